//! Derivatives against central differences.

use kin_core::prelude::*;
use kin_fit::{Candidate, Design, Objective, Term, Travel};

use super::{COUPLER, Coupler, KNOWN, off, placed};

/// The change of a number for a central difference. Its square, and the rounding of the rows over it, are both below
/// 1e-10.
const STEP: f64 = 1e-5;
const TOLERANCE: f64 = 1e-8;

fn agree(objective: &Objective, design: &Design) {
    let variables: Vec<f64> = objective
        .variables(design)
        .into_iter()
        .map(|(_, value, _)| value)
        .collect();
    let rows = objective.residuals(design).expect("it closes");
    let exact = objective.jacobian(design).expect("it closes");
    assert_eq!(exact.len(), rows.len() * variables.len());
    let mut largest = vec![0.0_f64; variables.len()];
    for column in 0..variables.len() {
        let [low, high] = [-STEP, STEP].map(|step| {
            let mut moved = variables.clone();
            moved[column] += step;
            let design = objective.with_variables(design, &moved).expect("as many numbers");
            objective.residuals(&design).expect("it closes")
        });
        for (row, (low, high)) in low.iter().zip(&high).enumerate() {
            let derivative = exact[row * variables.len() + column];
            let difference = (high - low) / (2.0 * STEP);
            assert!(
                (derivative - difference).abs() < TOLERANCE * (1.0 + derivative.abs()),
                "row {row}, column {column}: {derivative} and {difference}"
            );
            largest[column] = largest[column].max(derivative.abs());
        }
    }
    // every number has an influence
    assert!(largest.iter().all(|largest| *largest > 1e-3), "{largest:?}");
}

fn bounded(mut objective: Objective) -> Objective {
    for (quantity, value) in Coupler::<f64>::DESCRIPTION.parameters.iter().zip(off(0.03).parameters) {
        objective = objective
            .bounds(quantity.name, value - 0.5..=value + 0.5)
            .expect("a parameter");
    }
    objective
}

/// Terms none of which is kept, so that all of them have derivatives.
fn with_terms(objective: Objective) -> Objective {
    objective
        .term(Term::Lengths { weight: 0.2 })
        .term(Term::Box {
            width: 1.0,
            height: 0.5,
            weight: 0.3,
        })
        .term(Term::Grashof { aim: 5.0, weight: 0.4 })
        .term(Term::DriverTurns { aim: 5.0, weight: 0.5 })
        .term(Term::Transmission {
            aim: 1.5,
            floor: 0.0,
            weight: 0.6,
        })
}

fn inputs() -> impl Iterator<Item = f64> {
    (0..7).map(|step| 0.3 + 0.7 * f64::from(step))
}

#[test]
fn of_a_path_with_free_timing() {
    let targets = inputs()
        .map(|input| placed(&KNOWN, input, [0.1, 0.2, 0.3]))
        .map(|[x, y, _]| [x, y]);
    let objective = bounded(Objective::path(COUPLER, "point", targets).expect("a point"))
        .placement(-1.0..=1.0, -1.0..=1.0, -1.0..=1.0)
        .and_then(|objective| objective.weights([1.0, 2.0, 0.5, 1.0, 1.0, 3.0, 1.0]))
        .expect("a path of seven points");
    for travel in [Travel::Targets, Travel::Revolution] {
        let objective = with_terms(objective.clone()).travel(travel);
        let candidate = Candidate {
            placement: Some([0.0, 0.1, 0.2]),
            inputs: Some(inputs().map(|input| input + 0.05).collect()),
            ..off(0.03)
        };
        agree(&objective, &objective.design(&candidate).expect("it fits"));
    }
}

#[test]
fn of_a_motion_with_a_phase() {
    let targets = inputs().map(|input| placed(&KNOWN, input, [0.1, 0.2, 0.3]));
    let objective = bounded(Objective::motion(COUPLER, "point", "theta3", 0.7, targets).expect("a point and an angle"))
        .prescribed(inputs())
        .and_then(|objective| objective.phase(-0.5..=0.5))
        .and_then(|objective| objective.pace(0.5..=1.5))
        .and_then(|objective| objective.placement(-1.0..=1.0, -1.0..=1.0, -1.0..=1.0))
        .expect("a motion with given inputs");
    let candidate = Candidate {
        placement: Some([0.0, 0.1, 0.2]),
        phase: Some(0.1),
        ..off(0.03)
    };
    let objective = with_terms(objective);
    agree(&objective, &objective.design(&candidate).expect("it fits"));
}

#[test]
fn of_a_function_with_scales() {
    let pairs = inputs().map(|input| {
        let pose = KNOWN.position(input, Assembly::Open).expect("it closes");
        [input, pose.theta4.position()]
    });
    let objective = Objective::function(COUPLER, "theta4", pairs)
        .and_then(|objective| objective.phase(-0.5..=0.5))
        .and_then(|objective| objective.pace(0.5..=1.4))
        .and_then(|objective| objective.offset(-0.5..=0.7))
        .and_then(|objective| objective.scale(0.5..=1.2))
        .and_then(|objective| objective.bounds("r2", 0.2..=1.0))
        .and_then(|objective| objective.bounds("r4", 1.0..=2.0))
        .expect("a function");
    let objective = with_terms(objective);
    agree(&objective, &objective.design(&off(0.03)).expect("it fits"));
}
