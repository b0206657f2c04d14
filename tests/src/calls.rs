//! Calls of solvers in other languages.

use std::fmt::Write as _;

use kin_core::tape::Tape;
use kin_core::tape::structure::Role;

/// What `solve` is given in JavaScript and in Python, where objects and dictionaries are written alike.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// The dimensions by name.
    pub parameters: String,
    /// The inputs by name, each with its rates.
    pub inputs: String,
    /// The assembly: one for each choice, or a value near each unknown.
    pub assembly: String,
}

impl Call {
    /// The arguments, where `of` writes the number with an index. The names of the tape must be names of the language.
    ///
    /// # Panics
    /// If a tape has rates without their input.
    #[must_use]
    pub fn new(tape: &Tape, of: impl Fn(usize) -> String) -> Self {
        let (mut parameters, mut inputs, mut assembly) = (Vec::new(), Vec::<(String, Vec<String>)>::new(), Vec::new());
        for (place, argument) in tape.arguments.iter().enumerate() {
            let name = argument.name.replace('.', "_");
            match argument.role {
                Role::Parameter(_) => parameters.push(format!("\"{name}\": {}", of(place))),
                Role::Input { order: 0, .. } => inputs.push((name, vec![of(place)])),
                Role::Input { .. } => inputs.last_mut().expect("a position is before").1.push(of(place)),
                Role::Near(_) | Role::Assembly(_) => assembly.push((name, of(place))),
                _ => panic!("an argument of another role"),
            }
        }
        let inputs: Vec<String> = inputs
            .into_iter()
            .map(|(name, rates)| format!("\"{name}\": [{}]", rates.join(", ")))
            .collect();
        let assembly = match assembly.as_slice() {
            [(name, only)] if name == "assembly" => only.clone(),
            several => {
                let pairs: Vec<String> = several.iter().map(|(name, own)| format!("\"{name}\": {own}")).collect();
                format!("{{{}}}", pairs.join(", "))
            }
        };
        Self {
            parameters: format!("{{{}}}", parameters.join(", ")),
            inputs: format!("{{{}}}", inputs.join(", ")),
            assembly,
        }
    }
}

/// A function `kernel` of C that solves a row of arguments, and returns the code of the outcome.
///
/// # Panics
/// If the solver has another structure of arguments.
#[must_use]
pub fn kernel(tape: &Tape) -> String {
    let name = tape.c().name;
    let count = |is_of: fn(&Role) -> bool| tape.arguments.iter().filter(|own| is_of(&own.role)).count();
    let structures = [
        ("dimensions", count(|role| matches!(role, Role::Parameter(_)))),
        ("inputs", count(|role| matches!(role, Role::Input { .. }))),
        ("near", count(|role| matches!(role, Role::Near(_)))),
        ("assembly", count(|role| matches!(role, Role::Assembly(_)))),
    ];
    let mut start = 0;
    let mut arguments = String::new();
    for (structure, members) in structures.into_iter().filter(|(_, members)| *members > 0) {
        // Structures of numbers alone are arrays.
        write!(arguments, "(const {name}_{structure} *)(in + {start}), ").expect("a string can be written");
        start += members;
    }
    assert_eq!(start, tape.arguments.len(), "{name}");
    format!(
        "#include \"{name}.h\"\n\nint kernel(const double *in, double *out);\n\
         int kernel(const double *in, double *out)\n\
         {{\n    return {name}_solve({arguments}({name}_pose *)out).code;\n}}\n"
    )
}
