//! Quantities by their names.

use kin_core::Dimension;
use kin_core::any::{Description, Quantity};

use crate::error::ObjectiveError;

/// The index of an unknown or of a scalar output of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum QuantityIndex {
    /// An unknown by its index.
    Unknown(usize),
    /// A scalar output by its index.
    Output(usize),
}

/// A quantity that is compared with targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Traced {
    pub(crate) name: &'static str,
    pub(crate) dimension: Dimension,
    pub(crate) index: QuantityIndex,
    /// The factor of its errors.
    pub(crate) unit: f64,
}

fn known(quantities: &[Quantity<'_>]) -> String {
    let names: Vec<&str> = quantities.iter().map(|quantity| quantity.name).collect();
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}

/// The index of a quantity in a list.
pub(crate) fn index(quantities: &[Quantity<'_>], name: &str, kind: &'static str) -> Result<usize, ObjectiveError> {
    let index = quantities.iter().position(|quantity| quantity.name == name);
    index.ok_or_else(|| ObjectiveError::NoSuchQuantity {
        name: name.to_owned(),
        kind,
        known: known(quantities),
    })
}

impl Traced {
    /// All unknowns and scalar outputs, in their order.
    pub(crate) fn all(description: &'static Description<'static>) -> impl Iterator<Item = Self> {
        let unknowns = description.unknowns.iter().enumerate();
        let outputs = description.outputs.iter().enumerate();
        let all = unknowns
            .map(|(index, quantity)| (QuantityIndex::Unknown(index), quantity))
            .chain(outputs.map(|(index, quantity)| (QuantityIndex::Output(index), quantity)));
        all.map(|(index, quantity)| Self {
            name: quantity.name,
            dimension: quantity.dimension,
            index,
            unit: 1.0,
        })
    }

    /// The unknown or scalar output of a name.
    pub(crate) fn find(
        description: &'static Description<'static>,
        name: &str,
        kind: &'static str,
    ) -> Result<Self, ObjectiveError> {
        let found = Self::all(description).find(|quantity| quantity.name == name);
        found.ok_or_else(|| ObjectiveError::NoSuchQuantity {
            name: name.to_owned(),
            kind,
            known: format!("{}, {}", known(description.unknowns), known(description.outputs)),
        })
    }

    /// Both coordinates of a point of the plane.
    pub(crate) fn point(description: &'static Description<'static>, name: &str) -> Result<[Self; 2], ObjectiveError> {
        let part = |axis: &str| {
            Self::find(description, &format!("{name}.{axis}"), "point").map_err(|error| match error {
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

    /// The value in a position, whose outputs are given too.
    pub(crate) fn of<T: Copy>(&self, unknowns: &[T], outputs: &[T]) -> T {
        match self.index {
            QuantityIndex::Unknown(index) => unknowns[index],
            QuantityIndex::Output(index) => outputs[index],
        }
    }
}
