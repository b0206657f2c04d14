//! What a designer reads off a circuit: strokes, ratios of times and the worst transmission angle.

use alloc::vec;
use core::error::Error;
use core::f64::consts::PI;
use core::fmt;

use super::Cycle;
use super::line::turned;
use super::station::MeasuredCycle;
use crate::any::{Of, OutputsOver, TransmissionOver};
use crate::extremes::{ExtremeKind, ExtremesError, NamedFunctions};
use crate::mechanism::Mechanism;
use crate::picture::TransmissionAngle;
use crate::quantity::Digits;
use crate::sweep::SweptMechanism;

/// The smallest stroke of a quantity that moves, as a part of its largest value, and the shortest way between its ends, as a part of a turn.
const STILL: f64 = 1e-12;

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
    /// The search for extremes along a branch has no answer.
    Extremes(ExtremesError),
}

impl fmt::Display for MeasureError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
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
            Self::Extremes(error) => error.fmt(formatter),
        }
    }
}

crate::__debug_by_display!(MeasureError);

impl Error for MeasureError {}

impl From<ExtremesError> for MeasureError {
    fn from(error: ExtremesError) -> Self {
        Self::Extremes(error)
    }
}

/// What quantities along branches need of a mechanism.
pub trait MeasuredFunctions: SweptMechanism + NamedFunctions + OutputsOver<f64> + TransmissionOver<f64> {}

impl<F: SweptMechanism + NamedFunctions + OutputsOver<f64> + TransmissionOver<f64>> MeasuredFunctions for F {}

impl<M: Mechanism<Scalar = f64>> Cycle<M> {
    /// The smallest and the largest value of a quantity along a circuit, called by the name of its column: `"theta4"`, `"foot.x"`,
    /// `"theta4_velocity"`. Rates are those with respect to the input.
    ///
    /// They are the [extremes](crate::extremes) of a sweep along each branch, where angles go on from branch to branch, and so do the
    /// quantities that depend on them, as the position of a rack does.
    ///
    /// # Errors
    /// [`MeasureError::NoSuchCircuit`], and [`MeasureError::Extremes`] if there is no such quantity, or if it grows beyond all bounds.
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
        self.measured().stroke(circuit, name)
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
        self.measured().time_ratio(circuit, name)
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
        self.measured().worst_transmission(circuit)
    }

    fn measured(&self) -> MeasuredCycle<'_> {
        MeasuredCycle {
            cycle: &self.searched,
            functions: Of::<M>::FUNCTIONS,
        }
    }
}

impl MeasuredCycle<'_> {
    pub(crate) fn stroke(&self, circuit: usize, name: &str) -> Result<Stroke, MeasureError> {
        self.range(circuit, name).map(|(stroke, _)| stroke)
    }

    /// The stroke of a quantity, and whether both of its ends lie inside of branches or at their limits, so that the quantity turns there.
    fn range(&self, circuit: usize, name: &str) -> Result<(Stroke, bool), MeasureError> {
        let mut range: Option<(Stroke, [ExtremeKind; 2])> = None;
        for station in self.branch_stations(circuit)? {
            for extreme in self.sweep(&station).extremes(self.functions, name)? {
                let value = extreme.value.ok_or(ExtremesError::Unbounded { at: extreme.at })?;
                let own = StrokeEnd {
                    value,
                    input: extreme.at,
                    branch: station.branch,
                };
                let (stroke, kinds) = range.get_or_insert((Stroke { low: own, high: own }, [extreme.kind; 2]));
                if value < stroke.low.value {
                    (stroke.low, kinds[0]) = (own, extreme.kind);
                }
                if value > stroke.high.value {
                    (stroke.high, kinds[1]) = (own, extreme.kind);
                }
            }
        }
        let (stroke, kinds) = range.ok_or(MeasureError::NoSuchCircuit)?;
        Ok((stroke, !kinds.contains(&ExtremeKind::End)))
    }

    pub(crate) fn time_ratio(&self, circuit: usize, name: &str) -> Result<f64, MeasureError> {
        let [branch] = self.circuit(circuit)? else {
            return Err(MeasureError::NoFullTurn);
        };
        let branch = self.branch(*branch);
        if !branch.is_full_turn() {
            return Err(MeasureError::NoFullTurn);
        }
        let turn = branch.ends[1].input - branch.ends[0].input;
        let (stroke, returns) = self.range(circuit, name)?;
        let way = (stroke.high.input - stroke.low.input).abs();
        let [short, long] = [way.min(turn - way), way.max(turn - way)];
        let (low, high) = (stroke.low.value, stroke.high.value);
        let is_still = stroke.length() <= STILL * low.abs().max(high.abs()) || short <= STILL * turn;
        if !returns || is_still {
            return Err(MeasureError::NoReturn { low, high });
        }
        Ok(long / short)
    }

    pub(crate) fn worst_transmission(&self, circuit: usize) -> Result<WorstTransmission, MeasureError> {
        let mut worst: Option<WorstTransmission> = None;
        let mechanism = &self.cycle.mechanism;
        let mut all = vec![TransmissionAngle::of("", 0.0, 1.0); mechanism.functions.dyad_count()];
        for station in self.branch_stations(circuit)? {
            let mut candidate = |block: &'static str, angle: f64, input: f64| {
                if worst.is_none_or(|worst| angle < worst.angle) {
                    worst = Some(WorstTransmission {
                        block,
                        angle,
                        input,
                        branch: station.branch,
                    });
                }
            };
            for end in &self.branch(station.branch).ends {
                let inputs = self.cycle.line.inputs(end.input);
                let functions: &dyn TransmissionOver<f64> = self.functions;
                functions.angles_of_dyads(&mechanism.parameters, &inputs, &end.unknowns, &mut all);
                for dyad in &all {
                    candidate(dyad.block, dyad.folded(), end.input);
                }
            }
            for (dyad, transmission) in all.iter().enumerate() {
                for extreme in self.sweep(&station).transmission_extremes(self.functions, dyad)? {
                    if let Some(angle) = extreme.value {
                        let size = turned(angle).abs();
                        candidate(transmission.block, size.min(PI - size), extreme.at);
                    }
                }
            }
        }
        worst.ok_or(MeasureError::NoDyad)
    }
}
