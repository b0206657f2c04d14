//! The line along which the inputs move, and the closure on it.

use core::cell::RefCell;

use super::follow::{SHORTEST, TrackPlace};
use super::lent_rows::LentRows;
use super::tracked::Tracked;
use crate::any::ClosureOver;
use crate::failure::SolveError;
use crate::mechanism::{Description, First, Lent, Second, Sizes};
use crate::number::{at_constant_rate, series::Series};
use crate::quantity::Dimension;

/// A point on the curve of solutions over the line of inputs.
#[derive(Clone, Copy)]
pub(super) struct WayPoint<'s> {
    /// The unknowns in their own units.
    pub(super) unknowns: &'s [f64],
    /// The distance that the inputs have covered.
    pub(super) travel: f64,
}

/// The line of inputs from one place to another, for a mechanism in double precision.
///
/// Unknowns are measured in their natural sizes: 1 for an angle, the longest link for a length. The travel of the
/// inputs is the largest of their distances, in units of their sizes, so rates with respect to the travel are usually
/// about 1.
pub(super) struct Way<'w> {
    pub(super) mechanism: &'w dyn Tracked,
    pub(super) description: &'w Description,
    parameters: &'w [f64],
    from: &'w [f64],
    to: &'w [f64],
    /// The whole travel.
    pub(super) length: f64,
    /// The sizes of the unknowns at the start.
    pub(super) sizes: &'w [f64],
    /// Parameters, inputs, unknowns and residuals as series of first and of second order.
    first: RefCell<&'w mut [First]>,
    second: RefCell<&'w mut [Second]>,
    /// Where the end of the track is told.
    place: RefCell<TrackPlace<'w>>,
}

/// The closure to first order at a point, one row for each equation, in sizes of the unknowns.
#[derive(Clone, Copy)]
pub(super) struct Linear<'s> {
    /// The entries row by row.
    jacobian: &'s [f64],
    /// The derivatives with respect to the travel of the inputs.
    pub(super) travel: &'s [f64],
    pub(super) residuals: &'s [f64],
}

impl Linear<'_> {
    pub(super) fn entry(&self, row: usize, column: usize) -> f64 {
        self.jacobian[row * self.travel.len() + column]
    }
}

impl<'w> Way<'w> {
    /// The line between two places, for unknowns `near` the first one. What the line keeps is taken of the scratch.
    pub(super) fn new(
        mechanism: &'w dyn Tracked,
        parameters: &'w [f64],
        [from, to]: [&'w [f64]; 2],
        near: &[f64],
        lent: Lent<'w>,
        place: TrackPlace<'w>,
    ) -> (Self, LentRows<'w>) {
        let Lent { numbers, first, second } = lent;
        let mut scratch = LentRows::new(numbers);
        let description = mechanism.description();
        let own = Sizes::of(description, parameters);
        let sizes = scratch.row(near.len(), |index| {
            own.size(description.unknowns[index].dimension, near[index])
        });
        let ends = from.iter().zip(to);
        let length = ends
            .zip(description.inputs)
            .fold(0.0, |length: f64, ((from, to), quantity)| {
                let travel = (to - from).abs() / own.size(quantity.dimension, from.abs().max(to.abs()));
                if travel <= length { length } else { travel }
            });
        for (series, parameter) in first.iter_mut().zip(parameters) {
            *series = along(*parameter, 0.0);
        }
        for (series, parameter) in second.iter_mut().zip(parameters) {
            *series = along(*parameter, 0.0);
        }
        let way = Self {
            mechanism,
            description,
            parameters,
            from,
            to,
            length,
            sizes,
            first: RefCell::new(first),
            second: RefCell::new(second),
            place: RefCell::new(place),
        };
        (way, scratch)
    }

    /// The names of the unknowns of a block.
    pub(super) fn block(&self, block: usize) -> &'static str {
        self.description.blocks.get(block).map_or("", |block| block.unknowns)
    }

    /// Tells the place where the track has ended.
    pub(super) fn end_at(&self, point: WayPoint<'_>) {
        for (index, input) in self.place.borrow_mut().inputs.iter_mut().enumerate() {
            *input = self.input(point.travel, index);
        }
        self.arrive(point.unknowns);
    }

    /// An input of the place that was told.
    #[cfg(test)]
    pub(super) fn ended_at(&self, input: usize) -> f64 {
        self.place.borrow().inputs[input]
    }

    /// Tells the unknowns at the end of the track.
    pub(super) fn arrive(&self, unknowns: &[f64]) {
        self.place.borrow_mut().unknowns.copy_from_slice(unknowns);
    }

    /// The number of unknowns, which is also the number of equations.
    pub(super) const fn count(&self) -> usize {
        self.sizes.len()
    }

    /// The number of derivatives of a motion, the value included.
    pub(super) const fn orders(&self) -> usize {
        self.description.order + 1
    }

    /// The size of an unknown at a point. A length or a number may have grown.
    pub(super) fn size_at(&self, unknowns: &[f64], index: usize) -> f64 {
        let size = self.sizes[index];
        match self.description.unknowns[index].dimension {
            Dimension::Angle => size,
            Dimension::Length | Dimension::Scalar => size.max(unknowns[index].abs()),
        }
    }

    /// The shortest step of the inputs.
    pub(super) fn shortest(&self) -> f64 {
        SHORTEST * self.length.max(1.0)
    }

    /// Whether two travels round to the same inputs.
    pub(super) fn are_same(&self, one: f64, other: f64) -> bool {
        (0..self.from.len()).all(|index| self.input(one, index) == self.input(other, index))
    }

    /// An input after a given travel.
    fn input(&self, travel: f64, index: usize) -> f64 {
        if travel == self.length {
            return self.to[index];
        }
        self.from[index] + self.slope(index) * travel
    }

    /// The inputs after a given travel.
    pub(super) fn inputs<'s>(&self, travel: f64, scratch: &mut LentRows<'s>) -> &'s [f64] {
        scratch.row(self.from.len(), |index| self.input(travel, index))
    }

    /// The position close to given unknowns after a given travel.
    pub(super) fn position_near<'s>(
        &self,
        travel: f64,
        near: &[f64],
        scratch: &mut LentRows<'s>,
    ) -> Result<&'s [f64], SolveError> {
        let unknowns = scratch.lend(self.count());
        let inputs = self.inputs(travel, &mut scratch.scope());
        self.mechanism.position_near(self.parameters, inputs, near, unknowns)?;
        Ok(unknowns)
    }

    /// The motions of the unknowns close to given ones after a given travel, with respect to the travel.
    pub(super) fn motions_near<'s>(
        &self,
        travel: f64,
        near: &[f64],
        scratch: &mut LentRows<'s>,
    ) -> Result<&'s [f64], SolveError> {
        let motions = scratch.lend(self.count() * self.orders());
        let orders = self.orders();
        let mut scope = scratch.scope();
        let inputs = scope.row(self.from.len() * orders, |place| match place % orders {
            0 => self.input(travel, place / orders),
            1 => self.slope(place / orders),
            _ => 0.0,
        });
        self.mechanism
            .motion_near(self.parameters, inputs, near, motions, &mut [])?;
        Ok(motions)
    }

    /// Whether a position belongs to an assembly.
    pub(super) fn assembly_at(&self, point: WayPoint<'_>, scratch: &mut LentRows<'_>) -> Option<usize> {
        let mut scope = scratch.scope();
        let inputs = self.inputs(point.travel, &mut scope);
        self.mechanism.assembly_near(self.parameters, inputs, point.unknowns)
    }

    fn slope(&self, index: usize) -> f64 {
        (self.to[index] - self.from[index]) / self.length
    }

    /// Passes on the residuals as series, where unknowns and travel are polynomials of first degree.
    fn residuals<const N: usize>(
        &self,
        mechanism: &dyn ClosureOver<Series<N>>,
        series: &mut [Series<N>],
        point: WayPoint<'_>,
        rate: impl Fn(usize) -> f64,
        travel_rate: f64,
        mut read: impl FnMut(usize, [f64; N]),
    ) {
        let (parameters, rest) = series.split_at_mut(self.parameters.len());
        let (inputs, rest) = rest.split_at_mut(self.from.len());
        let (unknowns, residuals) = rest.split_at_mut(self.count());
        for (index, input) in inputs.iter_mut().enumerate() {
            *input = along(self.input(point.travel, index), self.slope(index) * travel_rate);
        }
        for (index, unknown) in unknowns.iter_mut().enumerate() {
            *unknown = along(point.unknowns[index], rate(index) * self.sizes[index]);
        }
        mechanism.residuals(parameters, inputs, unknowns, residuals);
        for (row, residual) in residuals.iter().enumerate() {
            read(row, residual.coefficients());
        }
    }

    /// The size of the terms of each equation: the largest shift of the equation that a relative error of one in every
    /// quantity causes.
    ///
    /// Terms that cancel count in full, for example those of a long crank in a loop of short links.
    pub(super) fn terms<'s>(&self, point: WayPoint<'_>, scratch: &mut LentRows<'s>) -> &'s [f64] {
        let terms = scratch.filled(self.count(), |_| 0.0);
        let mut series = self.first.borrow_mut();
        let (quantities, residuals) = series.split_at_mut(self.parameters.len() + self.from.len() + self.count());
        let inputs = (0..self.from.len()).map(|index| self.input(point.travel, index));
        let values = self.parameters.iter().copied().chain(inputs);
        let values = values.chain(point.unknowns.iter().copied());
        for (quantity, value) in quantities.iter_mut().zip(values) {
            *quantity = along(value, 0.0);
        }
        for moved in 0..quantities.len() {
            let still = quantities[moved];
            let [value, _] = still.coefficients();
            quantities[moved] = along(value, value);
            let (parameters, rest) = quantities.split_at(self.parameters.len());
            let (inputs, unknowns) = rest.split_at(self.from.len());
            self.mechanism.residuals(parameters, inputs, unknowns, residuals);
            for (sum, shift) in terms.iter_mut().zip(&*residuals) {
                *sum += shift.coefficients()[1].abs();
            }
            quantities[moved] = still;
        }
        terms
    }

    /// The closure near a point; `None` if it is not finite there.
    pub(super) fn linearise<'s>(&self, point: WayPoint<'_>, scratch: &mut LentRows<'s>) -> Option<Linear<'s>> {
        let count = self.count();
        let (jacobian, travel, residuals) = (scratch.lend(count * count), scratch.lend(count), scratch.lend(count));
        let mut series = self.first.borrow_mut();
        let read = |row: usize, [value, rate]: [f64; 2]| (residuals[row], travel[row]) = (value, rate);
        self.residuals::<2>(self.mechanism, &mut series, point, |_| 0.0, 1.0, read);
        for column in 0..count {
            let rate = |index: usize| if index == column { 1.0 } else { 0.0 };
            let read = |row: usize, [_, rate]: [f64; 2]| jacobian[row * count + column] = rate;
            self.residuals::<2>(self.mechanism, &mut series, point, rate, 0.0, read);
        }
        let mut all = jacobian.iter().chain(&*travel).chain(&*residuals);
        all.all(|entry| entry.is_finite()).then_some(Linear {
            jacobian,
            travel,
            residuals,
        })
    }

    /// The second-order coefficients of the residuals along a straight line through the point, with their signs changed.
    pub(super) fn bend<'s>(
        &self,
        point: WayPoint<'_>,
        rates: &[f64],
        travel_rate: f64,
        scratch: &mut LentRows<'s>,
    ) -> &'s [f64] {
        let bend = scratch.lend(self.count());
        let mut series = self.second.borrow_mut();
        let read = |row: usize, [.., second]: [f64; 3]| bend[row] = -second;
        self.residuals::<3>(
            self.mechanism,
            &mut series,
            point,
            |index| rates[index],
            travel_rate,
            read,
        );
        bend
    }
}

/// A quantity that changes at a constant rate.
fn along<const N: usize>(value: f64, rate: f64) -> Series<N> {
    Series::from_coefficients(at_constant_rate(value, rate))
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

/// The largest difference of two rows, in units of sizes.
pub(super) fn largest_difference(one: &[f64], other: &[f64], sizes: &[f64]) -> f64 {
    let pairs = one.iter().zip(other).zip(sizes);
    largest(pairs.map(|((one, other), size)| (one - other) / size))
}
