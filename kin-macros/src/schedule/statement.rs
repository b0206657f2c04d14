//! What a scheduled program is made of.

use crate::assemble::{Cost, Shape, Solver};
use crate::expr::Symbol;
use crate::function::Function;

/// What stands on the right of a `let`.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Expression {
    Name(String),
    Number(f64),
    Pi,
    Add(Box<Self>, Box<Self>),
    Subtract(Box<Self>, Box<Self>),
    Multiply(Box<Self>, Box<Self>),
    Divide(Box<Self>, Box<Self>),
    Negate(Box<Self>),
    Call(Function, Vec<Self>),
}

/// One statement of a generated solver.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Statement {
    Let {
        name: String,
        value: Expression,
    },
    /// A function that is not defined everywhere, with a check.
    Checked {
        name: String,
        function: Function,
        argument: Expression,
    },
    SinCos {
        sine: Option<String>,
        cosine: Option<String>,
        argument: Expression,
    },
    /// A closed form; a result that nothing needs has no name.
    Solve {
        solver: Solver,
        arguments: Vec<(Shape, Vec<Expression>)>,
        results: Vec<Option<String>>,
    },
    /// A direction; `length` only where it may be negative.
    Angle {
        name: String,
        y: Expression,
        x: Expression,
        length: Option<Expression>,
    },
    Bound {
        unknown: usize,
        turns: bool,
    },
    Open {
        part: usize,
    },
    /// Newton's method; the unknowns bear their names.
    Newton {
        unknowns: Vec<usize>,
        body: Vec<Statement>,
        residuals: Vec<Expression>,
        jacobian: Vec<Vec<Expression>>,
    },
    /// One after the other of all solutions of a block.
    Every {
        block: usize,
        coefficients: Vec<Expression>,
        results: Vec<String>,
    },
    /// The factors of a matrix.
    Factor {
        name: String,
        matrix: Vec<Vec<Expression>>,
    },
    /// A linear system solved by its factors.
    Substitute {
        factors: String,
        right: Vec<Expression>,
        results: Vec<String>,
    },
    /// What must not vanish.
    Regular {
        value: Expression,
    },
    Close {
        part: usize,
    },
}

/// A value that a stage hands on.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Carried {
    pub(crate) name: String,
    /// Set if it is a parameter, which the first stage takes from the structure itself.
    pub(crate) parameter: Option<usize>,
    /// Set if it is the factors of a matrix of so many rows.
    pub(crate) factors: Option<usize>,
}

/// The statements of one stage.
#[derive(Clone, PartialEq, Debug, Default)]
pub(crate) struct ScheduledStage {
    pub(crate) statements: Vec<Statement>,
    /// Values of earlier stages that it uses, by name, besides positions and rates.
    pub(crate) uses: Vec<Carried>,
    /// Symbols whose values or rates it uses.
    pub(crate) symbols: Vec<Symbol>,
    /// Values that are handed to later stages.
    pub(crate) carries: Vec<Carried>,
    pub(crate) cost: Cost,
}

/// A whole program, ready to be written.
#[derive(Clone, PartialEq, Debug, Default)]
pub(crate) struct Scheduled {
    pub(crate) stages: Vec<ScheduledStage>,
}

impl Scheduled {
    /// The cost of all stages together.
    pub(crate) fn cost(&self) -> Cost {
        self.stages.iter().fold(Cost::default(), |sum, stage| sum + stage.cost)
    }
}

impl Expression {
    fn collect_names(&self, names: &mut Vec<String>) {
        match self {
            Self::Name(name) => names.push(name.clone()),
            Self::Number(_) | Self::Pi => {}
            Self::Add(a, b) | Self::Subtract(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => {
                a.collect_names(names);
                b.collect_names(names);
            }
            Self::Negate(a) => a.collect_names(names),
            Self::Call(_, arguments) => arguments.iter().for_each(|argument| argument.collect_names(names)),
        }
    }
}

impl Statement {
    /// The names that it reads.
    pub(crate) fn uses(&self) -> Vec<String> {
        let mut names = Vec::new();
        match self {
            Self::Let { value, .. } => value.collect_names(&mut names),
            Self::Checked { argument, .. } | Self::SinCos { argument, .. } => argument.collect_names(&mut names),
            Self::Solve { arguments, .. } => {
                arguments
                    .iter()
                    .flat_map(|(_, parts)| parts)
                    .for_each(|argument| argument.collect_names(&mut names));
            }
            Self::Angle { y, x, length, .. } => {
                [Some(y), Some(x), length.as_ref()]
                    .into_iter()
                    .flatten()
                    .for_each(|part| part.collect_names(&mut names));
            }
            Self::Regular { value } => value.collect_names(&mut names),
            Self::Newton {
                body,
                residuals,
                jacobian,
                ..
            } => {
                let inner: Vec<String> = self.inner_names();
                for statement in body {
                    names.extend(statement.uses());
                }
                residuals
                    .iter()
                    .chain(jacobian.iter().flatten())
                    .for_each(|part| part.collect_names(&mut names));
                names.retain(|name| !inner.contains(name));
            }
            Self::Every { coefficients, .. } => coefficients.iter().for_each(|part| part.collect_names(&mut names)),
            Self::Factor { matrix, .. } => matrix.iter().flatten().for_each(|part| part.collect_names(&mut names)),
            Self::Substitute { factors, right, .. } => {
                names.push(factors.clone());
                for part in right {
                    part.collect_names(&mut names);
                }
            }
            Self::Bound { .. } | Self::Open { .. } | Self::Close { .. } => {}
        }
        names
    }

    /// The names that it defines.
    pub(crate) fn defines(&self) -> Vec<String> {
        match self {
            Self::Let { name, .. } | Self::Checked { name, .. } | Self::Angle { name, .. } => vec![name.clone()],
            Self::SinCos { sine, cosine, .. } => sine.iter().chain(cosine).cloned().collect(),
            Self::Solve { results, .. } => results.iter().flatten().cloned().collect(),
            Self::Factor { name, .. } => vec![name.clone()],
            Self::Substitute { results, .. } | Self::Every { results, .. } => results.clone(),
            Self::Newton { .. }
            | Self::Bound { .. }
            | Self::Regular { .. }
            | Self::Open { .. }
            | Self::Close { .. } => Vec::new(),
        }
    }

    /// The names that are local to the iteration of Newton's method, besides the unknowns.
    fn inner_names(&self) -> Vec<String> {
        match self {
            Self::Newton { body, .. } => body.iter().flat_map(Self::defines).collect(),
            _ => Vec::new(),
        }
    }
}
