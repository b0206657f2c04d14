//! The function of a mechanism that summarises a revolution for each row.

use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, BooleanArray, Float64Builder, StructArray, new_null_array};
use datafusion::arrow::datatypes::{DataType, Field, Fields};
use datafusion::common::{Result, exec_datafusion_err};
use kin_core::RATES;
use kin_core::batch::{Column, Fold, FoldedNumber, InputGrid, KeptMemory, Slot};

use super::names::plain;
use super::search::{Call, Search, function_of_a_search};
use super::solver::SearchedMechanism;

/// A function such as `four_bar_turn(r1, r2, r3, r4, …)`.
#[derive(Debug)]
pub(crate) struct TurnFunction {
    search: Search,
    /// The numbers that are summarised, each with the fields that it gives.
    numbers: Vec<(FoldedNumber, Summarised)>,
    fields: Fields,
}

/// The fields of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Summarised {
    /// The least value, and where.
    Least,
    /// The least and the greatest value, and their difference.
    Range,
    /// The largest absolute value, and where.
    Peak,
}

impl Summarised {
    /// The number of fields.
    fn fields(self) -> usize {
        match self {
            Self::Least | Self::Peak => 2,
            Self::Range => 3,
        }
    }
}

const TEXT: &str = "A revolution of a mechanism in one row. closed is the share of the poses that close, and rotates \
whether all do; min_transmission is the smallest transmission angle of all dyads, at most a right angle (rad). Each \
unknown and each output q has q_least, q_greatest and their difference q_swing; and the largest absolute values of its \
rates, as in q_peak_velocity. A name that begins with where_ or contains _where_ is the value of the input there.";

impl TurnFunction {
    pub(crate) fn new(mechanism: &SearchedMechanism) -> Self {
        let description = mechanism.description();
        let number = |name: &str| Field::new(name, DataType::Float64, true);
        let mut fields = vec![number("closed"), Field::new("rotates", DataType::Boolean, true)];
        let mut numbers = Vec::new();
        if mechanism.dyad_count() > 0 {
            numbers.push((FoldedNumber::SmallestTransmissionAngle, Summarised::Least));
            fields.extend([number("min_transmission"), number("where_min_transmission")]);
        }
        let unknowns = description.unknowns.iter().enumerate();
        let unknowns = unknowns.map(|(index, quantity)| (quantity, Slot::Unknown as fn(usize, usize) -> Slot, index));
        let outputs = description.outputs.iter().enumerate();
        let outputs = outputs.map(|(index, quantity)| (quantity, Slot::Output as fn(usize, usize) -> Slot, index));
        for (quantity, slot, index) in unknowns.chain(outputs) {
            let name = plain(quantity);
            numbers.push((slot(index, 0).into(), Summarised::Range));
            fields.extend(["least", "greatest", "swing"].map(|word| number(&format!("{name}_{word}"))));
            for (rate, order) in RATES.iter().zip(1..=description.order) {
                numbers.push((slot(index, order).into(), Summarised::Peak));
                fields.extend(["peak", "where_peak"].map(|word| number(&format!("{name}_{word}_{rate}"))));
            }
        }
        Self {
            search: Search::new(mechanism, "turn", Vec::new(), TEXT),
            numbers,
            fields: fields.into(),
        }
    }

    /// The numbers of which a field is used, in their order.
    fn used(&self, call: &Call<'_>) -> Vec<bool> {
        let mut fields = self.fields.iter().skip(self.fields.len() - self.columns());
        let is_used = |field: &Arc<Field>| call.used.as_ref().is_none_or(|used| used.contains(field.name()));
        let of_number = |(_, summarised): &(FoldedNumber, Summarised)| {
            // All fields of the number are taken.
            let used = fields.by_ref().take(summarised.fields()).filter(|field| is_used(field));
            used.count() > 0
        };
        self.numbers.iter().map(of_number).collect()
    }

    /// The number of fields of all numbers.
    fn columns(&self) -> usize {
        self.numbers.iter().map(|(_, summarised)| summarised.fields()).sum()
    }

    fn evaluate(&self, call: &Call<'_>) -> Result<StructArray> {
        let is_used = self.used(call);
        let used = || {
            self.numbers
                .iter()
                .zip(&is_used)
                .filter(|(_, used)| **used)
                .map(|(number, _)| *number)
        };
        let mut folds: Vec<Fold> = used().map(|(number, _)| Fold::of(number)).collect();
        let columns: usize = used().map(|(_, summarised)| summarised.fields()).sum();
        let mut memory = KeptMemory::default();
        let mut closed = Float64Builder::with_capacity(call.rows);
        let mut rotates = Vec::with_capacity(call.rows);
        let mut numbers: Vec<Float64Builder> = (0..columns).map(|_| Float64Builder::with_capacity(call.rows)).collect();
        for row in 0..call.rows {
            let Some(candidate) = call.candidate(row)? else {
                closed.append_null();
                rotates.push(None);
                numbers.iter_mut().for_each(Float64Builder::append_null);
                continue;
            };
            let mechanism = &self.search.mechanism;
            let summary = candidate
                .given(Column::Same(0.0), |given| {
                    mechanism.fold_batch(candidate.grid, given, &mut folds, &mut memory, call.vectors)
                })
                .map_err(|error| exec_datafusion_err!("{}: {error}", self.search.name))?;
            let count = |poses: usize| f64::from(u32::try_from(poses).unwrap_or(u32::MAX));
            closed.append_value(count(summary.solved) / count(candidate.grid.poses));
            rotates.push(Some(summary.failed == 0));
            let mut builders = numbers.iter_mut();
            for (fold, (_, summarised)) in folds.iter().zip(used()) {
                let values = Self::values(fold, summarised, &candidate.grid);
                for (value, builder) in values.into_iter().take(summarised.fields()).zip(&mut builders) {
                    builder.append_option(value);
                }
            }
        }
        let mut arrays: Vec<ArrayRef> = vec![Arc::new(closed.finish()), Arc::new(BooleanArray::from(rotates))];
        let mut numbers = numbers.iter_mut().map(|builder| Arc::new(builder.finish()) as ArrayRef);
        let unused = new_null_array(&DataType::Float64, call.rows);
        for ((_, summarised), used) in self.numbers.iter().zip(is_used) {
            let fields = 0..summarised.fields();
            if used {
                arrays.extend(fields.zip(&mut numbers).map(|(_, array)| array));
            } else {
                arrays.extend(fields.map(|_| Arc::clone(&unused)));
            }
        }
        let arrays = StructArray::try_new_with_length(self.fields.clone(), arrays, call.valid.clone(), call.rows)?;
        Ok(arrays)
    }

    /// The fields of a number, as many as it has.
    fn values(fold: &Fold, summarised: Summarised, grid: &InputGrid) -> [Option<f64>; 3] {
        let folded = fold.folded();
        let found = |found: Option<(usize, f64)>| (found.map(|found| found.1), found.map(|found| grid.value(found.0)));
        match summarised {
            Summarised::Least => {
                let (least, at) = found(folded.least);
                [least, at, None]
            }
            Summarised::Range => [
                folded.least.map(|found| found.1),
                folded.greatest.map(|found| found.1),
                folded.range(),
            ],
            Summarised::Peak => {
                let (peak, at) = found(folded.peak());
                [peak.map(f64::abs), at, None]
            }
        }
    }
}

function_of_a_search!(TurnFunction);
