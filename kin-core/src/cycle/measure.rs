//! What a designer reads off a circuit: strokes, ratios of times and the worst transmission angle.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::error::Error;
use core::f64::consts::{PI, TAU};
use core::fmt;

use num_traits::Float;

use super::line::nearest;
use super::{Branch, Cycle, EndKind};
use crate::failure::{Failure, InputValues, SolveError};
use crate::mechanism::{Mechanism, Pose};
use crate::number::series::Series;
use crate::number::{Number, Row};
use crate::quantity::{Digits, Dimension, Quantity};
use crate::solve::nearest_turn;
use crate::track::track;

/// The number of places of a branch between which extremes are sought.
const PLACES: u32 = 96;
/// The distance by which an input may lie outside of its branch because of rounding, as a part of the largest input.
const BESIDE: f64 = 64.0 * f64::EPSILON;
/// The smallest stroke of a quantity that moves, as a part of its largest value, and the shortest way between its ends, as a part of a turn.
const STILL: f64 = 1e-12;
/// The largest number of iterations of an extreme.
const ITERATIONS: usize = 100;

/// The smallest or largest value of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokeEnd {
    /// The value.
    pub value: f64,
    /// The input there.
    pub input: f64,
    /// The index of the branch.
    pub branch: usize,
}

/// The range of a quantity along a circuit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// The smallest value.
    pub low: StrokeEnd,
    /// The largest value.
    pub high: StrokeEnd,
}

impl Stroke {
    /// The difference of the largest and the smallest value.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.high.value - self.low.value
    }
}

/// The smallest transmission angle along a circuit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstTransmission {
    /// The unknowns of the dyad, separated by commas.
    pub block: &'static str,
    /// The smaller of the transmission angle and its supplement, 0 at a limit.
    pub angle: f64,
    /// The input there.
    pub input: f64,
    /// The index of the branch.
    pub branch: usize,
}

/// The reason why there is no such figure of a circuit.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum MeasureError {
    /// The mechanism has no unknown or scalar output of this name.
    NoSuchQuantity {
        /// The name that was given.
        name: String,
        /// The names of the unknowns and scalar outputs.
        quantities: Vec<&'static str>,
    },
    /// There is no circuit with this index.
    NoSuchCircuit,
    /// The input does not turn fully along the circuit.
    NoFullTurn,
    /// The quantity does not go to and fro: it turns fully with the input, or stays where it is.
    NoReturn {
        /// The smallest value.
        low: f64,
        /// The largest value.
        high: f64,
    },
    /// The mechanism has no dyad.
    NoDyad,
    /// A position could not be solved again.
    Unsolved(SolveError),
}

impl fmt::Display for MeasureError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchQuantity { name, quantities } => {
                write!(formatter, "no unknown or scalar output is called `{name}`: there is ")?;
                for (place, quantity) in quantities.iter().enumerate() {
                    let before = match place {
                        0 => "",
                        _ if place + 1 == quantities.len() => " and ",
                        _ => ", ",
                    };
                    write!(formatter, "{before}`{quantity}`")?;
                }
                Ok(())
            }
            Self::NoSuchCircuit => formatter.write_str("there is no circuit with this index"),
            Self::NoFullTurn => formatter.write_str(
                "the input does not turn fully along this circuit, so there is no advance and return of one turn",
            ),
            Self::NoReturn { low, high } => write!(
                formatter,
                "the quantity does not go to and fro: it turns fully or stays where it is, from {} to {}, so there is no advance and \
                 return",
                Digits(*low),
                Digits(*high)
            ),
            Self::NoDyad => formatter.write_str("the mechanism has no dyad, and so no transmission angle"),
            Self::Unsolved(error) => error.fmt(formatter),
        }
    }
}

crate::__debug_by_display!(MeasureError);

impl Error for MeasureError {}

impl From<SolveError> for MeasureError {
    fn from(error: SolveError) -> Self {
        Self::Unsolved(error)
    }
}

/// An unknown or an output.
#[derive(Clone, Copy)]
enum Which {
    Unknown(usize),
    Output(usize),
}

/// The unknowns and the scalar outputs.
fn quantities<M: Mechanism>() -> impl Iterator<Item = &'static Quantity> {
    M::DESCRIPTION.unknowns.iter().chain(M::DESCRIPTION.outputs)
}

fn named<M: Mechanism>(name: &str) -> Option<Which> {
    let unknowns = M::DESCRIPTION.unknowns.iter().position(|unknown| unknown.name == name);
    let outputs = || M::DESCRIPTION.outputs.iter().position(|output| output.name == name);
    unknowns.map(Which::Unknown).or_else(|| outputs().map(Which::Output))
}

impl<M: Mechanism<Scalar = f64>> Cycle<M> {
    /// The unknowns of a branch at an input of its range, with angles on the turns they have along the branch. An input may be whole
    /// [periods](Self::period) beside the range.
    ///
    /// # Errors
    /// [`Failure::OutOfRange`] if the input lies outside the branch, with the range of the branch, and the errors of the solver: the input
    /// lies at an end of the branch.
    pub fn position_on(&self, branch: usize, input: f64) -> Result<M::Unknowns<f64>, SolveError> {
        let failed = |failure: Failure| {
            let names = InputValues::new(M::DESCRIPTION.inputs, self.line.inputs(input).as_ref());
            let block = M::DESCRIPTION.blocks.first().map_or("", |block| block.unknowns);
            failure.at(block, names)
        };
        let none = || failed(Failure::NotFinite { quantity: "branch" });
        let own = self.branches.get(branch).ok_or_else(none)?;
        let input = self.place_on(own, input).map_err(failed)?;
        let inputs = self.line.inputs(input);
        let inner = own.samples.iter().filter(|(s, _)| {
            let is_end = [0, 1].map(|end| own.ends[end].kind != EndKind::FullTurn && own.ends[end].input == *s);
            is_end == [false, false]
        });
        let closest = |one: &&(f64, M::Unknowns<f64>), other: &&(f64, M::Unknowns<f64>)| {
            (one.0 - input).abs().total_cmp(&(other.0 - input).abs())
        };
        let sample = inner.min_by(closest).or(own.samples.iter().min_by(closest));
        let (s, near) = *sample.ok_or_else(none)?;
        match own.assembly {
            Some(assembly) => {
                let solved = self.mechanism.solve_position(inputs, assembly)?;
                let unknowns = nearest::<M>(solved, &near);
                let is_turned = |index: usize| (unknowns[index] - solved[index]).abs() > PI;
                if !(0..M::DESCRIPTION.unknowns.len()).any(is_turned) {
                    return Ok(unknowns);
                }
                // what depends on an angle itself, as the position of a rack does, depends on its turn
                let turned = self.mechanism.solve_position_near(inputs, unknowns).ok();
                let is_same = |turned: &M::Unknowns<f64>| self.mechanism.assembly_near(inputs, *turned) == assembly;
                let turned = turned.filter(is_same);
                Ok(turned.map_or(unknowns, |turned| nearest::<M>(turned, &unknowns)))
            }
            None => track(&self.mechanism, self.line.inputs(s), near, inputs).map_err(|error| match error {
                crate::track::TrackError::Failed(error) => error,
                _ => none(),
            }),
        }
    }

    /// The place of an input in the range of a branch, which may be whole periods away from it.
    fn place_on(&self, branch: &Branch<M>, input: f64) -> Result<f64, Failure> {
        let [low, high] = branch.ends.each_ref().map(|end| end.input);
        let slack = BESIDE * low.abs().max(high.abs());
        let contains = |place: &f64| *place >= low - slack && *place <= high + slack;
        if branch.is_full_turn() || contains(&input) {
            return Ok(input);
        }
        let turned = self.line.period().map(|period| {
            let periods = Float::ceil((low - slack - input) / period);
            input + periods * period
        });
        turned.filter(contains).ok_or(Failure::OutOfRange {
            unknown: "the input of the branch",
            value: input,
            low,
            high,
            is_angle: self.line.is_angle(),
        })
    }

    /// The pose of a branch at an input, with all derivatives with respect to the input.
    ///
    /// # Errors
    /// The errors of [`position_on`](Self::position_on).
    pub fn pose_on(&self, branch: usize, input: f64) -> Result<M::Pose, SolveError> {
        let near = self.position_on(branch, input)?;
        let values = self.line.inputs(input);
        let motions = M::Inputs::from_fn(|index| {
            M::Motion::from_fn(|order| match order {
                0 => values[index],
                1 => self.line.direction[index],
                _ => 0.0,
            })
        });
        match self.branches[branch].assembly {
            Some(assembly) if self.mechanism.assembly_near(values, near) != assembly => {
                self.mechanism.solve_motion(motions, assembly)
            }
            _ => self.mechanism.solve_motion_near(motions, near),
        }
    }

    fn circuit(&self, circuit: usize) -> Result<&[usize], MeasureError> {
        let circuit = self.circuits.get(circuit).ok_or(MeasureError::NoSuchCircuit)?;
        Ok(circuit.branches())
    }

    /// The smallest and the largest value of an unknown or of a scalar output along a circuit.
    ///
    /// Inner extremes are the zeros of the derivative, to rounding. They are sought between 96 places of each branch, which are closest to each
    /// other at its ends. The values of unknowns at the ends count as well. Angles are those along each branch.
    ///
    /// # Errors
    /// [`MeasureError`], if there is no such circuit or quantity.
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::SliderCrank;
    ///
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// let stroke = press.cycle()?.stroke(0, "s")?;
    /// assert!((stroke.length() - 0.2).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn stroke(&self, circuit: usize, name: &str) -> Result<Stroke, MeasureError> {
        let which = named::<M>(name).ok_or_else(|| MeasureError::NoSuchQuantity {
            name: name.to_string(),
            quantities: quantities::<M>().map(|quantity| quantity.name).collect(),
        })?;
        let mut stroke: Option<Stroke> = None;
        for branch in self.circuit(circuit)? {
            // the input, the value and the rate of the sample before, from which an angle goes on
            let mut before: Option<[f64; 3]> = None;
            let value = |input: f64| {
                let pose = self.pose_on(*branch, input)?;
                let [mut value, rate] = match which {
                    Which::Unknown(index) => {
                        let near = self.position_on(*branch, input)?;
                        let motions = pose.unknown_motions_near(Row::from_fn(|unknown| near[unknown]));
                        [near[index], motions[index].as_ref().get(1).copied().unwrap_or(0.0)]
                    }
                    Which::Output(index) => {
                        let motions = pose.output_motions();
                        [
                            motions[index][0],
                            motions[index].as_ref().get(1).copied().unwrap_or(0.0),
                        ]
                    }
                };
                if let (Which::Output(index), Some([place, last, slope])) = (which, before)
                    && M::DESCRIPTION.outputs[index].dimension == Dimension::Angle
                {
                    let predicted = last + 0.5 * (input - place) * (slope + rate);
                    value = nearest_turn(value, predicted);
                }
                before = Some([input, value, rate]);
                Ok([value, rate])
            };
            let mut extremes = extremes(&self.branches[*branch], value)?;
            if let Which::Unknown(index) = which {
                extremes.extend(
                    self.branches[*branch]
                        .ends
                        .iter()
                        // those of a full turn are samples
                        .filter(|end| end.kind != EndKind::FullTurn)
                        .map(|end| (end.input, end.unknowns[index])),
                );
            }
            for (input, value) in extremes {
                let own = StrokeEnd {
                    value,
                    input,
                    branch: *branch,
                };
                let known = stroke.get_or_insert(Stroke { low: own, high: own });
                if value < known.low.value {
                    known.low = own;
                }
                if value > known.high.value {
                    known.high = own;
                }
            }
        }
        stroke.ok_or(MeasureError::NoSuchCircuit)
    }

    /// The time ratio of a quick return, at a constant speed of the input: the longer of the ways of the input between the smallest and the
    /// largest value of a quantity, divided by the shorter one. It is 1 or more.
    ///
    /// # Errors
    /// [`MeasureError::NoFullTurn`], if the input does not turn once along the circuit, [`MeasureError::NoReturn`], if the quantity turns
    /// fully or stays where it is; otherwise as for [`stroke`](Self::stroke).
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::FourBar;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let cycle = linkage.cycle()?;
    /// // at its ends, the rocker is where crank and coupler lie on one line
    /// let angle = |side: f64| ((90.0_f64.powi(2) + side.powi(2) - 60.0_f64.powi(2)) / (2.0 * 90.0 * side)).acos();
    /// let offset = (angle(70.0 - 30.0) - angle(70.0 + 30.0)).abs();
    /// let expected = (std::f64::consts::PI + offset) / (std::f64::consts::PI - offset);
    /// assert!((cycle.time_ratio(0, "theta4")? - expected).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn time_ratio(&self, circuit: usize, name: &str) -> Result<f64, MeasureError> {
        let [branch] = self.circuit(circuit)? else {
            return Err(MeasureError::NoFullTurn);
        };
        let branch = &self.branches[*branch];
        if !branch.is_full_turn() {
            return Err(MeasureError::NoFullTurn);
        }
        let turn = branch.ends[1].input - branch.ends[0].input;
        let stroke = self.stroke(circuit, name)?;
        let way = (stroke.high.input - stroke.low.input).abs();
        let [short, long] = [way.min(turn - way), way.max(turn - way)];
        let (low, high) = (stroke.low.value, stroke.high.value);
        let turns = match named::<M>(name) {
            Some(Which::Unknown(index)) => self.circuits[circuit].turns.is_some_and(|turns| turns[index] != 0),
            _ => false,
        };
        let is_still = stroke.length() <= STILL * low.abs().max(high.abs()) || short <= STILL * turn;
        if turns || is_still {
            return Err(MeasureError::NoReturn { low, high });
        }
        Ok(long / short)
    }

    /// The smallest transmission angle of all dyads along a circuit, folded to at most a right angle. It is zero if the circuit has a limit in
    /// which a dyad is stretched or folded.
    ///
    /// # Errors
    /// [`MeasureError::NoDyad`], if the mechanism has none, or if there is no such circuit.
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::FourBar;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let worst = linkage.cycle()?.worst_transmission(0)?;
    /// // crank and ground in line: the diagonal is 60 or 120
    /// let angle = |d: f64| ((70.0_f64.powi(2) + 60.0_f64.powi(2) - d * d) / (2.0 * 70.0 * 60.0)).acos();
    /// let expected = angle(60.0).min(std::f64::consts::PI - angle(120.0));
    /// assert!((worst.angle - expected).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn worst_transmission(&self, circuit: usize) -> Result<WorstTransmission, MeasureError> {
        let series: M::With<Series<2>> = self.mechanism.convert(Number::constant);
        let mut worst: Option<WorstTransmission> = None;
        let dyads = <M::Dyads<f64> as Row<f64>>::LENGTH;
        for branch in self.circuit(circuit)? {
            let own = &self.branches[*branch];
            let mut candidate = |block: &'static str, angle: f64, input: f64| {
                if worst.is_none_or(|worst| angle < worst.angle) {
                    worst = Some(WorstTransmission {
                        block,
                        angle,
                        input,
                        branch: *branch,
                    });
                }
            };
            for end in &own.ends {
                let all = self
                    .mechanism
                    .transmission_angles_at(self.line.inputs(end.input), end.unknowns);
                for dyad in all.as_ref() {
                    candidate(dyad.block, dyad.folded(), end.input);
                }
            }
            for dyad in 0..dyads {
                let mut block = "";
                let value = |input: f64| {
                    let near = self.position_on(*branch, input)?;
                    let motions = self
                        .pose_on(*branch, input)?
                        .unknown_motions_near(Row::from_fn(|unknown| near[unknown]));
                    let inputs = self.line.inputs(input);
                    let angles = series.transmission_angles_at(
                        Row::from_fn(|index| Series::from_coefficients([inputs[index], self.line.direction[index]])),
                        Row::from_fn(|index| {
                            let rate = motions[index].as_ref().get(1).copied().unwrap_or(0.0);
                            Series::from_coefficients([near[index], rate])
                        }),
                    );
                    block = angles[dyad].block;
                    Ok(angles[dyad].angle.coefficients())
                };
                for (input, angle) in extremes(own, value)? {
                    let size = (angle - TAU * Float::round(angle / TAU)).abs();
                    candidate(block, size.min(PI - size), input);
                }
            }
        }
        worst.ok_or(MeasureError::NoDyad)
    }
}

/// The extremes of a function inside a branch, and its values at the first and last of the places between which they are sought: inputs and
/// values. The function gives its value and its derivative.
fn extremes<M: Mechanism<Scalar = f64>>(
    branch: &Branch<M>,
    mut function: impl FnMut(f64) -> Result<[f64; 2], SolveError>,
) -> Result<Vec<(f64, f64)>, MeasureError> {
    let [low, high] = [0, 1].map(|end| branch.ends[end].input);
    let is_turn = branch.is_full_turn();
    let place = |step: u32| {
        let part = f64::from(step) / f64::from(PLACES);
        if is_turn {
            low + (high - low) * part
        } else {
            // With equal steps of this angle, the positions next to a limit move by equal steps.
            let part = (f64::from(step) + 0.5) / (f64::from(PLACES) + 1.0);
            0.5 * (low + high) - 0.5 * (high - low) * Float::cos(PI * part)
        }
    };
    let mut found = Vec::new();
    let mut before: Option<(f64, [f64; 2])> = None;
    for step in 0..=PLACES {
        let input = place(step);
        let own = match function(input) {
            Ok(own) => own,
            // Next to an end, rounding decides.
            Err(_) if !is_turn && (step == 0 || step == PLACES) => continue,
            Err(error) => return Err(error.into()),
        };
        if step == 0 || step == PLACES || own[1] == 0.0 {
            found.push((input, own[0]));
        }
        if let Some((start, first)) = before
            && first[1] * own[1] < 0.0
        {
            found.push(zero(&mut function, (start, first), (input, own))?);
        }
        before = Some((input, own));
    }
    Ok(found)
}

/// The place between two others where the derivative is zero, and the value there, by the Illinois variant of the rule of false position.
/// (M. Dowell and P. Jarratt, A modified regula falsi method for computing the root of an equation, BIT 11 (1971), 168-174.)
fn zero(
    function: &mut impl FnMut(f64) -> Result<[f64; 2], SolveError>,
    (mut low, first): (f64, [f64; 2]),
    (mut high, last): (f64, [f64; 2]),
) -> Result<(f64, f64), MeasureError> {
    let (mut at_low, mut at_high) = (first[1], last[1]);
    let mut best = if at_low.abs() < at_high.abs() {
        (low, first)
    } else {
        (high, last)
    };
    let mut side = 0_i8;
    for step in 0..ITERATIONS {
        let mut middle = (low * at_high - high * at_low) / (at_high - at_low);
        // Every fourth step halves, so that the interval always shrinks.
        if step % 4 == 3 || !(middle > low && middle < high) {
            middle = 0.5 * (low + high);
        }
        if !(middle > low && middle < high) {
            break;
        }
        let own = function(middle)?;
        if own[1].abs() < best.1[1].abs() {
            best = (middle, own);
        }
        if own[1] == 0.0 || (high - low) <= 4.0 * f64::EPSILON * high.abs().max(low.abs()) {
            break;
        }
        if own[1] * at_high < 0.0 {
            (low, at_low) = (middle, own[1]);
            if side == -1 {
                at_high *= 0.5;
            }
            side = -1;
        } else {
            (high, at_high) = (middle, own[1]);
            if side == 1 {
                at_low *= 0.5;
            }
            side = 1;
        }
    }
    Ok((best.0, best.1[0]))
}
