//! Blocks that no closed form fits: found by Newton's method, differentiated as exactly as any other.

use kin_core::prelude::*;
use kin_tests::compare::turned_back;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::coupled::{
    Built, GearedPair, Kepler, RelativeDrive, SixCoupled, SixInChain, StephensonThree, Triad,
};
use kin_tests::oracles::{Reported, Worst};
use kin_tests::random::Random;
use kin_tests::samples;

/// Both oracles, and the unknowns that the mechanism was built around.
fn check<M, const UNKNOWNS: usize>(worst: &mut Worst, built: &Built<M, UNKNOWNS>, random: &mut Random)
where
    M: ThroughSnap,
{
    let Built {
        mechanism,
        input,
        unknowns,
    } = built;
    let motion = random.motion(*input);
    let inputs = M::Inputs::from_fn(|_| Motion::new(motion));
    let near = M::Unknowns::from_fn(|index| unknowns[index] + random.between(-0.02, 0.02));
    let values = M::Inputs::from_fn(|_| motion[0]);
    let Ok(pose) = mechanism.solve_near(inputs, near) else {
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
    let assembly = mechanism.assembly_at(values, M::Unknowns::from_fn(|index| found[index]));
    worst.check(mechanism, inputs, assembly);
}

/// Two hundred of them.
fn prove<M: ThroughSnap, const UNKNOWNS: usize>(seed: u64, built: impl Fn(&mut Random) -> Built<M, UNKNOWNS>) {
    let mut random = Random::new(seed);
    let mut worst = Worst::default();
    for _ in 0..200 {
        check(&mut worst, &built(&mut random), &mut random);
    }
    worst.report(M::DESCRIPTION.name);
}

#[test]
fn kepler() {
    prove(1, Kepler::built);
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
    prove(3, Triad::built);
}

/// Every assembly is found: the one that the triad was built in, and as many as a dense scan finds.
#[test]
fn all_assemblies_of_a_triad() {
    let mut random = Random::new(6);
    let mut seen = [0; 7];
    let count = samples::of(100);
    for _ in 0..count {
        let Built {
            mechanism,
            input: theta,
            unknowns,
        } = Triad::built(&mut random);
        let all = mechanism.assemblies_at(theta).expect("the dimensions are finite");
        assert!(all.is_complete(), "{mechanism:?}: {all:?}");
        assert!(
            all.iter().any(|Near(position)| {
                position
                    .iter()
                    .zip(unknowns)
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
        seen[2] > 0 && seen[4] > 0 && seen[1] + seen[3] + seen[5] == 0,
        "{seen:?}"
    );
    assert!(seen[6] > 0 || !cfg!(feature = "every-case"), "{seen:?}");
}

fn at(length: f64, angle: f64) -> Plane {
    Plane::new(length * angle.cos(), length * angle.sin())
}

/// Another way to count: for each direction of the ternary link the first two legs close as a four-bar does, in two
/// ways, and the third leg must have its length. Changes of sign over a fine scan are roots.
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
    prove(4, StephensonThree::built);
}

#[test]
fn geared_pair() {
    prove(5, GearedPair::built);
}

#[test]
fn six_coupled() {
    assert_eq!(SixCoupled::<f64>::DESCRIPTION.blocks.len(), 1);
    prove(7, SixCoupled::built);
}

#[test]
fn six_in_chain() {
    assert_eq!(SixInChain::<f64>::DESCRIPTION.blocks.len(), 3);
    prove(8, SixInChain::built);
}
