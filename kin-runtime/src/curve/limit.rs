//! The kinds of limits.

use core::fmt;

/// The kind of a limit: a position up to which a mechanism closes, or at which it has several ways to go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum LimitKind {
    /// A limit position: two assemblies meet, and neither goes on. The inputs can only reverse.
    TurningPoint,
    /// A change point: assemblies cross, or meet where a part rotates freely or where several blocks have their limits,
    /// and geometry does not determine which one the mechanism follows.
    ChangePoint,
    /// A length goes to infinity. The unknowns are those next to the pole.
    Pole,
    /// The end of a declared range, or of the domain of a function.
    End,
}

impl fmt::Display for LimitKind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::TurningPoint => "limit position",
            Self::ChangePoint => "change point",
            Self::Pole => "pole",
            Self::End => "end of a domain or range",
        })
    }
}
