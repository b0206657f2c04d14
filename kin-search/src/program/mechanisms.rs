//! The mechanisms that are refined, and that have pages.

use kin_core::any::Of;
use kin_core::in_small_letters;
use kin_core::library::{
    ChebyshevLinkage, FourBar, HoekenLinkage, JansenLeg, KlannLeg, OffsetSliderCrank, RobertsLinkage, SliderCrank,
    StephensonIII, WattI, WattII,
};
use kin_search::pages::RefinedFunctions;

use super::declared::DeclaredArguments;
use super::fault::Fault;

/// The mechanisms of the program.
const COMPILED: [&dyn RefinedFunctions; 12] = [
    Of::<kin_fit::TracedFourBar>::FUNCTIONS,
    Of::<FourBar>::FUNCTIONS,
    Of::<SliderCrank>::FUNCTIONS,
    Of::<OffsetSliderCrank>::FUNCTIONS,
    Of::<HoekenLinkage>::FUNCTIONS,
    Of::<ChebyshevLinkage>::FUNCTIONS,
    Of::<RobertsLinkage>::FUNCTIONS,
    Of::<WattI>::FUNCTIONS,
    Of::<WattII>::FUNCTIONS,
    Of::<StephensonIII>::FUNCTIONS,
    Of::<JansenLeg>::FUNCTIONS,
    Of::<KlannLeg>::FUNCTIONS,
];

/// The mechanism of this name, such as `four_bar`, of the program or of a file. The fault lists all names if there is
/// none.
pub(crate) fn mechanism(name: &str, declared: &DeclaredArguments) -> Result<&'static dyn RefinedFunctions, Fault> {
    let mut all = COMPILED.to_vec();
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
