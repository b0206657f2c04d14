//! The mechanisms that are refined, and that have pages.

use kin_core::any::Of;
use kin_core::in_small_letters;
use kin_live::Mechanism;
use kin_search::pages::RefinedFunctions;

use super::declared::DeclaredArguments;
use super::fault::Fault;

/// The mechanism of this name, such as `four_bar`, of the program or of a file. The fault lists all names if there is
/// none.
pub(crate) fn mechanism(name: &str, declared: &DeclaredArguments) -> Result<&'static dyn RefinedFunctions, Fault> {
    // objectives keep a mechanism as long as the program runs
    let lasting = |mechanism: Mechanism| -> &'static dyn RefinedFunctions { Box::leak(Box::new(mechanism)) };
    let name_of = |functions: &dyn RefinedFunctions| in_small_letters(functions.description().name, '_');
    let traced: &'static dyn RefinedFunctions = Of::<kin_fit::TracedFourBar>::FUNCTIONS;
    let library = kin_studio::library::declarations().map(|(own, text)| (in_small_letters(own, '_'), text));
    let of_files = declared.mechanisms()?;
    if name_of(traced) == name {
        return Ok(traced);
    }
    // of the library, only this one is declared
    if let Some((_, text)) = library.clone().find(|(own, _)| own == name) {
        return Ok(lasting(Mechanism::declare(text).expect("the library has no mistakes")));
    }
    let names: Vec<String> = [name_of(traced)]
        .into_iter()
        .chain(library.map(|(own, _)| own))
        .chain(of_files.iter().map(|mechanism| name_of(mechanism)))
        .collect();
    if let Some(found) = of_files.into_iter().find(|mechanism| name_of(mechanism) == name) {
        return Ok(lasting(found));
    }
    Err(Fault::Wrong(format!(
        "`{name}` is no mechanism that this program refines or shows; there are {}, and those of files that \
         `--mechanism` names",
        names.join(", ")
    )))
}
