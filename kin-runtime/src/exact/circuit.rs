//! Tables of whole circuits, through their limits.
//!
//! Where an input reverses, the unknowns are a root of it. As in [`track`](crate::track()), the quantity that moves
//! fastest is the local parameter there, and the input one of the unknowns: with it the curve is as smooth as anywhere.
//! The length of the arc joins all local parameters into one.

use alloc::boxed::Box;
use alloc::string::ToString as _;
use alloc::vec;
use alloc::vec::Vec;
use core::cell::RefCell;
use core::f64::consts::TAU;

use num_traits::Float;

use super::ExactTableError;
use super::owned::ExactTable;
use super::precision::Precision;
use super::refine::{Frame, Source, Station, refined};
use crate::any::{ClosureOver, Of};
use crate::curve::{CurveFunctions, LentRows, Way, WayPoint, bordered, corrected, expanded, fastest, rates};
use crate::failure::Failure;
use crate::law::Side;
use crate::mechanism::{HeapMemory, Mechanism};
use crate::number::{GAUSS, Number};
use crate::quantity::{Dimension, Quantity};
use crate::sweep::{Local, StraightLine, Sweep, Variable, Walk, composed};

/// The number of terms of the series along the curve.
const TERMS: usize = 5;
/// The longest step along the curve.
const LONGEST_STEP: f64 = 0.4;
/// The shortest first piece. A shorter one would only bring rounding into the derivatives, and is made where the
/// tolerance needs it.
const THINNEST: f64 = 0.1;
/// The shortest step. Where even this is too long, the curve has no single direction.
const SHORTEST_STEP: f64 = 1e-7;
/// The largest number of steps around a circuit.
const MOST_STEPS: usize = 100_000;
/// The cosine of the angle by which the direction of the curve may change in a step.
const STRAIGHT: f64 = 0.9;
/// The smallest share of the local parameter in the direction of the curve, in a step.
const SHARE: f64 = 0.3;
/// The largest distance between prediction and correction, for each unit of a step.
const CORRECTION: f64 = 0.05;
/// The largest distance of the end of a circuit from its beginning.
const NOISE: f64 = 1e-9;
/// The largest number of corrections of the length of an arc.
const CORRECTIONS: usize = 16;
/// The largest number of revolutions of an input after which the inputs may be where they were.
const MOST_REVOLUTIONS: u32 = 12;
/// The longest piece over which the length of the arc is integrated at once. An error of 10⁻¹² would be one of 10⁻³ in
/// a derivative of order 4 of a short piece of the table.
const PIECE: f64 = 0.05;
/// The distance of the parameters at which rows may stand. The lengths of pieces between them are not rounded.
const GRID: f64 = 1.0 / 65_536.0;

/// A point of the curve. Its coordinates are the unknowns and the travel of the inputs, in their sizes.
#[derive(Clone)]
struct Point {
    coordinates: Vec<f64>,
    /// The coordinate that is the local parameter.
    leading: usize,
    /// The series of each coordinate in the local parameter.
    series: Vec<Local>,
    /// Whether the local parameter grows along the curve, 1 or -1.
    direction: f64,
    /// The sign of the Jacobian with the direction of the curve as a further row. It changes where branches cross.
    orientation: f64,
}

impl Point {
    /// The derivatives of the coordinates with respect to the local parameter.
    fn rates(&self) -> Vec<f64> {
        self.series.iter().map(|series| series.coefficients()[1]).collect()
    }

    /// The direction of the curve.
    fn tangent(&self) -> Vec<f64> {
        let rates = self.rates();
        let factor = self.direction / length(&rates);
        rates.into_iter().map(|rate| factor * rate).collect()
    }

    /// The local parameter as a series in the length of the arc.
    fn by_arc(&self) -> Local {
        // the change of the length with the parameter is the length of the rates; all terms of its integral are known
        let mut speed = Local::constant(0.0);
        for series in &self.series {
            let coefficients = series.coefficients();
            let mut rate = [0.0; TERMS];
            let mut order = 0.0;
            for (rate, coefficient) in rate.iter_mut().zip(&coefficients[1..]) {
                order += 1.0;
                *rate = order * coefficient;
            }
            let rate = Local::from_coefficients(rate);
            speed = speed + rate * rate;
        }
        let speed = speed
            .sqrt()
            .coefficients()
            .map(|coefficient| self.direction * coefficient);
        let [a, b, c, d] = [speed[0], speed[1] / 2.0, speed[2] / 3.0, speed[3] / 4.0];
        // the inverse of a series (Abramowitz and Stegun, 3.6.25)
        let e = 1.0 / a;
        let (b, c, d) = (b * e, c * e, d * e);
        Local::from_coefficients([
            0.0,
            e,
            -b * e * e,
            (2.0 * b * b - c) * e * e * e,
            (5.0 * b * c - d - 5.0 * b * b * b) * e * e * e * e,
        ])
    }
}

fn length(vector: &[f64]) -> f64 {
    Float::sqrt(dot(vector, vector))
}

/// The numbers, if all of them are finite.
fn finite(numbers: &[f64]) -> Option<&[f64]> {
    numbers.iter().all(|number| number.is_finite()).then_some(numbers)
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// A series at a change of its variable.
fn value(series: &Local, change: f64) -> f64 {
    series
        .coefficients()
        .iter()
        .rev()
        .fold(0.0, |sum, coefficient| sum * change + coefficient)
}

/// The functions of a mechanism that a circuit needs.
trait CircuitFunctions: CurveFunctions + ClosureOver<Local> {}

impl<F: CurveFunctions + ClosureOver<Local>> CircuitFunctions for F {}

/// The curve of all positions on which a pose lies.
struct CircuitCurve<'c> {
    functions: &'c dyn CircuitFunctions,
    way: Way<'c>,
    /// Memory for parameters, inputs, unknowns and residuals as series, in which the parameters stand.
    series: RefCell<Vec<Local>>,
    scratch: RefCell<LentRows<'c>>,
    /// The input of the sweep.
    lead: usize,
    /// The inputs that move.
    moving: Vec<usize>,
    /// The travel after which the inputs are where they were, if all that move are angles.
    period: Option<f64>,
    /// The orders of a column.
    orders: usize,
}

/// The travel after which every moving input has made whole revolutions, which are so many for each unit of the travel.
fn period(revolutions: &[f64]) -> Option<f64> {
    let fastest = revolutions
        .iter()
        .fold(0.0, |fastest: f64, revolutions| fastest.max(revolutions.abs()));
    let is_whole = |revolutions: f64| (revolutions - Float::round(revolutions)).abs() <= NOISE;
    let periods = (1..=MOST_REVOLUTIONS).map(|count| f64::from(count) / fastest);
    let mut whole = periods.filter(|period| revolutions.iter().all(|revolutions| is_whole(revolutions * period)));
    whole.next()
}

impl CircuitCurve<'_> {
    fn unknowns(&self, coordinates: &[f64]) -> Vec<f64> {
        let values = coordinates.iter().zip(self.way.sizes);
        values.map(|(value, size)| value * size).collect()
    }

    /// The input of the sweep at a point of the curve.
    fn input(&self, coordinates: &[f64]) -> f64 {
        self.way.input(coordinates[self.way.count()], self.lead)
    }

    /// The point on the curve with the same leading coordinate.
    fn corrected(&self, coordinates: &[f64], leading: usize) -> Option<Vec<f64>> {
        let (way, mut scratch) = (&self.way, self.scratch.borrow_mut());
        let start = WayPoint {
            unknowns: &self.unknowns(coordinates),
            travel: coordinates[way.count()],
        };
        let found = corrected(way, start, leading, &mut scratch.scope())?;
        let unknowns = found.unknowns.iter().zip(way.sizes).map(|(value, size)| value / size);
        Some(unknowns.chain([found.travel]).collect())
    }

    /// The rates of all coordinates by the leading one, at a point of the curve.
    fn rates(&self, coordinates: &[f64], leading: usize) -> Option<Vec<f64>> {
        let (way, mut scratch) = (&self.way, self.scratch.borrow_mut());
        let mut scope = scratch.scope();
        let point = WayPoint {
            unknowns: &self.unknowns(coordinates),
            travel: coordinates[way.count()],
        };
        let linear = way.linearise(point, &mut scope)?;
        let system = bordered(&linear, leading, &mut scope);
        finite(rates(&linear, leading, &system, &mut scope)).map(<[f64]>::to_vec)
    }

    /// The curve close to a point, in the direction of `ahead`.
    fn point(&self, coordinates: &[f64], leading: usize, ahead: &[f64]) -> Option<Point> {
        let coordinates = self.corrected(coordinates, leading)?;
        let (way, mut scratch) = (&self.way, self.scratch.borrow_mut());
        let mut scope = scratch.scope();
        let point = WayPoint {
            unknowns: &self.unknowns(&coordinates),
            travel: coordinates[way.count()],
        };
        let linear = way.linearise(point, &mut scope)?;
        let mut system = bordered(&linear, leading, &mut scope);
        let fastest = fastest(finite(rates(&linear, leading, &system, &mut scope))?);
        if fastest != leading {
            system = bordered(&linear, fastest, &mut scope);
        }
        let leading = fastest;
        let mut memory = self.series.borrow_mut();
        let equations = (&linear, leading, &system);
        let travel = expanded::<TERMS>(way, (self.functions, &mut memory), point, equations, &mut scope);
        let unknowns = way.unknowns(&mut memory[..]).iter().zip(way.sizes);
        let unknowns = unknowns.map(|(series, size)| {
            Local::from_coefficients(series.coefficients().map(|coefficient| coefficient / size))
        });
        let series: Vec<Local> = unknowns.chain([travel]).collect();
        let mut coefficients = series.iter().flat_map(Local::coefficients);
        if !coefficients.all(f64::is_finite) {
            return None;
        }
        let rates: Vec<f64> = series.iter().map(|series| series.coefficients()[1]).collect();
        let direction = dot(&rates, ahead).signum();
        Some(Point {
            coordinates,
            leading,
            series,
            direction,
            // the column of the travel stands in that of the leading coordinate, an exchange of two columns
            orientation: system.orientation().sign * if leading == way.count() { direction } else { -direction },
        })
    }

    /// A point near the curve, after a change of the local parameter.
    fn predicted(from: &Point, change: f64) -> Vec<f64> {
        let mut coordinates: Vec<f64> = from.series.iter().map(|series| value(series, change)).collect();
        coordinates[from.leading] = from.coordinates[from.leading] + change;
        coordinates
    }

    /// The change of the length of the arc with the local parameter, after a change of it.
    fn speed(&self, from: &Point, change: f64) -> Option<f64> {
        let coordinates = self.corrected(&Self::predicted(from, change), from.leading)?;
        Some(length(&self.rates(&coordinates, from.leading)?))
    }

    /// The length of the arc from a point to the one after a change of the local parameter, along the curve.
    fn arc(&self, from: &Point, change: f64) -> Option<f64> {
        let pieces = Float::ceil(change.abs() / PIECE).max(1.0);
        let half = 0.5 * change / pieces;
        let mut sum = 0.0;
        let mut middle = half;
        while (middle - change) * change < 0.0 {
            for (node, weight) in GAUSS {
                for node in [node, -node] {
                    sum += weight * self.speed(from, middle + node * half)?;
                }
            }
            middle += 2.0 * half;
        }
        Some(sum * half * from.direction)
    }

    /// The point after a length of the arc.
    fn advanced(&self, from: &Point, way: f64) -> Option<Point> {
        let mut change = value(&from.by_arc(), way);
        let mut previous = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let missing = way - self.arc(from, change)?;
            if missing.abs() <= f64::EPSILON * way.abs() || missing.abs() >= 0.5 * previous {
                break;
            }
            previous = missing.abs();
            change += from.direction * missing / self.speed(from, change)?;
        }
        self.point(&Self::predicted(from, change), from.leading, &from.tangent())
    }

    /// The columns at a point, in all orders by the length of the arc.
    fn station(&self, at: f64, point: Point) -> Station<Point> {
        let (way, parameter) = (&self.way, point.by_arc());
        let derivatives = |index: usize, size: f64| {
            let series = composed(point.series[index], parameter) * Local::constant(size);
            series.derivatives()
        };
        let mut numbers = Vec::new();
        for input in &self.moving {
            let rates = derivatives(way.count(), way.slope(*input));
            numbers.push(way.input(point.coordinates[way.count()], *input));
            numbers.extend(&rates[1..self.orders]);
        }
        for (index, size) in way.sizes.iter().enumerate() {
            numbers.extend(&derivatives(index, *size)[..self.orders]);
        }
        Station {
            at,
            numbers,
            near: point,
        }
    }

    /// The error of a curve that cannot be followed beyond a station.
    fn lost(&self, station: &Station<Point>) -> ExactTableError {
        ExactTableError::Lost {
            input: self.input(&station.near.coordinates),
            length: station.at,
        }
    }

    /// The next station, at most at a distance.
    fn next(&self, from: &Station<Point>, longest: f64) -> Result<Station<Point>, ExactTableError> {
        let here = &from.near;
        let tangent = here.tangent();
        let input = self.input(&here.coordinates);
        let mut way = longest;
        loop {
            if way < SHORTEST_STEP {
                return Err(ExactTableError::ChangePoint { input });
            }
            let change = value(&here.by_arc(), way);
            let predicted = Self::predicted(here, change);
            let found = self.point(&predicted, here.leading, &tangent).filter(|there| {
                let ahead = there.tangent();
                let distances = there
                    .coordinates
                    .iter()
                    .zip(&predicted)
                    .map(|(one, other)| (one - other).abs());
                change * here.direction > 0.0
                    && dot(&tangent, &ahead) >= STRAIGHT
                    && ahead[here.leading] * here.direction >= SHARE
                    && distances.fold(0.0, f64::max) <= CORRECTION * way
            });
            if let Some(there) = found
                && let Some(arc) = self.arc(here, change)
            {
                if there.orientation != here.orientation {
                    return Err(ExactTableError::ChangePoint { input });
                }
                return Ok(self.station(from.at + arc, there));
            }
            way *= 0.5;
        }
    }

    /// The last parameter of the grid between two stations.
    fn on_grid(&self, from: &Station<Point>, there: Station<Point>) -> Station<Point> {
        let at = GRID * Float::floor(there.at / GRID);
        let is_between = at > from.at && at < there.at;
        let point = is_between.then(|| self.advanced(&from.near, at - from.at)).flatten();
        point.map_or(there, |point| self.station(at, point))
    }

    /// Whether the solvers find this point as well. Near a limit they may not.
    fn confirm(&self, station: &Station<Point>) -> Result<(), ExactTableError> {
        let point = &station.near;
        let (way, unknowns) = (&self.way, self.unknowns(&point.coordinates));
        let mut scratch = self.scratch.borrow_mut();
        let solved = way.position_near(point.coordinates[way.count()], &unknowns, &mut scratch.scope());
        match solved.map(<[f64]>::to_vec) {
            Ok(found) => {
                let is_near = way.description.unknowns.iter().enumerate().all(|(index, unknown)| {
                    let mut change = (found[index] - unknowns[index]) / way.sizes[index];
                    if unknown.dimension == Dimension::Angle {
                        change -= TAU * Float::round(change / TAU);
                    }
                    change.abs() <= 0.1
                });
                if is_near { Ok(()) } else { Err(self.lost(station)) }
            }
            Err(error) => match error.failure {
                Failure::OutOfReach { .. } | Failure::Singular { .. } | Failure::NotConverged { .. } => Ok(()),
                _ => Err(ExactTableError::NotClosed {
                    at: self.input(&point.coordinates),
                    error: Box::new(error),
                }),
            },
        }
    }

    /// The whole periods by which a point differs from the start, and the rest of the difference.
    fn periods_between(&self, start: &Point, coordinates: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let unknowns = self.way.description.unknowns.iter();
        let periods = unknowns.map(|unknown| (unknown.dimension == Dimension::Angle).then_some(TAU));
        let differences = coordinates
            .iter()
            .zip(&start.coordinates)
            .zip(periods.chain([self.period]));
        differences
            .map(|((one, other), period)| {
                let whole = period.map_or(0.0, |period| period * Float::round((one - other) / period));
                (whole, one - other - whole)
            })
            .unzip()
    }

    /// The start again, if it lies between two stations.
    fn back(&self, start: &Station<Point>, [here, there]: [&Station<Point>; 2]) -> Option<Station<Point>> {
        let tangent = start.near.tangent();
        let (_, before) = self.periods_between(&start.near, &here.near.coordinates);
        let (whole, behind) = self.periods_between(&start.near, &there.near.coordinates);
        let passes = dot(&before, &tangent) < 0.0 && dot(&behind, &tangent) >= 0.0;
        let is_near = length(&before).max(length(&behind)) <= 2.0 * LONGEST_STEP;
        let goes_on = dot(&there.near.tangent(), &tangent) > 0.0;
        if !(passes && is_near && goes_on) {
            return None;
        }
        let leading = here.near.leading;
        let end: Vec<f64> = start
            .near
            .coordinates
            .iter()
            .zip(&whole)
            .map(|(value, whole)| value + whole)
            .collect();
        let change = end[leading] - here.near.coordinates[leading];
        let found = self.corrected(&Self::predicted(&here.near, change), leading)?;
        let distances = found.iter().zip(&end).map(|(one, other)| (one - other).abs());
        if distances.fold(0.0, f64::max) > NOISE {
            return None;
        }
        let mut station = start.clone();
        station.at = here.at + self.arc(&here.near, change)?;
        station.near.coordinates.clone_from(&end);
        for (series, value) in station.near.series.iter_mut().zip(&end) {
            let mut coefficients = series.coefficients();
            coefficients[0] = *value;
            *series = Local::from_coefficients(coefficients);
        }
        // the values after the whole periods, the derivatives as they are
        let again = self.station(station.at, station.near.clone());
        for (kept, again) in station
            .numbers
            .chunks_mut(self.orders)
            .zip(again.numbers.chunks(self.orders))
        {
            kept[0] = again[0];
        }
        Some(station)
    }

    /// Pairs of neighbouring stations around the whole circuit, from a point in the direction of the inputs.
    fn around(&self, coordinates: &[f64]) -> Result<Vec<[Station<Point>; 2]>, ExactTableError> {
        let (input, travel) = (self.input(coordinates), self.way.count());
        let mut ahead = vec![0.0; coordinates.len()];
        ahead[travel] = 1.0;
        let start = self.point(coordinates, travel, &ahead);
        let start = self.station(0.0, start.ok_or(ExactTableError::ChangePoint { input })?);
        let mut stations = vec![start.clone()];
        let mut here = start.clone();
        let mut longest = LONGEST_STEP;
        for _ in 0..MOST_STEPS {
            let there = self.next(&here, longest)?;
            let there = self.on_grid(&here, there);
            if let Some(end) = self.back(&start, [&here, &there]) {
                while stations.len() > 1 && stations.last().is_some_and(|last| end.at - last.at < THINNEST) {
                    stations.pop();
                }
                stations.push(end);
                let pairs = stations.windows(2);
                return Ok(pairs.map(|pair| [pair[0].clone(), pair[1].clone()]).collect());
            }
            self.confirm(&there)?;
            longest = LONGEST_STEP.min(2.0 * (there.at - here.at));
            if stations.last().is_none_or(|last| there.at - last.at >= THINNEST) {
                stations.push(there.clone());
            }
            here = there;
        }
        Err(self.lost(&here))
    }
}

impl Source for CircuitCurve<'_> {
    type Near = Point;

    fn columns(&self) -> Vec<Quantity<'_>> {
        let description = self.way.description;
        let inputs = self.moving.iter().map(|input| description.inputs[*input]);
        inputs.chain(description.unknowns.iter().copied()).collect()
    }

    fn station(&self, at: f64, _: Side, from: &Station<Point>) -> Result<Station<Point>, ExactTableError> {
        let mut here = from.clone();
        loop {
            // as far as one local parameter leads
            let rest = at - here.at;
            let there = self.next(&here, rest)?;
            if there.at - here.at > 0.75 * rest {
                let point = self.advanced(&here.near, rest);
                return point.map_or_else(|| Err(self.lost(&here)), |point| Ok(self.station(at, point)));
            }
            here = there;
        }
    }
}

impl<M: Mechanism<Scalar = f64>> Sweep<M, StraightLine> {
    /// The whole circuit as an [`ExactTable`]: from the beginning of the range in its direction, on through the limits
    /// where the input reverses, until the motion has come back to its start. So one closed table holds both assemblies
    /// between two limits.
    ///
    /// The parameter is the length of the arc, `arc`: the root of the sum of the squares of all ways of the unknowns
    /// and the moving input (of several, the one that moves farthest), angles in radians and lengths in units of the
    /// longest link. It is smooth where the input reverses. A mechanism that is shown at a constant speed of the arc
    /// moves evenly. The columns are the inputs that move and the unknowns, in this order. Outputs are not among them:
    /// at a limit the solver has none of their derivatives. A quantity that is declared as an unknown with a separate
    /// equation is a column.
    ///
    /// The errors are measured against the closure, which is well-conditioned at limits with the fastest quantity as
    /// its parameter; `solve` is not. Away from limits both are the same.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// // the crank swings between limits at ±112.02°
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let table = linkage.sweep(Assembly::Open).over(0.9..=1.0, 2).exact_circuit(1e-6)?;
    /// let crank = table.column("theta2")?;
    /// let period = table.period().expect("the table is closed");
    /// let highest = (0..1000).map(|step| crank.at(period * f64::from(step) / 1000.0).map(|[angle]| angle));
    /// let highest = highest.collect::<Result<Vec<f64>, _>>()?.into_iter().fold(0.0, f64::max);
    /// assert!((highest.to_degrees() - 112.0243).abs() < 1e-2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ExactTableError::NotClosed`] if the mechanism does not close at the beginning, or the motion leads to the end
    /// of the domain of a function, [`ExactTableError::ChangePoint`] where branches cross, [`ExactTableError::Lost`] if
    /// the motion does not come back, and the errors of [`exact_table`](Self::exact_table).
    pub fn exact_circuit(&self, precision: impl Into<Precision>) -> Result<ExactTable, ExactTableError> {
        let precision = precision.into();
        let sweep = self.any();
        sweep.check()?;
        let order = precision.order_of(sweep.description)?;
        let closed = |error| ExactTableError::NotClosed {
            at: self.from,
            error: Box::new(error),
        };
        let mut walk = Walk::BEGINNING;
        let reached = walk
            .step(&sweep, self.from, &sweep.motions(self.from))
            .map_err(closed)?;
        let unknowns = reached.unknowns();
        // a sweep of one point has a direction as well
        let end = if self.to == self.from { self.from + 1.0 } else { self.to };
        let [from, to] = [self.from, end].map(|at| sweep.inputs(at));
        let mut memory = HeapMemory::new(sweep.description, sweep.parameters.len());
        let functions = Of::<M>::FUNCTIONS;
        let (way, scratch) = Way::new(functions, &sweep.parameters, [&from, &to], &unknowns, memory.lend());
        let parameters = sweep.parameters.iter().copied().map(Local::constant);
        let others = from.len() + 2 * unknowns.len();
        let series = parameters
            .chain(core::iter::repeat_n(Local::constant(0.0), others))
            .collect();
        let moving: Vec<usize> = (0..from.len()).filter(|input| from[*input] != to[*input]).collect();
        let is_angle = |input: &usize| sweep.description.inputs[*input].dimension == Dimension::Angle;
        let revolutions: Vec<f64> = moving.iter().map(|input| way.slope(*input) / TAU).collect();
        let curve = CircuitCurve {
            functions,
            series: RefCell::new(series),
            scratch: RefCell::new(scratch),
            // the variable of a line is always an input
            lead: match sweep.drive.variable() {
                Variable::Input(lead) => lead,
                _ => 0,
            },
            period: moving.iter().all(is_angle).then(|| period(&revolutions)).flatten(),
            moving,
            orders: order + 1,
            way,
        };
        let start = unknowns.iter().zip(curve.way.sizes).map(|(value, size)| value / size);
        let stations = curve.around(&start.chain([0.0]).collect::<Vec<f64>>())?;
        let frame = Frame {
            name: M::DESCRIPTION.name.to_string(),
            parameter: ("arc".to_string(), Dimension::Scalar),
            order,
            may_close: true,
        };
        refined(&curve, frame, stations, precision)
    }
}
