//! The inputs of a solver that failed.

use core::fmt;

use crate::quantity::{Quantity, WithUnit};

/// The first few inputs of a mechanism with their names and units. They tell where an error occurred.
///
/// ```
/// use kin_core::{InputValues, Quantity};
///
/// const INPUTS: [Quantity; 2] = [Quantity::angle("theta2", "crank"), Quantity::length("x", "slide")];
/// let inputs = InputValues::new(&INPUTS, &[1.954, 3.0]);
/// assert_eq!(inputs.to_string(), "theta2 = 1.954 rad (112.0°), x = 3");
/// assert_eq!(inputs.iter().nth(1), Some(("x", 3.0)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputValues {
    // Cut to the number of values.
    quantities: &'static [Quantity],
    values: [f64; Self::CAPACITY],
}

impl InputValues {
    /// The number of inputs that are kept. A mechanism usually has one or two, and a larger record would enlarge every
    /// result of a solver.
    pub const CAPACITY: usize = 5;

    /// No inputs.
    pub const NONE: Self = Self {
        quantities: &[],
        values: [0.0; Self::CAPACITY],
    };

    /// The inputs and their values, in the same order. Inputs without a value, values without an input, and inputs
    /// beyond the [capacity](Self::CAPACITY) are left out.
    #[inline]
    #[must_use]
    pub fn new(quantities: &'static [Quantity], values: &[f64]) -> Self {
        let count = quantities.len().min(values.len()).min(Self::CAPACITY);
        let mut kept = [0.0; Self::CAPACITY];
        for (place, value) in kept.iter_mut().zip(values).take(count) {
            *place = *value;
        }
        Self {
            quantities: quantities.get(..count).unwrap_or(&[]),
            values: kept,
        }
    }

    /// An iterator over each name and its value, in the unit of the input: radians for an angle.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, f64)> + '_ {
        self.told().map(|(quantity, value)| (quantity.name, value))
    }

    fn told(&self) -> impl Iterator<Item = (&'static Quantity, f64)> + '_ {
        self.quantities.iter().zip(self.values)
    }
}

impl fmt::Display for InputValues {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (quantity, value)) in self.told().enumerate() {
            if index > 0 {
                formatter.write_str(", ")?;
            }
            write!(
                formatter,
                "{} = {}",
                quantity.name,
                WithUnit::new(value, quantity.dimension)
            )?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::InputValues;
    use crate::quantity::Quantity;
    use std::string::ToString;

    #[test]
    fn any_number_of_names_and_values_will_do() {
        const NINE: &[Quantity] = &[Quantity::length("a", ""); 9];
        const ONE: &[Quantity] = &[Quantity::angle("a", "")];
        assert_eq!(InputValues::new(NINE, &[1.0; 9]).iter().count(), InputValues::CAPACITY);
        assert_eq!(InputValues::new(NINE, &[1.0]).to_string(), "a = 1");
        assert_eq!(InputValues::new(ONE, &[1.0, 2.0]).to_string(), "a = 1 rad (57.3°)");
        assert_eq!(InputValues::new(&[], &[]).to_string(), "");
    }
}
