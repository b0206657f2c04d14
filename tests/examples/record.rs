//! Numbers of every mechanism of the tests and the library, to the last bit: what a change of structure must not
//! change.
//!
//! Each mechanism is solved through snap at 200 scattered poses in each assembly, where it closes and where it does
//! not. A line tells how many solves succeeded and how many were refused, and a hash of all results and errors. Record
//! before a change, and compare after it:
//!
//! ```text
//! cargo run -p kin-tests --features record --example record > before
//! cargo run -p kin-tests --features record --example record | diff before -
//! ```

use std::hash::{DefaultHasher, Hash as _, Hasher as _};

use kin_core::prelude::*;
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::mechanisms::{coupled, sensitive};
use kin_tests::random::Random;

const POSES: u32 = 200;

/// Results of one mechanism.
struct Tally {
    hash: DefaultHasher,
    solved: usize,
    refused: usize,
}

impl Tally {
    fn new() -> Self {
        // its keys are fixed, unlike those of a hash map's hasher
        Self {
            hash: DefaultHasher::new(),
            solved: 0,
            refused: 0,
        }
    }

    /// Adds a result. Numbers are written with as many digits as tell them apart.
    fn add(&mut self, result: &Result<impl std::fmt::Debug, SolveError>) {
        *if result.is_ok() {
            &mut self.solved
        } else {
            &mut self.refused
        } += 1;
        format!("{result:?}").hash(&mut self.hash);
    }

    fn print(&self, name: &str) {
        println!(
            "{name}: {} solved, {} refused, {:016x}",
            self.solved,
            self.refused,
            self.hash.finish()
        );
    }
}

/// Solves in every assembly, or near random values where assemblies depend on the dimensions.
fn solve<M: ThroughSnap>(tally: &mut Tally, mechanism: &M, inputs: M::Inputs<Motion<f64, 5>>, random: &mut Random) {
    for assembly in M::assemblies() {
        tally.add(&mechanism.solve(inputs, assembly));
    }
    let near = M::Unknowns::from_fn(|_| random.between(-3.0, 3.0));
    tally.add(&mechanism.solve_near(inputs, near));
}

/// The mechanisms with dimensions for which they close.
struct Record;

impl Visitor for Record {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let mut random = Random::new(M::DESCRIPTION.name.bytes().map(u64::from).sum());
        let mut tally = Tally::new();
        for pose in 0..POSES {
            // every third is far from the case, so that many do not close
            let mechanism: M = if pose % 3 == 0 {
                M::from_parameters(M::Parameters::from_fn(|index| {
                    case.parameters[index] * random.between(0.3, 3.0)
                }))
            } else {
                case.varied(&mut random)
            };
            let fraction = random.between(0.0, 1.0);
            let inputs = case.inputs::<M>(fraction, &mut random);
            solve(&mut tally, &mechanism, inputs, &mut random);
        }
        tally.print(M::DESCRIPTION.name);
    }
}

/// A mechanism with any dimensions.
fn anywhere<M: ThroughSnap>() {
    let mut random = Random::new(M::DESCRIPTION.name.bytes().map(u64::from).sum());
    let mut tally = Tally::new();
    for _ in 0..POSES {
        let mechanism = M::from_parameters(M::Parameters::from_fn(|_| random.between(0.2, 4.0)));
        let inputs = M::Inputs::from_fn(|_| {
            let value = random.between(-3.1, 3.1);
            Motion::new(random.motion(value))
        });
        solve(&mut tally, &mechanism, inputs, &mut random);
    }
    tally.print(M::DESCRIPTION.name);
}

fn main() {
    cases::all(&mut Record);
    cases::coupled_library(&mut Record);
    macro_rules! anywhere {
        ($($module:ident { $($mechanism:ident)+ })+) => { $($(anywhere::<$module::$mechanism>();)+)+ };
    }
    anywhere! {
        coupled { Kepler RelativeDrive Triad StephensonThree SixCoupled }
        sensitive {
            SensitiveFourBar SensitiveRanged SensitiveSlider SensitivePump SensitiveSlides SensitiveWatt
            SensitiveLogarithm SensitiveFunctions SensitiveFourBarDivided SensitiveFreudenstein SensitiveGeometric
            SensitiveSeries SensitiveOutputs SensitiveTernary SensitiveRssr SensitiveRssp
        }
    }
}
