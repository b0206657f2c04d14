//! By how much rounding errors move a position.

use super::sides::{Sides, bordered, whole};
use super::way::{Linear, Point, Way, largest};
use crate::mechanism::Mechanism;
use crate::mechanism::factored_matrix::FactoredMatrix;
use crate::number::Row;

/// How many units of rounding the terms of an equation may be off by, in the solvers and here.
const UNITS: f64 = 4.0;

/// The worst that rounding errors of a single equation may do to what a system of all equations is solved for, in
/// sizes. Not finite if the system is singular.
pub(super) fn rounding<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    point: &Point<M>,
    system: &FactoredMatrix<M>,
) -> M::Unknowns<f64> {
    let terms = way.terms(point);
    let size = |shift: &M::Unknowns<f64>| largest(shift.as_ref().iter().copied());
    let mut worst = M::Unknowns::from_fn(|_| 0.0);
    for (row, terms) in terms.as_ref().iter().enumerate() {
        let error = UNITS * f64::EPSILON * terms;
        let shift = system.solve(&M::Unknowns::from_fn(|other| if other == row { error } else { 0.0 }));
        if size(&shift) > size(&worst) || !size(&shift).is_finite() {
            worst = shift;
        }
    }
    worst
}

/// How far rounding errors may move the unknowns at a point, in sizes. Not finite where the equations are singular.
pub(super) fn blur<M: Mechanism<Scalar = f64>>(way: &Way<M>, point: &Point<M>) -> f64 {
    way.linearise(point).map_or(f64::INFINITY, |linear| {
        largest(rounding(way, point, &whole(&linear)).as_ref().iter().copied())
    })
}

/// Whether rounding errors may take half of the determinant of a block, or more: then a position at which it is zero is
/// as near as can be told.
pub(super) fn is_indistinct<M: Mechanism<Scalar = f64>>(way: &Way<M>, point: &Point<M>) -> bool {
    let Some(linear) = way.linearise(point) else {
        return false;
    };
    let here = Sides::of(&linear);
    if here.has_zero() {
        return true;
    }
    let shift = rounding(way, point, &whole(&linear));
    any_beside(way, point, &shift, None, |linear| Sides::of(linear).shrink_from(&here))
}

/// The same where an unknown is the parameter: then branches cross as near as can be told.
pub(super) fn is_crossed<M: Mechanism<Scalar = f64>>(way: &Way<M>, point: &Point<M>, parameter: usize) -> bool {
    let Some(linear) = way.linearise(point) else {
        return false;
    };
    let system = bordered(&linear, parameter);
    let here = system.orientation();
    if here.sign == 0 {
        return true;
    }
    let shift = rounding(way, point, &system);
    any_beside(way, point, &shift, Some(parameter), |linear| {
        bordered(linear, parameter).orientation().shrinks_from(here)
    })
}

/// Whether something holds for the closure on one side of a point or on the other. Where the domain of a function ends
/// in between, a determinant may be of any size; that is another matter.
fn any_beside<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    point: &Point<M>,
    shift: &M::Unknowns<f64>,
    parameter: Option<usize>,
    holds: impl Fn(&Linear<M>) -> bool,
) -> bool {
    let beside = [1.0, -1.0].map(|sign| {
        let mut moved = *point;
        for (index, shift) in shift.as_ref().iter().enumerate() {
            if parameter == Some(index) {
                moved.travel += sign * shift;
            } else {
                moved.unknowns[index] += sign * shift * way.sizes[index];
            }
        }
        way.linearise(&moved)
    });
    beside.iter().all(Option::is_some) && beside.iter().flatten().any(holds)
}
