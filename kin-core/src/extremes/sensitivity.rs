//! How a peak depends on the dimensions.
//!
//! At an inner extreme the slope vanishes. So a dimension changes the extreme value as it changes the quantity at that place, and the
//! place itself moves by minus the mixed second derivative over the bend. (A. E. Bryson & Y.-C. Ho, *Applied Optimal Control*, Hemisphere
//! 1975, section 1.2, or any text on the envelope theorem.)
//!
//! The mixed derivative comes from two series in which variable and dimension change together: with the second-order terms c₊ and c₋ in
//! the directions (1, 1) and (1, -1), it is (c₊ - c₋) / 2.

use super::ExtremesError;
use super::answer::Answer;
use super::at::At;
use super::curve::{Curve, Stretch};
use super::swept::QuantityOfSweep;
use super::{ExtremeKind, Peak};
use crate::law::Side;
use crate::mechanism::Mechanism;
use crate::number::{Number, Row};
use crate::sweep::{Local, SmoothDrive};

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

impl<M: Mechanism<Scalar = f64>, D: SmoothDrive<M>> QuantityOfSweep<'_, M, D> {
    /// How a peak depends on every dimension. It has been found on this curve.
    pub(super) fn sensitivities<A: Answer>(
        &self,
        curve: &Curve<'_>,
        peak: Peak,
        quantity: impl Fn(&At<M>) -> A,
    ) -> Result<PeakSensitivities<M>, ExtremesError> {
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
        let value = |mechanism: Option<&M::With<Local>>, step: f64| {
            let variable = Local::from_coefficients([peak.at, step, 0.0, 0.0, 0.0]);
            let (station, _) = self.station(stretch.mark.walk(), variable, side)?;
            let value = station.finite(station.answer(mechanism, &quantity)?)?;
            Ok::<_, ExtremesError>(value.coefficients())
        };
        let bend = 2.0 * value(None, 1.0)?[2];
        let mut by: M::Parameters<PeakSensitivity> = Row::splat(PeakSensitivity::default());
        for (place, sensitivity) in by.as_mut().iter_mut().enumerate() {
            let parameters = self.course.mechanism.parameters();
            let own: f64 = parameters[place];
            // a change of the size of the dimension keeps both second-order terms alike
            let unit = if own == 0.0 { 1.0 } else { own.abs() };
            let changed = |step: f64| {
                M::With::<Local>::from_parameters(Row::from_fn(|index| {
                    let change = if index == place { step } else { 0.0 };
                    Local::from_coefficients([parameters[index], change, 0.0, 0.0, 0.0])
                }))
            };
            sensitivity.value = value(Some(&changed(1.0)), 0.0)?[1];
            if is_inner {
                let [plus, minus] = [unit, -unit].map(|step| value(Some(&changed(step)), 1.0));
                let mixed = 0.5 * (plus?[2] - minus?[2]) / unit;
                sensitivity.at = -mixed / bend;
            }
        }
        Ok(PeakSensitivities { peak, by })
    }
}
