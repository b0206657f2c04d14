//! Laws as rows of pieces, each with one formula.

use num_traits::Float;

use super::continuity::LawJoints;
use crate::motion::Motion;
use crate::number::Number;

/// The side from which a time is approached where two pieces meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// From earlier times.
    Left,
    /// From later times.
    Right,
}

/// A law as a row of pieces, each with one formula: what a law of your own implements.
///
/// The methods to use are those of [`Law`], which every such type has. The first piece starts at time zero. A piece may
/// have no length; it is then left out.
///
/// ```
/// use kin_core::law::{Law, Piecewise};
///
/// /// A pendulum's swing, over one period of 2π.
/// struct Swing;
///
/// impl Piecewise<f64> for Swing {
///     fn end(&self, _: usize) -> f64 {
///         std::f64::consts::TAU
///     }
///
///     fn write(&self, _: usize, time: f64, derivatives: &mut [f64]) {
///         let (sine, cosine) = time.sin_cos();
///         for (order, entry) in derivatives.iter_mut().enumerate() {
///             *entry = [cosine, -sine, -cosine, sine][order % 4];
///         }
///     }
/// }
///
/// assert_eq!(Swing.at::<3>(0.0).derivatives(), [1.0, 0.0, -1.0]);
/// ```
pub trait Piecewise<T: Number> {
    /// The number of pieces, which is one at least.
    fn pieces(&self) -> usize {
        1
    }

    /// The time at which a piece ends and the next one starts.
    fn end(&self, piece: usize) -> T;

    /// Writes the value and its derivatives at a time, by the formula of one piece. The index is the order.
    fn write(&self, piece: usize, time: T, derivatives: &mut [T]);

    /// Whether the law starts again at its end.
    fn repeats(&self) -> bool {
        false
    }

    /// The time that the law takes; the length of one cycle if it repeats.
    fn duration(&self) -> T {
        self.end(self.pieces() - 1)
    }

    /// The piece to which a time belongs. Where two pieces meet, `side` selects one.
    fn piece(&self, time: f64, side: Side) -> usize {
        let (mut found, mut start) = (None, 0.0);
        for piece in 0..self.pieces() {
            let end = self.end(piece).real();
            if end > start {
                let is_past = start < time || (start == time && side == Side::Right);
                if found.is_some() && !is_past {
                    break;
                }
                found = Some(piece);
                start = end;
            }
        }
        found.unwrap_or(0)
    }
}

impl<T: Number, L: Piecewise<T> + ?Sized> Piecewise<T> for &L {
    fn pieces(&self) -> usize {
        (**self).pieces()
    }

    fn end(&self, piece: usize) -> T {
        (**self).end(piece)
    }

    fn write(&self, piece: usize, time: T, derivatives: &mut [T]) {
        (**self).write(piece, time, derivatives);
    }

    fn repeats(&self) -> bool {
        (**self).repeats()
    }

    fn duration(&self) -> T {
        (**self).duration()
    }

    fn piece(&self, time: f64, side: Side) -> usize {
        (**self).piece(time, side)
    }
}

/// A motion law. Its methods work with every [`Piecewise`] type, trait objects included.
///
/// Times and values may be any [`Number`] that holds one pose; the real part of the time selects the piece.
pub trait Law<T: Number>: Piecewise<T> {
    /// The value and its derivatives at a time.
    ///
    /// Where two pieces meet, they are those of the right side, the later piece. Before its start and after its end a
    /// law rests at the value there, unless it repeats; at the end itself the motion is that of the last piece.
    ///
    /// A time that is not finite may give NaN, and derivatives that exceed the range of the number type are infinite or
    /// NaN: `solve` refuses both with [`Failure::NotFinite`](crate::Failure::NotFinite).
    ///
    /// ```
    /// use kin_core::law::{Law, Rise, Shape};
    ///
    /// let rise = Rise::new(Shape::Polynomial345, 0.0, 30.0, 2.0)?;
    /// let middle = rise.at::<5>(1.0);
    /// assert_eq!(middle.position(), 15.0);
    /// // the largest velocity is 1.875 times the mean
    /// assert_eq!(middle.velocity(), 1.875 * 30.0 / 2.0);
    /// assert_eq!(rise.at::<2>(5.0).derivatives(), [30.0, 0.0]);
    /// # Ok::<(), kin_core::law::LawError>(())
    /// ```
    #[must_use]
    fn at<const N: usize>(&self, time: T) -> Motion<T, N> {
        approached(self, time, Side::Right)
    }

    /// The motion in time of what the law prescribes over a driving angle, from the motion of that angle, by the chain
    /// rule.
    ///
    /// Where two pieces meet, the piece that the angle moves into is taken: the later one, or the earlier one if the
    /// angle decreases.
    ///
    /// ```
    /// use kin_core::Motion;
    /// use kin_core::law::{Law, Rise, Shape};
    ///
    /// // 30 mm over 120 degrees of a cam that rotates at 10 rad/s
    /// let rise = Rise::new(Shape::Cycloidal, 0.0, 30.0, 120_f64.to_radians())?;
    /// let cam: Motion = Motion::at_constant_speed(1.0, 10.0);
    /// let follower = rise.driven(cam);
    /// let jerk = 1000.0 * rise.at::<5>(1.0).jerk();
    /// assert!((follower.jerk() - jerk).abs() < 1e-14 * jerk.abs());
    /// # Ok::<(), kin_core::law::LawError>(())
    /// ```
    #[must_use]
    fn driven<const N: usize>(&self, drive: Motion<T, N>) -> Motion<T, N> {
        let rates = drive.as_slice().get(1..).unwrap_or(&[]);
        let direction = rates.iter().map(|rate| rate.real()).find(|&rate| rate != 0.0);
        let side = match direction {
            Some(rate) if rate < 0.0 => Side::Left,
            _ => Side::Right,
        };
        approached(self, drive.value(), side).driven_by(drive)
    }

    /// The joints where pieces meet, with the jump of every derivative below order `N`.
    ///
    /// The start and the end of a law are joints too: with the end of the law if it repeats, with rest otherwise.
    ///
    /// ```
    /// use kin_core::law::{Law, Rise, Shape};
    ///
    /// let rise = Rise::new(Shape::Polynomial345, 0.0, 1.0, 1.0)?;
    /// let [start, end] = [0, 1].map(|number| rise.joints::<5>().nth(number).unwrap());
    /// assert_eq!(start.to_string(), "C2 at 0: jerk jumps by 60, snap jumps by -360");
    /// assert_eq!(end.continuity(), Some(2));
    /// assert_eq!(end.jump().jerk(), -60.0);
    /// # Ok::<(), kin_core::law::LawError>(())
    /// ```
    fn joints<const N: usize>(&self) -> LawJoints<'_, T, Self, N> {
        LawJoints::new(self)
    }

    /// The law again and again.
    fn repeated(self) -> Repeated<Self>
    where
        Self: Sized,
    {
        Repeated(self)
    }
}

impl<T: Number, L: Piecewise<T> + ?Sized> Law<T> for L {}

/// The motion at a time, by the formula of one piece.
pub(super) fn of_piece<T: Number, L: Piecewise<T> + ?Sized, const N: usize>(
    law: &L,
    piece: usize,
    time: T,
) -> Motion<T, N> {
    let mut motion = Motion::constant(T::constant(0.0));
    law.write(piece, time, motion.as_mut());
    motion
}

/// The motion at a time, from one side.
pub(crate) fn approached<T: Number, L: Piecewise<T> + ?Sized, const N: usize>(
    law: &L,
    time: T,
    side: Side,
) -> Motion<T, N> {
    let duration = law.duration();
    if law.repeats() {
        let quotient = time.real() / duration.real();
        let below = Float::floor(quotient);
        // at the end of a cycle, its left side belongs to the cycle before
        let cycle = if side == Side::Left && below == quotient {
            below - 1.0
        } else {
            below
        };
        let local = time - duration * T::constant(cycle);
        return of_piece(law, law.piece(local.real(), side), local);
    }
    let outside = if time.real() < 0.0 {
        Some(T::constant(0.0))
    } else if time.real() > duration.real() {
        Some(duration)
    } else {
        None
    };
    match outside {
        Some(end) => Motion::constant(approached::<T, L, 1>(law, end, side).value()),
        None => of_piece(law, law.piece(time.real(), side), time),
    }
}

/// A law that starts again whenever it ends, as that of a cam.
///
/// Its value at the end should be that at the start; [`Law::joints`] says whether it is.
///
/// ```
/// use kin_core::law::{Law, Rise, Sequence, Shape};
///
/// let rise = Rise::new(Shape::Cycloidal, 0.0, 10.0, 2.0)?;
/// let fall = Rise::new(Shape::Cycloidal, 10.0, 0.0, 3.0)?;
/// let cam = Sequence::new([&rise, &fall])?.repeated();
/// assert_eq!(cam.at::<1>(-1.0), cam.at::<1>(4.0));
/// assert!(cam.joints::<3>().all(|joint| joint.continuity() == Some(2)));
/// # Ok::<(), kin_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeated<L>(pub L);

impl<T: Number, L: Piecewise<T>> Piecewise<T> for Repeated<L> {
    fn pieces(&self) -> usize {
        self.0.pieces()
    }

    fn end(&self, piece: usize) -> T {
        self.0.end(piece)
    }

    fn write(&self, piece: usize, time: T, derivatives: &mut [T]) {
        self.0.write(piece, time, derivatives);
    }

    fn repeats(&self) -> bool {
        true
    }

    fn duration(&self) -> T {
        self.0.duration()
    }

    fn piece(&self, time: f64, side: Side) -> usize {
        self.0.piece(time, side)
    }
}
