//! How a peak depends on the dimensions.
//!
//! At an inner extreme the slope vanishes. So a dimension changes the extreme value as it changes the quantity at that place, and the
//! place itself moves by minus the mixed second derivative over the bend. (A. E. Bryson & Y.-C. Ho, *Applied Optimal Control*, Hemisphere
//! 1975, section 1.2, or any text on the envelope theorem.)
//!
//! The mixed derivative comes from two series in which variable and dimension change together: with the second-order terms c₊ and c₋ in
//! the directions (1, 1) and (1, -1), it is (c₊ - c₋) / 2.

use alloc::vec::Vec;

use super::ExtremesError;
use super::curve::{Curve, Stretch};
use super::station::SweepStation;
use super::swept::QuantityOfSweep;
use super::{ExtremeKind, Peak};
use crate::law::Side;
use crate::mechanism::Mechanism;
use crate::number::Number;
use crate::sweep::Local;

/// How a peak depends on one dimension.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PeakSensitivity {
    /// The derivative of the value with its sign, in the unit of the quantity over the unit of the dimension.
    pub value: f64,
    /// The derivative of the place: that of the variable of the sweep over the unit of the dimension. At the end of a sweep it is zero.
    pub at: f64,
}

/// A peak, and how it depends on every dimension.
#[derive(Clone, Copy, Debug)]
pub struct PeakSensitivities<M: Mechanism> {
    /// The peak.
    pub peak: Peak,
    /// A value for each scalar parameter of the mechanism, in the order of its declaration.
    pub by: M::Parameters<PeakSensitivity>,
}

/// The value of a quantity in a pose, of the dimensions of the sweep or of others that change with the variable.
pub(super) type ChangedQuantity<'q> = dyn Fn(&SweepStation, Option<&[Local]>) -> Result<Local, ExtremesError> + 'q;

impl QuantityOfSweep<'_> {
    /// The value that is largest in size, and how it depends on every dimension.
    pub(super) fn sensitivities(
        &self,
        quantity: &ChangedQuantity<'_>,
    ) -> Result<(Peak, Vec<PeakSensitivity>), ExtremesError> {
        self.ask(|curve| {
            let peak = curve.best(f64::abs)?;
            Ok((peak, self.sensitivities_at(curve, peak, quantity)?))
        })
    }

    fn sensitivities_at(
        &self,
        curve: &Curve<'_>,
        peak: Peak,
        quantity: &ChangedQuantity<'_>,
    ) -> Result<Vec<PeakSensitivity>, ExtremesError> {
        let is_inner = match peak.kind {
            ExtremeKind::Inner => true,
            ExtremeKind::End => false,
            kind @ (ExtremeKind::Limit | ExtremeKind::Kink | ExtremeKind::Unbounded) => {
                return Err(ExtremesError::NoSensitivity { at: peak.at, kind });
            }
        };
        let stretches = curve.stretches()?;
        let contains = |stretch: &&Stretch| {
            let [one, other] = stretch.parameters.map(|parameter| stretch.variable(parameter).real());
            one.min(other) <= peak.at && peak.at <= one.max(other)
        };
        let stretch = stretches.iter().find(contains).or(stretches.last());
        let stretch = stretch.ok_or(ExtremesError::Gap { at: peak.at })?;
        let side = if peak.at == self.course.from.max(self.course.to) {
            Side::Left
        } else {
            Side::Right
        };
        let value = |changed: Option<&[Local]>, step: f64| {
            let variable = Local::from_coefficients([peak.at, step, 0.0, 0.0, 0.0]);
            let (station, _) = self.station(&stretch.mark, variable, side)?;
            let value = station.finite(quantity(&station, changed)?)?;
            Ok::<_, ExtremesError>(value.coefficients())
        };
        let bend = 2.0 * value(None, 1.0)?[2];
        let parameters = &self.course.parameters;
        let sensitivity = |place: usize| {
            let own = parameters[place];
            // a change of the size of the dimension keeps both second-order terms alike
            let unit = if own == 0.0 { 1.0 } else { own.abs() };
            let changed = |step: f64| -> Vec<Local> {
                let mut changed: Vec<Local> = parameters.iter().copied().map(Local::constant).collect();
                changed[place] = Local::from_coefficients([own, step, 0.0, 0.0, 0.0]);
                changed
            };
            let mut sensitivity = PeakSensitivity {
                value: value(Some(&changed(1.0)), 0.0)?[1],
                at: 0.0,
            };
            if is_inner {
                let [plus, minus] = [unit, -unit].map(|step| value(Some(&changed(step)), 1.0));
                let mixed = 0.5 * (plus?[2] - minus?[2]) / unit;
                sensitivity.at = -mixed / bend;
            }
            Ok(sensitivity)
        };
        (0..parameters.len()).map(sensitivity).collect()
    }
}
