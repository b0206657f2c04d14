//! The class III triad has up to six positions, like the platform of a planar 3-RPR manipulator with locked legs.

use std::vec::Vec;

use proptest::prelude::*;

use super::super::sequence::FixedSequence;
use super::super::{PathCounts, Solution, real_solutions};
use super::platform::Platform;
use crate::number::samples;

fn solve(platform: &Platform) -> (PathCounts, Vec<Solution<8>>) {
    let table = platform.table();
    let mut found = Vec::new();
    let outcome =
        real_solutions::<8, 16>(&table.system(), &table.coefficients, |solution| found.push(solution)).unwrap();
    (outcome, found)
}

/// A function of the platform angle that is zero at each position.
///
/// Subtracting the first leg from the other two gives linear equations a × p = b for the end p of the first leg. With
/// their solution N / D, the length of the first leg gives |N|² - L₁² D².
fn gap(platform: &Platform, angle: f64) -> f64 {
    let (sine, cosine) = angle.sin_cos();
    let [[ax, ay, ah], [bx, by, bh]] = [0, 1].map(|side| {
        let [u, v] = platform.sides[side];
        let base = platform.bases[side + 1];
        let (x, y) = (base[0] - u * cosine + v * sine, base[1] - u * sine - v * cosine);
        let squares = platform.legs[0].powi(2) - platform.legs[side + 1].powi(2);
        [x, y, (x * x + y * y + squares) / 2.0]
    });
    let determinant = ax * by - ay * bx;
    let (x, y) = (ah * by - bh * ay, ax * bh - bx * ah);
    x * x + y * y - (platform.legs[0] * determinant).powi(2)
}

/// The angles at which the gap changes its sign, found without continuation.
fn scanned(platform: &Platform) -> Vec<f64> {
    const POINTS: u32 = 10_000;
    let angle = |point: u32| core::f64::consts::TAU * f64::from(point) / f64::from(POINTS);
    let mut angles = Vec::new();
    for point in 0..POINTS {
        let (mut low, mut high) = (angle(point), angle(point + 1));
        let below = gap(platform, low) < 0.0;
        if below == (gap(platform, high) < 0.0) {
            continue;
        }
        for _ in 0..50 {
            let middle = f64::midpoint(low, high);
            if (gap(platform, middle) < 0.0) == below {
                low = middle;
            } else {
                high = middle;
            }
        }
        angles.push(low);
    }
    angles
}

fn platform_angle(solution: &Solution<8>) -> f64 {
    let [.., cosine, sine] = solution.values;
    sine.atan2(cosine).rem_euclid(core::f64::consts::TAU)
}

/// The smallest difference between two angles, across whole revolutions.
fn apart(first: f64, second: f64) -> f64 {
    let difference = (first - second).rem_euclid(core::f64::consts::TAU);
    difference.min(core::f64::consts::TAU - difference)
}

/// The largest residual of the three legs, as lengths.
fn misfit(platform: &Platform, solution: &Solution<8>) -> f64 {
    let [c, s, ..] = solution.values;
    let first = [platform.legs[0] * c, platform.legs[0] * s];
    [0, 1, 2]
        .map(|leg| {
            let [c, s] = [solution.values[2 * leg], solution.values[2 * leg + 1]];
            let [x, y] = platform.point(leg, first, platform_angle(solution));
            let base = platform.bases[leg];
            (base[0] + platform.legs[leg] * c - x).hypot(base[1] + platform.legs[leg] * s - y)
        })
        .into_iter()
        .fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn all_positions_of_any_platform(number in any::<u64>()) {
        let platform = Platform::random(&mut FixedSequence::new(number));
        let (outcome, found) = solve(&platform);
        let expected = PathCounts { paths: 6, regular: 6, real: found.len(), singular: 0, at_infinity: 0, lost: 0 };
        prop_assert_eq!(outcome, expected);
        let scanned = scanned(&platform);
        // Every solution of the scan is among the solutions found.
        for angle in &scanned {
            let near = found.iter().any(|solution| {
                // The sign is reliable down to the rounding of fourth powers.
                apart(platform_angle(solution), *angle) <= (1e4 * f64::EPSILON * solution.condition.powi(2)).min(1e-3)
            });
            prop_assert!(near, "{} {:?} {:?}", angle, scanned, found);
        }
        // All solutions found are positions. If the scan misses positions, there are two of them between neighbouring
        // points of the scan.
        for solution in &found {
            prop_assert!(misfit(&platform, solution) <= 64.0 * f64::EPSILON * solution.condition);
        }
        let close = found
            .iter()
            .enumerate()
            .any(|(k, one)| found[..k].iter().any(|other| apart(platform_angle(one), platform_angle(other)) < 1e-3));
        prop_assert!(found.len() == scanned.len() || close, "{:?} {:?}", scanned, found);
    }
}

/// Room for more variables changes no bit: `kin-live` has few sizes for all systems.
#[test]
fn room_for_more_variables_changes_nothing() {
    let mut random = FixedSequence::new(16);
    for _ in 0..samples::of(20) {
        let platform = Platform::random(&mut random);
        let (counts, found) = solve(&platform);
        let table = platform.table();
        let system = table.system::<16>().with_variables(8);
        let mut roomy = Vec::new();
        let outcome = real_solutions::<16, 16>(&system, &table.coefficients, |solution| roomy.push(solution));
        assert_eq!(outcome, Ok(counts));
        for (one, other) in found.iter().zip(&roomy) {
            assert_eq!(other.values[..8], one.values);
            assert_eq!(other.values[8..], [0.0; 8]);
            assert_eq!(other.condition.to_bits(), one.condition.to_bits());
        }
    }
}

/// The first platform of a random sequence that has six real positions.
fn six() -> (Platform, Vec<Solution<8>>) {
    let mut random = FixedSequence::new(6);
    loop {
        let platform = Platform::random(&mut random);
        let (_, found) = solve(&platform);
        if found.len() == 6 {
            return (platform, found);
        }
    }
}

#[test]
fn six_positions_in_any_unit() {
    let (platform, found) = six();
    assert_eq!(scanned(&platform).len(), 6);
    for unit in [1e-6, 1e-3, 1e6] {
        let [bases, sides] = [&platform.bases[..], &platform.sides[..]]
            .map(|points| points.iter().map(|[x, y]| [x * unit, y * unit]).collect::<Vec<_>>());
        let scaled = Platform {
            bases: bases.try_into().unwrap(),
            sides: sides.try_into().unwrap(),
            legs: platform.legs.map(|leg| leg * unit),
        };
        let (outcome, scaled) = solve(&scaled);
        assert_eq!((outcome.real, outcome.lost), (6, 0));
        for solution in &found {
            assert!(scaled.iter().any(|other| {
                let distance = apart(platform_angle(solution), platform_angle(other));
                distance <= 64.0 * f64::EPSILON * solution.condition
            }));
        }
    }
}

/// A platform in a position in which the lines of the three legs meet at one point, and its angle there. Two positions
/// coincide there (K. H. Hunt, *Structural kinematics of in-parallel-actuated robot arms*, 1983).
pub(super) fn limit(random: &mut FixedSequence) -> (Platform, f64) {
    let mut platform = Platform::random(random);
    let angle = random.fraction();
    let meeting = [-1.0 - random.fraction(), 2.0 * random.fraction()];
    // The base of the first leg is the origin.
    let part = 0.4 * random.fraction() - 1.0;
    let first = [part * meeting[0], part * meeting[1]];
    for leg in 0..3 {
        // The base lies on the line from the platform's point to the point where the legs meet.
        let [x, y] = platform.point(leg, first, angle);
        if leg > 0 {
            let part = 0.3 + 0.5 * random.fraction();
            platform.bases[leg] = [x + part * (meeting[0] - x), y + part * (meeting[1] - y)];
        }
        let base = platform.bases[leg];
        platform.legs[leg] = (x - base[0]).hypot(y - base[1]);
    }
    (platform, angle)
}

#[test]
fn a_limit_position_is_found_as_a_double_one() {
    let mut random = FixedSequence::new(7);
    for _ in 0..20 {
        let (platform, angle) = limit(&mut random);
        let (outcome, found) = solve(&platform);
        assert_eq!(
            (outcome.regular, outcome.singular, outcome.lost),
            (4, 2, 0),
            "{platform:?} {found:?}"
        );
        let singular: Vec<_> = found.iter().filter(|solution| solution.multiplicity > 1).collect();
        let [solution] = *singular else {
            panic!("{found:?}");
        };
        assert_eq!(solution.multiplicity, 2);
        // The angle changes by the square root of the rounding of the dimensions.
        assert!(apart(platform_angle(solution), angle) < 64.0 * f64::EPSILON.sqrt());
    }
}

/// Close to a limit position there are two real positions on one side and none on the other. Their distance is
/// proportional to the square root of the distance to the limit.
#[test]
fn near_a_limit_position_nothing_is_lost() {
    let mut random = FixedSequence::new(8);
    for _ in 0..samples::of(5) {
        let (platform, _) = limit(&mut random);
        for exponent in 1..=16 {
            let counts = [-1.0, 1.0].map(|sign| {
                let mut platform = platform;
                platform.legs[1] *= 1.0 + sign * 10.0_f64.powi(-exponent);
                let (outcome, found) = solve(&platform);
                assert_eq!(
                    (outcome.paths, outcome.at_infinity, outcome.lost),
                    (6, 0, 0),
                    "{platform:?}"
                );
                assert!(
                    matches!((outcome.regular, outcome.singular), (6, 0) | (4, 2)),
                    "{platform:?} {exponent} {outcome:?} {found:?}"
                );
                found.iter().map(|solution| solution.multiplicity).sum::<usize>()
            });
            // Further away there may be another limit. Closer to this one, the two count as one double position on both
            // sides.
            if (3..=9).contains(&exponent) {
                assert_eq!(counts[0].abs_diff(counts[1]), 2, "{platform:?} {exponent}");
            }
        }
    }
}

/// A platform that is congruent to its base and has equal legs moves on circles, so its positions are not isolated.
#[test]
fn what_can_move_has_singular_positions() {
    let platform = Platform {
        bases: [[0.0, 0.0], [1.0, 0.0], [0.3, 0.8]],
        legs: [0.7; 3],
        sides: [[1.0, 0.0], [0.3, 0.8]],
    };
    let (outcome, found) = solve(&platform);
    assert_eq!(outcome.lost, 0);
    assert!(outcome.singular >= 2, "{outcome:?}");
    for solution in found {
        assert!(misfit(&platform, &solution) <= f64::EPSILON.sqrt(), "{solution:?}");
    }
}

#[test]
fn a_tiny_platform_loses_no_path() {
    for size in [1e-3, 1e-6] {
        let platform = Platform {
            bases: [[0.0, 0.0], [1.0, 0.0], [0.5, 0.8]],
            legs: [0.9, 1.0, 1.1],
            sides: [[size, 0.0], [0.4 * size, 0.9 * size]],
        };
        let (outcome, _) = solve(&platform);
        assert_eq!((outcome.paths, outcome.lost), (6, 0), "{outcome:?}");
    }
}
