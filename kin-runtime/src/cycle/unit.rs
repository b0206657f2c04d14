//! The unit of length in which a cycle is sought.
//!
//! Links of 10⁻⁶⁰ and of 10⁶⁰ have the same cycle. So the search takes a power of two as its unit, in which the largest
//! length lies between a half and one: every bound and every tolerance then has one size, no square leaves the range of
//! the numbers, and no digit changes.

use alloc::vec;
use core::iter;

use num_traits::Float;

use super::line::count;
use super::sought::SoughtMechanism;
use crate::any::PositionChoice;
use crate::number::NumberRow;
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
const RANGE_TEST: f64 = 1_099_511_627_776.0;
/// The number of inputs at which it is tested.
const TESTED: u32 = 16;

/// The factor by which lengths are multiplied for the search.
#[derive(Clone, Copy)]
pub(super) struct LengthUnit(f64);

impl LengthUnit {
    /// The unit of a mechanism: that of its declaration if numbers stand for lengths there, so that it cannot be
    /// enlarged.
    pub(super) fn of(mechanism: &SoughtMechanism<'_>, from: &[f64]) -> Self {
        let description = mechanism.description();
        let lengths = |quantities: &[Quantity<'_>], values: &[f64]| {
            let named = quantities.iter().zip(values);
            named
                .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
                .fold(0.0, |largest: f64, (_, value)| largest.max(value.abs()))
        };
        let links = lengths(description.parameters, &mechanism.parameters);
        let largest = if links > 0.0 {
            links
        } else {
            lengths(description.inputs, from)
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

    /// Lengths of the search, other quantities as they are.
    pub(super) fn row(self, quantities: &[Quantity<'_>], values: &[f64]) -> NumberRow {
        NumberRow::from_fn(values.len(), |index| match quantities[index].dimension {
            Dimension::Length => values[index] * self.0,
            _ => values[index],
        })
    }

    /// The mechanism of the search.
    pub(super) fn mechanism<'f>(self, mechanism: &SoughtMechanism<'f>) -> SoughtMechanism<'f> {
        SoughtMechanism {
            parameters: self.row(mechanism.description().parameters, &mechanism.parameters),
            ..*mechanism
        }
    }

    /// The unit of the search's lengths.
    pub(super) fn inverse(self) -> Self {
        Self(1.0 / self.0)
    }
}

/// The power of two by which a number becomes at least a half and less than one; less than that at the ends of the
/// range of numbers.
fn reciprocal_power(value: f64) -> f64 {
    const MOST_EXPONENT: i32 = 1000;
    let (_, exponent, _) = value.integer_decode();
    // The mantissa has 53 digits.
    let power = -(i32::from(exponent) + 53);
    Float::powi(2.0, power.clamp(-MOST_EXPONENT, MOST_EXPONENT))
}

/// Whether each row of the closure is multiplied by a power of a factor by which all lengths are multiplied, and no
/// declared range of a length has an end besides zero.
fn is_homogeneous(mechanism: &SoughtMechanism<'_>) -> bool {
    let factor = LengthUnit(ENLARGED);
    let enlarged = factor.mechanism(mechanism);
    let (inputs, unknowns) = (mechanism.inputs(), mechanism.unknowns());
    let mut fits = vec![u16::MAX; unknowns.len()];
    for seed in 0..3 {
        let mixed = |index: usize| Float::sin((f64::from(seed) + 0.5) * (count(index) + 1.7) * 12.9898);
        let given = NumberRow::from_fn(inputs.len(), |index| mixed(index + 11));
        let position = NumberRow::from_fn(unknowns.len(), mixed);
        let residual = mechanism.residuals(&given, &position);
        let other = enlarged.residuals(&factor.row(inputs, &given), &factor.row(unknowns, &position));
        for (fits, (residual, other)) in fits.iter_mut().zip(residual.iter().zip(other.iter())) {
            for (bit, power) in POWERS.enumerate() {
                let expected = residual * Float::powi(ENLARGED, power);
                if (other - expected).abs() > AGREEMENT * expected.abs() {
                    *fits &= !(1 << bit);
                }
            }
        }
    }
    let some = (1 << POWERS.count()) - 1;
    fits.iter().all(|fits| fits & some != 0) && ranges_have_no_end(mechanism)
}

/// Whether the same positions lie in the declared ranges of lengths for a mechanism that is much larger, and much
/// smaller.
fn ranges_have_no_end(mechanism: &SoughtMechanism<'_>) -> bool {
    let (inputs, unknowns) = (mechanism.inputs(), mechanism.unknowns());
    let mut lengths = unknowns.iter().filter(|unknown| unknown.dimension == Dimension::Length);
    if !lengths.any(|unknown| unknown.has_range) {
        return true;
    }
    let units = [LengthUnit(RANGE_TEST), LengthUnit(1.0 / RANGE_TEST)];
    let mechanisms = units.map(|unit| unit.mechanism(mechanism));
    let mut closes = false;
    let values = (0..TESTED).map(|value| f64::from(value) * core::f64::consts::TAU / f64::from(TESTED) + 0.1);
    let agrees = values
        .flat_map(|value| mechanism.assemblies().zip(iter::repeat(value)))
        .all(|(assembly, value)| {
            let given = NumberRow::splat(inputs.len(), value);
            let [large, small] = [0, 1].map(|which| {
                let given = units[which].row(inputs, &given);
                let solved = mechanisms[which].position(&given, PositionChoice::Assembly(assembly));
                solved
                    .ok()
                    .map(|position| units[which].inverse().row(unknowns, &position))
            });
            match (large, small) {
                (Some(one), Some(other)) => {
                    closes = true;
                    mechanism.distance(1.0, &one, &other) < AGREEMENT.sqrt()
                }
                (None, None) => true,
                _ => false,
            }
        });
    agrees && closes
}
