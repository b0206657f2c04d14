//! The measure of a formula: its shape, and a power of length.
//!
//! Angles are plain numbers here, so that `r * theta` is a length.

use std::fmt::{self, Display, Formatter};

use crate::syntax::{Dimension, ValueShape};

/// A power of a length, as a fraction in lowest terms with a positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Exponent {
    numerator: i64,
    denominator: i64,
}

impl Exponent {
    pub(crate) const NUMBER: Self = Self::whole(0);
    pub(crate) const LENGTH: Self = Self::whole(1);

    const fn whole(numerator: i64) -> Self {
        Self {
            numerator,
            denominator: 1,
        }
    }

    /// A fraction in lowest terms. Its operands may be saturated: no sensible formula has an exponent beyond 64 bits.
    fn fraction(numerator: i64, denominator: i64) -> Self {
        let divisor = greatest_common_divisor(numerator, denominator).max(1);
        Self {
            numerator: numerator / divisor,
            denominator: denominator / divisor,
        }
    }

    /// The exponent of a product.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self::fraction(
            self.numerator
                .saturating_mul(other.denominator)
                .saturating_add(other.numerator.saturating_mul(self.denominator)),
            self.denominator.saturating_mul(other.denominator),
        )
    }

    /// The exponent of a power.
    pub(crate) fn times(self, factor: i32) -> Self {
        Self::fraction(self.numerator.saturating_mul(i64::from(factor)), self.denominator)
    }

    /// The exponent of a square root.
    pub(crate) fn half(self) -> Self {
        Self::fraction(self.numerator, self.denominator.saturating_mul(2))
    }

    pub(crate) fn negated(self) -> Self {
        self.times(-1)
    }
}

fn greatest_common_divisor(a: i64, b: i64) -> i64 {
    let (mut a, mut b) = (a.saturating_abs(), b.saturating_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// `length^2`
impl Display for Exponent {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match (self.numerator, self.denominator) {
            (1, 1) => write!(f, "length"),
            (n, 1) => write!(f, "length^{n}"),
            (n, d) => write!(f, "length^({n}/{d})"),
        }
    }
}

/// The shape and the dimension of a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FormulaType {
    pub(crate) shape: ValueShape,
    /// `None` for zero, which fits every dimension.
    pub(crate) exponent: Option<Exponent>,
}

impl FormulaType {
    /// Whether the formula is zero, and so fits both a scalar and a vector.
    pub(crate) fn is_zero(self) -> bool {
        self.shape == ValueShape::Scalar && self.exponent.is_none()
    }

    /// Whether this is a number without dimension.
    pub(crate) fn is_number(self) -> bool {
        self.shape == ValueShape::Scalar && self.exponent.is_none_or(|exponent| exponent == Exponent::NUMBER)
    }
}

/// The measure of a sum or difference, `None` if the powers of length differ. Zero takes the measure of the other term.
/// The shapes are known to fit.
pub(crate) fn common(left: FormulaType, right: FormulaType) -> Option<FormulaType> {
    let fits = match (left.exponent, right.exponent) {
        (Some(left), Some(right)) => left == right,
        _ => true,
    };
    fits.then_some(FormulaType {
        shape: if left.shape == ValueShape::Scalar {
            right.shape
        } else {
            left.shape
        },
        exponent: left.exponent.or(right.exponent),
    })
}

/// The exponent of a product. A product with zero is zero.
pub(crate) fn product(left: Option<Exponent>, right: Option<Exponent>) -> Option<Exponent> {
    Some(left?.plus(right?))
}

/// Prints the measure in words, with an article.
impl Display for FormulaType {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let vector = match self.shape {
            ValueShape::Scalar => return scalar(self.exponent, f),
            ValueShape::Rotation => return f.write_str("a rotation"),
            ValueShape::Plane => "plane vector",
            ValueShape::Space => "space vector",
        };
        match self.exponent {
            None => write!(f, "a zero {vector}"),
            Some(Exponent::NUMBER) => write!(f, "a {vector} of plain numbers"),
            Some(Exponent::LENGTH) => write!(f, "a {vector} of lengths"),
            Some(exponent) => write!(f, "a {vector} of {exponent}"),
        }
    }
}

fn scalar(exponent: Option<Exponent>, f: &mut Formatter<'_>) -> fmt::Result {
    match exponent {
        None => f.write_str("zero"),
        Some(Exponent::NUMBER) => f.write_str("an angle or plain number"),
        Some(Exponent::LENGTH) => f.write_str("a length"),
        Some(exponent) if exponent == Exponent::whole(2) => f.write_str("an area (length^2)"),
        Some(exponent) if exponent == Exponent::whole(3) => f.write_str("a volume (length^3)"),
        Some(exponent) => write!(f, "a {exponent}"),
    }
}

impl Dimension {
    pub(super) fn exponent(self) -> Exponent {
        match self {
            Self::Length | Self::Point | Self::Vector | Self::Point3 | Self::Vector3 => Exponent::LENGTH,
            Self::Angle | Self::Direction | Self::Scalar => Exponent::NUMBER,
        }
    }

    pub(super) fn measure(self) -> FormulaType {
        FormulaType {
            shape: self.shape(),
            exponent: Some(self.exponent()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_add_halve_and_multiply() {
        let area = Exponent::LENGTH.plus(Exponent::LENGTH);
        assert_eq!(area.half(), Exponent::LENGTH);
        assert_eq!(area.plus(area.negated()), Exponent::NUMBER);
        assert_eq!(Exponent::LENGTH.half().times(2), Exponent::LENGTH);
        assert_eq!(Exponent::LENGTH.half().half().times(-8), area.negated());
    }

    #[test]
    fn endless_powers_do_not_overflow() {
        let mut exponent = Exponent::LENGTH;
        for _ in 0..100 {
            exponent = exponent.times(64).half().half();
        }
        for _ in 0..100 {
            exponent = exponent.half().plus(exponent);
        }
    }

    #[test]
    fn measures_have_words() {
        let words = |shape, exponent| FormulaType { shape, exponent }.to_string();
        assert_eq!(words(ValueShape::Scalar, Some(Exponent::LENGTH)), "a length");
        assert_eq!(
            words(ValueShape::Scalar, Some(Exponent::NUMBER)),
            "an angle or plain number"
        );
        assert_eq!(
            words(ValueShape::Scalar, Some(Exponent::whole(2))),
            "an area (length^2)"
        );
        assert_eq!(words(ValueShape::Scalar, Some(Exponent::whole(-1))), "a length^-1");
        assert_eq!(
            words(ValueShape::Scalar, Some(Exponent::LENGTH.half())),
            "a length^(1/2)"
        );
        assert_eq!(
            words(ValueShape::Plane, Some(Exponent::LENGTH)),
            "a plane vector of lengths"
        );
        assert_eq!(
            words(ValueShape::Plane, Some(Exponent::whole(2))),
            "a plane vector of length^2"
        );
        assert_eq!(words(ValueShape::Scalar, None), "zero");
        assert_eq!(words(ValueShape::Plane, None), "a zero plane vector");
        assert_eq!(
            words(ValueShape::Space, Some(Exponent::LENGTH)),
            "a space vector of lengths"
        );
        assert_eq!(words(ValueShape::Rotation, Some(Exponent::NUMBER)), "a rotation");
    }
}
