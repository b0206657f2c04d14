//! Defects made by hand are named, and counted.

use kin_core::any::Of;
use kin_core::library::{WattI, WattIAssembly};
use kin_core::prelude::*;
use kin_fit::{Candidate, Defect, DefectKind, Objective, ObjectiveError, Refinement, Settings, Term, Travel, polish};

use super::{COUPLER, Coupler, KNOWN, placed};

/// No step is taken, so that the candidates are judged as they are.
fn judged(objective: &Objective, candidates: &[Coupler]) -> Refinement {
    let candidates: Vec<Candidate> = candidates
        .iter()
        .zip(0..)
        .map(|(linkage, id)| Candidate::new(linkage, Assembly::Open).numbered(id))
        .collect();
    let settings = Settings {
        evolution: None,
        steps: 0,
        ..Settings::default()
    };
    polish(objective, &candidates, &settings).expect("a good objective")
}

/// The path of a linkage at given inputs.
fn path_of(linkage: &Coupler, inputs: &[f64]) -> Objective {
    let targets = inputs
        .iter()
        .map(|input| placed(linkage, *input, [0.0; 3]))
        .map(|[x, y, _]| [x, y]);
    Objective::path(COUPLER, "point", targets)
        .and_then(|objective| objective.prescribed(inputs.iter().copied()))
        .and_then(|objective| objective.bounds("r2", 0.1..=5.0))
        .expect("a path at these inputs")
}

#[test]
fn in_two_circuits() {
    // The output is the shortest link of a Grashof linkage, so the driver swings above or below the ground, never from
    // one to the other.
    let swinging = Coupler {
        r1: 4.0,
        r2: 3.0,
        r3: 3.5,
        r4: 1.0,
        ..KNOWN
    };
    assert_eq!(swinging.cycle().expect("finite lengths").circuits().len(), 2);
    let above = judged(&path_of(&swinging, &[0.7, 0.8, 0.9]), &[swinging]);
    assert_eq!((above.results.len(), above.dropped.len()), (1, 0));
    assert!(!above.results[0].figures.is_full_revolution);
    let both = judged(&path_of(&swinging, &[0.7, 0.8, -0.8]), &[swinging]);
    assert!(both.results.is_empty());
    let Defect::Circuit {
        targets,
        circuits: [one, other],
    } = both.dropped[0].defect
    else {
        panic!("{}", both.dropped[0].defect)
    };
    assert_eq!(targets, [0, 2]);
    assert_ne!(one, other);
    // its error is zero all the same: only the cycle shows the defect
    assert!(both.dropped[0].misfit.expect("it closes").largest < 1e-14);
}

#[test]
fn in_two_branches() {
    // The first loop swings. In one of its assemblies the second loop opens on the way, so the crank's range has two
    // parts, which the circuit connects by the other assemblies only.
    let six_bar = WattI {
        r1: 2.5,
        r2: 2.1,
        r3: 1.9,
        r4: 2.0,
        p: Plane::new(2.0, 1.8),
        q: Plane::new(0.0, -1.9),
        r5: 3.4,
        r6: 3.8,
    };
    let assembly = WattIAssembly::all(Assembly::Crossed);
    let judge = |inputs: [f64; 3]| {
        let targets = inputs.map(|input| {
            let tool = six_bar.position(input, assembly).expect("it closes").tool.value();
            [tool.x, tool.y]
        });
        let objective = Objective::path(Of::<WattI>::FUNCTIONS, "tool", targets)
            .and_then(|objective| objective.prescribed(inputs))
            .and_then(|objective| objective.bounds("r5", 3.0..=4.0))
            .expect("a path at these inputs");
        let settings = Settings {
            evolution: None,
            steps: 0,
            ..Settings::default()
        };
        polish(&objective, &[Candidate::new(&six_bar, assembly)], &settings).expect("a good objective")
    };
    assert_eq!(judge([0.2, 0.4, 0.6]).results.len(), 1);
    assert_eq!(judge([1.6, 1.8, 2.0]).results.len(), 1);
    let found = judge([0.4, 0.6, 1.6]);
    let Defect::Branch {
        targets,
        branches: [one, other],
    } = found.dropped[0].defect
    else {
        panic!("{}", found.dropped[0].defect)
    };
    assert_eq!(targets, [0, 2]);
    let cycle = six_bar.cycle().expect("finite lengths");
    let [one, other] = [one, other].map(|index| &cycle.branches()[index]);
    assert_eq!((one.circuit(), one.assembly()), (other.circuit(), other.assembly()));
}

#[test]
fn out_of_order() {
    let in_order = judged(&path_of(&KNOWN, &[0.5, 1.0, 1.5, 2.0]), &[KNOWN]);
    assert_eq!(in_order.results.len(), 1);
    // the way back is an order too, and the revolution has no beginning
    assert_eq!(
        judged(&path_of(&KNOWN, &[1.0, 0.5, 6.0, 5.0]), &[KNOWN]).results.len(),
        1
    );
    let out = judged(&path_of(&KNOWN, &[0.5, 1.5, 1.0, 2.0]), &[KNOWN]);
    assert_eq!(out.results.len(), 0);
    let Defect::Order { target, inputs } = out.dropped[0].defect else {
        panic!("{}", out.dropped[0].defect)
    };
    assert_eq!((target, inputs), (3, [1.0, 2.0]));
}

#[test]
fn gap_between_samples() {
    // The links are too short by a little when the crank points away, between two samples at which closure is tested.
    let short = Coupler {
        r1: 2.0,
        r2: 0.6,
        r3: 1.5,
        r4: 1.0997,
        mark: 0.1,
        ..KNOWN
    };
    let inputs: Vec<f64> = (0..24)
        .map(|step| 15.0 * f64::from(step))
        .map(f64::to_radians)
        .collect();
    assert!(
        inputs
            .iter()
            .all(|input| short.position(*input, Assembly::Open).is_ok())
    );
    let gap = std::f64::consts::PI - short.mark;
    assert!(short.position(gap, Assembly::Open).is_err());
    let objective = path_of(&short, &inputs[..8]).travel(Travel::Revolution);
    let found = judged(&objective, &[short, Coupler { r4: 1.2, ..short }]);
    assert_eq!(found.results.iter().map(|result| result.id).collect::<Vec<_>>(), [1]);
    let Defect::Closure { input } = found.dropped[0].defect else {
        panic!("{}", found.dropped[0].defect)
    };
    // an end of the branch beside the gap, to rounding: by the law of cosines
    let width = ((2.0_f64.powi(2) + 0.6_f64.powi(2) - 2.5997_f64.powi(2)) / (2.0 * 2.0 * 0.6)).acos();
    let limit = width - short.mark;
    assert!((input - limit).abs() < 1e-9, "{input} instead of {limit}");
    // between targets on both sides of the gap too
    let across = judged(&path_of(&short, &[gap - 0.2, gap - 0.1, gap + 0.1]), &[short]);
    assert_eq!(across.dropped[0].defect.kind(), DefectKind::Closure);
    let before = judged(&path_of(&short, &[gap - 0.3, gap - 0.2, gap - 0.1]), &[short]);
    assert_eq!(before.results.len(), 1);
}

#[test]
fn below_its_margins() {
    let objective = path_of(&KNOWN, &[0.5, 1.0, 1.5]);
    // The smallest transmission angle over the revolution, by the law of cosines at both ends of the diagonal.
    let angle = |diagonal: f64| ((1.8_f64.powi(2) + 1.5_f64.powi(2) - diagonal.powi(2)) / (2.0 * 1.8 * 1.5)).acos();
    let least = angle(1.4).min(std::f64::consts::PI - angle(2.6));
    let term = |floor: f64| Term::Transmission {
        aim: 0.0,
        floor,
        weight: 1.0,
    };
    let full = objective.clone().travel(Travel::Revolution);
    assert_eq!(
        judged(&full.clone().term(term(least - 1e-9)), &[KNOWN]).results.len(),
        1
    );
    let found = judged(&full.term(term(least + 1e-9)), &[KNOWN]);
    let Defect::Transmission { angle, .. } = found.dropped[0].defect else {
        panic!("{}", found.dropped[0].defect)
    };
    assert!((angle - least).abs() < 1e-12, "{angle} instead of {least}");
    // a linkage without Grashof's margin closes at all targets
    let short = Coupler { r4: 0.7, ..KNOWN };
    let objective = path_of(&short, &[0.5, 1.0, 1.5]);
    assert_eq!(judged(&objective, &[short]).results.len(), 1);
    let found = judged(&objective.term(Term::Grashof { aim: 0.1, weight: 1.0 }), &[short]);
    let Defect::Margin { margin, .. } = found.dropped[0].defect else {
        panic!("{}", found.dropped[0].defect)
    };
    assert!((margin - (0.7 + 1.8 - 0.6 - 2.0)).abs() < 1e-15);
}

#[test]
fn all_of_them_counted() {
    let swinging = Coupler {
        r1: 4.0,
        r2: 3.0,
        r3: 3.5,
        r4: 1.0,
        ..KNOWN
    };
    let objective = path_of(&swinging, &[0.7, 0.8, -0.8]);
    let closed_nowhere = Coupler { r1: 9.0, ..swinging };
    let found = judged(&objective, &[swinging, closed_nowhere, KNOWN, swinging]);
    let counts: Vec<_> = found.counts().into_iter().collect();
    // `KNOWN` turns, but passes the last target between the others only
    assert_eq!(counts, [(DefectKind::Circuit, 2), (DefectKind::Closure, 1)]);
    assert_eq!(found.results.len(), 1);
}

#[test]
fn mistakes_are_named() {
    let path = || path_of(&KNOWN, &[0.5, 1.0]);
    let error = path().bounds("r9", 0.0..=1.0).expect_err("no such parameter");
    assert_eq!(
        error.to_string(),
        "the mechanism has no parameter `r9`; it has r1, r2, r3, r4, along, beside, mark"
    );
    let error = Objective::path(COUPLER, "pint", [[0.0, 0.0]]).expect_err("no such point");
    assert!(error.to_string().contains("no point `pint`"), "{error}");
    assert!(matches!(
        path().bounds("r2", 1.0..=1.0),
        Err(ObjectiveError::NotInOrder { .. })
    ));
    assert!(matches!(
        path().prescribed([1.0]),
        Err(ObjectiveError::WrongCount {
            given: 1,
            wanted: 2,
            ..
        })
    ));
    assert!(matches!(path().scale(1.0), Err(ObjectiveError::NoSuchPart { .. })));
    let nothing = Objective::function(COUPLER, "theta4", [[0.5, 1.0]]).expect("a function");
    let candidates = [Candidate::new(&KNOWN, Assembly::Open)];
    assert!(matches!(
        polish(&nothing, &candidates, &Settings::default()),
        Err(ObjectiveError::NothingToSeek)
    ));
    // a coupled block has no assembly that holds for all dimensions
    let coupled = Objective::path(
        Of::<kin_core::library::ClassThreeTriad>::FUNCTIONS,
        "centre",
        [[0.0, 0.0]],
    );
    assert!(
        matches!(coupled, Err(ObjectiveError::NoClosedForm { .. })),
        "{coupled:?}"
    );
}
