//! A number type that holds several numbers, for several poses at once.
//!
//! No operation has a branch. Arithmetic and [decisions](mask) name their [vector instructions](instructions). The
//! other operations are short loops over an array, which a compiler converts into the widest vectors that the calling
//! function may use.
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
mod mask;
mod newton;
pub(in crate::batch) mod verdicts;

pub use element::Element;
use instructions::{Instructions, is_fused};
use mask::Mask;

use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::Float;

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::number::elementary::{is_near, near_sine_cosine, ordinary_arc_tangent, sign_flipped};
use crate::number::{Number, real_parts};
use crate::solve::{Check, Choose, Equations, Measure, NewtonMemory, Real, RowMeasure, Scalar};

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
        Real::is_finite(self).chosen(Self::constant(-0.0), Self([E::nan(); W]))
    }

    /// One in lanes that are not finite, zero in the others.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn gone(self) -> Self {
        Real::is_finite(self).chosen(Self::constant(0.0), Self::constant(1.0))
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
        let limit = Self([E::LARGEST_MEASURED * E::LARGEST_MEASURED; W]);
        squares.is_below(limit).chosen(self, Self([E::nan(); W]))
    }

    /// The lanes that pass a check.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn passing<const N: usize, const K: usize, C: Check<Self, N, K>>(check: C) -> Mask<W, BITS, E> {
        let operands = check.operands();
        if !C::IS_LONG {
            let conditions = check.holds(operands).into_iter();
            return conditions.fold(Self::certainly(true), |passing, condition| passing & condition);
        }
        let Mask(mut passing) = Self::certainly(true);
        for_each_lane!(lane in 0..W {
            // One condition after the other: the compiler vectorises a comparison with a selection, but not a
            // conjunction. A selection within the array would be stored in part, and could not be read at once.
            let mut bits = passing.0[lane];
            for holds in check.holds(Self::at(&operands, lane)) {
                bits = if holds { bits } else { E::zero() };
            }
            passing.0[lane] = bits;
        });
        Mask(passing)
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
        let passing = Self::passing(check);
        if !passing.is_every() {
            judge(check, passing, check.square().sqrt());
        }
        Some(passing.chosen(self, Self([E::nan(); W])))
    }

    /// A lane that fails does not need its root, so it gets the root by which its shortfall is measured: a root takes
    /// longer than twenty other operations.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rooted<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<(Self, Self)> {
        let passing = Self::passing(check);
        let nan = Self([E::nan(); W]);
        let root = passing.chosen(self, check.square()).sqrt();
        if !passing.is_every() {
            judge(check, passing, root);
        }
        Some((passing.chosen(self, nan), passing.chosen(root, nan)))
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
        let [holds] = check.holds(check.operands());
        holds.chosen(one(), other())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn times_sign_of(self, other: Self) -> Self {
        Self::from_fn(|lane| sign_flipped(self.0[lane], other.0[lane].bits()))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measured<const N: usize>(measure: impl Measure<Self, N>) -> Self {
        let operands = measure.operands();
        Self::from_fn(|lane| measure.measure(Self::at(&operands, lane)))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measured_over<M: RowMeasure>(_: M, count: usize, operand: impl Fn(usize) -> Self) -> Self {
        let mut measured = M::start();
        for index in 0..count {
            measured = M::with(measured, operand(index));
        }
        M::end(measured)
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

/// Records verdicts about the lanes that do not pass a check: the margin where it is negative beyond doubt, otherwise
/// NaN. NaN also stands for lengths whose squares lose digits or overflow.
#[cfg_attr(not(debug_assertions), inline(always))]
fn judge<const W: usize, const BITS: usize, const N: usize, const K: usize, E: Element>(
    check: impl Check<Lanes<W, BITS, E>, N, K>,
    passing: Mask<W, BITS, E>,
    root: Lanes<W, BITS, E>,
) {
    let mut verdict = Lanes([E::nan(); W]);
    if let Some([margin, scale]) = check.shortfall(root) {
        let is_beyond_doubt = margin.is_below(Lanes::constant(-E::DOUBT_IN_LANES) * scale);
        let is_large = scale.exceeds(Lanes([E::one() / E::LARGEST_MEASURED; W]));
        let is_small = scale.is_below(Lanes([E::LARGEST_MEASURED; W]));
        verdict = (is_beyond_doubt & is_large & is_small).chosen(margin, verdict);
    }
    verdicts::record(passing.chosen(Lanes::constant(0.0), verdict));
}

/// The other leg of a right triangle whose hypotenuse is 1.
#[cfg_attr(not(debug_assertions), inline(always))]
fn leg<const W: usize, const BITS: usize, E: Element>(known: Lanes<W, BITS, E>) -> Lanes<W, BITS, E> {
    let one = Lanes::<W, BITS, E>::constant(1.0);
    Number::sqrt((one - known) * (one + known))
}
