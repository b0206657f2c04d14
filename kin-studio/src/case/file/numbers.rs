//! The numbers of a file: dimensions, and motions of inputs.

use std::ops::Range;

use kin_compiler::Quantity;
use kin_core::Dimension;

use super::super::fault::similar;
use super::super::motion::InputMotion;
use super::super::value::{self, Lengths};
use crate::file::{Entry, Mistake, Part};

/// A quantity of the declaration.
#[derive(Clone, Debug)]
struct Declared {
    name: String,
    dimension: Dimension,
    /// One, or the number of coordinates of a point.
    parts: usize,
}

impl From<&Quantity> for Declared {
    fn from(quantity: &Quantity) -> Self {
        use kin_compiler::Dimension as Of;
        let (dimension, parts) = match quantity.dimension {
            Of::Length => (Dimension::Length, 1),
            Of::Angle | Of::Direction => (Dimension::Angle, 1),
            Of::Scalar => (Dimension::Scalar, 1),
            Of::Point | Of::Vector => (Dimension::Length, 2),
            Of::Point3 | Of::Vector3 => (Dimension::Length, 3),
        };
        Self {
            name: quantity.name.clone(),
            dimension,
            parts,
        }
    }
}

/// The number of a dimension, of its coordinate, or of an input that stands.
#[derive(Clone, Debug)]
pub(crate) struct Number {
    pub(crate) name: String,
    pub(crate) dimension: Dimension,
    pub(crate) value: Part,
}

impl Number {
    /// As it is typed behind `--set`.
    pub(crate) fn setting(&self) -> String {
        format!("{}={}", self.name, self.value.text)
    }
}

const COORDINATES: [&str; 3] = ["x", "y", "z"];

/// The names of the scalars of a quantity.
fn scalars(quantity: &Declared) -> Vec<String> {
    if quantity.parts == 1 {
        return vec![quantity.name.clone()];
    }
    let parts = COORDINATES[..quantity.parts].iter();
    parts.map(|part| format!("{}.{part}", quantity.name)).collect()
}

/// The numbers of dimensions, and what is wrong in them.
pub(super) fn dimensions(
    fields: &[Quantity],
    entries: &[Entry],
    section: Option<Range<usize>>,
    text: &str,
    lengths: &mut Lengths,
) -> (Vec<Number>, Vec<Mistake>) {
    let fields: Vec<Declared> = fields.iter().map(Declared::from).collect();
    let (mut set, mut mistakes) = (Vec::new(), Vec::new());
    let mut given: Vec<String> = Vec::new();
    let mut has_misnamed = false;
    for entry in entries {
        let name = entry.head.text.replace(' ', "");
        let base = name.split('.').next().unwrap_or("");
        let Some(field) = fields.iter().find(|field| field.name == base) else {
            let names = fields.iter().map(|field| field.name.as_str());
            let advice = similar(&name, names);
            mistakes.push(
                entry
                    .head
                    .mistake(format!("the structure has no dimension `{name}`; {advice}")),
            );
            has_misnamed = true;
            continue;
        };
        let pieces = match pieces(field, &name, &entry.value) {
            Ok(pieces) => pieces,
            Err(mistake) => {
                mistakes.push(mistake);
                given.extend(scalars(field));
                continue;
            }
        };
        for (name, value) in pieces {
            if given.contains(&name) {
                mistakes.push(entry.head.mistake(format!("`{name}` has two values")));
                has_misnamed = true;
                continue;
            }
            if let Err(message) = value::quantity(field.dimension, &value.text, lengths) {
                mistakes.push(value.mistake(message));
            }
            given.push(name.clone());
            set.push(Number {
                name,
                dimension: field.dimension,
                value,
            });
        }
    }
    let all = fields.iter().flat_map(scalars);
    let missing: Vec<String> = all.filter(|name| !given.contains(name)).collect();
    if let (Some(first), false) = (missing.first(), has_misnamed) {
        let names: Vec<String> = missing.iter().map(|name| format!("`{name}`")).collect();
        let message = format!(
            "no value for {}: write `dimensions {{ {first} = 45mm; }}`",
            names.join(", ")
        );
        let end = text.trim_end().len();
        mistakes.push(Mistake::new(message, section.unwrap_or(end..end)));
    }
    (set, mistakes)
}

/// The scalars of an entry with their values.
fn pieces(field: &Declared, name: &str, value: &Part) -> Result<Vec<(String, Part)>, Mistake> {
    let base = &field.name;
    match value.coordinates() {
        Some(parts) if field.parts == 1 || parts.len() != field.parts => {
            let wanted = if field.parts == 1 {
                "one number".to_owned()
            } else {
                format!("{} coordinates", field.parts)
            };
            Err(value.mistake(format!("`{base}` takes {wanted}")))
        }
        Some(parts) => Ok(scalars(field).into_iter().zip(parts).collect()),
        None if field.parts > 1 && !name.contains('.') => {
            let example = vec!["1.5"; field.parts].join(", ");
            Err(value.mistake(format!("`{base}` is a point: write `{base} = ({example});`")))
        }
        None => Ok(vec![(name.to_owned(), value.clone())]),
    }
}

/// The motions as they are typed behind `--over`, and what is wrong in them. Inputs that stand go to `set`.
pub(super) fn motions(
    inputs: &[Quantity],
    entries: &[Entry],
    lengths: &mut Lengths,
    set: &mut Vec<Number>,
) -> (Vec<String>, Vec<Mistake>) {
    let (mut over, mut mistakes) = (Vec::new(), Vec::new());
    let mut given: Vec<&str> = Vec::new();
    for entry in entries {
        let name = entry.head.text.as_str();
        let Some(input) = inputs.iter().find(|input| input.name == name) else {
            let names = inputs.iter().map(|input| input.name.as_str());
            let advice = similar(name, names);
            mistakes.push(entry.head.mistake(format!("there is no input `{name}`; {advice}")));
            continue;
        };
        if given.contains(&name) {
            let message = format!("`{name}` has two motions: parts of one stand between commas");
            mistakes.push(entry.head.mistake(message));
            continue;
        }
        given.push(name);
        let value = &entry.value;
        let Declared { name, dimension, .. } = Declared::from(input);
        match InputMotion::read_parts(dimension, &value.text, lengths) {
            Ok(motion) if motion.moves() => over.push(format!("{name}={}", value.text)),
            Ok(_) => set.push(Number {
                name,
                dimension,
                value: value.clone(),
            }),
            Err((message, part)) => {
                let start = value.range.start;
                mistakes.push(Mistake::new(message, start + part.start..start + part.end));
            }
        }
    }
    (over, mistakes)
}
