//! The verdicts about lanes that fail a check.
//!
//! A lane that fails becomes NaN, which does not say by how much it fails. The first check that a lane fails therefore
//! leaves a verdict here. The driver of a batch reads it when the chunk is solved, instead of the ordinary solver. Each
//! thread solves one chunk at a time, so it has one store of verdicts. Without the standard library there are no
//! threads to distinguish, and all verdicts are left to the ordinary solver.

#[cfg(feature = "std")]
use core::cell::Cell;

use super::{Element, Lanes};
#[cfg(feature = "std")]
use crate::batch::dispatch::{MOST_LANES, MOST_SINGLES};
#[cfg(feature = "std")]
use crate::solve::Real as _;

/// A number with a store of the verdicts about lanes of it.
pub trait Judged: Sized {
    /// One number for each lane: zero if the lane has passed all checks, a margin if it is clearly out of reach, and
    /// NaN if the ordinary solver must decide.
    #[cfg(feature = "std")]
    type Verdicts: Copy + AsRef<[Self]> + AsMut<[Self]>;

    /// No lane fails.
    #[cfg(feature = "std")]
    const NO_VERDICTS: Self::Verdicts;

    /// The verdicts of this thread.
    #[cfg(feature = "std")]
    fn verdicts() -> Self::Verdicts;

    /// Replaces the verdicts of this thread.
    #[cfg(feature = "std")]
    fn judge(verdicts: Self::Verdicts);
}

/// Numbers on separate cache lines.
#[cfg(feature = "std")]
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Aligned<V>(V);

macro_rules! judged {
    ($float:ty, $verdicts:ident, $lanes:expr) => {
        #[cfg(feature = "std")]
        std::thread_local! {
            static $verdicts: Cell<Aligned<[$float; $lanes]>> = const { Cell::new(Aligned([0.0; $lanes])) };
        }

        impl Judged for $float {
            #[cfg(feature = "std")]
            type Verdicts = [$float; $lanes];

            #[cfg(feature = "std")]
            const NO_VERDICTS: Self::Verdicts = [0.0; $lanes];

            #[cfg(feature = "std")]
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn verdicts() -> Self::Verdicts {
                let Aligned(all) = $verdicts.get();
                all
            }

            #[cfg(feature = "std")]
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn judge(all: Self::Verdicts) {
                $verdicts.set(Aligned(all));
            }
        }
    };
}

judged!(f64, VERDICTS, MOST_LANES);
judged!(f32, VERDICTS_IN_SINGLE, MOST_SINGLES);

/// Forgets all verdicts.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::batch) fn forget<E: Element>() {
    #[cfg(feature = "std")]
    E::judge(E::NO_VERDICTS);
}

/// The verdicts since they were last forgotten.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::batch) fn read<const W: usize, const BITS: usize, E: Element>() -> Lanes<W, BITS, E> {
    #[cfg(feature = "std")]
    {
        let all = E::verdicts();
        let all = all.as_ref();
        Lanes::from_fn(|lane| all[lane])
    }
    #[cfg(not(feature = "std"))]
    Lanes([E::nan(); W])
}

/// Whether no lane has failed a check since the verdicts were last forgotten, as far as verdicts are kept.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::batch) fn are_none<const W: usize, const BITS: usize, E: Element>() -> bool {
    let Lanes(verdicts) = read::<W, BITS, E>();
    cfg!(not(feature = "std")) || verdicts.iter().all(|verdict| *verdict == E::zero())
}

/// Records a verdict for the lanes where `news` is not zero, unless an earlier check has left one.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn record<const W: usize, const BITS: usize, E: Element>(news: Lanes<W, BITS, E>) {
    #[cfg(feature = "std")]
    {
        let mut all = E::verdicts();
        let verdicts = read::<W, BITS, E>();
        let zero = Lanes([E::zero(); W]);
        let Lanes(verdicts) = verdicts.equals(zero).chosen(news, verdicts);
        for (verdict, own) in all.as_mut().iter_mut().zip(verdicts) {
            *verdict = own;
        }
        E::judge(all);
    }
    #[cfg(not(feature = "std"))]
    let _ = news;
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::{Lanes, forget, read};
    use crate::assembly::Assembly;
    use crate::geometry::Plane;
    use crate::number::Number;
    use crate::solve::{circle_circle, linear};

    type Four = Lanes<4, 128>;

    /// Two links of lengths 3 and 4 over a distance.
    fn spans(distances: [f64; 4]) -> bool {
        let [a, b] = [3.0, 4.0].map(Four::constant);
        let c = Plane::new(Lanes(distances), Four::constant(0.0));
        circle_circle(a, b, c, Assembly::Open).is_ok()
    }

    #[test]
    fn a_lane_out_of_reach_has_a_margin() {
        forget::<f64>();
        assert!(spans([5.0, 9.0, 7.0, 0.25]));
        let Lanes([inside, beyond, touching, below]) = read::<4, 128, f64>();
        assert_eq!([inside, beyond, below], [0.0, -2.0, -0.75]);
        assert!(
            touching.is_nan(),
            "the solver for one pose decides at the limit: {touching}"
        );
    }

    #[test]
    fn the_first_check_that_fails_gives_the_verdict() {
        forget::<f64>();
        let zero = Four::constant(0.0);
        let one = Four::constant(1.0);
        assert!(linear(Lanes([1.0, 0.0, 1.0, 1.0]), one).is_ok());
        assert!(spans([5.0, 9.0, 8.0, 6.0]));
        assert!(spans([10.0, 9.0, 10.0, 6.0]));
        let Lanes([late, unknown, early, never]) = read::<4, 128, f64>();
        assert_eq!([late, early, never], [-3.0, -1.0, 0.0]);
        assert!(unknown.is_nan());
        forget::<f64>();
        assert_eq!(read::<4, 128, f64>().0, zero.0);
    }

    #[test]
    fn all_lanes_may_fail() {
        forget::<f64>();
        assert!(spans([8.0, 9.0, 10.0, 11.0]));
        assert_eq!(read::<4, 128, f64>().0, [-1.0, -2.0, -3.0, -4.0]);
    }

    /// Lengths whose squares overflow or lose digits are left to the solver for one pose.
    #[test]
    fn lengths_that_cannot_be_squared_have_no_verdict() {
        for distance in [1e160, f64::INFINITY, f64::NAN] {
            forget::<f64>();
            spans([5.0, distance, 5.0, 5.0]);
            let Lanes([_, verdict, ..]) = read::<4, 128, f64>();
            assert!(verdict.is_nan(), "{distance}: {verdict}");
        }
    }
}
