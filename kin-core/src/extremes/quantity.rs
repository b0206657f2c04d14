//! Quantities called by the names of columns.

use alloc::vec::Vec;

use super::ExtremesError;
use super::at::At;
use crate::mechanism::Mechanism;
use crate::number::Number;
use crate::quantity::Quantity;
use crate::sweep::{Label, Local, NoSuchColumn};

/// A derivative of an input, an unknown or an output.
#[derive(Clone, Copy, Debug)]
pub(super) struct Named {
    kind: Kind,
    index: usize,
    order: usize,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Input,
    Unknown,
    Output,
}

impl Named {
    pub(super) fn find<M: Mechanism>(name: &str) -> Result<Self, ExtremesError> {
        let description = M::DESCRIPTION;
        let all = [
            (Kind::Input, description.inputs),
            (Kind::Unknown, description.unknowns),
            (Kind::Output, description.outputs),
        ];
        let quantities = all
            .into_iter()
            .flat_map(|(kind, quantities): (Kind, &'static [Quantity])| {
                quantities
                    .iter()
                    .enumerate()
                    .map(move |(index, quantity)| (kind, index, *quantity))
            });
        let named: Vec<(Self, Label)> = quantities
            .flat_map(|(kind, index, quantity)| {
                (0..=description.order).map(move |order| (Self { kind, index, order }, Label::new(quantity, order)))
            })
            .collect();
        let found = named.iter().find(|(_, label)| label.is(name));
        found.map(|(named, _)| *named).ok_or_else(|| {
            let labels = named.iter().map(|(_, label)| label);
            ExtremesError::NoSuchColumn(NoSuchColumn::new(name, labels))
        })
    }

    /// Its value at a place.
    pub(super) fn of<M: Mechanism>(self, at: &At<M>) -> Local {
        let value = match self.kind {
            Kind::Input => at.input(self.index, self.order),
            Kind::Unknown => at.unknown(self.index, self.order),
            Kind::Output => at.output(self.index, self.order),
        };
        value.unwrap_or(Local::constant(f64::NAN))
    }
}
