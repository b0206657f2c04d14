//! The names of functions, of their arguments and of the fields of their results.

use kin_core::any::Quantity;
use kin_core::{Dimension, RATES};

/// A quantity's name as a name of SQL: `tracer.x` becomes `tracer_x`.
pub(crate) fn plain(quantity: &Quantity<'_>) -> String {
    quantity.name.replace('.', "_").to_lowercase()
}

/// The name of a quantity's derivative of some order.
pub(crate) fn of_order(name: &str, order: usize) -> String {
    match order.checked_sub(1).and_then(|rate| RATES.get(rate)) {
        Some(rate) => format!("{name}_{rate}"),
        None => name.to_owned(),
    }
}

/// The unit of a quantity's derivative of some order.
pub(crate) fn unit(dimension: Dimension, order: usize) -> String {
    let base = match dimension {
        Dimension::Length => "length",
        Dimension::Angle => "rad",
        Dimension::Scalar => "1",
    };
    match order {
        0 => base.to_owned(),
        1 => format!("{base}/s"),
        _ => format!("{base}/s^{order}"),
    }
}
