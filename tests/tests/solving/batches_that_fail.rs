//! Batches in which poses fail, of mechanisms of the library: each outcome is that of `solve`, whatever the share that
//! fails.

use kin_core::batch::Outcome;
use kin_core::prelude::*;
use kin_tests::batches::{Poses, vectors};
use kin_tests::mechanisms::cases::{self, Case, Inputs, ThroughSnap};
use kin_tests::random::Random;

/// Poses in a batch: more than lanes, and no multiple of them.
const POSES: usize = 101;

/// Shares of poses that fail, in percent.
const SHARES: [f64; 4] = [0.0, 38.0, 90.0, 100.0];

/// A mechanism with its inputs.
type Pose<M> = (M, Inputs<M>);

/// Compares outcomes with the errors of `solve`.
#[derive(Default)]
struct Compare {
    failures: usize,
    with_margin: usize,
    mechanisms: usize,
    worst: f64,
}

impl Compare {
    /// Poses that close, and poses that fail, of dimensions that differ by up to a factor of four.
    fn pools<M: ThroughSnap>(case: Case, assembly: M::Assembly, random: &mut Random) -> [Vec<Pose<M>>; 2] {
        let mut pools = [Vec::new(), Vec::new()];
        for _ in 0..20 * POSES {
            let own: M = case.mechanism();
            let mechanism = M::from_parameters(Row::from_fn(|place| {
                own.parameters()[place] * random.between(-1.0, 1.0).exp2()
            }));
            let fraction = random.between(0.0, 1.0);
            let pose = (mechanism, case.inputs::<M>(fraction, random));
            let pool = &mut pools[usize::from(mechanism.solve(pose.1, assembly).is_err())];
            if pool.len() < POSES {
                pool.push(pose);
            }
        }
        pools
    }

    fn check<M: ThroughSnap>(&mut self, poses: &Poses<M>, assembly: M::Assembly, share: f64) {
        let assembly = Some(assembly);
        let name = M::DESCRIPTION.name;
        let singles: Vec<_> = (0..POSES).map(|index| poses.solve_one(index, assembly)).collect();
        for vectors in vectors() {
            let (table, outcomes, summary) = poses.solve(assembly, vectors);
            let mut first_failure = None;
            for (index, (outcome, single)) in outcomes.iter().zip(&singles).enumerate() {
                let Err(error) = single else {
                    assert_eq!(*outcome, Outcome::Solved, "{name}, pose {index}, {share} %");
                    continue;
                };
                first_failure = first_failure.or(Some((index, *error)));
                self.failures += 1;
                self.with_margin += usize::from(outcome.margin().is_some());
                self.worst = self.worst.max(poses.check_failure(index, assembly, *outcome, error));
                assert!(table.is_cleared(index), "{name}, pose {index}, {share} %");
            }
            let failed = singles.iter().filter(|single| single.is_err()).count();
            assert_eq!(
                (summary.solved, summary.failed),
                (POSES - failed, failed),
                "{name}, {share} %"
            );
            assert_eq!(summary.first_failure, first_failure, "{name}, {share} %");
        }
    }
}

impl cases::Visitor for Compare {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let mut random = Random::new(M::DESCRIPTION.name.len() as u64);
        self.mechanisms += 1;
        for assembly in M::assemblies().take(2) {
            let [good, bad] = Self::pools::<M>(case, assembly, &mut random);
            for share in SHARES {
                let mut places = [good.iter().cycle(), bad.iter().cycle()];
                let chosen: Vec<_> = (0..POSES)
                    .filter_map(|_| places[usize::from(random.between(0.0, 100.0) < share)].next())
                    .collect();
                // Some mechanisms close everywhere, and others fail for nearly all dimensions.
                if chosen.len() < POSES {
                    continue;
                }
                let poses = Poses {
                    mechanisms: chosen.iter().map(|(mechanism, _)| *mechanism).collect(),
                    inputs: chosen.iter().map(|(_, inputs)| *inputs).collect(),
                    near: Vec::new(),
                };
                self.check(&poses, assembly, share);
            }
        }
    }
}

#[test]
fn any_share_may_fail() {
    let mut compare = Compare::default();
    cases::some_of_the_library(&mut compare);
    let Compare {
        failures,
        with_margin,
        mechanisms,
        worst,
    } = compare;
    println!(
        "{mechanisms} mechanisms, {failures} failures, {with_margin} with a margin, worst difference {worst:.2} units"
    );
    let least = if cfg!(feature = "every-case") { 10_000 } else { 5_000 };
    assert!(mechanisms > 10 && failures > least && with_margin > failures / 2);
}
