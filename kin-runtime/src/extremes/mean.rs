//! Means and root mean squares.

use alloc::vec::Vec;

use super::ExtremesError;
use super::curve::{Curve, Edge, Stretch, StretchEnd};
use super::parts::BESIDE;
use crate::number::{GAUSS, Number};
use crate::sweep::Local;

/// The precision of a mean, relative to the mean size of the quantity.
const PRECISION: f64 = 1e-12;
/// The halvings of a stretch.
const HALVINGS: usize = 12;
/// The number of halvings, and of points of the trapezoid rule, after which the rounding errors of the poses are
/// measured. Where they make the difference of two sums, more points bring nothing.
const MEASURED_HALVINGS: usize = 4;
const MEASURED_POINTS: u32 = 256;
/// A piece of a curve that is shorter than this part of a stretch is next to a kink.
const SHARP: f64 = 1.0 / 1_048_576.0;
/// The ratio of lengths above which one piece is halved more often than the other.
const HALF: f64 = 1.5;
/// The most points of the trapezoid rule.
const MOST_POINTS: u32 = 1 << 15;
/// Points at which rounding errors are measured, as parts of an interval.
const SOME_POINTS: [f64; 4] = [0.13, 0.37, 0.61, 0.89];

/// The variable over which a mean is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// Every moment counts alike.
    Time,
    /// Every part of the way of the first input counts alike, whatever its speed.
    Input,
}

/// A mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mean {
    /// The mean.
    pub value: f64,
    /// The estimate of its error.
    pub error: f64,
    /// The part of the sweep over which it is taken, from 0 to 1: that in which the mechanism closes.
    pub covered: f64,
}

/// Integrals over a part of the sweep: of the quantity with its weight, of its size, and of the weight.
#[derive(Clone, Copy, Default)]
struct Integral {
    value: f64,
    size: f64,
    weight: f64,
}

impl Integral {
    fn plus(self, other: Self, factor: f64) -> Self {
        Self {
            value: self.value + factor * other.value,
            size: self.size + factor * other.size,
            weight: self.weight + factor * other.weight,
        }
    }

    /// The mean size of the quantity to its power.
    fn mean_size(self) -> f64 {
        if self.weight > 0.0 {
            self.size / self.weight
        } else {
            0.0
        }
    }

    /// The mean, unless its error is too large.
    fn mean(self, error: f64, covered: f64) -> Result<Mean, ExtremesError> {
        let value = self.value / self.weight;
        let error = (error + 4.0 * f64::EPSILON * self.size) / self.weight;
        if error.is_nan() || error > PRECISION * self.size / self.weight {
            return Err(ExtremesError::Imprecise { value, error });
        }
        Ok(Mean { value, error, covered })
    }
}

/// Where a curve has kinks and jumps: its pieces become shorter and shorter towards each of them.
struct SharpParameters {
    parameters: Vec<f64>,
    end: f64,
    longest: f64,
    /// The length of the last piece.
    before: f64,
    /// The ends of the shortest pieces, as far as their lengths do not rise again.
    shortest: Option<[f64; 2]>,
}

impl SharpParameters {
    fn of(stretch: &Stretch<'_>) -> Self {
        let [from, end] = stretch.parameters;
        Self {
            parameters: alloc::vec![from],
            end,
            longest: SHARP * (end - from).abs(),
            before: f64::INFINITY,
            shortest: None,
        }
    }

    fn meet(&mut self, [left, right]: [f64; 2]) {
        let length = (right - left).abs();
        if length > HALF * self.before {
            self.parameters.extend(self.shortest.take().into_iter().flatten());
        } else if self.before > HALF * length {
            self.shortest = (length <= self.longest).then_some([left, right]);
        } else if let Some([_, end]) = &mut self.shortest {
            *end = right;
        }
        self.before = length;
    }

    /// The ends of the stretch with the kinks between them.
    fn divided(mut self) -> Vec<f64> {
        self.parameters.extend(self.shortest.into_iter().flatten());
        self.parameters.push(self.end);
        self.parameters.dedup();
        self.parameters
    }
}

impl<'c> Curve<'c> {
    /// The mean of a power of the quantity: 1, or 2 for the mean square.
    pub(super) fn mean(&self, over: Over, power: i32) -> Result<Mean, ExtremesError> {
        let stretches = self.stretches()?;
        // Quadrature steps over change points and poles. The pieces of the curve meet them, and the sweep is divided
        // there.
        let mut divisions = Vec::with_capacity(stretches.len());
        for stretch in &stretches {
            let mut sharp = SharpParameters::of(stretch);
            let [_, end] = self.parts(stretch, false, &mut |_, nodes| {
                sharp.meet(nodes.map(|node| node.parameter));
                Ok(())
            })?;
            divisions.push(sharp.divided());
            if stretch.ends[1] == StretchEnd::Joint && self.quantity.impulse(&end)? != [false; 2] {
                return Err(ExtremesError::Unbounded { at: end.at });
            }
        }
        let is_smooth = stretches.len() == 1 && divisions[0].len() == 2;
        let is_smooth_revolution = self.extent.is_full_revolution && is_smooth && self.is_periodic(&stretches)?;
        if is_smooth_revolution && let Some(mean) = self.over_revolution(&stretches[0], power)? {
            return Ok(mean);
        }
        let covered = self.covered(&stretches);
        let (mut sum, mut error) = (Integral::default(), 0.0);
        for (stretch, parameters) in stretches.iter().zip(&divisions) {
            // first, as it decides whether there is an integral at all
            if let Some(edge) = stretch.edge {
                sum = sum.plus(self.beside_limit(stretch, edge, over, power)?, 1.0);
            }
            let [from, to] = stretch.parameters;
            let whole = self.gauss(stretch, [from, to], over, power)?;
            // where the quantity should be zero, its size elsewhere decides what is rounding
            let scale = whole.size.max(Number::powi(self.size.get(), power) * whole.weight);
            for ends in parameters.windows(2) {
                let ends = [ends[0], ends[1]];
                let whole = if parameters.len() == 2 {
                    whole
                } else {
                    self.gauss(stretch, ends, over, power)?
                };
                let part = self.halved(stretch, ends, whole, scale, over, power, HALVINGS, &mut error)?;
                sum = sum.plus(part, 1.0);
            }
        }
        sum.mean(error, covered)
    }

    /// The part of the sweep that stretches cover.
    fn covered(&self, stretches: &[Stretch<'c>]) -> f64 {
        let length = |stretch: &Stretch<'c>| {
            let [start, end] = stretch.parameters.map(|parameter| stretch.value_of_variable(parameter));
            (end - start).abs()
        };
        let covered: f64 = stretches.iter().map(length).sum();
        let whole = (self.extent.to - self.extent.from).abs();
        // the sum of several lengths may round to more than the whole
        (covered / whole).min(1.0)
    }

    /// The quantity with its weight, for the rate of the variable with respect to the parameter.
    fn integrand(
        &self,
        stretch: &Stretch<'c>,
        parameter: f64,
        over: Over,
        power: i32,
    ) -> Result<Integral, ExtremesError> {
        let node = self.node(stretch, parameter, &stretch.mark)?;
        let value = Number::powi(node.value.real(), power);
        let rate = stretch.variable(parameter).coefficients()[1].abs();
        let weight = rate * self.weight(node.at, over);
        Ok(Integral {
            value: value * weight,
            size: value.abs() * weight,
            weight,
        })
    }

    /// The way of the input, or the time, for a unit of the variable. A constant factor does not matter.
    fn weight(&self, at: f64, over: Over) -> f64 {
        match over {
            Over::Time => 1.0,
            Over::Input => self.way(at),
        }
    }

    fn gauss(
        &self,
        stretch: &Stretch<'c>,
        [from, to]: [f64; 2],
        over: Over,
        power: i32,
    ) -> Result<Integral, ExtremesError> {
        let (middle, half) = (f64::midpoint(from, to), 0.5 * (to - from));
        let mut sum = Integral::default();
        for (node, weight) in GAUSS {
            for parameter in [middle - half * node, middle + half * node] {
                sum = sum.plus(self.integrand(stretch, parameter, over, power)?, weight * half.abs());
            }
        }
        Ok(sum)
    }

    /// The integral by halves, until they agree with the whole.
    #[expect(clippy::too_many_arguments, reason = "a recursion hands everything down")]
    fn halved(
        &self,
        stretch: &Stretch<'c>,
        [from, to]: [f64; 2],
        whole: Integral,
        scale: f64,
        over: Over,
        power: i32,
        halvings: usize,
        error: &mut f64,
    ) -> Result<Integral, ExtremesError> {
        let middle = f64::midpoint(from, to);
        let left = self.gauss(stretch, [from, middle], over, power)?;
        let right = self.gauss(stretch, [middle, to], over, power)?;
        let both = left.plus(right, 1.0);
        let difference = (both.value - whole.value).abs() + (both.weight - whole.weight).abs() * both.mean_size();
        if difference <= 0.01 * PRECISION * scale || halvings == 0 {
            *error += difference;
            return Ok(both);
        }
        if halvings + MEASURED_HALVINGS <= HALVINGS {
            let rounding = both.weight * self.rounding_of_power(stretch, [from, to], to - from, power)?;
            if difference <= rounding {
                *error += difference;
                return Ok(both);
            }
        }
        let left = self.halved(stretch, [from, middle], left, scale, over, power, halvings - 1, error)?;
        let right = self.halved(stretch, [middle, to], right, scale, over, power, halvings - 1, error)?;
        Ok(left.plus(right, 1.0))
    }

    /// The largest rounding error of a power of the quantity at some points of an interval, as points at a part of a
    /// distance from them show it.
    fn rounding_of_power(
        &self,
        stretch: &Stretch<'c>,
        [from, to]: [f64; 2],
        distance: f64,
        power: i32,
    ) -> Result<f64, ExtremesError> {
        let mut largest: f64 = 0.0;
        for part in SOME_POINTS {
            let node = self.node(stretch, from + (to - from) * part, &stretch.mark)?;
            let rounding = self.rounding(stretch, &node, BESIDE * distance)?;
            let value = node.value.real().abs();
            largest = largest.max(Number::powi(value + rounding, power) - Number::powi(value, power));
        }
        Ok(largest)
    }

    /// The part next to a turning point, from the Taylor series at the nearest point.
    fn beside_limit(
        &self,
        stretch: &Stretch<'c>,
        edge: Edge,
        over: Over,
        power: i32,
    ) -> Result<Integral, ExtremesError> {
        if edge.nearest == edge.end.1 {
            // the pieces reach to the end
            return Ok(Integral::default());
        }
        let nearest = self.node(stretch, edge.nearest, &stretch.mark)?;
        // the power of one over the parameter with which the quantity grows
        let growth = if stretch.may_grow() {
            f64::from(power) * num_traits::Float::log2(self.growth(stretch, &nearest)?.max(f64::MIN_POSITIVE))
        } else {
            0.0
        };
        // the variable moves with the square of the parameter
        if growth > 1.5 {
            return Err(ExtremesError::Diverges {
                at: edge.at,
                power: 0.5 * num_traits::Float::round(growth),
            });
        }
        let [_, rate, bend, ..] = stretch.variable(edge.nearest).coefficients();
        let rate = Local::from_coefficients([rate, 2.0 * bend, 0.0, 0.0, 0.0]);
        let weight = rate * Local::constant(num_traits::Float::signum(rate.real()) * self.weight(nearest.at, over));
        let value = Number::powi(nearest.value, power);
        let integral = |integrand: Local| {
            let coefficients = integrand.coefficients();
            let mut order = 0.0;
            let mut reach = 1.0;
            let mut sum = 0.0;
            for coefficient in coefficients {
                order += 1.0;
                reach *= edge.end.1 - edge.nearest;
                sum -= coefficient * reach / order;
            }
            sum
        };
        let mean = integral(value * weight);
        Ok(Integral {
            value: mean,
            size: mean.abs(),
            weight: integral(weight),
        })
    }

    /// The mean over a full revolution by the trapezoid rule, whose error falls faster than any power of the number of
    /// points. (L. N. Trefethen and J. A. C. Weideman, The exponentially convergent trapezoidal rule, SIAM Review 56,
    /// 2014, 385-458.)
    fn over_revolution(&self, stretch: &Stretch<'c>, power: i32) -> Result<Option<Mean>, ExtremesError> {
        let [from, to] = stretch.parameters;
        let mut points = 16_u32;
        let mut sum = Integral::default();
        let mut last = f64::NAN;
        let mut add = |index: u32, points: u32| -> Result<Integral, ExtremesError> {
            let parameter = from + (to - from) * (f64::from(index) / f64::from(points));
            sum = sum.plus(self.integrand(stretch, parameter, Over::Time, power)?, 1.0);
            Ok(sum)
        };
        let mut total = Integral::default();
        for index in 0..points {
            total = add(index, points)?;
        }
        while points < MOST_POINTS {
            let mean = total.value / total.weight;
            let error = (mean - last).abs();
            if error <= 0.1 * PRECISION * total.mean_size() {
                return total.mean(error * total.weight, 1.0).map(Some);
            }
            if points >= MEASURED_POINTS {
                let distance = (to - from) / f64::from(points);
                let rounding = self.rounding_of_power(stretch, [from, to], distance, power)?;
                if error <= rounding {
                    let error = error.max(rounding / num_traits::Float::sqrt(f64::from(points)));
                    return total.mean(error * total.weight, 1.0).map(Some);
                }
            }
            last = mean;
            points *= 2;
            for index in (1..points).step_by(2) {
                total = add(index, points)?;
            }
        }
        Ok(None)
    }
}

/// The root of a mean square.
pub(super) fn rooted(square: Result<Mean, ExtremesError>) -> Result<Mean, ExtremesError> {
    let root = |value: f64, error: f64| {
        let root = num_traits::Float::sqrt(value);
        (root, if root > 0.0 { 0.5 * error / root } else { 0.0 })
    };
    match square {
        Ok(square) => {
            let (value, error) = root(square.value, square.error);
            Ok(Mean {
                value,
                error,
                covered: square.covered,
            })
        }
        Err(ExtremesError::Imprecise { value, error }) => {
            let (value, error) = root(value, error);
            Err(ExtremesError::Imprecise { value, error })
        }
        Err(error) => Err(error),
    }
}
