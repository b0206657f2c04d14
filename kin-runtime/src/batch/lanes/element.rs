//! The plain numbers of which lanes consist.

use super::instructions::Instructions;
use super::verdicts::Judged;
use crate::batch::dispatch::Kernel;
use crate::number::elementary::Elementary;
use crate::solve::{Real, Scalar};

/// A plain number of which a batch consists: `f64` or `f32`.
///
/// The vectors of a machine hold twice as many numbers of single precision.
pub trait Element: Scalar + Real<Truth = bool> + Elementary + Instructions + Judged + Send + Sync {
    /// [`Scalar::DOUBT`] of lanes, about 4500 ε: the steps before a sum may have magnified rounding a thousand times.
    #[doc(hidden)]
    const DOUBT_IN_LANES: f64;

    /// The largest length whose margin lanes measure. Its square, and the square of its reciprocal, have full
    /// precision.
    #[doc(hidden)]
    const LARGEST_MEASURED: Self;

    /// Runs a kernel in `DOUBLES` lanes of double precision, or in `SINGLES` lanes of single precision.
    #[doc(hidden)]
    fn run<K: Kernel, const DOUBLES: usize, const SINGLES: usize, const BITS: usize>(kernel: K) -> K::Result;
}

impl Element for f64 {
    const DOUBT_IN_LANES: f64 = 1e-12;
    /// 2⁴⁸⁰.
    const LARGEST_MEASURED: Self = f64::from_bits((1023 + 480) << 52);

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<K: Kernel, const DOUBLES: usize, const SINGLES: usize, const BITS: usize>(kernel: K) -> K::Result {
        kernel.run::<DOUBLES, BITS>()
    }
}

impl Element for f32 {
    const DOUBT_IN_LANES: f64 = 4500.0 * f32::EPSILON as f64;
    /// 2⁶⁰.
    const LARGEST_MEASURED: Self = f32::from_bits((127 + 60) << 23);

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<K: Kernel, const DOUBLES: usize, const SINGLES: usize, const BITS: usize>(kernel: K) -> K::Result {
        kernel.run::<SINGLES, BITS>()
    }
}
