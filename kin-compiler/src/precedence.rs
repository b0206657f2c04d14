//! The positions in which a formula needs parentheses.

/// The binding strength of a formula, by its outermost operator, or the strength that its position requires.
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
    /// Whether the formula needs parentheses in a position that requires at least `position`.
    pub(crate) fn needs_parentheses(self, position: Self) -> bool {
        self < position
    }
}
