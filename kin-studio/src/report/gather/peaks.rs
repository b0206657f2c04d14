//! Extremes, means and sensitivities over the range.

use kin_core::RATES;
use kin_core::any::Quantity;
use kin_core::extremes::{self, ExtremeKind, ExtremesError, Over};
use kin_core::linkage::AnySweep;
use kin_core::sweep::{Label, SmoothDrive};

use super::way::Way;
use crate::names::symbol;
use crate::report::draft::Wishes;
use crate::report::model::{Cause, Extreme, RootMeanSquare, Sensitivity, Side, Unanswered};

/// The answers.
#[derive(Default)]
pub(super) struct Found {
    pub(super) extremes: Vec<Extreme>,
    pub(super) rms: Vec<RootMeanSquare>,
    pub(super) sensitivities: Vec<Sensitivity>,
    pub(super) unanswered: Vec<Unanswered>,
}

/// The answers for every derivative of some quantities.
///
/// A drive that `dwells` lets everything rest for a while.
pub(super) fn find<D: SmoothDrive>(
    wishes: &Wishes<'_>,
    way: &Way<'_, D>,
    quantities: &[Quantity<'_>],
    dwells: bool,
) -> Found {
    let mut found = Found::default();
    for quantity in quantities {
        for order in 0..=wishes.linkage.description().order {
            let symbol = symbol(quantity.name);
            let text = match order.checked_sub(1).and_then(|rate| RATES.get(rate)) {
                Some(rate) => format!("{symbol} {}", rate.replace('_', " ")),
                None => symbol,
            };
            let question = Question {
                wishes,
                name: quantity.name,
                column: Label::new(*quantity, order).to_string(),
                text,
                order,
                dwells,
            };
            question.answer(way, &mut found);
        }
    }
    found
}

/// A derivative of a quantity.
struct Question<'q> {
    wishes: &'q Wishes<'q>,
    name: &'q str,
    /// The name of its column.
    column: String,
    text: String,
    order: usize,
    /// Whether it may be extreme over an interval, and not at a single value of the variable.
    dwells: bool,
}

impl Question<'_> {
    fn answer<D: SmoothDrive>(&self, way: &Way<'_, D>, found: &mut Found) {
        match extremes(way, &self.column) {
            Ok(all) => {
                let highest = all
                    .iter()
                    .filter(|one| one.is_maximum)
                    .max_by(|one, other| rank(one).total_cmp(&rank(other)));
                let lowest = all
                    .iter()
                    .filter(|one| !one.is_maximum)
                    .min_by(|one, other| rank(one).total_cmp(&rank(other)));
                for (extreme, kind) in [(highest, Side::Highest), (lowest, Side::Lowest)] {
                    let known = extreme.map(|extreme| (extreme.value, extreme.at, cause(extreme.kind)));
                    let flat = self.dwells.then(|| flat(way, &self.column, kind)).flatten();
                    let reached = match (known, flat) {
                        (Some((Some(value), ..)), Some((further, at, cause))) if exceeds(further, value, kind) => {
                            Some((Some(further), at, cause))
                        }
                        (None, Some((value, at, cause))) => Some((Some(value), at, cause)),
                        (known, _) => known,
                    };
                    found.extremes.extend(reached.map(|(value, at, cause)| Extreme {
                        quantity: self.name.to_owned(),
                        text: self.text.clone(),
                        order: self.order,
                        kind,
                        value,
                        at,
                        cause,
                    }));
                }
            }
            Err(error) => found.unanswered.push(self.unanswered(&error)),
        }
        match over_all(way, |sweep| Ok(sweep.of(&self.column).rms(Over::Time)?.value)) {
            Ok(value) => found.rms.push(RootMeanSquare {
                quantity: self.name.to_owned(),
                order: self.order,
                value,
            }),
            Err(error) => found.unanswered.push(self.unanswered(&error)),
        }
        // a peak that moves with a limit has no sensitivity, and no dimension changes the peak of an input
        if let Some(answer) = sensitivity(way, &self.column).filter(|answer| answer.by.iter().any(|by| by.value != 0.0))
        {
            let values = answer.by.iter().map(|by| by.value).collect();
            found.sensitivities.push(Sensitivity {
                quantity: self.name.to_owned(),
                text: format!("peak of {}", self.text),
                order: self.order,
                peak: answer.peak.value,
                at: answer.peak.at,
                values,
            });
        }
    }

    fn unanswered(&self, error: &ExtremesError) -> Unanswered {
        Unanswered {
            quantity: self.name.to_owned(),
            order: self.order,
            text: self.wishes.named(error),
        }
    }
}

/// The size by which extremes are compared: an unbounded extreme is larger than all others.
fn rank(extreme: &extremes::Extreme) -> f64 {
    extreme.value.unwrap_or(if extreme.is_maximum {
        f64::INFINITY
    } else {
        f64::NEG_INFINITY
    })
}

fn cause(kind: ExtremeKind) -> Cause {
    match kind {
        ExtremeKind::Inner => Cause::Inner,
        ExtremeKind::Limit => Cause::Limit,
        ExtremeKind::Kink => Cause::Kink,
        ExtremeKind::End => Cause::End,
        ExtremeKind::Unbounded => Cause::Unbounded,
    }
}

/// All extremes over the range.
fn extremes<D: SmoothDrive>(way: &Way<'_, D>, column: &str) -> Result<Vec<extremes::Extreme>, ExtremesError> {
    let mut all = Vec::new();
    for sweep in &way.sweeps {
        all.extend(sweep.of(column).extremes()?);
    }
    let Some(start) = way.start() else { return Ok(all) };
    // Two sweeps begin at one value, which is no end of the range. It is an extreme only if it is extreme in both
    // sweeps.
    let is_start = |extreme: &extremes::Extreme| extreme.at == start && extreme.kind == ExtremeKind::End;
    let maxima: Vec<bool> = all
        .iter()
        .filter(|extreme| is_start(extreme))
        .map(|extreme| extreme.is_maximum)
        .collect();
    let is_extreme = matches!(maxima.as_slice(), [one, other] if one == other);
    let mut kept = is_extreme;
    all.retain_mut(|extreme| {
        if !is_start(extreme) {
            return true;
        }
        extreme.kind = ExtremeKind::Inner;
        std::mem::take(&mut kept)
    });
    Ok(all)
}

/// Whether a value lies further to a side than another value by more than rounding.
fn exceeds(further: f64, value: f64, side: Side) -> bool {
    let by = if side == Side::Highest {
        further - value
    } else {
        value - further
    };
    by > 1e-12 * value.abs().max(further.abs())
}

/// The extreme value, even if it is reached over an interval, as in a dwell.
fn flat<D: SmoothDrive>(way: &Way<'_, D>, column: &str, side: Side) -> Option<(f64, f64, Cause)> {
    let reached = way.sweeps.iter().map(|sweep| match side {
        Side::Highest => sweep.of(column).highest(),
        Side::Lowest => sweep.of(column).lowest(),
    });
    let reached: Vec<_> = reached.collect::<Result<_, _>>().ok()?;
    let sign = if side == Side::Highest { 1.0 } else { -1.0 };
    let best = reached
        .into_iter()
        .max_by(|one, other| (sign * one.value).total_cmp(&(sign * other.value)))?;
    Some((best.value, best.at, cause(best.kind)))
}

/// The root mean square over time from that of each sweep, or nothing if it grows beyond all bounds.
pub(super) fn over_all<D: SmoothDrive>(
    way: &Way<'_, D>,
    rms: impl Fn(&AnySweep<'_, D>) -> Result<f64, ExtremesError>,
) -> Result<Option<f64>, ExtremesError> {
    let mut values = Vec::new();
    for sweep in &way.sweeps {
        match rms(sweep) {
            Ok(value) => values.push(value),
            Err(ExtremesError::Diverges { .. } | ExtremesError::Unbounded { .. }) => return Ok(None),
            Err(error) => return Err(error),
        }
    }
    if let [only] = values.as_slice() {
        return Ok(Some(*only));
    }
    // at constant speed the times are as the ways
    let Some(lengths) = way.lengths() else { return Ok(None) };
    let squares = values
        .iter()
        .zip(&lengths)
        .map(|(value, length)| value * value * length);
    Ok(Some((squares.sum::<f64>() / lengths.iter().sum::<f64>()).sqrt()))
}

/// The peak that is largest in size, with its dependence on the dimensions.
fn sensitivity<D: SmoothDrive>(way: &Way<'_, D>, column: &str) -> Option<extremes::PeakSensitivities> {
    let mut best: Option<extremes::PeakSensitivities> = None;
    for sweep in &way.sweeps {
        let found = sweep.of(column).peak_sensitivities().ok()?;
        if best
            .as_ref()
            .is_none_or(|best| found.peak.value.abs() > best.peak.value.abs())
        {
            best = Some(found);
        }
    }
    // the value at which two sweeps begin is no peak of the range
    best.filter(|best| way.start() != Some(best.peak.at))
}
