//! Quantities by their names.

use kin_core::{Dimension, Mechanism, Pose, Quantity, Row};

use super::error::ObjectiveError;

/// An unknown or a scalar output of a mechanism, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Unknown(usize),
    Output(usize),
}

/// A quantity that is compared with targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Traced {
    pub(crate) name: &'static str,
    pub(crate) dimension: Dimension,
    pub(crate) place: Place,
}

fn known(quantities: &[Quantity]) -> String {
    let names: Vec<&str> = quantities.iter().map(|quantity| quantity.name).collect();
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}

/// The place of a quantity in a list.
pub(crate) fn index(quantities: &'static [Quantity], name: &str, kind: &'static str) -> Result<usize, ObjectiveError> {
    let place = quantities.iter().position(|quantity| quantity.name == name);
    place.ok_or_else(|| ObjectiveError::NoSuchQuantity {
        name: name.to_owned(),
        kind,
        known: known(quantities),
    })
}

impl Traced {
    /// The unknown or scalar output of a name.
    pub(crate) fn find<M: Mechanism>(name: &str, kind: &'static str) -> Result<Self, ObjectiveError> {
        let description = M::DESCRIPTION;
        let unknowns = description.unknowns.iter().enumerate();
        let outputs = description.outputs.iter().enumerate();
        let all = unknowns
            .map(|(index, quantity)| (Place::Unknown(index), quantity))
            .chain(outputs.map(|(index, quantity)| (Place::Output(index), quantity)));
        let mut named = all.filter(|(_, quantity)| quantity.name == name);
        let found = named.next().map(|(place, quantity)| Self {
            name: quantity.name,
            dimension: quantity.dimension,
            place,
        });
        found.ok_or_else(|| ObjectiveError::NoSuchQuantity {
            name: name.to_owned(),
            kind,
            known: format!("{}, {}", known(description.unknowns), known(description.outputs)),
        })
    }

    /// Both coordinates of a point of the plane.
    pub(crate) fn point<M: Mechanism>(name: &str) -> Result<[Self; 2], ObjectiveError> {
        let part = |axis: &str| {
            Self::find::<M>(&format!("{name}.{axis}"), "point").map_err(|error| match error {
                ObjectiveError::NoSuchQuantity { kind, known, .. } => ObjectiveError::NoSuchQuantity {
                    name: name.to_owned(),
                    kind,
                    known,
                },
                other => other,
            })
        };
        Ok([part("x")?, part("y")?])
    }

    /// The value in a pose, and its rate.
    pub(crate) fn of<P: Pose>(&self, pose: &P) -> [P::Scalar; 2] {
        let motion = match self.place {
            Place::Unknown(index) => pose.unknown_motions()[index],
            Place::Output(index) => pose.output_motions()[index],
        };
        let entries = motion.as_ref();
        [entries[0], entries[1.min(<P::Motion as Row<P::Scalar>>::LENGTH - 1)]]
    }
}
