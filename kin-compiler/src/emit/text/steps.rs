//! Steps to Rust.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{ProgramText, doubt};
use crate::algebra::{Checked, Symbol};
use crate::emit::compiled::local;
use crate::program::{Expression, FormArgument, Mode, Returns, Solver, Stage, Step};

type Written = Step<Expression>;

impl ProgramText<'_> {
    /// The steps of a stage that cannot fail.
    pub(in crate::emit) fn plain_steps(&self, stage: &Stage<Expression>) -> TokenStream {
        let steps: Vec<&Written> = stage.steps.iter().collect();
        steps.iter().map(|step| self.step(step, None, &steps)).collect()
    }

    /// The steps of the position, block by block.
    pub(in crate::emit) fn position_steps(&self, stage: &Stage<Expression>) -> TokenStream {
        let mut tokens = TokenStream::new();
        let mut rest = stage.steps.as_slice();
        let mut outside: Vec<&Written> = Vec::new();
        while let Some((first, after)) = rest.split_first() {
            let Step::Open { part, mode } = *first else {
                outside.push(first);
                tokens.extend(self.step(first, None, &outside));
                rest = after;
                continue;
            };
            let end = after
                .iter()
                .position(|step| matches!(step, Step::Close { .. }))
                .unwrap_or(after.len());
            let (inside, after) = (&after[..end], &after[(end + 1).min(after.len())..]);
            if mode == Mode::Ranged {
                tokens.extend(self.candidates(part, inside, after, stage));
            } else {
                tokens.extend(self.sequence(inside, part));
            }
            rest = after;
        }
        tokens
    }

    /// The steps of a part, one after the other. Two directions in a row become one call.
    fn sequence<'s>(&self, steps: impl IntoIterator<Item = &'s Written>, part: usize) -> TokenStream {
        let mut tokens = TokenStream::new();
        let steps: Vec<&Written> = steps.into_iter().collect();
        let mut rest = steps.iter().copied().peekable();
        while let Some(step) = rest.next() {
            let both = rest.peek().and_then(|next| self.directions(step, next));
            if both.is_some() {
                rest.next();
            }
            tokens.extend(both.unwrap_or_else(|| self.step(step, Some(part), &steps)));
        }
        tokens
    }

    /// Two directions of the same kind, as one call.
    fn directions(&self, first: &Written, second: &Written) -> Option<TokenStream> {
        let runtime = self.mechanism.runtime;
        let direction = |step: &Written| match step {
            Step::Angle { symbol, y, x, length } => {
                let length = length.as_ref().map(|length| self.expression(length));
                Some((self.name(*symbol), self.expression(y), self.expression(x), length))
            }
            _ => None,
        };
        let (name, y, x, length) = direction(first)?;
        let (other_name, other_y, other_x, other_length) = direction(second)?;
        match (length, other_length) {
            (Some(length), Some(other_length)) => Some(quote! {
                let [#name, #other_name] =
                    #runtime::solve::directions([#y, #other_y], [#x, #other_x], [#length, #other_length]);
            }),
            (None, None) => Some(quote! {
                let [#name, #other_name] = T::atan2_of_two([#y, #other_y], [#x, #other_x]);
            }),
            _ => None,
        }
    }

    /// Both solutions of a part, and the choice between them by a declared range.
    fn candidates(&self, part: usize, inside: &[Written], after: &[Written], stage: &Stage<Expression>) -> TokenStream {
        let (runtime, model) = (self.mechanism.runtime, self.mechanism.model);
        let (bounds, inside): (Vec<&Written>, Vec<&Written>) =
            inside.iter().partition(|step| matches!(step, Step::Bound { .. }));
        let mut needed: Vec<Symbol> = after.iter().flat_map(Step::uses).collect();
        needed.extend(stage.carries.iter().map(|carried| carried.symbol));
        needed.extend((0..model.unknowns.len()).map(Symbol::Unknown));
        let mut kept: Vec<Symbol> = inside.iter().flat_map(|step| step.defines()).collect();
        kept.retain(|symbol| needed.contains(symbol));
        let names: Vec<_> = kept.iter().map(|&symbol| self.name(symbol)).collect();
        let kinds = names.iter().map(|_| quote!(T));
        let places: Vec<_> = (0..names.len()).map(Literal::usize_unsuffixed).collect();
        let body = self.sequence(inside.iter().copied(), part);
        let bounds = bounds.iter().map(|step| self.step(step, Some(part), &[]));
        let failed = self.mechanism.failed(part);
        let [candidate, assembly, first, second, chosen] =
            ["candidate", "assembly", "first", "second", "chosen"].map(|name| self.mechanism.own(name));
        // if one range contains both solutions, the next one decides
        let ranges = self.mechanism.parts()[part].unknowns.iter().filter_map(|&unknown| {
            let range = model.unknowns[unknown].range.as_ref()?;
            let own = Symbol::Unknown(unknown);
            let turns = inside
                .iter()
                .any(|step| matches!(step, Step::Angle { symbol, .. } if *symbol == own));
            let kind = local(if turns { "angle" } else { "value" });
            let place = Literal::usize_unsuffixed(kept.iter().position(|&symbol| symbol == own)?);
            let (low, high) = (number(range.low), number(range.high));
            let label = model.unknowns[unknown].name.to_string();
            Some(quote! {
                #runtime::solve::SolutionInRange::#kind(#label, [#first.#place, #second.#place], #low, #high)
            })
        });
        quote! {
            let #candidate = |#assembly: #runtime::Assembly| -> ::core::result::Result<(#(#kinds,)*), #runtime::SolveError> {
                #body
                ::core::result::Result::Ok((#(#names,)*))
            };
            let (#first, #second) = #runtime::solve::both(#candidate)?;
            let #chosen = #runtime::solve::choose([#(#ranges),*]) #failed;
            let [#(#names),*] = T::all_assembled(#chosen, [#(#first.#places),*], [#(#second.#places),*]);
            #(#bounds)*
        }
    }

    /// A step. `among` are the steps that may define the values that it reads.
    pub(super) fn step(&self, step: &Written, part: Option<usize>, among: &[&Written]) -> TokenStream {
        let runtime = self.mechanism.runtime;
        match step {
            Step::Define { symbol, value } => self.define(*symbol, value),
            Step::Check {
                symbol,
                guard,
                argument,
            } => self.check(*symbol, guard, argument, part, among),
            Step::SineCosine { sine, cosine, angle } => {
                let [sine, cosine] = [sine, cosine].map(|symbol| self.pattern(*symbol));
                let angle = self.expression(angle);
                quote!(let (#sine, #cosine) = T::sin_cos(#angle);)
            }
            Step::Solve {
                solver,
                arguments,
                results,
            } => {
                let part = part.expect("closed forms stand in parts of blocks");
                self.solve(*solver, arguments, results, part, among)
            }
            Step::Angle { symbol, y, x, length } => {
                let name = self.name(*symbol);
                let (y, x) = (self.expression(y), self.expression(x));
                match length {
                    None => quote!(let #name = T::atan2(#y, #x);),
                    Some(length) => {
                        let length = self.expression(length);
                        quote!(let #name = #runtime::solve::direction(#y, #x, #length);)
                    }
                }
            }
            Step::Bound { unknown, turns, .. } => self.bound(*unknown, *turns, part),
            Step::Regular { value } => {
                let failed = self.singular(part);
                // the value keeps its name, so that later steps divide by the tested value
                let name = match value {
                    Expression::Name(symbol) => self.pattern(Some(*symbol)),
                    _ => self.pattern(None),
                };
                let value = doubt::decisive(self, value, among);
                quote!(let #name = #runtime::solve::regular(#value) #failed;)
            }
            Step::Newton {
                unknowns,
                body,
                residuals,
                jacobian,
                ..
            } => {
                let part = part.expect("iterations stand in parts of blocks");
                self.newton(part, unknowns, body, residuals, jacobian)
            }
            Step::Every {
                block,
                coefficients,
                results,
            } => self.every_solution(*block, part.expect("blocks have parts"), coefficients, results),
            Step::Factor { symbol, matrix } => {
                let name = self.name(*symbol);
                let rows = matrix.iter().map(|row| {
                    let entries = self.expressions(row);
                    quote!([#(#entries),*])
                });
                let failed = self.singular(part);
                quote!(let #name = #runtime::solve::factor([#(#rows),*]) #failed;)
            }
            Step::Substitute {
                factors,
                right,
                results,
            } => {
                let factors = self.expression(factors);
                let results = results.iter().map(|&symbol| self.name(symbol));
                let right = self.expressions(right);
                quote!(let [#(#results),*] = #runtime::solve::Factors::solve(&#factors, [#(#right),*]);)
            }
            Step::Open { .. } | Step::Close { .. } => TokenStream::new(),
        }
    }

    /// The failure for a value that must not vanish.
    fn singular(&self, part: Option<usize>) -> TokenStream {
        match part {
            Some(part) => self.mechanism.failed_together(part),
            None => self.mechanism.failed_at("the rates"),
        }
    }

    fn define(&self, symbol: Symbol, value: &Expression) -> TokenStream {
        let runtime = self.mechanism.runtime;
        let (name, value) = (self.name(symbol), self.expression(value));
        match self.label(symbol) {
            None => quote!(let #name = #value;),
            Some(label) => {
                let failed = self.mechanism.failed_at(&label);
                quote!(let #name = #runtime::solve::finite(#label, #value) #failed;)
            }
        }
    }

    /// A checked call of a function that is not defined everywhere.
    fn check(
        &self,
        symbol: Symbol,
        guard: &Checked,
        argument: &Expression,
        part: Option<usize>,
        among: &[&Written],
    ) -> TokenStream {
        let runtime = self.mechanism.runtime;
        let name = self.name(symbol);
        let argument = if guard.decides_by_sign {
            doubt::decisive(self, argument, among)
        } else {
            self.expression(argument)
        };
        let guard = local(guard.name);
        let failed = match part {
            Some(part) => self.mechanism.failed(part),
            None => self.mechanism.failed_at("the outputs"),
        };
        quote!(let #name = #runtime::solve::#guard(#argument) #failed;)
    }

    /// A closed form.
    fn solve(
        &self,
        solver: Solver,
        arguments: &[FormArgument<Expression>],
        results: &[Option<Symbol>],
        part: usize,
        among: &[&Written],
    ) -> TokenStream {
        let runtime = self.mechanism.runtime;
        let function = local(solver.name());
        let mut arguments: Vec<TokenStream> = arguments
            .iter()
            .enumerate()
            .map(|(place, argument)| match argument {
                FormArgument::Scalar(value) if solver.decides_on(place) => doubt::decisive(self, value, among),
                FormArgument::Plane(vector) if solver.decides_on(place) => doubt::decisive_vector(self, vector, among),
                _ => self.argument(argument),
            })
            .collect();
        if solver.takes_assembly() {
            arguments.push(self.assembly_of(part));
        }
        let results: Vec<TokenStream> = results.iter().map(|&symbol| self.pattern(symbol)).collect();
        let result = self.results(solver.returns(), &results);
        let failed = self.mechanism.failed(part);
        quote!(let #result = #runtime::solve::#function(#(#arguments),*) #failed;)
    }

    /// The label in messages of an output, or of an unknown found without a closed form: these are tested for being
    /// finite. Otherwise `None`.
    fn label(&self, symbol: Symbol) -> Option<String> {
        let model = self.mechanism.model;
        match symbol {
            Symbol::Unknown(index) => Some(model.unknowns[index].name.to_string()),
            Symbol::OutputRate(part, 0) => {
                let mut end = 0;
                let output = model.outputs.iter().find(|output| {
                    end += output.value.nodes().len();
                    part < end
                });
                output.map(|output| output.name.to_string())
            }
            _ => None,
        }
    }

    fn argument(&self, argument: &FormArgument<Expression>) -> TokenStream {
        let runtime = self.mechanism.runtime;
        match argument.map(|value| self.expression(value)) {
            FormArgument::Scalar(scalar) => scalar,
            FormArgument::Plane([x, y]) => quote!(#runtime::Plane::new(#x, #y)),
            FormArgument::Pair([first, second]) => quote!([#first, #second]),
            FormArgument::Matrix([[a, b], [c, d]]) => quote!([[#a, #b], [#c, #d]]),
            FormArgument::Known(number) => quote!(#number),
        }
    }

    fn results(&self, shape: Returns, names: &[TokenStream]) -> TokenStream {
        let runtime = self.mechanism.runtime;
        let root = |value: &TokenStream, square: &TokenStream| quote!(#runtime::solve::Root { value: #value, square: #square });
        match (shape, names) {
            (Returns::Scalar, [name]) => name.clone(),
            (Returns::Pair, [first, second]) => quote!((#first, #second)),
            (Returns::Plane, [x, y]) => quote!(#runtime::Plane { x: #x, y: #y }),
            (Returns::Root, [value, square]) => root(value, square),
            (Returns::PlaneAndRoot, [x, y, value, square]) => {
                let root = root(value, square);
                quote!((#runtime::Plane { x: #x, y: #y }, #root))
            }
            (Returns::RootAndScalar, [value, square, scalar]) => {
                let root = root(value, square);
                quote!((#root, #scalar))
            }
            (Returns::PlaneAndScalar, [x, y, scalar]) => quote!((#runtime::Plane { x: #x, y: #y }, #scalar)),
            (Returns::ScalarAndPlane, [scalar, x, y]) => quote!((#scalar, #runtime::Plane { x: #x, y: #y })),
            _ => unreachable!("results match their shape"),
        }
    }

    /// The choice between a part's solutions.
    fn assembly_of(&self, part: usize) -> TokenStream {
        let runtime = self.mechanism.runtime;
        let assembly = self.mechanism.own("assembly");
        match self.mechanism.solvers.choices[part].mode {
            Mode::Fixed { is_open: true } => quote!(#runtime::Assembly::Open),
            Mode::Fixed { is_open: false } => quote!(#runtime::Assembly::Crossed),
            Mode::Assembly(_) if self.goes_through_all => {
                let choices = self.mechanism.own("choices");
                quote!(#choices.assembly())
            }
            Mode::Assembly(index) if self.mechanism.choices().len() > 1 => {
                let field = &self.mechanism.assembly_fields()[index];
                quote!(#assembly.#field)
            }
            Mode::Assembly(_) | Mode::Ranged | Mode::Only => quote!(#assembly),
        }
    }

    /// Moves an unknown to the requested turn, or into its range.
    fn bound(&self, unknown: usize, turns: bool, part: Option<usize>) -> TokenStream {
        let runtime = self.mechanism.runtime;
        let own = &self.mechanism.model.unknowns[unknown];
        let name = self.name(Symbol::Unknown(unknown));
        if let Some(range) = &own.range {
            let label = own.name.to_string();
            let (low, high) = (number(range.low), number(range.high));
            let check = local(if turns { "check_angle" } else { "check_value" });
            let failed = self.mechanism.failed(part.expect("bounds stand in parts of blocks"));
            return quote!(let #name = #runtime::solve::#check(#label, #name, #low, #high) #failed;);
        }
        if turns && !self.goes_through_all {
            let (near, index) = (self.mechanism.own("near"), Literal::usize_unsuffixed(unknown));
            let near = if self.mechanism.is_coupled() {
                quote!(::core::option::Option::Some(#near))
            } else {
                quote!(#near)
            };
            return quote!(let #name = #runtime::solve::on_turn(#name, #near, #index););
        }
        TokenStream::new()
    }

    /// A name in a pattern, or `_` for an unused value.
    fn pattern(&self, symbol: Option<Symbol>) -> TokenStream {
        symbol.map_or_else(
            || quote!(_),
            |symbol| {
                let name = self.name(symbol);
                quote!(#name)
            },
        )
    }
}

/// A number of type `f64`, infinite ones included.
fn number(value: f64) -> TokenStream {
    if value == f64::INFINITY {
        quote!(::core::primitive::f64::INFINITY)
    } else if value == f64::NEG_INFINITY {
        quote!(::core::primitive::f64::NEG_INFINITY)
    } else if value < 0.0 {
        let value = Literal::f64_unsuffixed(-value);
        quote!(-#value)
    } else {
        let value = Literal::f64_unsuffixed(value);
        quote!(#value)
    }
}
