//! The documentation of generated items: the decisions of the compiler, in the terms of kinematics.

use crate::algebra::Symbol;
use crate::describe;
use crate::emit::compiled::Compiled;
use crate::model::{Dimension, Quantity, Unknown};
use crate::program::Cost;
use crate::structure::{Arm, Block, ClosedForm, Method, Part};

impl Compiled<'_> {
    /// The equations as a list of code lines.
    pub(in crate::emit) fn equation_lines(&self) -> Vec<String> {
        self.model
            .equations
            .iter()
            .map(|equation| format!(" - `{}`", equation.text))
            .collect()
    }

    /// The blocks and their closed forms, as a list.
    pub(in crate::emit) fn block_lines(&self) -> Vec<String> {
        self.blocks
            .iter()
            .map(|block| format!(" - `{}`: {}", self.names(&block.unknowns), self.solution(block)))
            .collect()
    }

    /// The note that some formulas were too large to be multiplied out before they are differentiated.
    pub(in crate::emit) fn form_lines(&self) -> Vec<String> {
        if !self.solvers.is_form_given_up {
            return Vec::new();
        }
        let line = " Some equations or outputs would be too large if multiplied out. Their products are left when they \
                    are differentiated.";
        vec![String::new(), line.to_owned()]
    }

    /// The solution of a block, part by part.
    pub(in crate::emit) fn solution(&self, block: &Block) -> String {
        describe::solution(self.model, &self.solvers.graph, block)
    }

    /// The solution of a part.
    pub(in crate::emit) fn solution_of_part(&self, part: &Part) -> String {
        describe::solution_of_part(&self.solvers.graph, part)
    }

    /// The meaning of open and crossed for a part.
    pub(in crate::emit) fn choice_documentation(&self, part: usize) -> Vec<String> {
        vec![
            format!(
                " The block of `{}`: {}.",
                self.part_name(part),
                self.solution_of_part(self.parts()[part])
            ),
            String::new(),
            format!(" Open if {}. Crossed otherwise.", self.open_in_words(part)),
        ]
    }

    /// The condition of a part's open assembly in words, if there are words for it, and in symbols.
    pub(in crate::emit) fn open_in_words(&self, part: usize) -> String {
        let symbols = format!("`{}`", self.criterion(part));
        match &self.parts()[part].method {
            Method::Closed(form) => match self.words(form, part) {
                Some(words) => format!("{words}: {symbols}"),
                None => symbols,
            },
            Method::Newton { .. } => symbols,
        }
    }

    fn words(&self, form: &ClosedForm, part: usize) -> Option<String> {
        let name = |unknown: &usize| &self.model.unknowns[*unknown].name;
        Some(match form {
            ClosedForm::Linear { .. }
            | ClosedForm::LinearPair { .. }
            | ClosedForm::LinearSystem { .. }
            | ClosedForm::Direction { .. } => return None,
            ClosedForm::Inverse { then, .. } => return self.words(then, part),
            ClosedForm::SquareRoot { unknown, .. } => format!("`{}` is positive", name(unknown)),
            ClosedForm::Polar { length, offset, .. } if self.solvers.graph.is_zero(offset.re) => {
                format!("`{}` is positive", name(length))
            }
            ClosedForm::Quadratic { unknown, .. }
            | ClosedForm::EvenInverse { unknown, .. }
            | ClosedForm::AngleLength { length: unknown, .. }
            | ClosedForm::Polar { length: unknown, .. } => {
                format!("`{}` is the larger of its two solutions", name(unknown))
            }
            ClosedForm::CosineSine { unknown, .. } => {
                format!(
                    "`{}` is less than half a turn ahead of its other solution",
                    name(unknown)
                )
            }
            ClosedForm::InverseCosine { unknown, .. } => {
                format!("`{}` is between zero and half a turn", name(unknown))
            }
            ClosedForm::InverseSine { unknown, .. } => {
                format!("`{}` is within a quarter turn of zero", name(unknown))
            }
            ClosedForm::TwoAngles { arms, .. } => return self.turn_of_links(arms, part),
        })
    }

    /// Which of two links is turned clockwise from the other in the open assembly, if all lengths are positive. `None`
    /// if the angles are not simply the directions of the links.
    fn turn_of_links(&self, arms: &[Arm; 2], part: usize) -> Option<String> {
        let graph = &self.solvers.graph;
        let orientation = self.solvers.choices[part].orientation?;
        let [Some(first), Some(second)] = arms.each_ref().map(|arm| match arm.angle.0[..] {
            [(Symbol::Unknown(angle), 1)] if !arm.mirrored && arm.factor.is_real(graph) => Some(angle),
            _ => None,
        }) else {
            return None;
        };
        // with the second angle a quarter turn ahead of the first
        let quarter = graph.evaluate(orientation, &|symbol| match symbol {
            Symbol::Unknown(angle) if angle == first => 0.0,
            Symbol::Unknown(angle) if angle == second => std::f64::consts::FRAC_PI_2,
            _ => 1.0,
        });
        let links = [(first, &arms[0]), (second, &arms[1])].map(|(angle, arm)| {
            let angle = &self.model.unknowns[angle].name;
            match self.link_name(arm) {
                Some(link) => format!("the link `{link}` at `{angle}`"),
                None => format!("the direction `{angle}`"),
            }
        });
        let [behind, ahead] = if quarter > 0.0 {
            [&links[0], &links[1]]
        } else if quarter < 0.0 {
            [&links[1], &links[0]]
        } else {
            return None;
        };
        Some(format!(
            "{behind} is turned clockwise from {ahead}, by less than half a turn"
        ))
    }

    /// The parameter that is a link's length.
    fn link_name(&self, arm: &Arm) -> Option<String> {
        let graph = &self.solvers.graph;
        let scalars = self.scalar_parameters();
        (0..scalars.len()).find_map(|index| {
            let is_own = graph.is_signed_symbol(arm.factor.re, Symbol::Parameter(index));
            is_own.then(|| scalars[index].0.clone())
        })
    }

    /// The meaning of the assembly as a separate paragraph; nothing if there is no choice.
    pub(in crate::emit) fn assembly_lines(&self) -> Vec<String> {
        let lines: Vec<String> = self
            .choices()
            .into_iter()
            .map(|part| format!(" - `{}`: open if `{}`", self.part_name(part), self.criterion(part)))
            .collect();
        if lines.is_empty() {
            return lines;
        }
        [String::new(), " Assemblies:".to_owned()]
            .into_iter()
            .chain(lines)
            .collect()
    }

    /// The condition that holds in a part's open assembly.
    fn criterion(&self, part: usize) -> String {
        let names = |symbol: Symbol| self.solvers.names().of(symbol).to_owned();
        self.solvers.choices[part].orientation.map_or_else(String::new, |node| {
            format!("{} > 0", self.solvers.graph.print(node, &names))
        })
    }

    /// The description of an unknown.
    pub(in crate::emit) fn unknown_line(&self, index: usize) -> String {
        let unknown = &self.model.unknowns[index];
        let part = self
            .parts()
            .into_iter()
            .find(|part| part.unknowns.contains(&index))
            .expect("every unknown is solved in a part of a block");
        let with: Vec<String> = part
            .unknowns
            .iter()
            .filter(|&&other| other != index)
            .map(|&other| format!("`{}`", self.model.unknowns[other].name))
            .collect();
        let company = if with.is_empty() {
            String::new()
        } else {
            format!(", together with {}", with.join(", "))
        };
        let range = unknown
            .range
            .as_ref()
            .map_or_else(String::new, |range| format!(", `{}`", range.text));
        format!(
            " Unknown: {}{range}. Solution: {}{company}.",
            unit(unknown.dimension),
            self.solution_of_part(part)
        )
    }

    /// The cost of a solver, as a line.
    pub(in crate::emit) fn cost_line(&self, order: usize) -> String {
        cost_line(self.solvers.orders()[order].cost)
    }

    /// The inputs' names and units, for a method's documentation.
    pub(in crate::emit) fn input_line(&self) -> String {
        let inputs: Vec<String> = self
            .model
            .inputs
            .iter()
            .map(|Quantity { name, dimension, .. }| format!("`{name}` ({})", unit(*dimension)))
            .collect();
        inputs.join(", ")
    }

    /// The unknowns' names, in order.
    pub(in crate::emit) fn unknown_order(&self) -> String {
        let names: Vec<String> = self
            .model
            .unknowns
            .iter()
            .map(|Unknown { name, .. }| name.to_string())
            .collect();
        names.join(", ")
    }
}

/// A dimension with its unit.
pub(in crate::emit) const fn unit(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Length => "length, in the mechanism's unit",
        Dimension::Angle => "angle, in radians",
        Dimension::Direction => "angle as a unit vector, its rates in radians",
        Dimension::Scalar => "number",
        Dimension::Point | Dimension::Point3 => "point, in the mechanism's unit of length",
        Dimension::Vector | Dimension::Vector3 => "vector, in the mechanism's unit of length",
    }
}

/// A cost, as a line.
pub(in crate::emit) fn cost_line(cost: Cost) -> String {
    format!(" Costs {}.", in_words(cost))
}

/// A cost in words.
fn in_words(cost: Cost) -> String {
    let functions = [
        (cost.square_roots, "square root", "square roots"),
        (cost.sine_cosines, "sine-cosine pair", "sine-cosine pairs"),
        (cost.arc_tangents, "arctangent", "arctangents"),
        (cost.others, "other function", "other functions"),
    ];
    let arithmetic = cost.arithmetic();
    let mut parts = vec![format!(
        "{arithmetic} {}",
        if arithmetic == 1 { "operation" } else { "operations" }
    )];
    parts.extend(
        functions
            .into_iter()
            .filter(|&(count, ..)| count > 0)
            .map(|(count, one, many)| format!("{count} {}", if count == 1 { one } else { many })),
    );
    match parts.as_slice() {
        [only] => only.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
        [] => String::new(),
    }
}
