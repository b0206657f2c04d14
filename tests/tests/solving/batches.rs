//! Batches: what they find is what one pose after the other finds, in every kind of vectors, for every mechanism.
#![allow(clippy::cast_precision_loss, reason = "there are hundreds of poses")]

use kin_core::batch::Outcome;
use kin_core::library::FourBar;
use kin_core::prelude::*;
use kin_tests::batches::{Poses, Table, vectors};
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap};
use kin_tests::mechanisms::coupled::{Built, Kepler, SixCoupled, SixInChain, StephensonThree, Triad};
use kin_tests::mechanisms::directions::{DirectedKepler, DirectedTriad};
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;
use kin_tests::reference::{Given, Solution, solution};

/// Poses in a batch: more than lanes, and no multiple of them.
const POSES: usize = 101;

/// By how much a batch may differ from single poses, in units of rounding times the condition, which is known to 50
/// digits.
const UNITS: f64 = 4.0;

/// Of every so many poses that condition is asked for; the others are held to what both oracles allow a single pose.
const SAMPLE: usize = if cfg!(feature = "every-case") { 8 } else { 40 };

/// A pose that was solved by itself, and the units in which its errors are told.
struct Single<M: Mechanism> {
    pose: M::Pose,
    gauge: Gauge,
    reference: Option<Solution>,
}

impl<M: ThroughSnap> Single<M> {
    fn new(poses: &Poses<M>, index: usize, assembly: Option<M::Assembly>) -> Result<Self, SolveError> {
        let pose = poses.solve_one(index, assembly)?;
        let unknowns = pose.unknown_motions();
        let gauge = Gauge::new(&poses.mechanisms[index], &poses.inputs[index], &unknowns);
        let reference = index.is_multiple_of(SAMPLE).then(|| {
            let position: Vec<f64> = unknowns.as_ref().iter().map(|motion| motion[0]).collect();
            let inputs = poses.inputs[index].as_ref().iter();
            let given = Given {
                parameters: poses.mechanisms[index].parameters().as_ref().to_vec(),
                inputs: inputs.map(|motion| motion.as_ref().to_vec()).collect(),
            };
            solution::<M>(&given, &position).expect("there is a reference")
        });
        Ok(Self { pose, gauge, reference })
    }
}

/// Compares batches with one pose after the other, and prints how far they are apart.
#[derive(Default)]
struct Compare {
    worst: [f64; 5],
    poses: usize,
    failures: usize,
    alone: usize,
}

impl Compare {
    fn print(&self, name: &str) {
        let Self {
            worst,
            poses,
            failures,
            alone,
        } = self;
        println!("{name}: {poses} poses, {failures} failures, {alone} solved alone, differences in units: {worst:.2?}");
    }

    fn check<M: ThroughSnap>(&mut self, poses: &Poses<M>, assembly: Option<M::Assembly>) {
        let name = M::DESCRIPTION.name;
        let singles: Vec<_> = (0..poses.mechanisms.len())
            .map(|index| Single::new(poses, index, assembly))
            .collect();
        for vectors in vectors() {
            let (table, outcomes, summary) = poses.solve(assembly, vectors);
            self.alone += summary.alone;
            assert_eq!(summary.solved + summary.failed, outcomes.len(), "{name}");
            let mut first_failure = None;
            for (index, outcome) in outcomes.iter().enumerate() {
                self.poses += 1;
                match &singles[index] {
                    Ok(single) => {
                        assert_eq!(*outcome, Outcome::Solved, "{name}, pose {index}");
                        self.compare(poses, index, single, &table);
                    }
                    Err(error) => {
                        self.failures += 1;
                        first_failure = first_failure.or(Some((index, *error)));
                        poses.check_failure(index, assembly, *outcome, error);
                        assert!(table.is_cleared(index), "{name}, pose {index}");
                    }
                }
            }
            assert_eq!(summary.first_failure, first_failure, "{name}");
        }
    }

    fn compare<M: ThroughSnap>(&mut self, poses: &Poses<M>, index: usize, single: &Single<M>, table: &Table) {
        let Single { pose, gauge, reference } = single;
        let (columns, sines) = (pose.unknown_columns(), pose.unknown_sines());
        for (order, allowed) in ALLOWED.into_iter().enumerate() {
            for (input, motion) in poses.inputs[index].as_ref().iter().enumerate() {
                assert_eq!(table.inputs[input][order][index].to_bits(), motion[order].to_bits());
            }
            let note = |found: f64, expected: f64, unit: f64, allowed: f64| {
                // What is exact is so where there is no unit, too.
                let error = if found == expected {
                    0.0
                } else {
                    (found - expected).abs() / unit
                };
                assert!(
                    error <= allowed,
                    "{}, pose {index}, order {order}: {found:e} for {expected:e}, {error} units of {unit:e}",
                    M::DESCRIPTION.name
                );
                error
            };
            for (place, motion) in columns.as_ref().iter().enumerate() {
                let sine = sines[place].filter(|_| order == 0);
                let pairs = [
                    Some((table.unknowns[place][order][index], motion[order])),
                    sine.map(|sine| (table.sines[place][index], sine)),
                ];
                // cosine and sine move by no more than the angle, but are rounded where they are near 1
                let least = if sine.is_some() { f64::EPSILON } else { 0.0 };
                for (found, expected) in pairs.into_iter().flatten() {
                    note(found, expected, gauge.unknown(place, order).max(least), allowed);
                    if let Some(reference) = reference {
                        let unit = (f64::EPSILON * reference.conditions[place][order]).max(least);
                        let error = note(found, expected, unit, UNITS);
                        self.worst[order] = self.worst[order].max(error);
                    }
                }
            }
            for (place, motion) in pose.output_motions().as_ref().iter().enumerate() {
                let unit = gauge.output(&M::DESCRIPTION.outputs[place], motion.as_ref(), order);
                note(table.outputs[place][order][index], motion[order], unit, allowed);
            }
        }
    }
}

impl cases::Visitor for Compare {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let mut random = Random::new(M::DESCRIPTION.name.len() as u64);
        let mechanisms: Vec<M> = (0..POSES).map(|_| case.varied(&mut random)).collect();
        let inputs = (0..POSES)
            .map(|index| case.inputs::<M>((index as f64 + 0.5) / POSES as f64, &mut random))
            .collect();
        let poses = Poses {
            mechanisms,
            inputs,
            near: Vec::new(),
        };
        for assembly in M::assemblies() {
            self.check(&poses, Some(assembly));
        }
    }
}

/// Mechanisms with coupled blocks, no two alike, from values of the unknowns a little off the positions they were built
/// around.
fn coupled<M: ThroughSnap, const UNKNOWNS: usize>(
    seed: u64,
    built: impl Fn(&mut Random) -> Built<M, UNKNOWNS>,
) -> Compare {
    let mut random = Random::new(seed);
    let mut poses = Poses {
        mechanisms: Vec::new(),
        inputs: Vec::new(),
        near: Vec::new(),
    };
    for _ in 0..POSES {
        let built = built(&mut random);
        let motion = random.motion(built.input);
        poses.mechanisms.push(built.mechanism);
        poses.inputs.push(M::Inputs::from_fn(|_| Motion::new(motion)));
        poses.near.push(M::Unknowns::from_fn(|index| {
            built.unknowns[index] + random.between(-0.02, 0.02)
        }));
    }
    let mut compare = Compare::default();
    compare.check(&poses, None);
    compare.print(M::DESCRIPTION.name);
    compare
}

#[test]
fn coupled_blocks_in_lanes() {
    coupled(1, Kepler::built);
    let compare = coupled(2, Triad::built);
    assert!(compare.alone < compare.poses / 4, "{}", compare.alone);
    coupled(3, StephensonThree::built);
    coupled(6, DirectedTriad::built);
    if cfg!(feature = "every-case") {
        coupled(4, SixCoupled::built);
        coupled(5, SixInChain::built);
        coupled(7, DirectedKepler::built);
    }
}

#[test]
fn mechanisms_of_all_kinds_in_every_assembly() {
    let mut compare = Compare::default();
    cases::of_each_form(&mut compare);
    compare.print("all kinds");
    let Compare {
        poses, failures, alone, ..
    } = compare;
    let least = if cfg!(feature = "every-case") { 10_000 } else { 5_000 };
    assert!(poses > least && failures > 100, "{poses} {failures}");
    assert!(alone < poses / 50, "{alone} of {poses}");
}

fn linkage() -> FourBar {
    FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    }
}

#[test]
fn a_pose_does_not_depend_on_its_neighbours() {
    let mut random = Random::new(7);
    let poses = Poses {
        mechanisms: vec![linkage(); POSES],
        inputs: (0..POSES)
            .map(|index| [Motion::new(random.motion(-1.9 + 3.8 * index as f64 / POSES as f64))])
            .collect(),
        near: Vec::new(),
    };
    for vectors in vectors() {
        let (table, outcomes, _) = poses.solve(Some(Assembly::Open), vectors);
        assert!(outcomes.iter().all(Outcome::is_solved));
        // some of them out of reach, far away, or no numbers at all
        let spoilt = |index: usize| index.is_multiple_of(3);
        let mut disturbed = Poses {
            mechanisms: poses.mechanisms.clone(),
            inputs: poses.inputs.clone(),
            near: Vec::new(),
        };
        for index in (0..POSES).filter(|index| spoilt(*index)) {
            match index % 4 {
                0 => disturbed.mechanisms[index].r3 = 10.0,
                1 => disturbed.inputs[index][0] = Motion::at_constant_speed(1e9, 1.0),
                2 => disturbed.inputs[index][0] = Motion::at_constant_speed(f64::NAN, 1.0),
                _ => disturbed.mechanisms[index].r1 = f64::INFINITY,
            }
        }
        let (other, outcomes, _) = disturbed.solve(Some(Assembly::Open), vectors);
        for index in (0..POSES).filter(|index| !spoilt(*index)) {
            assert!(outcomes[index].is_solved());
            assert_eq!(table.bits(index), other.bits(index), "{vectors:?}, pose {index}");
        }
        Compare::default().check(&disturbed, Some(Assembly::Open));
    }
}
