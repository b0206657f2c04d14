//! Where a formula needs parentheses.

/// How tightly a formula holds together, by its outermost operator; or how tightly it must, where it stands.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Precedence {
    Sum,
    Product,
    /// A formula with a minus in front.
    Sign,
    /// A name, a number, a call, or anything in parentheses.
    Atom,
}

impl Precedence {
    /// Whether the formula needs parentheses where at least `place` is required.
    pub(crate) fn needs_parentheses(self, place: Self) -> bool {
        self < place
    }
}
