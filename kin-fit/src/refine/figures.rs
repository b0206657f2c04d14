//! The figures of a result over its exact travel.

use kin_core::any::AssemblyChoice;
use kin_core::cycle::Branch;
use kin_core::extremes::Peak;
use kin_core::linkage::AnyLinkage;
use kin_core::{Number as _, RATES};

use super::check::Way;
use crate::functions::{Change, Choice, PointWay};
use crate::objective::Objective;
use crate::term::Travel;

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

/// The range of a quantity, or the largest size of a rate.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// The name of the quantity, in the frame of the mechanism.
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
    /// Whether the input makes full revolutions.
    pub is_full_revolution: bool,
    /// The smallest and the largest input of the branch.
    pub limits: [f64; 2],
    /// The ends of its travel, in the order in which it passes its targets.
    pub travel: [f64; 2],
    /// The smallest transmission angle of all dyads over the travel, folded to at most a right angle (rad); `None`
    /// without dyads.
    pub transmission: Option<Least>,
    /// The range of each traced quantity over the travel.
    pub strokes: Vec<Range>,
    /// The largest velocity, acceleration, jerk and snap over the travel, at the speed 1 of the input: of a point their
    /// lengths. Empty if the travel is a single position.
    pub peaks: Vec<(String, Least)>,
}

pub(super) fn figures(
    objective: &Objective,
    linkage: &AnyLinkage<'static>,
    assembly: usize,
    branch: &Branch,
    index: usize,
    way: Way,
) -> Result<Figures, String> {
    let ends = branch.ends().map(|end| end.input);
    let travel = match objective.travel {
        Travel::Revolution => [way.from, way.from + (ends[1] - ends[0]).copysign(way.way)],
        Travel::Targets => [way.from, way.from + way.way],
    };
    let mut figures = Figures {
        circuit: branch.circuit(),
        branch: index,
        is_full_revolution: branch.is_full_revolution(),
        limits: ends,
        travel,
        transmission: None,
        strokes: Vec::new(),
        peaks: Vec::new(),
    };
    if travel[0] == travel[1] {
        let choice = Choice::Assembly(assembly);
        let posed = objective.posed(linkage.parameters(), &choice);
        let solved = posed.solve(objective.inputs(Change::constant(travel[0])));
        let solved = solved.ok_or_else(|| "the mechanism does not close at its only target".to_owned())?;
        figures.transmission = posed.transmission(&solved).map(|angle| Least {
            value: angle.value,
            input: travel[0],
        });
        return Ok(figures);
    }
    let [from, to] = travel.map(|input| objective.inputs_at(input));
    // the input has the speed 1, whichever way it travels
    let speed = (travel[1] - travel[0]).signum();
    let sweep = linkage
        .sweep(AssemblyChoice::Index(assembly))
        .between(&from, &to, ROWS)
        .speed(speed);
    let least = |peak: Peak| Least {
        value: peak.value,
        input: peak.at,
    };
    let text = |error: kin_core::extremes::ExtremesError| error.to_string();
    for dyad in 0..linkage.dyad_count() {
        let lowest = sweep.of_transmission_angle(dyad).lowest().map_err(text)?;
        if figures.transmission.is_none_or(|known| lowest.value < known.value) {
            figures.transmission = Some(least(lowest));
        }
    }
    for traced in &objective.traced {
        let quantity = sweep.of(traced.name);
        figures.strokes.push(Range {
            name: traced.name.to_owned(),
            low: least(quantity.lowest().map_err(text)?),
            high: least(quantity.highest().map_err(text)?),
        });
    }
    for (order, rate) in (1..=linkage.description().order.min(HIGHEST)).zip(RATES) {
        let first = objective.traced[0];
        let (name, peak) = if let [x, y, ..] = objective.traced[..] {
            let found = objective.functions.peak_of_point(&PointWay {
                parameters: linkage.parameters(),
                assembly,
                ends: [&from, &to],
                rows: ROWS,
                speed,
                quantities: [x.index, y.index],
                order,
            });
            let Some(peak) = found else { break };
            (first.name.strip_suffix(".x").unwrap_or(first.name), peak)
        } else {
            (first.name, sweep.of(&format!("{}_{rate}", first.name)).peak())
        };
        figures
            .peaks
            .push((format!("{name}_{rate}"), least(peak.map_err(text)?)));
    }
    Ok(figures)
}
