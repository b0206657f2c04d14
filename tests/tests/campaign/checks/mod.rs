//! Checks that must hold for any numbers.

mod assembly;
mod batch;
mod edges;
mod pose;
mod single;
mod tracks;

use std::panic::{AssertUnwindSafe, catch_unwind};

use kin_core::SolveError;
use kin_core::any::AssemblyChoice;

use super::draw::{Draw, Family, choice, draw};
use super::tally::{Finding, Report, Tally};
use super::topology::{Found, Problem, Topology};
use super::unit::Units;
use kin_tests::random::Random;

/// How large a campaign is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Size {
    /// Draws of each family for each topology.
    pub(crate) draws: usize,
    /// Of so many draws one is tracked.
    pub(crate) tracked: usize,
    /// Of so many draws one is brought to the edge of where the mechanism closes.
    pub(crate) edges: usize,
    /// Poses in a batch that is solved on all cores.
    pub(crate) parallel: usize,
    /// Where the numbers start.
    pub(crate) seed: u64,
}

/// A problem with what became of it.
struct Solved {
    problem: Problem,
    assembly: AssemblyChoice,
    result: Result<Pose, SolveError>,
}

/// A pose, and how well it is known if it is.
struct Pose {
    found: Found,
    units: Option<Units>,
}

/// The condition up to which anything is said of a pose: a tenth of 1 / √ε. Near a limit position its square times ε is
/// what the unit, which is of the first order, leaves out.
fn most_condition(epsilon: f64) -> f64 {
    0.1 / epsilon.sqrt()
}

impl Pose {
    /// The units, unless so many digits are lost at a given ε that they mean little.
    fn known(&self, epsilon: f64) -> Option<&Units> {
        self.units
            .as_ref()
            .filter(|units| units.condition <= most_condition(epsilon))
    }
}

/// The campaign through one topology.
struct Campaign {
    topology: Topology,
    tally: Tally,
    findings: Vec<Finding>,
    /// The case under test, to be reported after a panic.
    current: (Problem, AssemblyChoice),
}

/// Runs the campaign through a topology, and enters it into the report.
pub(crate) fn run(topology: Topology, size: Size, report: &mut Report) {
    let mut campaign = Campaign {
        topology,
        tally: Tally {
            name: topology.description().name,
            ..Tally::default()
        },
        findings: Vec::new(),
        current: (Problem::default(), AssemblyChoice::Near(Vec::new())),
    };
    let mut all = Vec::new();
    for (number, family) in (0_u64..).zip(Family::ALL) {
        for index in 0..size.draws {
            let mut random = Random::new(size.seed ^ (number << 40) ^ (index as u64) << 8);
            campaign.guarded(|campaign| campaign.look_at(family, index, size, &mut random, &mut all));
        }
    }
    campaign.guarded(|campaign| campaign.batches(&all, size));
    report.tallies.push(campaign.tally);
    report.findings.append(&mut campaign.findings);
}

impl Campaign {
    /// Notes that something is wrong.
    fn find(&mut self, check: &'static str, what: String, problem: &Problem, assembly: &AssemblyChoice) {
        self.findings.push(Finding {
            name: self.tally.name,
            check,
            what,
            problem: problem.clone(),
            assembly: assembly.clone(),
        });
    }

    /// Does something that must not panic.
    fn guarded(&mut self, work: impl FnOnce(&mut Self)) {
        if let Err(payload) = catch_unwind(AssertUnwindSafe(|| work(self))) {
            let message = payload
                .downcast_ref::<String>()
                .cloned()
                .or_else(|| payload.downcast_ref::<&str>().map(ToString::to_string));
            let (problem, assembly) = self.current.clone();
            self.find("panic", message.unwrap_or_default(), &problem, &assembly);
        }
    }

    /// One draw, in some of its assemblies.
    fn look_at(&mut self, family: Family, index: usize, size: Size, random: &mut Random, all: &mut Vec<Solved>) {
        let Draw {
            problem,
            near,
            is_closed,
        } = draw(&self.topology, family, random);
        let assemblies: Vec<AssemblyChoice> = match self.topology.solvers.assembly_count() {
            0 => vec![AssemblyChoice::Near(near.clone())],
            // Four of them at most, lest the batches of each be small.
            count => {
                let mut some = || choice(random, 4) * (count - 1) / 3;
                let (first, second) = (some(), some());
                let both = if first == second {
                    vec![first]
                } else {
                    vec![first, second]
                };
                both.into_iter().map(AssemblyChoice::Index).collect()
            }
        };
        let solved: Vec<Solved> = assemblies
            .into_iter()
            .map(|assembly| self.solve(&problem, assembly))
            .collect();
        if is_closed {
            self.is_not_missed(&problem, &near);
        }
        if let [one, other] = solved.as_slice() {
            self.are_apart(one, other);
        }
        for solved in &solved {
            self.in_single_precision(solved, family);
            if index.is_multiple_of(size.tracked) {
                self.track(solved, family, random);
            }
        }
        if index.is_multiple_of(size.edges)
            && let Some(solved) = solved.first()
        {
            all.extend(self.edges(solved, random));
        }
        all.extend(solved);
    }
}
