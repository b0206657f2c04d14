//! How the inputs move during a sweep.

use crate::batch::Column;
#[cfg(feature = "alloc")]
use crate::batch::LengthMismatch;
pub(crate) use crate::hermite::TERMS;
use crate::law::{Law, Piecewise, Side, approached};
use crate::mechanism::{Description, Mechanism};
use crate::motion::Motion;
use crate::number::{Row, at_constant_rate, series::Series};
#[cfg(feature = "alloc")]
use crate::quantity::Dimension;
use crate::quantity::{Quantity, RATES};
#[cfg(feature = "alloc")]
use crate::sweep::SweepError;

/// A value that carries its first four derivatives with respect to the variable of a sweep.
pub type Local = Series<TERMS>;

/// The time of a formula, with all derivatives that are read of it.
pub type Instant = Series<READ>;

/// The number of derivatives of an input that are read, with its value: those of the highest order, and those of its series.
pub(crate) const READ: usize = RATES.len() + TERMS;

/// The largest rounding of a number of turns that is whole.
#[cfg(feature = "alloc")]
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
    pub fn quantity<M: Mechanism>(self) -> Quantity {
        self.of(&M::DESCRIPTION)
    }

    pub(crate) fn of(self, description: &Description) -> Quantity {
        match self {
            Self::Input(index) => description.inputs[index],
            Self::Time => Quantity::scalar("time", "The time."),
            Self::Row => Quantity::scalar("row", "The number of the row."),
        }
    }
}

/// The motion of the inputs over the variable of a sweep.
pub trait Drive<M: Mechanism<Scalar = f64>> {
    /// The variable.
    fn variable(&self) -> Variable;

    /// The motions of the inputs at a value of the variable.
    fn motions(&self, at: f64) -> InputMotions<M, f64>;

    /// The derivative of an input with respect to time, if it is the same everywhere.
    fn same(&self, input: usize, order: usize) -> Option<f64> {
        let _ = (input, order);
        None
    }

    /// The change of the variable for each unit of time, not a number if the rates of the inputs do not tell it.
    fn rate(&self) -> f64 {
        1.0
    }

    /// Whether the inputs can move so over a range of the variable, from the smaller end to the larger one, in a number of rows.
    #[doc(hidden)]
    #[cfg(feature = "alloc")]
    fn check(&self, range: [f64; 2], rows: usize) -> Result<(), SweepError> {
        let _ = (range, rows);
        Ok(())
    }
}

/// A drive that is known with its derivatives to any order, so that the poses between the rows are known as well.
pub trait SmoothDrive<M: Mechanism<Scalar = f64>>: Drive<M> {
    /// The inputs with their derivatives with respect to the variable. Where two pieces of a law meet, `side` selects one.
    fn derivatives(&self, at: f64, side: Side) -> M::Inputs<Motion<f64, READ>>;

    /// The first place beyond `after` where two pieces of a law meet, if there is one.
    fn next_joint(&self, after: f64) -> Option<f64> {
        let _ = after;
        None
    }

    /// The time for each unit of the variable.
    fn time_per_variable(&self) -> f64 {
        1.0 / self.rate().abs()
    }

    /// The way of the first input for each unit of the variable, without its sign.
    fn way_per_variable(&self, at: f64) -> f64 {
        let inputs = self.derivatives(at, Side::Right);
        inputs.as_ref().first().map_or(1.0, |motion| motion[1].abs())
    }
}

/// A derivative with respect to time, as a series in the variable, from the derivatives with respect to the variable.
#[cfg(feature = "alloc")]
pub(crate) fn by_time(derivatives: &[f64], order: usize, rate: f64) -> Local {
    let factor = (0..order).fold(1.0, |factor, _| factor * rate);
    Local::from_derivatives(core::array::from_fn(|above| factor * derivatives[order + above]))
}

/// A straight line in the space of the inputs, at constant speed.
#[derive(Clone, Copy, Debug)]
pub struct StraightLine<M: Mechanism<Scalar = f64>> {
    pub(super) from: M::Inputs<f64>,
    pub(super) to: M::Inputs<f64>,
    /// The first input that moves.
    pub(super) lead: usize,
    /// The speed of that input in the direction of the line.
    pub(super) speed: f64,
}

impl<M: Mechanism<Scalar = f64>> StraightLine<M> {
    pub(super) fn new(from: M::Inputs<f64>, to: M::Inputs<f64>) -> Self {
        let ends = from.as_ref().iter().zip(to.as_ref());
        let lead = ends.clone().position(|(from, to)| from != to).unwrap_or(0);
        Self {
            from,
            to,
            lead,
            speed: 1.0,
        }
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

impl<M: Mechanism<Scalar = f64>> Drive<M> for StraightLine<M> {
    fn variable(&self) -> Variable {
        Variable::Input(self.lead)
    }

    fn rate(&self) -> f64 {
        self.velocity()
    }

    fn motions(&self, at: f64) -> InputMotions<M, f64> {
        Row::from_fn(|input| at_constant_rate(self.value(input, at), self.slope(input) * self.velocity()))
    }

    fn same(&self, input: usize, order: usize) -> Option<f64> {
        match order {
            0 if self.from[input] == self.to[input] => Some(self.from[input]),
            0 => None,
            1 => Some(self.slope(input) * self.velocity()),
            _ => Some(0.0),
        }
    }

    #[cfg(feature = "alloc")]
    fn check(&self, _: [f64; 2], _: usize) -> Result<(), SweepError> {
        let of = |quantity, values: &[f64]| {
            let culprit = values.iter().copied().find(|value| !value.is_finite());
            culprit.map_or(Ok(()), |value| Err(SweepError::NotFinite { quantity, value }))
        };
        of("start", self.from.as_ref())?;
        of("end", self.to.as_ref())?;
        of("speed", &[self.speed])?;
        if self.speed == 0.0 {
            return Err(SweepError::NoSpeed);
        }
        Ok(())
    }
}

impl<M: Mechanism<Scalar = f64>> SmoothDrive<M> for StraightLine<M> {
    fn derivatives(&self, at: f64, _: Side) -> M::Inputs<Motion<f64, READ>> {
        Row::from_fn(|input| Motion::at_constant_speed(self.value(input, at), self.slope(input)))
    }

    fn way_per_variable(&self, _: f64) -> f64 {
        1.0
    }
}

/// Any motion over time, given by a function.
#[derive(Clone, Copy, Debug)]
pub struct OverTime<F>(pub(super) F);

impl<M, F> Drive<M> for OverTime<F>
where
    M: Mechanism<Scalar = f64>,
    F: Fn(f64) -> InputMotions<M, f64>,
{
    fn variable(&self) -> Variable {
        Variable::Time
    }

    fn motions(&self, at: f64) -> InputMotions<M, f64> {
        (self.0)(at)
    }
}

/// Motions over time, given by formulas.
#[derive(Clone, Copy, Debug)]
pub struct ByFormula<F>(pub(super) F);

impl<M, F> Drive<M> for ByFormula<F>
where
    M: Mechanism<Scalar = f64>,
    F: Fn(Instant) -> M::Inputs<Instant>,
{
    fn variable(&self) -> Variable {
        Variable::Time
    }

    fn motions(&self, at: f64) -> InputMotions<M, f64> {
        let inputs: M::Inputs<Motion<f64, READ>> = SmoothDrive::<M>::derivatives(self, at, Side::Right);
        Row::from_fn(|input| Row::from_fn(|order| inputs[input][order]))
    }
}

impl<M, F> SmoothDrive<M> for ByFormula<F>
where
    M: Mechanism<Scalar = f64>,
    F: Fn(Instant) -> M::Inputs<Instant>,
{
    fn derivatives(&self, at: f64, _: Side) -> M::Inputs<Motion<f64, READ>> {
        let time = Motion::<f64, READ>::at_constant_speed(at, 1.0);
        let inputs = (self.0)(Instant::from_derivatives(time.derivatives()));
        Row::from_fn(|input| Motion::new(inputs[input].derivatives()))
    }
}

/// Motion laws over time, one for each input.
#[derive(Clone, Copy)]
pub struct Laws<'l, M: Mechanism<Scalar = f64>>(pub(super) M::Inputs<&'l dyn Piecewise<f64>>);

impl<M: Mechanism<Scalar = f64>> Drive<M> for Laws<'_, M> {
    fn variable(&self) -> Variable {
        Variable::Time
    }

    fn motions(&self, at: f64) -> InputMotions<M, f64> {
        Row::from_fn(|input| {
            let motion: Motion<f64, 13> = self.0[input].at(at);
            Row::from_fn(|order| motion[order])
        })
    }

    /// A mechanism does not jump. A jump of an angle by whole turns is none: a crank starts a new turn at zero.
    #[cfg(feature = "alloc")]
    fn check(&self, range: [f64; 2], _: usize) -> Result<(), SweepError> {
        for (law, quantity) in self.0.as_ref().iter().zip(M::DESCRIPTION.inputs) {
            let period = law.repeats().then(|| law.duration());
            let jump = law.joints::<1>().find_map(|joint| {
                let by = joint.jump().value();
                let turns = by / core::f64::consts::TAU;
                let is_none = joint.first_jump().is_none()
                    || quantity.dimension == Dimension::Angle
                        && (turns - num_traits::Float::round(turns)).abs() < WHOLE;
                (!is_none)
                    .then(|| within(joint.time, period, range))?
                    .map(|at| (at, by))
            });
            if let Some((at, by)) = jump {
                let (input, dimension) = (quantity.name, quantity.dimension);
                return Err(SweepError::Jump {
                    input,
                    dimension,
                    at,
                    by,
                });
            }
        }
        Ok(())
    }
}

/// The first of the times, one or one in each period, that lies inside of a range.
#[cfg(feature = "alloc")]
fn within(time: f64, period: Option<f64>, [start, end]: [f64; 2]) -> Option<f64> {
    let first = match period {
        None => time,
        Some(period) => time + period * (num_traits::Float::floor((start - time) / period) + 1.0),
    };
    (start < first && first < end).then_some(first)
}

impl<M: Mechanism<Scalar = f64>> SmoothDrive<M> for Laws<'_, M> {
    fn derivatives(&self, at: f64, side: Side) -> M::Inputs<Motion<f64, READ>> {
        Row::from_fn(|input| approached(self.0[input], at, side))
    }

    fn next_joint(&self, after: f64) -> Option<f64> {
        let next = |law: &dyn Piecewise<f64>| {
            let duration = law.duration();
            let cycle = if law.repeats() {
                num_traits::Float::floor(after / duration)
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
        self.0.as_ref().iter().filter_map(|law| next(*law)).reduce(f64::min)
    }
}

/// Columns of one's own, one for each order of each input.
#[derive(Clone, Copy)]
pub struct Along<'c, M: Mechanism<Scalar = f64>>(pub(super) InputMotions<M, Column<'c>>);

impl<M: Mechanism<Scalar = f64>> Drive<M> for Along<'_, M> {
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
    fn motions(&self, at: f64) -> InputMotions<M, f64> {
        let row = at as usize;
        let part = at - num_traits::Float::floor(at);
        Row::from_fn(|input| {
            Row::from_fn(|order| {
                let column = self.0[input][order];
                let value = column.at(row);
                if part > 0.0 {
                    value + part * (column.at(row + 1) - value)
                } else {
                    value
                }
            })
        })
    }

    fn same(&self, input: usize, order: usize) -> Option<f64> {
        match self.0[input][order] {
            Column::Same(value) => Some(value),
            Column::Each(_) => None,
        }
    }

    #[cfg(feature = "alloc")]
    fn check(&self, _: [f64; 2], rows: usize) -> Result<(), SweepError> {
        let inputs = self.0.as_ref().iter().zip(M::DESCRIPTION.inputs);
        let mut lengths = inputs.flat_map(|(orders, quantity)| {
            orders.as_ref().iter().filter_map(|column| match column {
                Column::Same(_) => None,
                Column::Each(values) => Some((quantity.name, values.len())),
            })
        });
        lengths
            .find(|(_, length)| *length != rows)
            .map_or(Ok(()), |(quantity, length)| {
                Err(SweepError::Columns(LengthMismatch {
                    quantity,
                    poses: rows,
                    length,
                }))
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::{Rise, Sequence, Shape};
    use crate::library::{FiveBar, FourBar};

    /// The other input moves in proportion, and both arrive exactly.
    #[test]
    fn a_line_leads_all_inputs_to_their_ends() {
        let mut line = StraightLine::<FiveBar>::new([1.0, 2.0], [4.0, 0.1]);
        line.speed = 6.0;
        let motions = |at| Drive::<FiveBar>::motions(&line, at).map(|motion| motion.derivatives());
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
        let drive = Laws::<FourBar>([&rise]);
        let [motion] = SmoothDrive::<FourBar>::derivatives(&drive, 0.2, Side::Right);
        let series: [Local; 5] = core::array::from_fn(|order| by_time(motion.as_ref(), order, 1.0));
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
        let joints = |drive: &Laws<'_, FourBar>| {
            let mut places = std::vec![];
            let mut after = -0.1;
            while let Some(next) = drive.next_joint(after).filter(|joint| *joint < 1.6) {
                places.push(next);
                after = next;
            }
            places
        };
        assert_eq!(joints(&Laws::<FourBar>([&laws])), [0.0, 0.5, 0.75]);
        let cam = laws.repeated();
        assert_eq!(joints(&Laws::<FourBar>([&cam])), [0.0, 0.5, 0.75, 1.25, 1.5]);
    }
}
