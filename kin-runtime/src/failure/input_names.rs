//! The names of the inputs in errors.

use core::fmt;

use crate::quantity::{Dimension, Name, NameKind, Quantity, WithUnit};

/// The names of the inputs, and which of them are angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InputNames {
    /// Those of a declared mechanism.
    Declared(&'static [Quantity<'static>]),
    /// The number of inputs of another mechanism, and a bit for each that is an angle.
    ByIndex(u8, u32),
}

impl InputNames {
    /// The names by the indices of the inputs. Inputs beyond the first 32 are left out.
    #[must_use]
    pub fn by_index(inputs: &[Quantity<'_>]) -> Self {
        let first = inputs.iter().take(32).enumerate();
        let mut names = (0, 0);
        for (index, input) in first {
            let is_angle = input.dimension == Dimension::Angle;
            names = (names.0 + 1, names.1 | u32::from(is_angle) << index);
        }
        Self::ByIndex(names.0, names.1)
    }

    /// The first of these names.
    pub(super) fn first(self, count: usize) -> Self {
        match self {
            Self::Declared(inputs) => Self::Declared(inputs.get(..count).unwrap_or(inputs)),
            Self::ByIndex(inputs, angles) => Self::ByIndex(inputs.min(u8::try_from(count).unwrap_or(u8::MAX)), angles),
        }
    }

    /// Each name, and whether it is that of an angle.
    pub(crate) fn iter(self) -> impl Iterator<Item = (Name, bool)> {
        let count = match self {
            Self::Declared(inputs) => inputs.len(),
            Self::ByIndex(count, _) => count.into(),
        };
        (0..count).map(move |index| match self {
            Self::Declared(inputs) => (inputs[index].name.into(), inputs[index].dimension == Dimension::Angle),
            Self::ByIndex(_, angles) => (Name::by_index(NameKind::Input, index), angles >> index & 1 == 1),
        })
    }

    /// Writes each name with its value.
    pub(crate) fn write(self, values: &[f64], formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, ((name, is_angle), value)) in self.iter().zip(values).enumerate() {
            let separator = if index == 0 { "" } else { ", " };
            let value = WithUnit {
                value: *value,
                is_angle,
            };
            write!(formatter, "{separator}{name} = {value}")?;
        }
        Ok(())
    }
}
