//! Statements of a routine.

use super::Value;
use crate::algebra::Symbol;
use crate::program::Returns;
use crate::structure::SystemForm;

/// A statement. It assigns values, and may fail.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    /// A value, without a test.
    Assign {
        /// The value's symbol.
        symbol: Symbol,
        /// The value.
        value: Value,
    },
    /// A value that must be finite.
    Finite {
        /// The value's symbol.
        symbol: Symbol,
        /// The value.
        value: Value,
        /// The quantity in a failure.
        label: Label,
    },
    /// A checked call of a function that is not defined everywhere.
    Check {
        /// The result.
        symbol: Symbol,
        /// The function of `kin_core::solve`.
        function: &'static str,
        /// The argument.
        argument: Decisive,
        /// The unknowns in a failure.
        label: Label,
    },
    /// Sine and cosine of one angle. One of them may be unused.
    SineCosine {
        /// The sine.
        sine: Option<Symbol>,
        /// The cosine.
        cosine: Option<Symbol>,
        /// The angle.
        angle: Value,
    },
    /// A closed form.
    Solve {
        /// The function of `kin_core::solve`.
        form: &'static str,
        /// Its arguments.
        arguments: Vec<Argument>,
        /// The solution that it takes, if there are two.
        selection: Option<Selection>,
        /// The shape of its results.
        returns: Returns,
        /// Its results, in the order of the shape.
        results: Vec<Option<Symbol>>,
        /// The unknowns in a failure.
        label: Label,
    },
    /// The directions of one vector, or of two in one call.
    Angles {
        /// The angles.
        symbols: Vec<Symbol>,
        /// The y-components.
        y: Vec<Value>,
        /// The x-components.
        x: Vec<Value>,
        /// The lengths, which may be negative; none if they are positive.
        lengths: Vec<Value>,
    },
    /// An unknown must lie in its declared range. An angle may be moved by whole revolutions to get there.
    InRange {
        /// The unknown and its range.
        range: Range,
        /// The unknowns in a failure.
        label: Label,
    },
    /// Unwraps an angle to the caller's guess.
    Unwrap {
        /// The unknown.
        unknown: usize,
    },
    /// Both solutions of a part, and the choice between them by declared ranges.
    Candidates {
        /// The statements that find one of the solutions.
        body: Vec<Statement>,
        /// The values that are kept.
        kept: Vec<Symbol>,
        /// The ranges. If one of them contains both solutions, the next one decides.
        ranges: Vec<Range>,
        /// The unknowns in a failure.
        label: Label,
    },
    /// Newton's method from the caller's guess.
    Newton {
        /// The unknowns.
        unknowns: Vec<usize>,
        /// Whether each unknown is a length. Its size is then the largest of `lengths`, otherwise 1.
        are_lengths: Vec<bool>,
        /// The parameters and inputs that are lengths, if there is an unknown length.
        lengths: Vec<Symbol>,
        /// The statements that find the values of an iteration.
        body: Vec<Statement>,
        /// The residuals.
        residuals: Vec<Value>,
        /// Their partial derivatives, a row for each residual.
        jacobian: Vec<Vec<Value>>,
        /// The unknowns in a failure.
        label: Label,
    },
    /// All solutions of a block's equations, one after the other.
    Every {
        /// The block.
        block: usize,
        /// The equations.
        form: SystemForm,
        /// The number of solutions, real and complex.
        paths: usize,
        /// The coefficients of the equations.
        coefficients: Vec<Value>,
        /// The variables.
        results: Vec<Symbol>,
        /// The unknowns in a failure.
        label: Label,
    },
    /// The factors of a matrix.
    Factor {
        /// The factors.
        symbol: Symbol,
        /// The matrix, row by row.
        matrix: Vec<Vec<Value>>,
        /// The unknowns in a failure.
        label: Label,
    },
    /// matrix · results = right, by the factors of the matrix.
    Substitute {
        /// The factors.
        factors: Symbol,
        /// The right-hand sides.
        right: Vec<Value>,
        /// The results.
        results: Vec<Symbol>,
    },
    /// A value that must not vanish. Later statements divide by the tested value.
    Regular {
        /// The symbol of the value, if it has one.
        symbol: Option<Symbol>,
        /// The value.
        value: Decisive,
        /// The unknowns in a failure.
        label: Label,
    },
}

/// A number whose sign decides, or the test that it is nonzero, with the terms that it is the sum of. Only they say how
/// far it is from zero. There are none if the number is no sum.
#[derive(Clone, PartialEq, Debug)]
pub struct Decisive {
    /// The number.
    pub value: Value,
    /// Its terms.
    pub terms: Vec<Value>,
}

/// An argument of a closed form.
#[derive(Clone, PartialEq, Debug)]
pub enum Argument {
    /// A number.
    Scalar(Decisive),
    /// A vector, with the terms of both components if they decide.
    Plane([Value; 2], Vec<Value>),
    /// Two numbers.
    Pair([Value; 2]),
    /// Two rows of two numbers.
    Matrix([[Value; 2]; 2]),
    /// A number that was known when the declaration was compiled.
    Known(f64),
}

/// The choice between two solutions.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Selection {
    /// The same solution always: the open one, or the crossed one.
    Fixed {
        /// Whether it is the open one.
        is_open: bool,
    },
    /// The caller's choice, by its index among the choices of the mechanism.
    Choice(usize),
    /// The solution that the candidates ask for.
    Candidate,
    /// The next solution on the way through all positions.
    Next,
}

/// A declared range of an unknown.
#[derive(Clone, PartialEq, Debug)]
pub struct Range {
    /// The unknown.
    pub unknown: usize,
    /// Whether it may be moved by whole revolutions.
    pub is_periodic: bool,
    /// The lowest value.
    pub low: f64,
    /// The highest value.
    pub high: f64,
}

/// The name of the block of a failure.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Label {
    /// Some unknowns, separated by commas.
    Unknowns(Vec<usize>),
    /// An output.
    Output(usize),
    /// All outputs.
    Outputs,
    /// The rates.
    Rates,
}
