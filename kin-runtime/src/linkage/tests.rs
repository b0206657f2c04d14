//! A linkage without its type gives the numbers of its type.

use std::f64::consts::TAU;
use std::vec::Vec;

use super::AnyLinkage;
use crate::any::{AssemblyChoice, Of};
use crate::cycle::FullCycle;
use crate::extremes::Over;
use crate::law::{Rise, Shape};
use crate::library::{FiveBar, FourBar};
use crate::mechanism::Mechanism;
use crate::mechanism::condition::conditions;
use crate::number::{Number, Row, samples};
use crate::sweep::samples::{CRANK_ROCKER, triad};
use crate::sweep::{Local, Swept};
use crate::verify::Random;

/// The answers along a turn of the first input, in one assembly.
fn agrees<M: Mechanism<Scalar = f64>>(mechanism: &M, from: M::Inputs<f64>, assembly: M::Assembly) {
    let name = M::DESCRIPTION.name;
    let linkage = AnyLinkage::of(mechanism);
    let choice = AssemblyChoice::of::<M>(assembly);
    let to = M::Inputs::from_fn(|input| if input == 0 { from[0] + TAU } else { from[input] });
    let typed = mechanism.sweep(assembly).between(from, to, 25).speed(3.0);
    let any = linkage
        .sweep(choice.clone())
        .between(from.as_ref(), to.as_ref(), 25)
        .speed(3.0);
    let (one, other) = (typed.table().unwrap(), any.table(Of::<M>::FUNCTIONS).unwrap());
    for (one, other) in one.columns().zip(other.columns()) {
        let mut pairs = one.values.iter().zip(other.values);
        assert!(pairs.all(|(one, other)| one.to_bits() == other.to_bits()), "{name}");
    }
    assert_eq!(one.limits(), other.limits());
    for (row, (at, reached)) in any.rows().iter().enumerate() {
        assert_eq!(*at, typed.at(row));
        assert_eq!(reached.is_ok(), one.outcome(row).unwrap().is_solved(), "{name}");
    }
    // a search of coupled blocks takes seconds without optimisation
    let rates: &[&str] = if choice.index().is_some() {
        &["", "_velocity", "_snap"]
    } else {
        &["_velocity"]
    };
    for unknown in M::DESCRIPTION.unknowns.iter().take(2) {
        for rate in rates {
            let column = std::format!("{}{rate}", unknown.name);
            let (one, other) = (typed.of(&column), any.of(&column));
            assert_eq!(one.extremes(), other.extremes(), "{name}");
            assert_eq!(one.rms(Over::Time), other.rms(Over::Time), "{name}");
            assert_eq!(one.peak_sensitivities(), other.peak_sensitivities(), "{name}");
        }
    }
    if let Ok(position) = mechanism.position(from, assembly) {
        let found = linkage.conditions(from.as_ref(), position.as_ref());
        assert_eq!(conditions(mechanism, &from, &position).as_ref(), found, "{name}");
    }
    for dyad in 0..linkage.dyad_count() {
        let one = typed.of_expression(|at| {
            at.transmission_angle(dyad)
                .map_or(Local::constant(f64::NAN), |angle| angle.folded())
        });
        // zero at a limit, up to the rounding of typed rates
        let [one, other] = [one.lowest().unwrap(), any.of_transmission_angle(dyad).lowest().unwrap()];
        assert!((one.value - other.value).abs() < 1e-11, "{name}: {one} {other}");
    }
    if M::DESCRIPTION.order > 0 {
        let rise = Rise::new(Shape::ModifiedSine, from[0], from[0] + 0.5, 0.3).unwrap();
        let rests: Vec<Rise> = (1..M::DESCRIPTION.inputs.len())
            .map(|input| Rise::new(Shape::ModifiedSine, from[input], from[input], 0.3).unwrap())
            .collect();
        let laws: Vec<&dyn crate::law::Piecewise<f64>> = core::iter::once(&rise)
            .chain(&rests)
            .map(|law| law as &dyn crate::law::Piecewise<f64>)
            .collect();
        let column = std::format!("{}_jerk", M::DESCRIPTION.unknowns[0].name);
        let one = mechanism
            .sweep(assembly)
            .under_laws(Row::from_fn(|input| laws[input]), 0.0..=0.3, 9);
        let other = linkage.sweep(choice).under_laws(&laws, 0.0..=0.3, 9);
        assert_eq!(one.of(&column).peak(), other.of(&column).peak(), "{name}");
    }
}

fn cycles_agree<M: Mechanism<Scalar = f64>>(mechanism: &M, from: M::Inputs<f64>) {
    let direction = M::Inputs::from_fn(|input| if input == 0 { 1.0 } else { 0.0 });
    let one = mechanism.cycle_along(from, direction).unwrap();
    let other = AnyLinkage::of(mechanism)
        .cycle_along(from.as_ref(), direction.as_ref())
        .unwrap();
    assert_eq!(*one, *other);
    let name = M::DESCRIPTION.unknowns[0].name;
    for circuit in 0..one.circuits().len() {
        assert_eq!(
            one.along(circuit).of(name).stroke(),
            other.along(circuit).of(name).stroke()
        );
        assert_eq!(
            one.along(circuit).of(name).time_ratio(),
            other.along(circuit).of(name).time_ratio()
        );
        assert_eq!(
            one.along(circuit).worst_transmission(),
            other.along(circuit).worst_transmission()
        );
        for &branch in one.circuits()[circuit].branches() {
            let [low, high] = one.branches()[branch].ends().map(|end| end.input);
            let (one, other) = (
                one.position_on(branch, 0.3 * low + 0.7 * high),
                other.position_on(branch, 0.3 * low + 0.7 * high),
            );
            assert_eq!(one.map(|one| one.as_ref().to_vec()), other);
        }
    }
}

/// Both comparisons at the first position that is found.
fn compare<M: Mechanism<Scalar = f64>>(mechanism: &M, start: M::Inputs<f64>) -> bool {
    cycles_agree(
        mechanism,
        M::Inputs::from_fn(|input| if input == 0 { 0.0 } else { start[input] }),
    );
    let mut first = None;
    let search = mechanism.positions_at(start, |assembly, _| first = first.or(Some(assembly)));
    if let (Ok(_), Some(assembly)) = (search, first) {
        agrees(mechanism, start, assembly);
    }
    first.is_some()
}

#[test]
fn random_linkages_answer_without_their_types() {
    let mut random = Random::new(31);
    let mut closed = 0;
    for _ in 0..samples::some_of(3, 100) {
        let [r1, r2, r3, r4] = [(); 4].map(|()| random.between(0.3, 2.0));
        let start = [random.between(-3.0, 3.0)];
        closed += u32::from(compare(&FourBar { r1, r2, r3, r4 }, start));
    }
    assert!(closed > samples::some_of(1, 40), "{closed}");
}

#[test]
fn several_inputs_outputs_and_coupled_blocks_answer_without_their_types() {
    let robot = FiveBar {
        ground: 2.0,
        left: 0.5,
        left_rod: 2.0,
        right_rod: 2.0,
        right: 1.5,
    };
    assert!(compare(&robot, [0.3, 1.0]));
    assert!(compare(&CRANK_ROCKER, [0.2]));
    // as many seconds as all others together
    if samples::are_all() {
        assert!(compare(&triad(), [1.8; 3]));
    }
}
