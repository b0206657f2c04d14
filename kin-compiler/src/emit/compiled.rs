//! The mechanism to be written, and the names of its parts.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::vector_type;
use crate::algebra::Symbol;
use crate::describe;
use crate::formulas::Formulas;
use crate::model::{Dimension, Model, Request, ValueShape};
use crate::program::{Solvers, order_name};
use crate::structure::{Block, Part};

/// All facts about a mechanism that generated code needs.
#[derive(Clone, Copy)]
pub(super) struct Compiled<'a> {
    pub(super) model: &'a Model,
    pub(super) blocks: &'a [Block],
    pub(super) solvers: &'a Solvers,
    pub(super) formulas: &'a Formulas,
    /// The path to the items that generated code calls.
    pub(super) runtime: &'a TokenStream,
}

/// A name in generated code that no name of the user can capture.
pub(super) fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// The attributes of generated items: they may be unused, and the lints of the user's crate do not apply to them.
pub(super) fn attributes() -> TokenStream {
    quote!(#[allow(dead_code, non_snake_case, clippy::all, clippy::pedantic, clippy::nursery)])
}

/// The type of a mechanism's pose through an order: `FourBarVelocity`.
pub(crate) fn pose_name(mechanism: &Ident, order: usize) -> Ident {
    let mut name = order_name(order);
    if let Some(first) = name.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    let name: String = name.split('_').collect();
    format_ident!("{mechanism}{name}", span = mechanism.span())
}

impl Compiled<'_> {
    pub(super) fn is_requested(&self, request: Request) -> bool {
        self.model.is_requested(request)
    }

    /// The highest time derivative.
    pub(super) fn order(&self) -> usize {
        self.solvers.order()
    }

    /// The type of the pose through an order: `FourBarVelocity`.
    pub(super) fn pose(&self, order: usize) -> Ident {
        pose_name(&self.model.name, order)
    }

    /// The parts of all blocks, in the order in which they are solved.
    pub(super) fn parts(&self) -> Vec<&Part> {
        self.blocks.iter().flat_map(|block| &block.parts).collect()
    }

    /// Whether Newton's method solves a part, so that guessed values choose the assembly.
    pub(super) fn is_coupled(&self) -> bool {
        self.blocks.iter().any(Block::is_coupled)
    }

    /// The indices of the parts that leave a choice to the caller, in order.
    pub(super) fn choices(&self) -> Vec<usize> {
        describe::choices(self.solvers)
    }

    /// The names of unknowns, separated by commas.
    pub(super) fn names(&self, unknowns: &[usize]) -> String {
        describe::names(self.model, unknowns)
    }

    /// The names of a part's unknowns, separated by commas.
    pub(super) fn part_name(&self, part: usize) -> String {
        self.names(&self.parts()[part].unknowns)
    }

    pub(super) fn name_of(&self, symbol: Symbol) -> Ident {
        local(self.solvers.names().of(symbol))
    }

    /// A name for the use of generated code, different from all inputs and unknowns.
    pub(super) fn fresh(&self, name: &str) -> Ident {
        local(&self.model.own_name(name))
    }

    /// A type parameter for the use of generated code, different from the mechanism's name.
    pub(super) fn type_parameter(&self, name: &str) -> Ident {
        let underscore = if self.model.name == name { "_" } else { "" };
        local(&format!("{name}{underscore}"))
    }

    /// The inputs as arguments of type `T`.
    pub(super) fn input_names(&self) -> Vec<Ident> {
        self.model
            .inputs
            .iter()
            .map(|input| local(&input.name.to_string()))
            .collect()
    }

    /// Whether an unknown is returned as a unit vector.
    pub(super) fn is_direction(&self, unknown: usize) -> bool {
        self.model.unknowns[unknown].dimension == Dimension::Direction
    }

    /// Whether an unknown is returned as a unit vector, for any unknown.
    pub(super) fn has_directions(&self) -> bool {
        (0..self.model.unknowns.len()).any(|unknown| self.is_direction(unknown))
    }

    /// An unknown's value, from a pose of any order. The angle of a direction is calculated if the pose does not keep
    /// it.
    pub(super) fn unknown_value(&self, unknown: usize, pose: &TokenStream) -> TokenStream {
        let name = &self.model.unknowns[unknown].name;
        match (self.is_direction(unknown), self.solvers.directions().angle(unknown)) {
            (false, _) => quote!(#pose.#name.position()),
            (true, None) => quote!(#pose.#name.angle()),
            (true, Some(angle)) => {
                let angle = self.name_of(angle);
                quote!(#pose.#angle)
            }
        }
    }

    /// An unknown's value from a pose of any order. A calculated angle is unwrapped to a given value.
    pub(super) fn unknown_value_near(&self, unknown: usize, near: &TokenStream) -> TokenStream {
        let name = &self.model.unknowns[unknown].name;
        if self.is_direction(unknown) && self.solvers.directions().angle(unknown).is_none() {
            quote!(self.#name.angle_near(#near))
        } else {
            self.unknown_value(unknown, &quote!(self))
        }
    }

    /// The type of an unknown through an order: `Motion<T, 5>` or `Direction<T, 4>`.
    pub(super) fn unknown_type(&self, unknown: usize, order: usize, number: &TokenStream) -> TokenStream {
        let runtime = self.runtime;
        if self.is_direction(unknown) {
            let rates = Literal::usize_unsuffixed(order);
            quote!(#runtime::Direction<#number, #rates>)
        } else {
            let length = Literal::usize_unsuffixed(order + 1);
            quote!(#runtime::Motion<#number, #length>)
        }
    }

    /// The indices of the scalar parts of each output.
    pub(super) fn output_parts(&self) -> Vec<Vec<usize>> {
        let mut next = 0;
        self.model
            .outputs
            .iter()
            .map(|output| {
                let count = output.value.nodes().len();
                let parts = (next..next + count).collect();
                next += count;
                parts
            })
            .collect()
    }

    /// The type of an output whose numbers have the type `T`: `T`, `Plane<T>` or `Space<T>`.
    pub(super) fn output_type(&self, shape: ValueShape, number: &TokenStream) -> TokenStream {
        let runtime = self.runtime;
        if let Some(vector) = vector_type(shape) {
            quote!(#runtime::#vector<#number>)
        } else {
            number.clone()
        }
    }

    /// The field of a scalar parameter by the parameter's index; `None` for a part of a vector.
    pub(super) fn scalar_field(&self, number: usize) -> Option<&Ident> {
        let mut next = 0;
        for parameter in &self.model.parameters {
            let parts = parameter.dimension.shape().axes().len();
            if next == number {
                return (parts == 0).then_some(&parameter.name);
            }
            next += parts.max(1);
        }
        None
    }

    /// The scalar parameters. Each has its name in messages, its value in the structure, its dimension and its field.
    pub(super) fn scalar_parameters(&self) -> Vec<(String, TokenStream, Dimension, usize)> {
        let mut scalars = Vec::new();
        for (index, parameter) in self.model.parameters.iter().enumerate() {
            let name = &parameter.name;
            let shape = parameter.dimension.shape();
            if shape == ValueShape::Scalar {
                scalars.push((name.to_string(), quote!(self.#name), parameter.dimension, index));
            }
            for axis in shape.axes() {
                let part = local(&axis.to_string());
                scalars.push((
                    format!("{name}.{axis}"),
                    quote!(self.#name.#part),
                    Dimension::Length,
                    index,
                ));
            }
        }
        scalars
    }

    /// The structure of several choices: `SixBarAssembly`.
    pub(super) fn assembly_structure(&self) -> Ident {
        format_ident!("{}Assembly", self.model.name, span = self.model.name.span())
    }

    /// The fields of that structure: the unknowns of each block, joined.
    pub(super) fn assembly_fields(&self) -> Vec<Ident> {
        let names = describe::choice_names(self.model, self.blocks, self.solvers);
        names
            .iter()
            .map(|name| Ident::new(name, self.model.name.span()))
            .collect()
    }

    /// The type of the assembly of the parts with a closed form: one choice, a structure of several, or nothing.
    pub(super) fn assembly_type(&self) -> TokenStream {
        let runtime = self.runtime;
        match self.choices().len() {
            0 => quote!(()),
            1 => quote!(#runtime::Assembly),
            _ => {
                let name = self.assembly_structure();
                quote!(#name)
            }
        }
    }

    /// The assembly as an argument; nothing if there is no choice.
    pub(super) fn assembly_argument(&self) -> TokenStream {
        if self.choices().is_empty() {
            return TokenStream::new();
        }
        let (assembly, kind) = (self.fresh("assembly"), self.assembly_type());
        quote!(#assembly: #kind)
    }

    /// The assembly as a program gives it, and its conversion. Instead of a structure of several choices, the solvers
    /// take a trait, whose message says how to write the structure.
    pub(super) fn given_assembly(&self) -> (TokenStream, TokenStream) {
        let (runtime, value) = (self.runtime, self.assembly_value());
        if self.choices().len() < 2 {
            return (self.assembly_argument(), value);
        }
        let kind = self.assembly_type();
        (
            quote!(#value: impl #runtime::IntoAssembly<#kind>),
            quote!(#runtime::IntoAssembly::into_assembly(#value)),
        )
    }

    /// The assembly as a value that is passed on.
    pub(super) fn assembly_value(&self) -> TokenStream {
        if self.choices().is_empty() {
            return TokenStream::new();
        }
        let assembly = self.fresh("assembly");
        quote!(#assembly)
    }

    /// `.map_err(…)?` with the block of a failure, and the inputs.
    pub(super) fn failed_at(&self, block: &str) -> TokenStream {
        let inputs = self.input_names();
        let failure = self.fresh("failure");
        quote!(.map_err(|#failure| self.__failed(#failure, #block, #(#inputs),*))?)
    }
}
