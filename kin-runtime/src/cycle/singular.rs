//! The positions at which a block is singular: the real solutions of the closure and det J = 0, with the input unknown.

use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;

use num_traits::Float;

use super::Incomplete;
use super::closure::Closure;
use super::polynomial::{ClosurePolynomial, ClosureQuantity, Quantities, determinant};
use super::sought::SoughtMechanism;
use crate::assemblies::continuation::{BorrowedSystem, BorrowedTerm, real_solutions};
use crate::mechanism::Block;
use crate::quantity::Name;

/// The largest number of paths.
const MOST_PATHS: usize = 1024;

/// A term: its equation, its coefficient, and the powers of variables.
type OwnedTerm = (u16, f64, Vec<(u16, u8)>);
/// A real solution, and whether it is multiple.
type SingularSolution = (Vec<f64>, bool);

/// A position at which a block is singular.
#[derive(Clone, Debug)]
pub(super) struct SingularPosition {
    pub(super) input: f64,
    /// The unknowns on which the block depends.
    pub(super) unknowns: Vec<Singular>,
    /// Whether the system has a multiple solution here.
    pub(super) is_multiple: bool,
}

/// An unknown at a singular position.
#[derive(Clone, Copy, Debug)]
pub(super) struct Singular {
    pub(super) index: usize,
    pub(super) value: f64,
    /// The rate at which it moves while the input stands still, where the fastest unknown has the rate 1.
    pub(super) rate: f64,
}

/// The singular positions of every block. The input is the first of the quantities.
///
/// # Errors
/// Says if an unknown may grow beyond all bounds, if there are too many paths, or if one of them was lost.
pub(super) fn singular_positions(
    mechanism: &SoughtMechanism<'_>,
    closure: &Closure,
) -> Result<Vec<SingularPosition>, Incomplete> {
    let blocks = mechanism.blocks();
    let quantities = &closure.quantities;
    if !is_bounded(quantities, &closure.equations) {
        return Err(Incomplete::Unbounded);
    }
    let mut all = Vec::new();
    for (block, singular_block) in blocks.iter().enumerate() {
        let (name, members) = (mechanism.block_name(block), singular_block.members);
        let mut system = Vec::new();
        let mut involved = match closure.slide_angle {
            Some(_) => Vec::new(),
            None => vec![0],
        };
        for needed in needed(closure, blocks, block) {
            let Block { equations, members, .. } = blocks[needed];
            system.extend(equations.iter().map(|equation| closure.equations[*equation].clone()));
            involved.extend(members.iter().map(|member| member + 1));
        }
        reduce(&mut system);
        // The determinant has more terms than can be counted if the block is large. It only adds to the paths.
        let paths = paths(closure, &system, &involved);
        if paths > MOST_PATHS {
            return Err(Incomplete::TooManyPaths {
                block: name,
                paths,
                most: MOST_PATHS,
            });
        }
        let row = |equation: &usize| {
            let columns = members.iter();
            columns
                .map(|member| closure.derivative(*equation, member + 1))
                .collect()
        };
        let matrix: Vec<Vec<ClosurePolynomial>> = singular_block.equations.iter().map(row).collect();
        let singular = determinant(&matrix);
        if singular.is_zero() {
            return Err(Incomplete::AlwaysSingular { block: name });
        }
        if singular.degree() == 0 {
            continue;
        }
        system.push(singular);
        // A block on which the input has no effect stands still.
        if closure.slide_angle.is_some_and(|angle| !involved.contains(&angle)) {
            continue;
        }
        for (at, is_multiple) in solutions(closure, &system, &involved, name)? {
            let mut variables = quantities.variables(&at);
            if let Some(angle) = closure.slide_angle {
                let first = usize::from(quantities.first(angle));
                variables[first] *= at[0];
                variables[first + 1] *= at[0];
            }
            let numbers = matrix
                .iter()
                .map(|row| row.iter().map(|entry| entry.value(&variables)).collect())
                .collect();
            let rates = kernel(numbers);
            let rate = |unknown: usize| {
                let index = members.iter().position(|member| *member == unknown);
                index.map_or(0.0, |index| rates[index])
            };
            let unknowns = involved.iter().filter_map(|quantity| {
                let index = quantity.checked_sub(1)?;
                Some(Singular {
                    index,
                    value: at[*quantity],
                    rate: rate(index),
                })
            });
            all.push(SingularPosition {
                input: match closure.added {
                    Some((angle, sign)) => at[0] - f64::from(sign) * at[angle],
                    None => at[0],
                },
                unknowns: unknowns.collect(),
                is_multiple,
            });
        }
    }
    Ok(all)
}

/// The product of the degrees of a system and of the circles of its angles.
fn paths(closure: &Closure, system: &[ClosurePolynomial], involved: &[usize]) -> usize {
    let is_on_circle = |quantity: &&usize| {
        closure.slide_angle != Some(**quantity) && closure.quantities.kind(**quantity) == ClosureQuantity::Angle
    };
    let circles = involved.iter().filter(is_on_circle).map(|_| 2);
    let degrees = system.iter().map(|polynomial| polynomial.degree().max(1));
    degrees.chain(circles).fold(1, usize::saturating_mul)
}

/// Subtracts equations from each other, so that fewer have a degree above one.
fn reduce(system: &mut [ClosurePolynomial]) {
    for pivot in 0..system.len() {
        let highest = |polynomial: &ClosurePolynomial| {
            let degree = |powers: &[(u16, u8)]| powers.iter().map(|(_, power)| u32::from(*power)).sum::<u32>();
            let high = polynomial.terms().filter(|(powers, _)| degree(powers) > 1);
            high.max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()))
                .map(|(powers, coefficient)| (powers.to_vec(), coefficient))
        };
        let Some((powers, coefficient)) = highest(&system[pivot]) else {
            continue;
        };
        let pivot_equation = system[pivot].clone();
        for (index, other) in system.iter_mut().enumerate() {
            let share = other.coefficient(&powers) / coefficient;
            if index != pivot && share != 0.0 {
                *other = other.plus(&pivot_equation, -share);
            }
        }
    }
}

/// A vector of the kernel of a singular matrix, with the largest entry 1, by elimination with complete pivoting.
fn kernel(mut matrix: Vec<Vec<f64>>) -> Vec<f64> {
    let count = matrix.len();
    let mut order: Vec<usize> = (0..count).collect();
    for step in 0..count.saturating_sub(1) {
        let entries = (step..count).flat_map(|row| (step..count).map(move |column| (row, column)));
        let best = entries.max_by(|one, other| matrix[one.0][one.1].abs().total_cmp(&matrix[other.0][other.1].abs()));
        let Some((row, column)) = best else { break };
        matrix.swap(step, row);
        order.swap(step, column);
        for matrix_row in &mut matrix {
            matrix_row.swap(step, column);
        }
        let pivot = matrix[step].clone();
        for lower_row in matrix.iter_mut().skip(step + 1) {
            let share = lower_row[step] / pivot[step];
            for (entry, pivot) in lower_row.iter_mut().zip(&pivot) {
                *entry -= share * pivot;
            }
        }
    }
    let mut solution = vec![0.0; count];
    let mut vector = vec![0.0; count];
    for row in (0..count).rev() {
        solution[row] = if row + 1 == count {
            1.0
        } else {
            let sum: f64 = (row + 1..count)
                .map(|column| matrix[row][column] * solution[column])
                .sum();
            -sum / matrix[row][row]
        };
        vector[order[row]] = solution[row];
    }
    let largest = vector.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
    vector.into_iter().map(|entry| entry / largest).collect()
}

/// The blocks on which a block depends, itself included, in the order of solution.
fn needed(closure: &Closure, blocks: &[Block<'_>], block: usize) -> Vec<usize> {
    let mut needed = vec![false; block + 1];
    needed[block] = true;
    for candidate in (0..=block).rev() {
        if !needed[candidate] {
            continue;
        }
        let terms = blocks[candidate]
            .equations
            .iter()
            .flat_map(|equation| closure.equations[*equation].terms());
        for (variable, _) in terms.flat_map(|(powers, _)| powers) {
            let quantity = closure.quantities.quantity(*variable);
            let earlier = blocks[..candidate]
                .iter()
                .position(|block| quantity > 0 && block.members.contains(&(quantity - 1)));
            if let Some(earlier) = earlier {
                needed[earlier] = true;
            }
        }
    }
    (0..=block).filter(|candidate| needed[*candidate]).collect()
}

/// Whether no unknown can grow beyond all bounds while the input is finite: each length is alone in an equation with a
/// constant coefficient, or in the two equations of a loop with the coefficients cos θ and sin θ.
fn is_bounded(quantities: &Quantities, equations: &[ClosurePolynomial]) -> bool {
    let count = quantities.len() - 1;
    let mut bounded: Vec<bool> = (0..=count)
        .map(|quantity| quantity == 0 || quantities.kind(quantity) == ClosureQuantity::Angle)
        .collect();
    loop {
        let mut has_changed = false;
        for quantity in 1..=count {
            if bounded[quantity] {
                continue;
            }
            let variable_of_length = quantities.first(quantity);
            // The other factors of the terms with the quantity, in equations without another unbounded one.
            let slopes = equations.iter().filter_map(|equation| {
                let is_alone = equation.terms().all(|(powers, _)| {
                    powers.iter().all(|&(variable, power)| {
                        bounded[quantities.quantity(variable)] || (variable == variable_of_length && power == 1)
                    })
                });
                let slope = equation.derivative(quantities, quantity);
                (is_alone && !slope.is_zero()).then_some(slope)
            });
            let slopes: Vec<ClosurePolynomial> = slopes.collect();
            // Two slopes with a constant sum of squares, which is not zero, do not vanish together.
            let is_unit_vector = |one: &ClosurePolynomial, other: &ClosurePolynomial| {
                let mut squares = one.times(one);
                squares.add_multiple(&other.times(other), 1.0);
                squares.reduced(quantities).degree() == 0
            };
            bounded[quantity] = slopes.iter().enumerate().any(|(index, slope)| {
                slope.degree() == 0 || slopes[index + 1..].iter().any(|other| is_unit_vector(slope, other))
            });
            has_changed |= bounded[quantity];
        }
        if !has_changed {
            return bounded.into_iter().all(|bounded| bounded);
        }
    }
}

/// The real solutions of a system for a block, as values of all quantities, of which some are involved, and whether
/// they are multiple.
fn solutions(
    closure: &Closure,
    system: &[ClosurePolynomial],
    involved: &[usize],
    block: Name,
) -> Result<Vec<SingularSolution>, Incomplete> {
    let lost = Incomplete::PathLost { block };
    let quantities = &closure.quantities;
    let mut first = Vec::new();
    let mut count = 0_u16;
    for quantity in involved {
        first.push(count);
        count += if quantities.kind(*quantity) == ClosureQuantity::Angle {
            2
        } else {
            1
        };
    }
    // The variable of the system for a variable of the closure.
    let renumbered = |variable: u16| {
        let quantity = quantities.quantity(variable);
        let index = involved.iter().position(|known| *known == quantity)?;
        Some(first[index] + (variable - quantities.first(quantity)))
    };
    let mut terms: Vec<OwnedTerm> = Vec::new();
    let paths = paths(closure, system, involved);
    let mut equation = 0_u16;
    for polynomial in system {
        for (powers, coefficient) in polynomial.terms() {
            let powers: Option<Vec<(u16, u8)>> = powers
                .iter()
                .map(|(variable, power)| Some((renumbered(*variable)?, *power)))
                .collect();
            terms.push((equation, coefficient, powers.ok_or(lost)?));
        }
        equation += 1;
    }
    let mut pairs = Vec::new();
    for (quantity, first) in involved.iter().zip(&first) {
        if closure.slide_angle == Some(*quantity) {
            pairs.push([*first, *first + 1]);
        } else if quantities.kind(*quantity) == ClosureQuantity::Angle {
            for powers in [vec![(*first, 2)], vec![(*first + 1, 2)], Vec::new()] {
                terms.push((equation, if powers.is_empty() { -1.0 } else { 1.0 }, powers));
            }
            equation += 1;
        }
    }
    let most = MOST_PATHS;
    let real = match (usize::from(count), paths) {
        _ if equation != count => None,
        (0..=6, 0..=32) => real::<6, 32>(&mut terms, &pairs, count),
        (0..=10, 0..=128) => real::<10, 128>(&mut terms, &pairs, count),
        (0..=20, 0..=MOST_PATHS) => real::<20, MOST_PATHS>(&mut terms, &pairs, count),
        _ => return Err(Incomplete::TooManyPaths { block, paths, most }),
    };
    let real = real.ok_or(lost)?;
    let mut all = Vec::new();
    for (variables, is_multiple) in real {
        let mut at = vec![0.0; quantities.len()];
        for (quantity, first) in involved.iter().zip(&first) {
            let first = usize::from(*first);
            at[*quantity] = match quantities.kind(*quantity) {
                ClosureQuantity::Angle => Float::atan2(variables[first + 1], variables[first]),
                ClosureQuantity::Plain => variables[first],
            };
            if closure.slide_angle == Some(*quantity) {
                at[0] = Float::hypot(variables[first], variables[first + 1]);
            }
        }
        all.push((at.clone(), is_multiple));
        // A negative length points the other way.
        if let Some(angle) = closure.slide_angle {
            at[0] = -at[0];
            at[angle] -= PI.copysign(at[angle]);
            all.push((at, is_multiple));
        }
    }
    Ok(all)
}

/// The real solutions of a system of `count` equations, with room for `N` variables. The others are zero.
fn real<const N: usize, const PATHS: usize>(
    terms: &mut Vec<OwnedTerm>,
    pairs: &[[u16; 2]],
    count: u16,
) -> Option<Vec<SingularSolution>> {
    for variable in count..u16::try_from(N).ok()? {
        terms.push((variable, 1.0, vec![(variable, 1)]));
    }
    let coefficients: Vec<f64> = terms.iter().map(|(_, coefficient, _)| *coefficient).collect();
    let table: Option<Vec<BorrowedTerm<'_>>> = terms
        .iter()
        .enumerate()
        .map(|(index, (equation, _, powers))| Some(BorrowedTerm::new(*equation, u16::try_from(index).ok()?, powers)))
        .collect();
    let table = table?;
    let mut found = Vec::new();
    let counts = real_solutions::<N, PATHS>(
        &BorrowedSystem::new(&table).with_pairs(pairs),
        &coefficients,
        |solution| {
            found.push((solution.values[..usize::from(count)].to_vec(), !solution.is_regular()));
        },
    );
    counts.is_ok_and(|counts| counts.is_complete()).then_some(found)
}
