//! What other languages and programs call by another name, and what is written here instead.

use crate::mistakes::suggestion;
use crate::syntax::callee::{form, function_names, is_function};

/// The units of angles that programs write behind a number, with their size in degrees.
const ANGLES: [(&str, f64); 8] = [
    ("deg", 1.0),
    ("degree", 1.0),
    ("degrees", 1.0),
    ("turn", 360.0),
    ("turns", 360.0),
    ("rev", 360.0),
    ("gon", 0.9),
    ("grad", 0.9),
];

/// The advice about a function that the language does not have. It ends the sentence about it.
pub(super) fn instead_of_function(word: &str, method: bool) -> String {
    let advice = match word.to_ascii_lowercase().as_str() {
        "pow" | "powf" | "power" => "; write `powi(x, 2)` for a whole power, `sqrt(x)` for a square root",
        "sqr" | "square" => "; write `powi(x, 2)`",
        "hypot" => "; write `norm(vec2(x, y))`",
        "length" | "magnitude" | "mag" | "len" | "modulus" => "; write `norm(v)`",
        "dist" | "distance" => "; write `norm(a - b)`",
        "normalize" | "unit" => "; write `v / norm(v)`",
        "arg" | "angle" | "phase" => "; write `atan2(v.y, v.x)` for the angle of `v`",
        "re" | "real" => "; write `v.x`",
        "im" | "imag" => "; write `v.y`",
        "expi" | "expj" | "cexp" => "; write `cis(angle)`",
        "rotate" | "rot2" | "rot2d" => "; write `cis(angle) * v` in the plane, `rot_z(angle) * v` in space",
        "vec" | "vector" | "point" => "; write `vec2(x, y)`, or `vec3(x, y, z)` in space",
        "log" => "; write `ln(x)` for the natural logarithm",
        "radians" | "to_radians" | "deg2rad" => {
            "; angles are in radians already, and an angle of 30 degrees is written `30deg`"
        }
        "degrees" | "to_degrees" | "rad2deg" => {
            "; angles are in radians, and every motion in a result has the method `to_degrees`"
        }
        "sind" | "cosd" | "tand" => "; write `sin(30deg)` for the sine of 30 degrees, and so on",
        "abs" => {
            "; a formula must be differentiable, and that function is not: write `norm(v)` for the length of a vector"
        }
        "signum" | "sign" | "min" | "max" | "clamp" | "floor" | "ceil" | "round" | "rem_euclid" => {
            "; a formula must be differentiable, and that function is not"
        }
        "sin_cos" => "; write `sin(x)` and `cos(x)`, which are computed together",
        _ => return near_function(word, method),
    };
    advice.to_owned()
}

fn near_function(word: &str, method: bool) -> String {
    if let Some(name) = without_arc(word) {
        return format!("; did you mean `{name}`?");
    }
    let near = suggestion(word, function_names());
    if near.is_empty() && !method {
        "; write `*` for a product".to_owned()
    } else {
        near
    }
}

/// The function here named with `a` whose name elsewhere begins with `arc` or `ar`.
fn without_arc(word: &str) -> Option<String> {
    let function = word.strip_prefix("arc").or_else(|| word.strip_prefix("ar"))?;
    let name = format!("a{function}");
    is_function(&name).then_some(name)
}

/// Whether a word names a time derivative, as the methods of a motion do.
pub(super) fn is_derivative(word: &str) -> bool {
    matches!(
        word,
        "velocity" | "acceleration" | "jerk" | "snap" | "crackle" | "pop" | "derivative"
    )
}

/// Whether a function of this name differentiates in a program for algebra.
pub(super) fn differentiates(word: &str) -> bool {
    matches!(word, "diff" | "deriv" | "Derivative" | "derive" | "ddt" | "D" | "dt")
}

/// The advice about a number with letters behind it.
pub(super) fn about_suffix(digits: &str, suffix: &str) -> String {
    if let Some(degrees) = in_degrees(digits, suffix) {
        return format!("angles are in radians, or in degrees with `deg`: write `{degrees}deg`");
    }
    match suffix {
        "rad" | "radians" => format!("angles are in radians anyway: write `{digits}`"),
        "nm" | "um" | "mm" | "cm" | "dm" | "m" | "km" | "in" | "inch" | "ft" | "mil" | "thou" => {
            format!("lengths have one unit, of your choice: write `{digits}` in that unit")
        }
        "s" | "ms" | "us" | "min" | "h" | "Hz" | "rpm" => {
            "a declaration holds no times and speeds, which are given to the solver: write a number without a unit"
                .to_owned()
        }
        "f16" | "f32" | "f128" | "i8" | "i16" | "i32" | "i64" | "i128" | "isize" | "u8" | "u16" | "u32" | "u64"
        | "u128" | "usize" => format!("a number takes no type `{suffix}` here: write `{digits}`"),
        "i" | "j" => {
            "there are no imaginary numbers here: write `cis(angle)` for the exponential of an imaginary angle, \
             `vec2(x, y)` for a complex number"
                .to_owned()
        }
        "pi" | "Pi" | "π" => format!("a product is written with `*`: write `{digits} * PI`"),
        _ => format!("a product is written with `*`: write `{digits} * {suffix}`"),
    }
}

/// Whether a word behind a number is a unit, and nothing else. Single letters may be names.
pub(super) fn is_unit(word: &str) -> bool {
    ANGLES.iter().any(|(unit, _)| *unit == word)
        || matches!(
            word,
            "rad" | "radians" | "nm" | "um" | "mm" | "cm" | "dm" | "km" | "inch" | "ft" | "mil" | "thou" | "Hz" | "rpm"
        )
}

/// The number of degrees in a number with the unit of an angle behind it.
fn in_degrees(digits: &str, unit: &str) -> Option<f64> {
    // a product such as 0.1 * 0.9 has more digits than were typed
    const SCALE: f64 = 1e9;
    let (_, size) = ANGLES.into_iter().find(|(name, _)| *name == unit)?;
    let number: f64 = digits.parse().ok()?;
    Some((number * size * SCALE).round() / SCALE)
}

/// The function that a word is in small letters, as in `Cos[theta]`.
pub(super) fn form_in_small_letters(word: &str) -> Option<&'static str> {
    form(&word.to_ascii_lowercase())
}

/// The advice about a word that begins a statement in other languages. `next` is the name after it.
pub(super) fn instead_of_statement(word: &str, next: &str) -> Option<String> {
    Some(match word {
        "equation" | "eq" | "constraint" | "closure" => {
            format!("an equation needs no word before it: remove `{word}`")
        }
        "pivot" | "fixed" | "anchor" => {
            format!("`{word}` does not begin a statement: write `ground {next}` for a point that stands still")
        }
        "joint" | "hinge" | "revolute" => {
            format!(
                "`{word}` does not begin a statement: a point that two bodies name joins them, as `{next}` in `body \
                 rod: {next}, tip;`"
            )
        }
        _ => return None,
    })
}

/// Whether a word stands for a link in other programs.
pub(super) fn is_link(word: &str) -> bool {
    matches!(word, "link" | "bar" | "rigid" | "member" | "part" | "solid")
}

/// The advice about a word instead of a dimension. It ends the sentence about it.
pub(super) fn instead_of_dimension(word: &str) -> Option<&'static str> {
    Some(match word {
        "Velocity" | "Speed" | "Rate" | "Acceleration" | "Jerk" | "AngularVelocity" => {
            "; every result has its velocity and its higher derivatives: declare the quantity itself"
        }
        "Force" | "Torque" | "Moment" | "Mass" | "Inertia" => {
            "; a declaration holds the geometry alone, without masses and forces"
        }
        "Rotation" | "Rotation3" | "Orientation" | "Quaternion" | "Matrix" | "Matrix3" => {
            "; declare the angles of the rotation, and write `rot_z(a) * rot_x(b)` in the equations"
        }
        "Time" => "; did you mean `Scalar`?",
        _ => return None,
    })
}

/// The advice about a word that cannot be requested. It ends the sentence about it.
pub(crate) fn instead_of_request(word: &str) -> Option<&'static str> {
    if is_derivative(word) {
        return Some("; derivatives need no request: write `order = 3;` to solve through the jerk");
    }
    matches!(
        word,
        "serde" | "std" | "libm" | "alloc" | "nalgebra" | "glam" | "num_dual" | "approx"
    )
    .then_some("; a feature is named in Cargo.toml, behind the dependency `kin-core`")
}
