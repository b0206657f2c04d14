//! All limits of a mechanism over a line of inputs.

use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;

use num_traits::Float;

use super::Incomplete;
use super::line::InputLine;
use super::polynomial::{ClosureQuantity, Quantities};
use super::singular::{Singular, singular_positions};
use super::sought::SoughtMechanism;
use crate::quantity::Dimension;

/// A place at which the Jacobian of a block is singular.
#[derive(Clone, Debug)]
pub(super) struct SingularPlace {
    pub(super) s: f64,
    /// The unknowns on which the block depends.
    pub(super) unknowns: Vec<Singular>,
    /// Whether the closure and det J = 0 have a multiple solution here, as at a change point.
    pub(super) is_multiple: bool,
}

/// All limits over the range of a line, in ascending order, whether or not the blocks close that are solved later.
///
/// # Errors
/// Says if the closure is not algebraic, if an unknown has a declared range, or may grow beyond all bounds, if
/// there are too many paths, or if one of them was lost.
pub(super) fn limits(mechanism: &SoughtMechanism<'_>, line: &InputLine) -> Result<Vec<SingularPlace>, Incomplete> {
    let description = mechanism.description();
    if let Some(unknown) = description.unknowns.iter().find(|unknown| unknown.has_range) {
        return Err(Incomplete::DeclaredRange { unknown: unknown.name });
    }
    let moving = || {
        let all = description.inputs.iter().zip(line.direction.iter()).enumerate();
        all.filter(|(_, (_, rate))| **rate != 0.0)
    };
    let is_angle = moving().all(|(_, (input, _))| input.dimension == Dimension::Angle);
    // A length that moves alone stands for the place on the line, so that its products with cosines are no sums.
    let (from, rate) = match moving().next() {
        Some((index, (_, rate))) if !is_angle && moving().count() == 1 => (line.from[index], *rate),
        _ => (0.0, 1.0),
    };
    let place = |input: f64| (input - from) / rate;
    let kind = |is_angle: bool| {
        if is_angle {
            ClosureQuantity::Angle
        } else {
            ClosureQuantity::Plain
        }
    };
    let unknowns = description.unknowns.iter();
    let kinds = unknowns.map(|unknown| kind(unknown.dimension == Dimension::Angle));
    let quantities = Quantities::new(core::iter::once(kind(is_angle)).chain(kinds).collect());
    let mut closure = |at: &[f64], values: &mut [f64]| {
        let residuals = mechanism.residuals(&line.inputs(place(at[0])), &at[1..]);
        for (value, residual) in values.iter_mut().zip(residuals.iter()) {
            *value = *residual;
        }
    };
    let size = if is_angle {
        mechanism.reach()
    } else {
        let ends = [line.low, line.high].map(|s| (from + rate * s).abs());
        mechanism.reach().max(ends[0]).max(ends[1])
    };
    let found = singular_positions(&quantities, size, description.blocks, &mut closure)?;
    let period = is_angle.then_some(TAU);
    let mut all: Vec<SingularPlace> = found
        .iter()
        .flat_map(|position| {
            let places = places(place(position.input), period, [line.low, line.high]);
            places.into_iter().map(|s| SingularPlace {
                s,
                unknowns: position.unknowns.clone(),
                is_multiple: position.is_multiple,
            })
        })
        .collect();
    all.sort_by(|one, other| one.s.total_cmp(&other.s));
    Ok(all)
}

/// The places of a range that differ from one by whole periods.
fn places(s: f64, period: Option<f64>, [low, high]: [f64; 2]) -> Vec<f64> {
    let Some(period) = period else {
        return if s >= low && s <= high { vec![s] } else { Vec::new() };
    };
    let first = s + period * Float::ceil((low - s) / period);
    core::iter::successors(Some(first), |place| Some(place + period))
        .take_while(|place| *place <= high)
        .collect()
}
