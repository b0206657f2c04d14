//! The positions at which a block is singular: the real solutions of the closure and det J = 0, with the input unknown.

use alloc::vec;
use alloc::vec::Vec;

use num_traits::Float;

use super::polynomial::{Kind, Polynomial, Quantities, determinant, polynomials};
use crate::assemblies::continuation::{BorrowedSystem, BorrowedTerm, real_solutions};

/// The largest number of paths.
const MOST_PATHS: usize = 1024;

/// A position at which a block is singular.
#[derive(Clone, Debug)]
pub(super) struct SingularPosition {
    pub(super) input: f64,
    /// The indices of the unknowns on which the block depends, and their values.
    pub(super) unknowns: Vec<(usize, f64)>,
    /// Whether the system has a multiple solution here.
    pub(super) is_multiple: bool,
}

/// The singular positions of every block. `blocks` are the indices of their equations and of their unknowns. The input is the first of the
/// quantities.
///
/// It is `None` if the closure is not algebraic, if an unknown may grow beyond all bounds, if there are too many paths, or if one of them was
/// lost.
pub(super) fn singular_positions(
    quantities: &Quantities,
    size: f64,
    blocks: &[[&[usize]; 2]],
    closure: &mut dyn FnMut(&[f64], &mut [f64]),
) -> Option<Vec<SingularPosition>> {
    let equations = polynomials(quantities, size.max(f64::MIN_POSITIVE), quantities.len() - 1, closure);
    let equations: Vec<Polynomial> = equations.into_iter().collect::<Option<_>>()?;
    if !is_bounded(quantities, &equations) {
        return None;
    }
    let mut all = Vec::new();
    for (block, [own, members]) in blocks.iter().enumerate() {
        let row = |equation: &usize| {
            let columns = members.iter();
            columns
                .map(|member| equations[*equation].derivative(quantities, member + 1))
                .collect()
        };
        let matrix: Vec<Vec<Polynomial>> = own.iter().map(row).collect();
        let singular = determinant(&matrix);
        if singular.is_zero() {
            return None;
        }
        if singular.degree() == 0 {
            continue;
        }
        let needed = needed(quantities, &equations, blocks, block);
        let of_blocks = |side: usize| needed.iter().flat_map(move |block| blocks[*block][side]);
        let mut system: Vec<&Polynomial> = of_blocks(0).map(|equation| &equations[*equation]).collect();
        system.push(&singular);
        let members: Vec<usize> = core::iter::once(0)
            .chain(of_blocks(1).map(|member| member + 1))
            .collect();
        for (values, is_multiple) in solutions(quantities, &system, &members)? {
            let unknowns = members[1..].iter().zip(&values[1..]);
            all.push(SingularPosition {
                input: values[0],
                unknowns: unknowns.map(|(member, value)| (member - 1, *value)).collect(),
                is_multiple,
            });
        }
    }
    Some(all)
}

/// The blocks on which a block depends, itself included, in the order of solution.
fn needed(quantities: &Quantities, equations: &[Polynomial], blocks: &[[&[usize]; 2]], block: usize) -> Vec<usize> {
    let mut needed = vec![false; block + 1];
    needed[block] = true;
    for own in (0..=block).rev() {
        if !needed[own] {
            continue;
        }
        let terms = blocks[own][0].iter().flat_map(|equation| equations[*equation].terms());
        for (variable, _) in terms.flat_map(|(powers, _)| powers) {
            let quantity = quantities.quantity(*variable);
            let earlier = blocks[..own]
                .iter()
                .position(|[_, members]| quantity > 0 && members.contains(&(quantity - 1)));
            if let Some(earlier) = earlier {
                needed[earlier] = true;
            }
        }
    }
    (0..=block).filter(|own| needed[*own]).collect()
}

/// Whether no unknown can grow beyond all bounds while the input is finite: each length is alone in an equation with a constant
/// coefficient, or in the two equations of a loop with the coefficients cos θ and sin θ.
fn is_bounded(quantities: &Quantities, equations: &[Polynomial]) -> bool {
    let count = quantities.len() - 1;
    let mut bounded: Vec<bool> = (0..=count)
        .map(|quantity| quantity == 0 || quantities.kind(quantity) == Kind::Angle)
        .collect();
    loop {
        let mut has_changed = false;
        for quantity in 1..=count {
            if bounded[quantity] {
                continue;
            }
            let own = quantities.first(quantity);
            // The other factors of the terms with the quantity, in equations without another unbounded one.
            let slopes = equations.iter().filter_map(|equation| {
                let is_alone = equation.terms().all(|(powers, _)| {
                    powers.iter().all(|&(variable, power)| {
                        bounded[quantities.quantity(variable)] || (variable == own && power == 1)
                    })
                });
                let slope = equation.derivative(quantities, quantity);
                (is_alone && !slope.is_zero()).then_some(slope)
            });
            let slopes: Vec<Polynomial> = slopes.collect();
            let is_turned = |one: &Polynomial, other: &Polynomial| {
                let angles: Vec<usize> = (0..=count)
                    .filter(|angle| quantities.kind(*angle) == Kind::Angle)
                    .collect();
                angles.into_iter().any(|angle| {
                    [1.0, -1.0]
                        .into_iter()
                        .any(|sign| one.derivative(quantities, angle).is_multiple(other, sign))
                })
            };
            bounded[quantity] = slopes.iter().enumerate().any(|(place, slope)| {
                slope.degree() == 0 || slopes[place + 1..].iter().any(|other| is_turned(slope, other))
            });
            has_changed |= bounded[quantity];
        }
        if !has_changed {
            return bounded.into_iter().all(|bounded| bounded);
        }
    }
}

/// The real solutions of a system, as values of some quantities, and whether they are multiple. `None` if there are too many paths, or if
/// one was lost.
fn solutions(quantities: &Quantities, system: &[&Polynomial], members: &[usize]) -> Option<Vec<(Vec<f64>, bool)>> {
    let mut first = Vec::new();
    let mut count = 0_u16;
    for member in members {
        first.push(count);
        let is_angle = quantities.kind(*member) == Kind::Angle;
        count += if is_angle { 2 } else { 1 };
    }
    // The variable of the system for a variable of the closure.
    let own = |variable: u16| {
        let quantity = quantities.quantity(variable);
        let place = members.iter().position(|member| *member == quantity)?;
        Some(first[place] + (variable - quantities.first(quantity)))
    };
    let mut terms: Vec<(u16, f64, Vec<(u16, u8)>)> = Vec::new();
    let mut paths = 1_usize;
    let mut equation = 0_u16;
    for polynomial in system {
        paths = paths.saturating_mul(polynomial.degree().max(1));
        for (powers, coefficient) in polynomial.terms() {
            let powers: Option<Vec<(u16, u8)>> = powers
                .iter()
                .map(|(variable, power)| Some((own(*variable)?, *power)))
                .collect();
            terms.push((equation, coefficient, powers?));
        }
        equation += 1;
    }
    for (member, first) in members.iter().zip(&first) {
        if quantities.kind(*member) == Kind::Angle {
            for powers in [vec![(*first, 2)], vec![(*first + 1, 2)], Vec::new()] {
                terms.push((equation, if powers.is_empty() { -1.0 } else { 1.0 }, powers));
            }
            paths = paths.saturating_mul(2);
            equation += 1;
        }
    }
    if equation != count || paths > MOST_PATHS {
        return None;
    }
    let real = match (usize::from(count), paths) {
        (0..=6, 0..=32) => real::<6, 32>(&mut terms, count)?,
        (0..=10, 0..=128) => real::<10, 128>(&mut terms, count)?,
        (0..=20, _) => real::<20, MOST_PATHS>(&mut terms, count)?,
        _ => return None,
    };
    let values = |variables: Vec<f64>| {
        let places = members.iter().zip(&first);
        places
            .map(|(member, first)| {
                let first = usize::from(*first);
                match quantities.kind(*member) {
                    Kind::Angle => Float::atan2(variables[first + 1], variables[first]),
                    Kind::Plain => variables[first],
                }
            })
            .collect()
    };
    Some(
        real.into_iter()
            .map(|(variables, is_multiple)| (values(variables), is_multiple))
            .collect(),
    )
}

/// The real solutions of a system of `count` equations, with room for `N` variables. The others are zero.
fn real<const N: usize, const PATHS: usize>(
    terms: &mut Vec<(u16, f64, Vec<(u16, u8)>)>,
    count: u16,
) -> Option<Vec<(Vec<f64>, bool)>> {
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
    let counts = real_solutions::<N, PATHS>(&BorrowedSystem::new(&table), &coefficients, |solution| {
        found.push((solution.values[..usize::from(count)].to_vec(), !solution.is_regular()));
    });
    counts.is_ok_and(|counts| counts.is_complete()).then_some(found)
}
