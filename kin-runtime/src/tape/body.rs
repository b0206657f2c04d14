//! The body of a function while it is written, in JavaScript or Python.

use std::collections::BTreeSet;
use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::tape::signature::Signature;
use crate::tape::structure::Tape;
use crate::tape::writer::{Dialect, Writer};
use crate::tape::{Condition, Function, TapeNode, TapeStep, Value};

/// The ways in which a language writes statements.
pub(super) trait Language: Dialect + Sized {
    /// One level of indentation.
    const INDENT: &'static str;

    /// A number that is none.
    const NAN: &'static str;

    /// The unknown of a search, within its equations.
    fn unknown(index: usize) -> String;

    /// The number that a search has found.
    fn root(search: usize, index: usize) -> String;

    /// The number that solves a linear system.
    fn solution(solution: usize, index: usize) -> String;

    /// The names of the sine and of the cosine of an angle.
    fn pair(angle: Value) -> [String; 2];

    /// Gives a name to a value, or names to several.
    fn assignment(names: &[&str], value: &str) -> String;

    /// Sine and cosine together.
    fn sine_cosine(angle: &str) -> String;

    /// The condition on which a search has found nothing, and its residual.
    fn is_lost(search: usize) -> [String; 2];

    /// The condition on which a linear system is singular, and its determinant.
    fn is_singular(system: usize) -> [String; 2];

    /// Writes a check that fails under a condition.
    fn check(
        body: &mut FunctionBody<'_, Self>,
        index: usize,
        fails: &str,
        margin: impl FnOnce(&mut FunctionBody<'_, Self>) -> String,
    );

    /// Writes a search.
    fn search(body: &mut FunctionBody<'_, Self>, index: usize);

    /// The factors of a matrix.
    fn factor(body: &mut FunctionBody<'_, Self>, index: usize, rows: &str);

    /// The solution of a linear system.
    fn solve(body: &mut FunctionBody<'_, Self>, index: usize, system: usize, right: &str);
}

/// The body of a function.
pub(super) struct FunctionBody<'a, L> {
    pub(super) tape: &'a Tape<'a>,
    pub(super) writer: Writer<'a, L>,
    /// The longest operand without a name.
    limit: Option<usize>,
    /// The sines and cosines that are there, by their angles.
    pairs: BTreeSet<Value>,
    pub(super) text: String,
}

impl<'a, L: Language> FunctionBody<'a, L> {
    /// A body in which the arguments have these names.
    pub(super) fn new(
        tape: &'a Tape<'a>,
        language: L,
        limit: Option<usize>,
        argument: impl Fn(usize) -> String,
    ) -> Self {
        let mut writer = Writer::new(tape, language);
        for (index, node) in tape.nodes.iter().enumerate() {
            let name = match *node {
                TapeNode::Argument(index) => argument(index),
                TapeNode::Unknown { index, .. } => L::unknown(index),
                TapeNode::Root { search, index } => L::root(search, index),
                TapeNode::Solution { solution, index } => L::solution(solution, index),
                _ => continue,
            };
            writer.name(Value(u32::try_from(index).unwrap_or(u32::MAX)), name);
        }
        Self {
            tape,
            writer,
            limit,
            pairs: BTreeSet::new(),
            text: String::new(),
        }
    }

    pub(super) fn line(&mut self, indent: usize, text: &str) {
        for _ in 0..indent {
            self.text.push_str(L::INDENT);
        }
        self.text.push_str(text);
        self.text.push('\n');
    }

    /// Computes a node, and gives it a name.
    fn compute(&mut self, value: Value, indent: usize) {
        let TapeNode::Call(function @ (Function::Sine | Function::Cosine), angle) = self.tape.nodes[value.index()]
        else {
            let (name, text) = (value.to_string(), self.writer.operation(value).text);
            self.line(indent, &L::assignment(&[&name], &text));
            self.writer.name(value, name);
            return;
        };
        let [sine, cosine] = L::pair(angle);
        if self.pairs.insert(angle) {
            let both = L::sine_cosine(&self.writer.value(angle).text);
            self.line(indent, &L::assignment(&[&sine, &cosine], &both));
        }
        let is_sine = function == Function::Sine;
        self.writer.name(value, if is_sine { sine } else { cosine });
    }

    /// Computes the nodes of a branch or of an inner function, whose sines and cosines nothing else uses.
    pub(super) fn within(&mut self, group: &[Value]) {
        let before = self.pairs.clone();
        for value in self.writer.named(group, self.limit) {
            self.compute(value, 2);
        }
        self.pairs = before;
    }

    pub(super) fn list(&self, values: &[Value]) -> String {
        let texts: Vec<String> = values.iter().map(|value| self.writer.value(*value).text).collect();
        format!("[{}]", texts.join(", "))
    }

    pub(super) fn rows(&self, rows: &[Vec<Value>]) -> String {
        let rows: Vec<String> = rows.iter().map(|row| self.list(row)).collect();
        format!("[{}]", rows.join(", "))
    }

    /// The results, each with its name and its list of numbers. Those of the skeleton are lists of lists.
    pub(super) fn results(&self, signature: &Signature<'_>) -> Vec<(String, String)> {
        let values = |indices: &Vec<usize>| -> Vec<Value> {
            let results = indices.iter().map(|index| &self.tape.results[*index]);
            results.map(|result| result.value).collect()
        };
        let quantities = signature.results.iter();
        let quantities = quantities.map(|entry| (entry.name.clone(), self.list(&values(&entry.indices))));
        let picture = signature.picture().map(|(name, list)| {
            let rows: Vec<Vec<Value>> = list.iter().map(values).collect();
            (name.to_string(), self.rows(&rows))
        });
        quantities.chain(picture).collect()
    }

    fn check(&mut self, index: usize) {
        let check = &self.tape.checks[index];
        let (fails, detail) = match check.condition {
            Condition::Holds(truth) => {
                let fails = TapeNode::Not(truth).written(L::TARGET, |truth| self.writer.value(truth));
                (fails.text, L::NAN.to_string())
            }
            Condition::Found(search) => L::is_lost(search).into(),
            Condition::Regular(system) => L::is_singular(system).into(),
        };
        L::check(self, index, &fails, |body| {
            body.within(&check.cold);
            check.margin.map_or(detail, |margin| body.writer.value(margin).text)
        });
    }

    /// All steps of the tape.
    pub(super) fn steps(&mut self) {
        let tape = self.tape;
        // Between checks all nodes are one group.
        let all: Vec<Value> = tape.steps.iter().filter_map(TapeStep::computed).collect();
        let named = BTreeSet::from_iter(self.writer.named(&all, self.limit));
        for step in &tape.steps {
            match *step {
                TapeStep::Compute(value) if named.contains(&value) => self.compute(value, 1),
                TapeStep::Compute(_) => {}
                TapeStep::Check(index) => self.check(index),
                TapeStep::Search(index) => L::search(self, index),
                TapeStep::Factor(index) => {
                    let rows = self.rows(&tape.systems[index].rows);
                    L::factor(self, index, &rows);
                }
                TapeStep::Solve(index) => {
                    let solution = &tape.solutions[index];
                    let right = self.list(&solution.right);
                    L::solve(self, index, solution.system, &right);
                }
            }
        }
    }
}
