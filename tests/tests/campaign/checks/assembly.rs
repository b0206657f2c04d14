//! A pose is of the assembly that it was asked for, and two assemblies lie on different sides of a singular position.

use kin_core::any::AssemblyChoice;

use super::{Campaign, Pose, Solved};
use crate::topology::Problem;

impl Campaign {
    /// The values of the unknowns tell the assembly.
    pub(super) fn is_of_its_assembly(&mut self, problem: &Problem, assembly: &AssemblyChoice, pose: &Pose) {
        let AssemblyChoice::Index(asked) = assembly else {
            return;
        };
        if pose.known(f64::EPSILON).is_none() {
            return;
        }
        let told = self.topology.assembly_at(problem, &pose.found.position());
        if told != Some(*asked) {
            let what = format!("{:?} is told to be of assembly {told:?}", pose.found.position());
            self.find("assembly", what, problem, assembly);
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
        let differs = |place: &usize| first.found.unknowns[*place][0] != second.found.unknowns[*place][0];
        let mut blocks = self.topology.description().blocks.iter();
        let Some(block) = blocks.position(|block| block.members.iter().any(differs)) else {
            let what = format!("the same as {:?}: {:?}", other.assembly, first.found.position());
            self.find("apart", what, &one.problem, &one.assembly);
            return;
        };
        let (own, others) = (units.determinants[block], other_units.determinants[block]);
        if own * others >= 0.0 {
            let what = format!(
                "not apart from {:?} in block {block}: determinants {own:e}, {others:e}",
                other.assembly
            );
            self.find("apart", what, &one.problem, &one.assembly);
        }
    }
}
