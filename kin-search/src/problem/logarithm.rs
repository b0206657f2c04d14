//! A function generator for the logarithm.

use std::f64::consts::{PI, TAU};

use kin_core::library::FourBar;
use kin_core::prelude::*;

use super::number;
use super::search::{Bounds, Effort, smallest};

/// The range of the crank, while x goes from 1 to 2.
pub const CRANK: f64 = PI / 3.0;
/// The range of the follower, while log x goes from log 1 to log 2.
pub const FOLLOWER: f64 = PI / 2.0;
/// The shortest and the longest link that are allowed, in ground links.
pub const LINKS: [f64; 2] = [0.1, 10.0];

/// A four-bar linkage whose follower turns with the logarithm of the crank's angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Generator {
    /// The linkage, with a ground link of 1.
    pub linkage: FourBar,
    /// How the coupler meets the follower.
    pub assembly: Assembly,
    /// The crank's angle at x = 1.
    pub crank: f64,
    /// The follower's angle at x = 1.
    pub follower: f64,
    /// +1 if the follower turns in the direction of the crank, -1 if it turns against it.
    pub direction: f64,
}

/// A generator near that with six equal errors, to four digits: see [`Generator::equalised`].
pub const NEAR_EQUAL: Generator = Generator {
    linkage: FourBar {
        r1: 1.0,
        r2: 0.3213,
        r3: 0.9547,
        r4: 0.2661,
    },
    assembly: Assembly::Crossed,
    crank: 0.3685,
    follower: -0.6334,
    direction: -1.0,
};

/// How well a generator follows its function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// The largest structural error: the follower's angle less the angle that is wanted, in radians.
    pub error: f64,
    /// The smallest transmission angle, at most a right angle.
    pub transmission: f64,
}

/// The share of its range through which the follower is to have turned at x.
fn share(x: f64) -> f64 {
    x.log2()
}

impl Generator {
    fn of(numbers: &[f64], assembly: Assembly, direction: f64) -> Self {
        let [r2, r3, r4] = [0, 1, 2].map(|index| numbers[index].exp());
        Self {
            linkage: FourBar { r1: 1.0, r2, r3, r4 },
            assembly,
            crank: numbers[3],
            follower: numbers[4],
            direction,
        }
    }

    fn numbers(&self) -> [f64; 5] {
        let FourBar { r2, r3, r4, .. } = self.linkage;
        [r2.ln(), r3.ln(), r4.ln(), self.crank, self.follower]
    }

    /// The structural error at x, in -π ..= π, and the transmission angle.
    ///
    /// # Errors
    /// [`SolveError`], if the linkage does not close there.
    pub fn error_at(&self, x: f64) -> Result<(f64, f64), SolveError> {
        let pose = self.linkage.position(self.crank + CRANK * (x - 1.0), self.assembly)?;
        let wanted = self.follower + self.direction * FOLLOWER * share(x);
        let error = (pose.theta4.value() - wanted + PI).rem_euclid(TAU) - PI;
        let between = (pose.theta4.value() - pose.theta3.value()).cos().abs().min(1.0).acos();
        Ok((error, between))
    }

    /// The largest error and the smallest transmission angle at equal steps of x.
    ///
    /// # Errors
    /// [`SolveError`], if the linkage does not close everywhere.
    pub fn quality(&self, steps: u32) -> Result<Quality, SolveError> {
        let mut quality = Quality {
            error: 0.0,
            transmission: f64::INFINITY,
        };
        for step in 0..=steps {
            let (error, transmission) = self.error_at(1.0 + f64::from(step) / f64::from(steps))?;
            quality.error = quality.error.max(error.abs());
            quality.transmission = quality.transmission.min(transmission);
        }
        Ok(quality)
    }

    /// The same linkage with the middle of its largest and smallest error at zero.
    fn centred(mut self, steps: u32) -> Option<Self> {
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        for step in 0..=steps {
            let (error, _) = self.error_at(1.0 + f64::from(step) / f64::from(steps)).ok()?;
            range = (range.0.min(error), range.1.max(error));
        }
        self.follower += 0.5 * (range.0 + range.1);
        Some(self)
    }

    /// The generator without an error at five values of x, from one nearby, by Newton's method.
    ///
    /// This is the synthesis for five precision points of F. Freudenstein, "Approximate synthesis of four-bar linkages",
    /// Transactions of the ASME 77, 1955, with the start angles of both cranks free.
    #[must_use]
    pub fn exact_at(self, points: [f64; 5]) -> Option<Self> {
        let wanted = points.map(|x| (x, 0.0));
        self.with_errors(&wanted, false).map(|(generator, _)| generator)
    }

    /// The generator with equal errors of alternating sign at six values of x, from one nearby.
    ///
    /// The errors of the best generator have this form. Each step moves the six values to where the errors are extreme.
    #[must_use]
    pub fn equalised(self, steps: u32) -> Option<Self> {
        let mut best = self;
        for _ in 0..30 {
            let extremes = best.extremes(steps)?;
            let signs: Vec<(f64, f64)> = extremes.iter().map(|(x, error)| (*x, error.signum())).collect();
            if signs.len() != 6 || signs.windows(2).any(|pair| pair[0].1 == pair[1].1) {
                return None;
            }
            let (next, _) = best.with_errors(&signs, true)?;
            let (old, new) = (best.quality(steps).ok()?, next.quality(steps).ok()?);
            let settled = (old.error - new.error).abs() <= 1e-12 * old.error;
            best = next;
            if settled {
                return Some(best);
            }
        }
        Some(best)
    }

    /// Where the error is extreme: the ends of the range and the places between them.
    fn extremes(&self, steps: u32) -> Option<Vec<(f64, f64)>> {
        let mut errors = Vec::new();
        for step in 0..=steps {
            let x = 1.0 + f64::from(step) / f64::from(steps);
            errors.push((x, self.error_at(x).ok()?.0));
        }
        let mut extremes = vec![errors[0]];
        for triple in errors.windows(3) {
            let [before, at, after] = [triple[0].1, triple[1].1, triple[2].1];
            if (at > before && at >= after) || (at < before && at <= after) {
                // the vertex of the parabola through three errors
                let shift = 0.5 * (before - after) / (before - 2.0 * at + after);
                let x = triple[1].0 + shift / f64::from(steps);
                extremes.push((x, self.error_at(x).ok()?.0));
            }
        }
        extremes.extend(errors.last());
        Some(extremes)
    }

    /// Newton's method for given errors, which are multiples of a sixth unknown if they are to be equalised.
    fn with_errors(self, wanted: &[(f64, f64)], equalise: bool) -> Option<(Self, f64)> {
        let mut numbers = self.numbers().to_vec();
        if equalise {
            let first = self.error_at(wanted[0].0).ok()?.0;
            numbers.push(first * wanted[0].1);
        }
        for _ in 0..40 {
            let generator = Self::of(&numbers, self.assembly, self.direction);
            let mut rows = Vec::new();
            for (x, sign) in wanted {
                let pose = generator
                    .linkage
                    .solve(
                        Motion::at_constant_speed(generator.crank + CRANK * (x - 1.0), 1.0),
                        self.assembly,
                    )
                    .ok()?;
                let by =
                    kin_core::Mechanism::sensitivities_at(&generator.linkage, [pose.theta2], self.assembly).ok()?;
                let of = |index: usize| kin_core::prelude::Partials::unknown_partials(&by[index])[1].position();
                let FourBar { r2, r3, r4, .. } = generator.linkage;
                let mut row = vec![r2 * of(1), r3 * of(2), r4 * of(3), pose.theta4.velocity(), -1.0];
                let mut error = generator.error_at(*x).ok()?.0;
                if equalise {
                    row.push(-sign);
                    error -= sign * numbers[5];
                }
                row.push(-error);
                rows.push(row);
            }
            let step = solve(rows)?;
            let largest = step.iter().fold(0.0_f64, |largest, step| largest.max(step.abs()));
            // steps beyond a few degrees leave the region in which the linear equations hold
            let scale = (0.2 / largest).min(1.0);
            for (number, step) in numbers.iter_mut().zip(&step) {
                *number += scale * step;
            }
            if largest < 1e-14 {
                break;
            }
        }
        let generator = Self::of(&numbers, self.assembly, self.direction);
        let level = numbers.get(5).copied().unwrap_or(0.0);
        let met = wanted.iter().all(|(x, sign)| {
            generator
                .error_at(*x)
                .is_ok_and(|(error, _)| (error - sign * level).abs() < 1e-11)
        });
        met.then_some((generator, level.abs()))
    }
}

/// Gauss's elimination with the largest pivot of each column; each row ends with its right-hand side.
fn solve(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let count = rows.len();
    for column in 0..count {
        let pivot =
            (column..count).max_by(|one, other| rows[*one][column].abs().total_cmp(&rows[*other][column].abs()))?;
        rows.swap(column, pivot);
        if rows[column][column] == 0.0 {
            return None;
        }
        let above = rows[column].clone();
        for row in &mut rows[column + 1..] {
            let factor = row[column] / above[column];
            for (cell, above) in row[column..].iter_mut().zip(&above[column..]) {
                *cell -= factor * above;
            }
        }
    }
    let mut found = vec![0.0; count];
    for row in (0..count).rev() {
        let known: f64 = (row + 1..count).map(|cell| rows[row][cell] * found[cell]).sum();
        found[row] = (rows[row][count] - known) / rows[row][row];
    }
    Some(found)
}

/// Chebyshev's places of precision points for x from 1 to 2.
#[must_use]
pub fn chebyshev<const N: usize>() -> [f64; N] {
    std::array::from_fn(|index| 1.5 - 0.5 * (PI * number(2 * index + 1) / number(2 * N)).cos())
}

/// The generators without an error at three given values of x, for given start angles: Freudenstein's three linear equations.
#[must_use]
pub fn three_points(points: [f64; 3], crank: f64, follower: f64, direction: f64) -> Vec<Generator> {
    let rows = points.map(|x| {
        let (input, output) = (crank + CRANK * (x - 1.0), follower + direction * FOLLOWER * share(x));
        vec![output.cos(), -input.cos(), 1.0, (input - output).cos()]
    });
    let Some(k) = solve(rows.to_vec()) else {
        return Vec::new();
    };
    let (r2, r4) = (1.0 / k[0], 1.0 / k[1]);
    let squared = 1.0 + r2 * r2 + r4 * r4 - 2.0 * r2 * r4 * k[2];
    if !(squared.is_finite() && squared > 0.0) {
        return Vec::new();
    }
    // a negative crank is one that points the other way
    let turned = |length: f64| if length < 0.0 { PI } else { 0.0 };
    [Assembly::Open, Assembly::Crossed]
        .map(|assembly| Generator {
            linkage: FourBar {
                r1: 1.0,
                r2: r2.abs(),
                r3: squared.sqrt(),
                r4: r4.abs(),
            },
            assembly,
            crank: crank + turned(r2),
            follower: follower + turned(r4),
            direction,
        })
        .to_vec()
}

/// The steps at which a search looks, and those at which a result is measured.
const COARSE: u32 = 60;
const FINE: u32 = 2000;
/// The cost of a generator that does not close, or whose limits are broken, for each unit by which they are.
const OPEN: f64 = 1e3;
const PRICE: f64 = 10.0;

fn cost(generator: &Generator, transmission: f64, steps: u32) -> f64 {
    let Ok(quality) = generator.quality(steps) else {
        return OPEN;
    };
    let FourBar { r2, r3, r4, .. } = generator.linkage;
    let over = |value: f64, limit: f64| (value - limit).max(0.0);
    let wrong: f64 = [r2, r3, r4]
        .iter()
        .map(|link| over(*link, LINKS[1]) + over(LINKS[0], *link))
        .sum();
    quality.error + PRICE * (wrong + over(transmission, quality.transmission))
}

const KINDS: [(Assembly, f64); 4] = [
    (Assembly::Open, 1.0),
    (Assembly::Open, -1.0),
    (Assembly::Crossed, 1.0),
    (Assembly::Crossed, -1.0),
];

/// The best generator with three precision points at Chebyshev's places, over all start angles, with at least a given
/// transmission angle.
#[must_use]
pub fn best_of_three_points(transmission: f64, effort: Effort) -> Option<Generator> {
    let bounds = Bounds::new(&[[-PI, PI], [-PI, PI]]);
    let best = |numbers: &[f64], direction: f64, steps: u32| {
        let all = three_points(chebyshev(), numbers[0], numbers[1], direction);
        all.into_iter()
            .map(|generator| (cost(&generator, transmission, steps), generator))
            .min_by(|one, other| one.0.total_cmp(&other.0))
    };
    let found = [1.0, -1.0].map(|direction| {
        let found = smallest(&bounds, effort, |numbers| {
            best(numbers, direction, COARSE).map_or(OPEN, |(cost, _)| cost)
        });
        best(&found.point, direction, FINE)
    });
    let found = found
        .into_iter()
        .flatten()
        .min_by(|one, other| one.0.total_cmp(&other.0));
    found.map(|(_, generator)| generator)
}

/// The generator with the smallest largest error, over all dimensions and start angles, with at least a given transmission
/// angle.
#[must_use]
pub fn best(transmission: f64, effort: Effort) -> Option<Generator> {
    let size = [LINKS[0].ln(), LINKS[1].ln()];
    let bounds = Bounds::new(&[size, size, size, [-PI, PI], [-PI, PI]]);
    let of_result = |generator: &Generator| cost(generator, transmission, FINE);
    let found = KINDS.map(|(assembly, direction)| {
        let of = |numbers: &[f64]| Generator::of(numbers, assembly, direction);
        let found = smallest(&bounds, effort, |numbers| cost(&of(numbers), transmission, COARSE));
        let rough = of(&found.point).centred(FINE)?;
        let equalised = rough
            .equalised(FINE)
            .filter(|generator| of_result(generator) < of_result(&rough));
        Some(equalised.unwrap_or(rough))
    });
    let all = found.into_iter().flatten();
    all.min_by(|one, other| of_result(one).total_cmp(&of_result(other)))
}
