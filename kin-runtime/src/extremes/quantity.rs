//! Quantities called by the names of columns.

use alloc::string::ToString;
use alloc::vec::Vec;

use super::ExtremesError;
use super::margin::Margins;
use super::sensitivity::ByDimension;
use super::station::{ChangedFunctions, NamedFunctions, ResultIndex, SweepStation};
use crate::any::AnyMechanism;
use crate::number::Number;
use crate::quantity::Quantity;
use crate::sweep::{Label, Local, NoSuchColumn};

/// The name of the smallest margin of all dyads.
const MARGIN: &str = "margin";

/// A derivative of an input, an unknown or an output, or the margin.
#[derive(Clone, Copy, Debug)]
pub struct Named {
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
    /// The derivative of this name, up to an order.
    pub(super) fn find(functions: &dyn AnyMechanism, name: &str, highest: usize) -> Result<Self, ExtremesError> {
        let (description, has_dyads) = (functions.description(), functions.dyad_count() > 0);
        let all = [
            (Kind::Input, description.inputs),
            (Kind::Unknown, description.unknowns),
            (Kind::Output, description.outputs),
        ];
        let quantities = all.into_iter().flat_map(|(kind, quantities): (Kind, &[Quantity<'_>])| {
            quantities
                .iter()
                .enumerate()
                .map(move |(index, quantity)| (kind, index, *quantity))
        });
        let named: Vec<(Self, Label<'_>)> = quantities
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

    /// Another derivative of the same quantity.
    pub(super) fn of_order(self, order: usize) -> Self {
        Self { order, ..self }
    }

    /// Its value at a point of a sweep, from the position alone.
    pub(super) fn at(self, functions: &dyn NamedFunctions, station: &SweepStation<'_>) -> Result<Local, ExtremesError> {
        let value = match (self.result(), self.kind) {
            (Some(result), _) => station.result(functions, result, self.order),
            (None, Kind::Margin) => station.margins(functions).map(|margins| smallest(&margins)),
            (None, _) => Ok(station.input(self.index, self.order)),
        };
        value.map_err(|_| gap(station))
    }

    /// How its value and its slope at a point of a sweep change with a dimension.
    pub(super) fn by_dimension(
        self,
        functions: &dyn ChangedFunctions,
        station: &SweepStation<'_>,
        dimension: usize,
    ) -> Result<ByDimension, ExtremesError> {
        match (self.result(), self.kind) {
            (Some(result), _) => {
                let change = station.change(functions, result, self.order, dimension);
                ByDimension::of_change(station, change.map_err(|_| gap(station))?)
            }
            (None, Kind::Margin) => ByDimension::of_expression(station, dimension, |station, changed| {
                let margins = station.changed_margins(functions, changed);
                margins.map(|margins| smallest(&margins)).map_err(|_| gap(station))
            }),
            // the inputs move as they are driven
            (None, _) => Ok(ByDimension { value: 0.0, slope: 0.0 }),
        }
    }

    fn result(self) -> Option<ResultIndex> {
        match self.kind {
            Kind::Unknown => Some(ResultIndex::Unknown(self.index)),
            Kind::Output => Some(ResultIndex::Output(self.index)),
            Kind::Input | Kind::Margin => None,
        }
    }
}

fn gap(station: &SweepStation<'_>) -> ExtremesError {
    ExtremesError::Gap {
        at: station.variable.real(),
    }
}

fn smallest(margins: &Margins<'_>) -> Local {
    margins.smallest().unwrap_or(Local::constant(f64::NAN))
}
