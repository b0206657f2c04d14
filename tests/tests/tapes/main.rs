//! Recorded solvers of the whole library against the solvers themselves.
//!
//! Tests of other languages need tools besides Rust: they are ignored, and `.ci/run languages` runs them.

mod arguments;
mod c;
mod chapter;
mod exact;
mod languages;
mod poses;
mod sensitivities;

use kin_core::tape::{self, Options, Stop};
use kin_core::{Failure, Pose, SolveError};
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};

use poses::poses;

/// How many inputs and dimensions of a mechanism are compared, half of them with dimensions that may not close.
const POSES: u32 = if cfg!(feature = "every-case") { 1000 } else { 100 };

/// How many of them a tape is recorded at.
const RECORDED: u32 = if cfg!(feature = "every-case") { 20 } else { 4 };

/// What was compared.
#[derive(Default)]
struct Compared {
    mechanisms: Vec<&'static str>,
    found: usize,
    refused: usize,
    margins: usize,
    ranges: usize,
    wrong: Vec<String>,
}

impl Compared {
    fn compare<M: ThroughSnap>(&mut self, own: Result<M::Pose, SolveError>, found: Result<Vec<f64>, Stop>, size: f64) {
        let name = M::DESCRIPTION.name;
        match (own, found) {
            (Ok(pose), Ok(found)) => {
                let (unknowns, outputs) = (pose.unknown_motions(), pose.output_motions());
                let mut own: Vec<f64> = Vec::new();
                for motion in unknowns.as_ref() {
                    own.extend(motion.as_ref());
                }
                for motion in outputs.as_ref() {
                    own.extend(motion.as_ref());
                }
                let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
                if bits(&own) != bits(&found) {
                    self.wrong.push(format!("{name}: {own:?} {found:?}"));
                }
                self.found += 1;
            }
            (Err(error), Err(stop)) => {
                self.refused += 1;
                if stop.block != error.block {
                    self.wrong.push(format!("{name}: {stop:?} {error:?}"));
                }
                self.ranges += usize::from(self.range::<M>(&stop, &error));
                if let Failure::OutOfReach { margin } = error.failure {
                    self.margins += 1;
                    // The check has its margin from squares of lengths up to `size`.
                    if (stop.margin - margin).abs() > 64.0 * f64::EPSILON * size * (1.0 + size / margin.abs()) {
                        self.wrong.push(format!("{name}: {stop:?} {margin}"));
                    }
                }
            }
            (own, found) => self.wrong.push(format!("{name}: {own:?} {found:?}")),
        }
    }
}

impl Compared {
    /// Whether a range refuses the pose. The check says so with the margin of the error.
    fn range<M: ThroughSnap>(&mut self, stop: &Stop, error: &SolveError) -> bool {
        let is_same = match error.failure {
            Failure::OutOfRange { value, low, high, .. } => {
                let is_of_a_range = matches!(
                    stop.name,
                    "a solution in the range" | "range of an angle" | "range of a value"
                );
                is_of_a_range && stop.margin.to_bits() == (value - low).min(high - value).to_bits()
            }
            // The error does not name the ends of the range, in which both solutions lie.
            Failure::Ambiguous { .. } => stop.name == "only one solution in the range" && stop.margin <= 0.0,
            _ => return false,
        };
        if !is_same {
            self.wrong.push(format!("{}: {stop:?} {error:?}", M::DESCRIPTION.name));
        }
        true
    }
}

impl Visitor for Compared {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let tape = tape::record::<M>(&Options::new()).expect("every mechanism of the library is recorded");
        self.mechanisms.push(M::DESCRIPTION.name);
        for pose in poses::<M>(case, POSES) {
            let own = match pose.near {
                Some(near) => pose.mechanism.solve_near(pose.inputs, near),
                None => pose
                    .mechanism
                    .solve(pose.inputs, M::assembly(pose.number).expect("it is one of them")),
            };
            self.compare::<M>(own, tape.run(&pose.arguments()), pose.size());
        }
    }
}

/// Every tape finds what `solve` finds to the last bit, in every assembly, in and out of reach. Where there is no pose,
/// block and margin are those of the error.
#[test]
fn tapes_are_their_solvers() {
    let mut compared = Compared::default();
    cases::library(&mut compared);
    cases::coupled_library(&mut compared);
    cases::ranges(&mut compared);
    let wrong = &compared.wrong;
    println!("{:?}", compared.mechanisms);
    println!(
        "{} poses, {} refused, {} margins, {} ranges",
        compared.found, compared.refused, compared.margins, compared.ranges
    );
    assert!(
        wrong.is_empty(),
        "{} wrong: {:#?}",
        wrong.len(),
        &wrong[..wrong.len().min(12)]
    );
    assert!(compared.found > 2000 && compared.refused > 500 && compared.margins > 500 && compared.ranges > 100);
}

/// A record does not depend on the place where it is made: at 20 poses, in reach and out of reach, the tape is the
/// same.
struct SameEverywhere;

impl Visitor for SameEverywhere {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let everywhere = tape::record::<M>(&Options::new().with_skeleton()).expect("it is recorded");
        for pose in poses::<M>(case, RECORDED) {
            let there =
                tape::record_at::<M>(&Options::new().with_skeleton(), &pose.arguments()).expect("it is recorded");
            let is_same = (
                &there.nodes,
                &there.steps,
                &there.results,
                &there.searches,
                &there.systems,
                &there.solutions,
            ) == (
                &everywhere.nodes,
                &everywhere.steps,
                &everywhere.results,
                &everywhere.searches,
                &everywhere.systems,
                &everywhere.solutions,
            );
            assert!(is_same, "{} at {:?}", M::DESCRIPTION.name, pose.arguments());
        }
    }
}

#[test]
fn tapes_are_the_same_wherever_they_are_recorded() {
    cases::some_of_the_library(&mut SameEverywhere);
    cases::ranges(&mut SameEverywhere);
}
