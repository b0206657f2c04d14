//! Many poses at once.

mod given;
mod memory;
mod pieces;
mod poses;

use kin_core::any::AssemblyChoice;
use kin_core::batch::{AnyBatch, Column, ColumnChoice, GivenColumns, Outcome, Slot, Vectors, WantedColumns};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat};

use crate::arguments::{self, Wanted};
use crate::choice::choice;
use crate::declared::Declared;

use given::{Values, broadcast, motion};
use memory::{Memory, own};
use pieces::{Columns, OutcomeColumns, Piece, Scratch, make_angles, on_threads, parts, threads};

pub(crate) use poses::{Batch, restored_batch};

/// What a batch is asked for beside its numbers.
pub(crate) struct Wishes<'a, 'py> {
    pub(crate) assembly: Option<&'a Bound<'py, PyAny>>,
    pub(crate) near: Option<&'a Bound<'py, PyAny>>,
    /// The highest derivative.
    pub(crate) order: Option<usize>,
    pub(crate) threads: Option<usize>,
    /// A batch or arrays whose memory is used.
    pub(crate) out: Option<&'a Bound<'py, PyAny>>,
}

/// Solves a batch. Dimensions are these numbers, or stand among the given arguments.
pub(crate) fn solve<'py>(
    py: Python<'py>,
    declared: &Declared,
    dimensions: Option<&[f64]>,
    given: Option<&Bound<'py, PyDict>>,
    wishes: &Wishes<'_, 'py>,
) -> PyResult<Batch> {
    let description = declared.description();
    let wanted = [
        Wanted {
            kind: "dimension",
            quantities: description.parameters,
        },
        Wanted {
            kind: "input",
            quantities: description.inputs,
        },
    ];
    let wanted = &wanted[usize::from(dimensions.is_some())..];
    let mut values = arguments::values(given, wanted)?;
    let inputs = values.pop().unwrap_or_default();
    let parameters = match dimensions {
        Some(numbers) => numbers
            .iter()
            .map(|number| PyFloat::new(py, *number).into_any())
            .collect(),
        None => values.pop().unwrap_or_default(),
    };
    let choice = choice(declared, wishes.assembly, wishes.near)?;
    let orders = match wishes.order {
        Some(order) if order > description.order => {
            return Err(PyValueError::new_err(format!(
                "{} has derivatives up to order {}",
                description.name, description.order
            )));
        }
        order => order.unwrap_or(description.order) + 1,
    };
    let mut given: Vec<(Bound<'py, PyAny>, String)> = Vec::new();
    for (value, quantity) in parameters.into_iter().zip(description.parameters) {
        let value = arguments::without_unit(&value, quantity, 0)?;
        given.push((value, quantity.name.to_owned()));
    }
    let mut counts = Vec::with_capacity(inputs.len());
    for (value, quantity) in inputs.into_iter().zip(description.inputs) {
        let motion = motion(&value, quantity, declared.orders())?;
        counts.push(motion.len());
        given.extend(motion.into_iter().map(|value| (value, quantity.name.to_owned())));
    }
    let (values, shape) = broadcast(py, &given)?;
    let count: usize = shape.iter().product();
    let columns = values.iter().map(Values::column).collect::<PyResult<Vec<_>>>()?;
    let (parameters, motions) = columns.split_at(description.parameters.len());

    let memory = Memory::new(py, description, orders, shape, wishes.out)?;
    let mut guards = memory.numbers.iter().map(own).collect::<PyResult<Vec<_>>>()?;
    let mut ends = (own(&memory.solved)?, own(&memory.singular)?, own(&memory.margin)?);
    let mut found = Columns {
        groups: &memory.groups,
        orders,
        count,
        numbers: guards
            .iter_mut()
            .map(|guard| guard.as_slice_mut())
            .collect::<Result<_, _>>()?,
    };
    let outcomes = OutcomeColumns {
        solved: ends.0.as_slice_mut()?,
        singular: ends.1.as_slice_mut()?,
        margin: ends.2.as_slice_mut()?,
    };
    let threads = threads(wishes.threads);
    let unknowns = description.unknowns.iter().enumerate();
    let directions = unknowns.filter(|(_, quantity)| quantity.is_direction);
    let directions: Vec<usize> = directions.map(|(index, _)| index).collect();
    let first_failure = py.detach(|| {
        let pieces = found.pieces(outcomes);
        let solve = |scratch: &mut Scratch, piece: Piece<'_>| {
            let length = piece.outcomes.solved.len();
            let range = piece.from..piece.from + length;
            let parameters = parts(parameters, &range);
            let motions = parts(motions, &range);
            let Scratch { outcomes, sines } = scratch;
            outcomes.clear();
            outcomes.resize(length, Outcome::Unsolved);
            sines.clear();
            sines.resize(directions.len() * length, 0.0);
            let mut rest = motions.as_slice();
            let inputs = counts.iter().map(|count| {
                let (motion, others) = rest.split_at(*count);
                rest = others;
                motion
            });
            let inputs: Vec<&[Column<'_>]> = inputs.collect();
            let near: Vec<Column<'_>> = match &choice {
                AssemblyChoice::Near(near) => near.iter().copied().map(Column::Same).collect(),
                AssemblyChoice::Index(_) => Vec::new(),
            };
            let given = GivenColumns {
                parameters: &parameters,
                inputs: &inputs,
                choice: match choice {
                    AssemblyChoice::Index(index) => ColumnChoice::Assembly(index),
                    AssemblyChoice::Near(_) => ColumnChoice::Near(&near),
                },
            };
            let mut wanted = piece.wanted;
            let columns = wanted.iter_mut().map(|(slot, numbers)| (*slot, &mut **numbers));
            let of_sines = directions.iter().zip(sines.chunks_exact_mut(length));
            let of_sines = of_sines.map(|(unknown, sines)| (Slot::Sine(*unknown), sines));
            let all = &mut WantedColumns::new(columns.chain(of_sines).collect());
            let solved = declared.mechanism.solve_batch(given, all, outcomes, Vectors::widest());
            let summary = solved.unwrap_or_else(|_| unreachable!("all columns have the length of the piece"));
            piece.outcomes.write(outcomes, summary.first_failure.is_none());
            for (unknown, sines) in directions.iter().zip(sines.chunks_exact(length)) {
                make_angles(&mut wanted, *unknown, sines);
            }
            summary.first_failure.map(|(index, error)| (piece.from + index, error))
        };
        on_threads(pieces, threads, solve)
    });
    drop(found);
    drop((guards, ends));
    memory.batch(py, declared, first_failure)
}
