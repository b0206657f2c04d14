//! The time that kin-live's batch takes for a number of poses of a four-bar linkage on one core, without Python: the
//! best of several runs in seconds, through snap and for positions alone. The race in `benches/` compares its own with
//! these.

use std::hint::black_box;
use std::time::Instant;

use kin_core::any::Described;
use kin_core::batch::{AnyBatch, Column, ColumnChoice, GivenColumns, Outcome, Slot, Vectors, WantedColumns};
use kin_live::Mechanism;
use kin_studio::library::DESIGNS;

/// The dimensions and the speed of the race.
const DIMENSIONS: [f64; 4] = [90.0, 30.0, 70.0, 60.0];
const SPEED: f64 = 10.0;
const RUNS: usize = 7;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count: usize = std::env::args().nth(1).ok_or("give the number of poses")?.parse()?;
    let design = DESIGNS.iter().find(|design| design.name == "FourBar");
    let mechanism = Mechanism::declare(design.ok_or("no four-bar linkage")?.declaration())?;
    let angles: Vec<f64> = (0..count)
        .map(|index| fraction(index, count) * std::f64::consts::TAU)
        .collect();
    let parameters = DIMENSIONS.map(Column::Same);
    let unknowns = mechanism.description().unknowns.len();
    for orders in [5, 1] {
        let motion = [Column::Each(&angles), Column::Same(SPEED)];
        let inputs: [&[Column<'_>]; 1] = [&motion[..orders.min(2)]];
        let mut numbers = vec![vec![0.0; count]; unknowns * orders];
        let mut outcomes = vec![Outcome::Unsolved; count];
        let mut best = f64::INFINITY;
        for _ in 0..RUNS {
            let slots = numbers.iter_mut().enumerate();
            let slots =
                slots.map(|(index, numbers)| (Slot::Unknown(index / orders, index % orders), numbers.as_mut_slice()));
            let given = GivenColumns {
                parameters: &parameters,
                inputs: &inputs,
                choice: ColumnChoice::Assembly(0),
            };
            let start = Instant::now();
            let summary = mechanism.solve_batch(
                given,
                &mut WantedColumns::new(slots.collect()),
                &mut outcomes,
                Vectors::widest(),
            )?;
            best = best.min(start.elapsed().as_secs_f64());
            black_box(&numbers);
            if summary.first_failure.is_some() {
                return Err("a pose does not close".into());
            }
        }
        println!("{best}");
    }
    Ok(())
}

#[expect(clippy::cast_precision_loss, reason = "there are less than 2⁵³ poses")]
fn fraction(index: usize, count: usize) -> f64 {
    index as f64 / count as f64
}
