//! The columns of a table: what each of them is.

use alloc::string::{String, ToString};
use core::fmt;

use super::Variable;
use crate::mechanism::Description;
use crate::quantity::{Dimension, Quantity, RATES};

/// What a column holds: a quantity, and the order of its derivative with respect to time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Label<'q> {
    /// The name of the quantity.
    pub name: &'q str,
    /// The dimension of the quantity.
    pub dimension: Dimension,
    /// The order of the derivative, 0 for the value itself.
    pub order: usize,
    /// The variable of the sweep itself, which has no orders, if it is no input.
    pub(super) is_variable: bool,
}

impl<'q> Label<'q> {
    /// The column of a derivative.
    #[must_use]
    pub const fn new(quantity: Quantity<'q>, order: usize) -> Self {
        Self {
            name: quantity.name,
            dimension: quantity.dimension,
            order,
            is_variable: false,
        }
    }

    /// Whether this is the name of the column: that of the quantity, followed by the order, as in `theta4_velocity`.
    #[must_use]
    pub fn is(&self, name: &str) -> bool {
        let Some(rest) = name.strip_prefix(self.name) else {
            return false;
        };
        match self.order.checked_sub(1) {
            None => rest.is_empty(),
            Some(rate) => rest.strip_prefix('_') == RATES.get(rate).copied(),
        }
    }
}

/// The name of the column.
impl fmt::Display for Label<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name)?;
        match self.order.checked_sub(1) {
            None => Ok(()),
            Some(rate) => write!(formatter, "_{}", RATES.get(rate).unwrap_or(&"derivative")),
        }
    }
}

/// The unit of a column, as text: `rad/s²`, `mm/s`.
///
/// A mechanism has units of length and time. Until [`Table::units`](super::Table::units) names them they are `L` and
/// `T`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit<'t> {
    /// The unit as it was given, of a column that is no quantity of the mechanism.
    pub(super) given: Option<&'t str>,
    pub(super) dimension: Dimension,
    pub(super) order: usize,
    pub(super) is_time: bool,
    pub(super) in_degrees: bool,
    pub(super) length: &'t str,
    pub(super) time: &'t str,
}

impl Unit<'_> {
    /// Whether it is the unit of a plain number, which is not written.
    fn is_none(&self) -> bool {
        match self.given {
            Some(given) => given.is_empty(),
            None => self.dimension == Dimension::Scalar && self.order == 0 && !self.is_time,
        }
    }
}

impl fmt::Display for Unit<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(given) = self.given {
            return formatter.write_str(given);
        }
        if self.is_time {
            return formatter.write_str(self.time);
        }
        let value = match self.dimension {
            Dimension::Length => self.length,
            Dimension::Angle if self.in_degrees => "deg",
            Dimension::Angle => "rad",
            Dimension::Scalar => "1",
        };
        formatter.write_str(if self.order == 0 && value == "1" { "" } else { value })?;
        match self.order {
            0 => Ok(()),
            1 => write!(formatter, "/{}", self.time),
            order => {
                write!(formatter, "/{}", self.time)?;
                for digit in [order / 10, order % 10].iter().skip_while(|digit| **digit == 0) {
                    let digits = ["⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"];
                    formatter.write_str(digits[*digit])?;
                }
                Ok(())
            }
        }
    }
}

/// A column of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnOf<'t> {
    /// What it holds; its `Display` is the name of the column.
    pub label: Label<'t>,
    /// Its unit.
    pub unit: Unit<'t>,
    /// A number for each row, NaN where the mechanism does not close.
    pub values: &'t [f64],
}

/// The heading of a column where it stands over numbers: its name, and its unit in brackets, as in
/// `theta4_velocity [rad/s]`.
impl fmt::Display for ColumnOf<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { label, unit, .. } = self;
        write!(formatter, "{label}")?;
        if unit.is_none() {
            return Ok(());
        }
        write!(formatter, " [{unit}]")
    }
}

/// A label that has its name by itself.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Heading {
    name: String,
    pub(super) dimension: Dimension,
    pub(super) order: usize,
    pub(super) is_variable: bool,
    /// The unit of a column that is no quantity of the mechanism.
    pub(super) unit: Option<String>,
}

impl Heading {
    /// That of a column which is no quantity of the mechanism.
    pub(super) fn other(name: &str, unit: &str) -> Self {
        Self {
            name: name.to_string(),
            dimension: Dimension::Scalar,
            order: 0,
            is_variable: false,
            unit: Some(unit.to_string()),
        }
    }
}

impl From<Label<'_>> for Heading {
    fn from(label: Label<'_>) -> Self {
        Self {
            name: label.name.to_string(),
            dimension: label.dimension,
            order: label.order,
            is_variable: label.is_variable,
            unit: None,
        }
    }
}

impl Heading {
    pub(super) fn label(&self) -> Label<'_> {
        Label {
            name: &self.name,
            dimension: self.dimension,
            order: self.order,
            is_variable: self.is_variable,
        }
    }
}

/// The labels of all columns of a mechanism: the variable unless it is an input, then inputs, unknowns and outputs,
/// each in all orders.
pub(super) fn labels<'d>(description: &'d Description<'d>, variable: Variable) -> impl Iterator<Item = Label<'d>> {
    let given = match variable {
        Variable::Input(_) => None,
        _ => Some(Label {
            is_variable: true,
            ..Label::new(variable.of(description), 0)
        }),
    };
    let quantities = [description.inputs, description.unknowns, description.outputs];
    let all = quantities
        .into_iter()
        .flatten()
        .flat_map(move |quantity| (0..=description.order).map(move |order| Label::new(*quantity, order)));
    given.into_iter().chain(all)
}
