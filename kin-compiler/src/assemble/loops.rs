//! Plane loops as steps: the vectors of the turning links, and the angles from them.

use super::blocks::Builder;
use super::reciprocals::KnownRoot;
use crate::algebra::{Node, Symbol};
use crate::program::{FormArgument, Solver, Step};
use crate::structure::{Arm, ComplexNode};

impl Builder<'_> {
    /// The prefix of the names of a link's components: its length, if that has a name, otherwise the angle.
    pub(super) fn link_name(&mut self, length: Node, angle: &str) -> String {
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

    /// The unit vector of an arm from the vector of the arm.
    fn unit_of(&mut self, vector: ComplexNode, factor: ComplexNode, mirrored: bool) -> ComplexNode {
        let unit = vector.over(self.graph, factor);
        if mirrored { unit.conjugate(self.graph) } else { unit }
    }

    /// Finds the angle of a link whose vector is known.
    pub(super) fn direction(&mut self, unknown: usize, arm: &Arm, target: ComplexNode) {
        let factor = self.known_complex(arm.factor);
        let target = self.known_complex(target);
        let wish = if factor.is_real(self.graph) {
            let (_, length) = self.graph.split_coefficient(factor.re);
            self.link_name(length, &self.angle_name(arm))
        } else {
            format!("link_{}", self.angle_name(arm))
        };
        let vector = self.define_complex(&wish, target);
        let unit = self.unit_of(vector, factor, arm.mirrored);
        self.turn(unknown, unit);
    }

    pub(super) fn two_angles(&mut self, unknowns: [usize; 2], arms: &[Arm; 2], target: ComplexNode) {
        let factors = [self.known_complex(arms[0].factor), self.known_complex(arms[1].factor)];
        let mut target = self.known_complex(target);
        let names = [self.angle_name(&arms[0]), self.angle_name(&arms[1])];
        let both_real = factors.iter().all(|factor| factor.is_real(self.graph));
        // vectors[k] points along the k-th arm: factor times unit vector, times a positive number
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
            let ((area, root), (area_squared, square)) = (self.fresh("four_areas"), self.fresh("four_areas_squared"));
            self.solve(
                Solver::CircleCircle,
                vec![
                    FormArgument::Scalar(a),
                    FormArgument::Scalar(b),
                    FormArgument::Plane([target.re, target.im]),
                ],
                vec![x, y, area, area_squared],
            );
            let mut other = ComplexNode::new(
                self.graph.subtract(target.re, link.re),
                self.graph.subtract(target.im, link.im),
            );
            let is_opposite = (first_sign < 0.0) != (second_sign < 0.0);
            if is_opposite {
                let minus = self.graph.number(-1.0);
                other = other.scaled(self.graph, minus);
            }
            let wish = self.link_name(b, &names[1]);
            let other = self.define_complex(&wish, other);
            // link × (target - link) is minus half of the root
            let cross = link.conjugate(self.graph).times(self.graph, other).im;
            self.learn_root(KnownRoot {
                base: cross,
                value: root,
                square,
                factor: if is_opposite { 2.0 } else { -2.0 },
                names: ["double_inverse_square", "inverse_determinant"].map(str::to_owned),
            });
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
                    FormArgument::Scalar(a2),
                    FormArgument::Scalar(b2),
                    FormArgument::Plane([target.re, target.im]),
                ],
                vec![x, y],
            );
            let other = ComplexNode::new(
                self.graph.subtract(target.re, link.re),
                self.graph.subtract(target.im, link.im),
            );
            let other = self.define_complex(&format!("link_{}", names[1]), other);
            // rotated back by the angle of the factor, they lie along the arms, times the factor's square
            let mut rotated = [link, other];
            let mut squares = [a2, b2];
            for index in 0..2 {
                if factors[index].is_real(self.graph) {
                    squares[index] = factors[index].re;
                } else {
                    let conjugate = factors[index].conjugate(self.graph);
                    let back = rotated[index].times(self.graph, conjugate);
                    rotated[index] = self.define_complex(&names[index], back);
                }
            }
            vectors = rotated;
            lengths = squares;
        }
        let mut directions = [vectors[0], vectors[1]];
        for index in 0..2 {
            let length = ComplexNode::new(lengths[index], self.graph.zero());
            directions[index] = self.unit_of(vectors[index], length, arms[index].mirrored);
            let angle = arms[index].angle.node(self.graph);
            self.units.learn_direction(angle, directions[index]);
        }
        self.angles_of_unknowns(unknowns, arms, vectors, lengths, directions);
    }

    /// Finds the unknowns from the directions of two arms, which are integer combinations of the unknowns.
    fn angles_of_unknowns(
        &mut self,
        unknowns: [usize; 2],
        arms: &[Arm; 2],
        vectors: [ComplexNode; 2],
        lengths: [Node; 2],
        directions: [ComplexNode; 2],
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
            let angle = self.graph.symbol(Symbol::Unknown(unknowns[index]));
            let (vector, length) = match row {
                [1, 0] => (self.upright(vectors[0], arms[0].mirrored), lengths[0]),
                [0, 1] => (self.upright(vectors[1], arms[1].mirrored), lengths[1]),
                _ => {
                    let mut vector: Option<ComplexNode> = None;
                    let mut direction: Option<ComplexNode> = None;
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
                    let one = ComplexNode::new(self.graph.one(), self.graph.zero());
                    self.units.learn_direction(angle, direction.unwrap_or(one));
                    (vector.unwrap_or(one), length)
                }
            };
            self.push_angle(unknowns[index], vector, length);
        }
    }

    /// The mirror image of a clockwise vector, so that it is counter-clockwise; other vectors stay as they are.
    fn upright(&mut self, vector: ComplexNode, mirrored: bool) -> ComplexNode {
        if mirrored { vector.conjugate(self.graph) } else { vector }
    }

    pub(super) fn angle_length(
        &mut self,
        angle: usize,
        length: usize,
        arm: &Arm,
        direction: ComplexNode,
        target: ComplexNode,
    ) {
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
        let is_along_x = self.graph.is_one(direction.re) && self.graph.is_zero(direction.im);
        let is_along_y = self.graph.is_one(direction.im) && self.graph.is_zero(direction.re);
        let mut arguments = vec![FormArgument::Scalar(square)];
        let solver = if is_along_x {
            Solver::CircleLineX
        } else if is_along_y {
            Solver::CircleLineY
        } else {
            arguments.push(FormArgument::Plane([direction.re, direction.im]));
            Solver::CircleLine
        };
        arguments.push(FormArgument::Plane([target.re, target.im]));
        let mut results;
        let link;
        if is_along_x || is_along_y {
            let (symbol, leg) = self.fresh(&format!("{wish}_{}", if is_along_x { "x" } else { "y" }));
            link = if is_along_x {
                ComplexNode::new(leg, target.im)
            } else {
                ComplexNode::new(target.re, leg)
            };
            results = vec![symbol, self.root(symbol, leg)];
        } else {
            let (parts, vector) = self.fresh_plane(&wish);
            link = vector;
            results = parts.to_vec();
        }
        results.push(Symbol::Unknown(length));
        self.solve(solver, arguments, results);
        let unit = self.unit_of(link, factor, arm.mirrored);
        let angle_node = self.graph.symbol(Symbol::Unknown(angle));
        self.units.learn_direction(angle_node, unit);
        let (vector, length) = if factor.is_real(self.graph) {
            (link, factor.re)
        } else {
            let conjugate = factor.conjugate(self.graph);
            (link.times(self.graph, conjugate), self.graph.one())
        };
        let vector = self.upright(vector, arm.mirrored);
        self.push_angle(angle, vector, length);
    }

    /// Finds the angle of a vector. The sign of a number in front of the length is moved into the vector.
    pub(super) fn push_angle(&mut self, unknown: usize, vector: ComplexNode, length: Node) {
        let (coefficient, bare) = self.graph.split_coefficient(length);
        let sign = self.graph.number(coefficient.signum());
        let vector = vector.scaled(self.graph, sign);
        self.steps.push(Step::Angle {
            symbol: Symbol::Unknown(unknown),
            x: vector.re,
            y: vector.im,
            length: Some(bare),
        });
    }

    pub(super) fn polar(
        &mut self,
        length: usize,
        angle: usize,
        mirrored: bool,
        offset: ComplexNode,
        target: ComplexNode,
    ) {
        let (offset, target) = (self.known_complex(offset), self.known_complex(target));
        let target = self.define_complex("span", target);
        let length_node = self.graph.symbol(Symbol::Unknown(length));
        let has_offset = !(self.graph.is_zero(offset.re) && self.graph.is_zero(offset.im));
        let given = FormArgument::Plane([target.re, target.im]);
        if has_offset {
            let ([x, y], unit) = self.fresh_plane(&self.unknown_name(angle));
            self.solve(
                Solver::PolarOffset,
                vec![FormArgument::Plane([offset.re, offset.im]), given],
                vec![Symbol::Unknown(length), x, y],
            );
            let unit = self.upright(unit, mirrored);
            self.turn(angle, unit);
        } else {
            let symbol = Symbol::Unknown(length);
            let square = self.root(symbol, length_node);
            self.solve(Solver::Polar, vec![given], vec![symbol, square]);
            let vector = self.upright(target, mirrored);
            self.turn_vector(angle, length_node, vector);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use quote::quote;

    use super::*;
    use crate::algebra::{Angle, Graph};
    use crate::assemble::units::Units;
    use crate::passes::Passes;
    use crate::program::Names;
    use crate::testing::{declarations, sound};

    /// The unknowns found from the directions of links give the links these directions.
    #[test]
    fn unknowns_follow_from_combinations_of_angles() {
        const TRUE: [f64; 2] = [0.7, -1.9];
        const LENGTHS: [f64; 2] = [2.0, 1.5];
        for (multiples, mirrored) in [
            ([[1, 0], [0, 1]], [false, false]),
            ([[1, 0], [1, 1]], [false, false]),
            ([[1, 1], [0, 1]], [true, false]),
            ([[1, 0], [2, -1]], [false, true]),
            ([[2, 1], [1, 1]], [false, false]),
            ([[1, -1], [1, 0]], [true, true]),
        ] {
            let mut graph = Graph::new();
            let factors = [0, 1].map(|index| graph.symbol(Symbol::Parameter(index)));
            let [c, d] = [2, 3].map(|index| graph.symbol(Symbol::Parameter(index)));
            let zero = graph.zero();
            let arm = |index: usize| {
                let symbols = [0, 1].map(Symbol::Unknown).into_iter().zip(multiples[index]);
                Arm {
                    angle: Angle(symbols.filter(|&(_, multiple)| multiple != 0).collect()),
                    mirrored: mirrored[index],
                    factor: ComplexNode::new(factors[index], zero),
                }
            };
            let arms = [arm(0), arm(1)];
            let mut names = Names::default();
            for symbol in [0, 1]
                .map(Symbol::Unknown)
                .into_iter()
                .chain([0, 1].map(Symbol::Parameter))
            {
                names.name(symbol, "known");
            }
            let mut builder = Builder {
                graph: &mut graph,
                names: &mut names,
                steps: Vec::new(),
                units: Units::new(Passes::ALL),
                nonzero: Vec::new(),
                roots: Vec::new(),
            };
            builder.two_angles([0, 1], &arms, ComplexNode::new(c, d));
            let steps = builder.steps;

            let vectors = [0, 1].map(|index| {
                let [p, q] = multiples[index].map(f64::from);
                let angle = p * TRUE[0] + q * TRUE[1];
                let angle = if mirrored[index] { -angle } else { angle };
                [LENGTHS[index] * angle.cos(), LENGTHS[index] * angle.sin()]
            });
            let mut values = BTreeMap::from([
                (Symbol::Parameter(0), LENGTHS[0]),
                (Symbol::Parameter(1), LENGTHS[1]),
                (Symbol::Parameter(2), vectors[0][0] + vectors[1][0]),
                (Symbol::Parameter(3), vectors[0][1] + vectors[1][1]),
            ]);
            let mut found = Vec::new();
            for step in steps {
                let value = |node: Node, values: &BTreeMap<Symbol, f64>| {
                    graph.evaluate(node, &|symbol| values.get(&symbol).copied().unwrap_or(f64::NAN))
                };
                match step {
                    Step::Define { symbol, value: node } => drop(values.insert(symbol, value(node, &values))),
                    Step::Solve { results, .. } => values.extend(results.into_iter().flatten().zip(vectors[0])),
                    Step::Angle { symbol, x, y, .. } => {
                        found.push((symbol, value(y, &values).atan2(value(x, &values))));
                    }
                    other => panic!("{other:?}"),
                }
            }
            assert_eq!(found.len(), 2);
            for (symbol, angle) in found {
                let Symbol::Unknown(unknown) = symbol else {
                    panic!("{symbol:?}");
                };
                let difference = (angle - TRUE[unknown]).sin().abs() + 1.0 - (angle - TRUE[unknown]).cos();
                assert!(difference < 1e-14, "{multiples:?} {mirrored:?}: {angle}");
            }
        }
    }

    /// The components of a link are named after its length, or after the angles with which it rotates.
    #[test]
    fn links_are_called_after_their_length_or_their_angle() {
        let solvable = sound(quote! {
            struct Links { r: Length, l: Vector, g: Vector, w: Vector }
            input q: Angle;
            unknown a: Angle, b: Angle;
            r * cis(q) + l * cis(a) == g + w * cis(a + b);
        });
        let is_taken = |names: &Names, name: &str| names.clone().unique(name) != name;
        let names = solvable.solvers(Passes::ALL).motion.names;
        for name in ["link_a_x", "link_a_y", "link_a_b_x", "link_a_b_y"] {
            assert!(is_taken(&names, name), "{name}");
        }
        let names = sound(declarations::four_bar()).solvers(Passes::ALL).motion.names;
        for name in ["r3_x", "r3_y", "r4_x", "r4_y"] {
            assert!(is_taken(&names, name), "{name}");
        }
    }

    /// A slide along an axis has a separate closed form if its length is measured along that axis without a factor.
    #[test]
    fn slides_along_axes_are_solved_as_such() {
        for (direction, expected) in [
            ([1.0, 0.0], Solver::CircleLineX),
            ([-1.0, 0.0], Solver::CircleLineX),
            ([0.0, 1.0], Solver::CircleLineY),
            ([2.0, 0.0], Solver::CircleLine),
            ([0.0, 0.5], Solver::CircleLine),
            ([1.0, 1.0], Solver::CircleLine),
        ] {
            let mut graph = Graph::new();
            let [re, im] = direction.map(|part| graph.number(part));
            let [l, c, d] = [0, 1, 2].map(|index| graph.symbol(Symbol::Parameter(index)));
            let arm = Arm {
                angle: Angle(vec![(Symbol::Unknown(0), 1)]),
                mirrored: false,
                factor: ComplexNode::new(l, graph.zero()),
            };
            let mut names = Names::default();
            for symbol in [Symbol::Unknown(0), Symbol::Unknown(1), Symbol::Parameter(0)] {
                names.name(symbol, "known");
            }
            let mut builder = Builder {
                graph: &mut graph,
                names: &mut names,
                steps: Vec::new(),
                units: Units::new(Passes::ALL),
                nonzero: Vec::new(),
                roots: Vec::new(),
            };
            builder.angle_length(0, 1, &arm, ComplexNode::new(re, im), ComplexNode::new(c, d));
            let solvers: Vec<Solver> = builder
                .steps
                .iter()
                .filter_map(|step| match step {
                    Step::Solve { solver, .. } => Some(*solver),
                    _ => None,
                })
                .collect();
            assert_eq!(solvers, [expected], "{direction:?}");
        }
    }
}
