//! The line along which the inputs move, and the closure on it.

use super::SHORTEST;
use crate::mechanism::{Mechanism, Sizes};
use crate::number::{Row, at_constant_rate, series::Series};
use crate::quantity::Dimension;

/// A value with its first and second derivative, as coefficients of a series.
type Second = Series<3>;

/// A point on the curve of solutions over the line of inputs.
#[derive(Clone, Copy)]
pub(super) struct WayPoint<M: Mechanism> {
    /// The unknowns in their own units.
    pub(super) unknowns: M::Unknowns<f64>,
    /// The distance that the inputs have covered.
    pub(super) travel: f64,
}

/// The line of inputs from one place to another, for a mechanism in double precision.
///
/// Unknowns are measured in their natural sizes: 1 for an angle, the longest link for a length. The travel of the
/// inputs is the largest of their distances, in units of their sizes, so rates with respect to the travel are usually
/// about 1.
pub(super) struct Way<M: Mechanism<Scalar = f64>> {
    pub(super) mechanism: M,
    series: M::With<Second>,
    from: M::Inputs<f64>,
    to: M::Inputs<f64>,
    /// The whole travel.
    pub(super) length: f64,
    /// The sizes of the unknowns at the start.
    pub(super) sizes: M::Unknowns<f64>,
}

/// The closure to first order at a point, one row for each equation, in sizes of the unknowns.
#[derive(Clone, Copy)]
pub(super) struct Linear<M: Mechanism> {
    pub(super) jacobian: M::Unknowns<M::Unknowns<f64>>,
    /// The derivatives with respect to the travel of the inputs.
    pub(super) travel: M::Unknowns<f64>,
    pub(super) residuals: M::Unknowns<f64>,
}

impl<M: Mechanism<Scalar = f64>> Way<M> {
    pub(super) fn new(mechanism: M, from: M::Inputs<f64>, near: &M::Unknowns<f64>, to: M::Inputs<f64>) -> Self {
        let description = M::DESCRIPTION;
        let own = Sizes::of(&mechanism);
        let sizes = M::Unknowns::from_fn(|index| own.size(description.unknowns[index].dimension, near[index]));
        let ends = from.as_ref().iter().zip(to.as_ref());
        let length = ends
            .zip(description.inputs)
            .fold(0.0, |length: f64, ((from, to), quantity)| {
                let travel = (to - from).abs() / own.size(quantity.dimension, from.abs().max(to.abs()));
                if travel <= length { length } else { travel }
            });
        Self {
            mechanism,
            series: mechanism.convert(|parameter| Second::from_coefficients([parameter, 0.0, 0.0])),
            from,
            to,
            length,
            sizes,
        }
    }

    /// The number of unknowns, which is also the number of equations.
    pub(super) const COUNT: usize = <M::Unknowns<f64> as Row<f64>>::LENGTH;

    /// The sizes of the unknowns at a point. A length or a number may have grown.
    pub(super) fn sizes_at(&self, point: &WayPoint<M>) -> M::Unknowns<f64> {
        M::Unknowns::from_fn(|index| {
            let size = self.sizes[index];
            match M::DESCRIPTION.unknowns[index].dimension {
                Dimension::Angle => size,
                Dimension::Length | Dimension::Scalar => size.max(point.unknowns[index].abs()),
            }
        })
    }

    /// The shortest step of the inputs.
    pub(super) fn shortest(&self) -> f64 {
        SHORTEST * self.length.max(1.0)
    }

    /// Whether two travels round to the same inputs.
    pub(super) fn are_same(&self, one: f64, other: f64) -> bool {
        let [one, other] = [one, other].map(|travel| self.inputs(travel));
        one.as_ref() == other.as_ref()
    }

    /// The inputs after a given travel.
    pub(super) fn inputs(&self, travel: f64) -> M::Inputs<f64> {
        if travel == self.length {
            return self.to;
        }
        M::Inputs::from_fn(|index| self.from[index] + self.slope(index) * travel)
    }

    /// The inputs after a given travel, with their rates with respect to the travel.
    pub(super) fn motions(&self, travel: f64) -> M::Inputs<M::Motion<f64>> {
        let values = self.inputs(travel);
        Row::from_fn(|index| at_constant_rate(values[index], self.slope(index)))
    }

    fn slope(&self, index: usize) -> f64 {
        (self.to[index] - self.from[index]) / self.length
    }

    /// The residuals as series, where unknowns and travel are polynomials of first degree.
    fn residuals(
        &self,
        point: &WayPoint<M>,
        rate: impl Fn(usize) -> f64,
        travel_rate: f64,
    ) -> <M::With<Second> as Mechanism>::Residuals<Second> {
        let values = self.inputs(point.travel);
        self.series.residuals(
            Row::from_fn(|index| Second::from_coefficients([values[index], self.slope(index) * travel_rate, 0.0])),
            Row::from_fn(|index| {
                let rate = rate(index) * self.sizes[index];
                Second::from_coefficients([point.unknowns[index], rate, 0.0])
            }),
        )
    }

    /// The size of the terms of each equation: the largest shift of the equation that a relative error of one in every
    /// quantity causes.
    ///
    /// Terms that cancel count in full, for example those of a long crank in a loop of short links.
    pub(super) fn terms(&self, point: &WayPoint<M>) -> M::Unknowns<f64> {
        let parameters = self.mechanism.parameters();
        let inputs = self.inputs(point.travel);
        let all = [parameters.as_ref(), inputs.as_ref(), point.unknowns.as_ref()];
        let mut terms = M::Unknowns::splat(0.0);
        for group in 0..all.len() {
            for moved in 0..all[group].len() {
                let quantity = |of: usize, index: usize| {
                    let value = all[of][index];
                    let rate = if (of, index) == (group, moved) { value } else { 0.0 };
                    Second::from_coefficients([value, rate, 0.0])
                };
                let shifts = M::With::from_parameters(Row::from_fn(|index| quantity(0, index))).residuals(
                    Row::from_fn(|index| quantity(1, index)),
                    Row::from_fn(|index| quantity(2, index)),
                );
                for (sum, shift) in terms.as_mut().iter_mut().zip(shifts.as_ref()) {
                    *sum += shift.coefficients()[1].abs();
                }
            }
        }
        terms
    }

    /// The closure near a point; `None` if it is not finite there.
    pub(super) fn linearise(&self, point: &WayPoint<M>) -> Option<Linear<M>> {
        let along = self.residuals(point, |_| 0.0, 1.0);
        let of = |row: usize, order: usize| along[row].coefficients()[order];
        let mut linear: Linear<M> = Linear {
            jacobian: M::Unknowns::splat(M::Unknowns::splat(0.0)),
            travel: M::Unknowns::from_fn(|row| of(row, 1)),
            residuals: M::Unknowns::from_fn(|row| of(row, 0)),
        };
        for column in 0..Self::COUNT {
            let changed = self.residuals(point, |index| if index == column { 1.0 } else { 0.0 }, 0.0);
            let rows: &mut [M::Unknowns<f64>] = linear.jacobian.as_mut();
            for (row, residual) in rows.iter_mut().zip(changed.as_ref()) {
                row[column] = residual.coefficients()[1];
            }
        }
        let all = linear.jacobian.as_ref().iter().flat_map(AsRef::as_ref);
        let mut all = all.chain(linear.travel.as_ref()).chain(linear.residuals.as_ref());
        all.all(|entry| entry.is_finite()).then_some(linear)
    }

    /// The second-order coefficients of the residuals along a straight line through the point.
    pub(super) fn bend(&self, point: &WayPoint<M>, rates: &M::Unknowns<f64>, travel_rate: f64) -> M::Unknowns<f64> {
        let series = self.residuals(point, |index| rates[index], travel_rate);
        M::Unknowns::from_fn(|row| series[row].coefficients()[2])
    }
}

/// The largest magnitude in a row, or NaN if an entry is NaN.
pub(super) fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest: f64, value| {
        let size = value.abs();
        if size <= largest || largest.is_nan() {
            largest
        } else {
            size
        }
    })
}
