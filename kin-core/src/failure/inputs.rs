//! The inputs of a solver that failed.

use core::fmt;

use crate::failure::digits::Digits;

/// The first few inputs of a mechanism with their names. They tell where an error occurred.
///
/// ```
/// use kin_core::InputValues;
///
/// let inputs = InputValues::new(&["theta2", "x"], &[1.954, 3.0]);
/// assert_eq!(inputs.to_string(), "theta2 = 1.954, x = 3");
/// assert_eq!(inputs.iter().nth(1), Some(("x", 3.0)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputValues {
    // The names are cut to the number of values.
    names: &'static [&'static str],
    values: [f64; Self::CAPACITY],
}

impl InputValues {
    /// The number of inputs that are kept. A mechanism usually has one or two, and a larger record would enlarge every
    /// result of a solver.
    pub const CAPACITY: usize = 5;

    /// The inputs with these names and values, in the same order. Names without a value, values without a name, and
    /// inputs beyond the [capacity](Self::CAPACITY) are left out.
    #[must_use]
    pub fn new(names: &'static [&'static str], values: &[f64]) -> Self {
        let count = names.len().min(values.len()).min(Self::CAPACITY);
        let mut kept = [0.0; Self::CAPACITY];
        for (place, value) in kept.iter_mut().zip(values).take(count) {
            *place = *value;
        }
        Self {
            names: names.get(..count).unwrap_or(&[]),
            values: kept,
        }
    }

    /// An iterator over each name and its value, in the unit of the input: radians for an angle.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, f64)> + '_ {
        self.names.iter().copied().zip(self.values)
    }
}

impl fmt::Display for InputValues {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (name, value)) in self.iter().enumerate() {
            if index > 0 {
                formatter.write_str(", ")?;
            }
            write!(formatter, "{name} = {}", Digits(value))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::InputValues;
    use std::string::ToString;

    #[test]
    fn any_number_of_names_and_values_will_do() {
        const NAMES: &[&str] = &["a", "b", "c", "d", "e", "f", "g", "h", "i"];
        assert_eq!(InputValues::new(NAMES, &[1.0; 9]).iter().count(), InputValues::CAPACITY);
        assert_eq!(InputValues::new(NAMES, &[1.0]).to_string(), "a = 1");
        assert_eq!(InputValues::new(&["a"], &[1.0, 2.0]).to_string(), "a = 1");
        assert_eq!(InputValues::new(&[], &[]).to_string(), "");
    }
}
