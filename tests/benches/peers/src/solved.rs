//! Poses of a mechanism, solved in this process.

use kin_core::Prepared;
use kin_core::prelude::*;
use kin_tests::mechanisms::cases::{Case, Inputs, ThroughSnap};
use kin_tests::random::Random;

/// A pose that a mechanism reaches.
#[derive(Clone, Copy)]
pub(crate) struct Wanted<M: ThroughSnap> {
    pub(crate) inputs: Inputs<M>,
    /// Values near the unknowns, if a block is coupled.
    pub(crate) near: Option<M::Unknowns<f64>>,
    /// The number of the assembly.
    pub(crate) assembly: usize,
}

/// So many draws without a pose mean that there is none.
const DRAWS: usize = 200_000;

impl<M: ThroughSnap> Wanted<M> {
    /// The pose of an assembly at these inputs.
    pub(crate) fn in_assembly(inputs: Inputs<M>, assembly: usize) -> Self {
        Self {
            inputs,
            near: None,
            assembly,
        }
    }

    /// The pose near some values of the unknowns.
    pub(crate) fn near(inputs: Inputs<M>, near: M::Unknowns<f64>) -> Self {
        Self {
            inputs,
            near: Some(near),
            assembly: 0,
        }
    }

    /// Poses of a case, in reach.
    pub(crate) fn of(case: Case, count: usize) -> Vec<Self> {
        let mechanism: M = case.mechanism();
        let mut random = Random::new(37);
        let mut all = Vec::new();
        for draw in 0..DRAWS {
            if all.len() == count {
                break;
            }
            let fraction = random.between(0.0, 1.0);
            let own = Self {
                inputs: case.inputs::<M>(fraction, &mut random),
                assembly: draw % M::ASSEMBLY_COUNT.max(1),
                near: (M::ASSEMBLY_COUNT == 0).then(|| M::Unknowns::from_fn(|_| random.between(-4.0, 4.0))),
            };
            if own.solve(&mechanism).is_ok() {
                all.push(own);
            }
        }
        assert_eq!(all.len(), count, "{} is out of reach", M::DESCRIPTION.name);
        all
    }

    /// Finds it.
    pub(crate) fn solve(&self, mechanism: &M) -> Result<M::Pose, SolveError> {
        match self.near {
            Some(near) => mechanism.solve_near(self.inputs, near),
            None => mechanism.solve(self.inputs, M::assembly(self.assembly).expect("it is one of them")),
        }
    }

    /// Finds it with a mechanism whose dimensions stay. A coupled block has nothing to prepare.
    pub(crate) fn solve_prepared(&self, prepared: &Prepared<M>) -> Result<M::Pose, SolveError> {
        match self.near {
            Some(near) => prepared.mechanism().solve_near(self.inputs, near),
            None => prepared.solve(self.inputs, M::assembly(self.assembly).expect("it is one of them")),
        }
    }

    /// The arguments of the tape.
    pub(crate) fn arguments(&self, mechanism: M) -> Vec<f64> {
        let mut own = mechanism.parameters().as_ref().to_vec();
        for motion in self.inputs.as_ref() {
            own.extend(motion.as_ref());
        }
        if let Some(near) = self.near {
            own.extend(near.as_ref());
        } else {
            let choices = M::ASSEMBLY_COUNT.trailing_zeros();
            let is_crossed = |choice: u32| self.assembly >> (choices - 1 - choice) & 1 == 1;
            own.extend((0..choices).map(|choice| if is_crossed(choice) { -1.0 } else { 1.0 }));
        }
        own
    }

    /// The results of the tape.
    pub(crate) fn results(&self, mechanism: M) -> Vec<f64> {
        let pose = self.solve(&mechanism).expect("it is in reach");
        let (unknowns, outputs) = (pose.unknown_motions(), pose.output_motions());
        let motions = unknowns.as_ref().iter().chain(outputs.as_ref());
        motions.flat_map(|motion| motion.as_ref().to_vec()).collect()
    }
}
