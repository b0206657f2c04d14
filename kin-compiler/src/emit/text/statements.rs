//! Statements to Rust.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::ProgramText;
use crate::algebra::Symbol;
use crate::emit::compiled::local;
use crate::lower::{Argument, Decisive, Extent, Label, Range, Selection, Statement, Value};
use crate::program::{Expression, Returns, Stage};

impl ProgramText<'_> {
    /// The steps of a stage outside of blocks.
    pub(in crate::emit) fn plain_steps(&self, stage: &Stage<Expression>) -> TokenStream {
        self.statements(&self.lowering().plain(stage))
    }

    /// The steps of the position, block by block.
    pub(in crate::emit) fn position_steps(&self, stage: &Stage<Expression>) -> TokenStream {
        self.statements(&self.lowering().position(stage))
    }

    fn statements(&self, statements: &[Statement]) -> TokenStream {
        statements.iter().map(|statement| self.statement(statement)).collect()
    }

    pub(super) fn statement(&self, statement: &Statement) -> TokenStream {
        let runtime = self.mechanism.runtime;
        match statement {
            Statement::Assign { symbol, value } => {
                let (name, value) = (self.name(*symbol), self.value(value));
                quote!(let #name = #value;)
            }
            Statement::Finite { symbol, value, label } => {
                let (name, value, failed) = (self.name(*symbol), self.value(value), self.failed(label));
                let label = self.label(label);
                quote!(let #name = #runtime::solve::finite(#label, #value) #failed;)
            }
            Statement::Check {
                symbol,
                function,
                argument,
                label,
            } => {
                let (name, function, argument) = (self.name(*symbol), local(function), self.decisive(argument));
                let failed = self.failed(label);
                quote!(let #name = #runtime::solve::#function(#argument) #failed;)
            }
            Statement::SineCosine { sine, cosine, angle } => {
                let [sine, cosine] = [sine, cosine].map(|symbol| self.pattern(*symbol));
                let (function, angle) = (self.function("sin_cos"), self.value(angle));
                quote!(let (#sine, #cosine) = #function(#angle);)
            }
            Statement::Solve {
                form,
                arguments,
                selection,
                returns,
                results,
                label,
            } => {
                let form = local(form);
                let arguments = arguments.iter().map(|argument| self.argument(argument));
                let arguments = arguments.chain(selection.map(|selection| self.selection(selection)));
                let results: Vec<TokenStream> = results.iter().map(|&symbol| self.pattern(symbol)).collect();
                let result = self.results(*returns, &results);
                let failed = self.failed(label);
                quote!(let #result = #runtime::solve::#form(#(#arguments),*) #failed;)
            }
            Statement::Angles { symbols, y, x, lengths } => {
                let names: Vec<_> = symbols.iter().map(|&symbol| self.name(symbol)).collect();
                let [y, x, lengths] = [y, x, lengths].map(|values| self.values(values));
                match (names.as_slice(), lengths.is_empty()) {
                    ([name], true) => {
                        let function = self.function("atan2");
                        quote!(let #name = #function(#(#y),*, #(#x),*);)
                    }
                    ([name], false) => {
                        quote!(let #name = #runtime::solve::direction(#(#y),*, #(#x),*, #(#lengths),*);)
                    }
                    (_, true) => quote!(let [#(#names),*] = T::atan2_of_two([#(#y),*], [#(#x),*]);),
                    (_, false) => quote! {
                        let [#(#names),*] = #runtime::solve::directions([#(#y),*], [#(#x),*], [#(#lengths),*]);
                    },
                }
            }
            Statement::InRange { range, label } => {
                let (name, failed) = (self.name(Symbol::Unknown(range.unknown)), self.failed(label));
                let check = local(if range.is_periodic {
                    "check_angle"
                } else {
                    "check_value"
                });
                let (label, low, high) = (self.unknown(range.unknown), number(range.low), number(range.high));
                quote!(let #name = #runtime::solve::#check(#label, #name, #low, #high) #failed;)
            }
            Statement::Unwrap { unknown } => {
                let (near, index) = (self.mechanism.fresh("near"), Literal::usize_unsuffixed(*unknown));
                let near = if self.mechanism.is_coupled() {
                    quote!(::core::option::Option::Some(#near))
                } else {
                    quote!(#near)
                };
                let name = self.name(Symbol::Unknown(*unknown));
                quote!(let #name = #runtime::solve::unwrap_to_guess(#name, #near, #index);)
            }
            Statement::Candidates {
                body,
                kept,
                ranges,
                label,
            } => self.candidates(body, kept, ranges, label),
            Statement::Newton { .. } => self.newton(statement),
            Statement::Every { .. } => self.every_solution(statement),
            Statement::Factor { symbol, matrix, label } => {
                let name = self.name(*symbol);
                let rows = matrix.iter().map(|row| {
                    let entries = self.values(row);
                    quote!([#(#entries),*])
                });
                let failed = self.failed(label);
                quote!(let #name = #runtime::solve::factor([#(#rows),*]) #failed;)
            }
            Statement::Substitute {
                factors,
                right,
                results,
            } => {
                let factors = self.name(*factors);
                let results = results.iter().map(|&symbol| self.name(symbol));
                let right = self.values(right);
                quote!(let [#(#results),*] = #runtime::solve::Factors::solve(&#factors, [#(#right),*]);)
            }
            Statement::Regular { symbol, value, label } => {
                let (name, value, failed) = (self.pattern(*symbol), self.decisive(value), self.failed(label));
                quote!(let #name = #runtime::solve::regular(#value) #failed;)
            }
        }
    }

    /// Both solutions of a part, and the choice between them by a declared range.
    fn candidates(&self, body: &[Statement], kept: &[Symbol], ranges: &[Range], label: &Label) -> TokenStream {
        let runtime = self.mechanism.runtime;
        let names: Vec<_> = kept.iter().map(|&symbol| self.name(symbol)).collect();
        let kinds = names.iter().map(|_| quote!(T));
        let indices: Vec<_> = (0..names.len()).map(Literal::usize_unsuffixed).collect();
        let (body, failed) = (self.statements(body), self.failed(label));
        let [candidate, assembly, first, second, chosen] =
            ["candidate", "assembly", "first", "second", "chosen"].map(|name| self.mechanism.fresh(name));
        let ranges = ranges.iter().filter_map(|range| {
            let kind = local(if range.is_periodic { "angle" } else { "value" });
            let unknown = Symbol::Unknown(range.unknown);
            let index = Literal::usize_unsuffixed(kept.iter().position(|&symbol| symbol == unknown)?);
            let (label, low, high) = (self.unknown(range.unknown), number(range.low), number(range.high));
            Some(quote! {
                #runtime::solve::SolutionInRange::#kind(#label, [#first.#index, #second.#index], #low, #high)
            })
        });
        quote! {
            let #candidate = |#assembly: #runtime::Assembly|
                -> ::core::result::Result<(#(#kinds,)*), #runtime::SolveError>
            {
                #body
                ::core::result::Result::Ok((#(#names,)*))
            };
            let (#first, #second) = #runtime::solve::both(#candidate)?;
            let #chosen = #runtime::solve::choose([#(#ranges),*]) #failed;
            let [#(#names),*] = T::all_assembled(#chosen, [#(#first.#indices),*], [#(#second.#indices),*]);
        }
    }

    /// A decisive number with its terms.
    fn decisive(&self, Decisive { value, terms }: &Decisive) -> TokenStream {
        let value = self.value(value);
        self.with_terms("decisive", value, terms)
    }

    fn with_terms(&self, function: &str, value: TokenStream, terms: &[Value]) -> TokenStream {
        if terms.is_empty() {
            return value;
        }
        let (runtime, function, terms) = (self.mechanism.runtime, local(function), self.values(terms));
        // A long closure would not be inlined into the code that is compiled for the machine's vectors.
        quote!(#runtime::solve::#function(#value, #[inline(always)] || [#(#terms),*]))
    }

    fn argument(&self, argument: &Argument) -> TokenStream {
        let runtime = self.mechanism.runtime;
        match argument {
            Argument::Scalar(scalar) => self.decisive(scalar),
            Argument::Plane(vector, terms) => {
                let parts = self.values(vector);
                self.with_terms("decisive_vector", quote!(#runtime::Plane::new(#(#parts),*)), terms)
            }
            Argument::Pair(pair) => {
                let pair = self.values(pair);
                quote!([#(#pair),*])
            }
            Argument::Matrix(rows) => {
                let [first, second] = rows.each_ref().map(|row| self.values(row));
                quote!([[#(#first),*], [#(#second),*]])
            }
            Argument::Known(number) => quote!(#number),
        }
    }

    fn results(&self, shape: Returns, names: &[TokenStream]) -> TokenStream {
        let runtime = self.mechanism.runtime;
        let solve = quote!(#runtime::solve);
        let root = |value: &TokenStream, square: &TokenStream| quote!(#solve::Root { value: #value, square: #square });
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
    fn selection(&self, selection: Selection) -> TokenStream {
        let runtime = self.mechanism.runtime;
        let assembly = self.mechanism.fresh("assembly");
        match selection {
            Selection::Fixed { is_open: true } => quote!(#runtime::Assembly::Open),
            Selection::Fixed { is_open: false } => quote!(#runtime::Assembly::Crossed),
            Selection::Next => {
                let choices = self.mechanism.fresh("choices");
                quote!(#choices.assembly())
            }
            Selection::Choice(index) if self.mechanism.choices().len() > 1 => {
                let field = &self.mechanism.assembly_fields()[index];
                quote!(#assembly.#field)
            }
            Selection::Choice(_) | Selection::Candidate => quote!(#assembly),
        }
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

    fn unknown(&self, unknown: usize) -> String {
        self.mechanism.model.unknowns[unknown].name.to_string()
    }

    /// The name of the block of a failure.
    fn label(&self, label: &Label) -> String {
        match label {
            Label::Unknowns(unknowns) => self.mechanism.names(unknowns),
            Label::Output(index) => self.mechanism.model.outputs[*index].name.to_string(),
            Label::Outputs => "the outputs".to_owned(),
            Label::Rates => "the rates".to_owned(),
        }
    }

    /// `.map_err(…)?` with the block and the inputs, which are not known yet where values are prepared.
    pub(super) fn failed(&self, label: &Label) -> TokenStream {
        let block = self.label(label);
        if let Extent::Prepared(_) = self.extent {
            let failure = self.mechanism.fresh("failure");
            return quote!(.map_err(|#failure| (#failure, #block))?);
        }
        self.mechanism.failed_at(&block)
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
