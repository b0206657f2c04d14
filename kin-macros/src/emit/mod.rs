//! Model and program to Rust, one file per generated item. Nothing here can fail.

mod assembly;
mod batch;
mod bindings;
pub(crate) mod closure;
pub(crate) mod declaration;
mod description;
mod documentation;
mod doubt;
mod every;
mod formula;
mod mechanism;
mod poses;
mod position;
mod rates;
mod sensitivities;
mod skeleton;
mod solve;
mod statements;
mod test;
mod track;
mod transmission;
mod values;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use crate::assemble::{Limits, Mode};
use crate::expr::{Graph, Symbol};
use crate::model::{Dimension, Model, Request, Shape};
use crate::plan::Plan;
use crate::structure::{Block, Part};
use crate::syntax::Declaration;

/// All that is known of a mechanism when it is written down.
pub(crate) struct Mechanism<'a> {
    pub(crate) declaration: &'a Declaration,
    pub(crate) model: &'a Model,
    pub(crate) graph: &'a Graph,
    pub(crate) blocks: &'a [Block],
    pub(crate) ranges: &'a std::collections::BTreeMap<usize, Limits>,
    pub(crate) plan: &'a Plan,
    /// The path to what generated code calls.
    pub(crate) runtime: &'a TokenStream,
    /// Whether statements are written that go through all positions, and not to one of them.
    pub(crate) goes_through_all: bool,
}

/// Everything that a declaration expands to.
pub(crate) fn tokens(mechanism: &Mechanism<'_>) -> TokenStream {
    let outside = mechanism;
    let alias = alias(&outside.model.name.to_string());
    let inside = &Mechanism {
        runtime: &quote!(#alias),
        ..*outside
    };
    let structures = [
        declaration::tokens(outside.model, outside.runtime),
        assembly::structure(outside),
        poses::structures(outside),
        batch::structure(outside),
        sensitivities::structures(outside),
    ];
    let implementations = [
        assembly::tokens(inside),
        description::tokens(inside),
        solve::tokens(inside),
        position::tokens(inside),
        every::tokens(inside),
        track::tokens(inside),
        poses::tokens(inside),
        rates::tokens(inside),
        sensitivities::tokens(inside),
        mechanism::tokens(inside),
        batch::tokens(inside),
        values::tokens(inside),
        skeleton::tokens(inside),
        if inside.is_requested(Request::TransmissionAngles) {
            transmission::tokens(inside)
        } else {
            TokenStream::new()
        },
    ];
    // test functions inside of other items do not run
    let test = if outside.is_requested(Request::Test) {
        test::tokens(outside)
    } else {
        TokenStream::new()
    };
    let runtime = outside.runtime;
    let bindings = bindings::imports(&implementations, runtime);
    // a scope of its own, so that short names meet no others
    quote! {
        #(#structures)*
        #[allow(deprecated)]
        const _: () = {
            use #runtime as #alias;
            #bindings
            #(#implementations)*
        };
        #test
    }
}

/// What the runtime is called within the expansion: anything but what the mechanism is called.
fn alias(mechanism: &str) -> Ident {
    local(if mechanism == "kin" { "runtime" } else { "kin" })
}

/// A name in generated code that no name of the user's can capture.
fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// The names that generated code needs for itself where the names of a program stand as well.
pub(crate) const OWN_NAMES: [&str; 13] = [
    "assembly",
    "near",
    "failure",
    "pose",
    "position",
    "result",
    "candidate",
    "size",
    "first",
    "second",
    "decided",
    "choices",
    "values",
];

/// Such a name, with what makes it unlike any input or unknown.
pub(crate) fn own_name(model: &Model, name: &str) -> String {
    let mut name = name.to_owned();
    while model.inputs.iter().any(|input| input.name == name)
        || model.unknowns.iter().any(|unknown| unknown.name == name)
    {
        name.push('_');
    }
    name
}

/// Generated items may go unused, and are not to be judged by the lints of the crate that they land in.
fn attributes() -> TokenStream {
    quote! {
        #[automatically_derived]
        #[allow(dead_code, non_snake_case, clippy::all, clippy::pedantic, clippy::nursery)]
    }
}

impl Mechanism<'_> {
    fn is_requested(&self, request: Request) -> bool {
        self.model.requests.iter().any(|requested| requested.request == request)
    }

    /// The highest time derivative.
    fn order(&self) -> usize {
        self.plan.scheduled.stages.len() - 1
    }

    /// The type of the pose through an order: `FourBarVelocity`.
    fn pose(&self, order: usize) -> Ident {
        let mut name = crate::plan::order_name(order);
        if let Some(first) = name.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        let name: String = name.split('_').collect();
        format_ident!("{}{name}", self.model.name, span = self.model.name.span())
    }

    /// The parts of all blocks, in the order in which they are solved.
    fn parts(&self) -> Vec<&Part> {
        self.blocks.iter().flat_map(|block| &block.parts).collect()
    }

    /// Whether a part is left to Newton's method, so that its assembly is told by values near by.
    fn is_coupled(&self) -> bool {
        self.blocks.iter().any(Block::is_coupled)
    }

    /// The indices of the parts that leave a choice to the caller, in order.
    fn choices(&self) -> Vec<usize> {
        (0..self.plan.choices.len())
            .filter(|&part| matches!(self.plan.choices[part].mode, Mode::Assembly(_)))
            .collect()
    }

    /// The names of unknowns, separated by commas.
    fn names(&self, unknowns: &[usize]) -> String {
        let names: Vec<String> = unknowns
            .iter()
            .map(|&unknown| self.model.unknowns[unknown].name.to_string())
            .collect();
        names.join(", ")
    }

    /// The names of a part's unknowns, separated by commas.
    fn part_name(&self, part: usize) -> String {
        self.names(&self.parts()[part].unknowns)
    }

    fn name_of(&self, symbol: Symbol) -> Ident {
        local(self.plan.names.of(symbol))
    }

    /// A name of the generated code's own, unlike any input or unknown.
    fn own(&self, name: &str) -> Ident {
        local(&own_name(self.model, name))
    }

    /// A type parameter of the generated code's own, unlike the mechanism.
    fn type_parameter(&self, name: &str) -> Ident {
        let underscore = if self.model.name == name { "_" } else { "" };
        local(&format!("{name}{underscore}"))
    }

    /// The inputs as arguments of type `T`.
    fn input_names(&self) -> Vec<Ident> {
        self.model
            .inputs
            .iter()
            .map(|input| local(&input.name.to_string()))
            .collect()
    }

    /// Whether an unknown is handed out as a unit vector.
    fn is_direction(&self, unknown: usize) -> bool {
        self.model.unknowns[unknown].dimension == Dimension::Direction
    }

    /// Whether any is.
    fn has_directions(&self) -> bool {
        (0..self.model.unknowns.len()).any(|unknown| self.is_direction(unknown))
    }

    /// An unknown's value, from a pose of any order. That of a direction is calculated, if the pose does not keep it.
    fn unknown_value(&self, unknown: usize) -> TokenStream {
        let name = &self.model.unknowns[unknown].name;
        match (self.is_direction(unknown), self.plan.directions.angle(unknown)) {
            (false, _) => quote!(self.#name.position()),
            (true, None) => quote!(self.#name.angle()),
            (true, Some(angle)) => {
                let angle = self.name_of(angle);
                quote!(self.#angle)
            }
        }
    }

    /// The same on the turn nearest to a value, if it is calculated.
    fn unknown_value_near(&self, unknown: usize, near: &TokenStream) -> TokenStream {
        let name = &self.model.unknowns[unknown].name;
        if self.is_direction(unknown) && self.plan.directions.angle(unknown).is_none() {
            quote!(self.#name.angle_near(#near))
        } else {
            self.unknown_value(unknown)
        }
    }

    /// What holds an unknown through an order: `Motion<T, 5>`, or `Direction<T, 4>`.
    fn unknown_type(&self, unknown: usize, order: usize, number: &TokenStream) -> TokenStream {
        let runtime = self.runtime;
        if self.is_direction(unknown) {
            let rates = Literal::usize_unsuffixed(order);
            quote!(#runtime::Direction<#number, #rates>)
        } else {
            let length = Literal::usize_unsuffixed(order + 1);
            quote!(#runtime::Motion<#number, #length>)
        }
    }

    /// For each output, its scalar parts' numbers.
    fn output_parts(&self) -> Vec<Vec<usize>> {
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

    /// An output whose numbers are of a type `T`: `T`, `Plane<T>` or `Space<T>`.
    fn output_type(&self, shape: Shape, number: &TokenStream) -> TokenStream {
        let runtime = self.runtime;
        if let Some(vector) = declaration::vector_type(shape) {
            quote!(#runtime::#vector<#number>)
        } else {
            number.clone()
        }
    }

    /// Each scalar parameter: its name in messages, its place in the structure, its dimension and its field.
    fn scalar_parameters(&self) -> Vec<(String, TokenStream, Dimension, usize)> {
        let mut scalars = Vec::new();
        for (index, parameter) in self.model.parameters.iter().enumerate() {
            let name = &parameter.name;
            let shape = parameter.dimension.shape();
            if shape == Shape::Scalar {
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

    /// The type that says which assembly of the parts with a closed form: one choice, a structure of several, or nothing.
    fn assembly_type(&self) -> TokenStream {
        let runtime = self.runtime;
        match self.choices().len() {
            0 => quote!(()),
            1 => quote!(#runtime::Assembly),
            _ => {
                let name = assembly::type_name(self);
                quote!(#name)
            }
        }
    }

    /// The assembly as an argument, absent where there is nothing to choose.
    fn assembly_argument(&self) -> TokenStream {
        if self.choices().is_empty() {
            return TokenStream::new();
        }
        let (assembly, kind) = (self.own("assembly"), self.assembly_type());
        quote!(#assembly: #kind)
    }

    /// The assembly where it is passed on.
    fn assembly_value(&self) -> TokenStream {
        if self.choices().is_empty() {
            return TokenStream::new();
        }
        let assembly = self.own("assembly");
        quote!(#assembly)
    }
}
