//! The forms in which programs call the generated code: motions as arrays, tuples and numbers, poses as guesses, and
//! the text of poses and errors.
#![allow(
    clippy::needless_borrows_for_generic_args,
    clippy::explicit_iter_loop,
    reason = "people write it in every form"
)]

use kin_core::library::{ClassThreeTriad, FourBar};
use kin_core::prelude::*;
use num_dual::Dual64;

const LINKAGE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

#[test]
fn a_motion_has_several_forms() -> Result<(), SolveError> {
    let expected = LINKAGE.solve(Motion::at_constant_speed(1.0, -10.0), Assembly::Open)?;
    assert_eq!(LINKAGE.solve([1.0, -10.0, 0.0, 0.0, 0.0], Assembly::Open)?, expected);
    assert_eq!(LINKAGE.solve((1.0, -10.0, 0.0, 0.0, 0.0), Assembly::Open)?, expected);
    let at_rest = LINKAGE.solve(Motion::constant(1.0), Assembly::Open)?;
    assert_eq!(LINKAGE.solve(1.0, Assembly::Open)?, at_rest);
    assert_eq!(LINKAGE.solve(Motion::from(1.0), Assembly::Open)?, at_rest);
    assert_eq!(LINKAGE.solve_all(1.0)[0], Ok(at_rest));
    Ok(())
}

/// The number type of the mechanism is found from its parameters, and that of the motion from the mechanism.
#[test]
fn motions_of_every_number_type() -> Result<(), SolveError> {
    let single = FourBar::<f32> {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    assert_eq!(single.solve(1.0, Assembly::Open)?.theta2.position(), 1.0_f32);
    assert_eq!(
        single.solve([0.5, 1.0, 0.0, 0.0, 0.0], Assembly::Open)?.theta2[1],
        1.0_f32
    );
    let dual = LINKAGE.convert(Dual64::from);
    let pose = dual.solve(Dual64::from(1.0).derivative(), Assembly::Open)?;
    let rate = LINKAGE.position(1.0, Assembly::Open)?.velocity(1.0).theta4.velocity();
    assert!((pose.theta4.position().eps - rate).abs() <= 16.0 * f64::EPSILON * rate.abs());
    // parameters and motion are literals without a type
    let pose = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    }
    .solve(1.0, Assembly::Open)?;
    assert_eq!(pose, LINKAGE.solve(1.0, Assembly::Open)?);
    Ok(())
}

#[test]
fn the_last_pose_is_a_guess() -> Result<(), SolveError> {
    let position = LINKAGE.position(1.0, Assembly::Crossed)?;
    let expected = LINKAGE.position(1.1, Assembly::Crossed)?;
    let velocity = position.velocity(3.0);
    for found in [
        LINKAGE.position_near(1.1, position)?,
        LINKAGE.position_near(1.1, &position)?,
        LINKAGE.position_near(1.1, velocity)?,
        LINKAGE.position_near(1.1, position.unknowns())?,
        LINKAGE.position_near(1.1, &position.unknowns())?,
        LINKAGE.position_near(1.1, Near(position.unknowns()))?,
    ] {
        assert_eq!(found, expected);
    }
    let moved = LINKAGE.solve_near([1.1, 2.0, 0.0, 0.0, 0.0], position)?;
    assert_eq!(moved, LINKAGE.solve((1.1, 2.0, 0.0, 0.0, 0.0), Assembly::Crossed)?);
    // the pose of a tracked motion, on its turns
    let turned = LINKAGE.position_near(1.0, position.unknowns().map(|angle| angle + core::f64::consts::TAU))?;
    let next = LINKAGE.position_near(1.1, turned)?;
    assert!((next.theta4.position() - expected.theta4.position() - core::f64::consts::TAU).abs() < 1e-14);
    Ok(())
}

/// Coupled equations have no other way to choose the assembly.
#[test]
fn a_pose_chooses_the_assembly_of_coupled_equations() -> Result<(), SolveError> {
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    let leg = 5.0_f64.sqrt();
    let all = triad.assemblies_at(leg, leg, leg)?;
    assert!(!all.is_empty());
    for near in all.iter() {
        let pose = triad.solve(leg, leg, leg, near)?;
        assert_eq!(triad.solve(leg, leg, leg, *near)?, pose);
        let longer = triad.position(leg + 0.01, leg, leg, pose)?;
        assert_eq!(triad.position_near(leg + 0.01, leg, leg, &pose)?, longer);
        let change = longer.phi.position() - pose.phi.position();
        assert!(change.abs() < 0.5, "{change}");
    }
    Ok(())
}

#[test]
fn a_pose_is_written_line_by_line() -> Result<(), SolveError> {
    let pose = LINKAGE.position(1.0, Assembly::Open)?;
    assert_eq!(
        pose.velocity(-10.0).to_string(),
        "theta2 = 1 rad (57.3°), velocity -10\n\
         theta3 = 0.2828924 rad (16.2°), velocity 4.047872\n\
         theta4 = 1.938488 rad (111.1°), velocity -4.397183"
    );
    assert_eq!(
        format!("{pose:.2}"),
        "theta2 = 1.00 rad (57.3°)\ntheta3 = 0.28 rad (16.2°)\ntheta4 = 1.94 rad (111.1°)"
    );
    Ok(())
}

mechanism! {
    struct Knee { thigh: Length, shin: Length, twist: Angle }
    input hip: Angle;
    unknown knee: Direction, lift: Length;
    thigh * cis(hip) + shin * cis(knee) == vec2(0, lift);
    output foot: Point = vec2(0, lift);
    output hook: Point3 = vec3(lift, 0, thigh * sin(hip + twist));
    order = 1;
}

/// Directions show their angle, points their coordinates in parentheses.
#[test]
fn directions_and_points_are_written() -> Result<(), SolveError> {
    let knee: Knee = Knee {
        thigh: 3.0,
        shin: 5.0,
        twist: 0.0,
    };
    let pose = knee.solve((0.0, 0.0), Assembly::Open)?;
    assert_eq!(
        pose.to_string(),
        "hip = 0 rad (0.0°), velocity 0\n\
         knee = 2.214297 rad (126.9°), velocity 0\n\
         lift = 4, velocity 0\n\
         foot = (0, 4), velocity (0, 0)\n\
         hook = (4, 0, 0), velocity (0, 0, 0)"
    );
    Ok(())
}

/// What `unwrap`, and a `main` that returns the error, print.
#[test]
fn debug_prints_the_sentence_of_an_error() {
    let error = LINKAGE.position(2.0, Assembly::Open).unwrap_err();
    assert_eq!(format!("{error:?}"), error.to_string());
    let start = LINKAGE.position(1.0, Assembly::Open).expect("it closes");
    let error = LINKAGE.track(&start, 3.0).unwrap_err();
    assert_eq!(format!("{error:?}"), error.to_string());
}

mechanism! {
    struct Lever { arm: Length, reach: Length }
    input theta: Angle;
    unknown phi: Angle in 0..180deg, lift: Length;
    arm * cis(theta + 30deg) + reach * cis(phi) == vec2(0, lift);
    output tip: Point = arm * cis(theta + 30deg);
}

/// What people write before they have read anything.
#[test]
fn first_guesses_are_right() -> Result<(), SolveError> {
    let lever: Lever = Lever { arm: 3.0, reach: 5.0 };
    let pose = lever.solve((-30_f64).to_radians())?;
    let tip = pose.tip.position() * 0.5;
    assert!((tip - Plane::new(1.5, 0.0)).norm() < 4.0 * f64::EPSILON);
    assert!(format!("{:.3}", pose.lift).starts_with("4.000 ["));
    // at rest all rates are zero
    let mut sum = 0.0;
    for derivative in pose.phi {
        sum += derivative;
    }
    assert_eq!(sum, pose.phi.position());
    Ok(())
}
