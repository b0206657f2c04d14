//! The comparison of a declaration's text with the mechanism that rustc compiled.

mod batches;
mod bits;
mod random;
mod sheets;
mod solvers;

use std::cell::RefCell;

use kin_core::Mechanism;
use kin_core::batch::KeptMemory;
use kin_core::series::Series;
use kin_live::{Budget, CompilerBudget};

/// How many positions, possible or not, everything is compared at: a quarter of them without the environment variable
/// `KIN_EVERY_CASE`.
#[must_use]
pub fn samples() -> usize {
    if std::env::var_os("KIN_EVERY_CASE").is_some() {
        200
    } else {
        50
    }
}

/// The text between the braces of the declaration of a structure.
///
/// # Panics
/// If the file does not declare it.
#[must_use]
pub fn declaration<'a>(file: &'a str, name: &str) -> &'a str {
    let declarations = declarations(file);
    let found = declarations
        .into_iter()
        .find(|text| text.contains(&format!("struct {name} {{")));
    found.unwrap_or_else(|| panic!("{name} is not declared"))
}

/// The texts between the braces of all declarations of a file, outside of macros.
#[must_use]
pub fn declarations(file: &str) -> Vec<&str> {
    let starts = file.match_indices("mechanism! {\n").filter_map(|(place, opening)| {
        let is_whole = file[..place].ends_with('\n') || file[..place].ends_with("\ncrate::");
        is_whole.then_some(&file[place + opening.len()..])
    });
    starts
        .filter_map(|rest| rest.find("\n}\n").map(|end| &rest[..end]))
        .collect()
}

thread_local! {
    /// Memory of folds, which one mechanism leaves to the next.
    static MEMORY: RefCell<KeptMemory> = RefCell::default();
}

/// Compares a mechanism with its text in several kinds of numbers. Returns how many results of its translated methods
/// were finite, how many positions were solved, and how many numbers were summarised over turns.
///
/// # Panics
/// If they differ.
#[must_use]
pub fn assert_agreement<M: Mechanism<Scalar = f64>>(text: &str) -> [usize; 3] {
    // rustc compiles every mechanism, whatever it takes
    let limitless = CompilerBudget {
        text: usize::MAX,
        work: usize::MAX,
    };
    let budget = Budget {
        compiler: limitless,
        ..Budget::default()
    };
    let live = kin_live::Mechanism::declare_within(text, &budget).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let declaration = live.declaration();
    assert_eq!(declaration.name(), M::DESCRIPTION.name);
    solvers::assert_same_picture::<M>(&live);
    let finite = sheets::agreeing::<M, f64>(declaration)
        + sheets::agreeing::<M, f32>(declaration)
        + sheets::agreeing::<M, Series<4>>(declaration);
    solvers::assert_same_description::<M>(&live);
    solvers::assert_same_positions::<M>(&live);
    let solved = solvers::agreeing::<M, f64>(&live)
        + solvers::agreeing::<M, f32>(&live)
        + solvers::agreeing::<M, Series<4>>(&live)
        + batches::agreeing::<M>(&live);
    let folded = MEMORY.with_borrow_mut(|memory| batches::agreeing_folds::<M>(&live, memory));
    [finite, solved, folded]
}
