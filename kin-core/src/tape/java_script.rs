//! A tape in JavaScript.

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
    "arguments",
    "await",
    "break",
    "case",
    "catch",
    "class",
    "const",
    "continue",
    "debugger",
    "default",
    "delete",
    "do",
    "else",
    "enum",
    "eval",
    "export",
    "extends",
    "false",
    "finally",
    "for",
    "function",
    "if",
    "implements",
    "import",
    "in",
    "instanceof",
    "interface",
    "let",
    "new",
    "null",
    "package",
    "private",
    "protected",
    "public",
    "return",
    "static",
    "super",
    "switch",
    "this",
    "throw",
    "true",
    "try",
    "typeof",
    "undefined",
    "var",
    "void",
    "while",
    "with",
    "yield",
    "async",
    "NaN",
    "Infinity",
    "Math",
    "Number",
    "Object",
    "DataView",
    "ArrayBuffer",
    "parameters",
    "inputs",
    "assembly",
    "joints",
    "slides",
    "solve",
    "failed",
    "OPEN",
    "CROSSED",
    "CHECKS",
    "OUTLINE",
    "kinBits",
    "kinSix",
    "kinTwelve",
    "kinSign",
    "kinSineCosine",
    "kinAtan2",
    "kinRound",
    "kinFactor",
    "kinSubstitute",
    "kinNewton",
    "kinPivots",
    "kinExponent",
    "kinScaled",
    "kinLevelling",
    "kinPowerOfTwo",
    "kinClamped",
    "kinLargest",
    "kinDistance",
    "kinIsRounding",
    "kinDistinct",
    "constructor",
];

struct JavaScript;

impl Dialect for JavaScript {
    fn number(&self, value: f64) -> Expression {
        let size = value.abs();
        if value.is_nan() {
            return Expression::whole("NaN");
        }
        let own = if size.is_infinite() {
            Expression::whole("Infinity")
        } else {
            Expression::whole(format!("{size:?}").trim_end_matches(".0"))
        };
        if value.is_sign_negative() { own.negated() } else { own }
    }

    fn truth(&self, holds: bool) -> Expression {
        Expression::whole(holds.to_string())
    }

    fn call(&self, function: Function, argument: &Expression) -> Expression {
        let name = match function {
            Function::Negate => return argument.negated(),
            Function::Magnitude => "Math.abs",
            Function::SquareRoot => "Math.sqrt",
            Function::Sine => "Math.sin",
            Function::Cosine => "Math.cos",
            Function::ArcSine => "Math.asin",
            Function::ArcCosine => "Math.acos",
            Function::ArcTangent => "Math.atan",
            Function::HyperbolicSine => "Math.sinh",
            Function::HyperbolicCosine => "Math.cosh",
            Function::HyperbolicTangent => "Math.tanh",
            Function::AreaHyperbolicSine => "Math.asinh",
            Function::AreaHyperbolicCosine => "Math.acosh",
            Function::AreaHyperbolicTangent => "Math.atanh",
            Function::Exponential => "Math.exp",
            Function::Logarithm => "Math.log",
            Function::Round => "kinRound",
            Function::Raise => "Math.ceil",
        };
        Expression::call(name, &[argument])
    }

    fn angle(&self, y: &Expression, x: &Expression) -> Expression {
        Expression::call("kinAtan2", &[y, x])
    }

    fn is_finite(&self, number: &Expression) -> Expression {
        Expression::call("Number.isFinite", &[number])
    }
}

/// The function that rounds halves away from zero, which `Math.round` does not.
const ROUND: &str = "
/**
 * The nearest integer; a half is rounded away from zero.
 * @param {number} number
 * @returns {number}
 */
function kinRound(number) {
  const whole = Math.trunc(number);
  return Math.abs(number - whole) >= 0.5 ? whole + Math.sign(number) : whole;
}
";

impl Tape {
    /// The solver as a JavaScript module without dependencies, for browsers and for node. Its types are documented for
    /// editors by JSDoc.
    ///
    /// The module exports `solve(parameters, inputs, assembly)`:
    ///
    /// - `parameters` is an object with the dimensions by name; it may be empty if they are folded in;
    /// - `inputs` is an object with an array for each input: its position, velocity and so on; missing rates are zero;
    /// - `assembly` is `OPEN` or `CROSSED`, an object with one of them for each of several choices, or an object with a
    ///   value near each unknown for a mechanism with coupled blocks.
    ///
    /// The result is `{ok: true, pose}` with an array for each unknown and output, position first, and with `joints` and
    /// `slides` if the skeleton was asked for. Where the mechanism has no pose, it is `{ok: false, check, block, margin}`;
    /// the fields are those of a [`Stop`](crate::tape::Stop). Names are spelled in ASCII letters.
    ///
    /// The numbers are those of `solve` in a build of this crate that does not fuse products, to the last bit, as long as
    /// angles stay below 10⁵. Inverse sines and cosines, hyperbolic functions, exponentials and logarithms are those of
    /// the platform. A tape in single precision is run in double precision.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::tape::{self, Options};
    ///
    /// let module = tape::record::<FourBar>(&Options::new().up_to(2))?.java_script();
    /// assert!(module.contains("export function solve(parameters, inputs, assembly)"));
    /// # Ok::<(), tape::RecordError>(())
    /// ```
    #[must_use]
    pub fn java_script(&self) -> String {
        Module::new(self, None).text()
    }
}

/// A module while it is written.
pub(super) struct Module<'a> {
    tape: &'a Tape,
    signature: Signature,
    writer: Writer<'a, JavaScript>,
    /// The longest operand without a name of its own.
    limit: Option<usize>,
    /// The sines and cosines that are there, by their angles.
    pairs: BTreeSet<Value>,
    body: String,
}

impl<'a> Module<'a> {
    pub(super) fn new(tape: &'a Tape, limit: Option<usize>) -> Self {
        let signature = Signature::new(tape, TAKEN);
        let mut writer = Writer::new(tape, JavaScript);
        let mut arguments = std::vec![String::new(); tape.arguments.len()];
        // A name with a dollar sign is never that of a quantity.
        for entry in signature.parameters.iter().chain(&signature.inputs) {
            for (order, place) in entry.places.iter().enumerate() {
                arguments[*place] = match order {
                    0 => entry.name.clone(),
                    _ => format!("{}${order}", entry.name),
                };
            }
        }
        for entry in signature.near.iter().chain(&signature.assemblies) {
            arguments[entry.places[0]] = format!("{}$near", entry.name);
        }
        for place in 0..tape.nodes.len() {
            let value = Value(u32::try_from(place).unwrap_or(u32::MAX));
            match tape.nodes[place] {
                Node::Argument(argument) => writer.name(value, arguments[argument].clone()),
                Node::Unknown { index, .. } => writer.name(value, format!("u$[{index}]")),
                Node::Root { search, index } => writer.name(value, format!("root{search}$.unknowns[{index}]")),
                Node::Solution { solution, index } => writer.name(value, format!("solution{solution}$[{index}]")),
                _ => {}
            }
        }
        Self {
            tape,
            signature,
            writer,
            limit,
            pairs: BTreeSet::new(),
            body: String::new(),
        }
    }

    fn line(&mut self, indent: usize, text: &str) {
        for _ in 0..indent {
            self.body.push_str("  ");
        }
        self.body.push_str(text);
        self.body.push('\n');
    }

    /// The nodes of a group, each as a constant.
    fn compute(&mut self, group: &[Value], indent: usize) {
        let tape = self.tape;
        for value in self.writer.named(group, self.limit) {
            if let Node::Call(Function::Sine | Function::Cosine, angle) = tape.nodes[value.index()] {
                if self.pairs.insert(angle) {
                    let argument = self.writer.value(angle).text;
                    self.line(
                        indent,
                        &format!("const [sine{0}$, cosine{0}$] = kinSineCosine({argument});", angle.0),
                    );
                }
                let is_sine = matches!(tape.nodes[value.index()], Node::Call(Function::Sine, _));
                let name = if is_sine { "sine" } else { "cosine" };
                self.writer.name(value, format!("{name}{}$", angle.0));
            } else {
                let text = self.writer.operation(value).text;
                self.line(indent, &format!("const {value} = {text};"));
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
            Condition::Holds(truth) => (self.writer.value(truth).not().text, None),
            Condition::Found(search) => (format!("root{search}$.code"), Some(format!("root{search}$.detail"))),
            Condition::Regular(system) => (format!("system{system}$.code"), Some(format!("system{system}$.detail"))),
        };
        self.line(1, &format!("if ({condition}) {{"));
        let before = self.pairs.clone();
        self.compute(&check.cold, 2);
        self.pairs = before;
        let margin = match (check.margin, detail) {
            (Some(margin), _) => self.writer.value(margin).text,
            (None, Some(detail)) => detail,
            (None, None) => "NaN".to_string(),
        };
        self.line(2, &format!("return failed({index}, {margin});"));
        self.line(1, "}");
    }

    fn search(&mut self, index: usize) {
        let search = &self.tape.searches[index];
        let (guess, sizes) = (self.list(&search.guess), self.list(&search.sizes));
        self.line(
            1,
            &format!("const root{index}$ = kinNewton({guess}, {sizes}, (u$) => {{"),
        );
        let before = self.pairs.clone();
        self.compute(&search.body, 2);
        self.pairs = before;
        let (residuals, jacobian) = (self.list(&search.residuals), self.rows(&search.jacobian));
        self.line(2, &format!("return [{residuals}, {jacobian}];"));
        self.line(1, "});");
    }

    fn steps(&mut self) {
        let tape = self.tape;
        // Between checks all nodes are one group.
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
                    self.line(1, &format!("const system{index}$ = kinFactor({rows});"));
                }
                Step::Solve(index) => {
                    let solution = &tape.solutions[index];
                    let right = self.list(&solution.right);
                    let text = format!(
                        "const solution{index}$ = kinSubstitute(system{}$, {right});",
                        solution.system
                    );
                    self.line(1, &text);
                }
            }
        }
    }

    fn opening(&mut self) {
        let read = |entries: &[Entry]| {
            entries
                .iter()
                .map(|entry| entry.name.clone())
                .collect::<Vec<_>>()
                .join(", ")
        };
        let parameters = read(&self.signature.parameters);
        if !parameters.is_empty() {
            self.line(1, &format!("const {{ {parameters} }} = parameters;"));
        }
        let inputs: Vec<(String, usize)> = self
            .signature
            .inputs
            .iter()
            .map(|entry| (entry.name.clone(), entry.places.len()))
            .collect();
        for (name, orders) in inputs {
            let rates: Vec<String> = (1..orders).map(|order| format!(", {name}${order} = 0")).collect();
            self.line(1, &format!("const [{name}{}] = inputs.{name};", rates.concat()));
        }
        let names = |entries: &[Entry]| entries.iter().map(|entry| entry.name.clone()).collect::<Vec<_>>();
        for name in names(&self.signature.near) {
            self.line(1, &format!("const {name}$near = assembly.{name};"));
        }
        let choices = names(&self.signature.assemblies);
        match choices.as_slice() {
            [only] => self.line(1, &format!("const {only}$near = assembly;")),
            several => {
                for name in several {
                    self.line(1, &format!("const {name}$near = assembly.{name};"));
                }
            }
        }
    }

    fn closing(&mut self) {
        self.line(1, "const pose = {");
        let value = |place: usize| self.tape.results[place].value;
        let mut entries: Vec<String> = Vec::new();
        for entry in &self.signature.results {
            let values: Vec<Value> = entry.places.iter().map(|place| value(*place)).collect();
            entries.push(format!("{}: {},", entry.name, self.list(&values)));
        }
        for (name, list) in [("joints", &self.signature.joints), ("slides", &self.signature.slides)] {
            if !list.is_empty() {
                let rows: Vec<Vec<Value>> = list
                    .iter()
                    .map(|places| places.iter().map(|place| value(*place)).collect())
                    .collect();
                entries.push(format!("{name}: {},", self.rows(&rows)));
            }
        }
        for entry in entries {
            self.line(2, &entry);
        }
        self.line(1, "};");
        self.line(1, "return { ok: true, pose };");
    }

    pub(super) fn text(mut self) -> String {
        self.opening();
        self.steps();
        self.closing();
        let tape = self.tape;
        let mut text = comment(&head(tape), "");
        let parts = Parts::of(tape);
        let functions = runtime::java_script(parts);
        text.push_str(
            "\n/** The assemblies of a choice between two. */\nexport const OPEN = 1;\nexport const CROSSED = -1;\n",
        );
        text.push_str("\n/** The checks on the way to a pose: the subject of each, and the unknowns of its block. */\nexport const CHECKS = [\n");
        for check in &tape.checks {
            text.extend([format!(
                "  {{ check: {}, block: {} }},\n",
                quoted(check.name),
                quoted(check.block)
            )]);
        }
        text.push_str("];\n");
        if !self.signature.joints.is_empty() {
            text.push_str(&outline(tape));
        }
        text.push('\n');
        text.push_str(&self.documentation());
        text.push_str("export function solve(parameters, inputs, assembly) {\n");
        text.push_str(&self.body);
        text.push_str("}\n\n/**\n * @param {number} index\n * @param {number} margin\n * @returns {Failed}\n */\nfunction failed(index, margin) {\n  return { ok: false, ...CHECKS[index], margin };\n}\n");
        if tape
            .nodes
            .iter()
            .any(|node| matches!(node, Node::Call(Function::Round, _)))
        {
            text.push_str(ROUND);
        }
        if !functions.is_empty() {
            text.push('\n');
            text.push_str(&functions);
        }
        text
    }

    /// The types, and the documentation of the function.
    fn documentation(&self) -> String {
        let signature = &self.signature;
        let mut text = String::new();
        let mut define = |name: &str, of: &str, entries: &[Entry], kind: &str| {
            let mut lines = Vec::from([of.to_string(), format!("@typedef {{object}} {name}")]);
            lines.extend(
                entries
                    .iter()
                    .map(|entry| format!("@property {{{kind}}} {} {}", entry.name, entry.text())),
            );
            text.push_str(&comment(&lines, "*"));
            text.push('\n');
        };
        define("Parameters", "The dimensions.", &signature.parameters, "number");
        define(
            "Inputs",
            "The inputs, each with its rates; missing rates are zero.",
            &signature.inputs,
            "number[]",
        );
        let assembly = if !signature.near.is_empty() {
            define(
                "Near",
                "A value near each unknown, which chooses one of several assemblies.",
                &signature.near,
                "number",
            );
            "Near"
        } else if signature.assemblies.len() > 1 {
            define(
                "Assembly",
                "The assembly of each choice: `OPEN` or `CROSSED`.",
                &signature.assemblies,
                "number",
            );
            "Assembly"
        } else {
            "number"
        };
        define("Pose", "What is found, position first.", &signature.results, "number[]");
        if !signature.joints.is_empty() {
            // The last type has two more fields.
            let end = text.trim_end_matches("*/\n\n").len();
            let rest = " * @property {number[][]} joints the coordinates of the joints of the skeleton\n * @property {number[][]} slides the directions of its slides\n */\n\n";
            text.truncate(end);
            let end = text.trim_end_matches(' ').len();
            text.truncate(end);
            text.push_str(rest);
        }
        let failed = [
            "The check that failed, its block, and the distance from passing: negative if something is out of reach by that much.",
            "@typedef {{ok: false, check: string, block: string, margin: number}} Failed",
        ];
        text.push_str(&comment(&failed.map(String::from), "*"));
        let solve = [
            format!(
                "The pose of the mechanism `{}`, or the check that failed.",
                self.tape.description.name
            ),
            "@param {Parameters} parameters".to_string(),
            "@param {Inputs} inputs".to_string(),
            format!("@param {{{assembly}}} assembly"),
            "@returns {{ok: true, pose: Pose} | Failed}".to_string(),
        ];
        text.push('\n');
        text.push_str(&comment(&solve, "*"));
        text
    }
}

/// Lines as a comment, with a second star for documentation.
fn comment(texts: &[String], star: &str) -> String {
    let mut text = format!("/*{star}\n");
    for line in texts {
        let indent = &line[..line.len() - line.trim_start().len()];
        let parts = lines(&line.replace("*/", "* /"), 112);
        for part in &parts {
            text.extend([format!(" * {indent}{part}\n")]);
        }
        if parts.is_empty() {
            text.push_str(" *\n");
        }
    }
    text.push_str(" */\n");
    text
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

/// The parts of the picture that do not move, as a constant.
fn outline(tape: &Tape) -> String {
    let outline = &tape.outline;
    let entry = |name: &str, items: Vec<String>| format!("  {name}: [{}],\n", items.join(", "));
    let bodies = outline
        .bodies
        .iter()
        .map(|body| format!("{{ name: {}, joints: {:?} }}", quoted(body.name), body.joints));
    let slides = outline.slides.iter().map(|slide| {
        let guide = slide.guide.map_or("null".to_string(), |guide| guide.to_string());
        format!("{{ joint: {}, guide: {guide} }}", slide.joint)
    });
    let points = outline
        .points
        .iter()
        .map(|(name, joint)| format!("{{ name: {}, joint: {joint} }}", quoted(name)));
    let mut text = String::from(
        "\n/** Which joints belong together, by their places among the joints of a pose. */\nexport const OUTLINE = {\n",
    );
    text.push_str(&entry(
        "ground",
        outline.ground.iter().map(std::string::ToString::to_string).collect(),
    ));
    text.push_str(&entry("bodies", bodies.collect()));
    text.push_str(&entry("slides", slides.collect()));
    text.push_str(&entry("points", points.collect()));
    text.push_str("};\n");
    text
}
