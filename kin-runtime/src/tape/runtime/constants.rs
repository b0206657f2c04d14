//! The constants of the run time, from the code that uses them here, as text.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::number::elementary::constants as elementary;
use crate::number::single;
use crate::solve::{
    self, CONVERGING, FIRST_STEP, ITERATIONS, LINEAR_STEP, NEGLIGIBLE, QUADRATIC, SMALLEST_PART, TRIALS,
};
use crate::tape::NumberType;

/// The texts that stand for names such as `@SINE@`.
pub(super) struct ConstantTexts(Vec<(&'static str, String)>);

impl ConstantTexts {
    pub(super) fn new(precision: NumberType) -> Self {
        let list = |numbers: &[f64]| {
            let texts: Vec<String> = numbers.iter().map(|number| literal(*number, precision)).collect();
            texts.join(", ")
        };
        let one = |number: f64| literal(number, precision);
        let (right_angle, half_right_angle) = (
            elementary::RIGHT_ANGLE.iter().rev().sum::<f64>(),
            elementary::HALF_RIGHT_ANGLE.iter().rev().sum::<f64>(),
        );
        debug_assert!(right_angle == 2.0 * half_right_angle);
        let entries = match precision {
            NumberType::Double => [
                ("RIGHT_ANGLE", list(&elementary::RIGHT_ANGLE)),
                ("SINE", list(&elementary::SINE)),
                ("COSINE", list(&elementary::COSINE)),
                ("ROUNDING", one(elementary::ROUNDING)),
                ("HALF_RIGHT_ANGLE", list(&elementary::HALF_RIGHT_ANGLE)),
                ("ARC_TANGENT", list(&elementary::ARC_TANGENT)),
                ("RANGE", solve::range::<f64>().to_string()),
            ],
            NumberType::Single => [
                // Numbers of right angles have at most 16 bits, so eight more are exact. The middle of π/2 has 37 bits.
                ("RIGHT_ANGLE", list(&parts::<5>(elementary::RIGHT_ANGLE, 8))),
                ("SINE", list(&elementary::SINE_SINGLE)),
                ("COSINE", list(&elementary::COSINE_SINGLE)),
                // Half of the distance between two of these numbers is 1/2.
                ("ROUNDING", one(12_582_912.0)),
                // The multiples of π/4 are up to 4, which leaves 21 bits.
                ("HALF_RIGHT_ANGLE", list(&parts::<2>([half_right_angle, 0.0, 0.0], 21))),
                ("ARC_TANGENT", list(&elementary::ARC_TANGENT_SINGLE)),
                ("RANGE", solve::range::<f32>().to_string()),
            ],
        };
        let mut all = Vec::from(entries);
        all.extend([
            ("LIMIT", one(elementary::LIMIT)),
            ("TWO_OVER_PI", one(core::f64::consts::FRAC_2_PI)),
            ("FIRST_STEP", one(FIRST_STEP)),
            ("LINEAR_STEP", one(LINEAR_STEP)),
            ("SMALLEST_PART", one(SMALLEST_PART)),
            ("CONVERGING", one(CONVERGING)),
            ("QUADRATIC", one(QUADRATIC)),
            ("NEGLIGIBLE", one(NEGLIGIBLE)),
            ("ITERATIONS", ITERATIONS.to_string()),
            ("TRIALS", TRIALS.to_string()),
        ]);
        Self(all)
    }

    /// The text with all its names replaced.
    pub(super) fn filled(&self, text: &str) -> String {
        let mut filled = text.to_string();
        for (name, value) in &self.0 {
            filled = filled.replace(&format!("@{name}@"), value);
        }
        filled
    }
}

/// A finite number that is read as itself: the shortest decimal fraction that is nearest to it. C, JavaScript and
/// Python write it the same way; a number of single precision has the suffix of C.
fn literal(number: f64, precision: NumberType) -> String {
    match precision {
        NumberType::Double => format!("{number:?}"),
        NumberType::Single => format!("{:?}f", single(number)),
    }
}

/// A sum of doubles as a sum of `N` numbers in single precision, all of `bits` bits but the last.
fn parts<const N: usize>(whole: [f64; 3], bits: i32) -> [f64; N] {
    let [mut rest, middle, low] = whole;
    core::array::from_fn(|index| {
        if index == N - 1 {
            return f64::from(single(rest + (middle + low)));
        }
        // The exponent of the lowest bit, from that of the number itself.
        let lowest = solve::exponent_of(rest) + 1 - bits;
        let unit = f64::exp2(f64::from(lowest));
        let part = (rest / unit).floor() * unit;
        rest -= part;
        part
    })
}
