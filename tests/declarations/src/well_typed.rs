//! Declarations that keep to the grammar and to the dimensions, and leave it open whether they can be solved.

use crate::Scale;
use crate::formula::Formula;
use crate::measure::{Known, Measure, Shape, Temper, Writer};
use crate::names::{Names, Naming};
use crate::numbers;
use crate::random::Random;
use crate::text::{Item, Statement, Text};

const DIMENSIONS: [&str; 7] = ["Length", "Angle", "Scalar", "Point", "Vector", "Point3", "Vector3"];

/// As many scalar equations as unknowns, as a rule.
pub(crate) fn declaration(random: &mut Random, scale: Scale) -> String {
    let (deepest, highest) = match scale {
        Scale::Small => (2, 2),
        Scale::Full => (4, 12),
    };
    let mut names = Names::new(if random.one_in(2) {
        Naming::Plain
    } else {
        Naming::Unusual
    });
    let mut text = Text {
        name: "Formulas".to_owned(),
        ..Text::default()
    };
    quantities(random, &mut names, &mut text);
    let (depth, temper) = (
        random.between(1, deepest),
        if random.one_in(3) { Temper::Tame } else { Temper::Wild },
    );
    let all = unknowns(random, &mut names, &mut text);
    let mut unknowns = all.iter().cycle();
    let mut missing = all.len();
    if random.one_in(10) {
        missing = random.between(0, missing + 1);
    }
    while missing > 0 {
        let shape = *random.pick(&[Shape::Scalar, Shape::Scalar, Shape::Plane, Shape::Space]);
        let parts = match shape {
            Shape::Plane => 2,
            Shape::Space => 3,
            Shape::Scalar | Shape::Rotation => 1,
        };
        if parts > missing {
            continue;
        }
        missing -= parts;
        if random.one_in(4) {
            abbreviation(random, &mut names, &mut text, depth, temper);
        }
        let exponent = i32::from(random.one_in(2)) + i32::from(random.one_in(8));
        let measure = Measure::new(shape, exponent);
        let mut writer = writer(random, &text, temper);
        let (left, right) = (writer.formula(measure, depth), writer.formula(measure, depth));
        let sought = unknowns.by_ref().take(parts).collect::<Vec<_>>();
        // as a rule an unknown of its own for each part
        let left = if random.one_in(8) {
            left
        } else {
            let sum = left.plus(&carrier(random, &text.known[0].name, &sought, measure));
            if random.one_in(4) { sum.in_parentheses() } else { sum }
        };
        text.formulas.push(Statement::Equation(left, right));
    }
    uses(random, &mut names, &mut text);
    if highest < 4 || random.one_in(3) {
        text.wishes.push(format!("order = {}", random.between(1, highest)));
    }
    if random.one_in(5) {
        let requests = ["sensitivities", "test", "transmission_angles", "test, sensitivities"];
        text.wishes.push(format!("with {}", random.pick(&requests)));
    }
    text.scatter(random);
    text.to_string()
}

fn writer<'a>(random: &'a mut Random, text: &'a Text, temper: Temper) -> Writer<'a> {
    Writer {
        random,
        known: &text.known,
        temper,
    }
}

fn quantities(random: &mut Random, names: &mut Names, text: &mut Text) {
    // without a length some dimensions could not be written
    let name = names.name(random, "a");
    text.field(Item::new("", name, "Length"));
    for _ in 0..random.below(5) {
        let (name, dimension) = (names.name(random, "a"), *random.pick(&DIMENSIONS));
        text.field(Item::new("", name, dimension));
    }
    for _ in 0..random.between(1, 3) {
        let (name, dimension) = (names.name(random, "t"), *random.pick(&DIMENSIONS[..3]));
        text.knows(&name, dimension);
        let item = Item::new("", name, dimension);
        text.quantities.push(Statement::Quantities("input", vec![item]));
    }
}

fn unknowns(random: &mut Random, names: &mut Names, text: &mut Text) -> Vec<Known> {
    let count = random.between(1, 5);
    let mut unknowns = Vec::new();
    for _ in 0..count {
        let dimension = *random.pick(&["Length", "Angle", "Scalar", "Direction"]);
        let name = names.name(random, "u");
        let range = if random.one_in(6) {
            range(random, &name)
        } else {
            String::new()
        };
        let item = Item {
            range,
            ..Item::new("", name.as_str(), dimension)
        };
        text.quantities.push(Statement::Quantities("unknown", vec![item]));
        for _ in 0..3 {
            // more likely than others in formulas
            text.knows(&name, dimension);
        }
        unknowns.extend(text.known.last().cloned());
    }
    unknowns
}

/// A value of the given measure that contains these unknowns, one in each of its parts.
fn carrier(random: &mut Random, length: &str, unknowns: &[&Known], measure: Measure) -> Formula {
    let length = Formula::operand(length);
    let parts: Vec<Formula> = unknowns
        .iter()
        .map(|unknown| {
            let name = Formula::operand(unknown.name.as_str());
            let mut missing = measure.exponent - unknown.measure.exponent;
            let mut part = match unknown.measure {
                Measure::NUMBER if random.one_in(2) => {
                    let function = *random.pick(&["sin", "cos", "tan", "exp", "atan"]);
                    Formula::call(function, &[name])
                }
                _ => name,
            };
            while missing > 0 {
                part = length.times(&part);
                missing -= 1;
            }
            if missing < 0 { part.over(&length) } else { part }
        })
        .collect();
    match measure.shape {
        Shape::Plane => Formula::call("vec2", &parts),
        Shape::Space => Formula::call("vec3", &parts),
        Shape::Scalar | Shape::Rotation => parts[0].clone(),
    }
}

fn range(random: &mut Random, name: &str) -> String {
    if !random.one_in(3) {
        let range = *random.pick(&[
            " where _ > 0",
            " where _ <= -0.5",
            " in -PI..=PI",
            " in 0..PI / 2",
            " in -sqrt(2)..3",
        ]);
        return range.replace('_', name);
    }
    let mut end = || {
        let sign = if random.one_in(3) { "-" } else { "" };
        format!("{sign}{}", numbers::extreme(random))
    };
    let (low, high) = (end(), end());
    match random.below(4) {
        0 => format!(" in {low}..{high}"),
        1 => format!(" in {low}..={high}"),
        2 => format!(" where {name} > {low}"),
        _ => format!(" where {name} <= {high}"),
    }
}

fn abbreviation(random: &mut Random, names: &mut Names, text: &mut Text, depth: usize, temper: Temper) {
    let shape = *random.pick(&[Shape::Scalar, Shape::Plane, Shape::Space, Shape::Rotation]);
    let exponent = if shape == Shape::Rotation {
        0
    } else {
        i32::from(random.one_in(2))
    };
    let measure = Measure::new(shape, exponent);
    let value = writer(random, text, temper).formula(measure, depth);
    let name = names.name(random, "l");
    text.formulas.push(Statement::Let(name.clone(), value));
    text.known.push(Known { name, measure });
}

/// An output that uses everything, so that nothing is declared in vain.
fn uses(random: &mut Random, names: &mut Names, text: &mut Text) {
    let length = Formula::operand(text.known[0].name.as_str());
    let terms = text.known.iter().map(|known| {
        let name = Formula::operand(known.name.as_str());
        match (known.measure.shape, known.measure.exponent) {
            (Shape::Scalar, 1) => name,
            (Shape::Scalar, _) => length.times(&name),
            (Shape::Plane, 1) => name.part("x"),
            (Shape::Plane, _) => length.times(&name.part("y")),
            (Shape::Space, 1) => name.part("z"),
            (Shape::Space, _) => Formula::call("norm", &[name]).times(&length),
            (Shape::Rotation, _) => {
                let [zero, other] = ["0"; 2].map(Formula::operand);
                name.times(&Formula::call("vec3", &[length.clone(), zero, other]))
                    .part("x")
            }
        }
    });
    let sum = terms.reduce(|sum, term| sum.plus(&term)).expect("there is a length");
    let item = Item::new("", names.name(random, "o"), "Length");
    text.formulas.push(Statement::Output(item, sum));
}
