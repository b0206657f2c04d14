//! The tracking of one solution while the system is deformed.

use num_traits::Float;

use super::complex::Complex;
use super::homotopy::{Homotopy, Linearised};

/// The care with which a path is followed, relative to coordinates of size one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Care {
    /// The target for the distance between prediction and path. Twice this distance is accepted.
    pub(super) prediction: f64,
    /// The largest ratio of the second step of Newton's method to the first.
    ///
    /// By the theorem of Newton and Kantorovich, with quadratic convergence this ratio compares the distance from the
    /// path with the radius within which there is no other path.
    pub(super) contraction: f64,
}

/// The care at first, and for paths that may have been lost.
pub(super) const CARE: [Care; 3] = [
    Care {
        prediction: 1e-4,
        contraction: 1e-2,
    },
    Care {
        prediction: 1e-6,
        contraction: 1e-3,
    },
    Care {
        prediction: 1e-8,
        contraction: 1e-3,
    },
];

/// The error of the points of a path.
const ACCURACY: f64 = 1e-10;
/// Rounding tolerated near singular points.
const NOISE: f64 = 1e-9;
/// The number of steps after which a path is given up.
const MOST_STEPS: usize = 5_000;

/// A point that moves along a path.
#[derive(Clone, Debug)]
pub(super) struct Traveller<'a, const M: usize> {
    pub(super) homotopy: Homotopy<'a, M>,
    pub(super) point: [Complex; M],
    pub(super) t: Complex,
    /// The length of the next step.
    step: f64,
    /// The tangent dy/dt at the point.
    tangent: [Complex; M],
    steps: usize,
}

/// The outcome of an advance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Advance {
    /// The target has been reached.
    Arrived,
    /// Steps became too short or too many.
    Stuck,
}

/// The change of the pinned coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pinned {
    /// The same coordinate is pinned as before.
    Same,
    /// Another coordinate is pinned.
    Other,
    /// Another coordinate is pinned, and the Jacobian is singular there.
    Singular,
}

impl<'a, const M: usize> Traveller<'a, M> {
    /// The traveller at a known solution, t = 1. `None` if there is no such solution.
    pub(super) fn depart(mut homotopy: Homotopy<'a, M>, choice: usize, at: &mut Linearised<M>) -> Option<Self> {
        let point = homotopy.start(choice, at)?;
        let mut traveller = Self {
            homotopy,
            point,
            t: Complex::ONE,
            step: 0.1,
            tangent: [Complex::ZERO; M],
            steps: 0,
        };
        traveller.homotopy.pin_largest(&mut traveller.point);
        traveller.homotopy.newton(&mut traveller.point, Complex::ONE, at)?;
        traveller.face(at).then_some(traveller)
    }

    /// Moves towards a target on a straight line. Stops before it if steps become shorter than the given one.
    pub(super) fn advance(
        &mut self,
        target: Complex,
        shortest: f64,
        pin: bool,
        care: Care,
        at: &mut Linearised<M>,
    ) -> Advance {
        loop {
            let way = target - self.t;
            let distance = way.norm();
            if distance == 0.0 {
                return Advance::Arrived;
            }
            let last = self.step >= distance;
            let (next, step) = if last {
                (target, way)
            } else {
                let step = way.scale(self.step / distance);
                (self.t + step, step)
            };
            if self.steps >= MOST_STEPS || step.norm() < shortest.min(distance) {
                return Advance::Stuck;
            }
            self.steps += 1;
            let corrected = self.predict(step, at).map(|mut point| {
                let error = self.correct(&mut point, next, care, at);
                (point, error)
            });
            match corrected {
                Some((point, Ok(error))) => {
                    self.point = point;
                    self.t = next;
                    // The Jacobian of the last correction belongs to a point close enough to use it here.
                    self.homotopy.tangent(at, &mut self.tangent);
                    // The error of the prediction grows with the fifth power of the step.
                    let factor = Float::powf(0.5 * care.prediction / error.max(1e-3 * care.prediction), 0.2);
                    let proposed = step.norm() * factor.min(2.0);
                    // A step that was shortened is no reason against longer ones.
                    self.step = if last { proposed.max(self.step) } else { proposed };
                    if pin && self.pin(at) == Pinned::Singular {
                        return Advance::Stuck;
                    }
                }
                Some((_, Err(error))) if error.is_finite() => {
                    let factor = Float::powf(0.5 * care.prediction / error, 0.2);
                    self.step = step.norm() * factor.clamp(0.1, 0.5);
                }
                _ => self.step = 0.25 * step.norm(),
            }
        }
    }

    /// Pins the largest coordinate if it is much larger than the pinned one.
    pub(super) fn pin(&mut self, at: &mut Linearised<M>) -> Pinned {
        if !self.homotopy.pin_largest(&mut self.point) {
            Pinned::Same
        } else if self.face(at) {
            Pinned::Other
        } else {
            Pinned::Singular
        }
    }

    /// Finds the tangent at the point.
    fn face(&mut self, at: &mut Linearised<M>) -> bool {
        self.homotopy.evaluate(&self.point, self.t, at);
        let regular = at.factors.factorise(self.homotopy.free());
        if regular {
            self.homotopy.tangent(at, &mut self.tangent);
        }
        regular
    }

    /// The point after a step of the Runge-Kutta method of fourth order.
    fn predict(&self, step: Complex, at: &mut Linearised<M>) -> Option<[Complex; M]> {
        let free = self.homotopy.free();
        let mut slope = self.tangent;
        let mut sum = self.tangent;
        for (fraction, weight) in [(0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
            let part = step.scale(fraction);
            let mut point = self.point;
            for (value, slope) in point[..free].iter_mut().zip(&slope) {
                *value += *slope * part;
            }
            self.homotopy.evaluate(&point, self.t + part, at);
            if !at.factors.factorise(free) {
                return None;
            }
            self.homotopy.tangent(at, &mut slope);
            for (sum, slope) in sum[..free].iter_mut().zip(&slope) {
                *sum += slope.scale(weight);
            }
        }
        let sixth = step.scale(1.0 / 6.0);
        let mut point = self.point;
        for (value, sum) in point[..free].iter_mut().zip(&sum) {
            *value += *sum * sixth;
        }
        Some(point)
    }

    /// Corrects by Newton's method. Returns the error of the prediction, as an `Err` if it is too large.
    fn correct(&self, point: &mut [Complex; M], t: Complex, care: Care, at: &mut Linearised<M>) -> Result<f64, f64> {
        let Some(first) = self.homotopy.newton(point, t, at) else {
            return Err(f64::INFINITY);
        };
        if first.is_nan() || first > 2.0 * care.prediction {
            return Err(first);
        }
        let mut before = first;
        for _ in 0..3 {
            if before <= ACCURACY {
                return Ok(first);
            }
            let Some(next) = self.homotopy.newton(point, t, at) else {
                return Err(f64::INFINITY);
            };
            if next.is_nan() || next > (before * care.contraction).max(NOISE) {
                return Err(f64::INFINITY);
            }
            before = next;
        }
        if before <= NOISE { Ok(first) } else { Err(f64::INFINITY) }
    }
}

impl<const M: usize> Homotopy<'_, M> {
    /// One step of Newton's method at a fixed t, and its length; `None` if the Jacobian is singular.
    pub(super) fn newton(&self, point: &mut [Complex; M], t: Complex, at: &mut Linearised<M>) -> Option<f64> {
        let free = self.free();
        self.evaluate(point, t, at);
        if !at.factors.factorise(free) {
            return None;
        }
        at.factors.solve(free, &mut at.value);
        for (value, step) in point[..free].iter_mut().zip(&at.value) {
            *value = *value - *step;
        }
        Some(self.size(&at.value))
    }

    /// The tangent dy/dt, from the factors of the Jacobian.
    fn tangent(&self, at: &Linearised<M>, tangent: &mut [Complex; M]) {
        *tangent = at.rate;
        at.factors.solve(self.free(), tangent);
        for rate in &mut tangent[..self.free()] {
            *rate = -*rate;
        }
    }
}
