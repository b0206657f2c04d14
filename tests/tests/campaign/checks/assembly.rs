//! A pose is of the assembly that it was asked for, and two assemblies lie on different sides of a singular position.

use super::{Campaign, Pose, Solved};
use crate::engine::{Guide, Problem};

impl Campaign<'_> {
    /// The values of the unknowns tell the assembly.
    pub(super) fn is_of_its_assembly(&mut self, problem: &Problem, guide: &Guide, pose: &Pose) {
        let Guide::Assembly(asked) = guide else {
            return;
        };
        if pose.known(f64::EPSILON).is_none() {
            return;
        }
        let told = self.engine.assembly_near(problem, &pose.found.position());
        if told != Some(*asked) {
            let what = format!("{:?} is told to be of assembly {told:?}", pose.found.position());
            self.find("assembly", what, problem, guide);
        }
    }

    /// The poses of two assemblies differ, and the first block in which they do has determinants of opposite signs.
    pub(super) fn are_apart(&mut self, one: &Solved, other: &Solved) {
        let (Ok(first), Ok(second)) = (&one.result, &other.result) else {
            return;
        };
        let (Some(units), Some(other_units)) = (first.known(f64::EPSILON), second.known(f64::EPSILON)) else {
            return;
        };
        let description = self.engine.description();
        let differs = |place: &usize| {
            first.found.columns[*place][0] != second.found.columns[*place][0]
                || first.found.sines[*place] != second.found.sines[*place]
        };
        let Some(block) = description
            .blocks
            .iter()
            .position(|block| block.members.iter().any(differs))
        else {
            let what = format!("the same as {:?}: {:?}", other.guide, first.found.position());
            self.find("apart", what, &one.problem, &one.guide);
            return;
        };
        let (own, others) = (units.determinants[block], other_units.determinants[block]);
        if own * others >= 0.0 {
            let what = format!(
                "not apart from {:?} in block {block}: determinants {own:e}, {others:e}",
                other.guide
            );
            self.find("apart", what, &one.problem, &one.guide);
        }
    }
}
