//! Statements to Rust.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{Mechanism, doubt, formula, local};
use crate::assemble::{Mode, Returns, Shape, UnitPart};
use crate::expr::Symbol;
use crate::function::Function;
use crate::model::Dimension;
use crate::schedule::{Expression, ScheduledStage, Statement};

impl Mechanism<'_> {
    /// `let` for the values of earlier stages, positions and rates that a stage reads; `given` are arguments already.
    pub(super) fn readings(&self, stage: &ScheduledStage, given: &[Symbol]) -> TokenStream {
        self.readings_from(stage, given, &quote!(self))
    }

    /// The same from a pose that is not `self`.
    pub(super) fn readings_from(&self, stage: &ScheduledStage, given: &[Symbol], pose: &TokenStream) -> TokenStream {
        let carried = stage.uses.iter().map(|carried| {
            let name = local(&carried.name);
            quote!(let #name = #pose.#name;)
        });
        let parameters = self.scalar_parameters();
        let symbols = stage
            .symbols
            .iter()
            .filter(|symbol| !given.contains(symbol))
            .map(|&symbol| {
                let name = self.name_of(symbol);
                let value = match symbol {
                    Symbol::Parameter(index) => parameters[index].1.clone(),
                    _ => self.reading(symbol, pose),
                };
                quote!(let #name = #value;)
            });
        quote!(#(#carried)* #(#symbols)*)
    }

    fn reading(&self, symbol: Symbol, pose: &TokenStream) -> TokenStream {
        let (name, order) = match symbol {
            Symbol::Input(index) => (&self.model.inputs[index].name, 0),
            Symbol::InputRate(index, order) => (&self.model.inputs[index].name, order),
            Symbol::Unknown(index) => (&self.model.unknowns[index].name, 0),
            Symbol::UnknownRate(index, order) => (&self.model.unknowns[index].name, order),
            Symbol::Step(_) if let Some((unknown, part)) = self.plan.directions.meaning(symbol) => {
                let name = &self.model.unknowns[unknown].name;
                let part = local(match part {
                    UnitPart::Cosine => "cosine",
                    UnitPart::Sine => "sine",
                });
                return quote!(#pose.#name.#part());
            }
            Symbol::Parameter(_)
            | Symbol::Turning(..)
            | Symbol::OutputRate(..)
            | Symbol::Sensitivity(..)
            | Symbol::OutputSensitivity(..)
            | Symbol::Step(_) => {
                unreachable!("parameters are read from the structure, the others are carried under their names")
            }
        };
        let accessor = local(&crate::plan::order_name(order));
        quote!(#pose.#name.#accessor())
    }

    /// The statements of a stage that cannot fail.
    pub(super) fn plain_statements(&self, stage: &ScheduledStage) -> TokenStream {
        let statements: Vec<&Statement> = stage.statements.iter().collect();
        statements
            .iter()
            .map(|statement| self.statement(statement, None, &statements))
            .collect()
    }

    /// The statements of the position, block by block.
    pub(super) fn position_statements(&self, stage: &ScheduledStage) -> TokenStream {
        let mut tokens = TokenStream::new();
        let mut rest = stage.statements.as_slice();
        let mut outside: Vec<&Statement> = Vec::new();
        while let Some((first, after)) = rest.split_first() {
            let Statement::Open { part } = *first else {
                outside.push(first);
                tokens.extend(self.statement(first, None, &outside));
                rest = after;
                continue;
            };
            let end = after
                .iter()
                .position(|statement| matches!(statement, Statement::Close { .. }))
                .unwrap_or(after.len());
            let (inside, after) = (&after[..end], &after[(end + 1).min(after.len())..]);
            if self.plan.choices[part].mode == Mode::Ranged {
                tokens.extend(self.candidates(part, inside, after, stage));
            } else {
                tokens.extend(self.sequence(inside, Some(part)));
            }
            rest = after;
        }
        tokens
    }

    /// Statements one after the other, two directions in a row as one.
    fn sequence<'a>(&self, statements: impl IntoIterator<Item = &'a Statement>, part: Option<usize>) -> TokenStream {
        let mut tokens = TokenStream::new();
        let statements: Vec<&Statement> = statements.into_iter().collect();
        let mut rest = statements.iter().copied().peekable();
        while let Some(statement) = rest.next() {
            let both = rest.peek().and_then(|next| self.directions(statement, next));
            if both.is_some() {
                rest.next();
            }
            tokens.extend(both.unwrap_or_else(|| self.statement(statement, part, &statements)));
        }
        tokens
    }

    /// Two directions of the same kind.
    fn directions(&self, first: &Statement, second: &Statement) -> Option<TokenStream> {
        let runtime = self.runtime;
        let direction = |statement: &Statement| match statement {
            Statement::Angle { name, y, x, length } => {
                let length = length.as_ref().map(formula::tokens);
                Some((local(name), formula::tokens(y), formula::tokens(x), length))
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
    fn candidates(
        &self,
        part: usize,
        inside: &[Statement],
        after: &[Statement],
        stage: &ScheduledStage,
    ) -> TokenStream {
        let runtime = self.runtime;
        let (bounds, inside): (Vec<&Statement>, Vec<&Statement>) = inside
            .iter()
            .partition(|statement| matches!(statement, Statement::Bound { .. }));
        let mut needed: Vec<String> = after.iter().flat_map(Statement::uses).collect();
        needed.extend(stage.carries.iter().map(|carried| carried.name.clone()));
        needed.extend(
            self.model
                .unknowns
                .iter()
                .enumerate()
                .map(|(index, _)| self.plan.names.of(Symbol::Unknown(index)).to_owned()),
        );
        let mut kept: Vec<String> = inside.iter().flat_map(|statement| statement.defines()).collect();
        kept.retain(|name| needed.contains(name));
        let names: Vec<_> = kept.iter().map(|name| local(name)).collect();
        let kinds = names.iter().map(|_| quote!(T));
        let body = self.sequence(inside.iter().copied(), Some(part));
        let bounds = bounds
            .iter()
            .map(|statement| self.statement(statement, Some(part), &[]));
        let failed = self.failed(part);
        let [candidate, assembly, first, second] =
            ["candidate", "assembly", "first", "second"].map(|name| self.own(name));
        let choices: Vec<TokenStream> = self.parts()[part]
            .unknowns
            .iter()
            .filter_map(|unknown| {
                let limits = self.ranges.get(unknown)?;
                let own = self.plan.names.of(Symbol::Unknown(*unknown));
                let turns = inside
                    .iter()
                    .any(|statement| matches!(statement, Statement::Angle { name, .. } if name == own));
                let choose = local(if turns { "choose_angle" } else { "choose_value" });
                let place = Literal::usize_unsuffixed(kept.iter().position(|name| name == own)?);
                let (low, high) = (number(limits.low), number(limits.high));
                let label = self.model.unknowns[*unknown].name.to_string();
                Some(quote!(#runtime::solve::#choose(#label, #first.#place, #second.#place, #low, #high)))
            })
            .collect();
        // where one range holds both solutions, the next one is asked
        let decided = self.own("decided");
        let choice = choices.into_iter().rev().reduce(|after, before| {
            quote! {
                match #before {
                    ::core::result::Result::Err(#runtime::Failure::Ambiguous { .. }) => #after,
                    #decided => #decided,
                }
            }
        });
        quote! {
            let #candidate = |#assembly: #runtime::Assembly| -> ::core::result::Result<(#(#kinds,)*), #runtime::SolveError> {
                #body
                ::core::result::Result::Ok((#(#names,)*))
            };
            let (#first, #second) = #runtime::solve::both(#candidate)?;
            let (#(#names,)*) =
                match #choice #failed {
                    #runtime::Assembly::Open => #first,
                    #runtime::Assembly::Crossed => #second,
                };
            #(#bounds)*
        }
    }

    /// `.map_err(…)?` with the block and the inputs.
    pub(super) fn failed(&self, part: usize) -> TokenStream {
        self.failed_at(&self.part_name(part))
    }

    /// The same with the names of all unknowns of a part's block: it is singular as a whole.
    fn failed_together(&self, part: usize) -> TokenStream {
        let mut before = 0;
        let block = self.blocks.iter().find(|block| {
            before += block.parts.len();
            part < before
        });
        block.map_or_else(
            || self.failed(part),
            |block| self.failed_at(&self.names(&block.unknowns)),
        )
    }

    /// The same with any names in the place of the block.
    pub(super) fn failed_at(&self, place: &str) -> TokenStream {
        let inputs = self.input_names();
        let failure = self.own("failure");
        quote!(.map_err(|#failure| self.__failed(#failure, #place, #(#inputs),*))?)
    }

    /// A statement; `among` are those that the definitions of what it reads may be found among.
    fn statement(&self, statement: &Statement, part: Option<usize>, among: &[&Statement]) -> TokenStream {
        let runtime = self.runtime;
        match statement {
            Statement::Let { name, value } => {
                let guarded = self.guarded_name(name);
                let name = local(name);
                let value = formula::tokens(value);
                match guarded {
                    None => quote!(let #name = #value;),
                    Some(label) => {
                        let failed = self.failed_at(&label);
                        quote!(let #name = #runtime::solve::finite(#label, #value) #failed;)
                    }
                }
            }
            Statement::Checked {
                name,
                function,
                argument,
            } => {
                let name = local(name);
                let argument = match function {
                    Function::Asin | Function::Acos => formula::tokens(argument),
                    _ => doubt::decisive(runtime, argument, among),
                };
                let function = local(match function {
                    Function::Sqrt => "square_root_of",
                    Function::Asin => "arc_sine",
                    Function::Acos => "arc_cosine",
                    _ => "logarithm",
                });
                let failed = match part {
                    Some(part) => self.failed(part),
                    None => self.failed_at("the outputs"),
                };
                quote!(let #name = #runtime::solve::#function(#argument) #failed;)
            }
            Statement::SinCos { sine, cosine, argument } => {
                let [sine, cosine] = [sine, cosine].map(|name| pattern(name.as_deref()));
                let argument = formula::tokens(argument);
                quote!(let (#sine, #cosine) = T::sin_cos(#argument);)
            }
            Statement::Solve {
                solver,
                arguments,
                results,
            } => {
                let function = local(solver.name());
                let mut arguments: Vec<TokenStream> = arguments
                    .iter()
                    .enumerate()
                    .map(|(place, (shape, parts))| match parts.as_slice() {
                        [value] if doubt::decides_on(*solver, place) => doubt::decisive(runtime, value, among),
                        [x, y] if doubt::decides_on(*solver, place) => doubt::decisive_vector(runtime, [x, y], among),
                        _ => self.argument(*shape, parts),
                    })
                    .collect();
                let part = part.expect("closed forms stand in parts of blocks");
                if solver.takes_assembly() {
                    arguments.push(self.assembly_of(part));
                }
                let results: Vec<TokenStream> = results.iter().map(|name| pattern(name.as_deref())).collect();
                let result = self.results(solver.returns(), &results);
                let failed = self.failed(part);
                quote!(let #result = #runtime::solve::#function(#(#arguments),*) #failed;)
            }
            Statement::Angle { name, y, x, length } => {
                let name = local(name);
                let (y, x) = (formula::tokens(y), formula::tokens(x));
                match length {
                    None => quote!(let #name = T::atan2(#y, #x);),
                    Some(length) => {
                        let length = formula::tokens(length);
                        quote!(let #name = #runtime::solve::direction(#y, #x, #length);)
                    }
                }
            }
            Statement::Bound { unknown, turns } => self.bound(*unknown, *turns, part),
            Statement::Regular { value } => {
                let failed = match part {
                    Some(part) => self.failed_together(part),
                    None => self.failed_at("the rates"),
                };
                // under its own name again, so that whoever divides by it divides by what was tested
                let name = match value {
                    Expression::Name(name) => pattern(Some(name)),
                    _ => pattern(None),
                };
                let value = doubt::decisive(runtime, value, among);
                quote!(let #name = #runtime::solve::regular(#value) #failed;)
            }
            Statement::Newton {
                unknowns,
                body,
                residuals,
                jacobian,
            } => self.newton(
                part.expect("iterations stand in parts of blocks"),
                unknowns,
                body,
                residuals,
                jacobian,
            ),
            Statement::Every {
                block,
                coefficients,
                results,
            } => self.every_solution(*block, part.expect("blocks have parts"), coefficients, results),
            Statement::Factor { name, matrix } => {
                let name = local(name);
                let rows = matrix.iter().map(|row| {
                    let entries = row.iter().map(formula::tokens);
                    quote!([#(#entries),*])
                });
                let failed = match part {
                    Some(part) => self.failed_together(part),
                    None => self.failed_at("the rates"),
                };
                quote!(let #name = #runtime::solve::factor([#(#rows),*]) #failed;)
            }
            Statement::Substitute {
                factors,
                right,
                results,
            } => {
                let factors = local(factors);
                let results = results.iter().map(|name| local(name));
                let right = right.iter().map(formula::tokens);
                quote!(let [#(#results),*] = #runtime::solve::Factors::solve(&#factors, [#(#right),*]);)
            }
            Statement::Open { .. } | Statement::Close { .. } => TokenStream::new(),
        }
    }

    /// Newton's method from the guess.
    fn newton(
        &self,
        part: usize,
        unknowns: &[usize],
        body: &[Statement],
        residuals: &[Expression],
        jacobian: &[Vec<Expression>],
    ) -> TokenStream {
        let runtime = self.runtime;
        let near = self.own("near");
        let names: Vec<_> = unknowns
            .iter()
            .map(|&unknown| self.name_of(Symbol::Unknown(unknown)))
            .collect();
        let guesses = unknowns.iter().map(|&unknown| {
            let place = Literal::usize_unsuffixed(unknown);
            quote!(#near[#place])
        });
        let is_length = |unknown: &usize| self.model.unknowns[*unknown].dimension == Dimension::Length;
        let size = self.own("size");
        let sizes = unknowns.iter().map(|unknown| {
            if is_length(unknown) {
                quote!(#size)
            } else {
                quote!(T::constant(1.0))
            }
        });
        let largest = unknowns.iter().any(is_length).then(|| {
            let lengths = self.lengths();
            quote!(let #size = #runtime::solve::largest([#(#lengths),*]);)
        });
        let count = Literal::usize_unsuffixed(unknowns.len());
        let body: Vec<&Statement> = body.iter().collect();
        let body = body
            .iter()
            .map(|statement| self.statement(statement, Some(part), &body));
        let residuals = residuals.iter().map(formula::tokens);
        let jacobian = jacobian.iter().map(|row| {
            let row = row.iter().map(formula::tokens);
            quote!([#(#row),*])
        });
        let failed = self.failed(part);
        quote! {
            #largest
            let [#(#names),*] = #runtime::solve::newton(
                [#(#guesses),*],
                [#(#sizes),*],
                |[#(#names),*]: [T; #count]| {
                    #(#body)*
                    ([#(#residuals),*], [#(#jacobian),*])
                },
            ) #failed;
        }
    }

    /// The parameters and inputs that are lengths.
    fn lengths(&self) -> Vec<TokenStream> {
        let parameters = self
            .scalar_parameters()
            .into_iter()
            .filter(|(_, _, dimension, _)| *dimension == Dimension::Length)
            .map(|(_, value, ..)| value);
        let inputs = self
            .model
            .inputs
            .iter()
            .filter(|input| input.dimension == Dimension::Length)
            .map(|input| {
                let name = local(&input.name.to_string());
                quote!(#name)
            });
        parameters.chain(inputs).collect()
    }

    /// Outputs and unknowns that come from no closed form are tested for being finite; the label for messages.
    fn guarded_name(&self, name: &str) -> Option<String> {
        match self.plan.names.symbol(name)? {
            Symbol::Unknown(index) => Some(self.model.unknowns[index].name.to_string()),
            Symbol::OutputRate(part, 0) => {
                let mut end = 0;
                let output = self.model.outputs.iter().find(|output| {
                    end += output.value.nodes().len();
                    part < end
                });
                output.map(|output| output.name.to_string())
            }
            _ => None,
        }
    }

    fn argument(&self, shape: Shape, parts: &[Expression]) -> TokenStream {
        let runtime = self.runtime;
        let parts: Vec<TokenStream> = parts.iter().map(formula::tokens).collect();
        match (shape, parts.as_slice()) {
            (Shape::Scalar, [scalar]) => scalar.clone(),
            (Shape::Plane, [x, y]) => quote!(#runtime::Plane::new(#x, #y)),
            (Shape::Pair, [first, second]) => quote!([#first, #second]),
            (Shape::Matrix, [a, b, c, d]) => quote!([[#a, #b], [#c, #d]]),
            _ => unreachable!("arguments have the parts of their shape"),
        }
    }

    fn results(&self, shape: Returns, names: &[TokenStream]) -> TokenStream {
        let runtime = self.runtime;
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

    /// Which of a part's solutions is wanted.
    fn assembly_of(&self, part: usize) -> TokenStream {
        let runtime = self.runtime;
        let assembly = self.own("assembly");
        match self.plan.choices[part].mode {
            Mode::Fixed { is_open: true } => quote!(#runtime::Assembly::Open),
            Mode::Fixed { is_open: false } => quote!(#runtime::Assembly::Crossed),
            Mode::Assembly(_) if self.goes_through_all => {
                let choices = self.own("choices");
                quote!(#choices.assembly())
            }
            Mode::Assembly(index) if self.choices().len() > 1 => {
                let field = &super::assembly::fields(self)[index];
                quote!(#assembly.#field)
            }
            Mode::Assembly(_) | Mode::Ranged | Mode::Only => quote!(#assembly),
        }
    }

    /// An unknown brought to the turn wanted, or into its range.
    fn bound(&self, unknown: usize, turns: bool, part: Option<usize>) -> TokenStream {
        let runtime = self.runtime;
        let own = &self.model.unknowns[unknown];
        let name = self.name_of(Symbol::Unknown(unknown));
        if let Some(limits) = self.ranges.get(&unknown) {
            let label = own.name.to_string();
            let (low, high) = (number(limits.low), number(limits.high));
            let check = local(if turns { "check_angle" } else { "check_value" });
            let failed = self.failed(part.expect("bounds stand in parts of blocks"));
            return quote!(let #name = #runtime::solve::#check(#label, #name, #low, #high) #failed;);
        }
        if turns && !self.goes_through_all {
            let (near, index) = (self.own("near"), Literal::usize_unsuffixed(unknown));
            let near = if self.is_coupled() {
                quote!(::core::option::Option::Some(#near))
            } else {
                quote!(#near)
            };
            return quote!(let #name = #runtime::solve::on_turn(#name, #near, #index););
        }
        TokenStream::new()
    }
}

/// A name in a pattern, or what stands for a value that nothing needs.
fn pattern(name: Option<&str>) -> TokenStream {
    name.map_or_else(
        || quote!(_),
        |name| {
            let name = local(name);
            quote!(#name)
        },
    )
}

/// A number of type `f64`, infinite ones included.
pub(super) fn number(value: f64) -> TokenStream {
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
