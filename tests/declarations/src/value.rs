//! Values of formulas: the language once more, from its grammar, and independent of the compiler.

use std::collections::BTreeMap;

use crate::formula::{Formula, Operator};

/// The value of a formula.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    Scalar(f64),
    Plane([f64; 2]),
    Space([f64; 3]),
    /// A rotation of space, row by row.
    Rotation([[f64; 3]; 3]),
}

use Value::{Plane, Rotation, Scalar, Space};

/// The values of names.
pub(crate) type Scope<'a> = BTreeMap<&'a str, Value>;

/// The value of a sound formula.
///
/// # Panics
/// If a name is unknown, or a function is not made for its arguments.
pub(crate) fn value(formula: &Formula, scope: &Scope<'_>) -> Value {
    let values = |formulas: &[Formula]| formulas.iter().map(|formula| value(formula, scope)).collect::<Vec<_>>();
    match formula {
        Formula::Operand(text) => operand(text, scope),
        Formula::Call(function, arguments) | Formula::Method(function, arguments) => call(function, &values(arguments)),
        Formula::Binary(operator, sides) => {
            let [left, right] = [&sides[0], &sides[1]].map(|side| value(side, scope));
            match operator {
                Operator::Plus => sum(left, right),
                Operator::Minus => sum(left, product(Scalar(-1.0), right)),
                Operator::Times => product(left, right),
                Operator::Over => product(Scalar(1.0 / scalar(&right)), left),
            }
        }
        Formula::Negated(inner) => product(Scalar(-1.0), value(inner, scope)),
        Formula::Part(whole, axis) => {
            let parts = value(whole, scope).parts();
            let place = ["x", "y", "z"].iter().position(|name| name == axis);
            Scalar(parts[place.expect("it is an axis")])
        }
        Formula::Parentheses(inner) => value(inner, scope),
    }
}

impl Value {
    /// The value of a quantity that has these parts.
    pub(crate) fn of_parts(parts: &[f64]) -> Self {
        match *parts {
            [value] => Scalar(value),
            [x, y] => Plane([x, y]),
            [x, y, z] => Space([x, y, z]),
            _ => unreachable!("a quantity has up to three parts"),
        }
    }

    /// Its coordinates, or the scalar itself.
    pub(crate) fn parts(self) -> Vec<f64> {
        match self {
            Scalar(value) => vec![value],
            Plane(parts) => parts.to_vec(),
            Space(parts) => parts.to_vec(),
            Rotation(rows) => rows.concat(),
        }
    }
}

fn operand(text: &str, scope: &Scope<'_>) -> Value {
    if let Some(value) = scope.get(text) {
        return value.clone();
    }
    if text == "PI" {
        return Scalar(std::f64::consts::PI);
    }
    let digits = text.trim_end_matches("f64").replace('_', "");
    Scalar(digits.parse().unwrap_or_else(|_| panic!("{text} has no value")))
}

fn scalar(value: &Value) -> f64 {
    match value {
        Scalar(value) => *value,
        _ => panic!("{value:?} is no scalar"),
    }
}

/// Each coordinate of one with that of the other.
fn paired<const N: usize>(one: [f64; N], other: [f64; N], function: fn(f64, f64) -> f64) -> [f64; N] {
    std::array::from_fn(|place| function(one[place], other[place]))
}

fn sum(left: Value, right: Value) -> Value {
    match (left, right) {
        (Scalar(a), Scalar(b)) => Scalar(a + b),
        // a scalar lies along the x axis
        (Scalar(a), Plane([x, y])) | (Plane([x, y]), Scalar(a)) => Plane([a + x, y]),
        (Plane(a), Plane(b)) => Plane(paired(a, b, |a, b| a + b)),
        (Space(a), Space(b)) => Space(paired(a, b, |a, b| a + b)),
        // the 0 on the right of an equation
        (Space(a), Scalar(0.0)) => Space(a),
        (left, right) => panic!("{left:?} + {right:?}"),
    }
}

fn product(left: Value, right: Value) -> Value {
    match (left, right) {
        (Scalar(a), Scalar(b)) => Scalar(a * b),
        (Scalar(a), Plane(b)) | (Plane(b), Scalar(a)) => Plane(b.map(|part| a * part)),
        (Scalar(a), Space(b)) | (Space(b), Scalar(a)) => Space(b.map(|part| a * part)),
        (Plane([a, b]), Plane([c, d])) => Plane([a * c - b * d, a * d + b * c]),
        (Rotation(rows), Space(vector)) => Space(rows.map(|row| dot(&row, &vector))),
        (Rotation(rows), Rotation(other)) => {
            let column = |place: usize| other.map(|row| row[place]);
            Rotation(rows.map(|row| [0, 1, 2].map(|place| dot(&row, &column(place)))))
        }
        (left, right) => panic!("{left:?} * {right:?}"),
    }
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The columns of the rotation are what Rodrigues' formula makes of the axes of coordinates.
fn rotation(axis: [f64; 3], angle: f64) -> Value {
    let length = dot(&axis, &axis).sqrt();
    let unit = axis.map(|part| part / length);
    let (sine, cosine) = angle.sin_cos();
    let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|own| {
        let (across, along) = (cross(unit, own), dot(&unit, &own) * (1.0 - cosine));
        [0, 1, 2].map(|place| own[place] * cosine + across[place] * sine + unit[place] * along)
    });
    Rotation([0, 1, 2].map(|row| columns.map(|column| column[row])))
}

fn call(function: &str, arguments: &[Value]) -> Value {
    let number = |place: usize| scalar(&arguments[place]);
    let of_one: Option<fn(f64) -> f64> = match function {
        "sin" => Some(f64::sin),
        "cos" => Some(f64::cos),
        "tan" => Some(f64::tan),
        "asin" => Some(f64::asin),
        "acos" => Some(f64::acos),
        "atan" => Some(f64::atan),
        "exp" => Some(f64::exp),
        "ln" => Some(f64::ln),
        "sqrt" => Some(f64::sqrt),
        _ => None,
    };
    if let Some(function) = of_one {
        return Scalar(function(number(0)));
    }
    let polar = |length: f64, angle: f64| Plane([length * angle.cos(), length * angle.sin()]);
    match (function, arguments) {
        ("atan2", _) => Scalar(number(0).atan2(number(1))),
        #[expect(clippy::cast_possible_truncation, reason = "an exponent is a small integer")]
        ("powi", _) => Scalar(number(0).powi(number(1) as i32)),
        ("polar", _) => polar(number(0), number(1)),
        ("cis", _) => polar(1.0, number(0)),
        ("vec2", _) => Plane([number(0), number(1)]),
        ("vec3", _) => Space([number(0), number(1), number(2)]),
        ("rot_x", _) => rotation([1.0, 0.0, 0.0], number(0)),
        ("rot_y", _) => rotation([0.0, 1.0, 0.0], number(0)),
        ("rot_z", _) => rotation([0.0, 0.0, 1.0], number(0)),
        ("rot", [Space(axis), _]) => rotation(*axis, number(1)),
        ("norm", [vector]) => {
            let parts = vector.clone().parts();
            Scalar(dot(&parts, &parts).sqrt())
        }
        ("dot", [one, other]) => Scalar(dot(&one.clone().parts(), &other.clone().parts())),
        ("cross", [Plane([a, b]), Plane([c, d])]) => Scalar(a * d - b * c),
        ("cross", [Space(one), Space(other)]) => Space(cross(*one, *other)),
        _ => panic!("{function} of {arguments:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Scope, Value, value};
    use crate::formula::Formula;

    /// Turning about x, y and z is turning about these axes, and y becomes z by the first.
    #[test]
    fn rotations_are_right_handed() {
        let quarter = Formula::operand("PI").over(&Formula::operand("2"));
        for (function, of, becomes) in [
            ("rot_x", ["0", "1", "0"], [0.0, 0.0, 1.0]),
            ("rot_y", ["0", "0", "1"], [1.0, 0.0, 0.0]),
            ("rot_z", ["1", "0", "0"], [0.0, 1.0, 0.0]),
        ] {
            let turn = Formula::call(function, std::slice::from_ref(&quarter));
            let turned = value(&turn.times(&Formula::of_numbers("vec3", &of)), &Scope::new());
            for (found, expected) in turned.parts().into_iter().zip(becomes) {
                assert!((found - expected).abs() < 1e-15, "{function}");
            }
        }
    }

    #[test]
    fn products_of_the_plane_are_complex() {
        let scope = Scope::from([("v", Value::Plane([3.0, 4.0]))]);
        let v = Formula::operand("v");
        let turned = value(&v.times(&Formula::of_numbers("vec2", &["0", "1"])), &scope);
        assert_eq!(turned.parts(), [-4.0, 3.0]);
        assert_eq!(value(&Formula::call("norm", &[v]), &scope).parts(), [5.0]);
    }
}
