//! Named quantities, and their values in messages.

mod digits;
mod name;
#[cfg(feature = "alloc")]
mod small_letters;
mod with_unit;

pub(crate) use digits::Digits;
pub use name::{Name, NameKind};
#[cfg(feature = "alloc")]
pub use small_letters::in_small_letters;
pub(crate) use with_unit::WithUnit;

/// The names of the derivatives with respect to time, from the first on.
#[doc(hidden)]
pub const RATES: [&str; 12] = [
    "velocity",
    "acceleration",
    "jerk",
    "snap",
    "crackle",
    "pop",
    "derivative_7",
    "derivative_8",
    "derivative_9",
    "derivative_10",
    "derivative_11",
    "derivative_12",
];

/// The letters of the Greek alphabet with their names.
#[doc(hidden)]
pub const GREEK: [(char, &str); 24] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
];

/// A named quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Quantity<'d> {
    /// The name of the quantity; the parts of a point `p` are `p.x`, `p.y` and, in space, `p.z`.
    pub name: &'d str,
    /// The dimension of the quantity.
    pub dimension: Dimension,
    /// The first paragraph of its documentation, or an empty string.
    pub description: &'d str,
    /// Whether the declaration gives a range for it, in which the unknown is found.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "core::ops::Not::not"))]
    pub has_range: bool,
    /// Whether a pose holds it as a unit vector, and a batch as cosine and sine: an unknown that is declared as a
    /// `Direction`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "core::ops::Not::not"))]
    pub is_direction: bool,
}

impl<'d> Quantity<'d> {
    /// A length.
    #[must_use]
    pub const fn length(name: &'d str, description: &'d str) -> Self {
        Self {
            name,
            dimension: Dimension::Length,
            description,
            has_range: false,
            is_direction: false,
        }
    }

    /// An angle.
    #[must_use]
    pub const fn angle(name: &'d str, description: &'d str) -> Self {
        Self {
            name,
            dimension: Dimension::Angle,
            description,
            has_range: false,
            is_direction: false,
        }
    }

    /// A plain number.
    #[must_use]
    pub const fn scalar(name: &'d str, description: &'d str) -> Self {
        Self {
            name,
            dimension: Dimension::Scalar,
            description,
            has_range: false,
            is_direction: false,
        }
    }

    /// The same quantity as a direction.
    #[doc(hidden)]
    #[must_use]
    pub const fn as_direction(self) -> Self {
        Self {
            is_direction: true,
            ..self
        }
    }

    /// The same quantity with a range.
    #[doc(hidden)]
    #[must_use]
    pub const fn with_range(self) -> Self {
        Self {
            has_range: true,
            ..self
        }
    }
}

/// The dimension of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Dimension {
    /// A length, in the mechanism's unit.
    Length,
    /// An angle, in radians.
    Angle,
    /// A plain number.
    Scalar,
}
