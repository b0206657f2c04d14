//! The effect of rounding errors on a position.

use super::sides::{Sides, bordered, whole};
use super::way::{Linear, Way, WayPoint, largest};
use crate::mechanism::Mechanism;
use crate::mechanism::factored_matrix::FactoredMatrix;
use crate::number::Row;

/// The error of the terms of an equation, in units of ε, in the solvers and here.
const UNITS: f64 = 4.0;

/// The largest effect of rounding errors in a single equation on the solution of a system of all equations, in units of
/// the sizes. It is not finite if the system is singular.
pub(super) fn rounding<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    point: &WayPoint<M>,
    system: &FactoredMatrix<M>,
) -> M::Unknowns<f64> {
    let terms = way.terms(point);
    let size = |shift: &M::Unknowns<f64>| largest(shift.as_ref().iter().copied());
    let mut worst = M::Unknowns::splat(0.0);
    for (row, terms) in terms.as_ref().iter().enumerate() {
        let error = UNITS * f64::EPSILON * terms;
        let shift = system.solve(&M::Unknowns::from_fn(|other| if other == row { error } else { 0.0 }));
        if size(&shift) > size(&worst) || !size(&shift).is_finite() {
            worst = shift;
        }
    }
    worst
}

/// The largest effect of rounding errors on the unknowns at a point, in units of their sizes. It is not finite if the
/// equations are singular.
pub(super) fn blur<M: Mechanism<Scalar = f64>>(way: &Way<M>, point: &WayPoint<M>) -> f64 {
    way.linearise(point).map_or(f64::INFINITY, |linear| {
        largest(rounding(way, point, &whole(&linear)).as_ref().iter().copied())
    })
}

/// Whether rounding errors may change the determinant of a block by half or more. A position where it is zero is then
/// too close to be ruled out.
pub(super) fn is_indistinct<M: Mechanism<Scalar = f64>>(way: &Way<M>, point: &WayPoint<M>) -> bool {
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

/// [`is_indistinct`] with an unknown as the parameter. If it holds, a crossing of branches is too close to be ruled
/// out.
pub(super) fn is_crossed<M: Mechanism<Scalar = f64>>(way: &Way<M>, point: &WayPoint<M>, parameter: usize) -> bool {
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

/// Whether a condition holds for the closure on one side of a point or on the other. If the domain of a function ends
/// in between, a determinant may have any size; other code handles that.
fn any_beside<M: Mechanism<Scalar = f64>>(
    way: &Way<M>,
    point: &WayPoint<M>,
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
