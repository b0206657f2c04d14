//! A declaration in the making.

use std::fmt::{self, Display, Formatter};

use crate::formula::Formula;
use crate::measure::{Known, Measure};
use crate::random::Random;

/// A quantity that is declared.
#[derive(Clone, Debug)]
pub(crate) struct Item {
    /// Attributes before its name.
    pub(crate) mark: &'static str,
    pub(crate) name: String,
    pub(crate) dimension: &'static str,
    /// What stands after its dimension.
    pub(crate) range: String,
}

impl Item {
    pub(crate) fn new(mark: &'static str, name: impl Into<String>, dimension: &'static str) -> Self {
        Self {
            mark,
            name: name.into(),
            dimension,
            range: String::new(),
        }
    }
}

impl Display for Item {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self {
            mark,
            name,
            dimension,
            range,
        } = self;
        write!(f, "{mark}{name}: {dimension}{range}")
    }
}

#[derive(Clone, Debug)]
pub(crate) enum Statement {
    /// Inputs or unknowns, by the word before them.
    Quantities(&'static str, Vec<Item>),
    Let(String, Formula),
    Equation(Formula, Formula),
    Output(Item, Formula),
    /// `order` or `with`.
    Wish(String),
}

impl Display for Statement {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quantities(word, items) => {
                let items: Vec<String> = items.iter().map(Item::to_string).collect();
                write!(f, "{word} {}", items.join(", "))
            }
            Self::Let(name, formula) => write!(f, "let {name} = {formula}"),
            Self::Equation(left, right) => write!(f, "{left} == {right}"),
            Self::Output(
                Item {
                    mark, name, dimension, ..
                },
                formula,
            ) => {
                write!(f, "{mark}output {name}: {dimension} = {formula}")
            }
            Self::Wish(text) => f.write_str(text),
        }
    }
}

/// The parts of a declaration.
#[derive(Clone, Debug, Default)]
pub(crate) struct Text {
    /// The words before the structure's name, with its attributes.
    pub(crate) head: String,
    pub(crate) name: String,
    /// The dimensions.
    pub(crate) fields: Vec<Item>,
    /// `input` and `unknown`, which may stand anywhere.
    pub(crate) quantities: Vec<Statement>,
    /// `order` and `with`, which may stand anywhere.
    pub(crate) wishes: Vec<String>,
    /// Abbreviations, equations and outputs, an abbreviation before its uses.
    pub(crate) formulas: Vec<Statement>,
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

    /// Adds a dimension, which formulas may use.
    pub(crate) fn field(&mut self, item: Item) {
        self.knows(&item.name, item.dimension);
        self.fields.push(item);
    }

    /// Puts what may stand anywhere between the formulas.
    pub(crate) fn scatter(&mut self, random: &mut Random) {
        let wishes = self.wishes.drain(..).map(Statement::Wish);
        for statement in self.quantities.drain(..).chain(wishes) {
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
        self.formulas
            .iter()
            .try_for_each(|statement| writeln!(f, "{statement};"))
    }
}
