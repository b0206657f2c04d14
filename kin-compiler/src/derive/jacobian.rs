//! A block's Jacobian, and the linear systems that it solves for the rates of every order.
//!
//! A large Jacobian is reduced first. The step of the reduction cannot fail if the determinant does not vanish,
//! whatever the position: two entries p and q that are alone in their column are rotated into √(p² + q²) and zero. Up
//! to three remaining unknowns are solved by Cramer's rule. More are solved by the factors that the position has
//! computed.

use super::Rate;
use super::influence::Influences;
use super::radius::radius;
use crate::algebra::{Graph, Node, Symbol};
use crate::passes::{Pass, Passes};
use crate::structure::Block;

/// The largest number of unknowns that Cramer's rule solves.
const CRAMER: usize = 3;

/// A Jacobian after all reductions.
pub(super) struct BlockJacobian {
    rotations: Vec<EquationRotation>,
    /// The remaining equations, by their indices in the block.
    rows: Vec<usize>,
    /// The remaining unknowns.
    unknowns: Vec<usize>,
    core: Vec<Vec<Node>>,
    /// The factors of the remaining matrix, if it is too large for Cramer's rule.
    factors: Option<Symbol>,
    passes: Passes,
}

/// The condition under which the rates of a block exist.
pub(crate) enum Regularity {
    /// This determinant does not vanish.
    Determinant(Node),
    /// This matrix can be factored. `factors` is the symbol of its factors.
    Factors { factors: Symbol, matrix: Vec<Vec<Node>> },
}

/// A step of the reduction: two equations that contain an unknown are rotated so that only the first one does.
struct EquationRotation {
    rows: [usize; 2],
    entries: [Node; 2],
    unknown: usize,
    others: Vec<(usize, Node)>,
}

/// The partial derivatives of a block's equations (rows) by its unknowns (columns).
pub(super) fn partials(graph: &mut Graph, residuals: &[Node], block: &Block) -> Vec<Vec<Node>> {
    block
        .equations
        .iter()
        .map(|&equation| {
            block
                .unknowns
                .iter()
                .map(|&unknown| graph.partial(residuals[equation], Symbol::Unknown(unknown)))
                .collect()
        })
        .collect()
}

impl BlockJacobian {
    pub(super) fn new(graph: &mut Graph, residuals: &[Node], block: &Block, passes: Passes) -> Self {
        let core = partials(graph, residuals, block);
        let mut jacobian = Self {
            rotations: Vec::new(),
            rows: (0..core.len()).collect(),
            unknowns: block.unknowns.clone(),
            core,
            factors: None,
            passes,
        };
        while passes.include(Pass::ReducedJacobians) && jacobian.core.len() > CRAMER {
            let Some((rows, column)) = jacobian.turnable(graph) else {
                break;
            };
            jacobian.rotate(graph, rows, column);
        }
        let is_factored =
            jacobian.core.len() > CRAMER || jacobian.core.len() == CRAMER && !passes.include(Pass::CramerOfThree);
        if is_factored {
            jacobian.factors = Some(graph.new_step().0);
        }
        jacobian
    }

    /// A column with exactly two entries, and their rows.
    fn turnable(&self, graph: &Graph) -> Option<([usize; 2], usize)> {
        let size = self.core.len();
        (0..size).find_map(|column| {
            let rows: Vec<usize> = (0..size)
                .filter(|&row| !graph.is_zero(self.core[row][column]))
                .collect();
            Some((<[usize; 2]>::try_from(rows).ok()?, column))
        })
    }

    fn rotate(&mut self, graph: &mut Graph, rows: [usize; 2], column: usize) {
        let entries = rows.map(|row| self.core[row][column]);
        let mut others = Vec::new();
        for index in (0..self.unknowns.len()).filter(|&index| index != column) {
            let values = rows.map(|row| self.core[row][index]);
            let (along, across) = rotated(graph, entries, values);
            if !graph.is_zero(along) {
                others.push((self.unknowns[index], along));
            }
            self.core[rows[1]][index] = across;
        }
        self.rotations.push(EquationRotation {
            rows: rows.map(|row| self.rows[row]),
            entries,
            unknown: self.unknowns[column],
            others,
        });
        self.core.remove(rows[0]);
        self.rows.remove(rows[0]);
        self.unknowns.remove(column);
        for entries in &mut self.core {
            entries.remove(column);
        }
    }

    /// The condition that the position tests: the remaining system is regular.
    pub(super) fn regularity(&self, graph: &mut Graph) -> Regularity {
        match self.factors {
            Some(factors) => Regularity::Factors {
                factors,
                matrix: self.core.clone(),
            },
            None => Regularity::Determinant(determinant(graph, &self.core, self.passes)),
        }
    }

    /// Divisors of rates that do not vanish unless the determinant does.
    pub(super) fn guaranteed(&self, graph: &mut Graph) -> Vec<Node> {
        self.rotations
            .iter()
            .map(|rotation| squares(graph, rotation.entries))
            .collect()
    }

    /// The solution x of J x = right, one rate for each unknown, in the order in which they can be computed. `symbol`
    /// is the symbol by which later rates refer to earlier ones.
    pub(super) fn solve(
        &self,
        graph: &mut Graph,
        influences: Influences,
        right: &[Node],
        symbol: &impl Fn(usize) -> Symbol,
    ) -> Vec<Rate> {
        let mut right = right.to_vec();
        let mut rates: Vec<Rate> = Vec::new();
        for rotation in &self.rotations {
            let [p, q] = rotation.entries;
            let opposite = graph.negate(p);
            let pair = rotation.rows.map(|row| right[row]);
            right[rotation.rows[0]] = influences.combined(graph, &[p, q], &pair, self.passes);
            right[rotation.rows[1]] = influences.combined(graph, &[q, opposite], &pair, self.passes);
        }
        let right_of_core: Vec<Node> = self.rows.iter().map(|&row| right[row]).collect();
        match self.factors {
            // the right-hand side is zero, and so is the solution
            Some(_) if right_of_core.iter().all(|&node| graph.is_zero(node)) => {
                rates.extend(
                    self.unknowns
                        .iter()
                        .zip(&right_of_core)
                        .map(|(&unknown, &value)| Rate::Value {
                            symbol: symbol(unknown),
                            value,
                        }),
                );
            }
            Some(factors) => rates.push(Rate::System {
                factors,
                symbols: self.unknowns.iter().map(|&unknown| symbol(unknown)).collect(),
                right: right_of_core,
            }),
            None => rates.extend(self.cramer(graph, influences, &right_of_core, symbol)),
        }
        for rotation in self.rotations.iter().rev() {
            let rest = without(graph, right[rotation.rows[0]], &rotation.others, &rates, symbol);
            let divisor = squares(graph, rotation.entries);
            let value = graph.divide(rest, divisor);
            rates.push(Rate::Value {
                symbol: symbol(rotation.unknown),
                value,
            });
        }
        rates
    }

    /// The rates of up to three remaining unknowns, by Cramer's rule.
    fn cramer(
        &self,
        graph: &mut Graph,
        influences: Influences,
        right: &[Node],
        symbol: &impl Fn(usize) -> Symbol,
    ) -> Vec<Rate> {
        let rate = |column: usize, value: Node| Rate::Value {
            symbol: symbol(self.unknowns[column]),
            value,
        };
        match self.core.as_slice() {
            [row] => {
                let one = graph.one();
                vec![rate(0, influences.quotient(graph, &[one], right, row[0], self.passes))]
            }
            [first, second] => {
                let determinant = determinant(graph, &self.core, self.passes);
                let weights = [[second[1], graph.negate(first[1])], [graph.negate(second[0]), first[0]]];
                (0..2)
                    .map(|column| {
                        rate(
                            column,
                            influences.quotient(graph, &weights[column], right, determinant, self.passes),
                        )
                    })
                    .collect()
            }
            matrix => {
                // the columns of the adjugate are cross products of the rows
                let cofactors = [
                    cross(graph, &matrix[1], &matrix[2]),
                    cross(graph, &matrix[2], &matrix[0]),
                    cross(graph, &matrix[0], &matrix[1]),
                ];
                let determinant = determinant(graph, matrix, self.passes);
                (0..3)
                    .map(|column| {
                        let weights = cofactors.map(|cofactor| cofactor[column]);
                        rate(
                            column,
                            influences.quotient(graph, &weights, right, determinant, self.passes),
                        )
                    })
                    .collect()
            }
        }
    }
}

/// p a + q b and q a - p b.
fn rotated(graph: &mut Graph, [p, q]: [Node; 2], [a, b]: [Node; 2]) -> (Node, Node) {
    let (pa, qb) = (graph.multiply(p, a), graph.multiply(q, b));
    let (qa, pb) = (graph.multiply(q, a), graph.multiply(p, b));
    (graph.add(pa, qb), graph.subtract(qa, pb))
}

fn squares(graph: &mut Graph, [p, q]: [Node; 2]) -> Node {
    let (p, q) = (graph.power(p, 2), graph.power(q, 2));
    graph.add(p, q)
}

/// A right-hand side minus the contributions of the rates found so far.
fn without(
    graph: &mut Graph,
    right: Node,
    others: &[(usize, Node)],
    found: &[Rate],
    symbol: &impl Fn(usize) -> Symbol,
) -> Node {
    let mut rest = right;
    for &(unknown, entry) in others {
        let symbol = symbol(unknown);
        let is_zero = |rate: &Rate| {
            let Rate::Value { symbol: known, value } = rate else {
                return false;
            };
            *known == symbol && graph.is_zero(*value)
        };
        if found.iter().any(is_zero) {
            continue;
        }
        let rate = graph.symbol(symbol);
        let product = graph.multiply(entry, rate);
        rest = graph.subtract(rest, product);
    }
    rest
}

/// The cross product of two rows of three entries.
fn cross(graph: &mut Graph, a: &[Node], b: &[Node]) -> [Node; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let (first, second) = (graph.multiply(a[i], b[j]), graph.multiply(a[j], b[i]));
        graph.subtract(first, second)
    })
}

fn determinant(graph: &mut Graph, matrix: &[Vec<Node>], passes: Passes) -> Node {
    match matrix {
        [row] => row[0],
        [first, second] => {
            let (main, other) = (graph.multiply(first[0], second[1]), graph.multiply(first[1], second[0]));
            let determinant = graph.subtract(main, other);
            radius(graph, determinant, passes)
        }
        [first, second, third] => {
            let cofactors = cross(graph, second, third);
            let terms: Vec<Node> = first
                .iter()
                .zip(cofactors)
                .map(|(&entry, cofactor)| graph.multiply(entry, cofactor))
                .collect();
            graph.sum(&terms)
        }
        _ => unreachable!("larger systems are factored at run time"),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::{BlockJacobian, Regularity};
    use crate::algebra::{Graph, Node, Symbol};
    use crate::derive::{Influences, Rate};
    use crate::passes::{Pass, Passes};
    use crate::structure::Block;

    /// The entry of a pattern's row in a column: zero, a number, or a parameter.
    fn entry(graph: &mut Graph, index: usize, letter: char) -> Node {
        match letter {
            '.' => graph.zero(),
            'n' => graph.number(4.0),
            _ => graph.symbol(Symbol::Parameter(index)),
        }
    }

    /// A value of about one half, or about four on the diagonal of a matrix of this size, so that the condition is
    /// below one hundred.
    fn value(size: usize, index: usize) -> f64 {
        let small = 0.3 + 0.1 * f64::from(u8::try_from(7 * index % 5).expect("it is less than five"));
        if index.is_multiple_of(size + 1) {
            4.0 + small
        } else {
            small
        }
    }

    /// The solution x of A x = right, by elimination with pivoting.
    fn eliminated(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
        let size = right.len();
        for step in 0..size {
            let pivot = (step..size)
                .max_by(|&a, &b| matrix[a][step].abs().total_cmp(&matrix[b][step].abs()))
                .expect("there is a row left");
            matrix.swap(step, pivot);
            right.swap(step, pivot);
            for row in (0..size).filter(|&row| row != step) {
                let factor = matrix[row][step] / matrix[step][step];
                let above = matrix[step].clone();
                for (entry, above) in matrix[row].iter_mut().zip(above) {
                    *entry -= factor * above;
                }
                right[row] -= factor * right[step];
            }
        }
        (0..size).map(|row| right[row] / matrix[row][row]).collect()
    }

    /// Solves J x = right for a Jacobian of a pattern, computes the rates in order, and substitutes them into the
    /// equations. Returns the number of rotations and the size of the remaining system.
    fn put_back(pattern: &[&str], passes: Passes, influences: Influences, is_still: bool) -> (usize, usize) {
        let size = pattern.len();
        let mut graph = Graph::new();
        let (mut residuals, mut right) = (Vec::new(), Vec::new());
        for (row, letters) in pattern.iter().enumerate() {
            let mut terms = Vec::new();
            for (column, letter) in letters.chars().enumerate() {
                let entry = entry(&mut graph, row * size + column, letter);
                let unknown = graph.symbol(Symbol::Unknown(column));
                terms.push(graph.multiply(entry, unknown));
            }
            residuals.push(graph.sum(&terms));
            let rate = graph.symbol(Symbol::InputRate(row, 1));
            right.push(if is_still { graph.zero() } else { rate });
        }
        let block = Block {
            equations: (0..size).collect(),
            unknowns: (0..size).collect(),
            parts: Vec::new(),
            all: None,
            check_jacobian: true,
        };
        let jacobian = BlockJacobian::new(&mut graph, &residuals, &block, passes);
        let rates = jacobian.solve(&mut graph, influences, &right, &|unknown| {
            Symbol::UnknownRate(unknown, 1)
        });
        let mut found: BTreeMap<Symbol, f64> = BTreeMap::new();
        let known = |found: &BTreeMap<Symbol, f64>, symbol: Symbol| match symbol {
            Symbol::Parameter(index) => value(size, index),
            Symbol::InputRate(row, _) => 1.0 + 0.7 * f64::from(u8::try_from(row).expect("it is small")),
            // a value used before it is computed makes the result NaN
            Symbol::UnknownRate(..) => found.get(&symbol).copied().unwrap_or(f64::NAN),
            _ => f64::NAN,
        };
        assert!(
            !is_still || rates.iter().all(|rate| matches!(rate, Rate::Value { .. })),
            "{pattern:?}: where nothing moves there is no system to be solved"
        );
        for rate in &rates {
            let values = match rate {
                Rate::Value { value, .. } => vec![graph.evaluate(*value, &|symbol| known(&found, symbol))],
                Rate::System { right, .. } => {
                    let at = |node: &Node| graph.evaluate(*node, &|symbol| known(&found, symbol));
                    let Regularity::Factors { matrix, .. } = jacobian.regularity(&mut graph.clone()) else {
                        panic!("the system is factored");
                    };
                    let matrix = matrix.iter().map(|row| row.iter().map(at).collect()).collect();
                    eliminated(matrix, right.iter().map(at).collect())
                }
            };
            for (&symbol, value) in rate.symbols().iter().zip(values) {
                assert_eq!(
                    found.insert(symbol, value),
                    None,
                    "{pattern:?}: {symbol:?} is found once"
                );
            }
        }
        for (residual, right) in residuals.into_iter().zip(right) {
            let left = graph.evaluate(residual, &|symbol| match symbol {
                Symbol::Unknown(unknown) => known(&found, Symbol::UnknownRate(unknown, 1)),
                _ => known(&found, symbol),
            });
            let right = graph.evaluate(right, &|symbol| known(&found, symbol));
            // a substitution takes a few dozen roundings of terms below ten
            assert!(
                (left - right).abs() < 1e-13,
                "{pattern:?}, {influences:?}: {left} and not {right}"
            );
        }
        (jacobian.rotations.len(), jacobian.core.len())
    }

    /// For every pattern of the Jacobian, the rates satisfy all equations, and each is found once, from earlier ones.
    /// The table lists the number of rotations and the size of the remaining system.
    #[test]
    fn rates_fulfil_the_equations_of_jacobians_of_every_pattern() {
        let patterns: [(&[&str], usize, usize); 10] = [
            (&["p"], 0, 1),
            (&["pp", "pp"], 0, 2),
            (&["p.", "pp"], 0, 2),
            (&["pp", "p."], 0, 2),
            (&["ppp", "ppp", "ppp"], 0, 3),
            (&["p..", "ppp", "ppp"], 0, 3),
            (&["pppp", "pppp", ".ppp", ".ppp"], 1, 3),
            (&["pppp", "pppp", "pppp", "pppp"], 0, 4),
            (&["ppppp", "ppppp", ".pppp", ".pppp", "..ppn"], 1, 4),
            (&["pp.pp", "pp.pp", "..ppp", "..ppp", "p...p"], 2, 3),
        ];
        for (pattern, rotations, left) in patterns {
            for influences in [Influences::Separate, Influences::Collected] {
                for is_still in [false, true] {
                    let of = |passes| put_back(pattern, passes, influences, is_still);
                    assert_eq!(of(Passes::ALL), (rotations, left), "{pattern:?}");
                    assert_eq!(
                        of(Passes::without(Pass::CramerOfThree)),
                        (rotations, left),
                        "{pattern:?}"
                    );
                    let whole = of(Passes::without(Pass::ReducedJacobians));
                    assert_eq!(whole, (0, pattern.len()), "{pattern:?}");
                }
            }
        }
    }
}
