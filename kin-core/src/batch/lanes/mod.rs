//! A number type that holds several numbers, for several poses at once.
//!
//! Every operation is a short loop over an array, without a branch. A compiler turns it into the widest vector
//! instructions that the calling function may use. There are no intrinsics.
//!
//! Each lane decides for itself: where a solver would stop for one of the numbers, that lane becomes NaN and stays NaN,
//! while the other lanes continue. So a lane that is finite at the end has passed every test. A lane also becomes NaN
//! where lanes cannot solve a pose (huge angles, an iteration that must be damped) or where [rounding](Scalar::DOUBT)
//! would decide. The caller must then ask the ordinary solver about these poses.

mod newton;

use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::Float;

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::number::elementary::{is_near, near_sine_cosine, ordinary_arc_tangent, turned_round};
use crate::number::{Number, Row};
use crate::solve::{Check, Choose, Measure, Scalar};

/// `W` numbers. If they are `FUSED`, multiply-add is one step where functions ask for it.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct Lanes<const W: usize, const FUSED: bool>(pub(crate) [f64; W]);

impl<const W: usize, const FUSED: bool> Lanes<W, FUSED> {
    #[inline(always)]
    pub(crate) fn from_fn(mut function: impl FnMut(usize) -> f64) -> Self {
        let mut lanes = [0.0; W];
        for (lane, entry) in lanes.iter_mut().enumerate() {
            *entry = function(lane);
        }
        Self(lanes)
    }

    #[inline(always)]
    fn map(self, function: impl Fn(f64) -> f64) -> Self {
        Self::from_fn(|lane| function(self.0[lane]))
    }

    #[inline(always)]
    fn with(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        Self::from_fn(|lane| function(self.0[lane], other.0[lane]))
    }

    /// The sum of all lanes, which is not finite if one of them is not.
    #[inline(always)]
    pub(crate) fn sum(self) -> f64 {
        // Add one by one: with pairs, a compiler would arrange everything before in vectors of two.
        let mut sum = 0.0;
        for entry in self.0 {
            sum += entry;
        }
        sum
    }

    /// The values in one lane.
    #[inline(always)]
    fn at<const N: usize>(numbers: &[Self; N], lane: usize) -> [f64; N] {
        let mut values = [0.0; N];
        for (value, number) in values.iter_mut().zip(numbers) {
            *value = number.0[lane];
        }
        values
    }
}

impl<const W: usize, const FUSED: bool> Add for Lanes<W, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl<const W: usize, const FUSED: bool> Sub for Lanes<W, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl<const W: usize, const FUSED: bool> Mul for Lanes<W, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl<const W: usize, const FUSED: bool> Div for Lanes<W, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(other, |a, b| a / b)
    }
}

impl<const W: usize, const FUSED: bool> Neg for Lanes<W, FUSED> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl<const W: usize, const FUSED: bool> Number for Lanes<W, FUSED> {
    const EPSILON: f64 = f64::EPSILON;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([value; W])
    }

    /// Only reports use it, and nobody reads them.
    #[inline(always)]
    fn real(self) -> f64 {
        self.0[0]
    }

    /// Always true: callers that solve in lanes test each lane at the end.
    #[inline(always)]
    fn is_finite(self) -> bool {
        true
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(Float::sqrt)
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (mut sine, mut cosine) = (self, self);
        for lane in 0..W {
            let angle = self.0[lane];
            // NaN where the polynomials are not valid.
            let angle = if is_near(angle) { angle } else { f64::NAN };
            (sine.0[lane], cosine.0[lane]) = near_sine_cosine::<FUSED, FUSED>(angle);
        }
        (sine, cosine)
    }

    #[inline(always)]
    fn asin(self) -> Self {
        self.atan2(leg(self))
    }

    #[inline(always)]
    fn acos(self) -> Self {
        leg(self).atan2(self)
    }

    #[inline(always)]
    fn atan(self) -> Self {
        self.atan2(Self::constant(1.0))
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.with(x, |y, x| {
            let (angle, ordinary) = ordinary_arc_tangent::<FUSED, FUSED>(y, x);
            if FUSED || ordinary { angle } else { f64::NAN }
        })
    }

    #[inline(always)]
    fn sinh(self) -> Self {
        self.map(Number::sinh)
    }

    #[inline(always)]
    fn cosh(self) -> Self {
        self.map(Number::cosh)
    }

    #[inline(always)]
    fn tanh(self) -> Self {
        self.map(Number::tanh)
    }

    #[inline(always)]
    fn asinh(self) -> Self {
        self.map(Number::asinh)
    }

    #[inline(always)]
    fn acosh(self) -> Self {
        self.map(Number::acosh)
    }

    #[inline(always)]
    fn atanh(self) -> Self {
        self.map(Number::atanh)
    }

    #[inline(always)]
    fn exp(self) -> Self {
        self.map(Float::exp)
    }

    #[inline(always)]
    fn ln(self) -> Self {
        self.map(Float::ln)
    }

    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        if FUSED {
            Self::from_fn(|lane| Float::mul_add(a.0[lane], b.0[lane], self.0[lane]))
        } else {
            self + a * b
        }
    }

    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        if FUSED {
            Self::from_fn(|lane| Float::mul_add(-a.0[lane], b.0[lane], self.0[lane]))
        } else {
            self - a * b
        }
    }
}

impl<const W: usize, const FUSED: bool> Scalar for Lanes<W, FUSED> {
    /// About 4500 ε: the steps before a sum may have magnified rounding a thousand times.
    const DOUBT: f64 = 1e-12;

    #[inline(always)]
    fn provided<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<Self> {
        let operands = check.operands();
        let mut kept = self;
        for lane in 0..W {
            // One condition after the other: the compiler vectorises a comparison with a selection, but not a
            // conjunction.
            for holds in check.holds(Self::at(&operands, lane)) {
                kept.0[lane] = if holds { kept.0[lane] } else { f64::NAN };
            }
        }
        Some(kept)
    }

    #[inline(always)]
    fn either<const N: usize>(
        check: impl Check<Self, N, 1>,
        one: impl FnOnce() -> Self,
        other: impl FnOnce() -> Self,
    ) -> Self {
        let operands = check.operands();
        let (one, other) = (one(), other());
        Self::from_fn(|lane| {
            let [holds] = check.holds(Self::at(&operands, lane));
            if holds { one.0[lane] } else { other.0[lane] }
        })
    }

    #[inline(always)]
    fn times_sign_of(self, other: Self) -> Self {
        self.with(other, |a, b| turned_round(a, b.to_bits()))
    }

    #[inline(always)]
    fn measured<const N: usize>(measure: impl Measure<Self, N>) -> Self {
        let operands = measure.operands();
        Self::from_fn(|lane| measure.measure(Self::at(&operands, lane)))
    }

    #[inline(always)]
    fn chosen<const N: usize>(choice: impl Choose<Self, N>) -> Result<Assembly, Failure> {
        let operands = choice.operands();
        let first = choice.choose(Self::at(&operands, 0))?;
        for lane in 1..W {
            if choice.choose(Self::at(&operands, lane))? != first {
                return Err(Failure::NotFinite { quantity: "lanes" });
            }
        }
        Ok(first)
    }

    /// The pivot as for one pose. Sizes are computed again instead of kept, which saves one percent of the instructions
    /// of Newton's method.
    #[inline(always)]
    fn pivot<R: Row<Self>>(rows: &[R], step: usize) -> usize {
        let size_of = |row: &R| row[step].leading().abs();
        let mut best = step;
        for row in step + 1..rows.len() {
            if size_of(&rows[row]) > size_of(&rows[best]) {
                best = row;
            }
        }
        best
    }

    /// The first lane leads.
    #[inline(always)]
    fn leading(self) -> f64 {
        self.0[0]
    }

    #[inline(always)]
    fn root<const N: usize>(
        guess: [Self; N],
        sizes: [Self; N],
        evaluate: impl FnMut([Self; N]) -> ([Self; N], [[Self; N]; N]),
    ) -> Result<[Self; N], Failure> {
        newton::root(guess, sizes, evaluate)
    }
}

/// The other leg of a right triangle whose hypotenuse is 1.
#[inline(always)]
fn leg<const W: usize, const FUSED: bool>(known: Lanes<W, FUSED>) -> Lanes<W, FUSED> {
    let one = Lanes::constant(1.0);
    ((one - known) * (one + known)).sqrt()
}
