//! A tape in Python, for arrays of NumPy.

use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::tape::body::{FunctionBody, Language};
use crate::tape::expression::Code;
use crate::tape::runtime::{self, RuntimeParts};
use crate::tape::signature::{Signature, SignatureEntry, head};
use crate::tape::spelling::Target;
use crate::tape::structure::Tape;
use crate::tape::words::{lines, quoted};
use crate::tape::writer::Dialect;
use crate::tape::{Function, TapeNode, Value};

/// The words of the language, and the names that the module uses itself.
const TAKEN: &[&str] = &[
    "False",
    "None",
    "True",
    "and",
    "as",
    "assert",
    "async",
    "await",
    "break",
    "class",
    "continue",
    "def",
    "del",
    "elif",
    "else",
    "except",
    "finally",
    "for",
    "from",
    "global",
    "if",
    "import",
    "in",
    "is",
    "lambda",
    "nonlocal",
    "not",
    "or",
    "pass",
    "raise",
    "return",
    "try",
    "while",
    "with",
    "yield",
    "match",
    "case",
    "type",
    "np",
    "npt",
    "bool",
    "int",
    "float",
    "len",
    "range",
    "range",
    "object",
    "parameters",
    "inputs",
    "assembly",
    "joints",
    "slides",
    "reached",
    "check",
    "margin",
    "solve",
    "Array",
    "Callable",
    "Mapping",
    "Sequence",
    "TypedDict",
    "dataclass",
    "annotations",
];

pub(super) struct Python;

impl Dialect for Python {
    const TARGET: Target = Target::Python;

    fn number(&self, value: f64) -> Code {
        let size = value.abs();
        if value.is_nan() {
            return Code::whole("np.nan");
        }
        let size_in_code = if size.is_infinite() {
            Code::whole("np.inf")
        } else {
            Code::whole(format!("{size:?}"))
        };
        if value.is_sign_negative() {
            size_in_code.negated()
        } else {
            size_in_code
        }
    }

    fn truth(&self, holds: bool) -> Code {
        Code::whole(if holds { "np.True_" } else { "np.False_" })
    }
}

impl Language for Python {
    const INDENT: &'static str = "    ";
    const NAN: &'static str = "np.nan";

    fn unknown(index: usize) -> String {
        format!("_u[{index}]")
    }

    fn root(search: usize, index: usize) -> String {
        format!("_root{search}[{index}]")
    }

    fn solution(solution: usize, index: usize) -> String {
        format!("_solution{solution}[{index}]")
    }

    fn pair(angle: Value) -> [String; 2] {
        ["_sine", "_cosine"].map(|name| format!("{name}{}", angle.0))
    }

    fn assignment(names: &[&str], value: &str) -> String {
        format!("{} = {value}", names.join(", "))
    }

    fn sine_cosine(angle: &str) -> String {
        format!("_sine_cosine({angle})")
    }

    fn is_lost(search: usize) -> [String; 2] {
        [format!("_outcome{search} != _FOUND"), format!("_detail{search}")]
    }

    fn is_singular(system: usize) -> [String; 2] {
        [
            format!("_system{system}.outcome != _FOUND"),
            format!("_system{system}.detail"),
        ]
    }

    fn check(
        body: &mut FunctionBody<'_, Self>,
        index: usize,
        fails: &str,
        margin: impl FnOnce(&mut FunctionBody<'_, Self>) -> String,
    ) {
        body.line(1, &format!("_failing = np.logical_and(_check < 0, {fails})"));
        body.line(1, "if np.any(_failing):");
        let margin = margin(body);
        body.line(2, &format!("_check = np.where(_failing, {index}, _check)"));
        body.line(2, &format!("_margin = np.where(_failing, {margin}, _margin)"));
    }

    fn search(body: &mut FunctionBody<'_, Self>, index: usize) {
        let search = &body.tape.searches[index];
        let outer = body.tape.given(index);
        let given = body.list(&outer);
        // Inside, each is a parameter with a separate name.
        let inner: Vec<String> = (0..outer.len()).map(|index| format!("_g{index}")).collect();
        let before = body.writer.names_of(&outer);
        for (value, name) in outer.iter().zip(&inner) {
            body.writer.name(*value, name.clone());
        }
        body.line(0, "");
        let parameters: Vec<String> = inner.iter().map(|name| format!(", {name}: Array")).collect();
        let parameters = parameters.concat();
        body.line(
            1,
            &format!("def _equations{index}(_u: Array{parameters}) -> tuple[Array, Array]:"),
        );
        body.within(&search.body);
        let (residuals, jacobian) = (body.list(&search.residuals), body.rows(&search.jacobian));
        body.line(2, "_size = _u.shape[1]");
        body.line(
            2,
            &format!("return _stacked({residuals}, _size), _stacked({jacobian}, _size)"),
        );
        for (value, name) in outer.iter().zip(before) {
            body.writer.rename(*value, name);
        }
        let (guess, sizes) = (body.list(&search.guess), body.list(&search.sizes));
        body.line(0, "");
        body.line(1, &format!("_root{index}, _outcome{index}, _detail{index} = _newton("));
        body.line(2, &format!("_stacked({guess}, _poses),"));
        body.line(2, &format!("_stacked({sizes}, _poses),"));
        body.line(2, &format!("_equations{index},"));
        body.line(2, &format!("_stacked({given}, _poses),"));
        body.line(2, "_check < 0,");
        body.line(1, ")");
    }

    fn factor(body: &mut FunctionBody<'_, Self>, index: usize, rows: &str) {
        body.line(1, &format!("_system{index} = _Factors(_stacked({rows}, _poses))"));
    }

    fn solve(body: &mut FunctionBody<'_, Self>, index: usize, system: usize, right: &str) {
        body.line(
            1,
            &format!("_solution{index} = _system{system}.solve(_stacked({right}, _poses))"),
        );
    }
}

/// The function that rounds halves away from zero, which `np.round` does not.
const ROUND: &str = r#"

def _round(number: Array) -> Array:
    """The nearest integer; a half is rounded away from zero."""
    whole = np.trunc(number)
    return np.where(np.abs(number - whole) >= 0.5, whole + np.sign(number), whole)
"#;

/// The function that puts numbers and arrays of one number for each pose together.
const STACKED: &str = r#"

def _stacked(entries: Sequence, poses: int) -> Array:
    """Numbers, or arrays with an entry for each pose, or lists of them, as one array whose last axis are the poses."""
    if isinstance(entries, list):
        return np.array([_stacked(entry, poses) for entry in entries])
    return np.broadcast_to(np.asarray(entries, dtype=np.float64), poses)
"#;

impl Tape<'_> {
    /// The solver as a Python module that works on whole arrays and needs NumPy alone.
    ///
    /// The module has a function `solve(parameters, inputs, assembly)`:
    ///
    /// - `parameters` is a dictionary with the dimensions by name; it may be empty if they are folded in;
    /// - `inputs` is a dictionary with a sequence for each input: its position, velocity and so on; missing rates are
    ///   zero;
    /// - `assembly` is `OPEN` or `CROSSED`, a dictionary with one of them for each of several choices, or a dictionary
    ///   with a value near each unknown for a mechanism with coupled blocks.
    ///
    /// Each number may be an array; they are broadcast to one shape. The result is a `Pose` with an array for each
    /// unknown and output, whose first axis are the orders, and with `reached`, a mask of the poses that exist. Numbers
    /// of other poses are NaN; `check` is the index among `CHECKS` of the check that failed, and `margin` the distance
    /// from passing. A name that is missing or unknown, and what is neither `OPEN` nor `CROSSED`, raises a `TypeError`
    /// that says what to give. With a skeleton it has `joints` and `slides`, whose first axes are the joint and the
    /// coordinate. Names are spelled in ASCII letters.
    ///
    /// The numbers are those of `solve` in a build of this crate that does not fuse products, to the last bit, as long
    /// as angles stay below 10⁵. Inverse sines and cosines, hyperbolic functions, exponentials and logarithms are those
    /// of NumPy. A tape in single precision is run in double precision.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::tape::{self, Options};
    ///
    /// let module = tape::record::<FourBar>(&Options::new().up_to(2))?.python();
    /// assert!(module.contains("import numpy as np"));
    /// # Ok::<(), tape::RecordError>(())
    /// ```
    #[must_use]
    pub fn python(&self) -> String {
        PythonModule::new(self, None).text()
    }
}

/// The line that refuses other names than these.
fn named(what: &str, entries: &[SignatureEntry<'_>]) -> String {
    let names: Vec<String> = entries
        .iter()
        .map(|entry| format!("{}, ", quoted(&entry.name)))
        .collect();
    format!("_named(\"{what}\", {what}, ({}))", names.concat().trim_end())
}

/// A module while it is written.
pub(super) struct PythonModule<'a> {
    signature: Signature<'a>,
    body: FunctionBody<'a, Python>,
}

/// The name of an argument. A name that ends with an underscore and a digit behind two is never that of a quantity.
fn argument(index: usize) -> String {
    format!("_a{index}")
}

impl<'a> PythonModule<'a> {
    pub(super) fn new(tape: &'a Tape<'a>, limit: Option<usize>) -> Self {
        Self {
            signature: Signature::new(tape, TAKEN),
            body: FunctionBody::new(tape, Python, limit, argument),
        }
    }

    fn line(&mut self, indent: usize, text: &str) {
        self.body.line(indent, text);
    }

    fn opening(&mut self) {
        let mut read = Vec::new();
        for entry in &self.signature.parameters {
            read.push((entry.indices[0], format!("parameters[\"{}\"]", entry.name)));
        }
        for entry in &self.signature.inputs {
            for (order, index) in entry.indices.iter().enumerate() {
                read.push((*index, format!("_rate(inputs[\"{}\"], {order})", entry.name)));
            }
        }
        for entry in &self.signature.near {
            read.push((entry.indices[0], format!("assembly[\"{}\"]", entry.name)));
        }
        match self.signature.assemblies.as_slice() {
            [only] => read.push((only.indices[0], "assembly".to_string())),
            several => {
                for entry in several {
                    read.push((entry.indices[0], format!("assembly[\"{}\"]", entry.name)));
                }
            }
        }
        read.sort();
        for (what, entries) in [
            ("parameters", &self.signature.parameters),
            ("inputs", &self.signature.inputs),
        ] {
            let line = named(what, entries);
            self.body.line(1, &line);
        }
        for entry in &self.signature.inputs {
            let name = quoted(&entry.name);
            self.body.line(1, &format!("_moving({name}, inputs[{name}])"));
        }
        let (near, choices) = (&self.signature.near, self.signature.assemblies.as_slice());
        match choices {
            [_] => self.body.line(1, "_chosen(\"assembly\", assembly)"),
            several => {
                for entries in [near.as_slice(), several]
                    .into_iter()
                    .filter(|entries| !entries.is_empty())
                {
                    self.body.line(1, &named("assembly", entries));
                }
                for entry in several {
                    let member = format!("assembly[{}]", quoted(&entry.name));
                    self.body.line(1, &format!("_chosen({}, {member})", quoted(&member)));
                }
            }
        }
        self.line(1, "_given = np.broadcast_arrays(");
        for (_, text) in &read {
            self.line(2, &format!("{text},"));
        }
        self.line(1, ")");
        self.line(1, "_shape = _given[0].shape");
        self.line(1, "_given = [np.ravel(entry).astype(np.float64) for entry in _given]");
        self.line(1, "_poses = len(_given[0])");
        let names: Vec<String> = read.iter().map(|(index, _)| argument(*index)).collect();
        self.line(1, &format!("{}, = _given", names.join(", ")));
        self.line(1, "_check = np.full(_poses, -1)");
        self.line(1, "_margin = np.full(_poses, np.nan)");
    }

    fn closing(&mut self) {
        self.line(1, "_reached = _check < 0");
        self.line(0, "");
        self.line(1, "def _found(entries: list) -> Array:");
        self.line(2, "stacked = np.where(_reached, _stacked(entries, _poses), np.nan)");
        self.line(2, "return stacked.reshape(stacked.shape[:-1] + _shape)");
        self.line(0, "");
        self.line(1, "return Pose(");
        self.line(2, "reached=_reached.reshape(_shape),");
        self.line(2, "check=_check.reshape(_shape),");
        self.line(2, "margin=_margin.reshape(_shape),");
        for (name, list) in self.body.results(&self.signature) {
            self.line(2, &format!("{name}=_found({list}),"));
        }
        self.line(1, ")");
    }

    pub(super) fn text(mut self) -> String {
        self.opening();
        self.body.steps();
        self.closing();
        let tape = self.body.tape;
        let mut text = docstring(&head(tape), "");
        text.push_str(
            "from __future__ import annotations\n\nfrom collections.abc import Callable, Mapping, Sequence\n",
        );
        text.push_str(
            "from dataclasses import dataclass\nfrom typing import TypedDict\n\nimport numpy as np\nimport \
            numpy.typing as npt\n\n",
        );
        text.push_str("Array = npt.NDArray[np.float64]\n\n");
        text.push_str("#: The assemblies of a choice between two.\nOPEN, CROSSED = 1.0, -1.0\n\n");
        text.push_str(
            "#: The checks on the way to a pose: the subject of each, and the unknowns of its block.\nCHECKS = (\n",
        );
        for check in &tape.checks {
            text.extend([format!(
                "    ({}, {}),\n",
                quoted(check.name),
                quoted(&tape.block_of(check).to_string())
            )]);
        }
        text.push_str(")\n");
        text.push_str(&self.documentation());
        text.push_str("    with np.errstate(all=\"ignore\"):\n        return _solve(parameters, inputs, assembly)\n");
        text.push_str(
            "\n\ndef _rate(motion: Sequence[npt.ArrayLike], order: int) -> npt.ArrayLike:\n    return \
            motion[order] if order < len(motion) else 0.0\n",
        );
        text.push_str("\n\n");
        text.push_str(&self.signature.argument_checks(runtime::PYTHON_ARGUMENTS));
        text.push_str(STACKED);
        text.push_str("\n\ndef _solve(parameters: Parameters, inputs: Inputs, assembly: Assembly) -> Pose:\n");
        text.push_str(&self.body.text);
        if tape
            .nodes
            .iter()
            .any(|node| matches!(node, TapeNode::Call(Function::Round, _)))
        {
            text.push_str(ROUND);
        }
        let functions = runtime::python(RuntimeParts::of(tape));
        if !functions.is_empty() {
            text.push_str("\n\n");
            text.push_str(&functions);
        }
        text
    }

    /// The types, and the signature of the function with its documentation.
    fn documentation(&self) -> String {
        let signature = &self.signature;
        let mut text = String::new();
        let mut define = |name: &str, of: &str, entries: &[SignatureEntry<'_>], kind: &str| {
            text.extend([format!("\n\nclass {name}(TypedDict):\n")]);
            text.push_str(&docstring(&[of.to_string()], "    "));
            for entry in entries {
                text.push_str(&documented("    ", &entry.text()));
                text.extend([format!("    {}: {kind}\n", entry.name)]);
            }
        };
        define("Parameters", "The dimensions.", &signature.parameters, "npt.ArrayLike");
        let of = "The inputs, each with its rates; missing rates are zero.";
        define("Inputs", of, &signature.inputs, "Sequence[npt.ArrayLike]");
        if !signature.near.is_empty() {
            let of = "A value near each unknown, which chooses one of several assemblies.";
            define("Assembly", of, &signature.near, "npt.ArrayLike");
        } else if signature.assemblies.len() > 1 {
            define(
                "Assembly",
                "The assembly of each choice: OPEN or CROSSED.",
                &signature.assemblies,
                "npt.ArrayLike",
            );
        } else {
            text.push_str("\n\n#: The assembly: OPEN or CROSSED.\nAssembly = npt.ArrayLike\n");
        }
        text.push_str("\n\n@dataclass(frozen=True)\nclass Pose:\n");
        let of = [
            "What is found. The first axis of a quantity are its orders: position, velocity and so on.".to_string(),
            String::new(),
            "Numbers of poses that are not reached are NaN.".to_string(),
        ];
        text.push_str(&docstring(&of, "    "));
        text.push_str("    #: Whether there is a pose.\n    reached: npt.NDArray[np.bool_]\n");
        text.push_str(
            "    #: The index among CHECKS of the check that failed, or -1.\n    check: npt.NDArray[np.int_]\n",
        );
        text.push_str(
            "    #: The distance from passing: negative if something is out of reach by that much.\n    \
            margin: Array\n",
        );
        for entry in &signature.results {
            text.push_str(&documented("    ", &entry.text()));
            text.extend([format!("    {}: Array\n", entry.name)]);
        }
        for (name, _) in signature.picture() {
            text.extend([format!(
                "    #: The {name} of the skeleton: the first axes are the number and the \
                coordinate.\n    {name}: Array\n"
            )]);
        }
        text.push_str("\n\ndef solve(parameters: Parameters, inputs: Inputs, assembly: Assembly) -> Pose:\n");
        let of = [
            format!("The poses of the mechanism `{}`.", self.body.tape.description.name),
            String::new(),
            "Every number may be an array. All of them are broadcast to one shape.".to_string(),
        ];
        text.push_str(&docstring(&of, "    "));
        text
    }
}

/// A comment that documents the next line.
fn documented(indent: &str, of: &str) -> String {
    let lines = lines(of, 112).into_iter().map(|line| format!("{indent}#: {line}\n"));
    lines.collect()
}

/// Lines as a documentation string.
fn docstring(texts: &[String], indent: &str) -> String {
    let mut all = Vec::new();
    for line in texts {
        let inner = &line[..line.len() - line.trim_start().len()];
        let parts = lines(&line.replace('\\', "\\\\").replace('"', "\\\""), 112);
        all.extend(parts.iter().map(|part| format!("{indent}{inner}{part}")));
        if parts.is_empty() {
            all.push(String::new());
        }
    }
    let text = all.join("\n");
    let end = if all.len() > 1 {
        format!("\n{indent}")
    } else {
        String::new()
    };
    format!("{indent}\"\"\"{}{end}\"\"\"\n\n", text.trim_start())
}
