//! The results of a campaign.

use std::fmt;
use std::fmt::Write as _;

use kin_core::any::AssemblyChoice;
use kin_core::{Failure, SolveError, TrackError};
use kin_tests::counting::Calls;

use super::bounded::TERMS;
use super::topology::{Ending, Problem};

/// Kinds of refusals, as the table names them.
const REFUSALS: [&str; 8] = [
    "reach",
    "singular",
    "range",
    "domain",
    "converged",
    "finite",
    "turns",
    "other",
];

/// Kinds of ends of a track, as the table names them.
const ENDS: [&str; 6] = ["arrived", "limit", "change point", "unbounded", "failed", "lost"];

/// The figures of one topology.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tally {
    /// The mechanism.
    pub(crate) name: &'static str,
    /// Poses that were found.
    pub(crate) solved: usize,
    /// Those among them that are known to so few digits that nothing can be said of them.
    pub(crate) ill: usize,
    /// Poses that were refused, by the kinds of refusals.
    pub(crate) refused: [usize; REFUSALS.len()],
    /// The largest correction that the closure asks for, order by order, in units of ε times the condition.
    pub(crate) closure: [f64; TERMS],
    /// Values of batches that were compared.
    pub(crate) values: usize,
    /// Poses of batches that close for a batch and not alone, or the other way round, as an earlier number is known too
    /// badly.
    pub(crate) undecided: usize,
    /// The largest difference of a batch from single poses, in the same unit.
    pub(crate) batch: f64,
    /// The largest difference of single from double precision, in the unit of single precision.
    pub(crate) single: f64,
    /// Poses compared in single precision.
    pub(crate) singles: usize,
    /// Tracks, by the kinds of their ends.
    pub(crate) tracks: [usize; ENDS.len()],
    /// The most solutions, and the most closures, that one track asked for.
    pub(crate) steps: Calls,
}

impl Tally {
    /// Counts a refusal.
    pub(super) fn refuse(&mut self, error: &SolveError) {
        let kind = match error.failure {
            Failure::OutOfReach { .. } => 0,
            Failure::Singular { .. } => 1,
            Failure::OutOfRange { .. } | Failure::Ambiguous { .. } => 2,
            Failure::OutsideDomain { .. } => 3,
            Failure::NotConverged { .. } => 4,
            Failure::NotFinite { .. } => 5,
            Failure::TooManyRevolutions { .. } => 6,
            _ => 7,
        };
        self.refused[kind] += 1;
    }

    /// Counts the end of a track.
    pub(super) fn end(&mut self, ending: &Ending, steps: Calls) {
        let kind = match ending {
            Ok(_) => 0,
            Err(TrackError::TurningPoint(_)) => 1,
            Err(TrackError::ChangePoint(_)) => 2,
            Err(TrackError::Pole(_)) => 3,
            Err(TrackError::Failed(_)) => 4,
            Err(_) => 5,
        };
        self.tracks[kind] += 1;
        self.widen(steps);
    }

    fn widen(&mut self, steps: Calls) {
        self.steps.solutions = self.steps.solutions.max(steps.solutions);
        self.steps.closures = self.steps.closures.max(steps.closures);
    }

    fn add(&mut self, other: &Self) {
        self.solved += other.solved;
        self.ill += other.ill;
        self.values += other.values;
        self.undecided += other.undecided;
        self.singles += other.singles;
        for (own, other) in self.refused.iter_mut().zip(other.refused) {
            *own += other;
        }
        for (own, other) in self.tracks.iter_mut().zip(other.tracks) {
            *own += other;
        }
        for (own, other) in self.closure.iter_mut().zip(other.closure) {
            *own = own.max(other);
        }
        self.batch = self.batch.max(other.batch);
        self.single = self.single.max(other.single);
        self.widen(other.steps);
    }
}

/// Something that is not as it must be, with all that is needed to see it again.
#[derive(Clone, Debug)]
pub(crate) struct Finding {
    /// The mechanism.
    pub(crate) name: &'static str,
    /// Which check has failed.
    pub(crate) check: &'static str,
    /// The findings.
    pub(crate) what: String,
    /// Dimensions and inputs.
    pub(crate) problem: Problem,
    /// The assembly, or the values near by.
    pub(crate) assembly: AssemblyChoice,
}

impl fmt::Display for Finding {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            name,
            check,
            what,
            problem,
            assembly,
        } = self;
        writeln!(formatter, "{check}: {name}: {what}")?;
        // every digit, so that the numbers can be given again
        writeln!(formatter, "    parameters {:?}", problem.parameters)?;
        write!(formatter, "    inputs {:?}, {assembly:?}", problem.inputs)
    }
}

/// The figures of all topologies, and what is wrong.
#[derive(Clone, Debug, Default)]
pub(crate) struct Report {
    /// The figures, topology by topology.
    pub(crate) tallies: Vec<Tally>,
    /// The defect.
    pub(crate) findings: Vec<Finding>,
}

impl Report {
    /// The figures of all together.
    #[must_use]
    pub(crate) fn total(&self) -> Tally {
        let mut total = Tally {
            name: "all",
            ..Tally::default()
        };
        for tally in &self.tallies {
            total.add(tally);
        }
        total
    }

    /// Asserts that nothing is wrong.
    ///
    /// # Panics
    /// With the first findings of each check, if there are any.
    pub(crate) fn assert(&self) {
        const SHOWN: usize = 3;
        if self.findings.is_empty() {
            return;
        }
        let mut text = format!("{} findings\n", self.findings.len());
        let mut checks: Vec<&str> = self.findings.iter().map(|finding| finding.check).collect();
        checks.sort_unstable();
        checks.dedup();
        for check in checks {
            let of_check = || self.findings.iter().filter(|finding| finding.check == check);
            writeln!(text, "{check}: {} findings", of_check().count()).expect("a string can be written");
            for tally in &self.tallies {
                let own = || of_check().filter(|finding| finding.name == tally.name);
                for finding in own().take(SHOWN) {
                    writeln!(text, "  {finding}").expect("a string can be written");
                }
            }
        }
        panic!("{text}");
    }
}

impl fmt::Display for Report {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let total = self.total();
        let rows = || self.tallies.iter().chain([&total]);
        writeln!(
            formatter,
            "| mechanism | solved | ill-conditioned | {} |",
            REFUSALS.join(" | ")
        )?;
        writeln!(formatter, "|{}", "---|".repeat(3 + REFUSALS.len()))?;
        for tally in rows() {
            let refused = tally.refused.map(|count| count.to_string()).join(" | ");
            writeln!(
                formatter,
                "| `{}` | {} | {} | {refused} |",
                tally.name, tally.solved, tally.ill
            )?;
        }
        writeln!(formatter)?;
        writeln!(
            formatter,
            "| mechanism | closure: position | velocity | acceleration | jerk | snap | batch | values | undecided | \
                single | poses |"
        )?;
        writeln!(formatter, "|{}", "---|".repeat(11))?;
        for tally in rows() {
            let closure = tally.closure.map(|worst| format!("{worst:.2}")).join(" | ");
            writeln!(
                formatter,
                "| `{}` | {closure} | {:.2} | {} | {} | {:.2} | {} |",
                tally.name, tally.batch, tally.values, tally.undecided, tally.single, tally.singles
            )?;
        }
        writeln!(formatter)?;
        writeln!(
            formatter,
            "| track | {} | most solutions | most closures |",
            ENDS.join(" | ")
        )?;
        writeln!(formatter, "|{}", "---|".repeat(3 + ENDS.len()))?;
        for tally in rows() {
            let tracks = tally.tracks.map(|count| count.to_string()).join(" | ");
            let Calls { solutions, closures } = tally.steps;
            writeln!(formatter, "| `{}` | {tracks} | {solutions} | {closures} |", tally.name)?;
        }
        Ok(())
    }
}
