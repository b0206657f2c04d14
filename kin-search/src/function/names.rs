//! The names of functions, of their arguments and of the fields of their results.

use kin_core::{Dimension, Quantity};

/// The names of the rates, from the first on.
pub(crate) const RATES: [&str; 12] = [
    "velocity",
    "acceleration",
    "jerk",
    "snap",
    "crackle",
    "pop",
    "derivative_7",
    "derivative_8",
    "derivative_9",
    "derivative_10",
    "derivative_11",
    "derivative_12",
];

/// A type's name in small letters with underscores: `FourBar` becomes `four_bar`, and `WattIIByCouplers` `watt_ii_by_couplers`.
pub(crate) fn snake(name: &str) -> String {
    let letters: Vec<char> = name.chars().collect();
    let mut own = String::new();
    for (place, letter) in letters.iter().enumerate() {
        let before = place.checked_sub(1).and_then(|place| letters.get(place));
        let follows_small = before.is_some_and(|before| *before != '_' && !before.is_uppercase());
        let precedes_small = before.is_some_and(|before| *before != '_')
            && letters.get(place + 1).is_some_and(|next| next.is_lowercase());
        if letter.is_uppercase() && (follows_small || precedes_small) {
            own.push('_');
        }
        own.extend(letter.to_lowercase());
    }
    own
}

/// A quantity's name as a name of SQL: `tracer.x` becomes `tracer_x`.
pub(crate) fn plain(quantity: &Quantity) -> String {
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
    let own = match dimension {
        Dimension::Length => "length",
        Dimension::Angle => "rad",
        Dimension::Scalar => "1",
    };
    match order {
        0 => own.to_owned(),
        1 => format!("{own}/s"),
        _ => format!("{own}/s^{order}"),
    }
}

#[cfg(test)]
mod tests {
    use super::snake;

    #[test]
    fn types_in_small_letters() {
        for (name, own) in [
            ("FourBar", "four_bar"),
            ("WattIIByCouplers", "watt_ii_by_couplers"),
            ("Rssr", "rssr"),
            ("StephensonIII", "stephenson_iii"),
        ] {
            assert_eq!(snake(name), own);
        }
    }
}
