//! A pose as text: a line for each quantity, with its name, unit and rates.

use core::fmt;

use crate::geometry::{Plane, Space};
use crate::mechanism::{Description, Mechanism};
use crate::motion::{Direction, Motion};
use crate::number::Number;
use crate::quantity::{Dimension, Quantity, RATES, WithUnit};
use crate::solve::Scalar;

/// A field of a pose, as numbers.
pub trait Shown {
    /// The number of coordinates: 1, or those of a point.
    fn coordinates(&self) -> usize;

    /// The number of orders, with the value.
    fn orders(&self) -> usize;

    /// A coordinate's derivative of an order, if there is one.
    fn entry(&self, coordinate: usize, order: usize) -> Option<f64>;
}

impl<T: Number, const N: usize> Shown for Motion<T, N> {
    fn coordinates(&self) -> usize {
        1
    }

    fn orders(&self) -> usize {
        N
    }

    fn entry(&self, _: usize, order: usize) -> Option<f64> {
        self.derivative(order).map(Number::real)
    }
}

impl<T: Scalar, const N: usize> Shown for Direction<T, N> {
    fn coordinates(&self) -> usize {
        1
    }

    fn orders(&self) -> usize {
        N + 1
    }

    fn entry(&self, _: usize, order: usize) -> Option<f64> {
        self.derivative(order).map(Number::real)
    }
}

impl<T: Number, const N: usize> Shown for Motion<Plane<T>, N> {
    fn coordinates(&self) -> usize {
        2
    }

    fn orders(&self) -> usize {
        N
    }

    fn entry(&self, coordinate: usize, order: usize) -> Option<f64> {
        let point: [T; 2] = self.derivative(order)?.into();
        point.get(coordinate).map(|part| part.real())
    }
}

impl<T: Number, const N: usize> Shown for Motion<Space<T>, N> {
    fn coordinates(&self) -> usize {
        3
    }

    fn orders(&self) -> usize {
        N
    }

    fn entry(&self, coordinate: usize, order: usize) -> Option<f64> {
        let point: [T; 3] = self.derivative(order)?.into();
        point.get(coordinate).map(|part| part.real())
    }
}

/// Writes a pose of a mechanism. The fields are its inputs, unknowns and outputs, in the order of the description.
///
/// # Errors
/// Returns the errors of the formatter.
pub fn fmt_pose<M: Mechanism>(formatter: &mut fmt::Formatter<'_>, fields: &[&dyn Shown]) -> fmt::Result {
    fmt_fields(formatter, &M::DESCRIPTION, fields)
}

fn fmt_fields(formatter: &mut fmt::Formatter<'_>, description: &Description<'_>, fields: &[&dyn Shown]) -> fmt::Result {
    let quantities = description.inputs.iter().chain(description.unknowns);
    let mut quantities = quantities.chain(description.outputs);
    for (index, field) in fields.iter().enumerate() {
        let Some(quantity) = quantities.next() else {
            return Ok(());
        };
        for _ in 1..field.coordinates() {
            quantities.next();
        }
        formatter.write_str(if index == 0 { "" } else { "\n" })?;
        fmt_field(formatter, quantity, *field)?;
    }
    Ok(())
}

fn fmt_field(formatter: &mut fmt::Formatter<'_>, quantity: &Quantity<'_>, field: &dyn Shown) -> fmt::Result {
    let is_point = field.coordinates() > 1;
    let name = if is_point {
        quantity.name.trim_end_matches(".x")
    } else {
        quantity.name
    };
    write!(formatter, "{name} = ")?;
    for order in 0..field.orders() {
        if let Some(rate) = order.checked_sub(1).and_then(|index| RATES.get(index)) {
            write!(formatter, ", {rate} ")?;
        }
        formatter.write_str(if is_point { "(" } else { "" })?;
        for coordinate in 0..field.coordinates() {
            let value = field.entry(coordinate, order).unwrap_or(f64::NAN);
            let is_angle = order == 0 && quantity.dimension == Dimension::Angle;
            formatter.write_str(if coordinate == 0 { "" } else { ", " })?;
            fmt::Display::fmt(&WithUnit { value, is_angle }, formatter)?;
        }
        formatter.write_str(if is_point { ")" } else { "" })?;
    }
    Ok(())
}
