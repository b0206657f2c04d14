//! A block's Jacobian, and the linear systems that it solves for the rates of every order.
//!
//! A large Jacobian is reduced first, by steps that cannot fail where its determinant does not vanish, whatever the position:
//! an entry that stands alone in its row or column is a factor of the determinant; two entries that stand alone in their
//! column, p and q, are turned into √(p² + q²) and zero; and an entry that is a number is a pivot at all times. What remains is
//! solved by Cramer's rule up to three unknowns, and beyond by the factors that the position has left.

use super::Rate;
use super::influence::Influences;
use super::radius::radius;
use crate::algebra::{Graph, Node, Symbol};
use crate::passes::{Pass, Passes};
use crate::structure::Block;

/// Up to so many unknowns are solved by Cramer's rule.
const CRAMER: usize = 3;

/// A Jacobian, reduced as far as it goes.
pub(super) struct Jacobian {
    pivots: Vec<Pivot>,
    /// The equations that remain, by their places in the block.
    rows: Vec<usize>,
    /// The unknowns that remain.
    unknowns: Vec<usize>,
    core: Vec<Vec<Node>>,
    /// The factors of the core, where it is too large for Cramer's rule.
    factors: Option<Symbol>,
}

/// A step of the reduction.
enum Pivot {
    /// The only unknown of an equation is found before all others; what it adds to the other equations.
    First {
        row: usize,
        unknown: usize,
        entry: Node,
        column: Vec<(usize, Node)>,
    },
    /// The only equation with an unknown gives it after all others.
    Last {
        row: usize,
        unknown: usize,
        entry: Node,
        others: Vec<(usize, Node)>,
    },
    /// An equation with a number before an unknown is subtracted from the others, and gives it after all others.
    Number {
        row: usize,
        unknown: usize,
        entry: Node,
        multiples: Vec<(usize, Node)>,
        others: Vec<(usize, Node)>,
    },
    /// Two equations with an unknown are turned so that only the first has it.
    Turn {
        rows: [usize; 2],
        entries: [Node; 2],
        unknown: usize,
        others: Vec<(usize, Node)>,
    },
}

/// The partial derivatives of a block's equations (rows) by its unknowns (columns).
fn partials(graph: &mut Graph, residuals: &[Node], block: &Block) -> Vec<Vec<Node>> {
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

impl Jacobian {
    pub(super) fn new(graph: &mut Graph, residuals: &[Node], block: &Block, passes: Passes) -> Self {
        let core = partials(graph, residuals, block);
        let mut jacobian = Self {
            pivots: Vec::new(),
            rows: (0..core.len()).collect(),
            unknowns: block.unknowns.clone(),
            core,
            factors: None,
        };
        while passes.include(Pass::ReducedJacobians) && jacobian.core.len() > 2 && jacobian.reduce(graph) {}
        if jacobian.core.len() > CRAMER {
            jacobian.factors = Some(graph.new_step().0);
        }
        jacobian
    }

    fn entries<'a>(&'a self, graph: &'a Graph, column: usize) -> impl Iterator<Item = usize> + 'a {
        (0..self.core.len()).filter(move |&row| !graph.is_zero(self.core[row][column]))
    }

    /// One step of the reduction; false if there is none.
    fn reduce(&mut self, graph: &mut Graph) -> bool {
        let size = self.core.len();
        for row in 0..size {
            let filled: Vec<usize> = (0..size)
                .filter(|&column| !graph.is_zero(self.core[row][column]))
                .collect();
            if let [column] = filled[..] {
                self.first(graph, row, column);
                return true;
            }
        }
        let columns: Vec<Vec<usize>> = (0..size).map(|column| self.entries(graph, column).collect()).collect();
        if let Some(column) = columns.iter().position(|rows| rows.len() == 1) {
            self.last(graph, columns[column][0], column);
            return true;
        }
        if size <= CRAMER {
            return false;
        }
        let is_constant = |&(row, _): &(usize, usize)| self.core[row].iter().all(|&entry| !graph.has_unknowns(entry));
        let numbers: Vec<(usize, usize)> = (0..size)
            .flat_map(|row| (0..size).map(move |column| (row, column)))
            .filter(|&(row, column)| {
                graph
                    .as_number(self.core[row][column])
                    .is_some_and(|number| number != 0.0)
            })
            .collect();
        if let Some(&(row, column)) = numbers.iter().find(|place| is_constant(place)) {
            self.number(graph, row, column);
            return true;
        }
        if let Some(column) = columns.iter().position(|rows| rows.len() == 2) {
            self.turn(graph, [columns[column][0], columns[column][1]], column);
            return true;
        }
        if let Some(&(row, column)) = numbers.first() {
            self.number(graph, row, column);
            return true;
        }
        false
    }

    /// What else stands in a row, by unknown.
    fn others(&self, graph: &Graph, row: usize, column: usize) -> Vec<(usize, Node)> {
        self.core[row]
            .iter()
            .enumerate()
            .filter(|&(other, &entry)| other != column && !graph.is_zero(entry))
            .map(|(other, &entry)| (self.unknowns[other], entry))
            .collect()
    }

    fn remove(&mut self, row: usize, column: usize) {
        self.core.remove(row);
        self.rows.remove(row);
        self.unknowns.remove(column);
        for entries in &mut self.core {
            entries.remove(column);
        }
    }

    fn first(&mut self, graph: &Graph, row: usize, column: usize) {
        let others = self
            .entries(graph, column)
            .filter(|&other| other != row)
            .map(|other| (self.rows[other], self.core[other][column]))
            .collect();
        self.pivots.push(Pivot::First {
            row: self.rows[row],
            unknown: self.unknowns[column],
            entry: self.core[row][column],
            column: others,
        });
        self.remove(row, column);
    }

    fn last(&mut self, graph: &Graph, row: usize, column: usize) {
        self.pivots.push(Pivot::Last {
            row: self.rows[row],
            unknown: self.unknowns[column],
            entry: self.core[row][column],
            others: self.others(graph, row, column),
        });
        self.remove(row, column);
    }

    fn number(&mut self, graph: &mut Graph, row: usize, column: usize) {
        let entry = self.core[row][column];
        let mut multiples = Vec::new();
        for other in 0..self.core.len() {
            if other == row || graph.is_zero(self.core[other][column]) {
                continue;
            }
            let factor = graph.divide(self.core[other][column], entry);
            for place in 0..self.unknowns.len() {
                let product = graph.multiply(factor, self.core[row][place]);
                self.core[other][place] = graph.subtract(self.core[other][place], product);
            }
            multiples.push((self.rows[other], factor));
        }
        self.pivots.push(Pivot::Number {
            row: self.rows[row],
            unknown: self.unknowns[column],
            entry,
            multiples,
            others: self.others(graph, row, column),
        });
        self.remove(row, column);
    }

    fn turn(&mut self, graph: &mut Graph, rows: [usize; 2], column: usize) {
        let entries = rows.map(|row| self.core[row][column]);
        let mut others = Vec::new();
        for place in (0..self.unknowns.len()).filter(|&place| place != column) {
            let values = rows.map(|row| self.core[row][place]);
            let (along, across) = turned(graph, entries, values);
            if !graph.is_zero(along) {
                others.push((self.unknowns[place], along));
            }
            self.core[rows[1]][place] = across;
        }
        self.pivots.push(Pivot::Turn {
            rows: rows.map(|row| self.rows[row]),
            entries,
            unknown: self.unknowns[column],
            others,
        });
        self.remove(rows[0], column);
    }

    /// What must not vanish: the determinant as a product of what it factors into.
    pub(super) fn regular(&self, graph: &mut Graph) -> Vec<Node> {
        let mut factors: Vec<Node> = self
            .pivots
            .iter()
            .filter_map(|pivot| match pivot {
                Pivot::First { entry, .. } | Pivot::Last { entry, .. } => Some(*entry),
                Pivot::Number { .. } | Pivot::Turn { .. } => None,
            })
            .collect();
        if self.factors.is_none() && !self.core.is_empty() {
            factors.push(determinant(graph, &self.core));
        }
        factors
    }

    /// What rates are divided by that does not vanish where the determinant does not.
    pub(super) fn guaranteed(&self, graph: &mut Graph) -> Vec<Node> {
        let mut nodes = Vec::new();
        if let [first, second] = self.core.as_slice()
            && first.iter().chain(second).any(|&entry| graph.is_zero(entry))
        {
            nodes.extend(first.iter().chain(second).filter(|&&entry| !graph.is_zero(entry)));
        }
        for pivot in &self.pivots {
            if let Pivot::Turn { entries, .. } = pivot {
                nodes.push(squares(graph, *entries));
            }
        }
        nodes
    }

    /// What is to be factored when the position is known.
    pub(super) fn system(&self) -> Option<(Symbol, Vec<Vec<Node>>)> {
        Some((self.factors?, self.core.clone()))
    }

    /// The x of J x = right, one for each unknown, in the order in which they can be computed; `symbol` is what later ones
    /// know earlier ones by.
    pub(super) fn solve(
        &self,
        graph: &mut Graph,
        influences: Influences,
        right: &[Node],
        symbol: &impl Fn(usize) -> Symbol,
    ) -> Vec<Rate> {
        let mut right = right.to_vec();
        let mut rates: Vec<Rate> = Vec::new();
        for pivot in &self.pivots {
            match pivot {
                Pivot::First {
                    row,
                    unknown,
                    entry,
                    column,
                } => {
                    let value = graph.divide(right[*row], *entry);
                    rates.push(Rate::Value {
                        symbol: symbol(*unknown),
                        value,
                    });
                    for &(other, entry) in column {
                        right[other] = without(graph, right[other], &[(*unknown, entry)], &rates, symbol);
                    }
                }
                Pivot::Number { row, multiples, .. } => {
                    for &(other, factor) in multiples {
                        let product = graph.multiply(factor, right[*row]);
                        right[other] = graph.subtract(right[other], product);
                    }
                }
                Pivot::Turn { rows, entries, .. } => {
                    let [p, q] = *entries;
                    let opposite = graph.negate(p);
                    let own = rows.map(|row| right[row]);
                    right[rows[0]] = influences.combined(graph, &[p, q], &own);
                    right[rows[1]] = influences.combined(graph, &[q, opposite], &own);
                }
                Pivot::Last { .. } => {}
            }
        }
        let own: Vec<Node> = self.rows.iter().map(|&row| right[row]).collect();
        match self.factors {
            // nothing to be solved for
            Some(_) if own.iter().all(|&node| graph.is_zero(node)) => {
                rates.extend(self.unknowns.iter().zip(&own).map(|(&unknown, &value)| Rate::Value {
                    symbol: symbol(unknown),
                    value,
                }));
            }
            Some(factors) => rates.push(Rate::System {
                factors,
                symbols: self.unknowns.iter().map(|&unknown| symbol(unknown)).collect(),
                right: own,
            }),
            None => rates.extend(self.cramer(graph, influences, &own, symbol)),
        }
        for pivot in self.pivots.iter().rev() {
            let (row, unknown, entry, others) = match pivot {
                Pivot::First { .. } => continue,
                Pivot::Last {
                    row,
                    unknown,
                    entry,
                    others,
                }
                | Pivot::Number {
                    row,
                    unknown,
                    entry,
                    others,
                    ..
                } => (*row, *unknown, *entry, others),
                Pivot::Turn {
                    rows,
                    entries,
                    unknown,
                    others,
                } => (rows[0], *unknown, squares(graph, *entries), others),
            };
            let rest = without(graph, right[row], others, &rates, symbol);
            let value = graph.divide(rest, entry);
            rates.push(Rate::Value {
                symbol: symbol(unknown),
                value,
            });
        }
        rates
    }

    /// The rates of what remains, up to three unknowns, by Cramer's rule.
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
            [] => Vec::new(),
            [row] => {
                let one = graph.one();
                vec![rate(0, influences.quotient(graph, &[one], right, row[0]))]
            }
            [first, second] => {
                if let Some(rates) = self.triangular(graph, influences, right, symbol) {
                    return rates;
                }
                let determinant = determinant(graph, &self.core);
                let weights = [[second[1], graph.negate(first[1])], [graph.negate(second[0]), first[0]]];
                (0..2)
                    .map(|column| rate(column, influences.quotient(graph, &weights[column], right, determinant)))
                    .collect()
            }
            matrix => {
                // the columns of the adjugate are the cross products of the rows
                let cofactors = [
                    cross(graph, &matrix[1], &matrix[2]),
                    cross(graph, &matrix[2], &matrix[0]),
                    cross(graph, &matrix[0], &matrix[1]),
                ];
                let determinant = determinant(graph, matrix);
                (0..3)
                    .map(|column| {
                        let weights = cofactors.map(|cofactor| cofactor[column]);
                        rate(column, influences.quotient(graph, &weights, right, determinant))
                    })
                    .collect()
            }
        }
    }

    /// The rates of two unknowns, if one of the two equations has only one of them: it first, the other from it.
    fn triangular(
        &self,
        graph: &mut Graph,
        influences: Influences,
        right: &[Node],
        symbol: &impl Fn(usize) -> Symbol,
    ) -> Option<Vec<Rate>> {
        let places = [(0, 0), (0, 1), (1, 0), (1, 1)];
        let (row, column) = places
            .into_iter()
            .find(|&(row, column)| graph.is_zero(self.core[row][column]))?;
        let (other_row, first) = (1 - row, 1 - column);
        let one = graph.one();
        let first_value = influences.quotient(graph, &[one], &right[row..=row], self.core[row][first]);
        let mut rates = vec![Rate::Value {
            symbol: symbol(self.unknowns[first]),
            value: first_value,
        }];
        let known = [(self.unknowns[first], self.core[other_row][first])];
        let rest = without(graph, right[other_row], &known, &rates, symbol);
        let value = influences.quotient(graph, &[one], &[rest], self.core[other_row][column]);
        rates.push(Rate::Value {
            symbol: symbol(self.unknowns[column]),
            value,
        });
        Some(rates)
    }
}

/// p a + q b and q a - p b.
fn turned(graph: &mut Graph, [p, q]: [Node; 2], [a, b]: [Node; 2]) -> (Node, Node) {
    let (pa, qb) = (graph.multiply(p, a), graph.multiply(q, b));
    let (qa, pb) = (graph.multiply(q, a), graph.multiply(p, b));
    (graph.add(pa, qb), graph.subtract(qa, pb))
}

fn squares(graph: &mut Graph, [p, q]: [Node; 2]) -> Node {
    let (p, q) = (graph.power(p, 2), graph.power(q, 2));
    graph.add(p, q)
}

/// A right-hand side less what the rates found add to its equation.
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
        let is_zero =
            |rate: &Rate| matches!(rate, Rate::Value { symbol: own, value } if *own == symbol && graph.is_zero(*value));
        if found.iter().any(is_zero) {
            continue;
        }
        let rate = graph.symbol(symbol);
        let product = graph.multiply(entry, rate);
        rest = graph.subtract(rest, product);
    }
    rest
}

/// The cross product of two rows of three.
fn cross(graph: &mut Graph, a: &[Node], b: &[Node]) -> [Node; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let (first, second) = (graph.multiply(a[i], b[j]), graph.multiply(a[j], b[i]));
        graph.subtract(first, second)
    })
}

fn determinant(graph: &mut Graph, matrix: &[Vec<Node>]) -> Node {
    match matrix {
        [row] => row[0],
        [first, second] => {
            let (main, other) = (graph.multiply(first[0], second[1]), graph.multiply(first[1], second[0]));
            let determinant = graph.subtract(main, other);
            radius(graph, determinant).unwrap_or(determinant)
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

    use super::{Jacobian, Pivot};
    use crate::algebra::{Graph, Node, Symbol};
    use crate::derive::{Influences, Rate};
    use crate::passes::{Pass, Passes};
    use crate::structure::Block;

    /// What a row of a pattern has in a column: nothing, a number, or a parameter.
    fn entry(graph: &mut Graph, place: usize, letter: char) -> Node {
        match letter {
            '.' => graph.zero(),
            'n' => graph.number(4.0),
            _ => graph.symbol(Symbol::Parameter(place)),
        }
    }

    /// Entries of about a half, and of about four on the diagonal of a matrix of this size, for a condition below a hundred.
    fn value(size: usize, place: usize) -> f64 {
        let small = 0.3 + 0.1 * f64::from(u8::try_from(7 * place % 5).expect("it is less than five"));
        if place.is_multiple_of(size + 1) {
            4.0 + small
        } else {
            small
        }
    }

    /// x of A x = right, by elimination, with pivots of rows.
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

    /// Solves J x = right for a Jacobian of some pattern, computes the rates one after the other, and puts them back into the
    /// equations. The steps of the reduction are handed back by their initials, and how large a system they left.
    fn put_back(pattern: &[&str], passes: Passes, influences: Influences, is_still: bool) -> (String, usize) {
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
        let jacobian = Jacobian::new(&mut graph, &residuals, &block, passes);
        let rates = jacobian.solve(&mut graph, influences, &right, &|unknown| {
            Symbol::UnknownRate(unknown, 1)
        });
        let mut found: BTreeMap<Symbol, f64> = BTreeMap::new();
        let known = |found: &BTreeMap<Symbol, f64>, symbol: Symbol| match symbol {
            Symbol::Parameter(place) => value(size, place),
            Symbol::InputRate(row, _) => 1.0 + 0.7 * f64::from(u8::try_from(row).expect("it is small")),
            // what is used before it is found makes the result NaN
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
                    let (_, matrix) = jacobian.system().expect("it is factored");
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
            // what is put back differs by a few dozen roundings of terms below ten
            assert!(
                (left - right).abs() < 1e-13,
                "{pattern:?}, {influences:?}: {left} and not {right}"
            );
        }
        let steps = jacobian.pivots.iter().map(|pivot| match pivot {
            Pivot::First { .. } => 'F',
            Pivot::Last { .. } => 'L',
            Pivot::Number { .. } => 'N',
            Pivot::Turn { .. } => 'T',
        });
        (steps.collect(), jacobian.core.len())
    }

    /// Whatever the pattern of the Jacobian, the rates fulfil all of its equations, each is found once, and from what is found
    /// before it. The table has the steps of the reduction, and the size of what they leave.
    #[test]
    fn rates_fulfil_the_equations_of_jacobians_of_every_pattern() {
        let patterns: [(&[&str], &str, usize); 14] = [
            (&["p"], "", 1),
            (&["pp", "pp"], "", 2),
            (&["p.", "pp"], "", 2),
            (&[".p", "pp"], "", 2),
            (&["pp", ".p"], "", 2),
            (&["pp", "p."], "", 2),
            (&["ppp", "ppp", "ppp"], "", 3),
            (&["p..", "ppp", "ppp"], "F", 2),
            (&["ppp", ".pp", ".pp"], "L", 2),
            (&["npp.", "pppp", "p.pp", "pp.p"], "N", 3),
            (&["pppp", "pppp", ".ppp", ".ppp"], "T", 3),
            (&["pppp", "pppp", "pppp", "pppp"], "", 4),
            (&["p.....", "pppppp", "p.pppp", "..pppp", "..pppp", "..pppp"], "FL", 4),
            (&["ppppp", "ppppp", ".pppp", ".pppp", "..ppn"], "NT", 3),
        ];
        for (pattern, steps, left) in patterns {
            for influences in [Influences::Separate, Influences::Collected] {
                for is_still in [false, true] {
                    let reduced = put_back(pattern, Passes::ALL, influences, is_still);
                    assert_eq!(reduced, (steps.to_owned(), left), "{pattern:?}");
                    let whole = put_back(pattern, Passes::without(Pass::ReducedJacobians), influences, is_still);
                    assert_eq!(whole, (String::new(), pattern.len()), "{pattern:?}");
                }
            }
        }
    }
}
