//! All positions of a platform on three legs, the class III triad, and the time to find them.
//!
//! `cargo run --release --example all_positions`

use std::time::Instant;

use kin_core::Positions;
use kin_core::continuation::{PolynomialSystem, Solution, Term, Unsuitable, real_solutions};

/// A term of an equation, given by the index of its coefficient and its variables.
const fn term(equation: u16, coefficient: u16, powers: &'static [(u16, u8)]) -> Term {
    Term {
        equation,
        coefficient,
        powers,
    }
}

/// The loop over the first leg, a side of the platform, another leg and another point of the base: l₁ cis(θ₁) + (u + i
/// v) cis(φ) = b + lₖ cis(θₖ), twice. The variables are the cosine and sine of θ₁, θ₂, θ₃ and φ in turn.
const PLATFORM: PolynomialSystem<8> = PolynomialSystem::new(&[
    term(0, 0, &[(0, 1)]),
    term(0, 1, &[(6, 1)]),
    term(0, 2, &[(7, 1)]),
    term(0, 4, &[(2, 1)]),
    term(0, 5, &[]),
    term(1, 0, &[(1, 1)]),
    term(1, 1, &[(7, 1)]),
    term(1, 3, &[(6, 1)]),
    term(1, 4, &[(3, 1)]),
    term(1, 6, &[]),
    term(2, 0, &[(0, 1)]),
    term(2, 7, &[(6, 1)]),
    term(2, 8, &[(7, 1)]),
    term(2, 10, &[(4, 1)]),
    term(2, 11, &[]),
    term(3, 0, &[(1, 1)]),
    term(3, 7, &[(7, 1)]),
    term(3, 9, &[(6, 1)]),
    term(3, 10, &[(5, 1)]),
    term(3, 12, &[]),
    term(4, 13, &[(0, 2)]),
    term(4, 13, &[(1, 2)]),
    term(4, 14, &[]),
    term(5, 13, &[(2, 2)]),
    term(5, 13, &[(3, 2)]),
    term(5, 14, &[]),
    term(6, 13, &[(4, 2)]),
    term(6, 13, &[(5, 2)]),
    term(6, 14, &[]),
    term(7, 13, &[(6, 2)]),
    term(7, 13, &[(7, 2)]),
    term(7, 14, &[]),
]);

fn main() -> Result<(), Unsuitable> {
    const PATHS: usize = PLATFORM.paths();
    const RUNS: u32 = 200;
    // With these dimensions all six solutions are real. They were found by trial.
    let [leg1, leg2, leg3] = [1.249, 0.954, 2.403];
    let [[base2_x, base2_y], [base3_x, base3_y]] = [[-1.547, 0.514], [1.202, -1.902]];
    let [[u2, v2], [u3, v3]] = [[0.936, 0.811], [-0.838, 0.372]];
    let coefficients = [
        leg1, u2, -v2, v2, -leg2, -base2_x, -base2_y, u3, -v3, v3, -leg3, -base3_x, -base3_y, 1.0, -1.0,
    ];

    let mut positions = Positions::<Solution<8>, PATHS>::new();
    let outcome = real_solutions::<8, PATHS>(&PLATFORM, &coefficients, |solution| {
        positions.push(solution);
    })?;
    println!("{outcome:?}");
    println!("     leg 1      leg 2      leg 3   platform  condition");
    for position in &positions {
        for angle in 0..4 {
            let (cosine, sine) = (position.values[2 * angle], position.values[2 * angle + 1]);
            print!("{:>10.4} ", sine.atan2(cosine).to_degrees());
        }
        println!("{:>10.1}", position.condition);
    }

    let begin = Instant::now();
    for _ in 0..RUNS {
        real_solutions::<8, PATHS>(&PLATFORM, std::hint::black_box(&coefficients), |_| {})?;
    }
    println!("{:.2?} for all of them", begin.elapsed() / RUNS);
    Ok(())
}
