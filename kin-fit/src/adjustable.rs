//! Numbers that are given or sought.

use std::ops::RangeInclusive;

use serde::Deserialize;

use crate::error::ObjectiveError;

/// A number that is given, or sought between two bounds.
///
/// ```
/// use kin_fit::Adjustable;
///
/// assert_eq!(Adjustable::from(2.0), Adjustable::Fixed(2.0));
/// assert_eq!(Adjustable::from(0.0..=1.0), Adjustable::Free([0.0, 1.0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum Adjustable {
    /// The number itself, which is given.
    Fixed(f64),
    /// The bounds between which the number is sought.
    Free([f64; 2]),
}

impl Adjustable {
    /// The number itself, or the middle between its bounds.
    #[must_use]
    pub fn middle(self) -> f64 {
        match self {
            Self::Fixed(value) => value,
            Self::Free([low, high]) => f64::midpoint(low, high),
        }
    }

    pub(crate) fn checked(self, name: &str) -> Result<Self, ObjectiveError> {
        let name = || name.to_owned();
        match self {
            Self::Fixed(value) if !value.is_finite() => Err(ObjectiveError::NotFinite { name: name(), value }),
            Self::Free([low, high]) if !(low.is_finite() && high.is_finite() && low < high) => {
                let bounds = [low, high];
                Err(ObjectiveError::NotInOrder { name: name(), bounds })
            }
            good => Ok(good),
        }
    }
}

impl From<f64> for Adjustable {
    fn from(value: f64) -> Self {
        Self::Fixed(value)
    }
}

impl From<RangeInclusive<f64>> for Adjustable {
    fn from(range: RangeInclusive<f64>) -> Self {
        Self::Free([*range.start(), *range.end()])
    }
}
