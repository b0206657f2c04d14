//! Motion within limits of velocity, acceleration, jerk and snap.

use num_traits::Float;

use super::LawError;
use super::error::{finite, positive};
use super::piecewise::Piecewise;
use crate::number::Number;

/// What a drive can do, as absolute values that hold in both directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<T = f64> {
    /// The largest velocity.
    pub velocity: T,
    /// The largest acceleration.
    pub acceleration: T,
    /// The largest jerk.
    pub jerk: T,
    /// The largest snap. Without it the jerk may jump.
    pub snap: Option<T>,
}

/// The phases of the acceleration, and constant speed.
const PHASES: usize = 8;

/// The phases of the whole motion: the acceleration, constant speed, and the deceleration.
const PIECES: usize = 2 * PHASES - 1;

/// The sign of the snap in each phase.
const SNAP: [f64; PHASES] = [1.0, 0.0, -1.0, 0.0, -1.0, 0.0, 1.0, 0.0];

/// The sign of the jerk at the start of each phase.
const JERK: [f64; PHASES] = [0.0, 1.0, 1.0, 0.0, 0.0, -1.0, -1.0, 0.0];

/// An S-curve: from rest to rest over a distance within [`Limits`].
///
/// Without a limit of the snap it has seven phases: the jerk is at its limit or zero. With it there are fifteen, and
/// the snap is at its limit or zero. A phase vanishes if its limit is not reached, so that at every instant one limit
/// is.
///
/// The velocity is a rectangle smoothed by the mean over two or three times w₁ < w₂ < w₃, as long as the limits ask
/// for:
///
/// ```text
/// jerk = snap w₁     acceleration = jerk w₂     velocity = acceleration w₃     distance = velocity w₄
/// w₂ ≥ w₁     w₃ ≥ w₁ + w₂     w₄ ≥ w₁ + w₂ + w₃     duration = w₁ + w₂ + w₃ + w₄
/// ```
///
/// With seven phases, w₁ is zero, and the motion is the shortest that the limits allow. With fifteen phases it is the
/// shortest of this form, whose acceleration rises and falls symmetrically. If the snap alone limits it, a motion with
/// unequal phases is 7 % shorter: for a snap S and a distance D, the duration is (512 D/S)^(1/4) instead of (384
/// D/S)^(1/4).
///
/// Source: P. Lambrechts, M. Boerlage, M. Steinbuch, *Trajectory planning and feedforward design for electromechanical
/// motion systems*, Control Engineering Practice 13, 2005, pages 145 to 157.
///
/// ```
/// use kin_core::law::{Law, Limits, Piecewise, SCurve};
///
/// let limits = Limits { velocity: 2.0, acceleration: 10.0, jerk: 200.0, snap: None };
/// let servo: SCurve = SCurve::new(0.0, 1.0, limits)?;
/// // 1/2 s at full speed, 1/5 s of acceleration, and 1/20 s until it is reached
/// assert!((servo.duration() - 0.75).abs() < 1e-15);
/// assert_eq!(servo.at::<3>(0.375).derivatives(), [0.5, 2.0, 0.0]);
/// # Ok::<(), kin_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SCurve<T = f64> {
    from: T,
    to: T,
    /// 1 or -1.
    direction: T,
    /// The time at which each phase of the acceleration starts.
    starts: [T; PHASES],
    /// The length of each phase. The differences of the starts would be rounded to parts of the duration.
    lengths: [T; PHASES],
    /// Distance, velocity, acceleration and jerk there.
    states: [[T; 4]; PHASES],
    snap: T,
    duration: T,
}

impl<T: Number> SCurve<T> {
    /// The motion from rest at one value to rest at another.
    ///
    /// # Errors
    /// [`LawError::NotFinite`] for the values, [`LawError::NoMove`] if they are equal, [`LawError::NotPositive`] for a
    /// limit, and [`LawError::OutOfRange`] if limits and distance are too far apart for the number type.
    pub fn new(from: T, to: T, limits: Limits<T>) -> Result<Self, LawError> {
        finite("value from which the S-curve starts", from)?;
        finite("value at which the S-curve ends", to)?;
        let ahead = to - from;
        let direction = T::constant(if ahead.real() < 0.0 { -1.0 } else { 1.0 });
        if ahead.real() == 0.0 {
            return Err(LawError::NoMove { value: to.real() });
        }
        let distance = positive("distance of the S-curve", direction * ahead)?;
        positive("limit of the velocity", limits.velocity)?;
        positive("limit of the acceleration", limits.acceleration)?;
        positive("limit of the jerk", limits.jerk)?;
        if let Some(snap) = limits.snap {
            positive("limit of the snap", snap)?;
        }
        let plan = Plan::new(distance, limits);
        let (starts, states) = plan.phases();
        let duration = starts[PHASES - 1] + plan.lengths[PHASES - 1] + starts[PHASES - 1];
        for (quantity, value) in [
            ("duration of the S-curve", duration),
            ("velocity of the S-curve", plan.velocity),
            ("acceleration of the S-curve", plan.acceleration),
            ("jerk of the S-curve", plan.jerk),
        ] {
            positive(quantity, value).map_err(|_| LawError::OutOfRange {
                quantity,
                value: value.real(),
            })?;
        }
        Ok(Self {
            from,
            to,
            direction,
            starts,
            lengths: plan.lengths,
            states,
            snap: limits.snap.unwrap_or(T::constant(0.0)),
            duration,
        })
    }
}

impl<T: Number> SCurve<T> {
    /// The time since the start of a phase, not beyond its ends.
    ///
    /// A time is rounded to a part of the duration, which may be much of a short phase: without this the phase would
    /// last longer, and exceed a limit.
    fn within(&self, phase: usize, since: T) -> T {
        let time = since.real();
        since - T::constant(time - time.max(0.0).min(self.lengths[phase].real()))
    }
}

impl<T: Number> Piecewise<T> for SCurve<T> {
    fn pieces(&self) -> usize {
        PIECES
    }

    fn end(&self, piece: usize) -> T {
        if piece + 1 < PHASES {
            self.starts[piece + 1]
        } else {
            self.duration - self.starts[PIECES - 1 - piece]
        }
    }

    /// The deceleration is the acceleration seen from the end, so that rounding leaves no gap there.
    fn write(&self, piece: usize, time: T, derivatives: &mut [T]) {
        let is_second = piece >= PHASES;
        let (phase, time) = if is_second {
            (PIECES - 1 - piece, self.duration - time)
        } else {
            (piece, time)
        };
        let since = self.within(phase, time - self.starts[phase]);
        let [distance, velocity, acceleration, jerk] = self.states[phase];
        let rates = [
            distance,
            velocity,
            acceleration,
            jerk,
            self.snap * T::constant(SNAP[phase]),
        ];
        derivatives.fill(T::constant(0.0));
        for (order, entry) in derivatives.iter_mut().take(rates.len()).enumerate() {
            *entry = taylor(&rates[order..], since) * self.direction;
        }
        if is_second {
            for entry in derivatives.iter_mut().step_by(2) {
                *entry = -*entry;
            }
        }
        if let Some(value) = derivatives.first_mut() {
            *value = *value + if is_second { self.to } else { self.from };
        }
    }
}

/// The value after a time, from a value and its derivatives.
fn taylor<T: Number>(rates: &[T], since: T) -> T {
    let mut sum = T::constant(0.0);
    let mut order = rates.len();
    for rate in rates.iter().rev() {
        let divisor = T::constant(NUMBERS[order]);
        sum = *rate + sum * since / divisor;
        order -= 1;
    }
    sum
}

const NUMBERS: [f64; 6] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];

/// The quantity that ends the growth of the acceleration.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Bound {
    Jerk,
    Acceleration,
    Velocity,
    Distance,
}

/// The lengths of the phases, and the peaks.
struct Plan<T> {
    lengths: [T; PHASES],
    velocity: T,
    acceleration: T,
    jerk: T,
}

impl<T: Number> Plan<T> {
    fn new(distance: T, limits: Limits<T>) -> Self {
        let two = T::constant(2.0);
        let (first, jerk, bound) = match limits.snap {
            None => (T::constant(0.0), limits.jerk, Bound::Jerk),
            Some(snap) => {
                let (time, bound) = least([
                    (limits.jerk / snap, Bound::Jerk),
                    ((limits.acceleration / snap).sqrt(), Bound::Acceleration),
                    (
                        lengthened(T::constant(0.0), limits.velocity / (two * snap)),
                        Bound::Velocity,
                    ),
                    ((distance / (T::constant(8.0) * snap)).sqrt().sqrt(), Bound::Distance),
                ]);
                let jerk = if bound == Bound::Jerk { limits.jerk } else { snap * time };
                (time, jerk, bound)
            }
        };
        let (second, acceleration, bound) = if bound == Bound::Jerk {
            let (time, bound) = least([
                (limits.acceleration / jerk, Bound::Acceleration),
                (longer(first, limits.velocity / jerk), Bound::Velocity),
                (lengthened(first, distance / (two * jerk)), Bound::Distance),
            ]);
            let reached = bound == Bound::Acceleration;
            let acceleration = if reached { limits.acceleration } else { jerk * time };
            (at_least(time, first), acceleration, bound)
        } else {
            let reached = bound == Bound::Acceleration;
            let acceleration = if reached { limits.acceleration } else { jerk * first };
            (first, acceleration, bound)
        };
        let shortest = first + second;
        let (third, velocity, bound) = if bound == Bound::Acceleration {
            let (time, bound) = least([
                (limits.velocity / acceleration, Bound::Velocity),
                (longer(shortest, distance / acceleration), Bound::Distance),
            ]);
            let time = at_least(time, shortest);
            let reached = bound == Bound::Velocity;
            (time, if reached { limits.velocity } else { acceleration * time }, bound)
        } else {
            let reached = bound == Bound::Velocity;
            let velocity = if reached {
                limits.velocity
            } else {
                acceleration * shortest
            };
            (shortest, velocity, bound)
        };
        let [at_jerk, at_acceleration] = [second - first, third - shortest];
        let shortest = shortest + third;
        let at_velocity = if bound == Bound::Velocity {
            at_least(distance / velocity, shortest) - shortest
        } else {
            T::constant(0.0)
        };
        Self {
            lengths: [
                first,
                at_jerk,
                first,
                at_acceleration,
                first,
                at_jerk,
                first,
                at_velocity,
            ],
            velocity,
            acceleration,
            jerk,
        }
    }

    /// The start of each phase, and distance, velocity, acceleration and jerk there.
    fn phases(&self) -> ([T; PHASES], [[T; 4]; PHASES]) {
        let [first, ..] = self.lengths;
        let half = T::constant(0.5);
        let zero = T::constant(0.0);
        let early = half * self.jerk * first;
        let accelerations = [
            zero,
            early,
            self.acceleration - early,
            self.acceleration,
            self.acceleration,
            self.acceleration - early,
            early,
            zero,
        ];
        let mut starts = [zero; PHASES];
        let mut states = [[zero; 4]; PHASES];
        for phase in 0..PHASES {
            let [distance, velocity] = match phase.checked_sub(1) {
                None => [zero, zero],
                Some(before) => {
                    let length = self.lengths[before];
                    starts[phase] = starts[before] + length;
                    self.after(states[before], SNAP[before], length)
                }
            };
            let jerk = self.jerk * T::constant(JERK[phase]);
            states[phase] = [distance, velocity, accelerations[phase], jerk];
        }
        // by symmetry, so that the last phases do not exceed the velocity by rounding
        for (phase, earlier) in [(4, 3), (5, 2), (6, 1), (7, 0)] {
            states[phase][1] = self.velocity - states[earlier][1];
        }
        (starts, states)
    }

    /// Distance and velocity after a phase.
    fn after(&self, [distance, velocity, acceleration, jerk]: [T; 4], sign: f64, length: T) -> [T; 2] {
        // the snap is the rate at which the jerk reaches its peak
        let [first, ..] = self.lengths;
        let snap = if first.real() > 0.0 {
            self.jerk / first * T::constant(sign)
        } else {
            T::constant(0.0)
        };
        let rates = [distance, velocity, acceleration, jerk, snap];
        [taylor(&rates, length), taylor(&rates[1..], length)]
    }
}

/// The shortest time and what bounds it; the first of equal ones.
fn least<T: Number, const K: usize>(times: [(T, Bound); K]) -> (T, Bound) {
    let mut shortest = times[0];
    for candidate in times {
        if candidate.0.real() < shortest.0.real() {
            shortest = candidate;
        }
    }
    shortest
}

/// The time, or the shortest one possible if rounding made it shorter.
fn at_least<T: Number>(time: T, shortest: T) -> T {
    if time.real() < shortest.real() { shortest } else { time }
}

/// The positive root x of x (before + x) = area.
fn longer<T: Number>(before: T, area: T) -> T {
    let root = (before * before + T::constant(4.0) * area).sqrt();
    T::constant(2.0) * area / (before + root)
}

/// The positive root x of x (before + x)² = volume, by Newton's method from above, where the function is convex.
fn lengthened<T: Number>(before: T, volume: T) -> T {
    let three = T::constant(3.0);
    let step = |x: T| {
        let sum = before + x;
        x - (x * sum * sum - volume) / (sum * (before + three * x))
    };
    let mut root = T::constant(Float::cbrt(volume.real()));
    // it converges quadratically, and from above until rounding stops it
    for _ in 0..64 {
        let next = step(root);
        let is_lower = next.real() < root.real();
        root = next;
        if !is_lower {
            break;
        }
    }
    // each step makes one more derivative right at least
    for _ in 0..T::ORDER {
        root = step(root);
    }
    root
}
