//! The line along which the inputs move, and the closure on it.

use core::cell::{RefCell, RefMut};

use super::functions::CurveFunctions;
use super::lent_rows::LentRows;
use crate::any::ClosureOver;
use crate::failure::SolveError;
use crate::mechanism::{Description, First, Lent, Second, Sizes};
use crate::number::{Number, at_constant_rate, series::Series};
use crate::quantity::{Dimension, Name, NameKind};

/// The shortest step along the curve, as a part of the way or of the unit.
pub(crate) const SHORTEST_STEP: f64 = 1e-13;

/// A point on the curve of solutions over the line of inputs.
#[derive(Clone, Copy)]
pub(crate) struct WayPoint<'s> {
    /// The unknowns in their units.
    pub(crate) unknowns: &'s [f64],
    /// The distance that the inputs have covered.
    pub(crate) travel: f64,
}

/// The line of inputs from one point to another, for a mechanism in double precision.
///
/// Unknowns are measured in their natural sizes: 1 for an angle, the longest link for a length. The travel of the
/// inputs is the largest of their distances, in units of their sizes, so rates with respect to the travel are usually
/// about 1.
pub(crate) struct Way<'w> {
    pub(crate) mechanism: &'w dyn CurveFunctions,
    pub(crate) description: &'w Description<'w>,
    parameters: &'w [f64],
    from: &'w [f64],
    to: &'w [f64],
    /// The whole travel.
    pub(crate) length: f64,
    /// The sizes of the unknowns at the start.
    pub(crate) sizes: &'w [f64],
    /// Parameters, inputs, unknowns and residuals as series of first and of second order.
    first: RefCell<&'w mut [First]>,
    second: RefCell<&'w mut [Second]>,
}

/// The closure to first order at a point, one row for each equation, in sizes of the unknowns.
#[derive(Clone, Copy)]
pub(crate) struct Linear<'s> {
    /// The entries row by row.
    jacobian: &'s [f64],
    /// The derivatives with respect to the travel of the inputs.
    pub(crate) travel: &'s [f64],
    pub(crate) residuals: &'s [f64],
}

impl Linear<'_> {
    /// The derivative of an equation with respect to a coordinate: an unknown, or the travel behind all of them.
    pub(crate) fn entry(&self, row: usize, column: usize) -> f64 {
        let count = self.travel.len();
        if column == count {
            self.travel[row]
        } else {
            self.jacobian[row * count + column]
        }
    }
}

impl<'w> Way<'w> {
    /// The line between two points, for unknowns `near` the first one. What the line keeps is taken of the scratch.
    pub(crate) fn new(
        mechanism: &'w dyn CurveFunctions,
        parameters: &'w [f64],
        [from, to]: [&'w [f64]; 2],
        near: &[f64],
        lent: Lent<'w>,
    ) -> (Self, LentRows<'w>) {
        let Lent { numbers, first, second } = lent;
        let mut scratch = LentRows::new(numbers);
        let description = mechanism.description();
        let units = Sizes::of(description, parameters);
        let sizes = scratch.row(near.len(), |index| {
            units.size(description.unknowns[index].dimension, near[index])
        });
        let ends = from.iter().zip(to);
        let length = ends
            .zip(description.inputs)
            .fold(0.0, |length: f64, ((from, to), quantity)| {
                let travel = (to - from).abs() / units.size(quantity.dimension, from.abs().max(to.abs()));
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
        };
        (way, scratch)
    }

    /// The name of a block in errors.
    pub(crate) fn block(&self, block: usize) -> Name {
        self.mechanism.name(NameKind::Block, block)
    }

    /// The number of unknowns, which is also the number of equations.
    pub(crate) const fn count(&self) -> usize {
        self.sizes.len()
    }

    /// The number of derivatives of a motion, the value included.
    pub(crate) const fn orders(&self) -> usize {
        self.description.order + 1
    }

    /// The size of an unknown at a point. A length or a number may have grown.
    pub(crate) fn size_at(&self, unknowns: &[f64], index: usize) -> f64 {
        let size = self.sizes[index];
        match self.description.unknowns[index].dimension {
            Dimension::Angle => size,
            Dimension::Length | Dimension::Scalar => size.max(unknowns[index].abs()),
        }
    }

    /// The shortest step of the inputs.
    pub(crate) fn shortest(&self) -> f64 {
        SHORTEST_STEP * self.length.max(1.0)
    }

    /// Whether two travels round to the same inputs.
    pub(crate) fn are_same(&self, one: f64, other: f64) -> bool {
        (0..self.from.len()).all(|index| self.input(one, index) == self.input(other, index))
    }

    /// An input after a given travel.
    pub(crate) fn input(&self, travel: f64, index: usize) -> f64 {
        if travel == self.length {
            return self.to[index];
        }
        self.from[index] + self.slope(index) * travel
    }

    /// The inputs after a given travel.
    pub(crate) fn inputs<'s>(&self, travel: f64, scratch: &mut LentRows<'s>) -> &'s [f64] {
        scratch.row(self.from.len(), |index| self.input(travel, index))
    }

    /// The position close to given unknowns after a given travel.
    pub(crate) fn position_near<'s>(
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
    pub(crate) fn motions_near<'s>(
        &self,
        travel: f64,
        near: &[f64],
        scratch: &mut LentRows<'s>,
    ) -> Result<&'s [f64], SolveError> {
        let motions = scratch.lend(self.count() * self.orders());
        let orders = self.orders();
        let mut scope = scratch.scope();
        let inputs = scope.row(self.from.len() * orders, |index| match index % orders {
            0 => self.input(travel, index / orders),
            1 => self.slope(index / orders),
            _ => 0.0,
        });
        self.mechanism
            .motion_near(self.parameters, inputs, near, motions, &mut [])?;
        Ok(motions)
    }

    /// Whether a position belongs to an assembly.
    pub(crate) fn assembly_at(&self, point: WayPoint<'_>, scratch: &mut LentRows<'_>) -> Option<usize> {
        let mut scope = scratch.scope();
        let inputs = self.inputs(point.travel, &mut scope);
        self.mechanism.assembly_at(self.parameters, inputs, point.unknowns)
    }

    /// The change of an input for each unit of the travel.
    pub(crate) fn slope(&self, index: usize) -> f64 {
        (self.to[index] - self.from[index]) / self.length
    }

    /// The unknowns in memory for parameters, inputs, unknowns and residuals.
    pub(crate) fn unknowns<'m, T>(&self, series: &'m mut [T]) -> &'m mut [T] {
        let first = self.parameters.len() + self.from.len();
        &mut series[first..first + self.count()]
    }

    /// The residuals as series, in memory for parameters, inputs, unknowns and residuals in which parameters and
    /// unknowns stand.
    pub(crate) fn residuals<'m, const N: usize>(
        &self,
        functions: &dyn ClosureOver<Series<N>>,
        series: &'m mut [Series<N>],
        travel: Series<N>,
    ) -> &'m [Series<N>] {
        let (parameters, rest) = series.split_at_mut(self.parameters.len());
        let (inputs, rest) = rest.split_at_mut(self.from.len());
        let (unknowns, residuals) = rest.split_at_mut(self.count());
        for (index, input) in inputs.iter_mut().enumerate() {
            let slope = self.slope(index);
            let mut coefficients = travel.coefficients().map(|coefficient| slope * coefficient);
            coefficients[0] = self.input(travel.real(), index);
            *input = Series::from_coefficients(coefficients);
        }
        functions.closure(parameters, inputs, unknowns, residuals);
        residuals
    }

    /// The memory of series of second order, in which the parameters stand.
    pub(crate) fn second(&self) -> RefMut<'_, &'w mut [Second]> {
        self.second.borrow_mut()
    }

    /// The size of the terms of each equation: the largest shift of the equation that a relative error of one in every
    /// quantity causes.
    ///
    /// Terms that cancel count in full, for example those of a long crank in a loop of short links.
    pub(crate) fn terms<'s>(&self, point: WayPoint<'_>, scratch: &mut LentRows<'s>) -> &'s [f64] {
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
            self.mechanism.closure(parameters, inputs, unknowns, residuals);
            for (sum, shift) in terms.iter_mut().zip(&*residuals) {
                *sum += shift.coefficients()[1].abs();
            }
            quantities[moved] = still;
        }
        terms
    }

    /// The closure near a point; `None` if it is not finite there.
    pub(crate) fn linearise<'s>(&self, point: WayPoint<'_>, scratch: &mut LentRows<'s>) -> Option<Linear<'s>> {
        let count = self.count();
        let (jacobian, travel, residuals) = (scratch.lend(count * count), scratch.lend(count), scratch.lend(count));
        let mut series = self.first.borrow_mut();
        for (unknown, value) in self.unknowns(&mut series[..]).iter_mut().zip(point.unknowns) {
            *unknown = along(*value, 0.0);
        }
        for (row, residual) in self
            .residuals::<2>(self.mechanism, &mut series[..], along(point.travel, 1.0))
            .iter()
            .enumerate()
        {
            [residuals[row], travel[row]] = residual.coefficients();
        }
        for column in 0..count {
            let value = point.unknowns[column];
            self.unknowns(&mut series[..])[column] = along(value, self.sizes[column]);
            let changes = self.residuals::<2>(self.mechanism, &mut series[..], along(point.travel, 0.0));
            for (row, change) in changes.iter().enumerate() {
                jacobian[row * count + column] = change.coefficients()[1];
            }
            self.unknowns(&mut series[..])[column] = along(value, 0.0);
        }
        let mut all = jacobian.iter().chain(&*travel).chain(&*residuals);
        all.all(|entry| entry.is_finite()).then_some(Linear {
            jacobian,
            travel,
            residuals,
        })
    }
}

/// A quantity that changes at a constant rate.
fn along<const N: usize>(value: f64, rate: f64) -> Series<N> {
    Series::from_coefficients(at_constant_rate(value, rate))
}

/// The largest magnitude in a row, or NaN if an entry is NaN.
pub(crate) fn largest(values: impl Iterator<Item = f64>) -> f64 {
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
pub(crate) fn largest_difference(one: &[f64], other: &[f64], sizes: &[f64]) -> f64 {
    let pairs = one.iter().zip(other).zip(sizes);
    largest(pairs.map(|((one, other), size)| (one - other) / size))
}
