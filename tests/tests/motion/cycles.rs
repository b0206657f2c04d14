//! Full cycles of random linkages: dense scans find nothing else, and labels say what the cycles find.

use core::fmt;

use kin_core::LimitKind;
use kin_core::cycle::{BlockClass, Branch, Cycle, EndKind, FullCycle, InvertedSliderCrankType, SliderCrankType};
use kin_core::library::{
    StephensonI, StephensonIByDyad, StephensonII, StephensonIIByElbow, StephensonIII, StephensonIIIByDyad, WattI,
    WattIByDyad, WattII, WattIIByCouplers,
};
use kin_core::prelude::*;
use kin_tests::random::Random;
use kin_tests::samples;

mechanism! {
    /// A slider-crank whose slider's line passes beside the crank's pivot.
    struct OffsetSliderCrank { crank: Length, coupler: Length, offset: Length }
    input theta: Angle;
    unknown phi: Angle, slide: Length;
    crank * cis(theta) + coupler * cis(phi) == vec2(slide, offset);
}

mechanism! {
    /// A crank with a pin in a slide, whose line passes beside the pivot of its link.
    struct OffsetInvertedSliderCrank { ground: Length, crank: Length, offset: Length }
    input theta: Angle;
    unknown phi: Angle, slide: Length;
    ground + crank * cis(theta) == vec2(slide, offset) * cis(phi);
}

/// All positions at places all over the turn lie on a branch, each on its own.
fn scan<M>(mechanism: M, places: u32, counts: &mut [usize; 2]) -> Result<(), String>
where
    M: Mechanism<Scalar = f64, Inputs<f64> = [f64; 1]>,
{
    let name = M::DESCRIPTION.name;
    let parameters = mechanism.parameters();
    let context = || format!("{name} {:?}", parameters.as_ref());
    let cycle = mechanism.cycle().map_err(|error| format!("{}: {error}", context()))?;
    if !cycle.is_complete() {
        return Err(format!("{}: not complete, {:?}", context(), cycle.branches()));
    }
    counts[0] += cycle.circuits().len();
    counts[1] += cycle.branches().len();
    for place in 0..places {
        let input = core::f64::consts::TAU * ((f64::from(place) + 0.317) / f64::from(places) - 0.5);
        let mut found = Vec::new();
        let search = mechanism.positions_at([input], |_, unknowns| found.push(unknowns));
        let search = search.map_err(|error| format!("{}: {error}", context()))?;
        if search.singular > 0 || !search.is_complete {
            continue;
        }
        let mut own: Vec<usize> = cycle.at(input).map(|(branch, _)| branch).collect();
        if own.len() != found.len() {
            return Err(format!(
                "{}: {} positions at {input}, but branches {own:?}",
                context(),
                found.len()
            ));
        }
        // Branches lie on turns of their own.
        let turns = |branch: usize| {
            let range = cycle.branches()[branch].range();
            let places = (-3..=3).map(move |turn| input + core::f64::consts::TAU * f64::from(turn));
            places.filter(move |place| range.contains(place))
        };
        own.dedup();
        for (branch, place) in own
            .into_iter()
            .flat_map(|branch| turns(branch).map(move |place| (branch, place)))
        {
            let on = cycle
                .position_on(branch, place)
                .map_err(|error| format!("{}: {error}", context()))?;
            let distance = |position: &M::Unknowns<f64>| {
                let angles = position.as_ref().iter().zip(on.as_ref());
                angles.fold(0.0_f64, |most, (one, other)| {
                    most.max((0.5 * (one - other)).sin().abs())
                })
            };
            let nearest =
                (0..found.len()).min_by(|one, other| distance(&found[*one]).total_cmp(&distance(&found[*other])));
            match nearest {
                Some(nearest) if distance(&found[nearest]) < 1e-7 => drop(found.swap_remove(nearest)),
                _ => {
                    return Err(format!(
                        "{}: branch {branch} is not among the positions at {input}",
                        context()
                    ));
                }
            }
        }
    }
    Ok(())
}

/// Random six-bars of some of the ten kinds below: a dense scan finds no position beside those of the cycle.
fn assert_scans_find_nothing_else(kinds: core::ops::Range<usize>) {
    let mut random = Random::new(71);
    let mut counts = [0; 2];
    let mut wrong = Vec::new();
    for round in 0..samples::of(200) {
        let [r1, r2, r3, r4, r5, r6] = [(); 6].map(|()| random.between(0.8, 4.0));
        let [p, q] = [(); 2].map(|()| Plane::new(random.between(-2.0, 2.0), random.between(-2.0, 2.0)));
        let pivot = Plane::new(random.between(-5.0, 5.0), random.between(-5.0, 5.0));
        if !kinds.contains(&(round % 10)) {
            continue;
        }
        let result = match round % 10 {
            0 => scan(
                WattI {
                    r1,
                    r2,
                    r3,
                    r4,
                    p,
                    q,
                    r5,
                    r6,
                },
                1400,
                &mut counts,
            ),
            1 => scan(
                WattII {
                    r1,
                    r2,
                    r3,
                    r4,
                    arm: p,
                    pivot,
                    r5,
                    r6,
                },
                1400,
                &mut counts,
            ),
            2 => scan(
                StephensonI {
                    r1,
                    r2,
                    r3,
                    r4,
                    p,
                    q,
                    r5,
                    r6,
                },
                1400,
                &mut counts,
            ),
            3 => scan(
                StephensonIIByElbow {
                    r1,
                    r2,
                    r3,
                    r4,
                    p,
                    q,
                    r5,
                    r6,
                },
                1400,
                &mut counts,
            ),
            4 => scan(
                StephensonIII {
                    r1,
                    r2,
                    r3,
                    r4,
                    p,
                    r5,
                    pivot,
                    r6,
                },
                1400,
                &mut counts,
            ),
            5 => scan(
                WattIByDyad {
                    r1,
                    r2,
                    r3,
                    r4,
                    p,
                    q,
                    r5,
                    r6,
                },
                24,
                &mut counts,
            ),
            6 => scan(
                WattIIByCouplers {
                    r1,
                    r2,
                    r3,
                    r4,
                    arm: p,
                    pivot,
                    r5,
                    r6,
                },
                24,
                &mut counts,
            ),
            7 => scan(
                StephensonIByDyad {
                    r1,
                    r2,
                    r3,
                    r4,
                    p,
                    q,
                    r5,
                    r6,
                },
                24,
                &mut counts,
            ),
            8 => scan(
                StephensonII {
                    r1,
                    r2,
                    r3,
                    r4,
                    p,
                    q,
                    r5,
                    r6,
                },
                24,
                &mut counts,
            ),
            _ => scan(
                StephensonIIIByDyad {
                    r1,
                    r2,
                    r3,
                    r4,
                    p,
                    r5,
                    pivot,
                    r6,
                },
                24,
                &mut counts,
            ),
        };
        wrong.extend(result.err());
    }
    println!("{} circuits, {} branches", counts[0], counts[1]);
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
    assert!(counts[0] > samples::of(200) * kinds.len() / 10 && counts[1] > counts[0]);
}

#[test]
fn six_bars_of_dyads_have_no_other_position() {
    assert_scans_find_nothing_else(0..5);
}

#[test]
#[cfg_attr(not(feature = "every-case"), ignore = "a long scan, for the feature every-case")]
fn watt_six_bars_of_coupled_loops_have_no_other_position() {
    assert_scans_find_nothing_else(5..7);
}

#[test]
#[cfg_attr(not(feature = "every-case"), ignore = "a long scan, for the feature every-case")]
fn stephenson_six_bars_of_coupled_loops_have_no_other_position() {
    assert_scans_find_nothing_else(7..10);
}

/// The whole turns of a circuit's input and of an angle, if it returns.
type Turns = (Option<i32>, Option<i32>);

/// Turns of the input and of the first unknown, an angle, along each circuit, and whether there is a change point.
fn told<M: Mechanism<Scalar = f64>>(cycle: &Cycle<M>) -> (Vec<Turns>, bool) {
    let turns = cycle.circuits().iter().map(|circuit| {
        let unknown = circuit.revolutions().map(|turns| turns[0].abs());
        (circuit.input_revolutions(), unknown)
    });
    let mut ends = cycle.branches().iter().flat_map(Branch::ends);
    (
        turns.collect(),
        ends.any(|end| end.limit() == Some(LimitKind::ChangePoint)),
    )
}

/// What a label says of the turns along each circuit, or nothing for a linkage with a change point.
type Expected = Option<Vec<Turns>>;

/// Compares the labels of random linkages of whole lengths, of which many have change points, with their cycles. There
/// are four labels, and each of them, as well as none, occurs often. `label` gives the index of a label with what it
/// says; `is_alone` says whether all positions of a linkage with a change point are on one circuit.
fn assert_labels_agree<M: Mechanism<Scalar = f64, Inputs<f64> = [f64; 1]> + fmt::Debug>(
    seed: u64,
    linkage: impl Fn([f64; 3]) -> M,
    label: impl Fn(&M) -> Option<(usize, Expected)>,
    is_alone: impl Fn(&M) -> bool,
) {
    let mut random = Random::new(seed);
    let mut counts = [0_usize; 5];
    for _ in 0..samples::of(10_000) {
        let [first, second] = [(); 2].map(|()| random.between(1.0, 13.0).floor());
        let offset = random.between(0.0, 13.0).floor();
        let mechanism = linkage([first, second, offset]);
        let label = label(&mechanism);
        let cycle = mechanism.cycle().unwrap();
        let (turns, has_change_point) = told(&cycle);
        let context = format!("{mechanism:?} {label:?} {cycle:?}");
        let (count, expected) = match label {
            None => (0, Some(vec![])),
            Some((index, expected)) => (1 + index, expected),
        };
        counts[count] += 1;
        let Some(expected) = expected else {
            assert!(
                has_change_point && (!is_alone(&mechanism) || turns.len() == 1),
                "{context}"
            );
            continue;
        };
        assert!(cycle.is_complete() && !has_change_point, "{context}");
        assert_eq!(turns, expected, "{context}");
    }
    assert!(
        counts.iter().all(|count| *count > samples::of(10_000) / 50),
        "{counts:?}"
    );
}

/// The labels of slider-cranks say which links turn.
#[test]
fn labels_of_slider_cranks_agree_with_the_cycle() {
    assert_labels_agree(
        72,
        |[crank, coupler, offset]| OffsetSliderCrank { crank, coupler, offset },
        |mechanism| {
            let [form, _] = mechanism.block_forms();
            let label = match BlockClass::of(&form)? {
                BlockClass::SliderCrank(label) => label,
                other => panic!("{mechanism:?} {form:?} {other:?}"),
            };
            let expected = match label {
                SliderCrankType::TurningCrank => Some(vec![(Some(1), Some(0)); 2]),
                SliderCrankType::TurningCoupler => Some(vec![(Some(0), Some(1)); 2]),
                SliderCrankType::Swinging => Some(vec![(Some(0), Some(0))]),
                SliderCrankType::ChangePoint => None,
            };
            Some((label as usize, expected))
        },
        |_| true,
    );
}

/// The labels of inverted slider-cranks say which links turn.
#[test]
fn labels_of_inverted_slider_cranks_agree_with_the_cycle() {
    assert_labels_agree(
        73,
        |[ground, crank, offset]| OffsetInvertedSliderCrank { ground, crank, offset },
        |mechanism| {
            let [form] = mechanism.block_forms();
            let label = match BlockClass::of(&form)? {
                BlockClass::InvertedSliderCrank(label) => label,
                other => panic!("{mechanism:?} {form:?} {other:?}"),
            };
            let expected = match label {
                InvertedSliderCrankType::TurningLink => Some(vec![(Some(1), Some(1)); 2]),
                InvertedSliderCrankType::SwingingLink => Some(vec![(Some(1), Some(0)); 2]),
                InvertedSliderCrankType::SwingingCrank => Some(vec![(Some(0), Some(0))]),
                InvertedSliderCrankType::ChangePoint => None,
            };
            Some((label as usize, expected))
        },
        // A slide that comes to stand on the pivot of its link leaves the link free to turn there, and no position is
        // alone.
        |mechanism| mechanism.ground != mechanism.crank,
    );
}

/// A crank as long as the ground brings the slide to the pivot of its link, which turns freely there and connects both
/// branches.
#[test]
fn a_free_link_connects_branches() {
    let mut random = Random::new(74);
    for _ in 0..samples::of(200) {
        let length = 10.0_f64.powf(random.between(-3.0, 3.0));
        let mechanism = OffsetInvertedSliderCrank {
            ground: length,
            crank: length,
            offset: 0.0,
        };
        let cycle = mechanism.cycle().unwrap();
        assert!(cycle.is_complete(), "{cycle:?}");
        assert_eq!((cycle.circuits().len(), cycle.branches().len()), (1, 2), "{cycle:?}");
        for branch in cycle.branches() {
            assert_eq!(
                branch.ends().map(|end| end.kind),
                [EndKind::Limit(LimitKind::ChangePoint); 2],
                "{cycle:?}"
            );
            assert_eq!(branch.joins().map(<[usize]>::len), [3; 2], "{cycle:?}");
        }
    }
    let mut counts = [0; 2];
    let mechanism = OffsetInvertedSliderCrank {
        ground: 2.0,
        crank: 2.0,
        offset: 0.0,
    };
    scan(mechanism, 1400, &mut counts).unwrap();
    assert_eq!(counts, [1, 2]);
}
