//! Declarations that nobody trusts, declared and solved in this process: no panic, no number that is not finite, and
//! within the usual budget no long time and little memory.
//!
//! `KIN_FUZZ=100000 cargo test --release -p kin-declarations --test untrusted -- --ignored --nocapture` takes as many;
//! `KIN_SEED` is the first. Without it, 400 small ones are taken at every change.

mod attacks;
mod cost;

use std::env;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use kin_core::any::{AssemblyOver, Described, EveryPosition, MotionOver, NearOver, PositionChoice};
use kin_declarations::{Kind, Random, Sample, Scale, declaration};
use kin_live::{Budget, CompilerBudget, DeclareError, Mechanism, Resource};

use cost::{most_resident, processor_time, resident};

/// The memory that the process may take at any time, in bytes.
const MEMORY: usize = 256 << 20;

/// The time that a declaration may take, optimised.
const PATIENCE: Duration = Duration::from_secs(2);

/// Costs are those of the process: one test at a time.
static ALONE: Mutex<()> = Mutex::new(());

/// What became of declarations.
#[derive(Debug, Default)]
struct Tally {
    solved: usize,
    declared: usize,
    mistaken: usize,
    too_large: usize,
    slowest: (Duration, String),
}

impl Tally {
    /// Declares and solves a text. A panic tells the text.
    fn add(&mut self, text: &str, budget: &Budget, seed: u64) {
        let before = processor_time();
        let outcome = catch_unwind(AssertUnwindSafe(|| match Mechanism::declare_within(text, budget) {
            Ok(mechanism) => {
                self.declared += 1;
                self.solved += usize::from(solve(&mechanism, seed) > 0);
            }
            Err(DeclareError::TooLarge(_)) => self.too_large += 1,
            Err(mistakes) => {
                let told = mistakes.to_string();
                assert!(!told.is_empty() && !told.contains("bug in kin"), "{told}");
                self.mistaken += 1;
            }
        }));
        assert!(outcome.is_ok(), "{seed}: {text}");
        let time = processor_time().saturating_sub(before);
        assert!(cfg!(debug_assertions) || time < PATIENCE, "{time:?} for {seed}: {text}");
        if time > self.slowest.0 {
            self.slowest = (time, format!("{seed}: {}", text.chars().take(100).collect::<String>()));
        }
        assert!(most_resident() < MEMORY, "{} bytes for {seed}: {text}", most_resident());
    }
}

/// Solves a mechanism at numbers of which some are none. Returns how many positions were found.
fn solve(mechanism: &Mechanism, seed: u64) -> usize {
    let mut random = Random::new(seed);
    let description = mechanism.description();
    let orders = description.order + 1;
    let mut found = 0;
    for broken in [false, false, true] {
        let mut drawn = |count: usize| -> Vec<f64> { (0..count).map(|_| 0.3 + 2.0 * random.fraction()).collect() };
        let mut parameters = drawn(description.parameters.len());
        let motions = drawn(description.inputs.len() * orders);
        let near = drawn(description.unknowns.len());
        if let (true, Some(first)) = (broken, parameters.first_mut()) {
            *first = [f64::NAN, f64::INFINITY, 0.0, 1e300, -1e-300][random.below(5)];
        }
        let inputs: Vec<f64> = motions.iter().step_by(orders).copied().collect();
        let (mut unknowns, mut rates) = (near.clone(), vec![0.0; near.len() * orders]);
        let mut outputs = vec![0.0; description.outputs.len() * orders];
        let mut all_finite = |numbers: &[&[f64]]| {
            found += 1;
            assert!(
                numbers
                    .iter()
                    .flat_map(|numbers| *numbers)
                    .all(|number| number.is_finite()),
                "{numbers:?}"
            );
        };
        let first = mechanism.assembly_count().min(4);
        for assembly in 0..first {
            if mechanism
                .position_of_assembly(&parameters, &inputs, assembly, &mut unknowns)
                .is_ok()
            {
                all_finite(&[&unknowns]);
            }
        }
        if mechanism
            .position_near(&parameters, &inputs, &near, &mut unknowns)
            .is_ok()
        {
            all_finite(&[&unknowns]);
        }
        let choices = (0..first)
            .map(PositionChoice::Assembly)
            .chain([PositionChoice::Near(&near)]);
        for choice in choices {
            if mechanism
                .motion(&parameters, &motions, choice, &mut rates, &mut outputs)
                .is_ok()
            {
                all_finite(&[&rates, &outputs]);
            }
        }
        let _ = mechanism.every_position(&parameters, &inputs, &mut |unknowns| all_finite(&[unknowns]));
    }
    found
}

fn number(name: &str, usual: u64) -> u64 {
    env::var(name).map_or(usual, |value| value.parse().expect("a number"))
}

/// A budget whose searches end soon: a path of ill-conditioned equations may take a second.
fn budget(work: usize) -> Budget {
    Budget {
        compiler: CompilerBudget {
            work,
            ..CompilerBudget::default()
        },
        paths: 2,
    }
}

#[test]
fn declarations_are_compiled_and_solved_or_refused() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut tally = Tally::default();
    for seed in 0..400 {
        let kind = Kind::ALL[(seed % 4) as usize];
        tally.add(&declaration(kind, seed, Scale::Small), &budget(20_000), seed);
    }
    println!("{tally:?}");
    assert!(
        tally.solved > 100 && tally.mistaken > 50 && tally.too_large > 10,
        "{tally:?}"
    );
}

#[test]
#[ignore = "takes minutes"]
fn any_number_of_declarations() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let usual = CompilerBudget::default().work;
    let mut tally = Tally::default();
    let first = number("KIN_SEED", 0);
    for seed in first..first + number("KIN_FUZZ", 100_000) {
        let kind = Kind::ALL[(seed % 4) as usize];
        tally.add(&declaration(kind, seed, Scale::Full), &budget(usual), seed);
    }
    println!("{tally:#?}\n{} MB at most", most_resident() >> 20);
}

/// What is written to do harm is refused, or it does none.
#[test]
fn attacks() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let work = if cfg!(debug_assertions) {
        50_000
    } else {
        CompilerBudget::default().work
    };
    for (name, text) in attacks::all() {
        let before = processor_time();
        let mut tally = Tally::default();
        tally.add(&text, &budget(work), 0);
        println!(
            "{name}: {} bytes, {:?}, {:?}",
            text.len(),
            processor_time().saturating_sub(before),
            tally
        );
    }
}

/// Assemblies and paths beyond the limits are not counted through.
#[test]
fn searches_are_bounded() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let enough = budget(10_000_000);
    let refused = Mechanism::declare_within(&attacks::four_bars_in_series(17), &enough);
    let Err(DeclareError::TooLarge(excess)) = refused else {
        panic!("it has 2^17 assemblies");
    };
    assert_eq!((excess.resource, excess.limit), (Resource::Assemblies, 1 << 16));
    for (paths, found) in [(7, 0), (8, 8)] {
        let series = Mechanism::declare_within(&attacks::four_bars_in_series(3), &Budget { paths, ..enough });
        let series = series.expect("it is small");
        let search = series
            .every_position(&[1.0, 3.0, 3.1], &[1.2], &mut |_| ())
            .expect("all numbers are finite");
        assert_eq!((search.found, search.is_complete), (found, found > 0), "{search:?}");
    }
}

/// A mechanism gives its memory back: a process that declares one after another does not grow.
#[test]
fn memory_is_given_back() {
    /// What the allocator may keep.
    const KEPT: usize = 32 << 20;
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let declare = |seed: u64| {
        drop(Mechanism::declare_within(
            &Sample::new(seed).to_string(),
            &budget(50_000),
        ));
    };
    (0..20).for_each(declare);
    let before = resident();
    assert!(before > 0 || !cfg!(target_os = "linux"), "the memory is not measured");
    (20..20 + number("KIN_FUZZ", 100)).for_each(declare);
    let grown = resident().saturating_sub(before);
    println!("{} KB more", grown >> 10);
    assert!(grown < KEPT, "{grown} bytes more");
}
