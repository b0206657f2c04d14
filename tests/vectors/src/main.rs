//! Asserts that wide vectors pay in batches, of compiled mechanisms and of declared ones.
//!
//! ```text
//! cargo run --profile bench -p kin-vectors
//! ```
//!
//! Whatever a batch calls must be inlined into the function that is compiled for the vectors of the machine. A function
//! or a long closure that is not inlined is compiled for the narrowest vectors, and the batch then takes several times
//! as long, with the same numbers. Only the ratio of times tells. It is that of the shortest of many runs, which
//! alternate, and it is far from the limit on both sides, so that a busy machine does not alter the verdict.

use std::hint::black_box;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use kin_core::any::Of;
use kin_core::batch::{AnyBatch, Column, ColumnChoice, GivenColumns, Outcome, Slot, Vectors, WantedColumns};

/// The largest part of the time with the narrowest vectors that wide vectors may take. They take 0.3 to 0.6, and more
/// than twice as long as the narrowest where a function is not inlined.
const LARGEST_PART: f64 = 1.0;

const POSES: usize = 1024;
const RUNS: usize = 200;

/// Declares a mechanism twice: for rustc, and as text.
macro_rules! declared_twice {
    ($module:ident $($declaration:tt)+) => {
        mod $module {
            #![allow(missing_docs, dead_code, reason = "only batches use it")]
            use kin_core::prelude::*;

            mechanism! { $($declaration)+ }

            pub(super) const TEXT: &str = stringify!($($declaration)+);
        }
    };
}

declared_twice! { four_bar
    pub struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

declared_twice! { triad
    pub struct Triad { base_b: Point, base_c: Point, platform_b: Vector, platform_c: Vector }
    input a: Length, b: Length, c: Length;
    unknown alpha: Angle, beta: Angle, gamma: Angle, phi: Angle;
    a * cis(alpha) + platform_b * cis(phi) == base_b + b * cis(beta);
    a * cis(alpha) + platform_c * cis(phi) == base_c + c * cis(gamma);
}

/// The columns of a batch: dimensions, positions of each input, and the values nearby if there are no assemblies.
struct Given<'g> {
    dimensions: &'g [f64],
    positions: &'g [f64],
    inputs: usize,
    near: &'g [f64],
}

impl Given<'_> {
    /// The nanoseconds for each pose, through snap, with each of these vectors in turn.
    fn times(&self, batch: &dyn AnyBatch, all: &[Vectors]) -> Vec<f64> {
        let same = |values: &[f64]| values.iter().map(|value| Column::Same(*value)).collect::<Vec<_>>();
        let (parameters, near) = (same(self.dimensions), same(self.near));
        let motion = [Column::Each(self.positions), Column::Same(10.0)];
        let inputs = vec![motion.as_slice(); self.inputs];
        let given = GivenColumns {
            parameters: &parameters,
            inputs: &inputs,
            choice: if near.is_empty() {
                ColumnChoice::Assembly(0)
            } else {
                ColumnChoice::Near(&near)
            },
        };
        let description = batch.description();
        let unknowns = 0..description.unknowns.len();
        let slots: Vec<Slot> = unknowns
            .flat_map(|unknown| (0..=description.order).map(move |order| Slot::Unknown(unknown, order)))
            .collect();
        let mut numbers = vec![vec![0.0; POSES]; slots.len()];
        let mut outcomes = vec![Outcome::Unsolved; POSES];
        let mut shortest = vec![Duration::MAX; all.len()];
        for _ in 0..RUNS {
            for (vectors, shortest) in all.iter().zip(&mut shortest) {
                let columns = slots.iter().zip(&mut numbers);
                let columns = columns.map(|(slot, column)| (*slot, column.as_mut_slice())).collect();
                let mut wanted = WantedColumns::new(columns);
                let start = Instant::now();
                let summary = batch.solve_batch(black_box(given), &mut wanted, &mut outcomes, *vectors);
                *shortest = (*shortest).min(start.elapsed());
                assert_eq!(summary.map(|summary| summary.solved), Ok(POSES), "{}", description.name);
            }
        }
        #[expect(clippy::cast_precision_loss, reason = "there are a thousand poses")]
        let nanoseconds = |time: &Duration| time.as_secs_f64() * 1e9 / POSES as f64;
        shortest.iter().map(nanoseconds).collect()
    }

    /// Prints the times, and returns whether wide vectors pay.
    fn vectors_pay(&self, name: &str, text: &str, compiled: &dyn AnyBatch) -> bool {
        let declared = kin_live::Mechanism::declare(text).expect("rustc has compiled the same declaration");
        let mut all = vec![Vectors::Compiled, Vectors::Avx2, Vectors::Avx512];
        all.retain(|vectors| vectors.are_there());
        let mut pay = true;
        for (way, batch) in [("compiled", compiled), ("declared", &declared)] {
            let times = self.times(batch, &all);
            for (vectors, time) in all.iter().zip(&times) {
                let part = time / times[0];
                println!("{name}, {way}: {vectors:?} {time:.1} ns for each pose, {part:.2} of the narrowest");
                if part > LARGEST_PART {
                    eprintln!("error: wide vectors do not pay; which function or closure is not inlined?");
                    pay = false;
                }
            }
        }
        pay
    }
}

fn main() -> ExitCode {
    #[expect(clippy::cast_precision_loss, reason = "there are a thousand poses")]
    let parts: Vec<f64> = (0..POSES).map(|pose| pose as f64 / POSES as f64).collect();
    let angles: Vec<f64> = parts.iter().map(|part| 6.2 * part).collect();
    let four_bar = Given {
        dimensions: &[90.0, 30.0, 70.0, 60.0],
        positions: &angles,
        inputs: 1,
        near: &[],
    };
    let root = 3.0_f64.sqrt();
    let legs: Vec<f64> = parts.iter().map(|part| 5.0_f64.sqrt() + 1e-3 * part).collect();
    let triad = Given {
        dimensions: &[2.0 * root, 0.0, root, 3.0, root, 0.0, root / 2.0, 1.5],
        positions: &legs,
        inputs: 3,
        near: &[0.1, 2.2, -2.0, 1.6],
    };
    let pay = [
        four_bar.vectors_pay("four-bar linkage", four_bar::TEXT, Of::<four_bar::FourBar>::FUNCTIONS),
        triad.vectors_pay("class III triad", triad::TEXT, Of::<triad::Triad>::FUNCTIONS),
    ];
    if pay.contains(&false) {
        ExitCode::FAILURE
    } else {
        ExitCode::SUCCESS
    }
}
