//! Known linkages are found again from their own points.

use kin_core::prelude::*;
use kin_fit::{Candidate, Evolution, Objective, Refinement, Sense, Settings, Travel, polish};

use super::{COUPLER, Coupler, KNOWN, off, placed};

const PLACED: [f64; 3] = [3.0, -1.0, 0.4];
const LENGTHS: [&str; 6] = ["r1", "r2", "r3", "r4", "along", "beside"];

/// Ten units in the last place of a length of the linkage, which is a few units long: its position has a condition of
/// about ten.
const ROUNDING: f64 = 1e-12;

fn inputs(count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(move |step| 0.2 + std::f64::consts::TAU * f64::from(step) / f64::from(count))
}

fn bounded(mut objective: Objective) -> Objective {
    for name in LENGTHS {
        let index = LENGTHS
            .iter()
            .position(|other| *other == name)
            .expect("it is in the list");
        let value = KNOWN.parameters()[index];
        objective = objective.bounds(name, 0.5 * value..=1.5 * value).expect("a parameter");
    }
    objective
        .placement(2.0..=4.0, -2.0..=0.0, 0.0..=1.0)
        .expect("a path or a motion")
}

fn settings() -> Settings {
    Settings {
        seed: 7,
        evolution: Some(Evolution {
            evaluations: 3000,
            ..Evolution::default()
        }),
        threads: 2,
        ..Settings::default()
    }
}

fn is_known(refinement: &Refinement) {
    assert!(refinement.dropped.is_empty(), "{:?}", refinement.counts());
    let best = &refinement.results[0];
    let start = best.start.expect("it closes at the start").largest;
    let evolved = best.evolved.expect("it closes").largest;
    println!(
        "start {start:.3e}, evolved {evolved:.3e}, polished {:.3e} in {} steps",
        best.polished.largest, best.steps
    );
    assert!(
        start > 1e-2 && evolved < start && best.polished.largest < ROUNDING,
        "{best:?}"
    );
    // The error of the lengths is that of the points times the condition of the fit, which is about a thousand.
    for (name, (found, known)) in LENGTHS.iter().zip(
        best.design
            .mechanism::<Coupler>()
            .parameters()
            .into_iter()
            .zip(KNOWN.parameters()),
    ) {
        assert!(
            (found - known).abs() < 1e4 * ROUNDING,
            "{name}: {found} instead of {known}"
        );
    }
    for (found, known) in best.design.placement().into_iter().zip(PLACED) {
        assert!(
            (found - known).abs() < 1e4 * ROUNDING,
            "placed at {found} instead of {known}"
        );
    }
    assert!(best.figures.is_full_revolution);
}

#[test]
fn a_path_with_free_timing() {
    let targets = inputs(14)
        .map(|input| placed(&KNOWN, input, PLACED))
        .map(|[x, y, _]| [x, y]);
    let objective = bounded(Objective::path(COUPLER, "point", targets).expect("a point")).travel(Travel::Revolution);
    let found = polish(&objective, &[off(0.03)], &settings()).expect("a good objective");
    is_known(&found);
    // the inputs are those at which the points were taken
    let wrong = found.results[0]
        .inputs
        .iter()
        .zip(inputs(14))
        .map(|(found, known)| (found - known).abs());
    assert!(wrong.fold(0.0, f64::max) < 1e4 * ROUNDING);
}

#[test]
fn a_path_with_prescribed_timing() {
    let targets = inputs(10)
        .map(|input| placed(&KNOWN, input, PLACED))
        .map(|[x, y, _]| [x, y]);
    let objective = bounded(Objective::path(COUPLER, "point", targets).expect("a point"))
        .prescribed(inputs(10).map(|input| input - 0.2))
        .and_then(|objective| objective.phase(-1.0..=1.0))
        .expect("ten inputs");
    let found = polish(&objective, &[off(0.05)], &settings()).expect("a good objective");
    is_known(&found);
    assert!((found.results[0].design.input_line()[0] - 0.2).abs() < 1e4 * ROUNDING);
}

#[test]
fn a_motion() {
    let targets = inputs(8).map(|input| placed(&KNOWN, input, PLACED));
    let objective = Objective::motion(COUPLER, "point", "theta3", 1.0, targets).expect("a point and an angle");
    is_known(&polish(&bounded(objective), &[off(0.05)], &settings()).expect("a good objective"));
}

#[test]
fn a_path_in_the_other_direction() {
    let mut targets: Vec<[f64; 2]> = inputs(14)
        .map(|input| placed(&KNOWN, input, PLACED))
        .map(|[x, y, _]| [x, y])
        .collect();
    targets.reverse();
    let objective = bounded(Objective::path(COUPLER, "point", targets).expect("a point"));
    let found = polish(&objective, &[off(0.03)], &settings()).expect("a good objective");
    is_known(&found);
    let [from, to] = found.results[0].figures.travel;
    assert!(to < from);
    // the known linkage cannot pass the points in this order with a growing input, and no other linkage passes them
    let forward = polish(&objective.sense(Sense::Forward), &[off(0.03)], &settings()).expect("a good objective");
    for result in &forward.results {
        let [from, to] = result.figures.travel;
        assert!(from < to && result.polished.largest > 0.01, "{result:?}");
    }
}

#[test]
fn threads_do_not_matter() {
    let targets = inputs(9)
        .map(|input| placed(&KNOWN, input, PLACED))
        .map(|[x, y, _]| [x, y]);
    let objective = bounded(Objective::path(COUPLER, "point", targets).expect("a point"));
    let candidates: Vec<Candidate> = (0..5_u32)
        .map(|id| off(0.02 * f64::from(id)).numbered(u64::from(id)))
        .collect();
    let bits = |seed: u64, threads: usize| {
        let mut settings = settings();
        (settings.seed, settings.threads) = (seed, threads);
        settings.evolution = Some(Evolution {
            evaluations: 300,
            ..Evolution::default()
        });
        settings.steps = 5;
        let found = polish(&objective, &candidates, &settings).expect("a good objective");
        let designs = found.results.iter().map(|result| (result.id, &result.design));
        let all = designs.chain(found.dropped.iter().map(|dropped| (dropped.id, &dropped.design)));
        let all = all.map(|(id, design)| {
            let values = objective
                .variables(design)
                .into_iter()
                .map(|(_, value, _)| value.to_bits());
            (id, values.collect::<Vec<u64>>())
        });
        all.collect::<Vec<_>>()
    };
    let once = bits(1, 1);
    assert_eq!(once.len(), 5);
    assert_eq!(once, bits(1, 2));
    assert_eq!(once, bits(1, 3));
    assert_ne!(once, bits(2, 2));
}
