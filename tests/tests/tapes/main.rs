//! Recorded solvers of the whole library against the solvers themselves.

use kin_core::tape::{self, Options, Stop};
use kin_core::{Failure, Pose, Row, SolveError};
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::random::Random;

/// A mechanism of the library has this many poses compared, half of them with dimensions that may not close.
const POSES: usize = 120;

/// What was compared.
#[derive(Default)]
struct Compared {
    mechanisms: Vec<&'static str>,
    found: usize,
    refused: usize,
    margins: usize,
    wrong: Vec<String>,
}

/// The numbers that a tape is given for a pose.
fn arguments<M: ThroughSnap>(
    mechanism: &M,
    inputs: M::Inputs<M::Motion<f64>>,
    near: Option<M::Unknowns<f64>>,
    number: usize,
) -> Vec<f64> {
    let mut own: Vec<f64> = mechanism.parameters().as_ref().to_vec();
    for motion in inputs.as_ref() {
        own.extend(motion.as_ref());
    }
    match near {
        Some(near) => own.extend(near.as_ref()),
        None => {
            let choices = M::ASSEMBLY_COUNT.trailing_zeros();
            let is_crossed = |choice: u32| number >> (choices - 1 - choice) & 1 == 1;
            own.extend((0..choices).map(|choice| if is_crossed(choice) { -1.0 } else { 1.0 }));
        }
    }
    own
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

impl Visitor for Compared {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let tape = tape::record::<M>(&Options::new()).expect("every mechanism of the library is recorded");
        self.mechanisms.push(M::DESCRIPTION.name);
        let mut random = Random::new(16);
        for pose in 0..POSES {
            let mechanism: M = if pose % 2 == 0 {
                case.varied(&mut random)
            } else {
                M::from_parameters(M::Parameters::from_fn(|index| {
                    case.parameters[index] * random.between(0.3, 2.0)
                }))
            };
            let inputs = case.inputs::<M>((pose as f64 + 0.5) / POSES as f64, &mut random);
            let size = mechanism
                .parameters()
                .as_ref()
                .iter()
                .fold(1.0, |sum, own| sum + own.abs());
            let motions = <M::Inputs<M::Motion<f64>> as Row<_>>::from_fn(|index| inputs[index]);
            if M::ASSEMBLY_COUNT > 0 {
                for (number, assembly) in M::assemblies().enumerate() {
                    let found = tape.run(&arguments(&mechanism, motions, None, number));
                    self.compare::<M>(mechanism.solve_motion(motions, assembly), found, size);
                }
            } else {
                let near = M::Unknowns::from_fn(|_| random.between(-4.0, 4.0));
                let found = tape.run(&arguments(&mechanism, motions, Some(near), 0));
                self.compare::<M>(mechanism.solve_motion_near(motions, near), found, size);
            }
        }
    }
}

/// Every tape finds what `solve` finds to the last bit, in every assembly, in and out of reach. Where there is no pose, block and
/// margin are those of the error.
#[test]
fn tapes_are_their_solvers() {
    let mut compared = Compared::default();
    cases::library(&mut compared);
    cases::coupled_library(&mut compared);
    let wrong = &compared.wrong;
    println!("{:?}", compared.mechanisms);
    println!(
        "{} poses, {} refused, {} margins",
        compared.found, compared.refused, compared.margins
    );
    assert!(
        wrong.is_empty(),
        "{} wrong: {:#?}",
        wrong.len(),
        &wrong[..wrong.len().min(12)]
    );
    assert!(compared.found > 2000 && compared.refused > 500 && compared.margins > 500);
}
