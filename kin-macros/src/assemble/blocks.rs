//! Each block's closed form as steps.

use std::collections::BTreeMap;

use super::program::{Choice, Mode, Names, Stage, Step};
use super::solver::{Argument, Solver};
use super::units::Units;
use crate::expr::{Graph, Node, Symbol};
use crate::function::Function;
use crate::structure::{Arm, Block, ClosedForm, Complex};

/// A range declared for an unknown, as far as choosing needs it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// The steps that find the position, what they teach about directions, and the choices they leave.
pub(crate) struct Assembled {
    pub(crate) stage: Stage,
    pub(crate) units: Units,
    pub(crate) choices: Vec<Choice>,
}

struct Builder<'a> {
    graph: &'a mut Graph,
    names: &'a mut Names,
    ranges: &'a BTreeMap<usize, Limits>,
    steps: Vec<Step>,
    units: Units,
}

/// Turns blocks into steps; `determinants` are the blocks' Jacobians, for those that must be checked.
pub(crate) fn assemble(
    graph: &mut Graph,
    names: &mut Names,
    blocks: &[Block],
    ranges: &BTreeMap<usize, Limits>,
    determinants: &[Node],
) -> Assembled {
    let mut builder = Builder {
        graph,
        names,
        ranges,
        steps: Vec::new(),
        units: Units::default(),
    };
    let mut choices = Vec::new();
    let mut assemblies = 0;
    for (index, block) in blocks.iter().enumerate() {
        builder.steps.push(Step::Open { block: index });
        let orientation = builder.orientation(&block.form);
        let mode = builder.mode(&block.form, &block.unknowns, &mut assemblies);
        choices.push(Choice { mode, orientation });
        builder.form(&block.form);
        for &unknown in &block.unknowns {
            builder.steps.push(Step::Bound { unknown });
        }
        if block.check_jacobian {
            let node = builder.units.rewrite(builder.graph, determinants[index]);
            builder.steps.push(Step::Regular { node });
        }
        builder.steps.push(Step::Close { block: index });
    }
    Assembled {
        stage: Stage { steps: builder.steps },
        units: builder.units,
        choices,
    }
}

impl Builder<'_> {
    fn mode(&self, form: &ClosedForm, unknowns: &[usize], assemblies: &mut usize) -> Mode {
        if !form.has_assemblies() {
            return Mode::Only;
        }
        let Some((&unknown, limits)) = unknowns.iter().find_map(|unknown| self.ranges.get_key_value(unknown)) else {
            *assemblies += 1;
            return Mode::Assembly(*assemblies - 1);
        };
        match fixed_by_range(self.graph, form, unknown, *limits) {
            Some(is_open) => Mode::Fixed { is_open },
            None => Mode::Ranged { unknown },
        }
    }

    /// Positive in the open assembly.
    fn orientation(&mut self, form: &ClosedForm) -> Option<Node> {
        let graph = &mut *self.graph;
        Some(match form {
            ClosedForm::Linear { .. } | ClosedForm::LinearPair { .. } => return None,
            ClosedForm::Inverse { then, .. } => return self.orientation(then),
            ClosedForm::SquareRoot { unknown, .. } => graph.symbol(Symbol::Unknown(*unknown)),
            ClosedForm::Quadratic { unknown, a, b, .. } => {
                let x = graph.symbol(Symbol::Unknown(*unknown));
                let double = graph.product(&[(*a, 1), (x, 1)]);
                let slope = graph.linear(0.0, &[(double, 2.0), (*b, 1.0)]);
                graph.multiply(*a, slope)
            }
            ClosedForm::InverseCosine { unknown, .. } => {
                let x = graph.symbol(Symbol::Unknown(*unknown));
                graph.sine(x)
            }
            ClosedForm::InverseSine { unknown, .. } => {
                let x = graph.symbol(Symbol::Unknown(*unknown));
                graph.cosine(x)
            }
            ClosedForm::CosineSine { unknown, a, b, .. } => {
                let x = graph.symbol(Symbol::Unknown(*unknown));
                let (cosine, sine) = (graph.cosine(x), graph.sine(x));
                let (first, second) = (graph.multiply(*a, sine), graph.multiply(*b, cosine));
                graph.subtract(first, second)
            }
            ClosedForm::TwoAngles {
                arms: [first, second], ..
            } => {
                // -(v₁ × v₂) with v = factor · cis(± angle)
                let (first_angle, second_angle) = (signed_angle(graph, first), signed_angle(graph, second));
                let between = graph.subtract(second_angle, first_angle);
                let conjugate = first.factor.conjugate(graph);
                let ratio = conjugate.times(graph, second.factor);
                let (cosine, sine) = (graph.cosine(between), graph.sine(between));
                let (along, across) = (graph.multiply(ratio.re, sine), graph.multiply(ratio.im, cosine));
                let cross = graph.add(along, across);
                graph.negate(cross)
            }
            ClosedForm::AngleLength { arm, direction, .. } => {
                // -(v · direction)
                let angle = signed_angle(graph, arm);
                let unit = Complex::new(graph.cosine(angle), graph.sine(angle));
                let vector = arm.factor.times(graph, unit);
                let (x, y) = (
                    graph.multiply(vector.re, direction.re),
                    graph.multiply(vector.im, direction.im),
                );
                let dot = graph.add(x, y);
                graph.negate(dot)
            }
            ClosedForm::Polar { length, offset, .. } => {
                let length = graph.symbol(Symbol::Unknown(*length));
                graph.add(length, offset.re)
            }
        })
    }

    fn known(&mut self, node: Node) -> Node {
        self.units.rewrite(self.graph, node)
    }

    fn known_complex(&mut self, value: Complex) -> Complex {
        Complex::new(self.known(value.re), self.known(value.im))
    }

    /// A value under a name, so that what is built on it refers to it and not to how it came about.
    fn define(&mut self, wish: &str, node: Node) -> Node {
        if self.graph.as_symbol(node).is_some() || self.graph.as_number(node).is_some() {
            return node;
        }
        let (symbol, result) = self.graph.new_step();
        self.names.name(symbol, wish);
        self.steps.push(Step::Define { symbol, node });
        result
    }

    fn define_complex(&mut self, wish: &str, value: Complex) -> Complex {
        Complex::new(
            self.define(&format!("{wish}_x"), value.re),
            self.define(&format!("{wish}_y"), value.im),
        )
    }

    fn fresh(&mut self, wish: &str) -> (Symbol, Node) {
        let (symbol, node) = self.graph.new_step();
        self.names.name(symbol, wish);
        (symbol, node)
    }

    fn fresh_plane(&mut self, wish: &str) -> ([Symbol; 2], Complex) {
        let ((x, x_node), (y, y_node)) = (self.fresh(&format!("{wish}_x")), self.fresh(&format!("{wish}_y")));
        ([x, y], Complex::new(x_node, y_node))
    }

    fn unknown_name(&self, unknown: usize) -> String {
        self.names.of(Symbol::Unknown(unknown)).to_owned()
    }

    fn solve(&mut self, solver: Solver, arguments: Vec<Argument>, results: Vec<Symbol>) {
        self.steps.push(Step::Solve {
            solver,
            arguments,
            results,
        });
    }

    fn form(&mut self, form: &ClosedForm) {
        match form {
            ClosedForm::Linear {
                unknown,
                coefficient,
                right,
            } => self.linear(*unknown, *coefficient, *right),
            ClosedForm::SquareRoot { unknown, square } => {
                let square = self.known(*square);
                self.solve(
                    Solver::SquareRoot,
                    vec![Argument::Scalar(square)],
                    vec![Symbol::Unknown(*unknown)],
                );
            }
            ClosedForm::Quadratic { unknown, a, b, c } => {
                let arguments = [*a, *b, *c].map(|node| Argument::Scalar(self.known(node))).to_vec();
                self.solve(Solver::Quadratic, arguments, vec![Symbol::Unknown(*unknown)]);
            }
            ClosedForm::InverseCosine { unknown, cosine } => {
                self.inverse_circular(Solver::InverseCosine, *unknown, *cosine);
            }
            ClosedForm::InverseSine { unknown, sine } => {
                self.inverse_circular(Solver::InverseSine, *unknown, *sine);
            }
            ClosedForm::CosineSine { unknown, a, b, c } => {
                let arguments = [*a, *b, *c].map(|node| Argument::Scalar(self.known(node))).to_vec();
                let ([x, y], unit) = self.fresh_plane(&self.unknown_name(*unknown));
                self.solve(Solver::CosineSine, arguments, vec![x, y]);
                self.turn(*unknown, unit);
            }
            ClosedForm::Inverse {
                function,
                value,
                result,
                then,
            } => {
                self.inverse(*function, *value, *result);
                self.form(then);
            }
            ClosedForm::LinearPair {
                unknowns,
                matrix,
                right,
            } => {
                let matrix = matrix.map(|row| row.map(|entry| self.known(entry)));
                let right = right.map(|entry| self.known(entry));
                self.solve(
                    Solver::LinearPair,
                    vec![Argument::Matrix(matrix), Argument::Pair(right)],
                    unknowns.iter().map(|&unknown| Symbol::Unknown(unknown)).collect(),
                );
            }
            ClosedForm::TwoAngles { unknowns, arms, target } => self.two_angles(*unknowns, arms, *target),
            ClosedForm::AngleLength {
                angle,
                length,
                arm,
                direction,
                target,
            } => {
                self.angle_length(*angle, *length, arm, *direction, *target);
            }
            ClosedForm::Polar {
                length,
                angle,
                mirrored,
                offset,
                target,
            } => {
                self.polar(*length, *angle, *mirrored, *offset, *target);
            }
        }
    }

    fn linear(&mut self, unknown: usize, coefficient: Node, right: Node) {
        let symbol = Symbol::Unknown(unknown);
        if self.graph.constant_value(coefficient).is_some() {
            let value = self.graph.divide(right, coefficient);
            let own = self.graph.symbol(symbol);
            self.units.learn_combination(own, value);
            let node = self.known(value);
            self.steps.push(Step::Define { symbol, node });
        } else {
            let arguments = vec![
                Argument::Scalar(self.known(coefficient)),
                Argument::Scalar(self.known(right)),
            ];
            self.solve(Solver::Linear, arguments, vec![symbol]);
        }
    }

    fn inverse_circular(&mut self, solver: Solver, unknown: usize, value: Node) {
        let value = self.known(value);
        let name = self.unknown_name(unknown);
        let is_cosine = solver == Solver::InverseCosine;
        let given = self.define(&format!("{}_{name}", if is_cosine { "cos" } else { "sin" }), value);
        let ([x, y], mut unit) = self.fresh_plane(&name);
        self.solve(solver, vec![Argument::Scalar(given)], vec![x, y]);
        if is_cosine {
            unit.re = given;
        } else {
            unit.im = given;
        }
        self.turn(unknown, unit);
    }

    /// The unknown angle of a unit vector.
    fn turn(&mut self, unknown: usize, unit: Complex) {
        let angle = self.graph.symbol(Symbol::Unknown(unknown));
        self.units.learn_direction(angle, unit);
        let length = self.graph.one();
        self.steps.push(Step::Angle {
            symbol: Symbol::Unknown(unknown),
            x: unit.re,
            y: unit.im,
            length,
        });
    }

    fn inverse(&mut self, function: Function, value: Node, result: Symbol) {
        let value = self.known(value);
        self.names.name(result, "inverse");
        let solver = match function {
            Function::Sqrt => Solver::SquareOfRoot,
            Function::Asin => Solver::SineOfArc,
            Function::Acos => Solver::CosineOfArc,
            Function::Atan => Solver::TangentOfArc,
            Function::Exp => Solver::Logarithm,
            _ => {
                let node = self.graph.call(Function::Exp, &[value]);
                self.steps.push(Step::Define { symbol: result, node });
                return;
            }
        };
        self.solve(solver, vec![Argument::Scalar(value)], vec![result]);
    }

    /// What a link's components are called: after its length, if that has a name.
    fn link_name(&mut self, length: Node, angle: &str) -> String {
        match self.graph.as_symbol(length) {
            Some(symbol @ Symbol::Parameter(_)) => self.names.of(symbol).to_owned(),
            _ => format!("link_{angle}"),
        }
    }

    fn angle_name(&self, arm: &Arm) -> String {
        arm.angle
            .0
            .iter()
            .map(|&(symbol, _)| self.names.of(symbol).to_owned())
            .collect::<Vec<_>>()
            .join("_")
    }

    /// The unit vector of an arm from the arm's own vector.
    fn unit_of(&mut self, vector: Complex, factor: Complex, mirrored: bool) -> Complex {
        let unit = vector.over(self.graph, factor);
        if mirrored { unit.conjugate(self.graph) } else { unit }
    }

    fn two_angles(&mut self, unknowns: [usize; 2], arms: &[Arm; 2], target: Complex) {
        let factors = [self.known_complex(arms[0].factor), self.known_complex(arms[1].factor)];
        let mut target = self.known_complex(target);
        let names = [self.angle_name(&arms[0]), self.angle_name(&arms[1])];
        let both_real = factors.iter().all(|factor| factor.is_real(self.graph));
        // vectors[k] points along the k-th arm: factor times unit vector, with a positive number in front
        let (vectors, lengths);
        if both_real {
            let (first_sign, first) = self.graph.split_coefficient(factors[0].re);
            let (second_sign, second) = self.graph.split_coefficient(factors[1].re);
            let (a, b) = (
                self.graph.scale(first_sign.abs(), first),
                self.graph.scale(second_sign.abs(), second),
            );
            if first_sign < 0.0 {
                let minus = self.graph.number(-1.0);
                target = target.scaled(self.graph, minus);
            }
            let target = self.define_complex("diagonal", target);
            let wish = self.link_name(a, &names[0]);
            let ([x, y], link) = self.fresh_plane(&wish);
            self.solve(
                Solver::CircleCircle,
                vec![
                    Argument::Scalar(a),
                    Argument::Scalar(b),
                    Argument::Plane(target.re, target.im),
                ],
                vec![x, y],
            );
            let mut other = Complex::new(
                self.graph.subtract(target.re, link.re),
                self.graph.subtract(target.im, link.im),
            );
            if (first_sign < 0.0) != (second_sign < 0.0) {
                let minus = self.graph.number(-1.0);
                other = other.scaled(self.graph, minus);
            }
            let wish = self.link_name(b, &names[1]);
            let other = self.define_complex(&wish, other);
            vectors = [link, other];
            lengths = [a, b];
        } else {
            let a2 = factors[0].norm_squared(self.graph);
            let b2 = factors[1].norm_squared(self.graph);
            let (a2, b2) = (self.define("length_squared", a2), self.define("length_squared", b2));
            let target = self.define_complex("diagonal", target);
            let ([x, y], link) = self.fresh_plane(&format!("link_{}", names[0]));
            self.solve(
                Solver::CircleCircleSquared,
                vec![
                    Argument::Scalar(a2),
                    Argument::Scalar(b2),
                    Argument::Plane(target.re, target.im),
                ],
                vec![x, y],
            );
            let other = Complex::new(
                self.graph.subtract(target.re, link.re),
                self.graph.subtract(target.im, link.im),
            );
            let other = self.define_complex(&format!("link_{}", names[1]), other);
            // turned back by the factor's own angle they lie along the arms, times the factor's square
            let mut turned = [link, other];
            let mut squares = [a2, b2];
            for index in 0..2 {
                if factors[index].is_real(self.graph) {
                    squares[index] = factors[index].re;
                } else {
                    let conjugate = factors[index].conjugate(self.graph);
                    let back = turned[index].times(self.graph, conjugate);
                    turned[index] = self.define_complex(&names[index], back);
                }
            }
            vectors = turned;
            lengths = squares;
        }
        let mut directions = [vectors[0], vectors[1]];
        for index in 0..2 {
            let length = Complex::new(lengths[index], self.graph.zero());
            directions[index] = self.unit_of(vectors[index], length, arms[index].mirrored);
            let angle = arms[index].angle.node(self.graph);
            self.units.learn_direction(angle, directions[index]);
        }
        self.angles_of_unknowns(unknowns, arms, vectors, lengths, directions);
    }

    /// The unknowns from the directions of the two arms, which are integer combinations of them.
    fn angles_of_unknowns(
        &mut self,
        unknowns: [usize; 2],
        arms: &[Arm; 2],
        vectors: [Complex; 2],
        lengths: [Node; 2],
        directions: [Complex; 2],
    ) {
        let multiple = |arm: usize, unknown: usize| {
            arms[arm]
                .angle
                .0
                .iter()
                .find(|&&(symbol, _)| symbol == Symbol::Unknown(unknowns[unknown]))
                .map_or(0, |&(_, multiple)| multiple)
        };
        let (a, b, c, d) = (multiple(0, 0), multiple(0, 1), multiple(1, 0), multiple(1, 1));
        let determinant = a * d - b * c;
        // the inverse of [[a, b], [c, d]], whose determinant is ±1
        let inverse = [[d * determinant, -b * determinant], [-c * determinant, a * determinant]];
        for (index, row) in inverse.into_iter().enumerate() {
            let own = self.graph.symbol(Symbol::Unknown(unknowns[index]));
            let (vector, length) = match row {
                [1, 0] => (self.upright(vectors[0], arms[0].mirrored), lengths[0]),
                [0, 1] => (self.upright(vectors[1], arms[1].mirrored), lengths[1]),
                _ => {
                    let mut vector: Option<Complex> = None;
                    let mut direction: Option<Complex> = None;
                    let mut length = self.graph.one();
                    for (arm, &power) in row.iter().enumerate() {
                        let mut link = self.upright(vectors[arm], arms[arm].mirrored);
                        let mut unit = directions[arm];
                        if power < 0 {
                            link = link.conjugate(self.graph);
                            unit = unit.conjugate(self.graph);
                        }
                        for _ in 0..power.abs() {
                            vector = Some(vector.map_or(link, |before| before.times(self.graph, link)));
                            direction = Some(direction.map_or(unit, |before| before.times(self.graph, unit)));
                            length = self.graph.multiply(length, lengths[arm]);
                        }
                    }
                    let one = Complex::new(self.graph.one(), self.graph.zero());
                    self.units.learn_direction(own, direction.unwrap_or(one));
                    (vector.unwrap_or(one), length)
                }
            };
            self.push_angle(unknowns[index], vector, length);
        }
    }

    /// A clockwise vector as a counter-clockwise one.
    fn upright(&mut self, vector: Complex, mirrored: bool) -> Complex {
        if mirrored { vector.conjugate(self.graph) } else { vector }
    }

    fn angle_length(&mut self, angle: usize, length: usize, arm: &Arm, direction: Complex, target: Complex) {
        let mut factor = self.known_complex(arm.factor);
        let mut direction = self.known_complex(direction);
        let mut target = self.known_complex(target);
        let minus = self.graph.number(-1.0);
        let leading = if self.graph.is_zero(direction.re) {
            direction.im
        } else {
            direction.re
        };
        if self.graph.as_number(leading).is_some_and(|value| value < 0.0) {
            factor = factor.scaled(self.graph, minus);
            direction = direction.scaled(self.graph, minus);
            target = target.scaled(self.graph, minus);
        }
        let square = factor.norm_squared(self.graph);
        let target = self.define_complex("offset", target);
        let angle_name = self.unknown_name(angle);
        let wish = if factor.is_real(self.graph) {
            let (_, bare) = self.graph.split_coefficient(factor.re);
            self.link_name(bare, &angle_name)
        } else {
            format!("link_{angle_name}")
        };
        let ([x, y], link) = self.fresh_plane(&wish);
        let is_along_x = self.graph.is_one(direction.re) && self.graph.is_zero(direction.im);
        let is_along_y = self.graph.is_one(direction.im) && self.graph.is_zero(direction.re);
        let mut arguments = vec![Argument::Scalar(square)];
        let solver = if is_along_x {
            Solver::CircleLineX
        } else if is_along_y {
            Solver::CircleLineY
        } else {
            arguments.push(Argument::Plane(direction.re, direction.im));
            Solver::CircleLine
        };
        arguments.push(Argument::Plane(target.re, target.im));
        self.solve(solver, arguments, vec![x, y, Symbol::Unknown(length)]);
        let unit = self.unit_of(link, factor, arm.mirrored);
        let own = self.graph.symbol(Symbol::Unknown(angle));
        self.units.learn_direction(own, unit);
        let (vector, length) = if factor.is_real(self.graph) {
            (link, factor.re)
        } else {
            let conjugate = factor.conjugate(self.graph);
            (link.times(self.graph, conjugate), self.graph.one())
        };
        let vector = self.upright(vector, arm.mirrored);
        self.push_angle(angle, vector, length);
    }

    /// The angle of a vector, a number's sign in front of the length being moved into the vector.
    fn push_angle(&mut self, unknown: usize, vector: Complex, length: Node) {
        let (coefficient, bare) = self.graph.split_coefficient(length);
        let sign = self.graph.number(coefficient.signum());
        let vector = vector.scaled(self.graph, sign);
        self.steps.push(Step::Angle {
            symbol: Symbol::Unknown(unknown),
            x: vector.re,
            y: vector.im,
            length: bare,
        });
    }

    fn polar(&mut self, length: usize, angle: usize, mirrored: bool, offset: Complex, target: Complex) {
        let (offset, target) = (self.known_complex(offset), self.known_complex(target));
        let target = self.define_complex("span", target);
        let own_angle = self.graph.symbol(Symbol::Unknown(angle));
        let own_length = self.graph.symbol(Symbol::Unknown(length));
        let has_offset = !(self.graph.is_zero(offset.re) && self.graph.is_zero(offset.im));
        let given = Argument::Plane(target.re, target.im);
        if has_offset {
            let ([x, y], unit) = self.fresh_plane(&self.unknown_name(angle));
            self.solve(
                Solver::PolarOffset,
                vec![Argument::Plane(offset.re, offset.im), given],
                vec![Symbol::Unknown(length), x, y],
            );
            let unit = self.upright(unit, mirrored);
            self.turn(angle, unit);
        } else {
            self.solve(Solver::Polar, vec![given], vec![Symbol::Unknown(length)]);
            let divisor = Complex::new(own_length, self.graph.zero());
            let unit = self.unit_of(target, divisor, mirrored);
            self.units.learn_direction(own_angle, unit);
            let vector = self.upright(target, mirrored);
            self.push_angle(angle, vector, own_length);
        }
    }
}

fn signed_angle(graph: &mut Graph, arm: &Arm) -> Node {
    let angle = arm.angle.node(graph);
    if arm.mirrored { graph.negate(angle) } else { angle }
}

/// Whether a range decides between the solutions whatever the dimensions are, and for the open one.
fn fixed_by_range(graph: &Graph, form: &ClosedForm, unknown: usize, limits: Limits) -> Option<bool> {
    use std::f64::consts::{FRAC_PI_2, PI};
    const SLACK: f64 = 1e-12;
    let within = |low: f64, high: f64| limits.low >= low - SLACK && limits.high <= high + SLACK;
    match form {
        ClosedForm::SquareRoot { .. } => by_sign(limits),
        ClosedForm::Polar { length, offset, .. } if *length == unknown && graph.is_zero(offset.re) => by_sign(limits),
        ClosedForm::InverseCosine { .. } if within(0.0, PI) => Some(true),
        ClosedForm::InverseCosine { .. } if within(-PI, 0.0) || within(PI, 2.0 * PI) => Some(false),
        ClosedForm::InverseSine { .. } if within(-FRAC_PI_2, FRAC_PI_2) => Some(true),
        ClosedForm::InverseSine { .. } if within(FRAC_PI_2, 3.0 * FRAC_PI_2) => Some(false),
        ClosedForm::Inverse { then, .. } => fixed_by_range(graph, then, unknown, limits),
        _ => None,
    }
}

fn by_sign(limits: Limits) -> Option<bool> {
    if limits.low >= 0.0 {
        Some(true)
    } else if limits.high <= 0.0 {
        Some(false)
    } else {
        None
    }
}
