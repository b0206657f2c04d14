//! Blocks that no closed form fits: found by Newton's method, differentiated as exactly as any other.

use kin_core::prelude::*;
use kin_tests::compare::turned_back;
use kin_tests::mechanisms::coupled::{GearedPair, Kepler, RelativeDrive, SixCoupled, StephensonThree, Triad};
use kin_tests::oracles::{Reported, Worst};
use kin_tests::random::Random;

fn at(length: f64, angle: f64) -> Plane {
    Plane::new(length * angle.cos(), length * angle.sin())
}

/// Both oracles, and the unknowns that the mechanism was built around.
fn check<M>(worst: &mut Worst, mechanism: &M, motion: [f64; 5], unknowns: &[f64], random: &mut Random)
where
    M: Mechanism<Scalar = f64, Motion<f64> = Motion<f64, 5>>,
{
    let inputs = M::Inputs::from_fn(|_| Motion::new(motion));
    let near = M::Unknowns::from_fn(|index| unknowns[index] + random.between(-0.02, 0.02));
    let values = M::Inputs::from_fn(|_| motion[0]);
    let Ok(pose) = mechanism.solve_motion_near(inputs, near) else {
        return;
    };
    let found: Vec<f64> = pose.unknown_motions().as_ref().iter().map(Motion::value).collect();
    let far = found
        .iter()
        .zip(unknowns)
        .any(|(found, known)| (found - known).abs() > 0.2);
    if far {
        return;
    }
    let assembly = mechanism.assembly_near(values, M::Unknowns::from_fn(|index| found[index]));
    worst.check(mechanism, inputs, assembly);
}

#[test]
fn kepler() {
    let mut random = Random::new(1);
    let mut worst = Worst::default();
    for _ in 0..200 {
        let mechanism = Kepler {
            eccentricity: random.between(0.0, 0.95),
        };
        let eccentric: f64 = random.between(-10.0, 10.0);
        let mean = eccentric - mechanism.eccentricity * eccentric.sin();
        check(&mut worst, &mechanism, random.motion(mean), &[eccentric], &mut random);
    }
    worst.report("Kepler");
}

#[test]
fn relative_drive() {
    let mut random = Random::new(2);
    let mut worst = Worst::default();
    for _ in 0..200 {
        let mechanism = RelativeDrive {
            r1: 90.0,
            r2: random.between(20.0, 60.0),
            r3: 60.0,
            r4: random.between(40.0, 90.0),
        };
        for assembly in RelativeDrive::<f64>::assemblies() {
            let drive = random.between(-3.0, 3.0);
            worst.check(&mechanism, [Motion::new(random.motion(drive))], assembly);
        }
    }
    worst.report("RelativeDrive");
}

#[test]
fn triad() {
    let mut random = Random::new(3);
    let mut worst = Worst::default();
    for _ in 0..200 {
        let [theta, alpha, beta, gamma, phi] = [(); 5].map(|()| random.between(-3.0, 3.0));
        let [crank, a, b, c, p, q] = [(); 6].map(|()| random.between(0.5, 2.0));
        let delta = random.between(0.5, 2.0);
        let joint = at(crank, theta) + at(a, alpha);
        let mechanism = Triad {
            crank,
            a,
            b,
            c,
            p,
            q,
            delta,
            pivot_b: joint + at(p, phi) - at(b, beta),
            pivot_c: joint + at(q, phi + delta) - at(c, gamma),
        };
        check(
            &mut worst,
            &mechanism,
            random.motion(theta),
            &[alpha, beta, gamma, phi],
            &mut random,
        );
    }
    worst.report("Triad");
}

/// Every assembly is found: the one that the triad was built in, and as many as a dense scan finds.
#[test]
fn all_assemblies_of_a_triad() {
    let mut random = Random::new(6);
    let mut seen = [0; 7];
    for _ in 0..100 {
        let [theta, alpha, beta, gamma, phi] = [(); 5].map(|()| random.between(-3.0, 3.0));
        let [crank, a, b, c, p, q] = [(); 6].map(|()| random.between(0.5, 2.0));
        let delta = random.between(0.5, 2.0);
        let joint = at(crank, theta) + at(a, alpha);
        let mechanism = Triad {
            crank,
            a,
            b,
            c,
            p,
            q,
            delta,
            pivot_b: joint + at(p, phi) - at(b, beta),
            pivot_c: joint + at(q, phi + delta) - at(c, gamma),
        };
        let all = mechanism.assemblies_at(theta).expect("the dimensions are finite");
        assert!(all.is_complete(), "{mechanism:?}: {all:?}");
        assert!(
            all.iter().any(|Near(position)| {
                position
                    .iter()
                    .zip([alpha, beta, gamma, phi])
                    .all(|(own, built)| turned_back(own - built).abs() < 1e-6)
            }),
            "{mechanism:?}: {all:?}"
        );
        for &Near(position) in &all {
            let left = mechanism.closure(theta, position);
            assert!(left.iter().all(|left| left.abs() < 1e-12), "{left:?}");
        }
        assert_eq!(all.len(), scanned(&mechanism, theta), "{mechanism:?}: {all:?}");
        seen[all.len()] += 1;
    }
    println!("assemblies of a triad: {seen:?}");
    assert!(
        seen[2] > 0 && seen[4] > 0 && seen[6] > 0 && seen[1] + seen[3] + seen[5] == 0,
        "{seen:?}"
    );
}

/// Another way to count: for each direction of the ternary link the first two legs close as a four-bar does, in two ways, and
/// the third leg must have its length. Changes of sign over a fine scan are roots.
fn scanned(mechanism: &Triad, theta: f64) -> usize {
    let left = |phi: f64, side: f64| {
        // a cis(alpha) - b cis(beta) = target
        let target = mechanism.pivot_b - at(mechanism.crank, theta) - at(mechanism.p, phi);
        let square = target.norm_squared();
        let along = (square + mechanism.a.powi(2) - mechanism.b.powi(2)) / (2.0 * square);
        let height = mechanism.a.powi(2) / square - along * along;
        let leg = target.times(Plane::new(along, side * height.max(0.0).sqrt()));
        let end = at(mechanism.crank, theta) + leg + at(mechanism.q, phi + mechanism.delta) - mechanism.pivot_c;
        (height, end.norm_squared() - mechanism.c.powi(2))
    };
    let steps = 40_000;
    let angle = |step: i32| f64::from(step) * std::f64::consts::TAU / f64::from(steps) + 0.1;
    let mut roots = 0;
    for side in [1.0, -1.0] {
        for step in 0..steps {
            let ((first_height, first), (second_height, second)) =
                (left(angle(step), side), left(angle(step + 1), side));
            if first_height >= 0.0 && second_height >= 0.0 && (first > 0.0) != (second > 0.0) {
                roots += 1;
            }
            // where the two legs reach each other only just, the scan goes over from one side to the other
            if side > 0.0 && (first_height >= 0.0) != (second_height >= 0.0) {
                let inside = if first_height >= 0.0 {
                    angle(step)
                } else {
                    angle(step + 1)
                };
                if (left(inside, 1.0).1 > 0.0) != (left(inside, -1.0).1 > 0.0) {
                    roots += 1;
                }
            }
        }
    }
    roots
}

#[test]
fn stephenson() {
    let mut random = Random::new(4);
    let mut worst = Worst::default();
    for _ in 0..200 {
        let [theta2, theta3, theta5, theta6] = [(); 4].map(|()| random.between(-3.0, 3.0));
        let [r2, r3, r5, r6, x, y] = [(); 6].map(|()| random.between(0.5, 2.0));
        let end = at(r2, theta2) + at(r3, theta3);
        let r1 = random.between(0.5, 2.0);
        let rocker = end - Plane::new(r1, 0.0);
        let theta4 = rocker.y.atan2(rocker.x);
        let coupler_point = Plane::new(x, y);
        let mechanism = StephensonThree {
            r1,
            r2,
            r3,
            r4: rocker.x.hypot(rocker.y),
            coupler_point,
            r5,
            r6,
            pivot: at(r2, theta2) + coupler_point.times(at(1.0, theta3)) + at(r5, theta5) - at(r6, theta6),
        };
        check(
            &mut worst,
            &mechanism,
            random.motion(theta6),
            &[theta2, theta3, theta4, theta5],
            &mut random,
        );
    }
    worst.report("StephensonThree");
}

#[test]
fn geared_pair() {
    let mut random = Random::new(5);
    let mut worst = Worst::default();
    for _ in 0..200 {
        let [theta2, theta3] = [(); 2].map(|()| random.between(-3.0, 3.0));
        let [r1, r3, r4, ratio] = [(); 4].map(|()| random.between(0.5, 2.0));
        let phase = 0.3;
        let theta4 = ratio * theta2 + phase;
        // the crank's length from the y part
        let r2 = (r4 * theta4.sin() - r3 * theta3.sin()) / theta2.sin();
        let s = r2 * theta2.cos() + r3 * theta3.cos() - r1 - r4 * theta4.cos();
        let mechanism = GearedPair {
            r1,
            r2,
            r3,
            r4,
            ratio,
            phase,
        };
        check(
            &mut worst,
            &mechanism,
            random.motion(theta3),
            &[theta2, theta4, s],
            &mut random,
        );
    }
    worst.report("GearedPair");
}

#[test]
fn six_coupled() {
    println!("{:?}", SixCoupled::<f64>::DESCRIPTION.blocks);
}
