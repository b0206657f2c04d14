//! The solver of a mechanism in C99.

mod expression;
mod header;
mod source;
mod writer;

use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::tape::structure::Tape;
use crate::tape::words::{DistinctNames, lines, of_order, snake};
use crate::tape::{Condition, NumberType, ResultOf, Role};

/// The words of C and C++, the names of `<math.h>` that the code calls, and the names of the arguments of the code.
const KEYWORDS: &[&str] = &[
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "class",
    "compl",
    "const",
    "constexpr",
    "continue",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "else",
    "enum",
    "explicit",
    "export",
    "extern",
    "false",
    "float",
    "for",
    "friend",
    "goto",
    "if",
    "inline",
    "int",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "struct",
    "switch",
    "template",
    "this",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "typeof",
    "union",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
    "acos",
    "acosf",
    "acosh",
    "acoshf",
    "asin",
    "asinf",
    "asinh",
    "asinhf",
    "atan",
    "atanf",
    "atanh",
    "atanhf",
    "ceil",
    "ceilf",
    "cos",
    "cosf",
    "cosh",
    "coshf",
    "exp",
    "expf",
    "fabs",
    "fabsf",
    "frexp",
    "frexpf",
    "ldexp",
    "ldexpf",
    "log",
    "logf",
    "round",
    "roundf",
    "sin",
    "sinf",
    "sinh",
    "sinhf",
    "sqrt",
    "sqrtf",
    "tanh",
    "tanhf",
    "main",
    "linux",
    "unix",
    "chain",
    "dimensions",
    "inputs",
    "assembly",
    "near",
    "pose",
    "NAN",
    "INFINITY",
    "HUGE_VAL",
    "NULL",
    "EOF",
    "stdin",
    "stdout",
    "stderr",
    "HUGE_VALF",
    "HUGE_VAL",
    "HUGE_VALF",
    "I",
    "given",
    "unknowns",
    "residuals",
    "jacobian",
    "DBL_MAX",
    "FLT_MAX",
    "DBL_EPSILON",
    "FLT_EPSILON",
];

/// A solver as files of C.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct C {
    /// The name of the mechanism in small letters, with which all names in the files begin: `four_bar`.
    pub name: String,
    /// The text of `four_bar.h`: structures and functions with their documentation.
    pub header: String,
    /// The text of `four_bar.c`.
    pub source: String,
    /// The text of `main.c`: a program that reads poses from its input, and prints their motion.
    pub example: String,
}

impl Tape<'_> {
    /// The tape as C99: a header, a source and an example. The code needs `<math.h>` and `<float.h>` alone, allocates
    /// nothing and has no static state.
    ///
    /// `cc -O2 -std=c99 -ffp-contract=off main.c four_bar.c -lm -o four_bar` builds the example. It finds the numbers
    /// of `solve` to the last bit where this crate is built without fused products, for angles up to 10⁵ and closures
    /// of sums, products, quotients, square roots, sines, cosines and angles of vectors.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::tape::{self, Options};
    ///
    /// let c = tape::record::<FourBar>(&Options::new())?.c();
    /// assert!(c.header.contains("four_bar_outcome four_bar_solve("));
    /// for (file, text) in [("four_bar.h", &c.header), ("four_bar.c", &c.source), ("main.c", &c.example)] {
    ///     println!("{file}: {} bytes", text.len());
    /// }
    /// # Ok::<(), tape::RecordError>(())
    /// ```
    #[must_use]
    pub fn c(&self) -> C {
        Text::new(self).files()
    }

    /// [`c`](Self::c) with expressions of any length.
    #[cfg(test)]
    pub(super) fn c_without_sharing(&self) -> C {
        let width = usize::MAX;
        Text {
            width,
            ..Text::new(self)
        }
        .files()
    }
}

/// The longest expression that is written where it is used, in letters.
const WIDTH: usize = 64;

/// A tape with its names in C.
struct Text<'a> {
    tape: &'a Tape<'a>,
    /// The beginning of all names.
    name: String,
    /// The beginning of the names of constants.
    upper: String,
    /// `double` or `float`.
    number: &'static str,
    /// The name of each argument, in its structure and as a variable.
    arguments: Vec<String>,
    /// The name of each result in the structure of a pose.
    results: Vec<String>,
    /// The name of the code of each check.
    codes: Vec<String>,
    /// The longest expression that is written where it is used, in letters.
    width: usize,
}

impl<'a> Text<'a> {
    fn new(tape: &'a Tape<'a>) -> Self {
        let name = snake(tape.description.name);
        let upper = name.to_uppercase();
        let mut names = DistinctNames::new(KEYWORDS);
        let arguments = tape.arguments.iter().map(|argument| {
            let plain = match argument.role {
                Role::Input { order, .. } => of_order(&argument.name, order),
                Role::Assembly(_) if argument.name == "assembly" => "sign".to_string(),
                Role::Near(_) | Role::Assembly(_) | Role::Parameter(_) => argument.name.clone(),
            };
            names.name(&plain)
        });
        let arguments = arguments.collect();
        let mut names = DistinctNames::new(KEYWORDS);
        let results = tape.results.iter().map(|result| {
            let by = |parameter: usize| tape.description.parameters[parameter].name;
            let quantity =
                |name: &str, parameter: usize| format!("{}_by_{}", of_order(name, result.order), by(parameter));
            let plain = match result.quantity {
                ResultOf::UnknownPartial { unknown, parameter } => {
                    quantity(tape.description.unknowns[unknown].name, parameter)
                }
                ResultOf::OutputPartial { output, parameter } => {
                    quantity(tape.description.outputs[output].name, parameter)
                }
                _ => of_order(&result.name, result.order),
            };
            names.name(&plain)
        });
        let results = results.collect();
        let mut names = DistinctNames::new(&[]);
        let codes = tape.checks.iter().map(|check| {
            let words: String = format!("{} {}", check.name, tape.block_of(check))
                .chars()
                .map(|letter| if letter == ' ' || letter == ',' { '_' } else { letter })
                .collect();
            let plain = snake(&words).replace("__", "_");
            names.name(&format!("{upper}_{}", plain.trim_end_matches('_').to_uppercase()))
        });
        let codes = codes.collect();
        Self {
            tape,
            name,
            upper,
            number: match tape.precision {
                NumberType::Single => "float",
                NumberType::Double => "double",
            },
            arguments,
            results,
            codes,
            width: WIDTH,
        }
    }

    fn files(self) -> C {
        C {
            header: header::header(&self),
            source: source::source(&self),
            example: header::example(&self),
            name: self.name,
        }
    }

    /// The structures of the arguments: the suffix of the type's name and the variable, and which arguments are in it.
    /// A structure without arguments is left out.
    fn structures(&self) -> Vec<(&'static str, Vec<usize>)> {
        type IsIn = fn(&Role) -> bool;
        let all: [(&str, IsIn); 4] = [
            ("dimensions", |role| matches!(role, Role::Parameter(_))),
            ("inputs", |role| matches!(role, Role::Input { .. })),
            ("near", |role| matches!(role, Role::Near(_))),
            ("assembly", |role| matches!(role, Role::Assembly(_))),
        ];
        let members = |is_in: IsIn| -> Vec<usize> {
            let arguments = self.tape.arguments.iter().enumerate();
            arguments
                .filter(|(_, argument)| is_in(&argument.role))
                .map(|(index, _)| index)
                .collect()
        };
        let structures = all.into_iter().map(|(name, is_in)| (name, members(is_in)));
        structures.filter(|(_, members)| !members.is_empty()).collect()
    }

    /// The arguments that choose between open and crossed.
    fn choices(&self) -> impl Iterator<Item = usize> + use<'a> {
        let arguments = self.tape.arguments.iter().enumerate();
        arguments
            .filter(|(_, argument)| matches!(argument.role, Role::Assembly(_)))
            .map(|(index, _)| index)
    }

    /// The structure member that holds an argument.
    fn member_of(&self, argument: usize) -> String {
        let structure = match self.tape.arguments[argument].role {
            Role::Parameter(_) => "dimensions",
            Role::Input { .. } => "inputs",
            Role::Near(_) => "near",
            Role::Assembly(_) => "assembly",
        };
        format!("{structure}->{}", self.arguments[argument])
    }

    /// The head of a function without its end: its name, and its arguments with their types, each on a separate line.
    /// The last one is what it writes to.
    fn signature(&self, function: &str, target: &str) -> String {
        let name = &self.name;
        let mut arguments: Vec<String> = self
            .structures()
            .into_iter()
            .map(|(structure, _)| format!("const {name}_{structure} *{structure}"))
            .collect();
        arguments.push(format!("{name}_{target} *{target}"));
        format!("{name}_outcome {name}_{function}(\n    {})", arguments.join(",\n    "))
    }

    /// The first lines of each file.
    fn head(&self, file: &str) -> String {
        let mut words = format!(
            "{file}: the motion of the mechanism {}, written by kin {}. ",
            self.tape.description.name,
            env!("CARGO_PKG_VERSION")
        );
        if self.tape.folded.is_empty() {
            words.push_str("The dimensions are arguments. ");
        } else {
            let parameters = self.tape.description.parameters.iter().zip(&self.tape.folded);
            let dimensions: Vec<String> = parameters
                .map(|(parameter, value)| format!("{} = {value:?}", parameter.name))
                .collect();
            words.push_str(&format!("The dimensions are {}. ", dimensions.join(", ")));
        }
        let licence = env!("CARGO_PKG_LICENSE");
        words.push_str(&format!(
            "Licence, at your option: {licence}. Do not edit: write it again."
        ));
        comment("", &words)
    }
}

/// The meaning of the margin of a check that fails.
fn meaning_of_margin(condition: Condition) -> &'static str {
    match condition {
        Condition::Holds(_) => "the distance from passing, negative if something is out of reach",
        Condition::Found(_) => "the largest residual where the search stopped, or the determinant there",
        Condition::Regular(_) => "the determinant",
    }
}

/// A comment of C. It does not end early, and continues no line.
fn comment(indent: &str, text: &str) -> String {
    let text = text.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?");
    let mut printed = String::new();
    let lines = lines(&text, 100 - indent.len());
    for (index, line) in lines.iter().enumerate() {
        let start = if index == 0 { "/* " } else { "   " };
        let line = line
            .strip_suffix('\\')
            .map_or_else(|| line.clone(), |line| format!("{line}\\."));
        printed.push_str(&format!("{indent}{start}{line}"));
        printed.push_str(if index + 1 == lines.len() { " */\n" } else { "\n" });
    }
    printed
}

/// A text of C between quotes.
fn quoted(text: &str) -> String {
    let mut printed = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => {
                printed.push('\\');
                printed.push(letter);
            }
            '?' => printed.push_str("\\?"),
            _ if letter.is_ascii_graphic() || letter == ' ' => printed.push(letter),
            _ => printed.push('.'),
        }
    }
    printed.push('"');
    printed
}

#[cfg(test)]
mod tests {
    use std::string::ToString as _;

    use super::{comment, quoted};

    #[test]
    fn comments_do_not_end_early() {
        assert_eq!(
            comment("", "a */ b /* c ??/ d\\\n e\\"),
            "/* a * / b / * c ? ?/ d\\ e\\. */\n".to_string()
        );
        let long = "word ".repeat(40);
        assert!(comment("    ", &long).lines().all(|line| line.len() <= 110));
        assert_eq!(comment("", ""), "");
    }

    #[test]
    fn quotes_hold_what_is_in_them() {
        assert_eq!(quoted("a \"b\" \\ ??/ θ"), "\"a \\\"b\\\" \\\\ \\?\\?/ .\"");
    }
}
