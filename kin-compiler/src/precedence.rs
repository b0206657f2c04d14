//! The places where a formula needs parentheses.

/// The binding strength of a formula, by its outermost operator, or the strength that its place requires.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Precedence {
    Sum,
    Product,
    /// A formula with a minus sign in front.
    Sign,
    /// A name, a number, a call, or anything in parentheses.
    Atom,
}

impl Precedence {
    /// Whether the formula needs parentheses in a place that requires at least `place`.
    pub(crate) fn needs_parentheses(self, place: Self) -> bool {
        self < place
    }
}
