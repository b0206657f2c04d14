//! The mechanisms that are refined, and that have pages.

use std::iter::once;
use std::sync::LazyLock;

use kin_core::any::Of;
use kin_core::in_small_letters;
use kin_live::Mechanism;
use kin_search::pages::RefinedFunctions;

use super::declared::DeclaredArguments;
use super::fault::Fault;

/// A mechanism that lasts as long as the program.
type Lasting = Box<dyn RefinedFunctions + Send + Sync>;

/// The mechanisms of the program.
static OF_PROGRAM: LazyLock<Vec<Lasting>> = LazyLock::new(|| {
    let traced: Lasting = Box::new(*Of::<kin_fit::TracedFourBar>::FUNCTIONS);
    let library = kin_studio::library::declarations()
        .map(|text| -> Lasting { Box::new(Mechanism::declare(text).expect("the library has no mistakes")) });
    once(traced).chain(library).collect()
});

/// The mechanism of this name, such as `four_bar`, of the program or of a file. The fault lists all names if there is
/// none.
pub(crate) fn mechanism(name: &str, declared: &DeclaredArguments) -> Result<&'static dyn RefinedFunctions, Fault> {
    let mut all: Vec<&'static dyn RefinedFunctions> = Vec::with_capacity(OF_PROGRAM.len());
    for mechanism in OF_PROGRAM.iter() {
        all.push(&**mechanism);
    }
    for mechanism in declared.mechanisms()? {
        // objectives keep a mechanism as long as the program runs
        all.push(Box::leak(Box::new(mechanism)));
    }
    let own = |functions: &dyn RefinedFunctions| in_small_letters(functions.description().name, '_');
    let found = all.iter().find(|functions| own(**functions) == name);
    found.copied().ok_or_else(|| {
        let names: Vec<String> = all.iter().map(|functions| own(*functions)).collect();
        Fault::Wrong(format!(
            "`{name}` is no mechanism that this program refines or shows; there are {}, and those of files that \
             `--mechanism` names",
            names.join(", ")
        ))
    })
}
