//! Numbers without their derivatives: of one pose, or of several that are solved together.

use crate::number::Number;

/// A number of one pose, or of several, each of which decides for itself.
pub(crate) trait PoseNumber: Number {
    /// The number where a condition on some others holds. One pose has none where it does not hold. Of several poses,
    /// those in which it does not hold become NaN, and are found alone.
    fn provided<const K: usize>(self, operands: [Self; K], holds: impl Fn([f64; K]) -> bool) -> Option<Self>;

    /// The number without its sign.
    fn size(self) -> Self;

    /// The larger of two numbers.
    fn or_larger(self, other: Self) -> Self;

    /// The number of one of the poses.
    fn of_pose(self, pose: usize) -> f64;
}

impl PoseNumber for f64 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn provided<const K: usize>(self, operands: [Self; K], holds: impl Fn([f64; K]) -> bool) -> Option<Self> {
        holds(operands).then_some(self)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn size(self) -> Self {
        self.abs()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn or_larger(self, other: Self) -> Self {
        self.max(other)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_pose(self, _: usize) -> f64 {
        self
    }
}
