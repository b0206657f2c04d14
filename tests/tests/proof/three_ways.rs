//! Every system of the notes, every order, three ways in one table:
//!
//! - **generated**: the solver that `mechanism!` writes from the declaration;
//! - **notes**: the formulas that lecture notes derive by hand, transcribed line by line in `tests/src/notes`;
//! - **hyper-dual**: the generated position solver alone, run on the dual numbers of `num-dual`, which differentiate
//!   it. The velocity comes from `Dual`, the acceleration from `HyperDual`, the jerk from `HyperHyperDual` and the snap
//!   from `HyperDual<HyperDual>`.
//!
//! The notes know nothing of the generated code. The dual numbers know nothing of its derivatives, and take the
//! position from it.
//!
//! The table is printed: `cargo test -p kin-tests --test proof three_ways -- --nocapture`.

use kin_core::library::{
    FourBar, FreudensteinFourBar, GeometricFourBar, InvertedSliderCrank, OffsetSliderCrank, SliderCrank,
    SliderCrankFirstApproximation, SliderCrankHigherApproximation,
};
use kin_core::prelude::*;
use kin_core::{Dimension, Number};
use kin_tests::compare::turned_back;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::notes::{self, sample};
use kin_tests::oracles::{ALLOWED, Gauge};
use num_dual::{Dual64, HyperDual, HyperDual64, HyperHyperDual64};

/// A quantity and its derivatives in time: position, velocity, acceleration, jerk, snap.
type Orders = [f64; 5];

/// The motion of the crank, which is that of the notes' sample table.
const CRANK: Orders = sample::THETA2;

#[test]
fn every_system_of_the_notes() {
    four_bar_as_a_vector_loop();
    four_bar_by_the_geometric_method();
    four_bar_by_freudenstein();
    slider_crank();
    slider_crank_with_offset();
    slider_crank_by_series();
    inverted_slider_crank();
}

const BOTH: [(Assembly, notes::Assembly); 2] = [
    (Assembly::Open, notes::Assembly::Open),
    (Assembly::Crossed, notes::Assembly::Crossed),
];

fn four_bar_as_a_vector_loop() {
    let notes::four_bar_geometric::Dimensions { r1, r2, r3, r4 } = sample::DIMENSIONS;
    for (assembly, by_hand) in BOTH {
        let notes = notes::four_bar_geometric::solve(sample::DIMENSIONS, CRANK, by_hand);
        System::new("four-bar, vector loop", FourBar { r1, r2, r3, r4 }, assembly)
            .compare(CRANK, &[notes.theta3, notes.theta4]);
    }
}

fn four_bar_by_the_geometric_method() {
    let notes::four_bar_geometric::Dimensions { r1, r2, r3, r4 } = sample::DIMENSIONS;
    let linkage = GeometricFourBar { r1, r2, r3, r4 };
    for (assembly, by_hand) in BOTH {
        let notes = notes::four_bar_geometric::solve(sample::DIMENSIONS, CRANK, by_hand);
        let by_hand = [
            notes.e,
            notes.alpha,
            notes.gamma,
            notes.beta,
            notes.theta4,
            notes.theta3,
        ];
        let assembly = linkage.assembly(CRANK[0], assembly);
        System::new("four-bar, geometric method", linkage, assembly).compare(CRANK, &by_hand);
    }
}

/// The notes stop at the acceleration here. Their jerk and snap of the same angles are those of the geometric method.
fn four_bar_by_freudenstein() {
    let notes::four_bar_geometric::Dimensions { r1, r2, r3, r4 } = sample::DIMENSIONS;
    let assemblies = [FreudensteinFourBar::OPEN, FreudensteinFourBar::CROSSED];
    for (assembly, (_, by_hand)) in assemblies.into_iter().zip(BOTH) {
        let notes = notes::freudenstein::solve(sample::DIMENSIONS, CRANK, by_hand);
        let geometric = notes::four_bar_geometric::solve(sample::DIMENSIONS, CRANK, by_hand);
        let through_snap = |[q, q_1, q_2]: [f64; 3], [.., q_3, q_4]: Orders| [q, q_1, q_2, q_3, q_4];
        let theta3 = through_snap(notes.theta3, geometric.theta3);
        let theta4 = through_snap(notes.theta4, geometric.theta4);
        System::new(
            "four-bar, Freudenstein",
            FreudensteinFourBar { r1, r2, r3, r4 },
            assembly,
        )
        .compare(CRANK, &[theta3, theta4]);
    }
}

fn slider_crank() {
    use notes::slider_crank::{Dimensions, Rod, solve};
    let (r, l) = (1.0, 3.0);
    for (assembly, rod) in [(Assembly::Open, Rod::Forward), (Assembly::Crossed, Rod::Backward)] {
        let notes = solve(Dimensions { r, l }, CRANK, rod);
        System::new("slider-crank", SliderCrank { r, l }, assembly).compare(CRANK, &[notes.phi, notes.s]);
    }
}

fn slider_crank_with_offset() {
    use notes::slider_crank::{Dimensions, Rod, solve_offset};
    let (r, l, h) = (1.0, 3.0, 0.4);
    for (assembly, rod) in [(Assembly::Open, Rod::Forward), (Assembly::Crossed, Rod::Backward)] {
        let notes = solve_offset(Dimensions { r, l }, h, CRANK, rod);
        System::new("slider-crank with offset", OffsetSliderCrank { r, l, h }, assembly)
            .compare(CRANK, &[notes.phi, notes.s]);
    }
}

/// At constant speed, for which the notes derive the series.
fn slider_crank_by_series() {
    use notes::slider_crank_approximate::{Dimensions, first, higher_order};
    let (r, l) = (1.0, 3.5);
    let [angle, speed, ..] = CRANK;
    let crank = [angle, speed, 0.0, 0.0, 0.0];
    let mechanism = SliderCrankFirstApproximation { r, l };
    System::explicit("slider-crank, first approximation", mechanism)
        .compare(crank, &[first(Dimensions { r, l }, angle, speed)]);
    let mechanism = SliderCrankHigherApproximation { r, l };
    System::explicit("slider-crank, through (R/L)^5", mechanism)
        .compare(crank, &[higher_order(Dimensions { r, l }, angle, speed)]);
}

/// The notes divide by the cosine of theta4, which adds to the condition of their result.
fn inverted_slider_crank() {
    use notes::inverted_slider_crank::{Dimensions, solve};
    let (r1, r2) = (2.0, 0.8);
    let notes = solve(Dimensions { r1, r2 }, CRANK, false);
    let mut system = System::explicit("inverted slider-crank", InvertedSliderCrank { r1, r2 });
    system.condition_of_notes = 1.0 / notes.theta4[0].cos().abs();
    system.compare(CRANK, &[notes.r4, notes.theta4]);
}

/// A mechanism of the notes in one of its assemblies.
struct System<M: Mechanism> {
    name: &'static str,
    mechanism: M,
    assembly: M::Assembly,
    /// By how much the notes' formulas are worse conditioned than the mechanism.
    condition_of_notes: f64,
}

impl<M: ThroughSnap> System<M> {
    fn new(name: &'static str, mechanism: M, assembly: M::Assembly) -> Self {
        Self {
            name,
            mechanism,
            assembly,
            condition_of_notes: 1.0,
        }
    }

    /// A mechanism with one assembly.
    fn explicit(name: &'static str, mechanism: M) -> Self {
        Self::new(name, mechanism, M::assembly(0).expect("it has an assembly"))
    }

    /// Prints the three ways of each unknown, and asserts that they agree. Angles agree modulo whole turns.
    ///
    /// Each way is known to about ε κ² wⁿ at order n, where κ is the condition of the pose and w its fastest rate: that
    /// is the unit of the `Gauge`. Of it `ALLOWED` grants 16 for the position, then 32, 128, 512 and 2048, as the sums
    /// of the chain rule grow. See "Tolerances" in `docs/verification.md`.
    fn compare(&self, crank: Orders, notes: &[Orders]) {
        let crank_motion = M::Inputs::from_fn(|_| Motion::new(crank));
        let pose = self.mechanism.solve(crank_motion, self.assembly);
        let unknowns = pose.expect("it closes").unknown_motions();
        let gauge = Gauge::new(&self.mechanism, &crank_motion, &unknowns);
        let hyper_dual = self.by_hyper_dual_numbers(crank);

        println!("\n{}, {:?}", self.name, self.assembly);
        println!(
            "{:20} {:>24} {:>24} {:>24} {:>24} {:>24}",
            "", "position", "velocity", "acceleration", "jerk", "snap"
        );
        assert_eq!(notes.len(), M::DESCRIPTION.unknowns.len(), "{}", self.name);
        for (index, unknown) in M::DESCRIPTION.unknowns.iter().enumerate() {
            let generated = unknowns[index].derivatives();
            let ways = [
                ("generated", generated, 1.0),
                ("notes", notes[index], self.condition_of_notes),
                ("hyper-dual", hyper_dual[index], 1.0),
            ];
            for (way, values, condition) in ways {
                let [q, q_1, q_2, q_3, q_4] = values;
                println!(
                    "{:8} {way:11} {q:>+24.15e} {q_1:>+24.15e} {q_2:>+24.15e} {q_3:>+24.15e} {q_4:>+24.15e}",
                    unknown.name
                );
                for order in 0..5 {
                    let mut difference = values[order] - generated[order];
                    if order == 0 && unknown.dimension == Dimension::Angle {
                        difference = turned_back(difference);
                    }
                    let error = difference.abs() / (condition * gauge.unknown(index, order));
                    assert!(
                        error <= ALLOWED[order],
                        "{}, {} by {way}, order {order}: {} against {}, {error} units",
                        self.name,
                        unknown.name,
                        values[order],
                        generated[order]
                    );
                }
            }
        }
    }

    /// The motion of each unknown by hyper-dual numbers through the position solver, each order by its own kind of
    /// number.
    ///
    /// A hyper-dual number has several infinitesimal steps, all of them steps of time here. The product of k steps
    /// carries the k-th derivative, so the crank is given its k-th derivative at each product of k steps, and an
    /// unknown's is read at one of them.
    fn by_hyper_dual_numbers(&self, [q, q_1, q_2, q_3, q_4]: Orders) -> Vec<Orders> {
        let first = self.position(Dual64::new(q, q_1));
        let second = self.position(HyperDual64::new(q, q_1, q_1, q_2));
        let third = self.position(HyperHyperDual64::new(q, q_1, q_1, q_1, q_2, q_2, q_2, q_3));
        let fourth = self.position(HyperDual::new(
            HyperDual64::new(q, q_1, q_1, q_2),
            HyperDual64::new(q_1, q_2, q_2, q_3),
            HyperDual64::new(q_1, q_2, q_2, q_3),
            HyperDual64::new(q_2, q_3, q_3, q_4),
        ));
        (0..first.len())
            .map(|index| {
                [
                    first[index].re,
                    first[index].eps,
                    second[index].eps1eps2,
                    third[index].eps1eps2eps3,
                    fourth[index].eps1eps2.eps1eps2,
                ]
            })
            .collect()
    }

    /// The unknowns by the position solver on numbers of another type.
    fn position<S: Scalar>(&self, crank: S) -> Vec<S> {
        let mechanism = self.mechanism.convert(<S as Number>::constant);
        let position = mechanism.position(Row::from_fn(|_| crank), self.assembly);
        position.expect("it closes").as_ref().to_vec()
    }
}
