//! Sound declarations as text and as data.

use std::f64::consts::PI;
use std::fmt::{self, Display, Formatter, Write};

use crate::closing::{Linearised, closed};
use crate::names::Naming;
use crate::random::Random;
use crate::sound::{self, Style};
use crate::text::{Item, Statement, Text};
use crate::value::{Scope, Value, value};

/// The dimension of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// A length, or a coordinate of a point or vector.
    Length,
    /// An angle.
    Angle,
    /// A plain number.
    Scalar,
}

/// A number that a mechanism is given, or that it finds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its name: of a coordinate, that of the point with `.x`, `.y` or `.z`.
    pub name: String,
    /// Its dimension.
    pub dimension: Dimension,
}

/// Numbers at which a mechanism closes.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// The dimensions.
    pub parameters: Vec<f64>,
    /// The inputs.
    pub inputs: Vec<f64>,
    /// The unknowns.
    pub unknowns: Vec<f64>,
}

/// A mechanism that the macro must accept, small enough to be compiled and solved with many others: its declaration as
/// text, and its closure as data.
///
/// ```
/// use kin_declarations::Sample;
///
/// let sample = Sample::new(7);
/// println!("{sample}");
/// let pose = sample.pose(1).expect("this one closes");
/// assert_eq!(pose.unknowns.len(), sample.unknowns().len());
/// for left in sample.residuals(&pose.parameters, &pose.inputs, &pose.unknowns) {
///     assert!(left.abs() < 1e-12);
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Sample {
    text: Text,
}

impl Sample {
    /// The sample of a seed. Its structure is called `Mechanism` and the seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let style = Style {
            blocks: 3,
            order: 6,
            naming: Naming::Plain,
            tests: false,
        };
        let text = sound::declaration(&mut Random::new(seed), &format!("Mechanism{seed}"), style);
        Self { text }
    }

    /// The name of its structure.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.text.name
    }

    /// The dimensions, number by number, in the order of the declaration.
    #[must_use]
    pub fn parameters(&self) -> Vec<Quantity> {
        numbers(self.text.fields.iter())
    }

    /// The inputs.
    #[must_use]
    pub fn inputs(&self) -> Vec<Quantity> {
        numbers(self.quantities("input"))
    }

    /// The unknowns.
    #[must_use]
    pub fn unknowns(&self) -> Vec<Quantity> {
        numbers(self.quantities("unknown"))
    }

    /// The highest order: that of the snap, 4, if the declaration says nothing.
    ///
    /// # Panics
    /// If the text gives an order that is no number, which it does not.
    #[must_use]
    pub fn order(&self) -> usize {
        let said = self.text.formulas.iter().find_map(|statement| match statement {
            Statement::Wish(wish) => wish.strip_prefix("order = "),
            _ => None,
        });
        said.map_or(4, |order| order.parse().expect("it is a number"))
    }

    /// Whether unknowns are confined to ranges.
    #[must_use]
    pub fn has_ranges(&self) -> bool {
        self.quantities("unknown").any(|item| !item.range.is_empty())
    }

    fn quantities<'a>(&'a self, word: &'a str) -> impl Iterator<Item = &'a Item> {
        let own = self.text.formulas.iter().filter_map(move |statement| match statement {
            Statement::Quantities(own, items) if *own == word => Some(items),
            _ => None,
        });
        own.flatten()
    }

    /// The left side of each scalar equation less its right side, in the order of the declaration.
    ///
    /// # Panics
    /// If there are not as many numbers as quantities.
    #[must_use]
    pub fn residuals(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Vec<f64> {
        let mut scope = Scope::new();
        enter(&mut scope, self.text.fields.iter(), parameters);
        enter(&mut scope, self.quantities("input"), inputs);
        enter(&mut scope, self.quantities("unknown"), unknowns);
        let mut residuals = Vec::new();
        for statement in &self.text.formulas {
            match statement {
                Statement::Let(name, formula) => {
                    let value = value(formula, &scope);
                    scope.insert(name, value);
                }
                Statement::Equation(left, right) => residuals.extend(value(&left.minus(right), &scope).parts()),
                _ => {}
            }
        }
        residuals
    }

    /// Numbers that close, of ordinary sizes: lengths within a decade, angles within a turn. Whether unknowns are in
    /// their ranges is left open.
    ///
    /// There may be none for a seed, as they are sought by an iteration.
    #[must_use]
    pub fn pose(&self, seed: u64) -> Option<Pose> {
        let mut random = Random::new(seed);
        let mut drawn = |quantities: &[Quantity]| -> Vec<f64> {
            quantities.iter().map(|quantity| drawn(&mut random, quantity)).collect()
        };
        let (mut quantities, inputs) = (self.parameters(), drawn(&self.inputs()));
        let count = quantities.len();
        quantities.extend(self.unknowns());
        let is_angle = |place: usize| quantities[place].dimension == Dimension::Angle;
        let closed = closed(&drawn(&quantities), is_angle, |values| {
            linearised(values, is_angle, |values| {
                self.residuals(&values[..count], &inputs, &values[count..])
            })
        })?;
        let (parameters, unknowns) = closed.split_at(count);
        Some(Pose {
            parameters: parameters.to_vec(),
            unknowns: unknowns.to_vec(),
            inputs,
        })
    }
}

/// The declaration, as it stands between the braces of the macro.
impl Display for Sample {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.text.fmt(f)
    }
}

/// How many numbers a quantity of a dimension has.
fn parts(item: &Item) -> usize {
    match item.dimension {
        "Point" | "Vector" => 2,
        "Point3" | "Vector3" => 3,
        _ => 1,
    }
}

fn numbers<'a>(items: impl Iterator<Item = &'a Item>) -> Vec<Quantity> {
    let numbers = |item: &'a Item| {
        let dimension = match item.dimension {
            "Angle" | "Direction" => Dimension::Angle,
            "Scalar" => Dimension::Scalar,
            _ => Dimension::Length,
        };
        let count = parts(item);
        (0..count).map(move |part| Quantity {
            name: match count {
                1 => item.name.clone(),
                _ => format!("{}.{}", item.name, ["x", "y", "z"][part]),
            },
            dimension,
        })
    };
    items.flat_map(numbers).collect()
}

fn enter<'a>(scope: &mut Scope<'a>, items: impl Iterator<Item = &'a Item>, values: &[f64]) {
    let mut rest = values;
    for item in items {
        let (own, others) = rest.split_at(parts(item));
        scope.insert(&item.name, Value::of_parts(own));
        rest = others;
    }
    assert!(rest.is_empty(), "there are too many numbers");
}

/// A number of ordinary size.
fn drawn(random: &mut Random, quantity: &Quantity) -> f64 {
    let size = 10.0_f64.powf(random.fraction() - 0.5);
    match quantity.dimension {
        Dimension::Angle => PI * (2.0 * random.fraction() - 1.0),
        Dimension::Length if !quantity.name.contains('.') => size,
        _ if random.one_in(2) => -size,
        _ => size,
    }
}

/// Equations with derivatives by differences.
fn linearised(values: &[f64], is_angle: impl Fn(usize) -> bool, equations: impl Fn(&[f64]) -> Vec<f64>) -> Linearised {
    /// The part of its size by which a value is moved, and the roundings of a residual that are expected.
    const MOVE: f64 = 1e-7;
    const ROUNDINGS: f64 = 16.0;
    let left = equations(values);
    let mut rounding = vec![f64::MIN_POSITIVE; left.len()];
    let mut jacobian = vec![Vec::new(); left.len()];
    for (place, value) in values.iter().enumerate() {
        let size = if is_angle(place) { 1.0 } else { value.abs() };
        let mut moved = values.to_vec();
        moved[place] += MOVE * size;
        let by = moved[place] - value;
        for (row, (after, before)) in equations(&moved).iter().zip(&left).enumerate() {
            let slope = (after - before) / by;
            rounding[row] += ROUNDINGS * f64::EPSILON * (slope * size).abs();
            jacobian[row].push(slope);
        }
    }
    Linearised {
        left,
        rounding,
        jacobian,
    }
}

/// Rust code with the samples of these seeds: a module for each, and `SAMPLE`, a list of pairs of a function and the
/// seed. The function's type is `Find`, which returns what the macro `of!` makes of the mechanism, a `Found`.
#[must_use]
pub fn code(seeds: impl IntoIterator<Item = u64>) -> String {
    let (mut modules, mut entries) = (String::new(), String::new());
    for seed in seeds {
        let sample = Sample::new(seed);
        let name = sample.name();
        write!(
            modules,
            "mod mechanism_{seed} {{
                use kin_core::prelude::*;
                mechanism! {{ {sample} }}
                pub(super) fn found() -> super::Found {{ of!({name}) }}
            }}
            "
        )
        .expect("a string can be written");
        write!(entries, "(mechanism_{seed}::found, {seed}),").expect("a string can be written");
    }
    format!("{modules}\nconst SAMPLE: &[(Find, u64)] = &[{entries}];\n")
}

#[cfg(test)]
mod tests {
    use super::Sample;

    /// Nine of ten have a pose, and there the closure is as good as rounded.
    #[test]
    fn samples_have_poses() {
        const COUNT: u64 = 300;
        let mut closed = 0;
        for seed in 0..COUNT {
            let sample = Sample::new(seed);
            let Some(pose) = (0..4).find_map(|seed| sample.pose(seed)) else {
                continue;
            };
            closed += 1;
            assert_eq!(pose.parameters.len(), sample.parameters().len());
            for left in sample.residuals(&pose.parameters, &pose.inputs, &pose.unknowns) {
                assert!(left.abs() < 1e-9, "{seed}: {left:e}\n{sample}");
            }
        }
        assert!(closed * 10 >= COUNT * 9, "only {closed}");
    }

    /// The order of the declaration, and coordinates one by one.
    #[test]
    fn quantities_are_those_of_the_text() {
        for seed in 0..100 {
            let sample = Sample::new(seed);
            let text = sample.to_string();
            for quantities in [sample.parameters(), sample.inputs(), sample.unknowns()] {
                let places = quantities.iter().map(|quantity| {
                    let whole = quantity.name.split('.').next().unwrap_or_default();
                    text.find(&format!("{whole}: ")).expect("it is declared")
                });
                assert!(places.is_sorted(), "{text}");
            }
        }
    }
}
