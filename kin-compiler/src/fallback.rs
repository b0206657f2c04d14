//! The replacement of a mechanism whose declaration contains mistakes.
//!
//! An editor gets the structure and the poses with their fields, and the solvers without bodies, so that the rest of
//! the program can be written while the declaration is half typed. The solvers take anything as an assembly, because
//! the blocks are unknown.
//!
//! The compiler gets the structures alone. Their number type is by default a type that contains the first mistake, and
//! they dereference to it. The compiler knows that it has reported this mistake. So it reports no further errors about
//! methods that it looks up there, whatever their arguments, nor about uses of their results. (A failing macro in the
//! place of a type would leave `()` there. In the length of an array it leaves an error, and so does an associated type
//! of that array.)

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};

use crate::emit;
use crate::emit::vector_type;
use crate::mistakes::Mistakes;
use crate::program::order_name;
use crate::syntax::{Declaration, Dimension, ParameterField, QuantityItem, Statement, UnknownItem};

/// The order of a declaration that states none.
const ORDER: usize = 4;

/// The items of a mechanism that are named by a path.
const ITEMS: [&str; 8] = [
    "ASSEMBLIES",
    "ASSEMBLY_COUNT",
    "DESCRIPTION",
    "OPERATIONS",
    "OUTLINE",
    "SENSITIVITY_OPERATIONS",
    "assembly",
    "from_parameters",
];

/// The mistakes, and a replacement for the readable part of the declaration.
pub(crate) fn tokens(declaration: Option<&Declaration>, mistakes: Mistakes, runtime: &TokenStream) -> TokenStream {
    let Some(declaration) = declaration else {
        return mistakes.into_compile_errors();
    };
    let errors = mistakes.into_each_compile_error();
    let Some((first, others)) = errors.split_first() else {
        return TokenStream::new();
    };
    let outline = ReadableDeclaration::new(declaration, runtime);
    let structure = outline.structure(&quote!(#runtime::unexpanded!(#first)));
    let (name, poses, assembly) = (&declaration.name, outline.poses(), outline.assembly());
    let (solvers, rates) = (outline.solvers(), outline.rates());
    let dereferenced = (0..=outline.order)
        .map(|order| outline.pose(order))
        .chain([name.clone()]);
    let visibility = &declaration.visibility;
    let items = ITEMS.map(|item| Ident::new(item, Span::mixed_site()));
    quote_spanned! {Span::mixed_site()=>
        #(#others)*
        #structure
        #poses
        #[allow(dead_code)]
        #visibility type #assembly = <#name as #runtime::Numeric>::Number;
        #[allow(unexpected_cfgs, unused, non_upper_case_globals)]
        const _: () = {
            impl<T> #runtime::Numeric for #name<T> {
                type Number = T;
            }

            #(
                #[cfg(not(rust_analyzer))]
                impl<T> ::core::ops::Deref for #dereferenced<T> {
                    type Target = <#name as #runtime::Numeric>::Number;

                    fn deref(&self) -> &Self::Target {
                        ::core::unreachable!()
                    }
                }
            )*

            #[cfg(not(rust_analyzer))]
            impl<T> #name<T> {
                #(pub const #items: <#name as #runtime::Numeric>::Number = ::core::unreachable!();)*
            }

            #[cfg(rust_analyzer)]
            #first

            #[cfg(rust_analyzer)]
            impl<T: #runtime::Scalar> #name<T> {
                #solvers
            }

            #rates
        };
    }
}

/// The readable part of a declaration. Where a name is declared twice, the first is taken.
struct ReadableDeclaration<'a> {
    declaration: &'a Declaration,
    runtime: &'a TokenStream,
    inputs: Vec<&'a QuantityItem>,
    unknowns: Vec<&'a UnknownItem>,
    /// The outputs with their types.
    outputs: Vec<(&'a Ident, Dimension)>,
    order: usize,
}

impl<'a> ReadableDeclaration<'a> {
    fn new(declaration: &'a Declaration, runtime: &'a TokenStream) -> Self {
        let mut outline = Self {
            declaration,
            runtime,
            inputs: Vec::new(),
            unknowns: Vec::new(),
            outputs: Vec::new(),
            order: ORDER,
        };
        let mut seen = BTreeSet::new();
        for statement in &declaration.statements {
            let mut is_first = |name: &Ident| seen.insert(name.to_string());
            match statement {
                Statement::Inputs(items) => outline.inputs.extend(items.iter().filter(|item| is_first(&item.name))),
                Statement::Unknowns(items) => {
                    outline
                        .unknowns
                        .extend(items.iter().filter(|item| is_first(&item.quantity.name)));
                }
                Statement::Output(output) if is_first(&output.name) => {
                    outline.outputs.push((&output.name, output.dimension));
                }
                Statement::Order(statement) => outline.order = statement.order,
                _ => {}
            }
        }
        outline
    }

    /// The structure of the parameters, with a number type by default.
    fn structure(&self, number: &TokenStream) -> TokenStream {
        let mut seen = BTreeSet::new();
        let first_of_its_name = |field: &&ParameterField| seen.insert(field.name.to_string());
        let fields = self
            .declaration
            .parameters
            .iter()
            .filter(first_of_its_name)
            .map(|field| {
                (
                    field.attributes.as_slice(),
                    &field.visibility,
                    &field.name,
                    field.dimension,
                )
            });
        let Declaration {
            attributes,
            visibility,
            name,
            ..
        } = self.declaration;
        emit::declaration::structure(attributes, visibility, name, fields, number, self.runtime)
    }

    /// The name of the pose through an order.
    fn pose(&self, order: usize) -> Ident {
        emit::pose_name(&self.declaration.name, order)
    }

    /// The name of the assembly, which stands for whatever the blocks need.
    fn assembly(&self) -> Ident {
        let name = &self.declaration.name;
        format_ident!("{name}Assembly", span = name.span())
    }

    /// The poses with the fields that are known.
    fn poses(&self) -> TokenStream {
        (0..=self.order).map(|order| self.pose_structure(order)).collect()
    }

    fn pose_structure(&self, order: usize) -> TokenStream {
        let (runtime, name) = (self.runtime, &self.declaration.name);
        let (visibility, pose) = (&self.declaration.visibility, self.pose(order));
        let length = Literal::usize_unsuffixed(order + 1);
        let rates = Literal::usize_unsuffixed(order);
        let inputs = self.inputs.iter().map(|input| {
            let field = &input.name;
            quote!(pub #field: #runtime::Motion<T, #length>)
        });
        let unknowns = self.unknowns.iter().map(|unknown| {
            let field = &unknown.quantity.name;
            if unknown.quantity.dimension == Dimension::Direction {
                quote!(pub #field: #runtime::Direction<T, #rates>)
            } else {
                quote!(pub #field: #runtime::Motion<T, #length>)
            }
        });
        let outputs = self.outputs.iter().map(|(field, dimension)| {
            if let Some(vector) = vector_type(dimension.shape()) {
                quote!(pub #field: #runtime::Motion<#runtime::#vector<T>, #length>)
            } else {
                quote!(pub #field: #runtime::Motion<T, #length>)
            }
        });
        let is_empty = self.inputs.is_empty() && self.unknowns.is_empty() && self.outputs.is_empty();
        let nothing = is_empty.then(|| quote!(nothing: ::core::marker::PhantomData<T>));
        quote_spanned! {Span::mixed_site()=>
            #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
            #[allow(dead_code, non_snake_case, clippy::all, clippy::pedantic)]
            #visibility struct #pose<T = <#name as #runtime::Numeric>::Number> {
                #(#inputs,)*
                #(#unknowns,)*
                #(#outputs,)*
                #nothing
            }
        }
    }

    /// The solvers without bodies.
    fn solvers(&self) -> TokenStream {
        let runtime = self.runtime;
        let site = Span::mixed_site();
        let inputs: Vec<Ident> = self
            .inputs
            .iter()
            .map(|input| Ident::new(&input.name.to_string(), site))
            .collect();
        let (first, last) = (self.pose(0), self.pose(self.order));
        let length = Literal::usize_unsuffixed(self.order + 1);
        let assembly = (!self.has_one_assembly()).then(|| quote_spanned!(site=> assembly: impl ::core::marker::Sized));
        let motions = quote!(#(#inputs: impl ::core::convert::Into<#runtime::Motion<T, #length>>,)*);
        let values = quote!(#(#inputs: T,)*);
        let found = |pose: &Ident| quote!(::core::result::Result<#pose<T>, #runtime::SolveError>);
        let (position, motion) = (found(&first), found(&last));
        let body = quote!({ ::core::unreachable!() });
        let count = Literal::usize_unsuffixed(self.unknowns.len());
        quote_spanned! {site=>
            /// The position.
            pub fn position(&self, #values #assembly) -> #position #body
            /// The position nearest to given values of the unknowns, or to a pose.
            pub fn position_near(&self, #values near: impl ::core::marker::Sized) -> #position #body
            /// Position and all time derivatives in one call.
            pub fn solve(&self, #motions #assembly) -> #motion #body
            /// Like `solve`, but in the assembly nearest to given values of the unknowns, or to a pose.
            pub fn solve_near(&self, #motions near: impl ::core::marker::Sized) -> #motion #body
            /// The assembly of a pose with unknowns near given values.
            pub fn assembly_at(&self, #values near: [T; #count]) -> #runtime::Assembly #body
            /// The assembly, link by link, for drawing.
            pub fn skeleton<Pose>(&self, pose: &Pose) -> #runtime::Skeleton<[#runtime::Plane<T>; 1]> #body
        }
    }

    /// The solvers of the time derivatives, as methods of the poses.
    fn rates(&self) -> TokenStream {
        let runtime = self.runtime;
        let site = Span::mixed_site();
        let count = Literal::usize_unsuffixed(self.unknowns.len());
        (0..=self.order)
            .map(|order| {
                let pose = self.pose(order);
                let next = (order < self.order).then(|| {
                    let (method, next) = (Ident::new(&order_name(order + 1), site), self.pose(order + 1));
                    let rates = self.inputs.iter().map(|input| {
                        let name = Ident::new(&input.name.to_string(), site);
                        quote!(#name: T)
                    });
                    let line = format!(" Adds the {} to the pose.", order_name(order + 1));
                    quote! {
                        #[doc = #line]
                        pub fn #method(&self, #(#rates),*) -> #next<T> { ::core::unreachable!() }
                    }
                });
                quote_spanned! {site=>
                    #[cfg(rust_analyzer)]
                    impl<T: #runtime::Scalar> #pose<T> {
                        #next
                        /// The unknowns in the order in which they are declared.
                        pub fn unknowns(&self) -> [T; #count] { ::core::unreachable!() }
                    }
                }
            })
            .collect()
    }

    /// Whether a range or an explicit formula chooses the solution of every equation, as far as they can be read.
    fn has_one_assembly(&self) -> bool {
        let is_unknown = |name: &str| self.unknowns.iter().any(|unknown| unknown.quantity.name == name);
        let chosen = self.unknowns.iter().filter(|unknown| unknown.range.is_some());
        let chosen: BTreeSet<String> = chosen.map(|unknown| unknown.quantity.name.to_string()).collect();
        let equations = self.declaration.equations();
        !equations.is_empty()
            && equations.iter().all(|equation| {
                !equation.names.is_disjoint(&chosen) || equation.alone.as_deref().is_some_and(is_unknown)
            })
    }
}
