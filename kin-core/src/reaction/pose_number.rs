//! Numbers without their derivatives: of one pose, or of one that stands for others.

use crate::number::Number;

/// A number of a pose. One that stands for others notes what it decides, so that others in which it would be decided
/// otherwise are found alone.
pub(crate) trait PoseNumber: Number {
    /// Whether the number is larger than a part of another one, both without their signs.
    fn exceeds(self, part: f64, other: Self) -> bool;

    /// Whether the number is below zero.
    fn is_negative(self) -> bool;

    /// The number without its sign.
    fn size(self) -> Self;

    /// The larger of two numbers.
    fn or_larger(self, other: Self) -> Self;
}

impl PoseNumber for f64 {
    #[inline]
    fn exceeds(self, part: f64, other: Self) -> bool {
        self.abs() > part * other.abs()
    }

    #[inline]
    fn is_negative(self) -> bool {
        self < 0.0
    }

    #[inline]
    fn size(self) -> Self {
        self.abs()
    }

    #[inline]
    fn or_larger(self, other: Self) -> Self {
        self.max(other)
    }
}
