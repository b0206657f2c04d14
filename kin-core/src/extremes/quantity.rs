//! Quantities called by the names of columns.

use alloc::string::ToString;
use alloc::vec::Vec;

use super::ExtremesError;
use super::at::{At, HIGHEST};
use super::station::{NamedFunctions, SweepStation};
use crate::mechanism::{Description, Mechanism};
use crate::number::{Number, Row};
use crate::quantity::Quantity;
use crate::sweep::{Label, Local, NoSuchColumn};

/// The name of the smallest margin of all dyads.
const MARGIN: &str = "margin";

/// A derivative of an input, an unknown or an output, or the margin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Named {
    kind: Kind,
    index: usize,
    pub(super) order: usize,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Input,
    Unknown,
    Output,
    Margin,
}

impl Named {
    pub(super) fn find<M: Mechanism>(name: &str) -> Result<Self, ExtremesError> {
        Self::find_up_to::<M>(name, HIGHEST)
    }

    /// The derivative of this name, up to an order.
    pub(super) fn find_up_to<M: Mechanism>(name: &str, highest: usize) -> Result<Self, ExtremesError> {
        let has_dyads = <M::Dyads<f64> as Row<f64>>::LENGTH > 0;
        Self::among(&M::DESCRIPTION, has_dyads, name, highest)
    }

    fn among(description: &Description, has_dyads: bool, name: &str, highest: usize) -> Result<Self, ExtremesError> {
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
                (0..=highest).map(move |order| (Self { kind, index, order }, Label::new(quantity, order)))
            })
            .collect();
        let found = named.iter().find(|(_, label)| label.is(name));
        if let Some((named, _)) = found {
            return Ok(*named);
        }
        if has_dyads && name == MARGIN {
            return Ok(Self {
                kind: Kind::Margin,
                index: 0,
                order: 0,
            });
        }
        let labels = named.iter().map(|(_, label)| label.to_string());
        let margin = has_dyads.then(|| MARGIN.to_string());
        Err(ExtremesError::NoSuchColumn(NoSuchColumn::new(
            name,
            labels.chain(margin),
        )))
    }

    /// Its value in a typed pose, whose mechanism may change with the variable.
    pub(super) fn of<M: Mechanism<Scalar = f64>>(self, at: &At<M>) -> Local {
        let value = match self.kind {
            Kind::Input => at.input(self.index, self.order),
            Kind::Unknown => at.unknown(self.index, self.order),
            Kind::Output => at.output(self.index, self.order),
            Kind::Margin => at.smallest_margin(),
        };
        value.unwrap_or(Local::constant(f64::NAN))
    }
    /// Its value at a place of a sweep, from the position alone.
    pub(super) fn at(self, functions: &dyn NamedFunctions, station: &SweepStation) -> Result<Local, ExtremesError> {
        let value = match self.kind {
            Kind::Input => Ok(station.input(self.index, self.order)),
            Kind::Unknown => station.unknown(functions, self.index, self.order),
            Kind::Output => station.output(functions, self.index, self.order),
            Kind::Margin => station
                .margins(functions)
                .map(|margins| margins.smallest().unwrap_or(Local::constant(f64::NAN))),
        };
        value.map_err(|_| ExtremesError::Gap {
            at: station.variable.real(),
        })
    }
}
