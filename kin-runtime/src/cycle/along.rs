//! A circuit, and the questions to a quantity along it.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;
use core::fmt;
use core::marker::PhantomData;

use super::line::wrapped;
use super::measure::{CircuitExtreme, CircuitPeak, MeasureError, Stroke, WorstTransmission};
use super::station::MeasuredCycle;
use super::{Cycle, SearchedCycle};
use crate::any::{Of, TransmissionOver};
use crate::extremes::{Answer, At, ExtremeKind, ExtremesError, StationQuantity, named_quantity, pose_quantity};
use crate::mechanism::Mechanism;
use crate::picture::TransmissionAngle;
use crate::quantity::Name;

/// The smallest stroke of a quantity that moves, as a part of its largest value, and the shortest way between its ends,
/// as a part of a revolution.
const STILL: f64 = 1e-12;

/// A circuit of a cycle. [`Cycle::along`] makes it; the words are those of a sweep.
///
/// A quantity along a circuit is the same as along a [sweep](crate::extremes) over each of its branches, where the
/// input moves at the speed 1. Angles go on from branch to branch, and so do the quantities that depend on them, as the
/// position of a rack does.
///
/// `C` is the cycle to which it belongs.
#[derive(Clone, Copy)]
pub struct CircuitAlong<'c, C> {
    cycle: MeasuredCycle<'c>,
    circuit: usize,
    of: PhantomData<fn() -> C>,
}

impl<C> fmt::Debug for CircuitAlong<'_, C> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("CircuitAlong")
            .field("circuit", &self.circuit)
            .finish_non_exhaustive()
    }
}

/// A quantity along a circuit. [`CircuitAlong::of`] and [`CircuitAlong::of_expression`] make it, and each of its
/// methods answers a question.
///
/// # Errors
/// For all questions, [`MeasureError::NoSuchCircuit`], and [`MeasureError::Extremes`] if no column has the name, or if
/// the curve of the quantity is too rough to be searched.
#[must_use = "ask for its `stroke`, its `peak` or its `extremes`"]
pub struct QuantityOnCircuit<'c> {
    cycle: MeasuredCycle<'c>,
    circuit: usize,
    quantity: Result<StationQuantity<'c>, ExtremesError>,
}

impl fmt::Debug for QuantityOnCircuit<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("QuantityOnCircuit")
            .field("circuit", &self.circuit)
            .finish_non_exhaustive()
    }
}

impl<M: Mechanism<Scalar = f64>> Cycle<M> {
    /// A circuit by its index, to ask for strokes, time ratios, extremes and transmission angles.
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::FourBar;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let cycle = linkage.cycle()?;
    /// let measures = cycle.along(0);
    /// println!("the rocker swings by {} rad", measures.of("theta4").stroke()?.length());
    /// // for each radian per second of the crank
    /// println!("and has at most {} rad/s", measures.of("theta4_velocity").peak()?.value);
    /// println!("at {} rad the transmission is worst", measures.worst_transmission()?.input);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn along(&self, circuit: usize) -> CircuitAlong<'_, Self> {
        let cycle = MeasuredCycle {
            cycle: &self.searched,
            functions: Of::<M>::FUNCTIONS,
        };
        CircuitAlong::new(cycle, circuit)
    }
}

impl<'c, M: Mechanism<Scalar = f64>> CircuitAlong<'c, Cycle<M>> {
    /// A quantity by a closure: any expression of a pose, as in `|at| at.theta4.jerk()`. See [`At`].
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::FourBar;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let cycle = linkage.cycle()?;
    /// let height = cycle.along(0).of_expression(|at| 60.0 * at.theta4.sin()).highest()?;
    /// println!("{} at {} rad", height.value, height.input);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_expression<A: Answer, F: Fn(&At<M>) -> A + 'c>(&self, expression: F) -> QuantityOnCircuit<'c> {
        self.quantity(Ok(Box::new(move |station| pose_quantity(station, None, &expression))))
    }
}

impl<'c, C> CircuitAlong<'c, C> {
    pub(crate) fn new(cycle: MeasuredCycle<'c>, circuit: usize) -> Self {
        Self {
            cycle,
            circuit,
            of: PhantomData,
        }
    }

    fn quantity(&self, quantity: Result<StationQuantity<'c>, ExtremesError>) -> QuantityOnCircuit<'c> {
        QuantityOnCircuit {
            cycle: self.cycle,
            circuit: self.circuit,
            quantity,
        }
    }

    /// A quantity by the name of its column: `"theta4"`, `"foot.x"`, `"theta4_velocity"`. Rates are those with respect
    /// to the input.
    pub fn of(&self, name: &str) -> QuantityOnCircuit<'c> {
        self.quantity(named_quantity(self.cycle.functions, name))
    }

    /// The smallest transmission angle of all dyads, folded to at most a right angle. It is zero if the circuit has a
    /// limit in which a dyad is stretched or folded.
    ///
    /// # Errors
    /// [`MeasureError::NoDyad`], if the mechanism has none, or if there is no such circuit.
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::FourBar;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let worst = linkage.cycle()?.along(0).worst_transmission()?;
    /// // crank and ground in line: the diagonal is 60 or 120
    /// let angle = |d: f64| ((70.0_f64.powi(2) + 60.0_f64.powi(2) - d * d) / (2.0 * 70.0 * 60.0)).acos();
    /// let expected = angle(60.0).min(std::f64::consts::PI - angle(120.0));
    /// assert!((worst.angle - expected).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn worst_transmission(&self) -> Result<WorstTransmission, MeasureError> {
        let mut worst: Option<WorstTransmission> = None;
        let SearchedCycle { mechanism, line, .. } = self.cycle.cycle;
        let mut all = vec![TransmissionAngle::of("", 0.0, 1.0); mechanism.functions.dyad_count()];
        for station in self.cycle.branch_stations(self.circuit)? {
            let mut candidate = |block: Name, angle: f64, input: f64| {
                if worst.is_none_or(|worst| angle < worst.angle) {
                    worst = Some(WorstTransmission {
                        block,
                        angle,
                        input,
                        branch: station.branch,
                    });
                }
            };
            for end in &self.cycle.branch(station.branch).ends {
                let inputs = line.inputs(end.input);
                let functions: &dyn TransmissionOver<f64> = self.cycle.functions;
                functions.angles_of_dyads(&mechanism.parameters, &inputs, &end.unknowns, &mut all);
                for dyad in &all {
                    candidate(dyad.block, dyad.folded(), end.input);
                }
            }
            for (dyad, transmission) in all.iter().enumerate() {
                let sweep = self.cycle.sweep(&station);
                for extreme in sweep.transmission_extremes(self.cycle.functions, dyad)? {
                    if let Some(angle) = extreme.value {
                        let size = wrapped(angle).abs();
                        candidate(transmission.block, size.min(PI - size), extreme.at);
                    }
                }
            }
        }
        worst.ok_or(MeasureError::NoDyad)
    }
}

impl QuantityOnCircuit<'_> {
    /// All extremes, branch by branch in the order of the circuit: those inside, those at limits and kinks, and those
    /// at the ends of branches.
    ///
    /// # Errors
    /// As for all [questions](Self).
    pub fn extremes(&self) -> Result<Vec<CircuitExtreme>, MeasureError> {
        let stations = self.cycle.branch_stations(self.circuit)?;
        let quantity = self.quantity.as_ref().map_err(Clone::clone)?;
        let mut all = Vec::new();
        for station in stations {
            let extremes = self.cycle.sweep(&station).extremes_of(quantity)?;
            let branch = station.branch;
            all.extend(extremes.into_iter().map(|extreme| CircuitExtreme { branch, extreme }));
        }
        Ok(all)
    }

    /// The value that is largest in size, and where.
    ///
    /// # Errors
    /// [`ExtremesError::Unbounded`] if the quantity has none.
    pub fn peak(&self) -> Result<CircuitPeak, MeasureError> {
        let Stroke { low, high } = self.stroke()?;
        Ok(if low.value.abs() > high.value.abs() { low } else { high })
    }

    /// The highest value, and where.
    ///
    /// # Errors
    /// [`ExtremesError::Unbounded`] if the quantity grows beyond all bounds.
    pub fn highest(&self) -> Result<CircuitPeak, MeasureError> {
        Ok(self.stroke()?.high)
    }

    /// The lowest value, and where.
    ///
    /// # Errors
    /// As for [`highest`](Self::highest).
    pub fn lowest(&self) -> Result<CircuitPeak, MeasureError> {
        Ok(self.stroke()?.low)
    }

    /// The smallest and the largest value.
    ///
    /// # Errors
    /// [`ExtremesError::Unbounded`] if the quantity grows beyond all bounds.
    ///
    /// ```
    /// use kin_core::cycle::FullCycle;
    /// use kin_core::library::SliderCrank;
    ///
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// let stroke = press.cycle()?.along(0).of("s").stroke()?;
    /// assert!((stroke.length() - 0.2).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn stroke(&self) -> Result<Stroke, MeasureError> {
        self.range().map(|(stroke, _)| stroke)
    }

    /// The stroke, and whether both of its ends lie inside of branches or at their limits, so that the quantity
    /// reverses there.
    fn range(&self) -> Result<(Stroke, bool), MeasureError> {
        let mut range: Option<(Stroke, [ExtremeKind; 2])> = None;
        for CircuitExtreme { branch, extreme } in self.extremes()? {
            let input = extreme.at;
            let value = extreme.value.ok_or(ExtremesError::Unbounded { at: input })?;
            let peak = CircuitPeak { value, input, branch };
            let (stroke, kinds) = range.get_or_insert((Stroke { low: peak, high: peak }, [extreme.kind; 2]));
            if value < stroke.low.value {
                (stroke.low, kinds[0]) = (peak, extreme.kind);
            }
            if value > stroke.high.value {
                (stroke.high, kinds[1]) = (peak, extreme.kind);
            }
        }
        let (stroke, kinds) = range.ok_or(MeasureError::NoSuchCircuit)?;
        Ok((stroke, !kinds.contains(&ExtremeKind::End)))
    }

    /// The time ratio of a quick return, at a constant speed of the input: the longer of the ways of the input between
    /// the smallest and the largest value, divided by the shorter one. It is 1 or more.
    ///
    /// # Errors
    /// [`MeasureError::NoFullRevolution`], if the input does not make one revolution along the circuit,
    /// [`MeasureError::NoReturn`], if the quantity makes full revolutions or stays constant; otherwise as for
    /// [`stroke`](Self::stroke).
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
    /// assert!((cycle.along(0).of("theta4").time_ratio()? - expected).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn time_ratio(&self) -> Result<f64, MeasureError> {
        let [branch] = self.cycle.circuit(self.circuit)? else {
            return Err(MeasureError::NoFullRevolution);
        };
        let branch = self.cycle.branch(*branch);
        if !branch.is_full_revolution() {
            return Err(MeasureError::NoFullRevolution);
        }
        let revolution = branch.ends[1].input - branch.ends[0].input;
        let (stroke, returns) = self.range()?;
        let way = (stroke.high.input - stroke.low.input).abs();
        let [short, long] = [way.min(revolution - way), way.max(revolution - way)];
        let (low, high) = (stroke.low.value, stroke.high.value);
        let is_still = stroke.length() <= STILL * low.abs().max(high.abs()) || short <= STILL * revolution;
        if !returns || is_still {
            return Err(MeasureError::NoReturn { low, high });
        }
        Ok(long / short)
    }
}
