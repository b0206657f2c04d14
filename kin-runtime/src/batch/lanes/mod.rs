//! A number type that holds several numbers, for several poses at once.
//!
//! No operation has a branch. Arithmetic names its [vector instructions](instructions). The other operations are short
//! loops over an array, which a compiler converts into the widest vectors that the calling function may use.
//!
//! Each lane decides for itself: where a solver would stop for one of the numbers, that lane becomes NaN and stays NaN,
//! while the other lanes continue. So a lane that is finite at the end has passed every test. A lane also becomes NaN
//! where lanes cannot solve a pose (huge angles, an iteration that must be damped) or where [rounding](Scalar::DOUBT)
//! would decide. The caller must then ask the ordinary solver about these poses, except those for which the check that
//! failed has left a [verdict](verdicts).

/// Runs a block for each lane. A kernel has hundreds of these loops. Iterators and closures take a compiler several
/// times as long, and `for` loops take it longer, because it moves their tests to the end, where this one stands.
macro_rules! for_each_lane {
    ($lane:ident in $first:literal..$count:ident $block:block) => {
        let mut $lane = $first;
        loop {
            $block
            $lane += 1;
            if $lane == $count {
                break;
            }
        }
    };
}

pub(in crate::batch) use for_each_lane;

mod element;
mod instructions;
mod newton;
pub(in crate::batch) mod verdicts;

pub use element::Element;
use instructions::{Instructions, is_fused};

use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::Float;

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::number::elementary::{is_near, near_sine_cosine, ordinary_arc_tangent, sign_flipped};
use crate::number::{Number, real_parts};
use crate::solve::{Check, Choose, Equations, Measure, NewtonMemory, RowMeasure, Scalar};

/// `W` numbers, calculated with vectors of `BITS` bits.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct Lanes<const W: usize, const BITS: usize, E = f64>(pub(crate) [E; W]);

impl<const W: usize, const BITS: usize, E: Element> Lanes<W, BITS, E> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn from_fn(mut function: impl FnMut(usize) -> E) -> Self {
        let mut lanes = [E::zero(); W];
        for_each_lane!(lane in 0..W {
            lanes[lane] = function(lane);
        });
        Self(lanes)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn map(self, function: impl Fn(E) -> E) -> Self {
        Self::from_fn(|lane| function(self.0[lane]))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with(self, other: Self, function: impl Fn(E, E) -> E) -> Self {
        Self::from_fn(|lane| function(self.0[lane], other.0[lane]))
    }

    /// Whether all lanes are finite.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn is_finite_throughout(self) -> bool {
        let mut is_finite = true;
        for_each_lane!(lane in 0..W {
            is_finite &= Float::is_finite(self.0[lane]);
        });
        is_finite
    }

    /// NaN in lanes that are not finite, a negative zero in the others.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn gaps(self) -> Self {
        self.map(|number| {
            if Float::is_finite(number) {
                E::neg_zero()
            } else {
                E::nan()
            }
        })
    }

    /// One in lanes that are not finite, zero in the others.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn gone(self) -> Self {
        self.map(|number| if Float::is_finite(number) { E::zero() } else { E::one() })
    }

    /// The sum of small counts.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "they are counts")]
    pub(super) fn count(self) -> usize {
        self.0.iter().map(|count| count.real()).sum::<f64>() as usize
    }

    /// The numbers themselves, NaN in lanes where a sum of squares exceeds that of the [largest
    /// length](LARGEST_MEASURED).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(in crate::batch) fn within(self, squares: Self) -> Self {
        self.with(squares, |number, squares| {
            if squares < E::LARGEST_MEASURED * E::LARGEST_MEASURED {
                number
            } else {
                E::nan()
            }
        })
    }

    /// The number with NaN in the lanes that fail a check, NaN in these lanes and zero in the others, and whether a
    /// lane fails.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn checked<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> (Self, Self, bool) {
        let operands = check.operands();
        let (mut kept, mut failing, mut one_fails) = (self, Self::constant(0.0), false);
        for_each_lane!(lane in 0..W {
            // One condition after the other: the compiler vectorises a comparison with a selection, but not a
            // conjunction. A selection within the arrays would be stored in part, and could not be read at once.
            let (mut number, mut gap) = (self.0[lane], E::zero());
            for holds in check.holds(Self::at(&operands, lane)) {
                number = if holds { number } else { E::nan() };
                gap = if holds { gap } else { E::nan() };
                one_fails |= !holds;
            }
            kept.0[lane] = number;
            failing.0[lane] = gap;
        });
        (kept, failing, one_fails)
    }

    /// The values in one lane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at<const N: usize>(numbers: &[Self; N], lane: usize) -> [E; N] {
        let mut values = [E::zero(); N];
        for index in 0..N {
            values[index] = numbers[index].0[lane];
        }
        values
    }
}

impl<const W: usize, const BITS: usize, E: Element> Add for Lanes<W, BITS, E> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add(self, other: Self) -> Self {
        Self(E::sum::<W, BITS>(&self.0, &other.0))
    }
}

impl<const W: usize, const BITS: usize, E: Element> Sub for Lanes<W, BITS, E> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sub(self, other: Self) -> Self {
        Self(E::difference::<W, BITS>(&self.0, &other.0))
    }
}

impl<const W: usize, const BITS: usize, E: Element> Mul for Lanes<W, BITS, E> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul(self, other: Self) -> Self {
        Self(E::product::<W, BITS>(&self.0, &other.0))
    }
}

impl<const W: usize, const BITS: usize, E: Element> Div for Lanes<W, BITS, E> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn div(self, other: Self) -> Self {
        Self(E::quotient::<W, BITS>(&self.0, &other.0))
    }
}

impl<const W: usize, const BITS: usize, E: Element> Neg for Lanes<W, BITS, E> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(self) -> Self {
        Self(E::opposite::<W, BITS>(&self.0))
    }
}

impl<const W: usize, const BITS: usize, E: Element> Number for Lanes<W, BITS, E> {
    const EPSILON: f64 = E::EPSILON;
    const SMALLEST_DIVISOR: f64 = E::SMALLEST_DIVISOR;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(value: f64) -> Self {
        Self([E::of(value); W])
    }

    /// Only reports use it, and nobody reads them.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn real(self) -> f64 {
        self.0[0].real()
    }

    /// Always true: callers that solve in lanes test each lane at the end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_finite(self) -> bool {
        true
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sqrt(self) -> Self {
        Self(E::square_root::<W, BITS>(&self.0))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sin_cos(self) -> (Self, Self) {
        let (mut sine, mut cosine) = (self, self);
        for_each_lane!(lane in 0..W {
            let angle = self.0[lane];
            // NaN where the polynomials are not valid.
            let angle = if is_near(angle) { angle } else { E::nan() };
            (sine.0[lane], cosine.0[lane]) = if is_fused(BITS) {
                near_sine_cosine::<true, true, E>(angle)
            } else {
                near_sine_cosine::<false, false, E>(angle)
            };
        });
        (sine, cosine)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn asin(self) -> Self {
        self.atan2(leg(self))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn acos(self) -> Self {
        leg(self).atan2(self)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn atan(self) -> Self {
        self.atan2(Self::constant(1.0))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn atan2(self, x: Self) -> Self {
        let mut result = self;
        for_each_lane!(lane in 0..W {
            result.0[lane] = if is_fused(BITS) {
                ordinary_arc_tangent::<true, true, E>(self.0[lane], x.0[lane]).0
            } else {
                let (angle, ordinary) = ordinary_arc_tangent::<false, false, E>(self.0[lane], x.0[lane]);
                if ordinary { angle } else { E::nan() }
            };
        });
        result
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sinh(self) -> Self {
        self.map(Number::sinh)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn cosh(self) -> Self {
        self.map(Number::cosh)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn tanh(self) -> Self {
        self.map(Number::tanh)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn asinh(self) -> Self {
        self.map(Number::asinh)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn acosh(self) -> Self {
        self.map(Number::acosh)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn atanh(self) -> Self {
        self.map(Number::atanh)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn exp(self) -> Self {
        self.map(Float::exp)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn ln(self) -> Self {
        self.map(Float::ln)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plus_product(self, a: Self, b: Self) -> Self {
        Self(<E as Instructions>::plus_product::<W, BITS>(&self.0, &a.0, &b.0))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn minus_product(self, a: Self, b: Self) -> Self {
        Self(<E as Instructions>::minus_product::<W, BITS>(&self.0, &a.0, &b.0))
    }
}

impl<const W: usize, const BITS: usize, E: Element> Scalar for Lanes<W, BITS, E> {
    const DOUBT: f64 = E::DOUBT_IN_LANES;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn provided<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<Self> {
        let (kept, failing, one_fails) = self.checked(check);
        if one_fails {
            judge(check, failing, check.square().sqrt());
        }
        Some(kept)
    }

    /// A lane that fails does not need its root, so it gets the root by which its shortfall is measured: a root takes
    /// longer than twenty other operations.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rooted<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<(Self, Self)> {
        let (kept, failing, one_fails) = self.checked(check);
        let square = check.square();
        let root = Self::from_fn(|lane| {
            if failing.0[lane] == E::zero() {
                self.0[lane]
            } else {
                square.0[lane]
            }
        })
        .sqrt();
        if one_fails {
            judge(check, failing, root);
        }
        Some((kept, root - failing))
    }

    /// Nobody reads the failure: the verdicts say what fails.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn refused(_: impl FnOnce() -> Failure) -> Failure {
        Failure::not_finite("lanes")
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
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

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn times_sign_of(self, other: Self) -> Self {
        self.with(other, |a, b| sign_flipped(a, b.bits()))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measured<const N: usize>(measure: impl Measure<Self, N>) -> Self {
        let operands = measure.operands();
        Self::from_fn(|lane| measure.measure(Self::at(&operands, lane)))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measured_over<M: RowMeasure>(_: M, count: usize, operand: impl Fn(usize) -> Self) -> Self {
        let mut measured = Self([M::start(); W]);
        for index in 0..count {
            measured = measured.with(operand(index), M::with);
        }
        measured.map(M::end)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn chosen<const N: usize>(choice: impl Choose<Self, N>) -> Result<Assembly, Failure> {
        let operands = choice.operands();
        let first = choice.choose(real_parts(Self::at(&operands, 0)))?;
        for lane in 1..W {
            if choice.choose(real_parts(Self::at(&operands, lane)))? != first {
                return Err(Failure::not_finite("lanes"));
            }
        }
        Ok(first)
    }

    /// The pivot as for one pose. Sizes are computed again instead of kept, which saves one percent of the instructions
    /// of Newton's method.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn pivot(entries: &[Self], count: usize, step: usize) -> usize {
        let size_of = |row: usize| entries[row * count + step].leading().abs();
        let mut best = step;
        for row in step + 1..count {
            if size_of(row) > size_of(best) {
                best = row;
            }
        }
        best
    }

    /// The first lane leads.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn leading(self) -> f64 {
        self.0[0].real()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn root(
        solution: &mut [Self],
        sizes: &[Self],
        memory: NewtonMemory<'_, Self>,
        equations: impl Equations<Self>,
    ) -> Result<(), Failure> {
        newton::root(solution, sizes, memory, equations)
    }
}

/// Records verdicts about lanes that fail a check.
#[cfg_attr(not(debug_assertions), inline(always))]
fn judge<const W: usize, const BITS: usize, const N: usize, const K: usize, E: Element>(
    check: impl Check<Lanes<W, BITS, E>, N, K>,
    failing: Lanes<W, BITS, E>,
    root: Lanes<W, BITS, E>,
) {
    let Some([margin, scale]) = check.shortfall(root) else {
        verdicts::record(failing);
        return;
    };
    verdicts::record(Lanes::<W, BITS, E>::from_fn(|lane| {
        verdict(failing.0[lane], margin.0[lane], scale.0[lane])
    }));
}

/// The verdict about a lane: zero if it does not fail, the margin if it is negative beyond doubt, and NaN otherwise.
/// NaN also stands for lengths whose squares lose digits or overflow.
#[cfg_attr(not(debug_assertions), inline(always))]
fn verdict<E: Element>(failing: E, margin: E, scale: E) -> E {
    let doubt = -E::of(E::DOUBT_IN_LANES);
    let margin = if margin < doubt * scale { margin } else { E::nan() };
    let margin = if scale > E::one() / E::LARGEST_MEASURED {
        margin
    } else {
        E::nan()
    };
    let margin = if scale < E::LARGEST_MEASURED { margin } else { E::nan() };
    if failing == E::zero() { failing } else { margin }
}

/// The other leg of a right triangle whose hypotenuse is 1.
#[cfg_attr(not(debug_assertions), inline(always))]
fn leg<const W: usize, const BITS: usize, E: Element>(known: Lanes<W, BITS, E>) -> Lanes<W, BITS, E> {
    let one = Lanes::<W, BITS, E>::constant(1.0);
    Number::sqrt((one - known) * (one + known))
}
