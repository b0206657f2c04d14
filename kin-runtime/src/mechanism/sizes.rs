//! The sizes of quantities, by which their steps are compared.

use num_traits::Float;

use super::Description;
use crate::quantity::Dimension;

/// The sizes of the quantities of a mechanism: 1 for an angle, and for a length that of the longest link or its value.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sizes {
    /// The longest length among the dimensions.
    longest: f64,
}

impl Sizes {
    pub(crate) fn of(description: &Description<'_>, parameters: &[f64]) -> Self {
        let lengths = description.parameters.iter().zip(parameters);
        let longest = lengths
            .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
            .fold(0.0, |longest: f64, (_, value)| longest.max(Float::abs(*value)));
        Self { longest }
    }

    /// The size of a quantity with this value.
    pub(crate) fn size(self, dimension: Dimension, value: f64) -> f64 {
        let value = Float::abs(value);
        match dimension {
            Dimension::Angle => 1.0,
            Dimension::Length if self.longest > 0.0 => self.longest.max(value),
            Dimension::Length if value > 0.0 => value,
            Dimension::Length => 1.0,
            Dimension::Scalar => value.max(1.0),
        }
    }
}
