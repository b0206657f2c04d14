//! The unit of length in which a cycle is sought.
//!
//! Links of 10⁻⁶⁰ and of 10⁶⁰ have the same cycle. So the search takes a power of two as its unit, in which the largest
//! length lies between a half and one: every bound and every tolerance then has one size, no square leaves the range of
//! the numbers, and no digit changes.

use core::iter;

use num_traits::Float;

use super::line::{count, distance};
use crate::mechanism::Mechanism;
use crate::number::Row;
use crate::quantity::{Dimension, Quantity};

/// The factor by which a mechanism is enlarged to see whether its closure has a unit of length: a power of two, so that
/// nothing is rounded.
const ENLARGED: f64 = 8.0;
/// The powers of a length that a row of the closure may have as its dimension.
const POWERS: core::ops::RangeInclusive<i32> = -4..=4;
/// The largest difference of a row from what its dimension says.
const AGREEMENT: f64 = 1e-12;
/// The factor by which a mechanism is enlarged and reduced to see whether the declared ranges of its lengths have an
/// end besides zero.
const FAR: f64 = 1_099_511_627_776.0;
/// The number of places at which it is tested.
const PLACES: u32 = 16;

/// The factor by which lengths are multiplied for the search.
#[derive(Clone, Copy)]
pub(super) struct LengthUnit(f64);

impl LengthUnit {
    /// The unit of a mechanism: that of its declaration if numbers stand for lengths there, so that it cannot be
    /// enlarged.
    pub(super) fn of<M: Mechanism<Scalar = f64>>(mechanism: &M, from: M::Inputs<f64>) -> Self {
        let description = M::DESCRIPTION;
        let lengths = |quantities: &'static [Quantity], values: &[f64]| {
            let named = quantities.iter().zip(values);
            named
                .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
                .fold(0.0, |largest: f64, (_, value)| largest.max(value.abs()))
        };
        let links = lengths(description.parameters, mechanism.parameters().as_ref());
        let largest = if links > 0.0 {
            links
        } else {
            lengths(description.inputs, from.as_ref())
        };
        if largest == 0.0 {
            return Self(1.0);
        }
        let unit = Self(reciprocal_power(largest));
        if is_homogeneous(&unit.mechanism(mechanism)) {
            unit
        } else {
            Self(1.0)
        }
    }

    fn row<R: Row<f64>>(self, quantities: &[Quantity], values: R) -> R {
        R::from_fn(|index| match quantities[index].dimension {
            Dimension::Length => values[index] * self.0,
            _ => values[index],
        })
    }

    /// The mechanism of the search.
    pub(super) fn mechanism<M: Mechanism<Scalar = f64>>(self, mechanism: &M) -> M {
        M::from_parameters(self.row(M::DESCRIPTION.parameters, mechanism.parameters()))
    }

    /// Inputs, or their rates, of the search.
    pub(super) fn inputs<M: Mechanism<Scalar = f64>>(self, inputs: M::Inputs<f64>) -> M::Inputs<f64> {
        self.row(M::DESCRIPTION.inputs, inputs)
    }

    /// Unknowns of the search.
    fn unknowns<M: Mechanism<Scalar = f64>>(self, unknowns: M::Unknowns<f64>) -> M::Unknowns<f64> {
        self.row(M::DESCRIPTION.unknowns, unknowns)
    }

    /// Unknowns in the mechanism's own unit.
    pub(super) fn told<M: Mechanism<Scalar = f64>>(self, unknowns: M::Unknowns<f64>) -> M::Unknowns<f64> {
        Self(1.0 / self.0).unknowns::<M>(unknowns)
    }
}

/// The power of two by which a number becomes at least a half and less than one; less than that at the ends of the
/// range of numbers.
fn reciprocal_power(value: f64) -> f64 {
    const MOST: i32 = 1000;
    let (_, exponent, _) = value.integer_decode();
    // The mantissa has 53 digits.
    let power = -(i32::from(exponent) + 53);
    Float::powi(2.0, power.clamp(-MOST, MOST))
}

/// Whether each row of the closure is multiplied by a power of a factor by which all lengths are multiplied, and no
/// declared range of a length has an end besides zero.
fn is_homogeneous<M: Mechanism<Scalar = f64>>(mechanism: &M) -> bool {
    let factor = LengthUnit(ENLARGED);
    let enlarged = factor.mechanism(mechanism);
    let mut fits: M::Residuals<u16> = Row::splat(u16::MAX);
    for seed in 0..3 {
        let mixed = |index: usize| Float::sin((f64::from(seed) + 0.5) * (count(index) + 1.7) * 12.9898);
        let inputs: M::Inputs<f64> = Row::from_fn(|index| mixed(index + 11));
        let unknowns: M::Unknowns<f64> = Row::from_fn(mixed);
        let own = mechanism.residuals(inputs, unknowns);
        let other = enlarged.residuals(factor.inputs::<M>(inputs), factor.unknowns::<M>(unknowns));
        for (fits, (own, other)) in fits.as_mut().iter_mut().zip(own.as_ref().iter().zip(other.as_ref())) {
            for (bit, power) in POWERS.enumerate() {
                let expected = own * Float::powi(ENLARGED, power);
                if (other - expected).abs() > AGREEMENT * expected.abs() {
                    *fits &= !(1 << bit);
                }
            }
        }
    }
    let some = (1 << POWERS.count()) - 1;
    fits.as_ref().iter().all(|fits| fits & some != 0) && ranges_have_no_end(mechanism)
}

/// Whether the same positions lie in the declared ranges of lengths for a mechanism that is much larger, and much
/// smaller.
fn ranges_have_no_end<M: Mechanism<Scalar = f64>>(mechanism: &M) -> bool {
    let mut lengths = M::DESCRIPTION
        .unknowns
        .iter()
        .filter(|unknown| unknown.dimension == Dimension::Length);
    if !lengths.any(|unknown| unknown.has_range) {
        return true;
    }
    let units = [LengthUnit(FAR), LengthUnit(1.0 / FAR)];
    let mechanisms = units.map(|unit| unit.mechanism(mechanism));
    let mut closes = false;
    let places = (0..PLACES).map(|place| f64::from(place) * core::f64::consts::TAU / f64::from(PLACES) + 0.1);
    let agrees = places
        .flat_map(|place| M::assemblies().zip(iter::repeat(place)))
        .all(|(assembly, place)| {
            let inputs: M::Inputs<f64> = Row::splat(place);
            let [large, small] = [0, 1].map(|which| {
                let solved = mechanisms[which].solve_position(units[which].inputs::<M>(inputs), assembly);
                solved.ok().map(|unknowns| units[which].told::<M>(unknowns))
            });
            match (large, small) {
                (Some(one), Some(other)) => {
                    closes = true;
                    distance::<M>(1.0, &one, &other) < AGREEMENT.sqrt()
                }
                (None, None) => true,
                _ => false,
            }
        });
    agrees && closes
}
