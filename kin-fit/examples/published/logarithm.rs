//! A function generator for the logarithm.

use std::f64::consts::{PI, TAU};

use kin_core::any::Of;
use kin_core::library::FourBar;
use kin_core::prelude::*;
use kin_fit::{Candidate, Choice, Effort, Measured, Objective, penalised, smallest};

use super::number;

/// The range of the crank, while x goes from 1 to 2.
pub(crate) const CRANK: f64 = PI / 3.0;
/// The range of the follower, while log x goes from log 1 to log 2.
pub(crate) const FOLLOWER: f64 = PI / 2.0;
/// The shortest and the longest link that are allowed, in ground links.
pub(crate) const LINKS: [f64; 2] = [0.1, 10.0];

/// A four-bar linkage whose follower turns with the logarithm of the crank's angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Generator {
    /// The linkage, with a ground link of 1.
    pub(crate) linkage: FourBar,
    /// The assembly of coupler and follower.
    pub(crate) assembly: Assembly,
    /// The crank's angle at x = 1.
    pub(crate) crank: f64,
    /// The follower's angle at x = 1.
    pub(crate) follower: f64,
    /// +1 if the follower turns in the direction of the crank, -1 if it turns against it.
    pub(crate) direction: f64,
}

/// A generator near that with six equal errors, to four digits: see [`Generator::equalised`].
pub(crate) const NEAR_EQUAL: Generator = Generator {
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

/// The quality of a generator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quality {
    /// The largest structural error: the follower's angle less the angle that is wanted, in radians.
    pub(crate) error: f64,
    /// The smallest transmission angle, at most a right angle.
    pub(crate) transmission: f64,
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

    /// The structural error at x, in -π ..= π, and the transmission angle.
    ///
    /// # Errors
    /// [`SolveError`], if the linkage does not close there.
    pub(crate) fn error_at(&self, x: f64) -> Result<(f64, f64), SolveError> {
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
    pub(crate) fn quality(&self, steps: u32) -> Result<Quality, SolveError> {
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

    /// The generator without an error at five values of x, from one nearby.
    ///
    /// This is the synthesis for five precision points of F. Freudenstein, "Approximate synthesis of four-bar
    /// linkages", Transactions of the ASME 77, 1955, with the start angles of both cranks free.
    #[must_use]
    pub(crate) fn exact_at(self, points: [f64; 5]) -> Option<Self> {
        let wanted = points.map(|x| (x, 0.0));
        self.with_errors(&wanted, false)
    }

    /// The generator with equal errors of alternating sign at six values of x, from one nearby.
    ///
    /// The errors of the best generator have this form. Each step moves the six values to where the errors are extreme.
    #[must_use]
    pub(crate) fn equalised(self, steps: u32) -> Option<Self> {
        let mut best = self;
        for _ in 0..30 {
            let extremes = best.extremes(steps)?;
            let signs: Vec<(f64, f64)> = extremes.iter().map(|(x, error)| (*x, error.signum())).collect();
            if signs.len() != 6 || signs.windows(2).any(|pair| pair[0].1 == pair[1].1) {
                return None;
            }
            let next = best.with_errors(&signs, true)?;
            let (old, new) = (best.quality(steps).ok()?, next.quality(steps).ok()?);
            let settled = (old.error - new.error).abs() <= 1e-12 * old.error;
            best = next;
            if settled {
                return Some(best);
            }
        }
        Some(best)
    }

    /// The values of x at which the error is extreme: the ends of the range and the extremes between them.
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

    /// The generator with given errors, which are multiples of a sixth unknown if they are to be equalised, by least
    /// squares without a rest.
    fn with_errors(self, wanted: &[(f64, f64)], equalise: bool) -> Option<Self> {
        let FourBar { r1, r2, r3, r4 } = self.linkage;
        let level = if equalise {
            self.error_at(wanted[0].0).ok()?.0 * wanted[0].1
        } else {
            0.0
        };
        let values = |(x, _): &(f64, f64)| vec![Some(self.direction * FOLLOWER * share(*x))];
        let rows = Measured {
            columns: vec![2],
            inputs: wanted
                .iter()
                .map(|(x, sign)| vec![Some(CRANK * (x - 1.0)), Some(*sign)])
                .collect(),
            values: wanted.iter().map(values).collect(),
        };
        let functions = Of::<WithErrors>::FUNCTIONS;
        let mut objective = Objective::measured(functions, &rows, 0, &[0.0; 2], [0.0, CRANK]).ok()?;
        for (name, value) in [("r2", r2), ("r3", r3), ("r4", r4)] {
            objective = objective.bounds(name, 0.5 * value..=2.0 * value).ok()?;
        }
        for (name, value) in [("crank", self.crank), ("follower", self.follower)] {
            objective = objective.bounds(name, value - 0.5..=value + 0.5).ok()?;
        }
        if equalise {
            objective = objective.bounds("level", level - 0.5..=level + 0.5).ok()?;
        }
        let start = vec![r1, r2, r3, r4, self.crank, self.follower, level];
        let start = Candidate::with_parameters(start, Choice::of::<WithErrors>(self.assembly, &[]));
        let found = objective.nearest_minimum(&objective.design(&start).ok()?, [200, 50]);
        let &[r1, r2, r3, r4, crank, follower, level] = found.parameters() else {
            return None;
        };
        let found = Self {
            linkage: FourBar { r1, r2, r3, r4 },
            crank,
            follower,
            ..self
        };
        let is_met = |(x, sign): &(f64, f64)| {
            found
                .error_at(*x)
                .is_ok_and(|(error, _)| (error - sign * level).abs() < 1e-11)
        };
        wanted.iter().all(is_met).then_some(found)
    }
}

mechanism! {
    /// A function generator whose structural error is a multiple of a level.
    struct WithErrors { r1: Length, r2: Length, r3: Length, r4: Length, crank: Angle, follower: Angle, level: Angle }
    input turned: Angle, multiple: Scalar;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(crank + turned) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output travel: Angle = theta4 - follower - multiple * level;
}

/// Chebyshev's spacing of precision points for x from 1 to 2.
#[must_use]
pub(crate) fn chebyshev<const N: usize>() -> [f64; N] {
    std::array::from_fn(|index| 1.5 - 0.5 * (PI * number(2 * index + 1) / number(2 * N)).cos())
}

/// The generators without an error at three given values of x, for given start angles: Freudenstein's three linear
/// equations.
#[must_use]
pub(crate) fn three_points(points: [f64; 3], crank: f64, follower: f64, direction: f64) -> Vec<Generator> {
    let angles = points.map(|x| (crank + CRANK * (x - 1.0), follower + direction * FOLLOWER * share(x)));
    let column = |of: fn((f64, f64)) -> f64| angles.map(of);
    let [outputs, inputs] = [column(|(_, output)| output.cos()), column(|(input, _)| -input.cos())];
    let right = column(|(input, output)| (input - output).cos());
    // Cramer's rule
    let volume = |[a, b, c]: [f64; 3], [d, e, f]: [f64; 3], [g, h, i]: [f64; 3]| {
        a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
    };
    let all = volume(outputs, inputs, [1.0; 3]);
    let (r2, r4) = (
        all / volume(right, inputs, [1.0; 3]),
        all / volume(outputs, right, [1.0; 3]),
    );
    let squared = 1.0 + r2 * r2 + r4 * r4 - 2.0 * r2 * r4 * volume(outputs, inputs, right) / all;
    if !(squared.is_finite() && squared > 0.0) {
        return Vec::new();
    }
    // a negative crank points the other way
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

/// The steps of a search, and those at which a result is measured.
const COARSE: u32 = 60;
const FINE: u32 = 2000;
/// The cost of a broken limit, for each unit by which it is broken.
const PRICE: f64 = 10.0;

fn cost(generator: &Generator, transmission: f64, steps: u32) -> f64 {
    let Ok(quality) = generator.quality(steps) else {
        // the angle at which the linkage ceases to close is not known
        return penalised(Err(0.0), 1.0);
    };
    let FourBar { r2, r3, r4, .. } = generator.linkage;
    let over = |value: f64, limit: f64| (value - limit).max(0.0);
    let wrong: f64 = [r2, r3, r4]
        .iter()
        .map(|link| over(*link, LINKS[1]) + over(LINKS[0], *link))
        .sum();
    penalised(
        Ok(quality.error + PRICE * (wrong + over(transmission, quality.transmission))),
        1.0,
    )
}

const KINDS: [(Assembly, f64); 4] = [
    (Assembly::Open, 1.0),
    (Assembly::Open, -1.0),
    (Assembly::Crossed, 1.0),
    (Assembly::Crossed, -1.0),
];

/// The best generator with three precision points at Chebyshev's spacing, over all start angles, with at least a given
/// transmission angle.
#[must_use]
pub(crate) fn best_of_three_points(transmission: f64, effort: Effort) -> Option<Generator> {
    let bounds = [[-PI, PI], [-PI, PI]];
    let best = |numbers: &[f64], direction: f64, steps: u32| {
        let all = three_points(chebyshev(), numbers[0], numbers[1], direction);
        all.into_iter()
            .map(|generator| (cost(&generator, transmission, steps), generator))
            .min_by(|one, other| one.0.total_cmp(&other.0))
    };
    let found = [1.0, -1.0].map(|direction| {
        let found = smallest(&bounds, effort, |numbers| {
            best(numbers, direction, COARSE).map_or(penalised(Err(1.0), 1.0), |(cost, _)| cost)
        });
        best(&found.point, direction, FINE)
    });
    let found = found
        .into_iter()
        .flatten()
        .min_by(|one, other| one.0.total_cmp(&other.0));
    found.map(|(_, generator)| generator)
}

/// The generator with the smallest largest error, over all dimensions and start angles, with at least a given
/// transmission angle.
#[must_use]
pub(crate) fn best(transmission: f64, effort: Effort) -> Option<Generator> {
    let size = [LINKS[0].ln(), LINKS[1].ln()];
    let bounds = [size, size, size, [-PI, PI], [-PI, PI]];
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
