//! The bodies of the functions of a solver in C, statement by statement.

use std::collections::{BTreeMap, BTreeSet};
use std::format;
use std::string::{String, ToString as _};
use std::vec;
use std::vec::Vec;

use crate::tape::c::source::{Inherited, taken};
use crate::tape::c::{Text, comment};
use crate::tape::expression::Code;
use crate::tape::spelling::Target;
use crate::tape::stages::Stages;
use crate::tape::{Condition, Constant, Function, NumberType, TapeNode, TapeStep, Value};

/// Writes the body of a function.
pub(super) struct CWriter<'a> {
    text: &'a Text<'a>,
    /// The order that the function finds, with the orders of all steps and what goes from order to order.
    order: Option<(usize, &'a Stages, &'a Inherited)>,
    /// How often the function uses each value. A value that is used once may be written where it is used.
    uses: Vec<usize>,
    /// The values that are there, each as it is written.
    there: BTreeMap<Value, Code>,
    /// The arguments that are used.
    read: BTreeSet<usize>,
    /// The values that an earlier order has left.
    loaded: BTreeSet<Value>,
    factored: BTreeSet<usize>,
    indent: usize,
    body: String,
}

impl<'a> CWriter<'a> {
    pub(super) fn of_order(text: &'a Text<'a>, stages: &'a Stages, carried: &'a Inherited, order: usize) -> Self {
        let mut writer = Self::new(text, Some((order, stages, carried)));
        for value in taken(text.tape, stages, order) {
            writer.uses[value.index()] += 1;
        }
        // What is used in a branch, or later, has a name.
        for check in text
            .tape
            .checks
            .iter()
            .filter(|check| stages.of_order(check.order) == order)
        {
            for value in &check.cold {
                text.tape.nodes[value.index()].operands(|operand| writer.uses[operand.index()] += 2);
            }
            if let Some(margin) = check.margin {
                writer.uses[margin.index()] += 2;
            }
        }
        for value in &carried.values {
            writer.uses[value.index()] += 2;
        }
        writer
    }

    pub(super) fn of_search(text: &'a Text<'a>, search: usize) -> Self {
        let mut writer = Self::new(text, None);
        let sought = &text.tape.searches[search];
        for value in &sought.body {
            text.tape.nodes[value.index()].operands(|operand| writer.uses[operand.index()] += 1);
        }
        for value in sought.residuals.iter().chain(sought.jacobian.iter().flatten()) {
            writer.uses[value.index()] += 1;
        }
        writer
    }

    fn new(text: &'a Text<'a>, order: Option<(usize, &'a Stages, &'a Inherited)>) -> Self {
        Self {
            text,
            order,
            uses: vec![0; text.tape.nodes.len()],
            there: BTreeMap::new(),
            read: BTreeSet::new(),
            loaded: BTreeSet::new(),
            factored: BTreeSet::new(),
            indent: 4,
            body: String::new(),
        }
    }

    fn line(&mut self, line: &str) {
        self.body.push_str(&" ".repeat(self.indent));
        self.body.push_str(line);
        self.body.push('\n');
    }

    /// A constant in the number type.
    fn constant(&self, value: f64) -> Code {
        Code::constant(Constant::new(value), self.text.tape.precision)
    }

    /// The function of an order. Results go to `target`.
    pub(super) fn order(mut self, target: &str) -> String {
        let Some((order, stages, carried)) = self.order else {
            return String::new();
        };
        let (text, tape) = (self.text, self.text.tape);
        if order == 0 {
            self.assemblies();
        }
        for step in tape.steps.iter().filter(|step| stages.of_step(tape, **step) == order) {
            self.step(*step);
        }
        for (result, field) in tape.results.iter().zip(&text.results) {
            if stages.of_order(result.order) == order {
                let value = self.expression(result.value).text;
                self.line(&format!("{target}{field} = {value};"));
            }
        }
        for (index, value) in carried.values.iter().enumerate() {
            if stages.of(*value) == order {
                let code = self.expression(*value);
                let code = if tape.nodes[value.index()].is_truth() {
                    code.select(&self.constant(1.0), &self.constant(0.0))
                } else {
                    code
                };
                self.line(&format!("chain->carried[{index}] = {};", code.text));
            }
        }
        let closed = format!("{}_CLOSED", text.upper);
        self.leave(&closed, &self.constant(0.0).text);
        let mut start = String::new();
        let number = text.number;
        for argument in &self.read {
            start.push_str(&format!(
                "    const {number} {} = {};\n",
                text.arguments[*argument],
                text.member_of(*argument)
            ));
        }
        for value in &self.loaded {
            let index = carried.index_of(*value).unwrap_or_default();
            if tape.nodes[value.index()].is_truth() {
                let half = self.constant(0.5).text;
                start.push_str(&format!("    const int {value} = chain->carried[{index}] > {half};\n"));
            } else {
                start.push_str(&format!("    const {number} {value} = chain->carried[{index}];\n"));
            }
        }
        for (structure, members) in text.structures() {
            if !members.iter().any(|member| self.read.contains(member)) {
                start.push_str(&format!("    (void){structure};\n"));
            }
        }
        start + &self.body
    }

    /// Leaves the function if a choice is neither open nor crossed.
    fn assemblies(&mut self) {
        let text = self.text;
        let [open, crossed] = [1.0, -1.0].map(|sign| self.constant(sign).text);
        for index in text.choices() {
            self.read.insert(index);
            let sign = &text.arguments[index];
            self.line(&format!("if (!({sign} == {open} || {sign} == {crossed})) {{"));
            self.indent = 8;
            self.leave(&format!("{}_NO_ASSEMBLY", text.upper), sign);
            self.indent = 4;
            self.line("}");
        }
    }

    /// The function of the equations of a search.
    pub(super) fn equations(mut self, search: usize) -> String {
        let (number, tape) = (self.text.number, self.text.tape);
        let sought = &tape.searches[search];
        let given = tape.given(search);
        if given.is_empty() {
            self.line("(void)given;");
        } else {
            self.line(&format!("const {number} *const values = (const {number} *)given;"));
        }
        for (index, value) in given.into_iter().enumerate() {
            if tape.nodes[value.index()].is_truth() {
                let half = self.constant(0.5).text;
                self.line(&format!("const int {value} = values[{index}] > {half};"));
            } else {
                self.line(&format!("const {number} {value} = values[{index}];"));
            }
            self.there.insert(value, Code::whole(value.to_string()));
        }
        for value in &sought.body {
            self.compute(*value);
        }
        for (row, value) in sought.residuals.iter().enumerate() {
            let code = self.expression(*value).text;
            self.line(&format!("residuals[{row}] = {code};"));
        }
        for (row, entries) in sought.jacobian.iter().enumerate() {
            for (column, value) in entries.iter().enumerate() {
                let code = self.expression(*value).text;
                self.line(&format!("jacobian[{row}][{column}] = {code};"));
            }
        }
        self.body
    }

    fn step(&mut self, step: TapeStep) {
        match step {
            TapeStep::Compute(value) => self.compute(value),
            TapeStep::Check(check) => self.check(check),
            TapeStep::Search(search) => self.search(search),
            TapeStep::Factor(system) => self.factor(system),
            TapeStep::Solve(solution) => self.solve(solution),
        }
    }

    /// Computes a value, or puts it off to where it is used.
    fn compute(&mut self, value: Value) {
        if self.there.contains_key(&value) {
            return;
        }
        let node = self.text.tape.nodes[value.index()];
        if let TapeNode::Call(Function::Sine | Function::Cosine, angle) = node {
            self.sine_cosine(value, angle);
            return;
        }
        let code = self.written(node);
        if self.uses[value.index()] == 1 && code.text.len() <= self.text.width {
            self.there.insert(value, code);
            return;
        }
        let kind = if node.is_truth() { "int" } else { self.text.number };
        self.line(&format!("const {kind} {value} = {};", code.text));
        self.there.insert(value, Code::whole(value.to_string()));
    }

    /// Sine and cosine of an angle together.
    fn sine_cosine(&mut self, value: Value, angle: Value) {
        let tape = self.text.tape;
        let is_sine = matches!(tape.nodes[value.index()], TapeNode::Call(Function::Sine, _));
        let other = if is_sine { Function::Cosine } else { Function::Sine };
        let is_other = |node: &TapeNode| *node == TapeNode::Call(other, angle);
        let other = tape
            .nodes
            .iter()
            .position(is_other)
            .and_then(|index| u32::try_from(index).ok())
            .map(Value);
        // A partner that another function finds has its name there.
        let partner = other.filter(|other| !self.there.contains_key(other) && !self.is_left(*other));
        let number = self.text.number;
        let other = partner.map_or_else(|| format!("{value}_other"), |partner| partner.to_string());
        self.line(&format!("{number} {value};"));
        self.line(&format!("{number} {other};"));
        let angle = self.expression(angle).text;
        let name = value.to_string();
        let (sine, cosine) = if is_sine { (&name, &other) } else { (&other, &name) };
        self.line(&format!("kin_sine_cosine({angle}, &{sine}, &{cosine});"));
        for value in [Some(value), partner].into_iter().flatten() {
            self.there.insert(value, Code::whole(value.to_string()));
        }
    }

    /// Whether an earlier order leaves a value.
    fn is_left(&self, value: Value) -> bool {
        self.order.is_some_and(|(order, stages, _)| stages.of(value) < order)
    }

    /// A value as it is written where it is used.
    fn expression(&mut self, value: Value) -> Code {
        if let Some(code) = self.there.get(&value) {
            return code.clone();
        }
        match self.text.tape.nodes[value.index()] {
            TapeNode::Argument(argument) => {
                self.read.insert(argument);
                Code::whole(self.text.arguments[argument].clone())
            }
            TapeNode::Constant(constant) => Code::constant(constant, self.text.tape.precision),
            TapeNode::Certain(truth) => Code::whole(if truth { "1" } else { "0" }),
            TapeNode::Unknown { index, .. } => Code::whole(format!("unknowns[{index}]")),
            _ if self.is_left(value) => {
                self.loaded.insert(value);
                Code::whole(value.to_string())
            }
            TapeNode::Root { search, index } => Code::whole(format!("roots_{search}[{index}]")),
            TapeNode::Solution { solution, index } => Code::whole(format!("solution_{solution}[{index}]")),
            node => self.written(node),
        }
    }

    fn written(&mut self, node: TapeNode) -> Code {
        let is_single = self.text.tape.precision == NumberType::Single;
        match node {
            // The function of `<math.h>` for `float`.
            TapeNode::Call(function, one) if is_single && function != Function::Negate => {
                let name = format!("{}f", node.spelling(Target::C));
                Code::call(&name, &[self.expression(one)])
            }
            TapeNode::IsFinite(one) => {
                let largest = if is_single { "FLT_MAX" } else { "DBL_MAX" };
                let size = self.written(TapeNode::Call(Function::Magnitude, one));
                Code::whole(largest).compared(">=", &size)
            }
            node => node.written(Target::C, |operand| self.expression(operand)),
        }
    }

    fn check(&mut self, index: usize) {
        let check = &self.text.tape.checks[index];
        let about = comment("    ", &format!("{} ({})", check.name, self.text.tape.block_of(check)));
        self.body.push_str(&about);
        let fails = match check.condition {
            Condition::Holds(truth) => self.expression(truth).not().text,
            Condition::Found(search) => format!("found_{search} != KIN_FOUND"),
            Condition::Regular(system) => format!("regular_{system} != KIN_FOUND"),
        };
        self.line(&format!("if ({fails}) {{"));
        self.indent = 8;
        // The names of the branch are used there only, and what it uses once is written there.
        let (before, uses) = (self.there.clone(), self.uses.clone());
        for value in &check.cold {
            self.uses[value.index()] = 0;
        }
        for value in &check.cold {
            let node = self.text.tape.nodes[value.index()];
            node.operands(|operand| self.uses[operand.index()] += 1);
        }
        if let Some(margin) = check.margin {
            self.uses[margin.index()] += 1;
        }
        for value in &check.cold {
            self.compute(*value);
        }
        let margin = match (check.margin, check.condition) {
            (Some(margin), _) => self.expression(margin).text,
            (None, Condition::Found(search)) => format!("detail_of_search_{search}"),
            (None, Condition::Regular(system)) => format!("detail_of_system_{system}"),
            (None, Condition::Holds(_)) => "NAN".to_string(),
        };
        self.leave(&self.text.codes[index], &margin);
        (self.there, self.uses) = (before, uses);
        self.indent = 4;
        self.line("}");
    }

    /// Leaves the function with a code.
    fn leave(&mut self, code: &str, margin: &str) {
        self.line(&format!("return ({}_outcome){{{code}, {margin}}};", self.text.name));
    }

    /// Values as the entries of an array. Truths are 1 and 0.
    fn array(&mut self, values: &[Value]) -> String {
        let entries: Vec<String> = values
            .iter()
            .map(|value| {
                let code = self.expression(*value);
                if self.text.tape.nodes[value.index()].is_truth() {
                    code.select(&self.constant(1.0), &self.constant(0.0)).text
                } else {
                    code.text
                }
            })
            .collect();
        entries.join(", ")
    }

    fn search(&mut self, index: usize) {
        let (number, tape) = (self.text.number, self.text.tape);
        let sought = &tape.searches[index];
        let count = sought.guess.len();
        let given = tape.given(index);
        let (guess, sizes) = (self.array(&sought.guess), self.array(&sought.sizes));
        self.line(&format!("const {number} guess_{index}[{count}] = {{{guess}}};"));
        self.line(&format!("const {number} sizes_{index}[{count}] = {{{sizes}}};"));
        let mut given_array = "0".to_string();
        if !given.is_empty() {
            given_array = format!("given_{index}");
            let values = self.array(&given);
            self.line(&format!(
                "const {number} {given_array}[{}] = {{{values}}};",
                given.len()
            ));
        }
        let name = &self.text.name;
        let block = format!(
            "const kin_block block_{index} = {{{count}, {name}_equations_{index}, {given_array}, sizes_{index}}};"
        );
        self.line(&block);
        self.line(&format!("{number} roots_{index}[{count}];"));
        self.line(&format!("{number} detail_of_search_{index};"));
        let call = format!("kin_newton(&block_{index}, guess_{index}, roots_{index}, &detail_of_search_{index})");
        self.line(&format!("const int found_{index} = {call};"));
    }

    fn factor(&mut self, index: usize) {
        if !self.factored.insert(index) {
            return;
        }
        let (number, tape) = (self.text.number, self.text.tape);
        let rows = &tape.systems[index].rows;
        self.line(&format!("kin_factors factors_{index};"));
        self.line(&format!("{number} detail_of_system_{index};"));
        for (row, entries) in rows.iter().enumerate() {
            for (column, value) in entries.iter().enumerate() {
                let code = self.expression(*value).text;
                self.line(&format!("factors_{index}.entries[{row}][{column}] = {code};"));
            }
        }
        let call = format!(
            "kin_factor({}, &factors_{index}, 0, &detail_of_system_{index})",
            rows.len()
        );
        // A later order factors the same matrix again, and knows that it is regular.
        if self
            .order
            .is_some_and(|(order, stages, _)| stages.of_system(index) == order)
        {
            self.line(&format!("const int regular_{index} = {call};"));
        } else {
            self.line(&format!("(void){call};"));
        }
    }

    fn solve(&mut self, index: usize) {
        let (number, tape) = (self.text.number, self.text.tape);
        let solution = &tape.solutions[index];
        self.factor(solution.system);
        let (count, right) = (solution.right.len(), self.array(&solution.right));
        self.line(&format!("const {number} right_{index}[{count}] = {{{right}}};"));
        self.line(&format!("{number} solution_{index}[{count}];"));
        let system = solution.system;
        self.line(&format!(
            "kin_substitute({count}, &factors_{system}, right_{index}, solution_{index});"
        ));
    }
}
