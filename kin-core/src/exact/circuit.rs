//! Tables of whole circuits, through their limits.
//!
//! Where an input turns back, the unknowns are a root of it. As in [`track`](crate::track()), the quantity that moves fastest is the local
//! parameter there, and the input one of the unknowns: with it the curve is as smooth as anywhere. The length of the arc joins all local
//! parameters into one.

use alloc::boxed::Box;
use alloc::string::ToString as _;
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;

use num_traits::Float;

use super::ExactTableError;
use super::factors::CurveFactors;
use super::owned::ExactTable;
use super::precision::Precision;
use super::refine::{Frame, Source, Station, refined};
use crate::any::{AnyMechanism, ClosureOver, Of};
use crate::failure::Failure;
use crate::law::Side;
use crate::mechanism::{Mechanism, Sizes};
use crate::number::{GAUSS, Number};
use crate::quantity::{Dimension, Quantity};
use crate::sweep::{Course, Drive, Local, READ, SmoothDrive, StraightLine, Variable, Walk, composed};

/// The number of terms of the series along the curve.
const TERMS: usize = 5;
/// The longest step along the curve.
const LONGEST: f64 = 0.4;
/// The shortest first piece. A shorter one would only bring rounding into the derivatives, and is made where the tolerance needs it.
const THINNEST: f64 = 0.1;
/// The shortest step. Where even this is too long, the curve has no single direction.
const SHORTEST: f64 = 1e-7;
/// The largest number of steps around a circuit.
const MOST_STEPS: usize = 100_000;
/// The cosine of the angle by which the curve may turn in a step.
const TURN: f64 = 0.9;
/// The smallest share of the local parameter in the direction of the curve, in a step.
const SHARE: f64 = 0.3;
/// The largest distance between prediction and correction, for each unit of a step.
const CORRECTION: f64 = 0.05;
/// The largest distance of a corrected point to the curve.
const NOISE: f64 = 1e-9;
/// The largest number of corrections.
const CORRECTIONS: usize = 16;
/// The longest piece over which the length of the arc is integrated at once. An error of 10⁻¹² would be one of 10⁻³ in a derivative of order 4
/// of a short piece of the table.
const PIECE: f64 = 0.05;
/// The distance of the places at which rows may stand. The lengths of pieces between them are not rounded.
const GRID: f64 = 1.0 / 65_536.0;

/// A point of the curve. Its coordinates are the moving input and the unknowns, in their sizes.
#[derive(Clone)]
struct Point {
    place: Vec<f64>,
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

/// The right-hand side for the rates by the leading coordinate, which belongs to the last row.
fn leading_rate(count: usize) -> Vec<f64> {
    (1..=count).map(|row| if row == count { 1.0 } else { 0.0 }).collect()
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

/// What a circuit needs of a mechanism: it follows the closure alone.
trait CircuitFunctions: AnyMechanism + ClosureOver<Local> {}

impl<F: AnyMechanism + ClosureOver<Local>> CircuitFunctions for F {}

/// The curve of all positions on which a pose lies.
struct CircuitCurve<'c> {
    mechanism: &'c dyn CircuitFunctions,
    /// The dimensions, as numbers and as series.
    dimensions: (Vec<f64>, Vec<Local>),
    /// Writes the inputs where the moving one has a value.
    inputs: &'c dyn Fn(f64) -> Vec<f64>,
    /// The inputs that move, with their ways for each unit of the leading one.
    moving: Vec<(usize, f64)>,
    sizes: Vec<f64>,
    /// Whether a coordinate is an angle.
    angles: Vec<bool>,
    count: usize,
}

impl CircuitCurve<'_> {
    /// The residuals of the closure for coordinates that are series.
    fn residuals(&self, coordinates: &[Local]) -> Vec<Local> {
        let scaled = |(size, coordinate): (&f64, &Local)| Local::constant(*size) * *coordinate;
        let scaled: Vec<Local> = self.sizes.iter().zip(coordinates).map(scaled).collect();
        let lead = scaled[0];
        let change = lead - Local::constant(lead.real());
        let mut inputs: Vec<Local> = (self.inputs)(lead.real()).into_iter().map(Local::constant).collect();
        for (input, slope) in &self.moving {
            inputs[*input] = inputs[*input] + Local::constant(*slope) * change;
        }
        let mut residuals = vec![Local::constant(0.0); scaled.len() - 1];
        self.mechanism
            .residuals(&self.dimensions.1, &inputs, &scaled[1..], &mut residuals);
        residuals
    }

    /// The residuals at a place, and the Jacobian with a row that holds the leading coordinate.
    fn linear(&self, place: &[f64], leading: usize) -> Option<(Vec<f64>, CurveFactors)> {
        let count = place.len();
        let mut rows = vec![vec![0.0; count]; count];
        let mut values = vec![0.0; count];
        let mut coordinates: Vec<Local> = place.iter().copied().map(Local::constant).collect();
        for column in 0..count {
            coordinates[column] = Local::from_coefficients([place[column], 1.0, 0.0, 0.0, 0.0]);
            let residuals = self.residuals(&coordinates);
            for (row, residual) in residuals.iter().enumerate().take(count - 1) {
                [values[row], rows[row][column]] = [residual.coefficients()[0], residual.coefficients()[1]];
            }
            coordinates[column] = Local::constant(place[column]);
        }
        rows[count - 1][leading] = 1.0;
        Some((values, CurveFactors::new(count, |row, column| rows[row][column])?))
    }

    /// The place on the curve with the same leading coordinate.
    fn corrected(&self, mut place: Vec<f64>, leading: usize) -> Option<(Vec<f64>, CurveFactors)> {
        let mut previous = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let (mut values, factors) = self.linear(&place, leading)?;
            // the leading coordinate stays
            if let Some(last) = values.last_mut() {
                *last = 0.0;
            }
            let changes = factors.solve(&values);
            let size = changes.iter().fold(0.0, |size: f64, change| size.max(change.abs()));
            if !size.is_finite() {
                return None;
            }
            for (value, change) in place.iter_mut().zip(&changes) {
                *value -= change;
            }
            if size <= f64::EPSILON || size >= 0.5 * previous {
                return (size <= NOISE).then_some((place, factors));
            }
            previous = size;
        }
        None
    }

    /// The curve close to a place, in the direction of `ahead`.
    fn point(&self, place: Vec<f64>, leading: usize, ahead: &[f64]) -> Option<Point> {
        let (place, mut factors) = self.corrected(place, leading)?;
        let count = place.len();
        let unit = leading_rate(count);
        let mut leading = leading;
        let mut rates = factors.solve(&unit);
        let fastest = (0..count).max_by(|one, other| rates[*one].abs().total_cmp(&rates[*other].abs()))?;
        if fastest != leading {
            leading = fastest;
            factors = self.linear(&place, leading)?.1;
            rates = factors.solve(&unit);
        }
        let mut series: Vec<[f64; TERMS]> = place
            .iter()
            .zip(&rates)
            .map(|(value, rate)| [*value, *rate, 0.0, 0.0, 0.0])
            .collect();
        for order in 2..TERMS {
            let coordinates: Vec<Local> = series.iter().copied().map(Local::from_coefficients).collect();
            let residuals = self.residuals(&coordinates);
            let mut right: Vec<f64> = residuals
                .iter()
                .map(|residual| -residual.coefficients()[order])
                .collect();
            right.truncate(count - 1);
            right.push(0.0);
            for (series, coefficient) in series.iter_mut().zip(factors.solve(&right)) {
                series[order] = coefficient;
            }
        }
        if !series.iter().flatten().all(|coefficient| coefficient.is_finite()) {
            return None;
        }
        let direction = dot(&rates, ahead).signum();
        Some(Point {
            place,
            leading,
            series: series.into_iter().map(Local::from_coefficients).collect(),
            direction,
            orientation: factors.sign() * direction,
        })
    }

    /// A place near the curve, after a change of the local parameter.
    fn predicted(from: &Point, change: f64) -> Vec<f64> {
        let mut place: Vec<f64> = from.series.iter().map(|series| value(series, change)).collect();
        place[from.leading] = from.place[from.leading] + change;
        place
    }

    /// The change of the length of the arc with the local parameter, after a change of it.
    fn speed(&self, from: &Point, change: f64) -> Option<f64> {
        let (_, factors) = self.corrected(Self::predicted(from, change), from.leading)?;
        Some(length(&factors.solve(&leading_rate(from.place.len()))))
    }

    /// The length of the arc from a point to the one after a change of the local parameter, along the curve.
    fn arc(&self, from: &Point, change: f64) -> Option<f64> {
        let pieces = Float::ceil(change.abs() / PIECE).max(1.0);
        let half = 0.5 * change / pieces;
        let mut sum = 0.0;
        let mut middle = half;
        while (middle - change) * change < 0.0 {
            for (place, weight) in GAUSS {
                for place in [place, -place] {
                    sum += weight * self.speed(from, middle + place * half)?;
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
        self.point(Self::predicted(from, change), from.leading, &from.tangent())
    }

    /// The columns at a point, in all orders by the length of the arc.
    fn station(&self, at: f64, point: Point) -> Station<Point> {
        let parameter = point.by_arc();
        let derivatives = |index: usize| {
            let series = composed(point.series[index], parameter) * Local::constant(self.sizes[index]);
            series.derivatives()
        };
        let mut numbers = Vec::new();
        let lead = derivatives(0);
        let values = (self.inputs)(lead[0]);
        for (input, slope) in &self.moving {
            numbers.push(values[*input]);
            numbers.extend(lead[1..self.count].iter().map(|derivative| slope * derivative));
        }
        for index in 1..point.place.len() {
            numbers.extend(&derivatives(index)[..self.count]);
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
            input: station.near.place[0] * self.sizes[0],
            length: station.at,
        }
    }

    /// The next station, at most at a distance.
    fn next(&self, from: &Station<Point>, longest: f64) -> Result<Station<Point>, ExactTableError> {
        let here = &from.near;
        let tangent = here.tangent();
        let input = here.place[0] * self.sizes[0];
        let mut way = longest;
        loop {
            if way < SHORTEST {
                return Err(ExactTableError::ChangePoint { input });
            }
            let change = value(&here.by_arc(), way);
            let predicted = Self::predicted(here, change);
            let found = self.point(predicted.clone(), here.leading, &tangent).filter(|there| {
                let ahead = there.tangent();
                let distances = there
                    .place
                    .iter()
                    .zip(&predicted)
                    .map(|(one, other)| (one - other).abs());
                change * here.direction > 0.0
                    && dot(&tangent, &ahead) >= TURN
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

    /// The last place of the grid between two stations.
    fn on_grid(&self, from: &Station<Point>, there: Station<Point>) -> Station<Point> {
        let at = GRID * Float::floor(there.at / GRID);
        let is_between = at > from.at && at < there.at;
        let point = is_between.then(|| self.advanced(&from.near, at - from.at)).flatten();
        point.map_or(there, |point| self.station(at, point))
    }

    /// Whether the solvers find this place as well. Near a limit they may not.
    fn confirm(&self, station: &Station<Point>) -> Result<(), ExactTableError> {
        let point = &station.near;
        let at = point.place[0] * self.sizes[0];
        let coordinates = point.place.iter().zip(&self.sizes);
        let unknowns: Vec<f64> = coordinates.skip(1).map(|(value, size)| value * size).collect();
        let mut found = unknowns.clone();
        let solved = self
            .mechanism
            .position_near(&self.dimensions.0, &(self.inputs)(at), &unknowns, &mut found);
        match solved {
            Ok(()) => {
                let is_near = (0..self.sizes.len() - 1).all(|index| {
                    let mut change = (found[index] - unknowns[index]) / self.sizes[1 + index];
                    if self.angles[1 + index] {
                        change -= TAU * Float::round(change / TAU);
                    }
                    change.abs() <= 0.1
                });
                if is_near { Ok(()) } else { Err(self.lost(station)) }
            }
            Err(error) => match error.failure {
                Failure::OutOfReach { .. } | Failure::Singular { .. } | Failure::NotConverged { .. } => Ok(()),
                _ => Err(ExactTableError::NotClosed {
                    at,
                    error: Box::new(error),
                }),
            },
        }
    }

    /// The whole turns by which a place differs from the start, and the rest of the difference.
    fn turns(&self, start: &Point, place: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let differences = place.iter().zip(&start.place).zip(&self.angles);
        differences
            .map(|((one, other), is_angle)| {
                let turns = if *is_angle {
                    TAU * Float::round((one - other) / TAU)
                } else {
                    0.0
                };
                (turns, one - other - turns)
            })
            .unzip()
    }

    /// The start again, if it lies between two stations.
    fn back(&self, start: &Station<Point>, [here, there]: [&Station<Point>; 2]) -> Option<Station<Point>> {
        let tangent = start.near.tangent();
        let (_, before) = self.turns(&start.near, &here.near.place);
        let (turns, behind) = self.turns(&start.near, &there.near.place);
        let passes = dot(&before, &tangent) < 0.0 && dot(&behind, &tangent) >= 0.0;
        let is_near = length(&before).max(length(&behind)) <= 2.0 * LONGEST;
        let goes_on = dot(&there.near.tangent(), &tangent) > 0.0;
        if !(passes && is_near && goes_on) {
            return None;
        }
        let leading = here.near.leading;
        let end: Vec<f64> = start
            .near
            .place
            .iter()
            .zip(&turns)
            .map(|(value, turn)| value + turn)
            .collect();
        let change = end[leading] - here.near.place[leading];
        let (found, _) = self.corrected(Self::predicted(&here.near, change), leading)?;
        let distances = found.iter().zip(&end).map(|(one, other)| (one - other).abs());
        if distances.fold(0.0, f64::max) > NOISE {
            return None;
        }
        let mut station = start.clone();
        station.at = here.at + self.arc(&here.near, change)?;
        station.near.place.clone_from(&end);
        for (series, value) in station.near.series.iter_mut().zip(&end) {
            let mut coefficients = series.coefficients();
            coefficients[0] = *value;
            *series = Local::from_coefficients(coefficients);
        }
        // the values on their new turns, the derivatives as they are
        let again = self.station(station.at, station.near.clone());
        for (own, again) in station
            .numbers
            .chunks_mut(self.count)
            .zip(again.numbers.chunks(self.count))
        {
            own[0] = again[0];
        }
        Some(station)
    }

    /// Pairs of neighbouring stations around the whole circuit, from a place in one direction of the moving input.
    fn around(&self, place: Vec<f64>, is_downwards: bool) -> Result<Vec<[Station<Point>; 2]>, ExactTableError> {
        let input = place[0] * self.sizes[0];
        let mut ahead = vec![0.0; place.len()];
        ahead[0] = if is_downwards { -1.0 } else { 1.0 };
        let start = self.point(place, 0, &ahead);
        let start = self.station(0.0, start.ok_or(ExactTableError::ChangePoint { input })?);
        let mut stations = vec![start.clone()];
        let mut here = start.clone();
        let mut longest = LONGEST;
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
            longest = LONGEST.min(2.0 * (there.at - here.at));
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

    fn columns(&self) -> Vec<Quantity> {
        let description = self.mechanism.description();
        let inputs = self.moving.iter().map(|(input, _)| description.inputs[*input]);
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

impl<M: Mechanism<Scalar = f64>> Course<M, StraightLine> {
    /// The whole circuit as an [`ExactTable`]: from the beginning of the range in its direction, on through the limits where the input
    /// turns back, until the motion has come back to its start. So one closed table holds both assemblies between two limits.
    ///
    /// The parameter is the length of the arc, `arc`: the root of the sum of the squares of all ways of the moving input and the unknowns,
    /// angles in radians and lengths in units of the longest link. It is smooth where the input turns back. A mechanism that is shown at a
    /// constant speed of the arc moves evenly. The columns are the inputs that move and the unknowns, in this order. Outputs are not among
    /// them: at a limit the solver has none of their derivatives. A quantity that is declared as an unknown with an equation of its own is
    /// a column.
    ///
    /// The errors are measured against the closure, which is well-conditioned at limits with the fastest quantity as its parameter; `solve`
    /// is not. Away from limits both are the same.
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
    /// [`ExactTableError::NotClosed`] if the mechanism does not close at the beginning, or the motion leads to the end of the domain of a
    /// function, [`ExactTableError::ChangePoint`] where branches cross, [`ExactTableError::Lost`] if the motion does not come back, and the
    /// errors of [`exact_table`](Self::exact_table).
    pub fn exact_circuit(&self, precision: impl Into<Precision>) -> Result<ExactTable, ExactTableError> {
        let precision = precision.into();
        let course = self.any();
        course.check()?;
        let order = precision.order_of(course.description)?;
        let closed = |error| ExactTableError::NotClosed {
            at: self.from,
            error: Box::new(error),
        };
        let mut walk = Walk::BEGINNING;
        let reached = walk
            .step(&course, self.from, &course.motions(self.from))
            .map_err(closed)?;
        let inputs = |at: f64| course.inputs(at).to_vec();
        let unknowns = reached.unknowns();
        let curve = self.circuit_curve(order + 1, &unknowns, &inputs);
        let values = core::iter::once(&self.from).chain(unknowns.iter());
        let start = values.zip(&curve.sizes).map(|(value, size)| value / size).collect();
        let stations = curve.around(start, self.to < self.from)?;
        let frame = Frame {
            name: M::DESCRIPTION.name,
            parameter: ("arc".to_string(), Dimension::Scalar),
            order,
            may_close: true,
        };
        refined(&curve, frame, stations, precision)
    }

    fn circuit_curve<'c>(
        &'c self,
        count: usize,
        unknowns: &[f64],
        inputs: &'c dyn Fn(f64) -> Vec<f64>,
    ) -> CircuitCurve<'c> {
        let description = M::DESCRIPTION;
        let parameters = self.mechanism.parameters().as_ref().to_vec();
        // the variable of a line is always an input
        let lead = match self.drive.variable() {
            Variable::Input(lead) => lead,
            _ => 0,
        };
        let mut slopes = vec![0.0; description.inputs.len() * READ];
        self.drive.derivatives(self.from, Side::Right, &mut slopes);
        let own = Sizes::of(&description, &parameters);
        let quantities = core::iter::once(description.inputs[lead]).chain(description.unknowns.iter().copied());
        let values = core::iter::once(self.from).chain(unknowns.iter().copied());
        CircuitCurve {
            mechanism: Of::<M>::FUNCTIONS,
            dimensions: (
                parameters.clone(),
                parameters.into_iter().map(Local::constant).collect(),
            ),
            inputs,
            moving: (0..description.inputs.len())
                .filter(|input| *input == lead || self.drive.same(*input, 0).is_none())
                .map(|input| (input, slopes[input * READ + 1]))
                .collect(),
            sizes: quantities
                .clone()
                .zip(values)
                .map(|(quantity, value)| own.size(quantity.dimension, value))
                .collect(),
            angles: quantities
                .map(|quantity| quantity.dimension == Dimension::Angle)
                .collect(),
            count,
        }
    }
}
