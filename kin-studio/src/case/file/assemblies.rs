//! The assemblies of a file.

use kin_core::any::Described as _;
use kin_live::Mechanism;

use super::super::assembly;
use super::super::value::Lengths;
use crate::file::{Mistake, Part};

/// What is wrong with the assembly, if anything is.
pub(super) fn mistake(mechanism: &Mechanism, part: &Part, lengths: &mut Lengths) -> Option<Mistake> {
    let names = mechanism.assembly_names();
    if part.text.is_empty() {
        return Some(part.mistake("the assembly has no name: write `assembly = open;`"));
    }
    if part.text == "all" && names.is_empty() {
        let message = "the positions of this mechanism have no names: give values of its unknowns near each that you \
                       mean";
        return Some(part.mistake(message));
    }
    assembly::each(&part.text, &names).iter().find_map(|one| {
        let wrong = assembly::wanted(&names, mechanism.description().unknowns, one, lengths).err()?;
        let start = part.range.start + part.text.find(one.as_str()).unwrap_or(0);
        // a file has no options
        let message = wrong
            .replace("`--assembly ", "`assembly = ")
            .replace("`--assembly`", "`assembly`");
        Some(Mistake::new(message, start..start + one.len()))
    })
}
