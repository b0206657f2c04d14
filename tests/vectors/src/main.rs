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

use std::process::ExitCode;

use kin_core::any::Of;
use kin_core::batch::{AnyBatch, Column, ColumnChoice, GivenColumns, Vectors};
use kin_vectors::nanoseconds;

/// The largest part of the time with the narrowest vectors that wide vectors may take. They take 0.3 to 0.6, and more
/// than twice as long as the narrowest where a function is not inlined.
const LARGEST_PART: f64 = 1.0;

const POSES: usize = 1024;

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

/// Prints the times of a mechanism, and returns whether wide vectors pay.
fn vectors_pay(name: &str, text: &str, compiled: &dyn AnyBatch, given: GivenColumns<'_>) -> bool {
    let declared = kin_live::Mechanism::declare(text).expect("rustc has compiled the same declaration");
    let mut all = vec![Vectors::Compiled, Vectors::Avx2, Vectors::Avx512];
    all.retain(|vectors| vectors.are_there());
    let mut pay = true;
    for (way, batch) in [("compiled", compiled), ("declared", &declared)] {
        let contenders: Vec<_> = all.iter().map(|vectors| (batch, *vectors)).collect();
        let times = nanoseconds(given, POSES, POSES, &contenders);
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

fn main() -> ExitCode {
    #[expect(clippy::cast_precision_loss, reason = "there are a thousand poses")]
    let parts: Vec<f64> = (0..POSES).map(|pose| pose as f64 / POSES as f64).collect();
    let speed = Column::Same(10.0);
    let angles: Vec<f64> = parts.iter().map(|part| 6.2 * part).collect();
    let of_four_bar = GivenColumns {
        parameters: &[90.0, 30.0, 70.0, 60.0].map(Column::Same),
        inputs: &[&[Column::Each(&angles), speed]],
        choice: ColumnChoice::Assembly(0),
    };
    let root = 3.0_f64.sqrt();
    let lengths: Vec<f64> = parts.iter().map(|part| 5.0_f64.sqrt() + 1e-3 * part).collect();
    let leg: &[Column<'_>] = &[Column::Each(&lengths), speed];
    let of_triad = GivenColumns {
        parameters: &[2.0 * root, 0.0, root, 3.0, root, 0.0, root / 2.0, 1.5].map(Column::Same),
        inputs: &[leg; 3],
        choice: ColumnChoice::Near(&[0.1, 2.2, -2.0, 1.6].map(Column::Same)),
    };
    let compiled = Of::<four_bar::FourBar>::FUNCTIONS;
    let four_bar_pays = vectors_pay("four-bar linkage", four_bar::TEXT, compiled, of_four_bar);
    let compiled = Of::<triad::Triad>::FUNCTIONS;
    let triad_pays = vectors_pay("class III triad", triad::TEXT, compiled, of_triad);
    if four_bar_pays && triad_pays {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
