//! Keyword arguments: values for quantities by their names.

use std::borrow::Cow;

use kin_core::any::{Description, Quantity};
use kin_core::{Dimension, RATES};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat};

/// Scalar quantities that have one name: a point `p`, whose coordinates are `p.x` and `p.y`, or a number.
pub(crate) struct Group<'d> {
    pub(crate) name: &'d str,
    /// The index of the first of them.
    pub(crate) first: usize,
    /// 1 for a number, 2 or 3 for a point.
    pub(crate) coordinates: usize,
    pub(crate) is_point: bool,
}

/// The groups of scalar quantities, in their order.
pub(crate) fn groups<'d>(quantities: &[Quantity<'d>]) -> Vec<Group<'d>> {
    let mut groups: Vec<Group<'d>> = Vec::new();
    for (index, quantity) in quantities.iter().enumerate() {
        let point = quantity.name.rsplit_once('.').map(|(point, _)| point);
        match (point, groups.last_mut()) {
            (Some(point), Some(last)) if last.is_point && last.name == point => last.coordinates += 1,
            _ => groups.push(Group {
                name: point.unwrap_or(quantity.name),
                first: index,
                coordinates: 1,
                is_point: point.is_some(),
            }),
        }
    }
    groups
}

/// A kind of quantities, of which values are wanted.
pub(crate) struct Wanted<'d> {
    /// The word for one of them.
    pub(crate) kind: &'static str,
    pub(crate) quantities: &'d [Quantity<'d>],
}

/// The values of all wanted quantities, kind by kind, each in the order of the declaration. A point is given as a
/// sequence of its coordinates, or each coordinate by its own name.
pub(crate) fn values<'py>(
    given: Option<&Bound<'py, PyDict>>,
    wanted: &[Wanted<'_>],
) -> PyResult<Vec<Vec<Bound<'py, PyAny>>>> {
    let mut known = 0;
    let mut missing = Vec::new();
    let mut all = Vec::new();
    for Wanted { kind, quantities } in wanted {
        let mut values = Vec::new();
        for group in groups(quantities) {
            let whole = given.map(|given| given.get_item(group.name)).transpose()?.flatten();
            if let Some(whole) = whole {
                known += 1;
                if group.is_point {
                    values.extend(coordinates(&whole, &group)?);
                } else {
                    values.push(whole);
                }
                continue;
            }
            for quantity in &quantities[group.first..group.first + group.coordinates] {
                match given.map(|given| given.get_item(quantity.name)).transpose()?.flatten() {
                    Some(value) if group.is_point => {
                        known += 1;
                        values.push(value);
                    }
                    _ => {
                        missing.push(format!("{kind} `{}`", group.name));
                        break;
                    }
                }
            }
        }
        all.push(values);
    }
    if given.map_or(0, PyDictMethods::len) > known {
        return Err(unknown(given, wanted)?);
    }
    if missing.is_empty() {
        return Ok(all);
    }
    Err(PyTypeError::new_err(format!("missing: {}", missing.join(", "))))
}

/// The error for a name that nothing has, or for a point that is given twice.
fn unknown(given: Option<&Bound<'_, PyDict>>, wanted: &[Wanted<'_>]) -> PyResult<PyErr> {
    let groups_of = |wanted: &Wanted<'_>| {
        let names = groups(wanted.quantities);
        names.into_iter().map(|group| group.name.to_owned()).collect::<Vec<_>>()
    };
    for name in given.into_iter().flat_map(PyDictMethods::keys) {
        let name: String = name.extract()?;
        let mut scalars = wanted.iter().flat_map(|wanted| wanted.quantities);
        let is_known = wanted.iter().any(|wanted| groups_of(wanted).contains(&name))
            || scalars.any(|quantity| quantity.name == name);
        if !is_known {
            let kinds = wanted.iter().map(|wanted| wanted.kind).collect::<Vec<_>>().join(" or ");
            let lists = wanted.iter().map(|wanted| match groups_of(wanted).join(", ") {
                list if list.is_empty() => format!("there is no {}", wanted.kind),
                list => format!("{}s are {list}", wanted.kind),
            });
            let lists = lists.collect::<Vec<_>>().join("; ");
            return Ok(PyTypeError::new_err(format!("no {kinds} is called `{name}`: {lists}")));
        }
    }
    Ok(PyTypeError::new_err(
        "a point is given twice: as a whole and by a coordinate",
    ))
}

fn coordinates<'py>(point: &Bound<'py, PyAny>, group: &Group<'_>) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let count = point.len().unwrap_or(0);
    if count != group.coordinates {
        return Err(PyTypeError::new_err(format!(
            "`{}` is a point: give its {} coordinates, as in `{}=({})`",
            group.name,
            group.coordinates,
            group.name,
            ["x", "y", "z"][..group.coordinates.min(3)].join(", "),
        )));
    }
    (0..count).map(|index| point.get_item(index)).collect()
}

/// A number.
pub(crate) fn number(value: &Bound<'_, PyAny>, quantity: &Quantity<'_>) -> PyResult<f64> {
    rate(value, quantity, 0)
}

/// A derivative of a quantity with respect to time; the quantity itself has the order 0.
pub(crate) fn rate(value: &Bound<'_, PyAny>, quantity: &Quantity<'_>, order: usize) -> PyResult<f64> {
    let value = without_unit(value, quantity, order)?;
    value.extract::<f64>().map_err(|error| {
        let py = value.py();
        PyTypeError::new_err(format!("`{}`: {}", quantity.name, error.value(py)))
    })
}

/// A quantity of pint in radians, metres and seconds; any other value as it is.
pub(crate) fn without_unit<'py>(
    value: &Bound<'py, PyAny>,
    quantity: &Quantity<'_>,
    order: usize,
) -> PyResult<Bound<'py, PyAny>> {
    if value.is_instance_of::<PyFloat>() || !value.hasattr("to_base_units")? {
        return Ok(value.clone());
    }
    let base = value.call_method0("to_base_units")?;
    let length = u8::from(quantity.dimension == Dimension::Length);
    let time = -i32::try_from(order).unwrap_or(i32::MAX);
    let expected = [("[length]", f64::from(length)), ("[time]", f64::from(time))];
    let powers = base.getattr("dimensionality")?;
    let mut is_expected = true;
    for power in powers.call_method0("items")?.try_iter()? {
        let (name, power): (String, f64) = power?.extract()?;
        is_expected &= expected.contains(&(name.as_str(), power));
    }
    for (name, power) in expected {
        is_expected &= power == 0.0 || powers.contains(name)?;
    }
    if is_expected {
        return base.getattr("magnitude");
    }
    let rates = [
        "",
        " by time",
        " by time squared",
        " by time to the third",
        " by time to the fourth",
    ];
    Err(PyTypeError::new_err(format!(
        "`{}` is {value}: give {}{}",
        quantity.name,
        match quantity.dimension {
            Dimension::Length => "a length",
            Dimension::Angle => "an angle",
            Dimension::Scalar => "a number",
        },
        rates.get(order).unwrap_or(&"")
    )))
}

/// The position of an input with its derivatives by time, those that are missing as zero.
pub(crate) fn motion(value: &Bound<'_, PyAny>, quantity: &Quantity<'_>, orders: usize) -> PyResult<Vec<f64>> {
    let name = quantity.name;
    let Ok(count) = value.len() else {
        let mut motion = vec![0.0; orders];
        motion[0] = number(value, quantity)?;
        return Ok(motion);
    };
    if count == 0 || count > orders {
        return Err(PyValueError::new_err(format!(
            "`{name}` has {count} numbers: give its position, and behind it up to {} derivatives with respect to time",
            orders - 1
        )));
    }
    let mut motion = (0..count)
        .map(|order| rate(&value.get_item(order)?, quantity, order))
        .collect::<PyResult<Vec<f64>>>()?;
    motion.resize(orders, 0.0);
    Ok(motion)
}

/// The values of the inputs alone: see `values`.
pub(crate) fn inputs<'py>(
    given: Option<&Bound<'py, PyDict>>,
    description: &Description<'_>,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let wanted = Wanted {
        kind: "input",
        quantities: description.inputs,
    };
    Ok(values(given, &[wanted])?.pop().unwrap_or_default())
}

/// The index of an input by its name, which may be left out if there is one.
pub(crate) fn input_index(description: &Description<'_>, name: Option<&str>) -> PyResult<usize> {
    let names = || {
        description
            .inputs
            .iter()
            .map(|input| input.name)
            .collect::<Vec<_>>()
            .join(", ")
    };
    let Some(name) = name else {
        if description.inputs.len() == 1 {
            return Ok(0);
        }
        return Err(PyTypeError::new_err(format!(
            "which input is meant? there are {}",
            names()
        )));
    };
    let index = description.inputs.iter().position(|input| input.name == name);
    index.ok_or_else(|| PyTypeError::new_err(format!("no input is called `{name}`: inputs are {}", names())))
}

/// The name of a quantity as in the columns of tables, `theta4_jerk`, which may be written as `theta4.jerk`.
pub(crate) fn column_name(name: &str) -> Cow<'_, str> {
    match name.rsplit_once('.') {
        Some((quantity, rate)) if RATES.contains(&rate) => format!("{quantity}_{rate}").into(),
        _ => name.into(),
    }
}
