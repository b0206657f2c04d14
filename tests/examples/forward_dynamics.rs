//! Mechanisms that move without a drive: a benchmark that passes through change points, and a press that friction
//! slows.
//!
//! The accelerations of the benchmark follow from `Loads::accelerations`. Friction depends on the forces in the joints,
//! and these on the acceleration that is sought: the acceleration is the one at which the drive has nothing to do,
//! by the secant method on the effort with friction. The crate `differential-equations` integrates both.
//!
//! ```sh
//! cargo run -p kin-tests --features other-crates --example forward_dynamics
//! ```

use std::cell::RefCell;
use std::error::Error;

use differential_equations::ivp::IVP;
use differential_equations::methods::ExplicitRungeKutta;
use kin_core::any::PositionChoice;
use kin_core::linkage::AnyLinkage;
use kin_core::load::{Load, Loads};
use kin_core::prelude::*;
use kin_core::reaction::{Friction, NamedReactions};

/// The state at the end of an integration by the method of order 8 of Dormand and Prince.
fn integrated<const N: usize>(
    rates: impl Fn([f64; N]) -> Result<[f64; N], Box<dyn Error>>,
    from: [f64; N],
    time: f64,
    tolerance: f64,
) -> Result<[f64; N], Box<dyn Error>> {
    let failed = RefCell::new(None);
    let rates = |_: f64, state: &[f64; N], out: &mut [f64; N]| {
        *out = rates(*state).unwrap_or_else(|error| {
            failed.borrow_mut().get_or_insert(error);
            [0.0; N]
        });
    };
    let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance);
    let solution = IVP::ode_from_fn(rates, 0.0, time, from)
        .method(method.max_steps(1_000_000))
        .solve();
    if let Some(error) = failed.take() {
        return Err(error);
    }
    let solution = solution.map_err(|error| format!("{error:?}"))?;
    Ok(*solution.y.last().ok_or("no step")?)
}

mechanism! {
    /// Two parallelograms in a row, in metres. Three bars stand on the ground, and two lie across them.
    ///
    /// Where all bars lie in one line, a four-bar linkage of these lengths could also go on as an antiparallelogram,
    /// and the position of its coupler loses all digits. So the closure says what a parallelogram is: opposite bars
    /// have the same angle, wherever they are.
    pub(crate) struct Parallelograms { bar: Length }
    input theta: Angle;
    unknown second: Angle, third: Angle;
    second == theta;
    third == theta;
    output b0: Point = bar * cis(theta);
    output first_bar: Point = bar / 2 * cis(theta);
    output second_bar: Point = bar + bar / 2 * cis(second);
    output third_bar: Point = 2 * bar + bar / 2 * cis(third);
    output first_across: Point = (bar * cis(theta) + bar + bar * cis(second)) / 2;
    output second_across: Point = (bar + bar * cis(second) + 2 * bar + bar * cis(third)) / 2;
}

/// The point B0 and its velocity in the benchmark A02: N parallel four-bars, of bars of 1 kg and 1 m, here
/// with N = 2. They are released upright with B0 at 1 m/s to the right.
pub(crate) const BENCHMARK: [(f64, [f64; 4]); 2] = [
    (
        4.0,
        [
            0.117_616_102_376_8,
            0.993_059_138_451_3,
            1.069_039_265_029,
            -0.126_615_049_167,
        ],
    ),
    (
        10.0,
        [
            0.328_458_111_540_8,
            0.944_518_538_178_6,
            1.423_051_470_207,
            -0.494_868_845_487,
        ],
    ),
];

/// The point B0 with its velocity, and the change of the energy as a part of the energy at first.
pub(crate) fn parallelograms(time: f64, tolerance: f64) -> Result<([f64; 4], f64), Box<dyn Error>> {
    let bars = Parallelograms { bar: 1.0 };
    let about_centre = 1.0 / 12.0;
    let loads = Loads::<Parallelograms>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(1.0, |pose| pose.first_bar)
        .inertia(about_centre, |pose| pose.theta)
        .mass(1.0, |pose| pose.second_bar)
        .inertia(about_centre, |pose| pose.second)
        .mass(1.0, |pose| pose.third_bar)
        .inertia(about_centre, |pose| pose.third)
        .mass(1.0, |pose| pose.first_across)
        .mass(1.0, |pose| pose.second_across);
    let rates = |[angle, speed]: [f64; 2]| {
        let [acceleration] = bars.accelerations(&loads, [angle], [speed], [0.0])?;
        Ok([speed, acceleration])
    };
    let energy = |[angle, speed]: [f64; 2]| {
        let balance = bars.balance(&loads, [Motion::at_constant_speed(angle, speed)])?;
        Ok::<_, Box<dyn Error>>(balance.kinetic_energy().value() + balance.potential_energy().value())
    };
    let start = [std::f64::consts::FRAC_PI_2, -1.0];
    let [angle, speed] = integrated(rates, start, time, tolerance)?;
    let pose = bars.solve(Motion::at_constant_speed(angle, speed))?;
    let (place, velocity) = (pose.b0.value(), pose.b0.velocity());
    let (before, after) = (energy(start)?, energy([angle, speed])?);
    Ok((
        [place.x, place.y, velocity.x, velocity.y],
        (after - before).abs() / before,
    ))
}

mechanism! {
    /// Four-bar linkage in metres, with its bodies.
    pub(crate) struct Press { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output pin: Point = r2 * cis(theta2);
    output knee: Point = r1 + r4 * cis(theta4);
    output pivot: Point = vec2(r1, 0);
    output coupler_centre: Point = r2 * cis(theta2) + r3 / 2 * cis(theta3);
    output rocker_centre: Point = r1 + r4 / 2 * cis(theta4);
    ground 0, pivot;
    body crank: 0, pin;
    body coupler: pin, knee, coupler_centre;
    body rocker: pivot, knee, rocker_centre;
}

const PRESS: Press = Press {
    r1: 0.4,
    r2: 0.12,
    r3: 0.36,
    r4: 0.28,
};

/// The masses of the coupler and the rocker, with their inertias and that of the crank with its flywheel.
fn masses() -> Loads<Press, impl Load<Press>> {
    Loads::<Press>::new()
        .gravity(Plane::new(0.0, -9.81))
        .inertia(0.2, |pose| pose.theta2)
        .mass(1.4, |pose| pose.coupler_centre)
        .inertia(0.016, |pose| pose.theta3)
        .mass(1.1, |pose| pose.rocker_centre)
        .inertia(0.007, |pose| pose.theta4)
}

/// The forces in the joints of the same, all of which have friction.
fn joints<'m>(linkage: &AnyLinkage<'m>) -> Result<NamedReactions<'m>, Box<dyn Error>> {
    let loads = linkage
        .loads()
        .gravity(Plane::new(0.0, -9.81))
        .inertia(0.2, "theta2")?
        .mass_of("coupler", 1.4, "coupler_centre", 0.016)?
        .mass_of("rocker", 1.1, "rocker_centre", 0.007)?;
    let friction = Friction::Pin {
        coefficient: 0.15,
        radius: 0.02,
    };
    let reactions = linkage.reactions(&loads)?;
    let names: Vec<String> = reactions.names().map(String::from).collect();
    Ok(reactions.frictions(names.into_iter().map(|name| (name, friction)))?)
}

/// The acceleration of the crank without a drive, and the power of friction.
fn coasting(reactions: &NamedReactions<'_>, angle: f64, speed: f64) -> Result<[f64; 2], Box<dyn Error>> {
    let at = |acceleration: f64| {
        let crank = Motion::from((angle, speed, acceleration, 0.0, 0.0));
        let found = reactions.at(&[crank], PositionChoice::Assembly(0))?;
        let [effort, ..] = found.effort(0).ok_or("no effort")?;
        Ok::<_, Box<dyn Error>>((effort, found.heat()[0]))
    };
    // friction bends the line of the effort a little
    let (mut before, mut acceleration) = (0.0, 1.0);
    let (mut effort_before, _) = at(before)?;
    for _ in 0..20 {
        let (effort, heat) = at(acceleration)?;
        let step = effort * (acceleration - before) / (effort - effort_before);
        if step.is_nan() || step.abs() <= 1e-13 * (1.0 + acceleration.abs()) {
            return Ok([acceleration, heat]);
        }
        (before, effort_before) = (acceleration, effort);
        acceleration -= step;
    }
    Err("the acceleration does not converge".into())
}

/// The tolerances with which the motion of the press is integrated.
pub(crate) const TOLERANCES: [f64; 4] = [1e-4, 1e-6, 1e-8, 1e-10];

/// The time that the press runs on, in seconds, and the speed of its crank at first.
pub(crate) const COAST: f64 = 2.0;
const SPEED: f64 = 240.0;

/// The energy of the press at first and after it has run on, and the heat of friction.
pub(crate) fn coasted(tolerance: f64) -> Result<[f64; 3], Box<dyn Error>> {
    let linkage = AnyLinkage::of(&PRESS);
    let (loads, reactions) = (masses(), joints(&linkage)?);
    let rates = |[angle, speed, _]: [f64; 3]| {
        let [acceleration, heat] = coasting(&reactions, angle, speed)?;
        Ok([speed, acceleration, heat])
    };
    let energy = |angle: f64, speed: f64| {
        let balance = PRESS.balance(&loads, [Motion::at_constant_speed(angle, speed)], Assembly::Open)?;
        Ok::<_, Box<dyn Error>>(balance.kinetic_energy().value() + balance.potential_energy().value())
    };
    let (angle, speed) = (1.0, rpm(SPEED));
    let end = integrated(rates, [angle, speed, 0.0], COAST, tolerance)?;
    Ok([energy(angle, speed)?, energy(end[0], end[1])?, end[2]])
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("two parallelograms, released upright");
    for (time, expected) in BENCHMARK {
        let (found, drift) = parallelograms(time, 1e-13)?;
        let worst = found
            .iter()
            .zip(expected)
            .map(|(own, other)| (own - other).abs())
            .fold(0.0, f64::max);
        println!("  after {time} s: B0 to {worst:.1e}, energy to {drift:.1e}");
    }
    println!("a press that runs on from {SPEED} revolutions per minute for {COAST} s");
    for tolerance in TOLERANCES {
        let [before, after, heat] = coasted(tolerance)?;
        let open = (before - after - heat).abs() / before;
        println!("  tolerance {tolerance:.0e}: {before:.2} J = {after:.2} J + {heat:.2} J of heat, to {open:.0e}");
    }
    Ok(())
}
