//! A declaration in the making.

use std::fmt::{self, Display, Formatter};

use crate::measure::{Known, Measure};
use crate::random::Random;

/// The parts of a declaration.
#[derive(Debug, Default)]
pub(crate) struct Text {
    /// The words before the structure's name, with its attributes.
    pub(crate) head: String,
    pub(crate) name: String,
    /// `a1: Length`, with attributes.
    pub(crate) fields: Vec<String>,
    /// `input` and `unknown`, which may stand anywhere.
    pub(crate) quantities: Vec<String>,
    /// `order` and `with`, which may stand anywhere.
    pub(crate) wishes: Vec<String>,
    /// Abbreviations, equations and outputs, an abbreviation before its uses.
    pub(crate) formulas: Vec<String>,
    /// Every name that formulas may use.
    pub(crate) known: Vec<Known>,
}

impl Text {
    pub(crate) fn knows(&mut self, name: &str, dimension: &str) {
        self.known.push(Known {
            name: name.to_owned(),
            measure: Measure::of(dimension),
        });
    }

    /// Puts what may stand anywhere between the formulas.
    pub(crate) fn scatter(&mut self, random: &mut Random) {
        for statement in self.quantities.drain(..).chain(self.wishes.drain(..)) {
            let place = random.below(self.formulas.len() + 1);
            self.formulas.insert(place, statement);
        }
    }
}

impl Display for Text {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}struct {} {{", self.head, self.name)?;
        for field in &self.fields {
            writeln!(f, "    {field},")?;
        }
        writeln!(f, "}}")?;
        for statement in self.quantities.iter().chain(&self.wishes).chain(&self.formulas) {
            writeln!(f, "{statement};")?;
        }
        Ok(())
    }
}
