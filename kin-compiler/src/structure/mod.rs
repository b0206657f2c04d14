//! Equations to blocks: the equations that determine each unknown, their order, and the method of solution.
//!
//! The scalar equations are matched to the unknowns. The matching is ordered into the smallest blocks that can be
//! solved one after another, and each block is compared with the closed forms. A block without a closed form is torn
//! into parts, of which Newton's method solves as few as possible.

mod arm;
mod body;
mod closed_form;
mod closure;
mod complex;
mod dyads;
mod form;
mod growth;
mod matching;
mod order;
mod polynomials;
mod recognise;
mod tear;

use std::collections::BTreeSet;

pub(crate) use arm::Arm;
pub(crate) use closed_form::ClosedForm;
pub(crate) use closure::{ClosureMonomial, closure_polynomials};
pub(crate) use complex::ComplexNode;
pub(crate) use dyads::{Dyad, dyads};
pub use form::BlockKind;
pub(crate) use form::block_forms;
pub(crate) use growth::CoefficientMagnitudes;
pub(crate) use polynomials::{PolynomialSystem, PolynomialVariable};
pub use polynomials::{PolynomialTerm, SystemForm};

use crate::algebra::{Expansion, Graph, Misfit, Node, Probe, Symbol, Variables};
use crate::work;

/// Unknowns that are solved together, the equations that determine them, and the method.
pub(crate) struct Block {
    /// The indices of the scalar equations, ascending.
    pub(crate) equations: Vec<usize>,
    /// The indices of the unknowns, ascending.
    pub(crate) unknowns: Vec<usize>,
    /// The parts of the solution, in order. Most blocks have one part.
    pub(crate) parts: Vec<Part>,
    /// The system that gives all solutions, for a block with algebraic equations and a part for Newton's method.
    pub(crate) all: Option<PolynomialSystem>,
    /// Whether the Jacobian may be singular although the parts have been solved.
    pub(crate) check_jacobian: bool,
}

/// Unknowns of a block that one step finds.
pub(crate) struct Part {
    /// The indices of the unknowns, ascending.
    pub(crate) unknowns: Vec<usize>,
    pub(crate) method: Method,
}

/// The method that solves a part.
pub(crate) enum Method {
    Closed(ClosedForm),
    /// Newton's method. It finds as many unknowns as there are residuals; the unknowns of earlier parts are known.
    Newton {
        residuals: Vec<Node>,
        /// Whether the equations were too large to be compared with the closed forms.
        is_given_up: bool,
    },
}

impl Block {
    /// Whether Newton's method solves a part of the block, so that its assemblies have no names.
    pub(crate) fn is_coupled(&self) -> bool {
        self.parts
            .iter()
            .any(|part| matches!(part.method, Method::Newton { .. }))
    }
}

/// The reason why a declaration cannot be solved. Equations and unknowns are given by index.
pub(crate) enum Fault {
    /// An unknown that cancels out of every equation that should determine it.
    Cancels { unknown: usize },
    /// An equation out of which every unknown cancels.
    WithoutUnknown { equation: usize },
    /// More unknowns than equations that contain them.
    Underdetermined {
        unknowns: Vec<usize>,
        equations: Vec<usize>,
    },
    /// More equations than unknowns; `surplus` are the unmatched equations.
    Overdetermined {
        unknowns: Vec<usize>,
        equations: Vec<usize>,
        surplus: Vec<usize>,
    },
    /// Equations that repeat each other and so do not determine their unknowns.
    Dependent {
        unknowns: Vec<usize>,
        equations: Vec<usize>,
        repeats: Option<(usize, usize)>,
    },
}

/// Equations `residual == 0`, ordered into blocks.
pub(crate) struct Structure {
    pub(crate) graph: Graph,
    pub(crate) residuals: Vec<Node>,
    /// The blocks in the order in which they are solved.
    pub(crate) blocks: Vec<Block>,
}

/// The reason why equations have no structure.
pub(crate) enum Refusal {
    /// A constant that follows from them does not fit an `f64`.
    Constants(Misfit),
    Faults(Vec<Fault>),
}

/// Orders scalar equations into solvable blocks.
pub(crate) fn analyse(
    mut graph: Graph,
    residuals: &[Node],
    unknowns: usize,
    magnitudes: &CoefficientMagnitudes,
) -> Result<Structure, Refusal> {
    let residuals = without_cancelling(&mut graph, residuals, Variables::AllUnknowns);
    let blocks = blocks(&mut graph, &residuals, unknowns, magnitudes);
    // the constants of what cancels mean nothing
    let cancels = |faults: &Vec<Fault>| faults.iter().any(|fault| matches!(fault, Fault::Cancels { .. }));
    let blocks = match blocks {
        Err(faults) if cancels(&faults) => return Err(Refusal::Faults(faults)),
        blocks => blocks,
    };
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
fn blocks(
    graph: &mut Graph,
    residuals: &[Node],
    unknowns: usize,
    magnitudes: &CoefficientMagnitudes,
) -> Result<Vec<Block>, Vec<Fault>> {
    let incidence = incidence(graph, residuals, Variables::AllUnknowns);
    let cancelled = cancelled(&incidence, unknowns);
    // an unknown may also be lost with a coefficient that is too small for an `f64`
    if !cancelled.is_empty() && graph.misfit().is_none() {
        return Err(cancelled);
    }
    let matching = matching::Matching::of(&incidence, unknowns);
    let mut faults = matching.faults(&incidence);
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut blocks = Vec::new();
    for equations in order::blocks(&incidence, &matching) {
        if work::is_spent() {
            break;
        }
        let mut members: Vec<usize> = equations
            .iter()
            .map(|&equation| matching.unknown_of(equation))
            .collect();
        members.sort_unstable();
        match solve_block(graph, residuals, magnitudes, equations, members) {
            Ok(block) => blocks.push(block),
            Err(fault) => faults.push(fault),
        }
    }
    if faults.is_empty() { Ok(blocks) } else { Err(faults) }
}

/// The unknowns that are in no equation after these are multiplied out, otherwise the equations without unknowns.
fn cancelled(incidence: &[BTreeSet<usize>], unknowns: usize) -> Vec<Fault> {
    let is_missing = |unknown: &usize| !incidence.iter().any(|contained| contained.contains(unknown));
    let missing: Vec<Fault> = (0..unknowns)
        .filter(is_missing)
        .map(|unknown| Fault::Cancels { unknown })
        .collect();
    if !missing.is_empty() {
        return missing;
    }
    let equations = incidence.iter().enumerate();
    equations
        .filter(|(_, contained)| contained.is_empty())
        .map(|(equation, _)| Fault::WithoutUnknown { equation })
        .collect()
}

/// The same equations, each multiplied out if that cancels an unknown. The solution would otherwise contain this
/// unknown, which may not be known yet.
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

/// The unknowns that each equation contains after it is multiplied out.
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
    magnitudes: &CoefficientMagnitudes,
    equations: Vec<usize>,
    unknowns: Vec<usize>,
) -> Result<Block, Fault> {
    for &unknown in &unknowns {
        let mut cancels = |&equation: &usize| {
            let partial = graph.partial(residuals[equation], Symbol::Unknown(unknown));
            graph.cancels(partial)
        };
        if equations.iter().all(&mut cancels) {
            return Err(Fault::Cancels { unknown });
        }
    }
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
    let parts = tear::parts(graph, magnitudes, &nodes, &unknowns);
    let check_jacobian = match parts.as_slice() {
        [
            Part {
                method: Method::Closed(form),
                ..
            },
        ] => cleared || form.has_inverse() || matches!(form, ClosedForm::LinearSystem { .. }),
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

/// Whether the block's Jacobian is singular everywhere. Then the equations do not determine the unknowns.
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
        if work::is_spent() {
            return false;
        }
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

/// Whether a matrix has full rank, by Gaussian elimination with complete pivoting.
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
            work::iteration();
        }
        if work::is_spent() {
            return true;
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

/// Two equations of a block, one a multiple of the other by a number or by parameters.
fn repeated(graph: &mut Graph, residuals: &[Node], equations: &[usize]) -> Option<(usize, usize)> {
    for (position, &second) in equations.iter().enumerate() {
        for &first in &equations[..position] {
            let ratio = graph.divide(residuals[first], residuals[second]);
            // the same parameters, with all other symbols changed
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

    /// The rank depends neither on the scale nor on the order of the rows.
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
        // the last row is twice the second minus the first
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
