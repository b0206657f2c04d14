//! The functions whose instructions are counted: each function of this module is one line of the record.
//!
//! They are never inlined, so that callgrind sees each as a function, and what it calls within it.

use core::hint::black_box;

use kin_core::library::{
    ClassThreeTriad, ClassThreeTriadSnap, FourBar, FourBarAcceleration, FourBarJerk, FourBarPosition, FourBarSnap,
    FourBarVelocity, InvertedSliderCrank, InvertedSliderCrankSnap, SliderCrank, SliderCrankSnap,
};
use kin_core::prelude::*;

mechanism! {
    /// A four-bar linkage of which the rocker's range chooses the assembly.
    struct RangedFourBar {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle in 0.0..=PI;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// A four-bar linkage of which the rocker's range decides where the coupler's holds both solutions.
    struct TwiceRangedFourBar {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle in -PI / 2..=PI / 2, theta4: Angle in 0.0..=PI;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// A slider-crank on an inclined slide, with its slider on the near side.
    struct RangedSliderCrank {
        r: Length,
        l: Length,
        incline: Angle,
    }
    input theta: Angle;
    unknown phi: Angle, s: Length where s < 0;

    r * cis(theta) + l * cis(phi) == s * cis(incline);
}

/// How often each function is called, every time for another pose.
pub(crate) const POSES: u64 = 16;

#[inline(never)]
fn four_bar_position(linkage: &FourBar, theta2: f64) -> Result<FourBarPosition, SolveError> {
    linkage.position(theta2, Assembly::Open)
}

#[inline(never)]
fn four_bar_velocity(position: &FourBarPosition, rate: f64) -> FourBarVelocity {
    position.velocity(rate)
}

#[inline(never)]
fn four_bar_acceleration(velocity: &FourBarVelocity, rate: f64) -> FourBarAcceleration {
    velocity.acceleration(rate)
}

#[inline(never)]
fn four_bar_jerk(acceleration: &FourBarAcceleration, rate: f64) -> FourBarJerk {
    acceleration.jerk(rate)
}

#[inline(never)]
fn four_bar_snap(jerk: &FourBarJerk, rate: f64) -> FourBarSnap {
    jerk.snap(rate)
}

#[inline(never)]
fn four_bar_solve(linkage: &FourBar, crank: Motion) -> Result<FourBarSnap, SolveError> {
    linkage.solve(crank, Assembly::Open)
}

#[inline(never)]
fn four_bar_single_precision_solve(linkage: &FourBar<f32>, crank: Motion<f32>) -> Result<FourBarSnap<f32>, SolveError> {
    linkage.solve(crank, Assembly::Open)
}

#[inline(never)]
fn slider_crank_solve(linkage: &SliderCrank, crank: Motion) -> Result<SliderCrankSnap, SolveError> {
    linkage.solve(crank, Assembly::Open)
}

#[inline(never)]
fn inverted_slider_crank_solve(
    linkage: &InvertedSliderCrank,
    crank: Motion,
) -> Result<InvertedSliderCrankSnap, SolveError> {
    linkage.solve(crank)
}

#[inline(never)]
fn ranged_four_bar_solve(linkage: &RangedFourBar, crank: Motion) -> Result<RangedFourBarSnap, SolveError> {
    linkage.solve(crank)
}

#[inline(never)]
fn twice_ranged_four_bar_solve(
    linkage: &TwiceRangedFourBar,
    crank: Motion,
) -> Result<TwiceRangedFourBarSnap, SolveError> {
    linkage.solve(crank)
}

#[inline(never)]
fn ranged_slider_crank_solve(linkage: &RangedSliderCrank, crank: Motion) -> Result<RangedSliderCrankSnap, SolveError> {
    linkage.solve(crank)
}

#[inline(never)]
fn class_three_triad_solve(
    triad: &ClassThreeTriad,
    legs: [Motion; 3],
    near: [f64; 4],
) -> Result<ClassThreeTriadSnap, SolveError> {
    triad.solve_near(legs[0], legs[1], legs[2], near)
}

/// Calls each of them as often as is said, where there is a solution.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "single precision is made from double precision, and there are a few poses"
)]
pub(crate) fn run() -> Result<(), SolveError> {
    // of a call, neither what goes in nor what comes out may be known beforehand
    macro_rules! count {
        ($function:ident($($argument:expr),*)) => {
            black_box($function($(black_box($argument)),*))
        };
    }

    let four_bar = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let single: FourBar<f32> = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let slider_crank = SliderCrank { r: 0.1, l: 0.3 };
    let inverted = InvertedSliderCrank { r1: 2.0, r2: 0.8 };
    let ranged = RangedFourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let twice_ranged = TwiceRangedFourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let ranged_slider_crank = RangedSliderCrank {
        r: 1.0,
        l: 3.0,
        incline: 0.4,
    };
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };

    for pose in 0..POSES {
        // -1 ... 1, where all of them close
        let t = (pose as f64 + 0.5) / (POSES as f64 / 2.0) - 1.0;

        let rates = [1.8 * t, 2.0, -0.5, 0.25, 0.125];
        let crank = Motion::from(rates);
        let position = count!(four_bar_position(&four_bar, rates[0]))?;
        let velocity = count!(four_bar_velocity(&position, rates[1]));
        let acceleration = count!(four_bar_acceleration(&velocity, rates[2]));
        let jerk = count!(four_bar_jerk(&acceleration, rates[3]));
        count!(four_bar_snap(&jerk, rates[4]));
        count!(four_bar_solve(&four_bar, crank))?;
        count!(four_bar_single_precision_solve(
            &single,
            Motion::from(rates.map(|rate| rate as f32))
        ))?;
        count!(slider_crank_solve(&slider_crank, crank))?;
        count!(inverted_slider_crank_solve(&inverted, crank))?;
        count!(ranged_four_bar_solve(&ranged, crank))?;
        count!(twice_ranged_four_bar_solve(&twice_ranged, crank))?;
        count!(ranged_slider_crank_solve(&ranged_slider_crank, crank))?;

        // about the position that the library's documentation has, to which the guess belongs
        let leg = |way: f64| Motion::from([5.0_f64.sqrt() + 0.2 * t * way, 0.1 * way, 0.2, -0.1, 0.3]);
        count!(class_three_triad_solve(
            &triad,
            [leg(1.0), leg(-0.5), leg(0.25)],
            [0.1, 2.2, -2.0, 1.6]
        ))?;
    }
    Ok(())
}
