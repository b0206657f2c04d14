//! The forms of blocks and the lengths of their links, and all positions by the trait.

use kin_core::library::{FiveBar, FourBar, InvertedSliderCrank, OffsetSliderCrank, SliderCrank};
use kin_core::prelude::*;
use kin_core::{BlockForm, Name, PositionSearch};
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::mechanisms::coupled::{Kepler, Triad};
use kin_tests::mechanisms::multi_loop::{StephensonSixBar, WattSixBar};
use kin_tests::mechanisms::slider_crank_typings::{SliderCrankDrivenAtSlider, SliderCrankInclined, SliderCrankLoop};
use kin_tests::random::Random;

/// The four-bar forms of a mechanism with its lengths divided by the ground.
fn four_bars<M: ThroughSnap>(mechanism: &M) -> Vec<(Name, [f64; 3])> {
    let forms = mechanism.block_forms();
    let found = forms.as_ref().iter().filter_map(|form| match *form {
        BlockForm::FourBar {
            driver,
            ground,
            crank,
            coupler,
            rocker,
        } => Some((driver, [crank, coupler, rocker].map(|length| length / ground))),
        _ => None,
    });
    found.collect()
}

/// However the loop is typed, its links are found, or no four-bar is named at all.
#[test]
fn four_bars_in_any_typing() {
    struct Check {
        named: Vec<&'static str>,
        others: Vec<&'static str>,
    }
    impl Visitor for Check {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            let name = M::DESCRIPTION.name;
            let found = four_bars(&case.mechanism::<M>());
            let [(_, [crank, coupler, rocker])] = found[..] else {
                self.others.push(name);
                return;
            };
            self.named.push(name);
            let expected = [30.0, 60.0, 45.0].map(|length| length / 90.0);
            // coupler and rocker change places where the equation does not tell them apart
            let mut links = [coupler, rocker];
            links.sort_by(f64::total_cmp);
            for (own, expected) in [(crank, expected[0]), (links[0], expected[2]), (links[1], expected[1])] {
                assert!((own - expected).abs() <= 4.0 * f64::EPSILON, "{name}: {found:?}");
            }
        }
    }
    let mut check = Check {
        named: Vec::new(),
        others: Vec::new(),
    };
    cases::four_bars_in_every_typing(&mut check);
    println!("no four-bar: {:?}", check.others);
    assert!(check.named.len() >= 24, "{:?}", check.others);
}

#[test]
fn forms_of_the_library() {
    let linkage = FourBar {
        r1: 90.0,
        r2: -30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let expected = BlockForm::FourBar {
        driver: "theta2".into(),
        ground: 90.0,
        crank: 30.0,
        coupler: 60.0,
        rocker: 45.0,
    };
    assert_eq!(linkage.block_forms(), [expected]);
    // the link and the slider of a slider-crank along an axis are two blocks
    let engine = OffsetSliderCrank {
        r: 1.0,
        l: 3.0,
        h: -0.25,
    };
    let expected = BlockForm::SliderCrank {
        driver: "theta".into(),
        crank: 1.0,
        coupler: 3.0,
        offset: 0.25,
    };
    assert_eq!(engine.block_forms(), [expected, BlockForm::Linear]);
    let engine = SliderCrank { r: 1.0, l: 3.0 };
    let expected = BlockForm::SliderCrank {
        driver: "theta".into(),
        crank: 1.0,
        coupler: 3.0,
        offset: 0.0,
    };
    assert_eq!(engine.block_forms()[0], expected);
    let lever = InvertedSliderCrank { r1: 2.0, r2: 0.8 };
    println!("{:?}", lever.block_forms());
    // the diagonal of a five-bar moves by two inputs
    let robot = FiveBar {
        ground: 2.0,
        left: 1.0,
        left_rod: 2.0,
        right_rod: 1.8,
        right: 1.1,
    };
    assert!(
        robot.block_forms().iter().any(|form| matches!(
            form,
            BlockForm::TwoLinks {
                lengths: [Some(_), Some(_)]
            }
        )),
        "{:?}",
        robot.block_forms()
    );
}

#[test]
fn sliders_in_other_typings() {
    let along = SliderCrankLoop::<f64>::from_parameters([1.0, 3.0, 0.4]);
    let inclined = SliderCrankInclined::<f64>::from_parameters([1.0, 3.0, 0.4, 0.7]);
    for form in [along.block_forms()[0], inclined.block_forms()[0]] {
        let BlockForm::SliderCrank {
            crank, coupler, offset, ..
        } = form
        else {
            panic!("{form:?}");
        };
        assert_eq!((crank, coupler), (1.0, 3.0));
        assert!((offset - 0.4).abs() <= f64::EPSILON, "{offset}");
    }
    // driven at the slider, the end of the dyad moves along a line
    let pump = SliderCrankDrivenAtSlider::<f64>::from_parameters([1.0, 3.0, 0.4]);
    let expected = BlockForm::TwoLinks {
        lengths: [Some(1.0), Some(3.0)],
    };
    assert_eq!(pump.block_forms(), [expected]);
}

/// A second loop is driven by an unknown of the first, or by two.
#[test]
fn loops_after_loops() {
    let watt = WattSixBar::<f64>::from_parameters([4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5]);
    let drivers: Vec<Name> = four_bars(&watt).into_iter().map(|(driver, _)| driver).collect();
    assert_eq!(drivers.len(), 2, "{:?}", watt.block_forms());
    let stephenson = StephensonSixBar::<f64>::from_parameters([4.0, 1.0, 3.0, 2.5, 1.5, 1.0, 5.0, 3.0, 3.0, 2.5]);
    assert_eq!(four_bars(&stephenson).len(), 1, "{:?}", stephenson.block_forms());
}

/// The trait finds the positions that the named assemblies have.
#[test]
fn all_positions_are_those_of_all_assemblies() {
    struct Check;
    impl Visitor for Check {
        fn visit<M: ThroughSnap>(&mut self, case: Case) {
            let mut random = Random::new(3);
            let mechanism = case.mechanism::<M>();
            for step in 0..6 {
                let inputs = case.inputs::<M>((f64::from(step) + 0.3) / 6.0, &mut random);
                let values = M::Inputs::from_fn(|input| inputs[input].value());
                let mut found = Vec::new();
                let search = mechanism
                    .positions_at(values, |assembly, unknowns| found.push((assembly, unknowns)))
                    .expect("all numbers are finite");
                let closing = M::assemblies().filter(|&assembly| mechanism.position(values, assembly).is_ok());
                assert_eq!(found.len(), closing.count(), "{}", M::DESCRIPTION.name);
                assert_eq!((search.found, search.is_complete), (found.len(), true));
                for (assembly, unknowns) in found {
                    let expected = mechanism.position(values, assembly).expect("it was found");
                    assert_eq!(unknowns.as_ref(), expected.as_ref());
                }
            }
        }
    }
    cases::loops(&mut Check);
    cases::chains(&mut Check);
}

#[test]
fn all_positions_of_coupled_blocks() {
    let mut random = Random::new(11);
    for _ in 0..10 {
        let triad = Triad::built(&mut random);
        let listed = triad.mechanism.assemblies_at(triad.input).expect("finite");
        let mut found = Vec::new();
        let search = triad
            .mechanism
            .positions_at([triad.input], |near, unknowns| found.push((near, unknowns)))
            .expect("finite");
        assert_eq!(search.found, listed.len());
        assert_eq!(search.is_complete, listed.is_complete());
        assert_eq!(search.singular, listed.singular());
        for ((near, unknowns), listed) in found.iter().zip(&listed) {
            assert_eq!(near, listed);
            for (own, other) in unknowns.iter().zip(listed.0) {
                // refined once more
                assert!((own - other).abs() <= 1e-9 * (1.0 + own.abs()));
            }
        }
    }
    // no search is known for equations that are not algebraic
    let orbit = Kepler { eccentricity: 0.3 };
    let search = orbit.positions_at([0.4], |_, _| panic!("nothing is searched"));
    assert_eq!(search, Ok(PositionSearch::default()));
}

#[test]
fn numbers_that_are_not_finite_are_an_error() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: f64::NAN,
        r4: 45.0,
    };
    let error = linkage.positions_at([0.6], |_, _| {}).expect_err("a length is NaN");
    assert_eq!(error.failure, kin_core::Failure::NotFinite { quantity: "r3".into() });
}
