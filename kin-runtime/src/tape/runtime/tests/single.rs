//! Single precision in C beside exact values.

use core::f64::consts::{FRAC_PI_4, PI};
use std::vec::Vec;

use super::{ALL, Folder, WARNINGS};
use crate::number::single;
use crate::tape::NumberType;
use crate::tape::runtime;
use crate::verify::Random;

/// The program for sines, cosines and angles.
const MAIN: &str = r#"
#include <stdio.h>

static void point(float y, float x, float *found)
{
    kin_sine_cosine(y, &found[0], &found[1]);
    found[2] = kin_atan2(y, x);
}

/* The loop of a four-bar. */
static void equations(const void *given, const float *u, float *residuals, float jacobian[KIN_UNKNOWNS][KIN_UNKNOWNS])
{
    const float *r = given;
    float s2, c2, s3, c3, s4, c4;
    kin_sine_cosine(r[4], &s2, &c2);
    kin_sine_cosine(u[0], &s3, &c3);
    kin_sine_cosine(u[1], &s4, &c4);
    residuals[0] = r[1] * c2 + r[2] * c3 - r[0] - r[3] * c4;
    residuals[1] = r[1] * s2 + r[2] * s3 - r[3] * s4;
    jacobian[0][0] = -(r[2] * s3);
    jacobian[0][1] = r[3] * s4;
    jacobian[1][0] = r[2] * c3;
    jacobian[1][1] = -(r[3] * c4);
}

static float root(const float *numbers, float *found)
{
    static const float sizes[2] = {1.0f, 1.0f};
    float detail;
    kin_block block = {2, equations, 0, sizes};
    block.given = numbers;
    return (float)kin_newton(&block, numbers + 5, found, &detail);
}

int main(int count, char **arguments)
{
    const int newton = count > 1 && arguments[1][0] == 'n';
    const size_t length = newton ? 7 : 2;
    float numbers[7];
    float found[3];
    FILE *in = fopen("in", "rb");
    FILE *out = in ? fopen("out", "wb") : NULL;
    if (!out) {
        return 1;
    }
    while (fread(numbers, sizeof numbers[0], length, in) == length) {
        if (newton) {
            found[0] = root(numbers, found + 1);
        } else {
            point(numbers[0], numbers[1], found);
        }
        fwrite(found, sizeof found, 1, out);
    }
    fclose(in);
    return fclose(out);
}
"#;

fn compiled(name: &str, options: &[&str]) -> Folder {
    let folder = Folder::new(name);
    folder.write("main.c", runtime::c(ALL, NumberType::Single) + MAIN);
    let mut arguments = Vec::from(WARNINGS);
    arguments.extend(options);
    arguments.extend(["main.c", "-o", "main", "-lm"]);
    folder.run("gcc", &arguments);
    folder
}

fn run(folder: &Folder, argument: &str, numbers: &[f32]) -> Vec<f32> {
    let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    folder.write("in", bytes);
    folder.run(&folder.0.join("main").to_string_lossy(), &[argument]);
    let bytes = std::fs::read(folder.0.join("out")).unwrap();
    let (numbers, rest) = bytes.as_chunks::<4>();
    assert!(rest.is_empty());
    numbers.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect()
}

/// The distance in units in the last place of the exact value.
fn units(found: f32, exact: f64) -> f64 {
    if found.is_nan() && exact.is_nan() || f64::from(found) == exact {
        return 0.0;
    }
    let size = f64::from(single(exact)).abs().max(f64::from(f32::MIN_POSITIVE));
    let unit = size.log2().floor().exp2() * f64::from(f32::EPSILON);
    (f64::from(found) - exact).abs() / unit
}

fn arguments() -> Vec<f32> {
    let mut random = Random::new(5);
    let mut numbers = Vec::new();
    let special = [
        0.0,
        f32::MIN_POSITIVE,
        1e-40,
        1.0,
        2.0,
        1e5,
        1e20,
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
    ];
    for y in special.into_iter().flat_map(|y| [y, -y]) {
        numbers.extend(special.into_iter().flat_map(|x| [y, x, y, -x]));
    }
    for index in 0..30_000_i32 {
        let quarters = single(f64::from(2 * index) * 2.0 * FRAC_PI_4);
        numbers.extend([quarters, single(random.between(-2.0, 2.0))]);
    }
    while numbers.len() < 200_000 {
        let size = random.between(-120.0, 120.0).exp2();
        let angle = random.between(-PI, PI);
        numbers.extend([single(size * angle.sin()), single(size * angle.cos())]);
        numbers.extend([single(random.between(-1e5, 1e5)), single(random.between(-1e5, 1e5))]);
        numbers.extend([single(random.between(-7.0, 7.0)), single(random.between(-7.0, 7.0))]);
    }
    numbers
}

#[test]
#[ignore = "gcc"]
fn c_in_single_precision_is_within_four_units() {
    let folder = compiled("single", &[]);
    let numbers = arguments();
    let found = run(&folder, "e", &numbers);
    assert_eq!(found.len() / 3, numbers.len() / 2);
    let mut worst = [0.0_f64; 3];
    for (point, found) in numbers.chunks(2).zip(found.chunks(3)) {
        let [y, x] = [point[0], point[1]].map(f64::from);
        for (index, exact) in [y.sin(), y.cos(), y.atan2(x)].into_iter().enumerate() {
            let error = units(found[index], exact);
            // The promise is 4 ε, and a unit is at most ε. A large angle adds the rounding of its reduction.
            assert!(
                error <= 4.0,
                "{index} {y:e} {x:e}: {:e} {exact:e} {error}",
                found[index]
            );
            assert_eq!(
                found[index].is_sign_negative(),
                exact.is_sign_negative() || exact.is_nan() && found[index].is_sign_negative()
            );
            worst[index] = worst[index].max(error);
        }
    }
    std::println!("worst errors of sine, cosine and angle in units in the last place: {worst:.3?}");
}

/// A root found in single precision satisfies the equations to single precision.
#[test]
#[ignore = "gcc"]
fn roots_in_single_precision_close_the_loop() {
    let folder = compiled(
        "single-newton",
        &["-fsanitize=undefined,address", "-fno-sanitize-recover=all"],
    );
    let numbers: Vec<f32> = super::cases::four_bars(5000).into_iter().map(single).collect();
    let found = run(&folder, "n", &numbers);
    let mut roots = 0;
    for (given, found) in numbers.chunks(7).zip(found.chunks(3)) {
        if found[0] != 0.0 {
            continue;
        }
        roots += 1;
        let r: Vec<f64> = given.iter().copied().map(f64::from).collect();
        let [coupler, rocker] = [found[1], found[2]].map(f64::from);
        let x = r[1] * r[4].cos() + r[2] * coupler.cos() - r[0] - r[3] * rocker.cos();
        let y = r[1] * r[4].sin() + r[2] * coupler.sin() - r[3] * rocker.sin();
        // Each angle is rounded, and each product and sum of three terms.
        let size = r[..4].iter().sum::<f64>() * (1.0 + coupler.abs().max(rocker.abs()));
        let allowed = 4.0 * f64::from(f32::EPSILON) * size;
        assert!(
            x.abs() <= allowed && y.abs() <= allowed,
            "{given:?} {found:?}: {x:e} {y:e} {allowed:e}"
        );
    }
    assert!(roots > 1000, "{roots}");
}
