//! The functions that programs in other languages carry along: kin's sine, cosine and arctangent, its triangular
//! factors and its Newton's method.
//!
//! The texts are files of their language with names such as `@SINE@` instead of constants. The constants come from the
//! code of this crate, and are printed so that they are read as the same numbers. C, JavaScript and NumPy find the same
//! numbers as this crate does where it does not fuse products, to the last bit: sines and cosines of angles up to 10⁵,
//! angles of points, factors and roots. Single precision in C has separate short polynomials and a separate reduction
//! of the angle, because it contains no `double`.

mod constants;
#[cfg(test)]
mod tests;

use std::string::{String, ToString};

use crate::tape::structure::Tape;
use crate::tape::{Function, NumberType, Operator, TapeNode};
use constants::ConstantTexts;

/// The parts of the run time that a program needs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "a program needs each part or does not")]
pub(super) struct RuntimeParts {
    /// Sines and cosines.
    pub(super) sine_cosine: bool,
    /// Angles of points.
    pub(super) arc_tangent: bool,
    /// Triangular factors.
    pub(super) factors: bool,
    /// Newton's method, which includes the factors.
    pub(super) newton: bool,
    /// The largest number of unknowns of a matrix or a block.
    pub(super) unknowns: usize,
}

impl RuntimeParts {
    /// The parts that a tape needs.
    pub(super) fn of(tape: &Tape<'_>) -> Self {
        let has = |wanted: fn(&TapeNode) -> bool| tape.nodes.iter().any(wanted);
        let systems = tape.systems.iter().map(|system| system.rows.len());
        let searches = tape.searches.iter().map(|search| search.guess.len());
        Self {
            sine_cosine: has(|node| matches!(node, TapeNode::Call(Function::Sine | Function::Cosine, _))),
            arc_tangent: has(|node| matches!(node, TapeNode::Binary(Operator::ArcTangent, ..))),
            factors: !tape.systems.is_empty(),
            newton: !tape.searches.is_empty(),
            unknowns: systems.chain(searches).max().unwrap_or(0),
        }
    }

    /// The parts one after the other, each a text with constants to be filled in.
    fn text(self, table: &ConstantTexts, [sine_cosine, arc_tangent, factors, newton]: [&str; 4]) -> String {
        let parts = [
            (self.sine_cosine, sine_cosine),
            (self.arc_tangent, arc_tangent),
            (self.factors || self.newton, factors),
            (self.newton, newton),
        ];
        let mut text = String::new();
        for (_, part) in parts.into_iter().filter(|(needed, _)| *needed) {
            if !text.is_empty() {
                text.push('\n');
            }
            text.push_str(&table.filled(part));
        }
        text
    }
}

/// The run time in C99, without heap and static state, as functions of one file. It begins with the headers that it
/// includes. With the macro `KIN_PLATFORM_FUNCTIONS` sine, cosine and arctangent are those of `<math.h>`.
///
/// - `kin_sine_cosine(angle, &sine, &cosine)` and `kin_atan2(y, x)`;
/// - `kin_factor(count, &factors, scaled, &detail)` of a matrix in `factors.entries`, scaled as another one if `scaled`
///   is not null, and `kin_substitute(count, &factors, right, solution)`;
/// - `kin_newton(&block, guess, found, &detail)`.
///
/// The outcomes are `KIN_FOUND`, which is zero, `KIN_NOT_CONVERGED`, `KIN_SINGULAR` and `KIN_NOT_FINITE`. Arrays of
/// unknowns have room for `KIN_UNKNOWNS`.
pub(super) fn c(parts: RuntimeParts, precision: NumberType) -> String {
    let table = ConstantTexts::new(precision);
    let mut text = include_str!("head.c").to_string();
    if parts.factors || parts.newton {
        let unknowns = parts.unknowns.max(1).to_string();
        text.push_str("\n/* The largest number of unknowns of a block. */\n#define KIN_UNKNOWNS ");
        text.push_str(&unknowns);
        text.push('\n');
    }
    let (factors, newton) = (include_str!("factors.c"), include_str!("newton.c"));
    let functions = match precision {
        NumberType::Double => parts.text(
            &table,
            [
                include_str!("sine_cosine.c"),
                include_str!("arc_tangent.c"),
                factors,
                newton,
            ],
        ),
        NumberType::Single => parts.text(
            &table,
            [
                include_str!("sine_cosine_single.c"),
                include_str!("arc_tangent_single.c"),
                &single(factors),
                &single(newton),
            ],
        ),
    };
    if !functions.is_empty() {
        text.push('\n');
        text.push_str(&functions);
    }
    text
}

/// The code that reports mistakes in the arguments of a solver in JavaScript: `kinCount` and `kinMistake`.
pub(super) const JAVA_SCRIPT_ARGUMENTS: &str = include_str!("arguments.js");

/// What refuses mistakes in the arguments of a solver in Python: `_named`, `_moving` and `_chosen`.
pub(super) const PYTHON_ARGUMENTS: &str = include_str!("arguments.py");

/// The run time in JavaScript, as functions of one module: `kinSineCosine`, `kinAtan2`, `kinFactor`, `kinSubstitute`
/// and `kinNewton`.
pub(super) fn java_script(parts: RuntimeParts) -> String {
    parts.text(
        &ConstantTexts::new(NumberType::Double),
        [
            include_str!("sine_cosine.js"),
            include_str!("arc_tangent.js"),
            include_str!("factors.js"),
            include_str!("newton.js"),
        ],
    )
}

/// The run time in Python, as functions of one module that has imported NumPy as `np` and calls its arrays `Array`:
/// `_sine_cosine`, `_atan2`, `_Factors` and `_newton`. They work on whole arrays, whose last axis are the poses.
pub(super) fn python(parts: RuntimeParts) -> String {
    parts
        .text(
            &ConstantTexts::new(NumberType::Double),
            [
                include_str!("sine_cosine.py"),
                include_str!("arc_tangent.py"),
                include_str!("factors.py"),
                include_str!("newton.py"),
            ],
        )
        .replace("\n\ndef ", "\n\n\ndef ")
        .replace("\n\nclass ", "\n\n\nclass ")
        .replace("\n\n\n\n", "\n\n\n")
}

/// C in double precision as C in single precision: words, functions of `<math.h>` and numbers outside of comments.
fn single(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if rest.starts_with('#') {
            rest.find('\n').unwrap_or(rest.len())
        } else if first.is_ascii_alphanumeric() || first == '_' || first == '@' {
            let belongs = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '@' || c == '.';
            rest.find(|c| !belongs(c)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (word, after) = rest.split_at(length);
        rest = after;
        match word {
            "double" => out.push_str("float"),
            "DBL_EPSILON" => out.push_str("FLT_EPSILON"),
            "DBL_MAX" => out.push_str("FLT_MAX"),
            "fabs" | "frexp" | "ldexp" => {
                out.push_str(word);
                out.push('f');
            }
            _ if first.is_ascii_digit() && word.contains('.') => {
                out.push_str(word);
                out.push('f');
            }
            _ => out.push_str(word),
        }
    }
    out
}
