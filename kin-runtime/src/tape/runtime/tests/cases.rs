//! Random cases of all sizes, with special ones among them.

use core::f64::consts::FRAC_PI_2;
use std::vec::Vec;

use crate::verify::Random;

const SPECIAL: [f64; 14] = [
    0.0,
    5e-324,
    1e-310,
    f64::MIN_POSITIVE,
    1e-20,
    0.5,
    1.0,
    2.0,
    1e5,
    1e300,
    0.6 * f64::MAX,
    f64::MAX,
    f64::INFINITY,
    f64::NAN,
];

fn specials() -> impl Iterator<Item = f64> {
    SPECIAL.into_iter().flat_map(|size| [size, -size])
}

/// A number of any size and sign.
fn of_any_size(random: &mut Random, digits: f64) -> f64 {
    let size = random.between(-digits, digits).exp2();
    if random.between(-1.0, 1.0) < 0.0 { -size } else { size }
}

/// 100 000 points (y, x) one after the other; y serves as an angle too.
pub(super) fn points() -> Vec<f64> {
    let mut random = Random::new(1);
    let mut points = Vec::new();
    for y in specials() {
        points.extend(specials().flat_map(|x| [y, x]));
    }
    for index in 0..20_000_i32 {
        // Next to the multiples of π/2, of which every third is among them.
        let quarters = f64::from(3 * index) * FRAC_PI_2;
        let angle = [quarters, quarters.next_up(), -quarters.next_down()][index.rem_euclid(3) as usize];
        points.extend([angle, random.between(-3.0, 3.0)]);
    }
    while points.len() < 200_000 {
        points.extend([of_any_size(&mut random, 1000.0), of_any_size(&mut random, 1000.0)]);
        let radius = of_any_size(&mut random, 30.0);
        let angle = random.between(-4.0, 4.0);
        points.extend([radius * angle.sin(), radius * angle.cos()]);
        points.extend([random.between(-1e5, 1e5), of_any_size(&mut random, 17.0)]);
        points.extend([random.between(-7.0, 7.0), random.between(-7.0, 7.0)]);
    }
    points
}

/// Four-bars in and out of reach, with guesses near and far: four links, the crank's angle, the guesses of coupler and
/// rocker.
pub(super) fn four_bars(count: usize) -> Vec<f64> {
    let mut random = Random::new(2);
    let mut numbers = Vec::new();
    for index in 0..count {
        let crank = random.between(-4.0, 4.0);
        let links = core::array::from_fn::<f64, 4, _>(|_| random.between(0.3, 2.0));
        numbers.extend(links);
        numbers.extend([crank, random.between(-4.0, 4.0), random.between(-4.0, 4.0)]);
        let start = numbers.len() - 7;
        match index % 500 {
            // Stretched, where the two assemblies meet.
            0 => numbers[start..].copy_from_slice(&[4.0, 1.0, 2.0, 1.0, 0.0, 1e-3, 3.1]),
            1 => numbers[start + 5] = f64::NAN,
            2 => numbers[start] = f64::INFINITY,
            3 => numbers[start + 1] = 1e200,
            4 => numbers[start + 2] = 0.0,
            _ => {}
        }
    }
    numbers
}

/// Three constants and three guesses for three surfaces.
pub(super) fn surfaces(count: usize) -> Vec<f64> {
    let mut random = Random::new(3);
    (0..6 * count).map(|_| random.between(-3.0, 3.0)).collect()
}

/// Four rows and a right-hand side; every fourth matrix is singular up to rounding.
pub(super) fn matrices(count: usize) -> Vec<f64> {
    let mut random = Random::new(4);
    let mut numbers = Vec::new();
    for index in 0..count {
        let digits = if index % 3 == 0 { 900.0 } else { 3.0 };
        let mut matrix: Vec<f64> = (0..20).map(|_| of_any_size(&mut random, digits)).collect();
        if index % 4 == 0 {
            for column in 0..4 {
                matrix[12 + column] = 0.3 * matrix[column] - 0.7 * matrix[4 + column];
            }
        }
        match index % 100 {
            1 => matrix[5] = f64::NAN,
            2 => matrix[..4].fill(0.0),
            3 => matrix[9] = 5e-324,
            _ => {}
        }
        numbers.extend(matrix);
    }
    numbers
}
