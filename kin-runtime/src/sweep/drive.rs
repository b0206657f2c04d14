//! How the inputs move during a sweep.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

use num_traits::Float;

use crate::any::{description, write};
use crate::batch::{Column, LengthMismatch};
use crate::failure::InputNames;
pub(crate) use crate::hermite::TERMS;
use crate::law::{Law, LawJoint, Piecewise, Side, approached};
use crate::mechanism::{Description, Mechanism};
use crate::motion::Motion;
use crate::number::{NumberRow, series::Series};
use crate::quantity::{Name, Quantity, RATES};
use crate::sweep::SweepError;

/// A value that carries its first four derivatives with respect to the variable of a sweep.
pub type Local = Series<TERMS>;

/// The time of a formula, with all derivatives that are read of it.
pub type Instant = Series<READ>;

/// The number of derivatives of an input that are read, with its value: those of the highest order, and those of its
/// series.
pub const READ: usize = RATES.len() + TERMS;

/// The largest rounding of a whole number of revolutions.
const WHOLE: f64 = 1e-9;

/// The inputs of the mechanism `M`, each in all orders, as numbers of the type `V`.
pub type InputMotions<M, V> = <M as Mechanism>::Inputs<<M as Mechanism>::Motion<V>>;

/// The quantity over which a sweep runs: an input, the time, or the number of the row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// The input with this index.
    Input(usize),
    /// The time, in the unit of time of the rates.
    Time,
    /// The number of the row, from zero.
    Row,
}

impl Variable {
    /// The name and the dimension of the variable.
    #[must_use]
    pub fn quantity<M: Mechanism>(self) -> Quantity<'static> {
        self.of(description::<M>())
    }

    pub(crate) fn of<'d>(self, description: &Description<'d>) -> Quantity<'d> {
        match self {
            Self::Input(index) => description.inputs[index],
            Self::Time => Quantity::scalar("time", "The time."),
            Self::Row => Quantity::scalar("row", "The number of the row."),
        }
    }
}

/// How the inputs move over the variable of a sweep. Do not implement it: a new version may add items.
pub trait Drive {
    /// The variable.
    fn variable(&self) -> Variable;

    /// Writes the motions of the inputs at a value of the variable, one after the other, each with a number of orders
    /// that a pose may have.
    #[doc(hidden)]
    fn motions(&self, at: f64, orders: usize, motions: &mut [f64]);

    /// The derivative of an input with respect to time, if it is the same everywhere.
    #[doc(hidden)]
    fn same(&self, input: usize, order: usize) -> Option<f64> {
        let _ = (input, order);
        None
    }

    /// The change of the variable for each unit of time, not a number if the rates of the inputs do not determine it.
    #[doc(hidden)]
    fn rate(&self) -> f64 {
        1.0
    }

    /// Whether the inputs can move so over a range of the variable, from the smaller end to the larger one, in a number
    /// of rows.
    #[doc(hidden)]
    fn check(&self, range: [f64; 2], rows: usize) -> Result<(), SweepError> {
        let _ = (range, rows);
        Ok(())
    }
}

/// A drive that is known with its derivatives to any order, so that the poses between the rows are known as well.
pub trait SmoothDrive: Drive {
    /// Writes the inputs with their derivatives with respect to the variable, one after the other, each with as many as
    /// are read. Where two pieces of a law meet, `side` selects one.
    #[doc(hidden)]
    fn derivatives(&self, at: f64, side: Side, derivatives: &mut [f64]);

    /// The first joint beyond `after` where two pieces of a law meet, if there is one.
    #[doc(hidden)]
    fn next_joint(&self, after: f64) -> Option<f64> {
        let _ = after;
        None
    }

    /// The lowest order of an input's derivative that jumps at a joint, if one does: higher ones have no bound there.
    #[doc(hidden)]
    fn jump(&self, joint: f64) -> Option<usize> {
        let _ = joint;
        None
    }
}

/// A derivative with respect to time, as a series in the variable, from the derivatives with respect to the variable.
pub(crate) fn by_time(derivatives: &[f64], order: usize, rate: f64) -> Local {
    let factor = (0..order).fold(1.0, |factor, _| factor * rate);
    Local::from_derivatives(core::array::from_fn(|above| factor * derivatives[order + above]))
}

/// Writes the first derivatives of some inputs, of which more may be known.
fn write_orders<'m>(known: impl Iterator<Item = &'m [f64]>, orders: usize, motions: &mut [f64]) {
    for (known, motion) in known.zip(motions.chunks_exact_mut(orders)) {
        motion.copy_from_slice(&known[..orders]);
    }
}

/// Writes the motion of an input whose value changes at a constant rate.
pub(crate) fn write_steady(motion: &mut [f64], value: f64, rate: f64) {
    motion.fill(0.0);
    motion[0] = value;
    if let Some(velocity) = motion.get_mut(1) {
        *velocity = rate;
    }
}

/// A straight line in the space of the inputs, at constant speed.
#[derive(Clone, Debug)]
pub struct StraightLine {
    pub(crate) from: NumberRow,
    pub(crate) to: NumberRow,
    /// The first input that moves.
    pub(super) lead: usize,
    /// The speed of that input in the direction of the line.
    pub(super) speed: f64,
}

impl StraightLine {
    pub(crate) fn new(from: &[f64], to: &[f64]) -> Self {
        let ends = from.iter().zip(to);
        let lead = ends.clone().position(|(from, to)| from != to).unwrap_or(0);
        Self {
            from: from.into(),
            to: to.into(),
            lead,
            speed: 1.0,
        }
    }

    /// The same line at another speed.
    pub(crate) fn at_speed(self, speed: f64) -> Self {
        Self { speed, ..self }
    }

    /// The range of the input that moves first.
    pub(crate) fn range(&self) -> [f64; 2] {
        [self.from[self.lead], self.to[self.lead]]
    }

    /// The way of an input for each unit of the first one that moves.
    fn slope(&self, input: usize) -> f64 {
        if input == self.lead {
            return 1.0;
        }
        let way = self.to[self.lead] - self.from[self.lead];
        if way == 0.0 {
            0.0
        } else {
            (self.to[input] - self.from[input]) / way
        }
    }

    /// The line for all values of the first input that moves: a point of it, where that input is zero, and its
    /// direction.
    pub(crate) fn unbounded(&self) -> [NumberRow; 2] {
        let mut unbounded = [self.from.clone(), self.from.clone()];
        let [origin, direction] = &mut unbounded;
        for input in 0..self.from.len() {
            (origin[input], direction[input]) = (self.value(input, 0.0), self.slope(input));
        }
        unbounded
    }

    /// The velocity of the first input that moves.
    fn velocity(&self) -> f64 {
        if self.to[self.lead] < self.from[self.lead] {
            -self.speed
        } else {
            self.speed
        }
    }

    fn value(&self, input: usize, at: f64) -> f64 {
        if input == self.lead {
            at
        } else if at == self.to[self.lead] {
            self.to[input]
        } else {
            self.from[input] + self.slope(input) * (at - self.from[self.lead])
        }
    }
}

impl Drive for StraightLine {
    fn variable(&self) -> Variable {
        Variable::Input(self.lead)
    }

    fn rate(&self) -> f64 {
        self.velocity()
    }

    fn motions(&self, at: f64, orders: usize, motions: &mut [f64]) {
        let velocity = self.velocity();
        for (input, motion) in motions.chunks_exact_mut(orders).enumerate() {
            write_steady(motion, self.value(input, at), self.slope(input) * velocity);
        }
    }

    fn same(&self, input: usize, order: usize) -> Option<f64> {
        match order {
            0 if self.from[input] == self.to[input] => Some(self.from[input]),
            0 => None,
            1 => Some(self.slope(input) * self.velocity()),
            _ => Some(0.0),
        }
    }

    fn check(&self, _: [f64; 2], _: usize) -> Result<(), SweepError> {
        let of = |quantity, values: &[f64]| {
            let culprit = values.iter().copied().find(|value| !value.is_finite());
            culprit.map_or(Ok(()), |value| Err(SweepError::NotFinite { quantity, value }))
        };
        of("start", &self.from)?;
        of("end", &self.to)?;
        of("speed", &[self.speed])?;
        if self.speed == 0.0 {
            return Err(SweepError::NoSpeed);
        }
        Ok(())
    }
}

impl SmoothDrive for StraightLine {
    fn derivatives(&self, at: f64, _: Side, derivatives: &mut [f64]) {
        for (input, motion) in derivatives.chunks_exact_mut(READ).enumerate() {
            write_steady(motion, self.value(input, at), self.slope(input));
        }
    }
}

/// A function that writes the inputs at a time.
type WriteInputs<'f> = Box<dyn Fn(f64, &mut [f64]) + 'f>;

/// Any motion over time, given by a function.
pub struct OverTime<'f> {
    write: WriteInputs<'f>,
    /// The orders of each motion.
    orders: usize,
    inputs: usize,
}

impl<'f> OverTime<'f> {
    pub(super) fn new<M: Mechanism>(function: impl Fn(f64) -> InputMotions<M, f64> + 'f) -> Self {
        Self {
            write: Box::new(move |time, motions| write(function(time).as_ref(), motions)),
            orders: M::DESCRIPTION.order + 1,
            inputs: M::DESCRIPTION.inputs.len(),
        }
    }
}

impl Drive for OverTime<'_> {
    fn variable(&self) -> Variable {
        Variable::Time
    }

    fn motions(&self, at: f64, orders: usize, motions: &mut [f64]) {
        if orders == self.orders {
            return (self.write)(at, motions);
        }
        let mut known = NumberRow::splat(self.inputs * self.orders, 0.0);
        (self.write)(at, &mut known);
        write_orders(known.chunks_exact(self.orders), orders, motions);
    }
}

/// Motions over time, given by formulas.
pub struct ByFormula<'f> {
    /// Writes all derivatives that are read.
    write: WriteInputs<'f>,
    inputs: usize,
}

impl<'f> ByFormula<'f> {
    pub(super) fn new<M: Mechanism<Scalar = f64>>(formula: impl Fn(Instant) -> M::Inputs<Instant> + 'f) -> Self {
        let write = move |time: f64, derivatives: &mut [f64]| {
            let time = Motion::<f64, READ>::at_constant_speed(time, 1.0);
            let inputs = formula(Instant::from_derivatives(time.derivatives()));
            for (input, derivatives) in inputs.as_ref().iter().zip(derivatives.chunks_exact_mut(READ)) {
                derivatives.copy_from_slice(&input.derivatives());
            }
        };
        Self {
            write: Box::new(write),
            inputs: M::DESCRIPTION.inputs.len(),
        }
    }
}

impl Drive for ByFormula<'_> {
    fn variable(&self) -> Variable {
        Variable::Time
    }

    fn motions(&self, at: f64, orders: usize, motions: &mut [f64]) {
        let mut known = alloc::vec![0.0; self.inputs * READ];
        (self.write)(at, &mut known);
        write_orders(known.chunks_exact(READ), orders, motions);
    }
}

impl SmoothDrive for ByFormula<'_> {
    fn derivatives(&self, at: f64, _: Side, derivatives: &mut [f64]) {
        (self.write)(at, derivatives);
    }
}

/// Motion laws over time, one for each input.
#[derive(Clone)]
pub struct Laws<'l> {
    laws: Vec<&'l dyn Piecewise<f64>>,
    inputs: InputNames,
}

impl<'l> Laws<'l> {
    pub(crate) fn new(laws: &[&'l dyn Piecewise<f64>], inputs: InputNames) -> Self {
        Self {
            laws: laws.to_vec(),
            inputs,
        }
    }
}

impl Drive for Laws<'_> {
    fn variable(&self) -> Variable {
        Variable::Time
    }

    fn motions(&self, at: f64, orders: usize, motions: &mut [f64]) {
        for (law, motion) in self.laws.iter().zip(motions.chunks_exact_mut(orders)) {
            let known: Motion<f64, { RATES.len() + 1 }> = law.at(at);
            motion.copy_from_slice(&known.as_ref()[..orders]);
        }
    }

    /// A mechanism does not jump.
    fn check(&self, range: [f64; 2], _: usize) -> Result<(), SweepError> {
        for (law, (input, is_angle)) in self.laws.iter().zip(self.inputs.iter()) {
            let period = law.repeats().then(|| law.duration());
            let jump = law.joints::<1>().find_map(|joint| {
                let by = joint.jump().value();
                (first_jump(&joint, is_angle) == Some(0))
                    .then(|| within(joint.time, period, range))?
                    .map(|at| (at, by))
            });
            if let Some((at, by)) = jump {
                return Err(SweepError::Jump {
                    input,
                    is_angle,
                    at,
                    by,
                });
            }
        }
        Ok(())
    }
}

/// The lowest order that jumps at a joint. A jump of an angle by whole revolutions is none: a crank starts a new
/// revolution at zero.
fn first_jump<const N: usize>(joint: &LawJoint<f64, N>, is_angle: bool) -> Option<usize> {
    let revolutions = joint.jump().value() / core::f64::consts::TAU;
    let is_whole = is_angle && (revolutions - Float::round(revolutions)).abs() < WHOLE;
    joint.first_jump_from(usize::from(is_whole))
}

/// The first of the times, one or one in each period, that lies inside of a range.
fn within(time: f64, period: Option<f64>, [start, end]: [f64; 2]) -> Option<f64> {
    let first = match period {
        None => time,
        Some(period) => time + period * (Float::floor((start - time) / period) + 1.0),
    };
    (start < first && first < end).then_some(first)
}

impl SmoothDrive for Laws<'_> {
    fn derivatives(&self, at: f64, side: Side, derivatives: &mut [f64]) {
        for (law, motion) in self.laws.iter().zip(derivatives.chunks_exact_mut(READ)) {
            // The end of a law itself has the motion of the last piece. Behind it, and before the beginning, the law
            // rests.
            let rests = match side {
                Side::Left => at <= 0.0,
                Side::Right => at >= law.duration(),
            };
            let known: Motion<f64, READ> = if rests && !law.repeats() {
                Motion::constant(approached::<f64, _, 1>(*law, at, side).value())
            } else {
                approached(*law, at, side)
            };
            motion.copy_from_slice(known.as_ref());
        }
    }

    fn next_joint(&self, after: f64) -> Option<f64> {
        let next = |law: &dyn Piecewise<f64>| {
            let duration = law.duration();
            let cycle = if law.repeats() {
                Float::floor(after / duration)
            } else {
                0.0
            };
            let ends = (0..law.pieces()).map(|piece| law.end(piece));
            // also the beginning of the next cycle's first piece
            [cycle, cycle + 1.0]
                .into_iter()
                .filter(|&start| law.repeats() || start == 0.0)
                .flat_map(|start| {
                    let ends = ends.clone();
                    core::iter::once(0.0).chain(ends).map(move |end| start * duration + end)
                })
                .filter(|joint| *joint > after)
                .reduce(f64::min)
        };
        self.laws.iter().filter_map(|law| next(*law)).reduce(f64::min)
    }

    fn jump(&self, joint: f64) -> Option<usize> {
        const ORDERS: usize = RATES.len() + 1;
        let jumps = self
            .laws
            .iter()
            .zip(self.inputs.iter())
            .filter_map(|(law, (_, is_angle))| {
                let duration = law.duration();
                // times are rounded, and the end of a law that repeats is its beginning
                let repetitions = |time: f64| {
                    if law.repeats() {
                        Float::round(time / duration)
                    } else {
                        0.0
                    }
                };
                let is_here = |time: f64| {
                    let distance = joint - time;
                    (distance - repetitions(distance) * duration).abs()
                        <= 16.0 * f64::EPSILON * joint.abs().max(duration)
                };
                let mut joints = law.joints::<ORDERS>().filter(|joint_of_law| is_here(joint_of_law.time));
                joints.find_map(|joint_of_law| first_jump(&joint_of_law, is_angle))
            });
        jumps.min()
    }
}

/// Columns that are given, one for each order of each input.
#[derive(Clone)]
pub struct Along<'c> {
    columns: Vec<Column<'c>>,
    orders: usize,
    inputs: &'static [Quantity<'static>],
}

impl<'c> Along<'c> {
    pub(super) fn new<M: Mechanism>(columns: &InputMotions<M, Column<'c>>) -> Self {
        let all = columns.as_ref().iter().flat_map(AsRef::as_ref);
        Self {
            columns: all.copied().collect(),
            orders: M::DESCRIPTION.order + 1,
            inputs: M::DESCRIPTION.inputs,
        }
    }

    /// The length of the first column that has one.
    pub(super) fn count(&self) -> usize {
        let mut lengths = self.lengths();
        lengths.next().map_or(1, |(_, length)| length)
    }

    /// The lengths of columns that have one, each with the name of the input.
    fn lengths(&self) -> impl Iterator<Item = (Name, usize)> {
        let columns = self.columns.iter().enumerate();
        columns.filter_map(|(index, column)| match column {
            Column::Same(_) => None,
            Column::Each(values) => Some((self.inputs[index / self.orders].name.into(), values.len())),
        })
    }
}

impl Drive for Along<'_> {
    fn variable(&self) -> Variable {
        Variable::Row
    }

    fn rate(&self) -> f64 {
        f64::NAN
    }

    /// Between two rows, the inputs stand on the straight line from the one to the other.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "it is the number of a row"
    )]
    fn motions(&self, at: f64, orders: usize, motions: &mut [f64]) {
        let row = at as usize;
        let part = at - Float::floor(at);
        let inputs = self.columns.chunks_exact(self.orders);
        for (columns, motion) in inputs.zip(motions.chunks_exact_mut(orders)) {
            for (column, motion) in columns.iter().zip(motion) {
                let value = column.at(row);
                *motion = if part > 0.0 {
                    value + part * (column.at(row + 1) - value)
                } else {
                    value
                };
            }
        }
    }

    fn same(&self, input: usize, order: usize) -> Option<f64> {
        match self.columns[input * self.orders + order] {
            Column::Same(value) => Some(value),
            Column::Each(_) => None,
        }
    }

    fn check(&self, _: [f64; 2], rows: usize) -> Result<(), SweepError> {
        let mut lengths = self.lengths();
        let other = lengths.find(|(_, length)| *length != rows);
        other.map_or(Ok(()), |(quantity, length)| {
            Err(SweepError::Columns(LengthMismatch {
                quantity,
                poses: rows,
                length,
            }))
        })
    }
}

macro_rules! shown_by_name {
    ($($drive:ident)*) => {
        $(
            impl fmt::Debug for $drive<'_> {
                fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                    formatter.write_str(stringify!($drive))
                }
            }
        )*
    };
}

shown_by_name!(OverTime ByFormula Laws Along);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::{Rise, Sequence, Shape};
    use crate::library::FourBar;

    /// The other input moves in proportion, and both arrive exactly.
    #[test]
    fn a_line_leads_all_inputs_to_their_ends() {
        let mut line = StraightLine::new(&[1.0, 2.0], &[4.0, 0.1]);
        line.speed = 6.0;
        let motions = |at| {
            let mut motions = [0.0; 10];
            line.motions(at, 5, &mut motions);
            [0, 5].map(|first| motions[first..first + 5].to_vec())
        };
        assert_eq!(motions(1.0)[1][0], 2.0);
        assert_eq!(motions(4.0)[1][0], 0.1);
        assert_eq!(motions(2.5)[0], [2.5, 6.0, 0.0, 0.0, 0.0]);
        assert!((motions(2.5)[1][0] - 1.05).abs() < 1e-15);
        assert!((motions(2.5)[1][1] + 3.8).abs() < 1e-15);
    }

    /// The series of each order is that of the next order, integrated.
    #[test]
    fn the_series_of_laws_fit_together() {
        let rise = Rise::new(Shape::Cycloidal, 0.0, 2.0, 0.5).unwrap();
        let drive = Laws::new(&[&rise], InputNames::Declared(FourBar::<f64>::DESCRIPTION.inputs));
        let mut motion = [0.0; READ];
        drive.derivatives(0.2, Side::Right, &mut motion);
        let series: [Local; 5] = core::array::from_fn(|order| by_time(&motion, order, 1.0));
        for order in 0..4 {
            let (low, high) = (series[order].derivatives(), series[order + 1].derivatives());
            assert_eq!(low[1..], high[..4]);
        }
    }

    #[test]
    fn joints_come_one_after_the_other() {
        let rise = Rise::new(Shape::Cycloidal, 0.0, 2.0, 0.5).unwrap();
        let fall = Rise::new(Shape::Cycloidal, 2.0, 0.0, 0.25).unwrap();
        let laws = Sequence::new([&rise, &fall]).unwrap();
        let joints = |drive: &Laws<'_>| {
            let mut joints = std::vec![];
            let mut after = -0.1;
            while let Some(next) = drive.next_joint(after).filter(|joint| *joint < 1.6) {
                joints.push(next);
                after = next;
            }
            joints
        };
        assert_eq!(
            joints(&Laws::new(
                &[&laws],
                InputNames::Declared(FourBar::<f64>::DESCRIPTION.inputs)
            )),
            [0.0, 0.5, 0.75]
        );
        let cam = laws.repeated();
        assert_eq!(
            joints(&Laws::new(
                &[&cam],
                InputNames::Declared(FourBar::<f64>::DESCRIPTION.inputs)
            )),
            [0.0, 0.5, 0.75, 1.25, 1.5]
        );
    }
}
