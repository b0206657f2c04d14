//! Columns, as people name them.

use kin_core::RATES;
use kin_core::any::{Description, Quantity};

use super::fault::{Fault, similar};
use super::file::Settings;
use super::loads::ForceColumns;
use super::subject::Subject;

/// The word for all columns.
pub(crate) const ALL: &str = "all";

/// The name of a derivative.
pub(crate) fn label(quantity: &str, order: usize) -> String {
    match order.checked_sub(1) {
        None => quantity.to_owned(),
        Some(rate) => format!("{quantity}_{}", RATES[rate]),
    }
}

/// The names of all columns: inputs, unknowns and outputs with their rates, and the forces if there are loads.
pub(crate) fn names(description: &Description<'_>, forces: &ForceColumns) -> Vec<String> {
    let quantities = [description.inputs, description.unknowns, description.outputs];
    let of_one = |quantity: &Quantity<'_>| {
        let name = quantity.name.to_owned();
        (0..=description.order).map(move |order| label(&name, order))
    };
    let quantities = quantities.into_iter().flatten().flat_map(of_one);
    quantities
        .chain(forces.all.iter().map(|force| force.name(description)))
        .collect()
}

/// The columns of a name: one, or the coordinates of a point, as in `tip` and `tip_velocity`.
pub(crate) fn named<'n>(name: &str, names: &'n [String]) -> Result<Vec<&'n str>, String> {
    let exact: Vec<&str> = names
        .iter()
        .map(String::as_str)
        .filter(|column| *column == name)
        .collect();
    if !exact.is_empty() {
        return Ok(exact);
    }
    let point = |column: &str| {
        let (point, rest) = column.split_once('.')?;
        // behind the letter of the axis
        Some(format!("{point}{}", rest.get(1..)?))
    };
    let coordinates = names.iter().map(String::as_str);
    let coordinates: Vec<&str> = coordinates
        .filter(|column| point(column).as_deref() == Some(name))
        .collect();
    if !coordinates.is_empty() {
        return Ok(coordinates);
    }
    // columns that begin with the name come before similar columns
    let begun = names
        .iter()
        .filter(|column| column.starts_with(name))
        .min_by_key(|column| column.len());
    let advice = if let Some(column) = begun {
        format!("did you mean `{column}`?")
    } else {
        let points: Vec<String> = names.iter().filter_map(|column| point(column)).collect();
        similar(name, names.iter().chain(&points).map(String::as_str))
    };
    let example = names.get(1).map_or("", String::as_str);
    Err(if advice.starts_with("did you mean") {
        format!("there is no column `{name}`; {advice}")
    } else {
        format!("there is no column `{name}`; a column is called by its quantity and its rate, as in `{example}`")
    })
}

/// The columns of several names, in their order, each once; none if there are no names, or if all are wanted.
pub(crate) fn chosen(wanted: &[String], names: &[String]) -> Result<Vec<String>, String> {
    let mut all: Vec<String> = Vec::new();
    for name in wanted.iter().filter(|name| *name != ALL) {
        for column in named(name, names)? {
            if !all.iter().any(|known| known == column) {
                all.push(column.to_owned());
            }
        }
    }
    if wanted.iter().any(|name| name == ALL) {
        all.clear();
    }
    Ok(all)
}

/// The columns that were typed, or else those of the file; none for those that are shown without being asked for.
pub(crate) fn columns_of(subject: &Subject, typed: &[String], settings: &Settings) -> Result<Vec<String>, Fault> {
    let forces = if settings.loads.is_empty() {
        ForceColumns::default()
    } else {
        subject.forces(&settings.loads.stated(1.0))
    };
    let names = names(subject.description(), &forces);
    let wanted = if typed.is_empty() { &settings.columns } else { typed };
    chosen(wanted, &names).map_err(|message| {
        let advice = wanted.iter().find_map(|name| forces.advice(name));
        Fault::Wrong(advice.unwrap_or(message))
    })
}

#[cfg(test)]
mod tests {
    use super::super::subject::Subject;
    use super::*;
    use crate::forces::Stated;
    use kin_core::library::FiveBar;

    #[test]
    fn a_point_has_the_columns_of_its_coordinates() {
        let subject = Subject::of::<FiveBar>();
        let names = names(subject.description(), &subject.forces(&Stated::default()));
        let chosen = |wanted: &[&str]| {
            let wanted: Vec<String> = wanted.iter().map(|&name| name.to_owned()).collect();
            chosen(&wanted, &names)
        };
        let both = ["hand.x_velocity", "hand.y_velocity"].map(str::to_owned).to_vec();
        assert_eq!(chosen(&["hand_velocity", "hand.x_velocity"]), Ok(both));
        assert_eq!(chosen(&["all", "hand"]), Ok(Vec::new()));
        for (wrong, advice) in [
            ("hnad", "did you mean `hand`?"),
            ("alpha_acc", "did you mean `alpha_acceleration`?"),
            ("alpha_efort", "did you mean `alpha_effort`?"),
            ("zzz", "as in `alpha_velocity`"),
        ] {
            let message = chosen(&[wrong]).unwrap_err();
            assert!(message.ends_with(advice), "{message}");
        }
    }
}
