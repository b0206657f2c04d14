//! `kin verify`: the solver beside two oracles.

use super::super::command::Setup;
use super::super::progress::watched;
use super::print;
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::subject::Subject;

pub(super) fn run(subject: &Subject, setup: &Setup, settings: &Settings) -> Result<(), Fault> {
    let typed = setup.typed(settings);
    // all assemblies are compared
    let case = typed.first_assembly(subject).case(subject)?;
    let report = watched("verifying", 1, |_| subject.verify(&case));
    print(&format!("{report}\n"))?;
    if report.passed() {
        let mut all = typed.each_assembly(subject).into_iter();
        all.try_for_each(|(_, typed)| subject.closes(&typed.case(subject)?))
    } else {
        Err(Fault::failed("the verification did not pass"))
    }
}
