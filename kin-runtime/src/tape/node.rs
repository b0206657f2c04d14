//! The nodes of a tape: one operation each.

use core::fmt;

/// The number of a node. A node is named by its index among the [nodes](crate::tape::Tape::nodes), and stands behind
/// its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Value(pub u32);

impl Value {
    /// The index among the nodes.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Display for Value {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "v{}", self.0)
    }
}

/// A number that is known beforehand. Constants are equal if their bits are, so that 0 and -0 differ, and NaN equals
/// itself.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Constant(u64);

impl Constant {
    /// The constant.
    #[must_use]
    pub const fn new(value: f64) -> Self {
        Self(value.to_bits())
    }

    /// Its value. That of a tape in single precision is a single-precision number.
    #[must_use]
    pub const fn value(self) -> f64 {
        f64::from_bits(self.0)
    }
}

impl fmt::Debug for Constant {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{:?}", self.value())
    }
}

/// One operation. Its result is a number, or a truth: the answer to a comparison.
///
/// Each operation is rounded once, to the [number type](crate::tape::NumberType) of the tape, and nothing may be
/// merged: `Add` of a `Multiply` is two roundings. Only [`PlusProduct`](TapeNode::PlusProduct) and
/// [`MinusProduct`](TapeNode::MinusProduct) may be rounded once instead of twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum TapeNode {
    /// The argument with this index among the [arguments](crate::tape::Tape::arguments).
    Argument(usize),
    /// A number.
    Constant(Constant),
    /// A truth that is known beforehand.
    Certain(bool),
    /// A function of one number.
    Call(Function, Value),
    /// A function of two numbers, in this order.
    Binary(Operator, Value, Value),
    /// a + b c.
    PlusProduct(Value, Value, Value),
    /// a - b c.
    MinusProduct(Value, Value, Value),
    /// A number that depends on a truth: one of two, in this order the one if it holds and the one if it does not.
    Select(Value, Value, Value),
    /// A comparison of two numbers. It does not hold if one of them is NaN.
    Compare(Comparison, Value, Value),
    /// Whether a number is neither NaN nor infinite.
    IsFinite(Value),
    /// Whether both truths hold.
    Both(Value, Value),
    /// Whether at least one of two truths holds.
    Either(Value, Value),
    /// Whether a truth does not hold.
    Not(Value),
    /// An unknown of a search, inside of its [body](crate::tape::NewtonSearch::body): where residuals and Jacobian are
    /// wanted.
    Unknown {
        /// The index of the search.
        search: usize,
        /// The index of the unknown in the search.
        index: usize,
    },
    /// An unknown of a search, after it: the root.
    Root {
        /// The index of the search.
        search: usize,
        /// The index of the unknown in the search.
        index: usize,
    },
    /// An unknown of a linear system.
    Solution {
        /// The index of the [solution](crate::tape::Tape::solutions).
        solution: usize,
        /// The index of the unknown in the system.
        index: usize,
    },
}

impl TapeNode {
    /// Whether the result is a truth; otherwise it is a number.
    #[must_use]
    pub const fn is_truth(&self) -> bool {
        matches!(
            self,
            Self::Certain(_) | Self::Compare(..) | Self::IsFinite(_) | Self::Both(..) | Self::Either(..) | Self::Not(_)
        )
    }

    /// Calls `visit` with each operand, from left to right. A root and a solution have none here: they depend on those
    /// of their search or system.
    pub fn operands(&self, mut visit: impl FnMut(Value)) {
        match *self {
            Self::Call(_, one) | Self::IsFinite(one) | Self::Not(one) => visit(one),
            Self::Binary(_, one, other)
            | Self::Compare(_, one, other)
            | Self::Both(one, other)
            | Self::Either(one, other) => {
                visit(one);
                visit(other);
            }
            Self::PlusProduct(one, other, third)
            | Self::MinusProduct(one, other, third)
            | Self::Select(one, other, third) => {
                visit(one);
                visit(other);
                visit(third);
            }
            Self::Argument(_)
            | Self::Constant(_)
            | Self::Certain(_)
            | Self::Unknown { .. }
            | Self::Root { .. }
            | Self::Solution { .. } => {}
        }
    }

    /// The same operation on other operands.
    #[must_use]
    pub(super) fn with_operands(self, mut moved: impl FnMut(Value) -> Value) -> Self {
        match self {
            Self::Call(function, one) => Self::Call(function, moved(one)),
            Self::IsFinite(one) => Self::IsFinite(moved(one)),
            Self::Not(one) => Self::Not(moved(one)),
            Self::Binary(operator, one, other) => Self::Binary(operator, moved(one), moved(other)),
            Self::Compare(comparison, one, other) => Self::Compare(comparison, moved(one), moved(other)),
            Self::Both(one, other) => Self::Both(moved(one), moved(other)),
            Self::Either(one, other) => Self::Either(moved(one), moved(other)),
            Self::PlusProduct(one, other, third) => Self::PlusProduct(moved(one), moved(other), moved(third)),
            Self::MinusProduct(one, other, third) => Self::MinusProduct(moved(one), moved(other), moved(third)),
            Self::Select(one, other, third) => Self::Select(moved(one), moved(other), moved(third)),
            Self::Argument(_)
            | Self::Constant(_)
            | Self::Certain(_)
            | Self::Unknown { .. }
            | Self::Root { .. }
            | Self::Solution { .. } => self,
        }
    }
}

/// A function of one number. Angles are in radians. Outside of its domain a function is NaN.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Function {
    /// The number with the other sign. Zero changes its sign as well.
    Negate,
    /// The magnitude.
    Magnitude,
    /// The non-negative square root, correctly rounded.
    SquareRoot,
    /// The sine.
    Sine,
    /// The cosine.
    Cosine,
    /// The angle in -π/2 ..= π/2 of a sine.
    ArcSine,
    /// The angle in 0 ..= π of a cosine.
    ArcCosine,
    /// The angle between -π/2 and π/2 of a tangent.
    ArcTangent,
    /// The hyperbolic sine.
    HyperbolicSine,
    /// The hyperbolic cosine.
    HyperbolicCosine,
    /// The hyperbolic tangent.
    HyperbolicTangent,
    /// The number of a hyperbolic sine.
    AreaHyperbolicSine,
    /// The non-negative number of a hyperbolic cosine.
    AreaHyperbolicCosine,
    /// The number of a hyperbolic tangent.
    AreaHyperbolicTangent,
    /// The exponential function.
    Exponential,
    /// The natural logarithm.
    Logarithm,
    /// The nearest integer; a half is rounded away from zero.
    Round,
    /// The smallest integer that is not less.
    Raise,
}

/// A function of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operator {
    /// The sum.
    Add,
    /// The first minus the second.
    Subtract,
    /// The product.
    Multiply,
    /// The first over the second.
    Divide,
    /// The angle in -π ..= π from the x axis to a point. The first number is y, the second x.
    ArcTangent,
}

/// A comparison of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Comparison {
    /// The first is greater than or equal to the second.
    AtLeast,
    /// The first is greater than the second.
    Exceeds,
    /// They are equal.
    Equals,
}
