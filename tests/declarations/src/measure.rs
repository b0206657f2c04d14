//! Measures of formulas, and random formulas of a given measure.

use crate::formula::Formula;
use crate::numbers;
use crate::random::Random;

/// The shape of a formula's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    Scalar,
    Plane,
    Space,
    Rotation,
}

/// The shape of a value and its power of length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Measure {
    pub(crate) shape: Shape,
    pub(crate) exponent: i32,
}

impl Measure {
    pub(crate) const NUMBER: Self = Self::new(Shape::Scalar, 0);
    pub(crate) const LENGTH: Self = Self::new(Shape::Scalar, 1);
    pub(crate) const POINT: Self = Self::new(Shape::Plane, 1);
    pub(crate) const PLACE: Self = Self::new(Shape::Space, 1);

    pub(crate) const fn new(shape: Shape, exponent: i32) -> Self {
        Self { shape, exponent }
    }

    /// The measure of a quantity of a dimension.
    pub(crate) fn of(dimension: &str) -> Self {
        match dimension {
            "Length" => Self::LENGTH,
            "Point" | "Vector" => Self::POINT,
            "Point3" | "Vector3" => Self::PLACE,
            _ => Self::NUMBER,
        }
    }
}

/// A name that can be used in formulas.
#[derive(Clone, Debug)]
pub(crate) struct Known {
    pub(crate) name: String,
    pub(crate) measure: Measure,
}

/// How far formulas go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Temper {
    /// Finite wherever they are evaluated.
    Tame,
    /// Whatever the language allows.
    Wild,
}

/// Writes random formulas.
pub(crate) struct Writer<'a> {
    pub(crate) random: &'a mut Random,
    pub(crate) known: &'a [Known],
    pub(crate) temper: Temper,
}

impl Writer<'_> {
    /// A formula whose operations are nested at most `depth` deep.
    pub(crate) fn formula(&mut self, measure: Measure, depth: usize) -> Formula {
        if depth == 0 || self.random.one_in(6) {
            return self.leaf(measure);
        }
        let formula = match measure.shape {
            Shape::Scalar => self.scalar(measure.exponent, depth - 1),
            Shape::Plane => self.plane(measure.exponent, depth - 1),
            Shape::Space => self.space(measure.exponent, depth - 1),
            Shape::Rotation => self.rotation(depth - 1),
        };
        if self.random.one_in(15) {
            formula.in_parentheses()
        } else {
            formula
        }
    }

    /// A name if there is one, else the shortest formula of this measure.
    fn leaf(&mut self, measure: Measure) -> Formula {
        let fitting: Vec<&Known> = self.known.iter().filter(|known| known.measure == measure).collect();
        let is_number = measure == Measure::NUMBER;
        let is_written_out = is_number && self.random.one_in(4);
        if !fitting.is_empty() && !is_written_out {
            return Formula::operand(self.random.pick(&fitting).name.clone());
        }
        let Measure { shape, exponent } = measure;
        let part = Measure::new(Shape::Scalar, exponent);
        match shape {
            Shape::Scalar if exponent == 0 => self.number(),
            Shape::Scalar if exponent > 0 => {
                let length = self.length();
                (1..exponent).fold(length, |product, _| {
                    let further = self.length();
                    product.times(&further)
                })
            }
            Shape::Scalar => {
                let divisor = self.leaf(Measure::new(Shape::Scalar, -exponent));
                Formula::operand("1").over(&divisor)
            }
            Shape::Plane => self.call("vec2", &[part; 2], 0),
            Shape::Space => self.call("vec3", &[part; 3], 0),
            Shape::Rotation => self.call("rot_x", &[Measure::NUMBER], 0),
        }
    }

    /// A name of a length; where there is none, a number stands in its place, and the declaration is ill-formed.
    fn length(&mut self) -> Formula {
        let lengths: Vec<&Known> = self
            .known
            .iter()
            .filter(|known| known.measure == Measure::LENGTH)
            .collect();
        if lengths.is_empty() {
            return self.number();
        }
        Formula::operand(self.random.pick(&lengths).name.clone())
    }

    fn number(&mut self) -> Formula {
        if self.temper == Temper::Wild && self.random.one_in(12) {
            return Formula::operand(numbers::extreme(self.random));
        }
        Formula::operand(match self.random.below(4) {
            0 => "PI".to_owned(),
            _ => numbers::ordinary(self.random),
        })
    }

    fn call(&mut self, function: &'static str, arguments: &[Measure], depth: usize) -> Formula {
        let arguments: Vec<Formula> = arguments
            .iter()
            .map(|&argument| self.formula(argument, depth))
            .collect();
        if self.random.one_in(4) {
            Formula::method(function, &arguments)
        } else {
            Formula::call(function, &arguments)
        }
    }

    fn binary(
        &mut self,
        operation: fn(&Formula, &Formula) -> Formula,
        left: Measure,
        right: Measure,
        depth: usize,
    ) -> Formula {
        let left = self.formula(left, depth);
        let right = self.formula(right, depth);
        self.unless_constant(operation(&left, &right), left)
    }

    /// The formula, or a part of it if it is made of numbers alone: two numbers together may be more than a turn, and
    /// that is no angle in radians.
    fn unless_constant(&self, formula: Formula, part: Formula) -> Formula {
        if self.temper == Temper::Tame && formula.is_constant() {
            part
        } else {
            formula
        }
    }

    /// The formulas of every shape except a rotation: sums, signs, and products with a scalar.
    fn linear(&mut self, measure: Measure, depth: usize) -> Formula {
        let Measure { shape, exponent } = measure;
        match self.random.below(6) {
            0 | 1 => self.binary(Formula::plus, measure, measure, depth),
            2 => self.binary(Formula::minus, measure, measure, depth),
            3 => self.formula(measure, depth).negated(),
            4 => {
                let part = *self.random.pick(&[0, 1, exponent]);
                let (scalar, rest) = (Measure::new(Shape::Scalar, part), Measure::new(shape, exponent - part));
                if self.random.one_in(2) {
                    self.binary(Formula::times, scalar, rest, depth)
                } else {
                    self.binary(Formula::times, rest, scalar, depth)
                }
            }
            _ => self.quotient(measure, depth),
        }
    }

    fn quotient(&mut self, measure: Measure, depth: usize) -> Formula {
        let Measure { shape, exponent } = measure;
        if self.temper == Temper::Tame {
            let dividend = self.formula(measure, depth);
            let quotient = dividend.over(&Formula::operand(numbers::ordinary(self.random)));
            return self.unless_constant(quotient, dividend);
        }
        let by = self.random.below(2);
        let by = i32::from(by == 1);
        self.binary(
            Formula::over,
            Measure::new(shape, exponent + by),
            Measure::new(Shape::Scalar, by),
            depth,
        )
    }

    fn scalar(&mut self, exponent: i32, depth: usize) -> Formula {
        let own = Measure::new(Shape::Scalar, exponent);
        match self.random.below(9) {
            0..=3 => self.linear(own, depth),
            4 => {
                let axis = *self.random.pick(&["x", "y"]);
                self.formula(Measure::new(Shape::Plane, exponent), depth).part(axis)
            }
            5 => {
                let axis = *self.random.pick(&["x", "y", "z"]);
                self.formula(Measure::new(Shape::Space, exponent), depth).part(axis)
            }
            6 => {
                let shape = *self.random.pick(&[Shape::Plane, Shape::Space]);
                let function = match shape {
                    Shape::Plane => *self.random.pick(&["dot", "cross", "norm"]),
                    _ => *self.random.pick(&["dot", "norm"]),
                };
                if function == "norm" {
                    return self.call(function, &[Measure::new(shape, exponent)], depth);
                }
                let first = *self.random.pick(&[0, 1, exponent]);
                let arguments = [first, exponent - first].map(|part| Measure::new(shape, part));
                self.call(function, &arguments, depth)
            }
            7 => self.power(exponent, depth),
            _ if exponent == 0 => self.elementary(depth),
            _ => self.root(exponent, depth),
        }
    }

    fn power(&mut self, exponent: i32, depth: usize) -> Formula {
        let powers: &[i32] = match self.temper {
            Temper::Tame => &[2, 3],
            Temper::Wild => &[0, 1, 2, 3, 4, 5, 7, -1, -2, -3, 12, 64, -64],
        };
        let mut power = *self.random.pick(powers);
        if power == 0 && exponent != 0 || power != 0 && exponent % power != 0 {
            power = 1;
        }
        let base = exponent.checked_div(power).unwrap_or(1);
        let base = self.formula(Measure::new(Shape::Scalar, base), depth);
        let arguments = [base.clone(), Formula::operand(power.to_string())];
        let is_method = self.random.one_in(2);
        if self.temper == Temper::Tame && base.is_constant() {
            // as for two numbers together
            return base;
        }
        if is_method {
            Formula::method("powi", &arguments)
        } else {
            Formula::call("powi", &arguments)
        }
    }

    fn root(&mut self, exponent: i32, depth: usize) -> Formula {
        let square = Measure::new(Shape::Scalar, 2 * exponent);
        if self.temper == Temper::Wild {
            return self.call("sqrt", &[square], depth);
        }
        // 1 + x² of the right dimension, which is positive everywhere
        let own = Measure::new(Shape::Scalar, exponent);
        let (first, second) = (self.leaf(own), self.leaf(own));
        Formula::call("sqrt", &[first.times(&first).plus(&second.times(&second))])
    }

    fn elementary(&mut self, depth: usize) -> Formula {
        let number = Measure::NUMBER;
        let wild = ["tan", "asin", "acos", "exp", "ln", "sqrt", "atan2"];
        let tame = ["sin", "cos", "atan", "bounded"];
        let function = if self.temper == Temper::Wild && self.random.one_in(2) {
            *self.random.pick(&wild)
        } else {
            *self.random.pick(&tame)
        };
        match function {
            "atan2" => {
                let exponent = i32::from(self.random.one_in(2));
                self.call("atan2", &[Measure::new(Shape::Scalar, exponent); 2], depth)
            }
            // the others where they are defined and finite
            "bounded" => {
                let sine = self.call("sin", &[number], depth);
                let half = sine.over(&Formula::operand("2"));
                match self.random.below(5) {
                    0 => Formula::call("exp", &[sine]),
                    1 => Formula::call("asin", &[half]),
                    2 => Formula::call("acos", &[half]),
                    3 => Formula::call("tan", &[half]),
                    _ => Formula::call("ln", &[half.plus(&Formula::operand("2"))]),
                }
            }
            function => self.call(function, &[number], depth),
        }
    }

    fn plane(&mut self, exponent: i32, depth: usize) -> Formula {
        let (number, scalar) = (Measure::NUMBER, Measure::new(Shape::Scalar, exponent));
        let own = Measure::new(Shape::Plane, exponent);
        match self.random.below(7) {
            0 | 1 => self.linear(own, depth),
            2 => self.call("polar", &[scalar, number], depth),
            3 => self.call("vec2", &[scalar; 2], depth),
            4 if exponent == 0 => self.call("cis", &[number], depth),
            4 | 5 => self.binary(Formula::times, own, Measure::new(Shape::Plane, 0), depth),
            // a scalar lies along the x axis
            _ => self.binary(Formula::plus, own, scalar, depth),
        }
    }

    fn space(&mut self, exponent: i32, depth: usize) -> Formula {
        let own = Measure::new(Shape::Space, exponent);
        match self.random.below(7) {
            0 | 1 => self.linear(own, depth),
            2 => self.call("vec3", &[Measure::new(Shape::Scalar, exponent); 3], depth),
            3 => self.call("cross", &[own, Measure::new(Shape::Space, 0)], depth),
            _ => self.binary(Formula::times, Measure::new(Shape::Rotation, 0), own, depth),
        }
    }

    fn rotation(&mut self, depth: usize) -> Formula {
        let own = Measure::new(Shape::Rotation, 0);
        match self.random.below(5) {
            0 => self.binary(Formula::times, own, own, depth),
            1 => {
                let axis = match self.temper {
                    // known not to vanish
                    Temper::Tame => Formula::of_numbers("vec3", &["1", "2", "2"]),
                    Temper::Wild => {
                        let exponent = i32::from(self.random.one_in(2));
                        self.formula(Measure::new(Shape::Space, exponent), depth)
                    }
                };
                let angle = self.formula(Measure::NUMBER, depth);
                Formula::call("rot", &[axis, angle])
            }
            _ => {
                let function = *self.random.pick(&["rot_x", "rot_y", "rot_z"]);
                self.call(function, &[Measure::NUMBER], depth)
            }
        }
    }
}
