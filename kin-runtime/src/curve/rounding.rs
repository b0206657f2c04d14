//! The effect of rounding errors on a position.

use super::lent_rows::LentRows;
use super::local::{bordered, whole};
use super::sides::Sides;
use super::way::{Linear, Way, WayPoint, largest};
use crate::solve::LentFactors;

/// The error of the terms of an equation, in units of ε, in the solvers and here.
const UNITS: f64 = 4.0;

/// The largest effect of rounding errors in a single equation on the solution of a system of all equations, in units of
/// the sizes. It is not finite if the system is singular.
pub(crate) fn rounding<'s>(
    way: &Way<'_>,
    point: WayPoint<'_>,
    system: &LentFactors<'_>,
    scratch: &mut LentRows<'s>,
) -> &'s [f64] {
    let worst = scratch.filled(way.count(), |_| 0.0);
    let mut scope = scratch.scope();
    let terms = way.terms(point, &mut scope);
    let (right, shift) = (scope.filled(way.count(), |_| 0.0), scope.lend(way.count()));
    let size = |shift: &[f64]| largest(shift.iter().copied());
    for (row, terms) in terms.iter().enumerate() {
        right[row] = UNITS * f64::EPSILON * terms;
        system.solve(right, shift);
        right[row] = 0.0;
        if size(shift) > size(worst) || !size(shift).is_finite() {
            worst.copy_from_slice(shift);
        }
    }
    worst
}

/// The largest effect of rounding errors on the unknowns at a point, in units of their sizes. It is not finite if the
/// equations are singular.
pub(crate) fn blur(way: &Way<'_>, point: WayPoint<'_>, scratch: &mut LentRows<'_>) -> f64 {
    let mut scope = scratch.scope();
    way.linearise(point, &mut scope).map_or(f64::INFINITY, |linear| {
        let system = whole(&linear, &mut scope);
        largest(rounding(way, point, &system, &mut scope).iter().copied())
    })
}

/// Whether rounding errors may change the determinant of a block by half or more. A position where it is zero is then
/// too close to be ruled out.
pub(crate) fn is_indistinct(way: &Way<'_>, point: WayPoint<'_>, scratch: &mut LentRows<'_>) -> bool {
    let mut scope = scratch.scope();
    let Some(linear) = way.linearise(point, &mut scope) else {
        return false;
    };
    let here = Sides::of(way, &linear, &mut scope);
    if here.has_zero() {
        return true;
    }
    let system = whole(&linear, &mut scope);
    let shift = rounding(way, point, &system, &mut scope);
    any_beside(way, point, shift, None, &mut scope, |linear, scratch| {
        Sides::of(way, linear, scratch).shrink_from(&here)
    })
}

/// [`is_indistinct`] with an unknown as the parameter. If it holds, a crossing of branches is too close to be ruled
/// out.
pub(crate) fn is_crossed(way: &Way<'_>, point: WayPoint<'_>, parameter: usize, scratch: &mut LentRows<'_>) -> bool {
    let mut scope = scratch.scope();
    let Some(linear) = way.linearise(point, &mut scope) else {
        return false;
    };
    let system = bordered(&linear, parameter, &mut scope);
    let here = system.orientation();
    if here.sign == 0.0 {
        return true;
    }
    let shift = rounding(way, point, &system, &mut scope);
    any_beside(way, point, shift, Some(parameter), &mut scope, |linear, scratch| {
        bordered(linear, parameter, scratch).orientation().shrinks_from(here)
    })
}

/// Whether a condition holds for the closure on one side of a point or on the other. If the domain of a function ends
/// in between, a determinant may have any size; other code handles that.
fn any_beside(
    way: &Way<'_>,
    point: WayPoint<'_>,
    shift: &[f64],
    parameter: Option<usize>,
    scratch: &mut LentRows<'_>,
    holds: impl Fn(&Linear<'_>, &mut LentRows<'_>) -> bool,
) -> bool {
    let mut any = false;
    for sign in [1.0, -1.0] {
        let mut scope = scratch.scope();
        let mut travel = point.travel;
        if let Some(parameter) = parameter {
            travel += sign * shift[parameter];
        }
        let unknowns = scope.row(way.count(), |index| {
            if parameter == Some(index) {
                point.unknowns[index]
            } else {
                point.unknowns[index] + sign * shift[index] * way.sizes[index]
            }
        });
        let Some(linear) = way.linearise(WayPoint { unknowns, travel }, &mut scope) else {
            return false;
        };
        any |= holds(&linear, &mut scope);
    }
    any
}
