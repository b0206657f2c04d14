//! The names of the time derivatives.

/// The names of the orders that have one.
const NAMES: [&str; 7] = ["position", "velocity", "acceleration", "jerk", "snap", "crackle", "pop"];

/// The name of the n-th time derivative.
pub(crate) fn order_name(order: usize) -> String {
    NAMES
        .get(order)
        .map_or_else(|| format!("derivative_{order}"), |name| (*name).to_owned())
}
