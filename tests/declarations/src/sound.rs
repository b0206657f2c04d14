//! Declarations without mistakes: mechanisms that are built block by block, each block driven by what is known before
//! it.

mod blocks;
mod space;
mod vectors;

use crate::formula::Formula;
use crate::measure::{Measure, Temper, Writer};
use crate::names::{Names, Naming};
use crate::numbers;
use crate::random::Random;
use crate::text::{Item, Statement, Text};

/// The choices from which sound declarations are drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    /// How many blocks there are at most.
    pub(crate) blocks: usize,
    /// The highest order.
    pub(crate) order: usize,
    pub(crate) naming: Naming,
    /// Whether a declaration may ask for a test of its own.
    pub(crate) tests: bool,
}

/// A mechanism that grows.
struct Mechanism<'a> {
    random: &'a mut Random,
    names: Names,
    text: Text,
    /// Angles that are known and change.
    angles: Vec<Formula>,
    /// Points of the plane that are known and move.
    joints: Vec<Formula>,
    /// Points of space that are known and move.
    places: Vec<Formula>,
    inputs: usize,
    dyads: usize,
}

/// A mechanism that the macro must accept.
pub(crate) fn declaration(random: &mut Random, name: &str, style: Style) -> Text {
    let blocks = random.size(style.blocks);
    let mut mechanism = Mechanism {
        names: Names::new(style.naming),
        text: Text {
            head: head(random),
            name: name.to_owned(),
            ..Text::default()
        },
        random,
        angles: Vec::new(),
        joints: Vec::new(),
        places: Vec::new(),
        inputs: 0,
        dyads: 0,
    };
    for _ in 0..blocks {
        mechanism.block();
    }
    if mechanism.text.fields.is_empty() {
        let formula = mechanism.length().times(&mechanism.angle());
        let name = mechanism.names.name(mechanism.random, "o");
        mechanism
            .text
            .formulas
            .push(Statement::Output(Item::new("", name, "Length"), formula));
    }
    mechanism.outputs();
    mechanism.wishes(style);
    let Mechanism { random, mut text, .. } = mechanism;
    text.scatter(random);
    text
}

fn head(random: &mut Random) -> String {
    let attributes = [
        "",
        "",
        "",
        "/// A mechanism.\n",
        "#[doc = \"A mechanism.\"]\n",
        "#[allow(dead_code)]\n",
        "/// Its first line.\n///\n/// ```text\n/// { ( [ \" \\ {0} %\n/// ```\n",
    ];
    let visibilities = ["", "pub ", "pub(crate) "];
    format!("{}{}", random.pick(&attributes), random.pick(&visibilities))
}

impl Mechanism<'_> {
    /// A new dimension.
    fn parameter(&mut self, letters: &str, dimension: &'static str) -> Formula {
        let name = self.names.name(self.random, letters);
        let marks = [
            "",
            "",
            "",
            "",
            "pub ",
            "/// A dimension.\n    ",
            "#[allow(dead_code)] pub(crate) ",
        ];
        let mark = self.random.pick(&marks);
        self.text.field(Item::new(mark, name.as_str(), dimension));
        Formula::operand(name)
    }

    fn input(&mut self, dimension: &'static str) -> Formula {
        let name = self.names.name(self.random, "t");
        self.inputs += 1;
        let item = Item::new(self.mark(), name.as_str(), dimension);
        self.quantity("input", item);
        self.text.knows(&name, dimension);
        let formula = Formula::operand(name);
        if dimension == "Angle" {
            self.angles.push(formula.clone());
        }
        formula
    }

    /// A new unknown, which may not be used before its block is there. `range` is what stands after its dimension.
    fn unknown(&mut self, letters: &str, dimension: &'static str, range: &str) -> Formula {
        let name = self.names.name(self.random, letters);
        let dimension = if dimension == "Angle" && range.is_empty() && self.random.one_in(5) {
            "Direction"
        } else {
            dimension
        };
        let item = Item {
            range: range.replace('_', &name),
            ..Item::new(self.mark(), name.as_str(), dimension)
        };
        self.quantity("unknown", item);
        Formula::operand(name)
    }

    fn mark(&mut self) -> &'static str {
        if self.random.one_in(8) { "/// A quantity.\n" } else { "" }
    }

    /// A statement of its own, or an item more of the one before.
    fn quantity(&mut self, word: &'static str, item: Item) {
        match self.text.quantities.last_mut() {
            Some(Statement::Quantities(last, items)) if *last == word && self.random.one_in(2) => items.push(item),
            _ => self.text.quantities.push(Statement::Quantities(word, vec![item])),
        }
    }

    /// From now on formulas may use an unknown.
    fn solved(&mut self, unknown: &Formula, dimension: &str) {
        self.text.knows(&unknown.to_string(), dimension);
        if dimension == "Angle" {
            self.angles.push(unknown.clone());
        }
    }

    /// A fixed length.
    fn length(&mut self) -> Formula {
        let length = self.parameter("a", "Length");
        match self.random.below(12) {
            0 => length.over(&Formula::operand(numbers::ordinary(self.random))),
            1 => Formula::operand(numbers::ordinary(self.random)).times(&length),
            2 => {
                let other = self.parameter("a", "Length");
                Formula::call("sqrt", &[length.times(&length).plus(&other.times(&other))])
            }
            3 => {
                let other = self.parameter("a", "Length");
                length.plus(&other)
            }
            _ => length,
        }
    }

    /// An angle that is known and changes.
    fn angle(&mut self) -> Formula {
        if self.inputs == 0 || self.inputs < 3 && self.random.one_in(8) {
            return self.input("Angle");
        }
        let angle = self.random.pick(&self.angles).clone();
        match self.random.below(12) {
            0 => angle.plus(&self.parameter("d", "Angle")),
            1 => angle.plus(&Formula::operand("PI").over(&Formula::operand("3"))),
            2 => angle.negated(),
            3 => {
                let other = self.random.pick(&self.angles).clone();
                if other == angle { angle } else { angle.minus(&other) }
            }
            4 => Formula::operand("2").times(&angle),
            5 => self.abbreviated(angle.plus(&Formula::operand("0.5"))),
            _ => angle,
        }
    }

    /// The formula, or a name for it.
    fn abbreviated(&mut self, formula: Formula) -> Formula {
        if !self.random.one_in(4) {
            return formula;
        }
        self.named(&formula)
    }

    fn named(&mut self, formula: &Formula) -> Formula {
        let name = self.names.name(self.random, "l");
        self.text.formulas.push(Statement::Let(name.clone(), formula.clone()));
        Formula::operand(name)
    }

    /// An equation, either way round.
    fn equate(&mut self, left: &Formula, right: &Formula) {
        let (left, right) = match self.random.below(4) {
            0 => (right.clone(), left.clone()),
            1 => (left.minus(right), Formula::operand("0")),
            _ => (left.clone(), right.clone()),
        };
        self.text.formulas.push(Statement::Equation(left, right));
    }

    /// A formula of what is known by now.
    fn tame(&mut self, measure: Measure, depth: usize) -> Formula {
        Writer {
            random: self.random,
            known: &self.text.known,
            temper: Temper::Tame,
        }
        .formula(measure, depth)
    }

    fn outputs(&mut self) {
        let dimensions = ["Length", "Angle", "Scalar", "Point", "Vector", "Point3", "Vector3"];
        // without a length nothing but numbers could be written
        if !self.text.known.iter().any(|known| known.measure == Measure::LENGTH) {
            return;
        }
        for _ in 0..self.random.below(4) {
            let dimension = *self.random.pick(&dimensions);
            let depth = self.random.between(1, 3);
            let formula = self.tame(Measure::of(dimension), depth);
            let name = self.names.name(self.random, "o");
            let item = Item::new(self.mark(), name, dimension);
            self.text.formulas.push(Statement::Output(item, formula));
        }
    }

    fn wishes(&mut self, style: Style) {
        // snap if nothing is said
        if style.order < 4 || self.random.one_in(2) {
            let order = self.random.between(1, style.order);
            self.text.wishes.push(format!("order = {order}"));
        }
        let mut requests = Vec::new();
        if self.random.one_in(6) {
            requests.push("sensitivities");
        }
        if self.dyads > 0 && self.random.one_in(4) {
            requests.push("transmission_angles");
        }
        if style.tests && self.random.one_in(8) {
            requests.push("test");
        }
        if !requests.is_empty() {
            self.text.wishes.push(format!("with {}", requests.join(", ")));
        }
    }
}
