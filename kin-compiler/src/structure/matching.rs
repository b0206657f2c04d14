//! The matching of equations to unknowns, and the parts that have too many of either.
//!
//! A maximum matching is found by augmenting paths. If it is not perfect, the alternating paths from unmatched
//! equations and unknowns reach the over- and the underdetermined parts (A. L. Dulmage and N. S. Mendelsohn, "Coverings
//! of bipartite graphs", Canadian Journal of Mathematics 10, 1958).

use std::collections::BTreeSet;

use super::Fault;

/// The unknown that each equation is matched to.
pub(super) struct Matching {
    unknown_of: Vec<Option<usize>>,
    equation_of: Vec<Option<usize>>,
}

impl Matching {
    /// A maximum matching. `incidence` lists the unknowns of each equation.
    pub(super) fn of(incidence: &[BTreeSet<usize>], unknowns: usize) -> Self {
        let mut matching = Self {
            unknown_of: vec![None; incidence.len()],
            equation_of: vec![None; unknowns],
        };
        for equation in 0..incidence.len() {
            let mut seen = BTreeSet::new();
            matching.augment(incidence, equation, &mut seen);
        }
        matching
    }

    fn augment(&mut self, incidence: &[BTreeSet<usize>], equation: usize, seen: &mut BTreeSet<usize>) -> bool {
        for &unknown in &incidence[equation] {
            if !seen.insert(unknown) {
                continue;
            }
            let free = match self.equation_of[unknown] {
                None => true,
                Some(other) => self.augment(incidence, other, seen),
            };
            if free {
                self.equation_of[unknown] = Some(equation);
                self.unknown_of[equation] = Some(unknown);
                return true;
            }
        }
        false
    }

    /// The unknown of an equation, in a perfect matching.
    pub(super) fn unknown_of(&self, equation: usize) -> usize {
        self.unknown_of[equation].expect("the matching is perfect")
    }

    /// The equation that an unknown is matched to.
    pub(super) fn equation_of(&self, unknown: usize) -> usize {
        self.equation_of[unknown].expect("the matching is perfect")
    }

    /// The parts that have too few or too many equations.
    pub(super) fn faults(&self, incidence: &[BTreeSet<usize>]) -> Vec<Fault> {
        let mut faults = Vec::new();
        let unmatched: Vec<usize> = (0..self.equation_of.len())
            .filter(|&unknown| self.equation_of[unknown].is_none())
            .collect();
        if !unmatched.is_empty() {
            let (unknowns, equations) = self.reach_from_unknowns(incidence, &unmatched);
            faults.push(Fault::Underdetermined { unknowns, equations });
        }
        let surplus: Vec<usize> = (0..incidence.len())
            .filter(|&equation| self.unknown_of[equation].is_none())
            .collect();
        if !surplus.is_empty() {
            let (unknowns, equations) = self.reach_from_equations(incidence, &surplus);
            faults.push(Fault::Overdetermined {
                unknowns,
                equations,
                surplus,
            });
        }
        faults
    }

    fn reach_from_unknowns(&self, incidence: &[BTreeSet<usize>], start: &[usize]) -> (Vec<usize>, Vec<usize>) {
        let mut unknowns: BTreeSet<usize> = start.iter().copied().collect();
        let mut equations = BTreeSet::new();
        loop {
            let before = equations.len();
            for (equation, members) in incidence.iter().enumerate() {
                if !members.is_disjoint(&unknowns) && equations.insert(equation) {
                    unknowns.extend(self.unknown_of[equation]);
                }
            }
            if equations.len() == before {
                return (unknowns.into_iter().collect(), equations.into_iter().collect());
            }
        }
    }

    fn reach_from_equations(&self, incidence: &[BTreeSet<usize>], start: &[usize]) -> (Vec<usize>, Vec<usize>) {
        let mut equations: BTreeSet<usize> = start.iter().copied().collect();
        let mut unknowns = BTreeSet::new();
        loop {
            let before = unknowns.len();
            for equation in equations.clone() {
                for &unknown in &incidence[equation] {
                    if unknowns.insert(unknown) {
                        equations.extend(self.equation_of[unknown]);
                    }
                }
            }
            if unknowns.len() == before {
                return (unknowns.into_iter().collect(), equations.into_iter().collect());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::Matching;
    use crate::structure::Fault;

    /// The unknowns that each equation contains.
    fn incidence<const N: usize>(equations: [&[usize]; N]) -> Vec<BTreeSet<usize>> {
        equations.map(|unknowns| unknowns.iter().copied().collect()).to_vec()
    }

    /// If one equation has several unknowns and another only one, the first leaves that unknown to the second.
    #[test]
    fn a_perfect_matching_gives_each_equation_an_unknown_of_its_own() {
        let incidence = incidence([&[0, 1, 2], &[0, 1], &[0]]);
        let matching = Matching::of(&incidence, 3);
        for (equation, unknown) in [(0, 2), (1, 1), (2, 0)] {
            assert_eq!(matching.unknown_of(equation), unknown);
            assert_eq!(matching.equation_of(unknown), equation);
        }
        assert!(matching.faults(&incidence).is_empty());
    }

    /// Three equations contain the unknowns 0 and 1, one the unknowns 2 and 3, one the unknown 4. The faults name all
    /// equations and unknowns of the first two parts, and none of the third.
    #[test]
    fn faults_name_the_parts_with_too_many_and_with_too_few_equations() {
        let incidence = incidence([&[4], &[0], &[0, 1], &[1], &[2, 3]]);
        let faults = Matching::of(&incidence, 5).faults(&incidence);
        let [
            Fault::Underdetermined {
                unknowns: free,
                equations: few,
            },
            Fault::Overdetermined {
                unknowns,
                equations,
                surplus,
            },
        ] = faults.as_slice()
        else {
            panic!("one part has too few equations, another one too many");
        };
        assert_eq!((free.as_slice(), few.as_slice()), ([2, 3].as_slice(), [4].as_slice()));
        assert_eq!(
            (unknowns.as_slice(), equations.as_slice()),
            ([0, 1].as_slice(), [1, 2, 3].as_slice())
        );
        assert_eq!(surplus, &[3]);
    }

    /// A free unknown leaves further unknowns undetermined, along a chain of equations.
    #[test]
    fn what_is_not_determined_spreads_along_equations() {
        let incidence = incidence([&[1, 2], &[0, 1]]);
        let faults = Matching::of(&incidence, 3).faults(&incidence);
        let [Fault::Underdetermined { unknowns, equations }] = faults.as_slice() else {
            panic!("there are too few equations, and nothing else is wrong");
        };
        assert_eq!(
            (unknowns.as_slice(), equations.as_slice()),
            ([0, 1, 2].as_slice(), [0, 1].as_slice())
        );
    }
}
