//! The figures of a result over its exact travel.

use kin_core::cycle::Cycle;
use kin_core::sweep::{Local, Swept as _};
use kin_core::{Mechanism, Number as _, RATES, Row};

use super::check::Way;
use crate::objective::{Design, Objective, Place, Traced, Travel};

/// The highest order of which peaks are given.
const HIGHEST: usize = 4;
/// The rows between which extremes are sought.
const ROWS: usize = 181;

/// A smallest or largest value, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Least {
    /// The value.
    pub value: f64,
    /// The input there.
    pub input: f64,
}

/// How far a quantity goes, or the largest size of a rate.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// The name of the quantity, in the mechanism's own frame.
    pub name: String,
    /// The smallest value.
    pub low: Least,
    /// The largest value.
    pub high: Least,
}

/// The figures of a result: limits of its branch, and extremes over its travel, which are the zeros of derivatives and
/// not the best of samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Figures {
    /// The index of its circuit in the cycle.
    pub circuit: usize,
    /// The index of its branch in the cycle.
    pub branch: usize,
    /// Whether the input turns fully.
    pub is_full_turn: bool,
    /// The smallest and the largest input of the branch.
    pub limits: [f64; 2],
    /// Where its travel begins and ends, in the order in which it passes its targets.
    pub travel: [f64; 2],
    /// The smallest transmission angle of all dyads over the travel, folded to at most a right angle (rad); `None`
    /// without dyads.
    pub transmission: Option<Least>,
    /// How far each traced quantity goes over the travel.
    pub strokes: Vec<Range>,
    /// The largest velocity, acceleration, jerk and snap over the travel, at the speed 1 of the input: of a point their
    /// lengths. Empty if the travel is a single place.
    pub peaks: Vec<(String, Least)>,
}

pub(super) fn figures<M: Mechanism<Scalar = f64>>(
    objective: &Objective<M>,
    design: &Design<M>,
    cycle: &Cycle<M>,
    index: usize,
    way: Way,
) -> Result<Figures, String> {
    let own = design.mechanism();
    let branch = &cycle.branches()[index];
    let ends = branch.ends().map(|end| end.input);
    let travel = match objective.travel {
        Travel::Turn => [way.from, way.from + (ends[1] - ends[0]).copysign(way.way)],
        Travel::Targets => [way.from, way.from + way.way],
    };
    let mut figures = Figures {
        circuit: branch.circuit(),
        branch: index,
        is_full_turn: branch.is_full_turn(),
        limits: ends,
        travel,
        transmission: None,
        strokes: Vec::new(),
        peaks: Vec::new(),
    };
    let dyads = <M::Dyads<f64> as Row<f64>>::LENGTH;
    if travel[0] == travel[1] {
        let inputs = || objective.inputs::<M>(travel[0]);
        let found = own
            .position(inputs(), design.assembly)
            .map_err(|error| error.to_string())?;
        let angles = own.transmission_angles_at(inputs(), found);
        let folded = angles.as_ref().iter().map(kin_core::TransmissionAngle::folded);
        figures.transmission = folded.min_by(f64::total_cmp).map(|value| Least {
            value,
            input: travel[0],
        });
        return Ok(figures);
    }
    let [from, to] = travel.map(|input| objective.inputs::<M>(input));
    // the input has the speed 1, whichever way it travels
    let speed = (travel[1] - travel[0]).signum();
    let sweep = own.sweep(design.assembly).between(from, to, ROWS).speed(speed);
    let least = |peak: kin_core::extremes::Peak| Least {
        value: peak.value,
        input: peak.at,
    };
    for dyad in 0..dyads {
        let folded = |at: &kin_core::extremes::At<M>| {
            let angle = at.transmission_angle(dyad);
            angle.map_or(Local::constant(f64::NAN), |angle| angle.folded())
        };
        let lowest = sweep
            .of_expression(folded)
            .lowest()
            .map_err(|error| error.to_string())?;
        if figures.transmission.is_none_or(|known| lowest.value < known.value) {
            figures.transmission = Some(least(lowest));
        }
    }
    let of = |traced: Traced, order: usize| {
        move |at: &kin_core::extremes::At<M>| {
            let value = match traced.place {
                Place::Unknown(index) => at.unknown(index, order),
                Place::Output(index) => at.output(index, order),
            };
            value.unwrap_or(Local::constant(f64::NAN))
        }
    };
    for traced in &objective.traced {
        let quantity = sweep.of_expression(of(*traced, 0));
        let [low, high] = [quantity.lowest(), quantity.highest()];
        figures.strokes.push(Range {
            name: traced.name.to_owned(),
            low: least(low.map_err(|error| error.to_string())?),
            high: least(high.map_err(|error| error.to_string())?),
        });
    }
    for (order, rate) in (1..=M::DESCRIPTION.order.min(HIGHEST)).zip(RATES) {
        let first = objective.traced[0];
        if let [x, y, ..] = objective.traced[..] {
            // The square of the length has derivatives where the point stands still.
            let square = |at: &kin_core::extremes::At<M>| {
                let [x, y] = [x, y].map(|traced| of(traced, order)(at));
                x * x + y * y
            };
            let highest = least(
                sweep
                    .of_expression(square)
                    .highest()
                    .map_err(|error| error.to_string())?,
            );
            let name = first.name.strip_suffix(".x").unwrap_or(first.name);
            let peak = Least {
                value: highest.value.sqrt(),
                ..highest
            };
            figures.peaks.push((format!("{name}_{rate}"), peak));
        } else {
            let peak = sweep
                .of_expression(of(first, order))
                .peak()
                .map_err(|error| error.to_string())?;
            figures.peaks.push((format!("{}_{rate}", first.name), least(peak)));
        }
    }
    Ok(figures)
}
