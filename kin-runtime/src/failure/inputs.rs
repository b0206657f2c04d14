//! The inputs of a solver that failed.

use core::fmt;

use crate::failure::InputNames;
use crate::quantity::{Name, Quantity};

/// The first few inputs of a mechanism with their names and units. They say where an error occurred.
///
/// ```
/// use kin_core::{InputValues, Quantity};
///
/// const INPUTS: [Quantity; 2] = [Quantity::angle("theta2", "crank"), Quantity::length("x", "slide")];
/// let inputs = InputValues::new(&INPUTS, &[1.954, 3.0]);
/// assert_eq!(inputs.to_string(), "theta2 = 1.954 rad (112.0°), x = 3");
/// let (name, value) = inputs.iter().nth(1).unwrap();
/// assert!(name == "x" && value == 3.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputValues {
    // Cut to the number of values.
    names: InputNames,
    values: [f64; Self::CAPACITY],
}

impl InputValues {
    /// The number of inputs that are kept. A mechanism usually has one or two, and a larger record would enlarge every
    /// result of a solver.
    pub const CAPACITY: usize = 5;

    /// No inputs.
    pub const NONE: Self = Self {
        names: InputNames::Declared(&[]),
        values: [0.0; Self::CAPACITY],
    };

    /// The inputs and their values, in the same order. Inputs without a value, values without an input, and inputs
    /// beyond the [capacity](Self::CAPACITY) are left out.
    #[inline]
    #[must_use]
    pub fn new(quantities: &'static [Quantity<'static>], values: &[f64]) -> Self {
        Self::of(InputNames::Declared(quantities), values)
    }

    /// The inputs with these names.
    #[inline]
    #[must_use]
    pub fn of(names: InputNames, values: &[f64]) -> Self {
        let count = values.len().min(Self::CAPACITY);
        let mut kept = [0.0; Self::CAPACITY];
        for (slot, value) in kept.iter_mut().zip(values).take(count) {
            *slot = *value;
        }
        Self {
            names: names.first(count),
            values: kept,
        }
    }

    /// An iterator over each name and its value, in the unit of the input: radians for an angle.
    pub fn iter(&self) -> impl Iterator<Item = (Name, f64)> {
        self.names
            .iter()
            .zip(self.values)
            .map(|((name, _), value)| (name, value))
    }
}

impl fmt::Display for InputValues {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.names.write(&self.values, formatter)
    }
}

#[cfg(test)]
mod tests {
    use super::InputValues;
    use crate::quantity::Quantity;
    use std::string::ToString;

    #[test]
    fn any_number_of_names_and_values_will_do() {
        const NINE: &[Quantity<'_>] = &[Quantity::length("a", ""); 9];
        const ONE: &[Quantity<'_>] = &[Quantity::angle("a", "")];
        assert_eq!(InputValues::new(NINE, &[1.0; 9]).iter().count(), InputValues::CAPACITY);
        assert_eq!(InputValues::new(NINE, &[1.0]).to_string(), "a = 1");
        assert_eq!(InputValues::new(ONE, &[1.0, 2.0]).to_string(), "a = 1 rad (57.3°)");
        assert_eq!(InputValues::new(&[], &[]).to_string(), "");
    }
}
