//! The solution of many poses in one call.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::emit::compiled::{Compiled, attributes, local};
use crate::emit::equality::Equality;
use crate::program::order_name;

/// The structure of columns: `FourBarBatch`.
fn type_name(mechanism: &Compiled<'_>) -> Ident {
    format_ident!("{}Batch", mechanism.model.name, span = mechanism.model.name.span())
}

/// The motions of many poses, with a column for each number.
pub(in crate::emit) fn structure(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let (structure, attributes, visibility) = (type_name(mechanism), attributes(), &model.visibility);
    let length = Literal::usize_unsuffixed(mechanism.order() + 1);
    let summary = format!(
        " The motions of many poses of [`{}`], with a column instead of each number.",
        model.name
    );
    let inputs = model
        .inputs
        .iter()
        .map(|input| (&input.name, quote!(#runtime::Motion<Column, #length>)));
    let unknowns = model.unknowns.iter().enumerate().map(|(index, unknown)| {
        (
            &unknown.name,
            mechanism.unknown_type(index, mechanism.order(), &quote!(Column)),
        )
    });
    let outputs = model.outputs.iter().map(|output| {
        let kind = mechanism.output_type(output.value.shape(), &quote!(Column));
        (&output.name, quote!(#runtime::Motion<#kind, #length>))
    });
    let fields: Vec<(&Ident, TokenStream)> = inputs.chain(unknowns).chain(outputs).collect();
    let names: Vec<&Ident> = fields.iter().map(|&(name, _)| name).collect();
    let Equality { derived, implemented } = Equality::of(&structure, &format_ident!("Column"), &names);
    let derived = derived.into_iter();
    let fields = fields.iter().map(|(name, kind)| {
        let line = format!(" As in [`{}`].", mechanism.pose(mechanism.order()));
        quote! {
            #[doc = #line]
            pub #name: #kind
        }
    });
    quote! {
        #[doc = #summary]
        #[derive(::core::clone::Clone, ::core::fmt::Debug #(, #derived)*)]
        #attributes
        #visibility struct #structure<Column> {
            #(#fields,)*
        }

        #implemented
    }
}

/// `solve_batch`, for constant parameters and for columns of parameters, and the function that fills the structure.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let methods = methods(mechanism);
    let columns = columns(mechanism);
    quote!(#methods #columns)
}

fn methods(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let (name, structure) = (&model.name, type_name(mechanism));
    let inputs = mechanism.input_names();
    let length = Literal::usize_unsuffixed(mechanism.order() + 1);
    let [near, poses, outcomes] = ["near", "poses", "outcomes"].map(|name| mechanism.own(name));
    let [column, value] = ["Column", "Value"].map(|name| mechanism.type_parameter(name));
    let same = quote!(#name<#value::Element>);
    let columns = quote!(#runtime::batch::Column<'_, #value::Element>);
    let (choice, chosen, solve) = if mechanism.is_coupled() {
        let count = Literal::usize_unsuffixed(model.unknowns.len());
        (quote!(#near: [#columns; #count],), quote!(#near), "solve_near")
    } else if mechanism.choices().is_empty() {
        (TokenStream::new(), quote!(()), "solve")
    } else {
        let (argument, value) = (mechanism.assembly_argument(), mechanism.assembly_value());
        (quote!(#argument,), value, "solve")
    };
    let summary = format!(
        " Position and all time derivatives to {} of many poses.",
        order_name(mechanism.order())
    );
    let scalars: Vec<TokenStream> = mechanism
        .scalar_parameters()
        .into_iter()
        .map(|(_, value, ..)| value)
        .collect();
    let method = |name: &str, solve: &str| {
        let (name, solve) = (local(name), local(solve));
        quote! {
            #[inline]
            pub fn #name<#column: #runtime::batch::Target<#value::Element>>(
                &self,
                #(#inputs: #runtime::Motion<#columns, #length>,)*
                #choice
                #poses: &mut #structure<#column>,
                #outcomes: &mut [#runtime::batch::Outcome],
            ) -> ::core::result::Result<#runtime::batch::Summary, #runtime::batch::LengthMismatch> {
                #runtime::batch::#solve::<#same, _, _>(
                    [#(#scalars.column()),*],
                    [#(#inputs),*],
                    #chosen,
                    #poses,
                    #outcomes,
                    #runtime::batch::Vectors::widest(),
                )
            }
        }
    };
    let one = method("solve_batch", solve);
    let all = method("solve_batch_in_parallel", &format!("{solve}_in_parallel"));
    quote! {
        impl<#value: #runtime::batch::Parameter> #name<#value> {
            #[doc = #summary]
            ///
            /// Each parameter and input is one number for all poses, or a column with one number for each pose.
            ///
            /// # Errors
            /// Returns an error if the length of a column differs from the number of outcomes. The outcome of a pose
            /// reports whether the pose was solved.
            #one

            #runtime::in_parallel! {
                /// [`solve_batch`](Self::solve_batch) on all cores, with the same errors.
                #all
            }
        }
    }
}

fn columns(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let structure = type_name(mechanism);
    let [fill, visitor] = ["fill", "visitor"].map(|name| mechanism.own(name));
    let inputs = model.inputs.iter().map(|input| &input.name);
    let unknowns = model.unknowns.iter().map(|unknown| &unknown.name);
    let outputs = model.outputs.iter().map(|output| &output.name);
    let fields: Vec<_> = inputs.chain(unknowns).chain(outputs).collect();
    let firsts = (0..model.inputs.len())
        .chain(0..model.unknowns.len())
        .chain(mechanism.output_parts().into_iter().map(|parts| parts[0]))
        .map(Literal::usize_unsuffixed);
    let kinds = [
        ("Input", model.inputs.len()),
        ("Unknown", model.unknowns.len()),
        ("Output", model.outputs.len()),
    ];
    let kinds = kinds
        .into_iter()
        .flat_map(|(kind, count)| std::iter::repeat_n(local(kind), count));
    quote! {
        impl<Column> #structure<Column> {
            /// Columns made by a function: vectors that `solve_batch` fills, or nothing for numbers that are not needed.
            pub fn filled(mut #fill: impl ::core::ops::FnMut() -> Column) -> Self {
                Self {
                    #(#fields: #runtime::batch::MotionColumns::filled(&mut #fill)),*
                }
            }
        }
        impl<Column> #runtime::batch::Columns<Column> for #structure<Column> {
            #[inline(always)]
            fn each<'a>(&'a mut self, #visitor: &mut impl #runtime::batch::Visitor<'a, Column>)
            where
                Column: 'a,
            {
                #(
                    self.#fields.each(#firsts, #runtime::batch::Place::#kinds, #visitor);
                )*
            }
        }
    }
}
