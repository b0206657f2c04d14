//! Equations to blocks: which equations determine which unknowns, in which order, and how they are solved.
//!
//! The scalar equations are matched to the unknowns, the matching is ordered into the smallest blocks that can be
//! solved one after another, and each block is compared with the closed forms that are known. A block that fits none is torn
//! into parts, of which as few as possible are left to Newton's method.

mod arm;
mod closed_form;
mod complex;
mod dyads;
mod matching;
mod order;
mod polynomials;
mod recognise;
mod tear;

use std::collections::BTreeSet;

pub(crate) use arm::Arm;
pub(crate) use closed_form::ClosedForm;
pub(crate) use complex::ComplexNode;
pub(crate) use dyads::{Dyad, dyads};
pub(crate) use polynomials::{PolynomialSystem, Variable};

use crate::algebra::{Expansion, Graph, Misfit, Node, Probe, Symbol, Variables};

/// Unknowns that are solved together, the equations that determine them, and how.
pub(crate) struct Block {
    /// The numbers of the scalar equations, ascending.
    pub(crate) equations: Vec<usize>,
    /// The numbers of the unknowns, ascending.
    pub(crate) unknowns: Vec<usize>,
    /// How they are solved, one part after another; most blocks are of one part.
    pub(crate) parts: Vec<Part>,
    /// All solutions of a block of which a part is left to Newton's method, if its equations are algebraic.
    pub(crate) all: Option<PolynomialSystem>,
    /// Whether the parts alone do not guarantee that the Jacobian is regular where they succeed.
    pub(crate) check_jacobian: bool,
}

/// Unknowns of a block that are found in one step.
pub(crate) struct Part {
    /// Their numbers, ascending.
    pub(crate) unknowns: Vec<usize>,
    pub(crate) method: Method,
}

/// How a part is solved.
pub(crate) enum Method {
    Closed(ClosedForm),
    /// By Newton's method for as many expressions that must vanish, in which earlier parts' unknowns are known.
    Newton {
        residuals: Vec<Node>,
        /// Whether the equations were too large to be compared with the closed forms.
        is_given_up: bool,
    },
}

impl Block {
    /// Whether a part of it is left to Newton's method, and so has no assembly with a name.
    pub(crate) fn is_coupled(&self) -> bool {
        self.parts
            .iter()
            .any(|part| matches!(part.method, Method::Newton { .. }))
    }
}

/// Why a declaration cannot be solved; equations and unknowns by number.
pub(crate) enum Fault {
    /// More unknowns than the equations that contain them.
    Underdetermined {
        unknowns: Vec<usize>,
        equations: Vec<usize>,
    },
    /// More equations than unknowns in them; `surplus` are the ones left over.
    Overdetermined {
        unknowns: Vec<usize>,
        equations: Vec<usize>,
        surplus: Vec<usize>,
    },
    /// Equations that say the same, so that they do not determine their unknowns.
    Dependent {
        unknowns: Vec<usize>,
        equations: Vec<usize>,
        repeats: Option<(usize, usize)>,
    },
}

/// Equations `residual == 0` in blocks.
pub(crate) struct Structure {
    pub(crate) graph: Graph,
    pub(crate) residuals: Vec<Node>,
    /// The blocks in the order in which they are solved.
    pub(crate) blocks: Vec<Block>,
}

/// Why equations have no structure.
pub(crate) enum Refusal {
    /// A constant follows from them that no number is.
    Constants(Misfit),
    Faults(Vec<Fault>),
}

/// Orders scalar equations into solvable blocks.
pub(crate) fn analyse(mut graph: Graph, residuals: &[Node], unknowns: usize) -> Result<Structure, Refusal> {
    let residuals = without_cancelling(&mut graph, residuals, Variables::AllUnknowns);
    let blocks = blocks(&mut graph, &residuals, unknowns);
    if let Some(misfit) = graph.misfit() {
        return Err(Refusal::Constants(misfit));
    }
    Ok(Structure {
        blocks: blocks.map_err(Refusal::Faults)?,
        graph,
        residuals,
    })
}

/// The blocks, or all faults.
fn blocks(graph: &mut Graph, residuals: &[Node], unknowns: usize) -> Result<Vec<Block>, Vec<Fault>> {
    let incidence = incidence(graph, residuals, Variables::AllUnknowns);
    let matching = matching::Matching::of(&incidence, unknowns);
    let mut faults = matching.faults(&incidence);
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut blocks = Vec::new();
    for equations in order::blocks(&incidence, &matching) {
        let mut members: Vec<usize> = equations
            .iter()
            .map(|&equation| matching.unknown_of(equation))
            .collect();
        members.sort_unstable();
        match solve_block(graph, residuals, equations, members) {
            Ok(block) => blocks.push(block),
            Err(fault) => faults.push(fault),
        }
    }
    if faults.is_empty() { Ok(blocks) } else { Err(faults) }
}

/// The same equations, each multiplied out if an unknown cancels then: its solution would otherwise be written with that unknown,
/// which may not be known before it.
fn without_cancelling(graph: &mut Graph, equations: &[Node], variables: Variables<'_>) -> Vec<Node> {
    let incidence = incidence(graph, equations, variables);
    let mut without = Vec::new();
    for (&equation, contained) in equations.iter().zip(&incidence) {
        let cancels = |unknown: usize| variables.include(Symbol::Unknown(unknown)) && !contained.contains(&unknown);
        without.push(if graph.unknowns(equation).any(cancels) {
            Expansion::new(graph, variables).equation(equation).node(graph)
        } else {
            equation
        });
    }
    without
}

/// The unknowns that each equation contains, once it is multiplied out.
fn incidence(graph: &mut Graph, equations: &[Node], variables: Variables<'_>) -> Vec<BTreeSet<usize>> {
    equations
        .iter()
        .map(|&equation| {
            let polynomial = Expansion::new(graph, variables).equation(equation);
            polynomial.unknowns(graph, variables)
        })
        .collect()
}

fn solve_block(
    graph: &mut Graph,
    residuals: &[Node],
    equations: Vec<usize>,
    unknowns: Vec<usize>,
) -> Result<Block, Fault> {
    if is_dependent(graph, residuals, &equations, &unknowns) {
        let repeats = repeated(graph, residuals, &equations);
        return Err(Fault::Dependent {
            unknowns,
            equations,
            repeats,
        });
    }
    let nodes: Vec<Node> = equations.iter().map(|&equation| residuals[equation]).collect();
    let cleared = nodes.iter().any(|&node| {
        Expansion::new(graph, Variables::Unknowns(&unknowns))
            .polynomial(node)
            .is_none()
    });
    let parts = tear::parts(graph, &nodes, &unknowns);
    let check_jacobian = match parts.as_slice() {
        [
            Part {
                method: Method::Closed(form),
                ..
            },
        ] => cleared || form.has_inverse(),
        _ => true,
    };
    let mut block = Block {
        equations,
        unknowns,
        parts,
        all: None,
        check_jacobian,
    };
    if block.is_coupled() {
        let whole = tear::whole(graph, &nodes, &block.unknowns);
        block.all = polynomials::system(graph, whole);
    }
    Ok(block)
}

/// Whether the block's Jacobian is singular everywhere: then the equations do not determine the unknowns.
fn is_dependent(graph: &mut Graph, residuals: &[Node], equations: &[usize], unknowns: &[usize]) -> bool {
    let jacobian: Vec<Vec<Node>> = equations
        .iter()
        .map(|&equation| {
            unknowns
                .iter()
                .map(|&unknown| graph.partial(residuals[equation], Symbol::Unknown(unknown)))
                .collect()
        })
        .collect();
    let mut probed = false;
    for point in 0..Probe::all().count() {
        let values: Vec<Vec<f64>> = jacobian
            .iter()
            .map(|row| row.iter().map(|&entry| graph.probe(entry)[point]).collect())
            .collect();
        if values.iter().flatten().all(|value| value.is_finite()) {
            probed = true;
            if has_full_rank(values) {
                return false;
            }
        }
    }
    probed
}

/// Gaussian elimination with complete pivoting.
fn has_full_rank(mut rows: Vec<Vec<f64>>) -> bool {
    let size = rows.len();
    let largest = rows
        .iter()
        .flatten()
        .fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
    for step in 0..size {
        let (pivot_row, pivot_column) = (step..size)
            .flat_map(|row| (step..size).map(move |column| (row, column)))
            .max_by(|&(a, b), &(c, d)| rows[a][b].abs().total_cmp(&rows[c][d].abs()))
            .expect("there is an entry left");
        if rows[pivot_row][pivot_column].abs() <= 1e-11 * largest {
            return false;
        }
        rows.swap(step, pivot_row);
        for row in &mut rows {
            row.swap(step, pivot_column);
        }
        let pivot = rows[step].clone();
        for row in rows.iter_mut().skip(step + 1) {
            let factor = row[step] / pivot[step];
            for (entry, above) in row.iter_mut().zip(&pivot).skip(step) {
                *entry -= factor * above;
            }
        }
    }
    true
}

/// Two equations of a block of which one is a multiple of the other, by a number or by parameters.
fn repeated(graph: &mut Graph, residuals: &[Node], equations: &[usize]) -> Option<(usize, usize)> {
    for (position, &second) in equations.iter().enumerate() {
        for &first in &equations[..position] {
            let ratio = graph.divide(residuals[first], residuals[second]);
            // the same parameters with everything else changed
            let ratios: Vec<f64> = Probe::all()
                .map(|probe| {
                    graph.evaluate(ratio, &|symbol| match symbol {
                        Symbol::Parameter(_) => Probe::FIRST.value(symbol),
                        _ => probe.value(symbol),
                    })
                })
                .collect();
            if ratios
                .iter()
                .all(|value| (value - ratios[0]).abs() <= 1e-9 * ratios[0].abs())
            {
                return Some((first, second));
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::has_full_rank;

    /// The rank is that of the rows, whatever their scale and order.
    #[test]
    fn rows_have_full_rank_unless_one_follows_from_the_others() {
        let matrix = |rows: [[f64; 3]; 3]| rows.map(|row| row.to_vec()).to_vec();
        assert!(has_full_rank(matrix([
            [1.0, 2.0, 3.0],
            [4.0, 5.0, 6.0],
            [7.0, 8.0, 10.0]
        ])));
        assert!(has_full_rank(matrix([
            [0.0, 0.0, 1e-9],
            [0.0, 1e-9, 0.0],
            [1e-9, 0.0, 0.0]
        ])));
        // the last row is twice the second less the first
        assert!(!has_full_rank(matrix([
            [1.0, 2.0, 3.0],
            [4.0, 5.0, 6.0],
            [7.0, 8.0, 9.0]
        ])));
        assert!(!has_full_rank(matrix([
            [0.3, 0.7, 0.2],
            [0.1, 0.9, 0.4],
            [0.2, 1.8, 0.8]
        ])));
        assert!(!has_full_rank(matrix([[0.0; 3], [0.0; 3], [0.0; 3]])));
    }
}
