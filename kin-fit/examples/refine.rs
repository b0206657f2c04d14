//! The time of refinement, and the fate of candidates: random linkages, and the path of a known linkage.
//!
//! ```sh
//! cargo run --release -p kin-fit --example refine
//! ```

use std::error::Error;
use std::f64::consts::TAU;
use std::time::{Duration, Instant};

use kin_core::any::Of;
use kin_core::prelude::*;
use kin_fit::{Candidate, Evolution, Misfit, Objective, Settings, Term, Travel, polish};

mechanism! {
    /// A four-bar linkage with a point of its coupler.
    struct Coupler { r1: Length, r2: Length, r3: Length, r4: Length, along: Length, beside: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output point: Point = r2 * cis(theta2) + vec2(along, beside) * cis(theta3);
}

const KNOWN: Coupler = Coupler {
    r1: 2.0,
    r2: 0.6,
    r3: 1.8,
    r4: 1.5,
    along: 0.9,
    beside: 0.7,
};
const TARGETS: u32 = 14;
const CANDIDATES: u32 = 24;

/// The n-th number of a sequence that fills an interval evenly: the multiples of an irrational number, without their
/// whole part.
fn part(index: u32, irrational: f64) -> f64 {
    (f64::from(index + 1) * irrational).fract()
}

fn mean_time(count: u32, mut task: impl FnMut()) -> Duration {
    let start = Instant::now();
    for _ in 0..count {
        task();
    }
    start.elapsed() / count
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = |input: f64| KNOWN.position(input, Assembly::Open).map(|pose| pose.point.value());
    let targets = (0..TARGETS).map(|step| path(TAU * f64::from(step) / f64::from(TARGETS)));
    let targets = targets
        .map(|point| point.map(|point| [3.0 + point.x, point.y - 1.0]))
        .collect::<Result<Vec<_>, _>>()?;
    let mut objective = Objective::path(Of::<Coupler>::FUNCTIONS, "point", targets)?
        .travel(Travel::Revolution)
        .placement(1.0..=5.0, -3.0..=1.0, 0.0..=TAU)?
        .term(Term::DriverTurns { aim: 0.02, weight: 1.0 });
    let bounds = [[1.0, 4.0], [0.3, 1.2], [1.0, 4.0], [1.0, 4.0], [-2.0, 2.0], [-2.0, 2.0]];
    for (quantity, [low, high]) in Coupler::<f64>::DESCRIPTION.parameters.iter().zip(bounds) {
        objective = objective.bounds(quantity.name, low..=high)?;
    }
    let candidates: Vec<Candidate> = (0..CANDIDATES)
        .map(|index| {
            // the square roots of six primes
            let irrational = [2.0_f64, 3.0, 5.0, 7.0, 11.0, 13.0];
            let parameters = std::array::from_fn(|parameter| {
                let [low, high] = bounds[parameter];
                low + (high - low) * part(index, irrational[parameter].sqrt())
            });
            Candidate::new(&Coupler::from_parameters(parameters), Assembly::Open).numbered(u64::from(index))
        })
        .collect();

    let known = objective.design(&Candidate::new(&KNOWN, Assembly::Open))?;
    let cost = mean_time(2000, || {
        std::hint::black_box(objective.penalised_cost(&mut known.clone()));
    });
    let rows = mean_time(20_000, || {
        std::hint::black_box(objective.residuals(&known));
    });
    let derivatives = mean_time(2000, || {
        std::hint::black_box(objective.jacobian(&known));
    });
    println!(
        "a cost with the inputs in order {cost:.1?}, {TARGETS} targets {rows:.1?}, all derivatives {derivatives:.1?}"
    );

    for evaluations in [0, 4000, 20_000] {
        let settings = Settings {
            evolution: Some(Evolution {
                evaluations,
                spread: 0.1,
                population: None,
            }),
            ..Settings::default()
        };
        let start = Instant::now();
        let found = polish(&objective, &candidates, &settings)?;
        let time = start.elapsed() / CANDIDATES;
        println!("{evaluations} evaluations: {time:.1?} for each candidate");
        let exact = found
            .results
            .iter()
            .filter(|result| result.polished.largest < 1e-12)
            .count();
        let kept = found.results.len();
        println!(
            "  kept {kept}, of which {exact} are exact to 1e-12; dropped {:?}",
            found.counts()
        );
        for result in found.results.iter().take(3) {
            let error = |misfit: Option<Misfit>| misfit.map_or(f64::NAN, |one| one.root_mean_square);
            println!(
                "  candidate {:2}: {:.2e}, {:.2e}, {:.2e} in {} steps; transmission {:.1}°",
                result.id,
                error(result.start),
                error(result.evolved),
                error(Some(result.polished)),
                result.steps,
                result
                    .figures
                    .transmission
                    .map_or(f64::NAN, |least| least.value.to_degrees()),
            );
        }
    }
    Ok(())
}
