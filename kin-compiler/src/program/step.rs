//! A step of a program.

use super::choice::Mode;
use super::expression::Expression;
use super::solver::{FormArgument, Solver};
use crate::algebra::{Checked, Node, Symbol};

/// One step. Its expressions `E` are nodes of a graph until the program is scheduled, and ready to be written
/// afterwards.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Step<E> {
    /// A value and its symbol.
    Define { symbol: Symbol, value: E },
    /// A checked call of a function that is not defined everywhere. Scheduling makes this step.
    Check {
        symbol: Symbol,
        guard: &'static Checked,
        argument: E,
    },
    /// Sine and cosine of one angle. One of them may be unused. Scheduling makes this step.
    SineCosine {
        sine: Option<Symbol>,
        cosine: Option<Symbol>,
        angle: E,
    },
    /// A call of a closed form, with its results in order. Scheduling leaves out the results that nothing needs.
    Solve {
        solver: Solver,
        arguments: Vec<FormArgument<E>>,
        results: Vec<Option<Symbol>>,
    },
    /// The direction of a vector. If a length is given, it may be negative.
    Angle {
        symbol: Symbol,
        y: E,
        x: E,
        length: Option<E>,
    },
    /// Compares the unknown, just computed, with its declared range. An angle with `is_periodic` came from a direction,
    /// so it may be moved by whole revolutions. Any other value occurs in its equation as a number and may not be
    /// moved. An angle with `wraps` may need one revolution to lie in its range.
    Bound {
        unknown: usize,
        is_periodic: bool,
        wraps: bool,
    },
    /// The beginning of a part of a block.
    Open { part: usize, mode: Mode },
    /// The end of a part of a block.
    Close { part: usize },
    /// Newton's method from the caller's guess. It finds values of the unknowns at which the residuals vanish. `given`
    /// are the values of earlier steps in the residuals. Scheduling fills `body` with the steps of an iteration.
    Newton {
        part: usize,
        unknowns: Vec<usize>,
        given: Vec<E>,
        body: Vec<Self>,
        residuals: Vec<E>,
        jacobian: Vec<Vec<E>>,
    },
    /// All solutions of a block's equations, one after the other, as values of the block's variables.
    Every {
        block: usize,
        coefficients: Vec<E>,
        results: Vec<Symbol>,
    },
    /// The factors of a matrix, which later stages use to solve.
    Factor { symbol: Symbol, matrix: Vec<Vec<E>> },
    /// matrix · results = right, by the factors of the matrix.
    Substitute {
        factors: E,
        right: Vec<E>,
        results: Vec<Symbol>,
    },
    /// A value that must not vanish, because a later step divides by it.
    Regular { value: E },
}

impl<E> Step<E> {
    /// All expressions in the step, in the order in which they are written.
    pub(crate) fn expressions(&self) -> Vec<&E> {
        match self {
            Self::Define { value, .. } | Self::Regular { value } => vec![value],
            Self::Check { argument, .. } => vec![argument],
            Self::SineCosine { angle, .. } => vec![angle],
            Self::Solve { arguments, .. } => arguments.iter().flat_map(FormArgument::expressions).collect(),
            Self::Angle { y, x, length, .. } => [y, x].into_iter().chain(length).collect(),
            Self::Newton {
                given,
                body,
                residuals,
                jacobian,
                ..
            } => {
                let inside = body.iter().flat_map(Self::expressions);
                given
                    .iter()
                    .chain(inside)
                    .chain(residuals)
                    .chain(jacobian.iter().flatten())
                    .collect()
            }
            Self::Every { coefficients, .. } => coefficients.iter().collect(),
            Self::Factor { matrix, .. } => matrix.iter().flatten().collect(),
            Self::Substitute { factors, right, .. } => [factors].into_iter().chain(right).collect(),
            Self::Bound { .. } | Self::Open { .. } | Self::Close { .. } => Vec::new(),
        }
    }

    /// The same step with other expressions, which are made in the order in which they are written.
    pub(crate) fn map<F>(&self, other: &mut impl FnMut(&E) -> F) -> Step<F> {
        match self {
            Self::Define { symbol, value } => Step::Define {
                symbol: *symbol,
                value: other(value),
            },
            Self::Check {
                symbol,
                guard,
                argument,
            } => Step::Check {
                symbol: *symbol,
                guard,
                argument: other(argument),
            },
            Self::SineCosine { sine, cosine, angle } => Step::SineCosine {
                sine: *sine,
                cosine: *cosine,
                angle: other(angle),
            },
            Self::Solve {
                solver,
                arguments,
                results,
            } => Step::Solve {
                solver: *solver,
                arguments: arguments.iter().map(|argument| argument.map(&mut *other)).collect(),
                results: results.clone(),
            },
            Self::Angle { symbol, y, x, length } => Step::Angle {
                symbol: *symbol,
                y: other(y),
                x: other(x),
                length: length.as_ref().map(other),
            },
            &Self::Bound {
                unknown,
                is_periodic,
                wraps,
            } => Step::Bound {
                unknown,
                is_periodic,
                wraps,
            },
            &Self::Open { part, mode } => Step::Open { part, mode },
            &Self::Close { part } => Step::Close { part },
            Self::Newton {
                part,
                unknowns,
                given,
                body,
                residuals,
                jacobian,
            } => Step::Newton {
                part: *part,
                unknowns: unknowns.clone(),
                given: given.iter().map(&mut *other).collect(),
                body: body.iter().map(|step| step.map(other)).collect(),
                residuals: residuals.iter().map(&mut *other).collect(),
                jacobian: rows(jacobian, other),
            },
            Self::Every {
                block,
                coefficients,
                results,
            } => Step::Every {
                block: *block,
                coefficients: coefficients.iter().map(other).collect(),
                results: results.clone(),
            },
            Self::Factor { symbol, matrix } => Step::Factor {
                symbol: *symbol,
                matrix: rows(matrix, other),
            },
            Self::Substitute {
                factors,
                right,
                results,
            } => Step::Substitute {
                factors: other(factors),
                right: right.iter().map(other).collect(),
                results: results.clone(),
            },
            Self::Regular { value } => Step::Regular { value: other(value) },
        }
    }

    /// The symbols that the step defines for later steps.
    pub(crate) fn defines(&self) -> Vec<Symbol> {
        match self {
            Self::Define { symbol, .. }
            | Self::Check { symbol, .. }
            | Self::Angle { symbol, .. }
            | Self::Factor { symbol, .. } => vec![*symbol],
            Self::SineCosine { sine, cosine, .. } => sine.iter().chain(cosine).copied().collect(),
            Self::Solve { results, .. } => results.iter().flatten().copied().collect(),
            Self::Substitute { results, .. } | Self::Every { results, .. } => results.clone(),
            Self::Newton { .. }
            | Self::Bound { .. }
            | Self::Regular { .. }
            | Self::Open { .. }
            | Self::Close { .. } => Vec::new(),
        }
    }
}

fn rows<E, F>(matrix: &[Vec<E>], other: &mut impl FnMut(&E) -> F) -> Vec<Vec<F>> {
    matrix.iter().map(|row| row.iter().map(&mut *other).collect()).collect()
}

impl Step<Expression> {
    /// The symbols that the step reads and does not define itself.
    pub(crate) fn uses(&self) -> Vec<Symbol> {
        let mut symbols = Vec::new();
        for expression in self.expressions() {
            expression.collect_symbols(&mut symbols);
        }
        if let Self::Newton { body, .. } = self {
            let inside: Vec<Symbol> = body.iter().flat_map(Self::defines).collect();
            symbols.retain(|symbol| !inside.contains(symbol));
        }
        symbols
    }
}

impl Step<Node> {
    /// The expressions that must be known before the step. An iteration of Newton's method is a separate program.
    pub(crate) fn needs(&self) -> Vec<Node> {
        match self {
            Self::Newton { given, .. } => given.clone(),
            _ => self.expressions().into_iter().copied().collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use quote::quote;

    use super::*;
    use crate::passes::Passes;
    use crate::testing::sound;

    /// The values within an iteration of Newton's method are neither defined nor used outside it.
    #[test]
    fn symbols_within_an_iteration_stay_there() {
        let declared = sound(quote! {
            struct Kepler { eccentricity: Scalar }
            input mean: Angle;
            unknown eccentric: Angle;
            eccentric - eccentricity * sin(eccentric) == mean;
        });
        let solvers = declared.solvers(Passes::ALL);
        let newton = solvers.motion.stages[0]
            .steps
            .iter()
            .find(|step| matches!(step, Step::Newton { .. }))
            .expect("it has no closed form");
        let Step::Newton { body, .. } = newton else {
            unreachable!("it has just been found as such");
        };
        let inner: Vec<Symbol> = body.iter().flat_map(Step::defines).collect();
        let uses = newton.uses();
        assert!(!inner.is_empty() && uses.contains(&Symbol::Parameter(0)), "{uses:?}");
        for symbol in inner {
            assert!(!uses.contains(&symbol), "{symbol:?}");
        }
        assert!(newton.defines().is_empty());
    }
}
