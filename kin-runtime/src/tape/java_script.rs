//! A tape in JavaScript.

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
    "kinCount",
    "kinMotion",
    "kinMistake",
    "isRight",
    "constructor",
];

pub(super) struct JavaScript;

impl Dialect for JavaScript {
    const TARGET: Target = Target::JavaScript;

    fn number(&self, value: f64) -> Code {
        let size = value.abs();
        if value.is_nan() {
            return Code::whole("NaN");
        }
        let size_in_code = if size.is_infinite() {
            Code::whole("Infinity")
        } else {
            Code::whole(format!("{size:?}").trim_end_matches(".0"))
        };
        if value.is_sign_negative() {
            size_in_code.negated()
        } else {
            size_in_code
        }
    }

    fn truth(&self, holds: bool) -> Code {
        Code::whole(holds.to_string())
    }
}

impl Language for JavaScript {
    const INDENT: &'static str = "  ";
    const NAN: &'static str = "NaN";

    fn unknown(index: usize) -> String {
        format!("u$[{index}]")
    }

    fn root(search: usize, index: usize) -> String {
        format!("root{search}$.unknowns[{index}]")
    }

    fn solution(solution: usize, index: usize) -> String {
        format!("solution{solution}$[{index}]")
    }

    fn pair(angle: Value) -> [String; 2] {
        ["sine", "cosine"].map(|name| format!("{name}{}$", angle.0))
    }

    fn assignment(names: &[&str], value: &str) -> String {
        match names {
            [name] => format!("const {name} = {value};"),
            several => format!("const [{}] = {value};", several.join(", ")),
        }
    }

    fn sine_cosine(angle: &str) -> String {
        format!("kinSineCosine({angle})")
    }

    fn is_lost(search: usize) -> [String; 2] {
        ["code", "detail"].map(|part| format!("root{search}$.{part}"))
    }

    fn is_singular(system: usize) -> [String; 2] {
        ["code", "detail"].map(|part| format!("system{system}$.{part}"))
    }

    fn check(
        body: &mut FunctionBody<'_, Self>,
        index: usize,
        fails: &str,
        margin: impl FnOnce(&mut FunctionBody<'_, Self>) -> String,
    ) {
        body.line(1, &format!("if ({fails}) {{"));
        let margin = margin(body);
        body.line(2, &format!("return failed({index}, {margin});"));
        body.line(1, "}");
    }

    fn search(body: &mut FunctionBody<'_, Self>, index: usize) {
        let search = &body.tape.searches[index];
        let (guess, sizes) = (body.list(&search.guess), body.list(&search.sizes));
        body.line(
            1,
            &format!("const root{index}$ = kinNewton({guess}, {sizes}, (u$) => {{"),
        );
        body.within(&search.body);
        let (residuals, jacobian) = (body.list(&search.residuals), body.rows(&search.jacobian));
        body.line(2, &format!("return [{residuals}, {jacobian}];"));
        body.line(1, "});");
    }

    fn factor(body: &mut FunctionBody<'_, Self>, index: usize, rows: &str) {
        body.line(1, &format!("const system{index}$ = kinFactor({rows});"));
    }

    fn solve(body: &mut FunctionBody<'_, Self>, index: usize, system: usize, right: &str) {
        let text = format!("const solution{index}$ = kinSubstitute(system{system}$, {right});");
        body.line(1, &text);
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

impl Tape<'_> {
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
    /// The result is `{ok: true, pose}` with an array for each unknown and output, position first, and with `joints`
    /// and `slides` if the skeleton was asked for. Where the mechanism has no pose, it is
    /// `{ok: false, check, block, margin}`; the fields are those of a [`Stop`](crate::tape::Stop). Names are spelled in
    /// ASCII letters. A name that is missing or unknown, and what is neither `OPEN` nor `CROSSED`, throws a `TypeError`
    /// that says what to give.
    ///
    /// The numbers are those of `solve` in a build of this crate that does not fuse products, to the last bit, as long
    /// as angles stay below 10⁵. Inverse sines and cosines, hyperbolic functions, exponentials and logarithms are those
    /// of the platform. A tape in single precision is run in double precision.
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
        JavaScriptModule::new(self, None).text()
    }
}

/// The names in the module of [`Tape::java_script`], for programs that call it.
///
/// A quantity keeps its name if it is one of JavaScript, in ASCII letters; the parts of a point `p` are `p_x` and
/// `p_y`.
///
/// ```
/// use kin_core::library::FiveBar;
/// use kin_core::tape::{self, Options};
///
/// let names = tape::record::<FiveBar>(&Options::new())?.java_script_names();
/// assert_eq!(names.inputs, ["alpha", "beta"]);
/// assert_eq!(names.results, ["phi", "psi", "hand_x", "hand_y"]);
/// # Ok::<(), tape::RecordError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct JavaScriptNames {
    /// The members of `parameters`, in the order of the description; none if the dimensions are folded in.
    pub parameters: Vec<String>,
    /// The members of `inputs`.
    pub inputs: Vec<String>,
    /// The members of `assembly` that are values near the unknowns, in a mechanism with coupled blocks.
    pub near: Vec<String>,
    /// The members of `assembly` that choose between open and crossed. If there is only one, `assembly` is the choice
    /// itself.
    pub assemblies: Vec<String>,
    /// The members of `pose`: the unknowns, the outputs, and the partial derivatives if they are recorded.
    pub results: Vec<String>,
}

impl Tape<'_> {
    /// The names of all quantities in the module of [`java_script`](Self::java_script).
    #[must_use]
    pub fn java_script_names(&self) -> JavaScriptNames {
        let signature = Signature::new(self, TAKEN);
        JavaScriptNames {
            parameters: names(&signature.parameters),
            inputs: names(&signature.inputs),
            near: names(&signature.near),
            assemblies: names(&signature.assemblies),
            results: names(&signature.results),
        }
    }
}

fn names(entries: &[SignatureEntry<'_>]) -> Vec<String> {
    entries.iter().map(|entry| entry.name.clone()).collect()
}

/// A module while it is written.
pub(super) struct JavaScriptModule<'a> {
    signature: Signature<'a>,
    body: FunctionBody<'a, JavaScript>,
}

impl<'a> JavaScriptModule<'a> {
    pub(super) fn new(tape: &'a Tape<'a>, limit: Option<usize>) -> Self {
        let signature = Signature::new(tape, TAKEN);
        let mut arguments = std::vec![String::new(); tape.arguments.len()];
        // A name with a dollar sign is never that of a quantity.
        for entry in signature.parameters.iter().chain(&signature.inputs) {
            for (order, index) in entry.indices.iter().enumerate() {
                arguments[*index] = match order {
                    0 => entry.name.clone(),
                    _ => format!("{}${order}", entry.name),
                };
            }
        }
        for entry in signature.near.iter().chain(&signature.assemblies) {
            arguments[entry.indices[0]] = format!("{}$near", entry.name);
        }
        let body = FunctionBody::new(tape, JavaScript, limit, |index| arguments[index].clone());
        Self { signature, body }
    }

    fn line(&mut self, indent: usize, text: &str) {
        self.body.line(indent, text);
    }

    fn opening(&mut self) {
        let parameters = names(&self.signature.parameters);
        if !parameters.is_empty() {
            self.line(
                1,
                &format!("const {{ {} }} = parameters ?? {{}};", parameters.join(", ")),
            );
        }
        let mut numbers = parameters.clone();
        let mut tests = Vec::new();
        let inputs: Vec<(String, usize)> = self
            .signature
            .inputs
            .iter()
            .map(|entry| (entry.name.clone(), entry.indices.len()))
            .collect();
        for (name, orders) in &inputs {
            let rates = (1..*orders).map(|order| format!("{name}${order}"));
            let defaults: Vec<String> = rates.clone().map(|rate| format!(", {rate} = 0")).collect();
            self.line(
                1,
                &format!("const [{name}{}] = kinMotion(inputs?.{name});", defaults.concat()),
            );
            numbers.push(name.clone());
            numbers.extend(rates);
        }
        for name in names(&self.signature.near) {
            self.line(1, &format!("const {name}$near = assembly?.{name};"));
            numbers.push(format!("{name}$near"));
        }
        let choices = names(&self.signature.assemblies);
        for name in &choices {
            let member = if choices.len() == 1 {
                String::new()
            } else {
                format!("?.{name}")
            };
            self.line(1, &format!("const {name}$near = assembly{member};"));
            tests.push(format!("({name}$near === OPEN || {name}$near === CROSSED)"));
        }
        let count = |name: &str, count: usize| format!("kinCount({name}) === {count}");
        tests.push(count("parameters", parameters.len()));
        tests.push(count("inputs", inputs.len()));
        match self.signature.near.len() {
            0 if choices.len() > 1 => tests.push(count("assembly", choices.len())),
            0 => {}
            near => tests.push(count("assembly", near)),
        }
        tests.splice(0..0, numbers.iter().map(|name| format!("typeof {name} === \"number\"")));
        self.line(1, "const isRight =");
        let last = tests.len().saturating_sub(1);
        for (index, test) in tests.iter().enumerate() {
            self.line(2, &format!("{test}{}", if index == last { ";" } else { " &&" }));
        }
        self.line(1, "if (!isRight) throw kinMistake(parameters, inputs, assembly);");
    }

    fn closing(&mut self) {
        self.line(1, "const pose = {");
        for (name, list) in self.body.results(&self.signature) {
            self.line(2, &format!("{name}: {list},"));
        }
        self.line(1, "};");
        self.line(1, "return { ok: true, pose };");
    }

    pub(super) fn text(mut self) -> String {
        self.opening();
        self.body.steps();
        self.closing();
        let tape = self.body.tape;
        let mut text = comment(&head(tape), "");
        let parts = RuntimeParts::of(tape);
        let functions = runtime::java_script(parts);
        text.push_str(
            "\n/** The assemblies of a choice between two. */\nexport const OPEN = 1;\nexport const CROSSED = -1;\n",
        );
        text.push_str(
            "\n/** The checks on the way to a pose: the subject of each, and the unknowns of its block. \
            */\nexport const CHECKS = [\n",
        );
        for check in &tape.checks {
            text.extend([format!(
                "  {{ check: {}, block: {} }},\n",
                quoted(check.name),
                quoted(&tape.block_of(check).to_string())
            )]);
        }
        text.push_str("];\n");
        if !self.signature.joints.is_empty() {
            text.push_str(&outline(tape));
        }
        text.push('\n');
        text.push_str(&self.documentation());
        text.push_str("export function solve(parameters, inputs, assembly) {\n");
        text.push_str(&self.body.text);
        text.push_str("}\n\n");
        text.push_str(&self.arguments());
        text.push_str(
            "\n/**\n * @param {number} index\n * @param {number} margin\n * @returns {Failed}\n */\nfunction \
            failed(index, margin) {\n  return { ok: false, ...CHECKS[index], margin };\n}\n",
        );
        if tape
            .nodes
            .iter()
            .any(|node| matches!(node, TapeNode::Call(Function::Round, _)))
        {
            text.push_str(ROUND);
        }
        if !functions.is_empty() {
            text.push('\n');
            text.push_str(&functions);
        }
        text
    }

    /// The names of the arguments, and the code that reports mistakes in them.
    fn arguments(&self) -> String {
        let signature = &self.signature;
        let choices = match signature.assemblies.as_slice() {
            // the assembly is the choice itself
            [_] => &[],
            several => several,
        };
        let members = [
            ("parameters", signature.parameters.as_slice()),
            ("inputs", &signature.inputs),
            ("near", &signature.near),
            ("assemblies", choices),
        ];
        let members = members.map(|(name, entries)| {
            let entries: Vec<String> = entries.iter().map(|entry| quoted(&entry.name)).collect();
            format!("  {name}: [{}],\n", entries.join(", "))
        });
        format!(
            "/** The names in the arguments. */\nconst NAMES = {{\n{}}};\n\n{}",
            members.concat(),
            signature.argument_checks(runtime::JAVA_SCRIPT_ARGUMENTS)
        )
    }

    /// The types, and the documentation of the function.
    fn documentation(&self) -> String {
        let signature = &self.signature;
        let mut text = String::new();
        let mut define = |name: &str, of: &str, entries: &[SignatureEntry<'_>], kind: &str| {
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
            let rest = " * @property {number[][]} joints the coordinates of the joints of the skeleton\n * @property \
                {number[][]} slides the directions of its slides\n */\n\n";
            text.truncate(end);
            let end = text.trim_end_matches(' ').len();
            text.truncate(end);
            text.push_str(rest);
        }
        let failed = [
            "The check that failed, its block, and the distance from passing: negative if something is out of reach by \
             that much.",
            "@typedef {{ok: false, check: string, block: string, margin: number}} Failed",
        ];
        text.push_str(&comment(&failed.map(String::from), "*"));
        let solve = [
            format!(
                "The pose of the mechanism `{}`, or the check that failed.",
                self.body.tape.description.name
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

/// The parts of the picture that do not move, as a constant.
fn outline(tape: &Tape<'_>) -> String {
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
        "\n/** Which joints belong together, by their indices among the joints of a pose. */\nexport const OUTLINE = \
         {\n",
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
