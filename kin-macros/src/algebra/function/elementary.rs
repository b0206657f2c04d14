//! What the file of an elementary function says of it.

use crate::algebra::{Function, Graph, Node};

/// The facts of an elementary function.
pub(super) struct Elementary {
    /// Its name, in a declaration and in [`Calculation::Method`] alike.
    pub(super) name: &'static str,
    /// How it is written, as messages show it.
    pub(super) form: &'static str,
    /// How many arguments it takes.
    pub(super) arity: usize,
    /// The dimension of its arguments.
    pub(super) takes: Takes,
    /// The dimension of its value.
    pub(super) gives: Gives,
    /// The numbers for which it is defined.
    pub(super) domain: Domain,
    /// The function of `kin_core::solve` that checks the domain in generated code.
    pub(super) guard: Option<&'static Checked>,
    /// How an equation f(x) = v is solved for x.
    pub(super) inverse: Inverse,
    /// How generated code calculates it.
    pub(super) calculation: Calculation,
    /// What it costs.
    pub(super) cost: &'static [Work],
    /// Whether its value is zero anywhere. If not, a zero has come by underflow.
    pub(super) has_zeros: bool,
    /// Its value, for folding constants and for probing an identity.
    pub(super) value: fn(&[f64]) -> f64,
    /// Its partial derivative by each argument, given the arguments and the node of the value itself.
    pub(super) partials: fn(&mut Graph, &[Node], Node) -> Vec<Node>,
}

/// The dimension of the arguments of a function.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Takes {
    /// A number without dimension.
    Number {
        /// What messages call it.
        wanted: &'static str,
        /// What to write where the argument is a length.
        instead_of_length: &'static str,
    },
    /// An angle in radians, or a ratio.
    Angle,
    /// Any dimension.
    Anything,
    /// Any dimension, the same for all arguments.
    Alike,
}

impl Takes {
    /// A number, of which messages say this.
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

/// The numbers for which a function is defined.
#[derive(Clone, Copy)]
pub(super) enum Domain {
    /// All of them.
    Everywhere,
    /// A part of them.
    Part {
        contains: fn(&[f64]) -> bool,
        /// What messages say of it, after "which".
        text: &'static str,
    },
    /// All of them except the zeros of what the function divides by.
    Between {
        divisor: fn(&mut Graph, &[Node]) -> Node,
        /// What messages say of it, after "which".
        text: &'static str,
    },
}

/// A function of `kin_core::solve` that checks its argument.
#[derive(PartialEq, Eq, Debug)]
pub(crate) struct Checked {
    /// Its name there.
    pub(crate) name: &'static str,
    /// Whether the sign of its argument decides. Only the formula of the argument tells how far a sum is from zero, in units of its
    /// terms; from an end of the size of 1 the check itself can tell it.
    pub(crate) decides_by_sign: bool,
    /// What it costs.
    pub(crate) cost: &'static [Work],
}

/// How an equation f(x) = v is solved for x.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Inverse {
    /// Not by an inverse: f has two arguments, or closed forms of its own.
    None,
    /// There is one solution.
    One(InverseFunction),
    /// f is even: there are two solutions, of which an assembly chooses one. The function takes the value, and a number with the sign
    /// of the solution in the open assembly.
    Even(&'static Checked),
}

/// What gives the argument of a function by its value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum InverseFunction {
    /// A function that is defined for every value.
    Elementary(Function),
    /// A function that checks the value.
    Checked(&'static Checked),
}

/// How generated code calculates a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Calculation {
    /// By the method of `kin_core::Number` with its name.
    Method,
    /// By `sin_cos`, as the sine.
    Sine,
    /// By `sin_cos`, as the cosine.
    Cosine,
    /// By `sin_cos`, as the quotient of sine and cosine.
    Tangent,
}

/// A piece of work that a function takes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Work {
    Multiplication,
    Division,
    SquareRoot,
    /// A sine and a cosine of one angle.
    SineCosine,
    ArcTangent,
    /// Any other function of a library of numbers.
    Other,
}
