//! A tape in Python, for arrays of NumPy.

use std::collections::BTreeSet;
use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::tape::c::expression::Expression;
use crate::tape::runtime::{self, Parts};
use crate::tape::signature::{Entry, Signature, head};
use crate::tape::words::lines;
use crate::tape::writer::{Dialect, Writer};
use crate::tape::{Condition, Function, Node, Step, Tape, Value};

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

struct Python;

impl Dialect for Python {
    fn number(&self, value: f64) -> Expression {
        let size = value.abs();
        if value.is_nan() {
            return Expression::whole("np.nan");
        }
        let own = if size.is_infinite() {
            Expression::whole("np.inf")
        } else {
            Expression::whole(format!("{size:?}"))
        };
        if value.is_sign_negative() { own.negated() } else { own }
    }

    fn truth(&self, holds: bool) -> Expression {
        Expression::whole(if holds { "np.True_" } else { "np.False_" })
    }

    fn call(&self, function: Function, argument: &Expression) -> Expression {
        let name = match function {
            Function::Negate => return argument.negated(),
            Function::Magnitude => "np.abs",
            Function::SquareRoot => "np.sqrt",
            Function::Sine => "np.sin",
            Function::Cosine => "np.cos",
            Function::ArcSine => "np.arcsin",
            Function::ArcCosine => "np.arccos",
            Function::ArcTangent => "np.arctan",
            Function::HyperbolicSine => "np.sinh",
            Function::HyperbolicCosine => "np.cosh",
            Function::HyperbolicTangent => "np.tanh",
            Function::AreaHyperbolicSine => "np.arcsinh",
            Function::AreaHyperbolicCosine => "np.arccosh",
            Function::AreaHyperbolicTangent => "np.arctanh",
            Function::Exponential => "np.exp",
            Function::Logarithm => "np.log",
            Function::Round => "_round",
            Function::Raise => "np.ceil",
        };
        Expression::call(name, &[argument])
    }

    fn angle(&self, y: &Expression, x: &Expression) -> Expression {
        Expression::call("_atan2", &[y, x])
    }

    /// Python's own numbers, which constants are, refuse to be divided by zero.
    fn quotient(&self, one: &Expression, other: &Expression) -> Expression {
        Expression::call("np.divide", &[one, other])
    }

    fn is_finite(&self, number: &Expression) -> Expression {
        Expression::call("np.isfinite", &[number])
    }

    fn select(&self, truth: &Expression, one: &Expression, other: &Expression) -> Expression {
        Expression::call("np.where", &[truth, one, other])
    }

    fn both(&self, one: &Expression, other: &Expression) -> Expression {
        Expression::call("np.logical_and", &[one, other])
    }

    fn either(&self, one: &Expression, other: &Expression) -> Expression {
        Expression::call("np.logical_or", &[one, other])
    }

    fn not(&self, truth: &Expression) -> Expression {
        Expression::call("np.logical_not", &[truth])
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

impl Tape {
    /// The solver as a Python module that works on whole arrays and needs NumPy alone.
    ///
    /// The module has a function `solve(parameters, inputs, assembly)`:
    ///
    /// - `parameters` is a dictionary with the dimensions by name; it may be empty if they are folded in;
    /// - `inputs` is a dictionary with a sequence for each input: its position, velocity and so on; missing rates are zero;
    /// - `assembly` is `OPEN` or `CROSSED`, a dictionary with one of them for each of several choices, or a dictionary
    ///   with a value near each unknown for a mechanism with coupled blocks.
    ///
    /// Each number may be an array; they are broadcast to one shape. The result is a `Pose` with an array for each unknown
    /// and output, whose first axis are the orders, and with `reached`, a mask of the poses that exist. Numbers of other
    /// poses are NaN; `check` is the index among `CHECKS` of the check that failed, and `margin` the distance from
    /// passing. With a skeleton it has `joints` and `slides`, whose first axes are the joint and the coordinate. Names are
    /// spelled in ASCII letters.
    ///
    /// The numbers are those of `solve` in a build of this crate that does not fuse products, to the last bit, as long as
    /// angles stay below 10⁵. Inverse sines and cosines, hyperbolic functions, exponentials and logarithms are those of
    /// NumPy. A tape in single precision is run in double precision.
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
        Module::new(self, None).text()
    }
}

/// A module while it is written.
pub(super) struct Module<'a> {
    tape: &'a Tape,
    signature: Signature,
    writer: Writer<'a, Python>,
    /// The longest operand without a name of its own.
    limit: Option<usize>,
    /// The sines and cosines that are there, by their angles.
    pairs: BTreeSet<Value>,
    body: String,
}

/// The name of an argument. A name that ends with an underscore and a digit behind two is never that of a quantity.
fn argument(place: usize) -> String {
    format!("_a{place}")
}

impl<'a> Module<'a> {
    pub(super) fn new(tape: &'a Tape, limit: Option<usize>) -> Self {
        let mut writer = Writer::new(tape, Python);
        for place in 0..tape.nodes.len() {
            let value = Value(u32::try_from(place).unwrap_or(u32::MAX));
            match tape.nodes[place] {
                Node::Argument(index) => writer.name(value, argument(index)),
                Node::Unknown { index, .. } => writer.name(value, format!("_u[{index}]")),
                Node::Root { search, index } => writer.name(value, format!("_root{search}[{index}]")),
                Node::Solution { solution, index } => writer.name(value, format!("_solution{solution}[{index}]")),
                _ => {}
            }
        }
        Self {
            tape,
            signature: Signature::new(tape, TAKEN),
            writer,
            limit,
            pairs: BTreeSet::new(),
            body: String::new(),
        }
    }

    fn line(&mut self, indent: usize, text: &str) {
        for _ in 0..indent {
            self.body.push_str("    ");
        }
        self.body.push_str(text);
        self.body.push('\n');
    }

    /// The nodes of a group, each as a variable.
    fn compute(&mut self, group: &[Value], indent: usize) {
        let tape = self.tape;
        for value in self.writer.named(group, self.limit) {
            if let Node::Call(Function::Sine | Function::Cosine, angle) = tape.nodes[value.index()] {
                if self.pairs.insert(angle) {
                    let argument = self.writer.value(angle).text;
                    self.line(
                        indent,
                        &format!("_sine{0}, _cosine{0} = _sine_cosine({argument})", angle.0),
                    );
                }
                let is_sine = matches!(tape.nodes[value.index()], Node::Call(Function::Sine, _));
                let name = if is_sine { "_sine" } else { "_cosine" };
                self.writer.name(value, format!("{name}{}", angle.0));
            } else {
                let text = self.writer.operation(value).text;
                self.line(indent, &format!("{value} = {text}"));
                self.writer.name(value, value.to_string());
            }
        }
    }

    fn list(&self, values: &[Value]) -> String {
        let texts: Vec<String> = values.iter().map(|value| self.writer.value(*value).text).collect();
        format!("[{}]", texts.join(", "))
    }

    fn rows(&self, rows: &[Vec<Value>]) -> String {
        let rows: Vec<String> = rows.iter().map(|row| self.list(row)).collect();
        format!("[{}]", rows.join(", "))
    }

    fn check(&mut self, index: usize) {
        let check = &self.tape.checks[index];
        let (condition, detail) = match check.condition {
            Condition::Holds(truth) => (self.writer.dialect.not(&self.writer.value(truth)).text, None),
            Condition::Found(search) => (format!("_outcome{search} != _FOUND"), Some(format!("_detail{search}"))),
            Condition::Regular(system) => (
                format!("_system{system}.outcome != _FOUND"),
                Some(format!("_system{system}.detail")),
            ),
        };
        self.line(1, &format!("_failing = np.logical_and(_check < 0, {condition})"));
        self.line(1, "if np.any(_failing):");
        let before = self.pairs.clone();
        self.compute(&check.cold, 2);
        self.pairs = before;
        let margin = match (check.margin, detail) {
            (Some(margin), _) => self.writer.value(margin).text,
            (None, Some(detail)) => detail,
            (None, None) => "np.nan".to_string(),
        };
        self.line(2, &format!("_check = np.where(_failing, {index}, _check)"));
        self.line(2, &format!("_margin = np.where(_failing, {margin}, _margin)"));
    }

    fn search(&mut self, index: usize) {
        let search = &self.tape.searches[index];
        let given: Vec<String> = self
            .writer
            .given(index)
            .iter()
            .map(|value| self.writer.value(*value).text)
            .collect();
        // Inside, each is a parameter with a name of its own.
        let inner: Vec<String> = (0..given.len()).map(|place| format!("_g{place}")).collect();
        let outer = self.writer.given(index);
        let before = (self.pairs.clone(), self.writer.names_of(&outer));
        for (value, name) in outer.iter().zip(&inner) {
            self.writer.name(*value, name.clone());
        }
        self.line(0, "");
        let parameters = inner
            .iter()
            .map(|name| format!(", {name}: Array"))
            .collect::<Vec<_>>()
            .concat();
        self.line(
            1,
            &format!("def _equations{index}(_u: Array{parameters}) -> tuple[Array, Array]:"),
        );
        self.compute(&search.body, 2);
        let (residuals, jacobian) = (self.list(&search.residuals), self.rows(&search.jacobian));
        self.line(2, "_size = _u.shape[1]");
        self.line(
            2,
            &format!("return _stacked({residuals}, _size), _stacked({jacobian}, _size)"),
        );
        self.pairs = before.0;
        for (value, name) in outer.iter().zip(before.1) {
            self.writer.rename(*value, name);
        }
        let (guess, sizes) = (self.list(&search.guess), self.list(&search.sizes));
        self.line(0, "");
        self.line(1, &format!("_root{index}, _outcome{index}, _detail{index} = _newton("));
        self.line(2, &format!("_stacked({guess}, _poses),"));
        self.line(2, &format!("_stacked({sizes}, _poses),"));
        self.line(2, &format!("_equations{index},"));
        self.line(2, &format!("_stacked([{}], _poses),", given.join(", ")));
        self.line(2, "_check < 0,");
        self.line(1, ")");
    }

    fn steps(&mut self) {
        let tape = self.tape;
        let all: Vec<Value> = tape.steps.iter().filter_map(Step::computed).collect();
        let named = BTreeSet::from_iter(self.writer.named(&all, self.limit));
        for step in &tape.steps {
            match *step {
                Step::Compute(value) => {
                    if named.contains(&value) {
                        self.compute(&[value], 1);
                    }
                }
                Step::Check(index) => self.check(index),
                Step::Search(index) => self.search(index),
                Step::Factor(index) => {
                    let rows = self.rows(&tape.systems[index].rows);
                    self.line(1, &format!("_system{index} = _Factors(_stacked({rows}, _poses))"));
                }
                Step::Solve(index) => {
                    let solution = &tape.solutions[index];
                    let right = self.list(&solution.right);
                    let system = solution.system;
                    self.line(
                        1,
                        &format!("_solution{index} = _system{system}.solve(_stacked({right}, _poses))"),
                    );
                }
            }
        }
    }

    fn opening(&mut self) {
        let mut read = Vec::new();
        for entry in &self.signature.parameters {
            read.push((entry.places[0], format!("parameters[\"{}\"]", entry.name)));
        }
        for entry in &self.signature.inputs {
            for (order, place) in entry.places.iter().enumerate() {
                read.push((*place, format!("_rate(inputs[\"{}\"], {order})", entry.name)));
            }
        }
        for entry in &self.signature.near {
            read.push((entry.places[0], format!("assembly[\"{}\"]", entry.name)));
        }
        match self.signature.assemblies.as_slice() {
            [only] => read.push((only.places[0], "assembly".to_string())),
            several => {
                for entry in several {
                    read.push((entry.places[0], format!("assembly[\"{}\"]", entry.name)));
                }
            }
        }
        read.sort();
        self.line(1, "_given = np.broadcast_arrays(");
        for (_, text) in &read {
            self.line(2, &format!("{text},"));
        }
        self.line(1, ")");
        self.line(1, "_shape = _given[0].shape");
        self.line(1, "_given = [np.ravel(own).astype(np.float64) for own in _given]");
        self.line(1, "_poses = len(_given[0])");
        let names: Vec<String> = read.iter().map(|(place, _)| argument(*place)).collect();
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
        let value = |place: usize| self.tape.results[place].value;
        let mut entries: Vec<String> = Vec::new();
        for entry in &self.signature.results {
            let values: Vec<Value> = entry.places.iter().map(|place| value(*place)).collect();
            entries.push(format!("{}=_found({}),", entry.name, self.list(&values)));
        }
        for (name, list) in self.picture() {
            let rows: Vec<Vec<Value>> = list
                .iter()
                .map(|places| places.iter().map(|place| value(*place)).collect())
                .collect();
            entries.push(format!("{name}=_found({}),", self.rows(&rows)));
        }
        for entry in entries {
            self.line(2, &entry);
        }
        self.line(1, ")");
    }

    /// The parts of the skeleton that are there.
    fn picture(&self) -> impl Iterator<Item = (&'static str, &Vec<Vec<usize>>)> {
        let parts = [("joints", &self.signature.joints), ("slides", &self.signature.slides)];
        parts.into_iter().filter(|(_, list)| !list.is_empty())
    }

    pub(super) fn text(mut self) -> String {
        self.opening();
        self.steps();
        self.closing();
        let tape = self.tape;
        let mut text = docstring(&head(tape), "");
        text.push_str(
            "from __future__ import annotations\n\nfrom collections.abc import Callable, Mapping, Sequence\n",
        );
        text.push_str("from dataclasses import dataclass\nfrom typing import TypedDict\n\nimport numpy as np\nimport numpy.typing as npt\n\n");
        text.push_str("Array = npt.NDArray[np.float64]\n\n");
        text.push_str("#: The assemblies of a choice between two.\nOPEN, CROSSED = 1.0, -1.0\n\n");
        text.push_str(
            "#: The checks on the way to a pose: the subject of each, and the unknowns of its block.\nCHECKS = (\n",
        );
        for check in &tape.checks {
            text.extend([format!("    ({}, {}),\n", quoted(check.name), quoted(check.block))]);
        }
        text.push_str(")\n");
        text.push_str(&self.documentation());
        text.push_str("    with np.errstate(all=\"ignore\"):\n        return _solve(parameters, inputs, assembly)\n");
        text.push_str("\n\ndef _rate(motion: Sequence[npt.ArrayLike], order: int) -> npt.ArrayLike:\n    return motion[order] if order < len(motion) else 0.0\n");
        text.push_str(STACKED);
        text.push_str("\n\ndef _solve(parameters: Parameters, inputs: Inputs, assembly: Assembly) -> Pose:\n");
        text.push_str(&self.body);
        if tape
            .nodes
            .iter()
            .any(|node| matches!(node, Node::Call(Function::Round, _)))
        {
            text.push_str(ROUND);
        }
        let functions = runtime::python(Parts::of(tape));
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
        let mut define = |name: &str, of: &str, entries: &[Entry], kind: &str| {
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
        text.push_str("    #: The distance from passing: negative if something is out of reach by that much.\n    margin: Array\n");
        for entry in &signature.results {
            text.push_str(&documented("    ", &entry.text()));
            text.extend([format!("    {}: Array\n", entry.name)]);
        }
        for (name, _) in self.picture() {
            text.extend([format!("    #: The {name} of the skeleton: the first axes are the number and the coordinate.\n    {name}: Array\n")]);
        }
        text.push_str("\n\ndef solve(parameters: Parameters, inputs: Inputs, assembly: Assembly) -> Pose:\n");
        let of = [
            format!("The poses of the mechanism `{}`.", self.tape.description.name),
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

/// A string of the language.
fn quoted(text: &str) -> String {
    format!(
        "\"{}\"",
        lines(text, usize::MAX)
            .concat()
            .replace('\\', "\\\\")
            .replace('"', "\\\"")
    )
}
