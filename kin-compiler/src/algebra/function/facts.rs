//! The facts that the file of an elementary function states.

use crate::algebra::{Function, Graph, Node};

/// The facts of an elementary function.
pub(super) struct FunctionFacts {
    /// The name, in a declaration and in [`Calculation::Method`] alike.
    pub(super) name: &'static str,
    /// The spelling of a call, as messages show it.
    pub(super) form: &'static str,
    /// The usual name, in formulas to be read.
    pub(super) notation: &'static str,
    /// The usual name of the function that gives the argument for a value, if it has a name.
    pub(super) undone_by: Option<&'static str>,
    /// The number of arguments.
    pub(super) arity: usize,
    /// The dimension of the arguments.
    pub(super) takes: Takes,
    /// The dimension of the value.
    pub(super) gives: Gives,
    /// The arguments for which the function is defined.
    pub(super) domain: Domain,
    /// The function of `kin_core::solve` that checks the domain in generated code.
    pub(super) guard: Option<&'static Checked>,
    /// The way to solve an equation f(x) = v for x.
    pub(super) inverse: Inverse,
    /// The way in which generated code calculates the function.
    pub(super) calculation: Calculation,
    /// The cost of a call.
    pub(super) cost: &'static [WorkUnit],
    /// Whether the function has a zero. If not, a zero result comes from underflow.
    pub(super) has_zeros: bool,
    /// The value, to fold constants and to probe identities.
    pub(super) value: fn(&[f64]) -> f64,
    /// The partial derivative by each argument, given the arguments and the node of the value.
    pub(super) partials: fn(&mut Graph, &[Node], Node) -> Vec<Node>,
}

/// The dimension of the arguments of a function.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Takes {
    /// A number without dimension.
    Number {
        /// The name that messages give the argument.
        wanted: &'static str,
        /// The advice of a message if the argument is a length.
        instead_of_length: &'static str,
    },
    /// An angle in radians, or a ratio.
    Angle,
    /// Any dimension.
    Anything,
    /// Any dimension, but the same for all arguments.
    Alike,
}

impl Takes {
    /// A dimensionless number, which messages call `wanted`.
    pub(super) const fn number(wanted: &'static str) -> Self {
        Self::Number {
            wanted,
            instead_of_length: "divide it by a length",
        }
    }
}

/// The dimension of the value of a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Gives {
    /// A number without dimension.
    Number,
    /// An angle in radians.
    Angle,
    /// The square root of the argument's dimension.
    Root,
}

/// The arguments for which a function is defined.
#[derive(Clone, Copy)]
pub(super) enum Domain {
    /// All numbers.
    Everywhere,
    /// A part of all numbers.
    Part {
        contains: fn(&[f64]) -> bool,
        /// The description in messages, after "which".
        text: &'static str,
    },
    /// All numbers except the zeros of a divisor of the function.
    Between {
        divisor: fn(&mut Graph, &[Node]) -> Node,
        /// The description in messages, after "which".
        text: &'static str,
    },
}

/// A function of `kin_core::solve` that checks its argument.
#[derive(PartialEq, Eq, Debug)]
pub(crate) struct Checked {
    /// Its name in `kin_core::solve`.
    pub(crate) name: &'static str,
    /// Whether the sign of its argument decides. Then only the formula of the argument decides how far a sum is from
    /// zero, relative to its terms. If the domain ends at about 1, the check itself can decide.
    pub(crate) decides_by_sign: bool,
    /// Its cost.
    pub(crate) cost: &'static [WorkUnit],
}

/// The way to solve an equation f(x) = v for x.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Inverse {
    /// No inverse: f has two arguments, or separate closed forms.
    None,
    /// There is one solution.
    One(InverseFunction),
    /// f is even: there are two solutions, and an assembly chooses one. The function takes the value, and a number with
    /// the sign of the solution in the open assembly.
    Even(&'static Checked),
}

/// The function that returns the argument of a function for a given value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum InverseFunction {
    /// A function that is defined for every value.
    Elementary(Function),
    /// A function that checks the value.
    Checked(&'static Checked),
}

/// The way in which generated code calculates a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Calculation {
    /// By the method of `kin_core::Number` that has the function's name.
    Method,
    /// By `sin_cos`, as the sine.
    Sine,
    /// By `sin_cos`, as the cosine.
    Cosine,
    /// By `sin_cos`, as the quotient of sine and cosine.
    Tangent,
}

/// A unit of the cost of a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum WorkUnit {
    Multiplication,
    Division,
    SquareRoot,
    /// A sine and a cosine of one angle.
    SineCosine,
    ArcTangent,
    /// Any other function of a mathematical library.
    Other,
}
