//! The curve near one of its points, with one of its coordinates as the parameter.
//!
//! The coordinates are the unknowns and the travel of the inputs. The one that moves fastest is the parameter, and the
//! others are unknown. With this parameter the curve is as smooth at a limit position as anywhere, and a limit position
//! is a simple zero of the travel's rate. (Local parametrisation: W. C. Rheinboldt and J. V. Burkardt, A locally
//! parameterized continuation process, ACM Transactions on Mathematical Software 9, 1983, 215-235.)
//!
//! A coordinate is called by its index: that of an unknown, or the number of unknowns for the travel. Rates and
//! corrections are in sizes.

use super::lent_rows::LentRows;
use super::rounding::rounding;
use super::way::{Linear, Way, WayPoint, largest};
use crate::any::ClosureOver;
use crate::number::series::Series;
use crate::solve::{LentFactors, lent_factors_length};

/// The largest number of corrections. They converge quadratically.
const CORRECTIONS: usize = 64;
/// The size below which a correction that does not fall is rounding.
const NOISE: f64 = 1e-7;
/// The largest distance from the curve that rounding may excuse.
const MOST_BLUR: f64 = 0.01;

/// The matrix of all equations for all coordinates but the parameter. The travel has the column of the parameter.
pub(crate) fn bordered<'s>(linear: &Linear<'_>, parameter: usize, scratch: &mut LentRows<'s>) -> LentFactors<'s> {
    let count = linear.travel.len();
    let memory = scratch.lend(lent_factors_length(count));
    LentFactors::new(memory, count, |row, column| {
        linear.entry(row, if column == parameter { count } else { column })
    })
}

/// The matrix of all equations for all unknowns.
pub(crate) fn whole<'s>(linear: &Linear<'_>, scratch: &mut LentRows<'s>) -> LentFactors<'s> {
    bordered(linear, linear.travel.len(), scratch)
}

/// The index of the largest rate, the first of several.
pub(crate) fn fastest(rates: &[f64]) -> usize {
    let rates = rates.iter().enumerate();
    let best = rates.fold(
        (0, 0.0),
        |best: (usize, f64), (index, rate)| {
            if rate.abs() > best.1 { (index, rate.abs()) } else { best }
        },
    );
    best.0
}

/// The rates of all coordinates with respect to the parameter.
pub(crate) fn rates<'s>(
    linear: &Linear<'_>,
    parameter: usize,
    system: &LentFactors<'_>,
    scratch: &mut LentRows<'s>,
) -> &'s mut [f64] {
    let count = linear.travel.len();
    let rates = scratch.lend(count + 1);
    let right = scratch.scope().row(count, |row| -linear.entry(row, parameter));
    system.solve(right, &mut rates[..count]);
    rates[count] = 1.0;
    rates.swap(parameter, count);
    rates
}

/// The Taylor series of the curve at a point, in all orders of the number: those of the unknowns in their units, which
/// it writes, and that of the travel, which it returns.
///
/// `series` is memory for parameters, inputs, unknowns and residuals, in which the parameters stand.
pub(crate) fn expanded<const N: usize>(
    way: &Way<'_>,
    (functions, series): (&dyn ClosureOver<Series<N>>, &mut [Series<N>]),
    point: WayPoint<'_>,
    (linear, parameter, system): (&Linear<'_>, usize, &LentFactors<'_>),
    scratch: &mut LentRows<'_>,
) -> Series<N> {
    let count = way.count();
    let mut scope = scratch.scope();
    let rates = rates(linear, parameter, system, &mut scope);
    let (right, solution) = (scope.lend(count), scope.lend(count + 1));
    let coefficients = |value: f64, rate: f64| {
        let mut coefficients = [0.0; N];
        (coefficients[0], coefficients[1]) = (value, rate);
        Series::from_coefficients(coefficients)
    };
    let mut travel = coefficients(point.travel, rates[count]);
    for (index, unknown) in way.unknowns(series).iter_mut().enumerate() {
        *unknown = coefficients(point.unknowns[index], rates[index] * way.sizes[index]);
    }
    for order in 2..N {
        let residuals = way.residuals(functions, series, travel);
        for (right, residual) in right.iter_mut().zip(residuals) {
            *right = -residual.coefficients()[order];
        }
        system.solve(right, &mut solution[..count]);
        // the parameter is straight
        solution[count] = 0.0;
        solution.swap(parameter, count);
        let with = |series: Series<N>, coefficient: f64| {
            let mut coefficients = series.coefficients();
            coefficients[order] = coefficient;
            Series::from_coefficients(coefficients)
        };
        travel = with(travel, solution[count]);
        for (index, unknown) in way.unknowns(series).iter_mut().enumerate() {
            *unknown = with(*unknown, solution[index] * way.sizes[index]);
        }
    }
    travel
}

/// The point of the curve with the same value of the parameter, by Newton's method.
pub(crate) fn corrected<'s>(
    way: &Way<'_>,
    start: WayPoint<'_>,
    parameter: usize,
    scratch: &mut LentRows<'s>,
) -> Option<WayPoint<'s>> {
    let unknowns = scratch.filled(way.count(), |index| start.unknowns[index]);
    let mut travel = start.travel;
    let mut previous = f64::INFINITY;
    for _ in 0..CORRECTIONS {
        let mut scope = scratch.scope();
        let point = WayPoint { unknowns, travel };
        let linear = way.linearise(point, &mut scope)?;
        let system = bordered(&linear, parameter, &mut scope);
        let correction = scope.lend(way.count());
        system.solve(linear.residuals, correction);
        let length = largest(correction.iter().copied());
        let stalls = length >= 0.5 * previous;
        if !length.is_finite() || (stalls && length > NOISE && length > local_blur(way, point, &system, &mut scope)) {
            return None;
        }
        for (index, change) in correction.iter().enumerate() {
            if index == parameter {
                travel -= change;
            } else {
                unknowns[index] -= change * way.sizes[index];
            }
        }
        if length <= f64::EPSILON || stalls {
            return Some(WayPoint { unknowns, travel });
        }
        previous = length;
    }
    None
}

/// The distance from the curve that rounding errors may cause. It is zero if it exceeds [`MOST_BLUR`], because it would
/// then excuse any deviation.
pub(crate) fn local_blur(
    way: &Way<'_>,
    point: WayPoint<'_>,
    system: &LentFactors<'_>,
    scratch: &mut LentRows<'_>,
) -> f64 {
    let mut scope = scratch.scope();
    let size = largest(rounding(way, point, system, &mut scope).iter().copied());
    if size <= MOST_BLUR { size } else { 0.0 }
}
