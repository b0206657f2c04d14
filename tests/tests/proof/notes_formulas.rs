//! Every system of the notes, every order, both assemblies: what is generated is what the notes derive by hand.
//!
//! The notes' derivatives are evaluated at the generated position, so that both are on the same branch; their positions
//! are compared modulo whole turns. Errors are in the units of `kin_tests::oracles::Gauge`, which grow near the right
//! angles and aligned links where the notes' formulas divide by nearly nothing.

use core::f64::consts::TAU;

use kin_core::library::{
    FourBar, FreudensteinFourBar, GeometricFourBar, InvertedSliderCrank, OffsetSliderCrank, SliderCrank,
    SliderCrankFirstApproximation, SliderCrankHigherApproximation,
};
use kin_core::prelude::*;
use kin_tests::notes;
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;

/// Errors seen so far, order by order.
struct Comparison {
    name: &'static str,
    worst: [f64; 5],
    count: usize,
}

impl Comparison {
    const fn new(name: &'static str) -> Self {
        Self {
            name,
            worst: [0.0; 5],
            count: 0,
        }
    }

    /// Compares one quantity, the first `own.len()` orders of it. Positions are compared modulo `turn`, if that is not
    /// zero.
    fn add(&mut self, gauge: &Gauge, index: usize, own: &[f64], notes: &[f64], turn: f64) {
        for (order, (own, notes)) in own.iter().zip(notes).enumerate() {
            let mut difference = own - notes;
            if order == 0 && turn > 0.0 {
                difference -= turn * (difference / turn).round();
            }
            let error = difference.abs() / gauge.unknown(index, order);
            assert!(
                error <= ALLOWED[order],
                "{}, order {order}: {own} against {notes}, {error} units",
                self.name
            );
            self.worst[order] = self.worst[order].max(error);
        }
        self.count += 1;
    }

    fn report(&self) {
        println!("{:36} {:5} motions, worst {:8.3?}", self.name, self.count, self.worst);
        assert!(self.count > 100, "{}: only {} motions", self.name, self.count);
    }
}

/// Crank angles all around, with random motions.
fn motions(random: &mut Random) -> Vec<[f64; 5]> {
    (0..24)
        .map(|step| random.motion((f64::from(15 * step) + 0.3).to_radians()))
        .collect()
}

const ASSEMBLIES: [(Assembly, notes::Assembly); 2] = [
    (Assembly::Open, notes::Assembly::Open),
    (Assembly::Crossed, notes::Assembly::Crossed),
];

#[test]
fn four_bar() {
    use notes::four_bar_geometric::{Branch, Dimensions, Position, derivatives, position};
    let mut random = Random::new(1);
    let mut geometric_method = Comparison::new("four-bar, geometric method");
    let mut vector_loop = Comparison::new("four-bar, vector loop");
    for _ in 0..40 {
        let [r1, r2, r3, r4] = [(); 4].map(|()| random.between(0.5, 5.0));
        let (geometric, linkage) = (GeometricFourBar { r1, r2, r3, r4 }, FourBar { r1, r2, r3, r4 });
        let dimensions = Dimensions { r1, r2, r3, r4 };
        for motion in motions(&mut random) {
            for (assembly, notes_assembly) in ASSEMBLIES {
                let crank = Motion::new(motion);
                let Ok(pose) = geometric.solve(crank, geometric.assembly(motion[0], assembly)) else {
                    continue;
                };
                let gauge = Gauge::new(&geometric, &[crank], &pose.unknown_motions());
                let [e, alpha, gamma, beta, theta4, theta3] = pose.unknowns();
                let expected = derivatives(
                    dimensions,
                    motion,
                    Position {
                        e,
                        alpha,
                        gamma,
                        beta,
                        theta4,
                        theta3,
                    },
                );
                let by_notes = position(
                    dimensions,
                    motion[0],
                    Branch::closing(dimensions, motion[0], notes_assembly),
                );
                let positions = [
                    by_notes.e,
                    by_notes.alpha,
                    by_notes.gamma,
                    by_notes.beta,
                    by_notes.theta4,
                    by_notes.theta3,
                ];
                let rates = [
                    expected.e,
                    expected.alpha,
                    expected.gamma,
                    expected.beta,
                    expected.theta4,
                    expected.theta3,
                ];
                for (index, (own, (rates, value))) in pose
                    .unknown_motions()
                    .iter()
                    .zip(rates.into_iter().zip(positions))
                    .enumerate()
                {
                    let mut notes = rates;
                    notes[0] = value;
                    let turn = if index == 0 { 0.0 } else { TAU };
                    geometric_method.add(&gauge, index, &own.derivatives(), &notes, turn);
                }
                let loops = linkage
                    .solve(crank, assembly)
                    .expect("it closes by the geometric method");
                vector_loop.add(&gauge, 4, &loops.theta4.derivatives(), &expected.theta4, TAU);
                vector_loop.add(&gauge, 5, &loops.theta3.derivatives(), &expected.theta3, TAU);
            }
        }
    }
    geometric_method.report();
    vector_loop.report();
}

/// The notes stop at acceleration here; jerk and snap are those of the vector loop.
#[test]
fn freudenstein() {
    use notes::freudenstein::{Position, derivatives};
    let mut random = Random::new(2);
    let mut to_acceleration = Comparison::new("four-bar, Freudenstein");
    let mut to_snap = Comparison::new("four-bar, Freudenstein and loop");
    for _ in 0..40 {
        let [r1, r2, r3, r4] = [(); 4].map(|()| random.between(0.5, 5.0));
        let (linkage, loops) = (FreudensteinFourBar { r1, r2, r3, r4 }, FourBar { r1, r2, r3, r4 });
        let dimensions = notes::four_bar_geometric::Dimensions { r1, r2, r3, r4 };
        for motion in motions(&mut random) {
            let pairs = [
                (FreudensteinFourBar::OPEN, Assembly::Open),
                (FreudensteinFourBar::CROSSED, Assembly::Crossed),
            ];
            for (assembly, loop_assembly) in pairs {
                let crank = Motion::new(motion);
                let Ok(pose) = linkage.solve(crank, assembly) else {
                    continue;
                };
                let gauge = Gauge::new(&linkage, &[crank], &pose.unknown_motions());
                let [theta3, theta4] = pose.unknowns();
                let expected = derivatives(dimensions, motion, Position { theta3, theta4 });
                to_acceleration.add(&gauge, 0, &pose.theta3.derivatives(), &expected.theta3, TAU);
                to_acceleration.add(&gauge, 1, &pose.theta4.derivatives(), &expected.theta4, TAU);
                let loops = loops
                    .solve(crank, loop_assembly)
                    .expect("it closes by Freudenstein's equations");
                to_snap.add(&gauge, 0, &pose.theta3.derivatives(), &loops.theta3.derivatives(), TAU);
                to_snap.add(&gauge, 1, &pose.theta4.derivatives(), &loops.theta4.derivatives(), TAU);
            }
        }
    }
    to_acceleration.report();
    to_snap.report();
}

#[test]
fn slider_crank() {
    use notes::slider_crank::{Dimensions, Position, Rod, derivatives, position, position_offset};
    let mut random = Random::new(3);
    let mut centric = Comparison::new("slider-crank");
    let mut offset = Comparison::new("slider-crank with offset");
    for _ in 0..40 {
        let [r, l, h] = [
            random.between(0.5, 3.0),
            random.between(1.0, 5.0),
            random.between(-1.0, 1.0),
        ];
        let dimensions = Dimensions { r, l };
        for motion in motions(&mut random) {
            for (assembly, rod) in [(Assembly::Open, Rod::Forward), (Assembly::Crossed, Rod::Backward)] {
                let crank = Motion::new(motion);
                let mechanism = SliderCrank { r, l };
                if let Ok(pose) = mechanism.solve(crank, assembly) {
                    let gauge = Gauge::new(&mechanism, &[crank], &pose.unknown_motions());
                    let [phi, s] = pose.unknowns();
                    let mut expected = derivatives(dimensions, motion, Position { phi, s });
                    let Position { phi, s } = position(dimensions, motion[0], rod);
                    (expected.phi[0], expected.s[0]) = (phi, s);
                    centric.add(&gauge, 0, &pose.phi.derivatives(), &expected.phi, TAU);
                    centric.add(&gauge, 1, &pose.s.derivatives(), &expected.s, 0.0);
                }
                let mechanism = OffsetSliderCrank { r, l, h };
                if let Ok(pose) = mechanism.solve(crank, assembly) {
                    let gauge = Gauge::new(&mechanism, &[crank], &pose.unknown_motions());
                    let [phi, s] = pose.unknowns();
                    let mut expected = derivatives(dimensions, motion, Position { phi, s });
                    let Position { phi, s } = position_offset(dimensions, h, motion[0], rod);
                    (expected.phi[0], expected.s[0]) = (phi, s);
                    offset.add(&gauge, 0, &pose.phi.derivatives(), &expected.phi, TAU);
                    offset.add(&gauge, 1, &pose.s.derivatives(), &expected.s, 0.0);
                }
            }
        }
    }
    centric.report();
    offset.report();
}

/// At constant speed, for which the notes derive it.
#[test]
fn approximate_slider_crank() {
    use notes::slider_crank_approximate::{first, higher_order};
    let mut random = Random::new(4);
    let mut first_approximation = Comparison::new("slider-crank, first approximation");
    let mut higher_approximation = Comparison::new("slider-crank, (R/L)^5");
    for _ in 0..20 {
        let [r, l] = [random.between(0.5, 1.0), random.between(1.5, 5.0)];
        let dimensions = notes::slider_crank::Dimensions { r, l };
        for [angle, speed, ..] in motions(&mut random) {
            let crank = Motion::at_constant_speed(angle, speed);
            let mechanism = SliderCrankFirstApproximation { r, l };
            let pose = mechanism.solve(crank).expect("it is explicit");
            let gauge = Gauge::new(&mechanism, &[crank], &pose.unknown_motions());
            first_approximation.add(&gauge, 0, &pose.s.derivatives(), &first(dimensions, angle, speed), 0.0);
            let mechanism = SliderCrankHigherApproximation { r, l };
            let pose = mechanism.solve(crank).expect("it is explicit");
            let gauge = Gauge::new(&mechanism, &[crank], &pose.unknown_motions());
            higher_approximation.add(
                &gauge,
                0,
                &pose.s.derivatives(),
                &higher_order(dimensions, angle, speed),
                0.0,
            );
        }
    }
    first_approximation.report();
    higher_approximation.report();
}

/// The notes divide by cos theta4, which the generated code does not: poses near the right angle are compared with that
/// in mind.
#[test]
fn inverted_slider_crank() {
    use notes::inverted_slider_crank::{Branch, Dimensions, Position, derivatives, position};
    let mut random = Random::new(5);
    let mut comparison = Comparison::new("inverted slider-crank");
    for _ in 0..40 {
        let [r1, r2] = [random.between(0.5, 5.0), random.between(0.5, 5.0)];
        let mechanism = InvertedSliderCrank { r1, r2 };
        let dimensions = Dimensions { r1, r2 };
        for motion in motions(&mut random) {
            let crank = Motion::new(motion);
            let pose = mechanism.solve(crank).expect("the lever reaches the pin");
            let mut gauge = Gauge::new(&mechanism, &[crank], &pose.unknown_motions());
            let [r4, theta4] = pose.unknowns();
            gauge.condition /= theta4.cos().abs();
            let mut expected = derivatives(dimensions, motion, Position { r4, theta4 });
            let by_notes = position(dimensions, motion[0], Branch::closing(dimensions, motion[0], false));
            (expected.r4[0], expected.theta4[0]) = (by_notes.r4, by_notes.theta4);
            comparison.add(&gauge, 0, &pose.r4.derivatives(), &expected.r4, 0.0);
            comparison.add(&gauge, 1, &pose.theta4.derivatives(), &expected.theta4, TAU);
        }
    }
    comparison.report();
}
