//! How a peak depends on the dimensions.
//!
//! At an inner extreme the slope vanishes. So a dimension changes the extreme value as it changes the quantity at that
//! point, and the point itself moves by minus the mixed second derivative over the bend. (A. E. Bryson & Y.-C. Ho,
//! *Applied Optimal Control*, Hemisphere 1975, section 1.2, or any text on the envelope theorem.)
//!
//! The mixed derivative of a quantity called by its name, or of a force in a joint, comes with the value, from a
//! position in series of the variable that change with the dimension. That of an expression comes from two series in
//! which variable and dimension change together: with the second-order terms c₊ and c₋ in the directions (1, 1) and
//! (1, -1), it is (c₊ - c₋) / 2.

use alloc::vec::Vec;

use super::ExtremesError;
use super::curve::{Curve, Stretch};
use super::station::SweepStation;
use super::swept::QuantityOfSweep;
use super::{ExtremeKind, Peak};
use crate::law::Side;
use crate::number::Number;
use crate::sweep::Local;

/// How a peak depends on one dimension.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PeakSensitivity {
    /// The derivative of the value with its sign, in the unit of the quantity over the unit of the dimension.
    pub value: f64,
    /// The derivative of the position: that of the variable of the sweep over the unit of the dimension. At the end of
    /// a sweep it is zero.
    pub at: f64,
}

/// A peak, and how it depends on every dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct PeakSensitivities {
    /// The peak.
    pub peak: Peak,
    /// A value for each scalar parameter of the mechanism, in the order of its declaration.
    pub by: Vec<PeakSensitivity>,
}

/// A quantity at a peak, whose variable has the slope 1.
pub(super) type PeakQuantity<'q> = dyn Fn(&SweepStation<'_>, usize) -> Result<ByDimension, ExtremesError> + 'q;

/// The derivatives of a quantity with respect to a dimension.
#[derive(Clone, Copy, Debug)]
pub struct ByDimension {
    /// That of the value.
    pub(super) value: f64,
    /// That of the slope.
    pub(super) slope: f64,
}

impl ByDimension {
    /// The derivatives of an expression, from its series for a series of all dimensions.
    pub(super) fn of_expression(
        station: &SweepStation<'_>,
        dimension: usize,
        expression: impl Fn(&SweepStation<'_>, &[Local]) -> Result<Local, ExtremesError>,
    ) -> Result<Self, ExtremesError> {
        let value = station.parameters[dimension];
        // a change of the size of the dimension keeps both second-order terms alike
        let unit = if value == 0.0 { 1.0 } else { value.abs() };
        let along = |slope: f64, step: f64| {
            let mut changed: Vec<Local> = station.parameters.iter().copied().map(Local::constant).collect();
            changed[dimension] = Local::from_coefficients([value, step, 0.0, 0.0, 0.0]);
            let variable = Local::from_coefficients([station.variable.real(), slope, 0.0, 0.0, 0.0]);
            let moved = SweepStation {
                variable,
                ..station.clone()
            };
            Ok::<_, ExtremesError>(station.finite(expression(&moved, &changed)?)?.coefficients())
        };
        Ok(Self {
            value: along(0.0, 1.0)?[1],
            slope: 0.5 * (along(1.0, unit)?[2] - along(1.0, -unit)?[2]) / unit,
        })
    }

    /// The derivatives of a quantity whose change with a dimension is a series of the variable.
    pub(super) fn of_change(station: &SweepStation<'_>, change: Local) -> Result<Self, ExtremesError> {
        let [value, slope, ..] = station.finite(change)?.derivatives();
        Ok(Self { value, slope })
    }
}

impl QuantityOfSweep<'_> {
    /// The value that is largest in size, and how it depends on every dimension.
    pub(super) fn sensitivities(&self, by_dimension: &PeakQuantity<'_>) -> Result<PeakSensitivities, ExtremesError> {
        self.ask(|curve| {
            let peak = curve.best(f64::abs)?;
            let by = self.sensitivities_at(curve, peak, by_dimension)?;
            Ok(PeakSensitivities { peak, by })
        })
    }

    fn sensitivities_at(
        &self,
        curve: &Curve<'_>,
        peak: Peak,
        by_dimension: &PeakQuantity<'_>,
    ) -> Result<Vec<PeakSensitivity>, ExtremesError> {
        let is_inner = match peak.kind {
            ExtremeKind::Inner => true,
            ExtremeKind::End => false,
            kind @ (ExtremeKind::Limit | ExtremeKind::Kink | ExtremeKind::Unbounded) => {
                return Err(ExtremesError::NoSensitivity { at: peak.at, kind });
            }
        };
        let stretches = curve.stretches()?;
        let contains = |stretch: &&Stretch<'_>| {
            let [one, other] = stretch.parameters.map(|parameter| stretch.variable(parameter).real());
            one.min(other) <= peak.at && peak.at <= one.max(other)
        };
        let stretch = stretches.iter().find(contains).or(stretches.last());
        let stretch = stretch.ok_or(ExtremesError::Gap { at: peak.at })?;
        let side = if peak.at == self.sweep.from.max(self.sweep.to) {
            Side::Left
        } else {
            Side::Right
        };
        let variable = Local::from_coefficients([peak.at, 1.0, 0.0, 0.0, 0.0]);
        let (station, _) = self.station(&stretch.mark, variable, side)?;
        let bend = 2.0 * station.finite((self.quantity)(&station)?)?.coefficients()[2];
        let sensitivity = |dimension: usize| {
            let by = by_dimension(&station, dimension)?;
            Ok(PeakSensitivity {
                value: by.value,
                at: if is_inner { -by.slope / bend } else { 0.0 },
            })
        };
        (0..station.parameters.len()).map(sensitivity).collect()
    }
}
