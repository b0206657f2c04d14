//! Double precision in each language beside this crate.

use std::vec::Vec;

use super::{ALL, Folder, WARNINGS, cases};
use crate::failure::Failure;
use crate::number::Number;
use crate::number::elementary::{is_near, near_sine_cosine, ordinary_arc_tangent};
use crate::solve::{factor, newton};
use crate::tape::NumberType;
use crate::tape::runtime;

/// A translation of the run time, with the program that tries it.
struct Translation {
    folder: Folder,
    command: [&'static str; 2],
}

impl Translation {
    fn c(name: &str, compiler: &str, options: &[&str]) -> Self {
        let folder = Folder::new(name);
        let text = runtime::c(ALL, NumberType::Double) + include_str!("main.c");
        folder.write("main.c", text);
        let mut arguments = Vec::from(WARNINGS);
        arguments.extend(options);
        arguments.extend(["main.c", "-o", "main", "-lm"]);
        folder.run(compiler, &arguments);
        let command = ["./main", ""];
        Self { folder, command }
    }

    fn java_script() -> Self {
        let folder = Folder::new("node");
        folder.write("main.mjs", runtime::java_script(ALL) + include_str!("main.js"));
        Self {
            folder,
            command: ["node", "main.mjs"],
        }
    }

    fn python() -> Self {
        let folder = Folder::new("python3");
        let text =
            include_str!("head.py").replace("\n\n\n\n", "\n\n\n") + &runtime::python(ALL) + include_str!("main.py");
        folder.write("main.py", text);
        Self {
            folder,
            command: ["python3", "main.py"],
        }
    }

    /// The results for some cases, in rows of `length` numbers.
    fn results(&self, cases: &str, numbers: &[f64], length: usize) -> Vec<Vec<f64>> {
        self.folder.write_numbers("in", numbers);
        let arguments = [self.command[1], cases];
        let arguments = &arguments[usize::from(self.command[1].is_empty())..];
        let program = if self.command[0] == "./main" {
            self.folder.0.join("main").to_string_lossy().into_owned()
        } else {
            self.command[0].into()
        };
        self.folder.run(&program, arguments);
        self.folder.numbers("out").chunks(length).map(Vec::from).collect()
    }

    fn agrees(&self) {
        let points = cases::points();
        let found = self.results("elementary", &points, 3);
        assert_eq!(found.len(), points.len() / 2);
        for (point, found) in points.chunks(2).zip(&found) {
            elementary([point[0], point[1]], [found[0], found[1], found[2]]);
        }
        // Newton's method is compared bit by bit where this crate does not fuse products either.
        if crate::number::elementary::FUSED {
            return;
        }
        let count = 20_000;
        let four_bars = cases::four_bars(count);
        self.roots("four-bar", &four_bars, 7, [1.0; 2], four_bar);
        self.roots("surfaces", &cases::surfaces(count), 6, [1.0, 2.0, 0.5], surfaces);
        let matrices = cases::matrices(count);
        let found = self.results("matrices", &matrices, 6);
        for (given, found) in matrices.chunks(20).zip(found) {
            let matrix = core::array::from_fn(|row| core::array::from_fn(|column| given[4 * row + column]));
            let right = core::array::from_fn(|row| given[16 + row]);
            same(
                given,
                &found,
                factor::<f64, 4>(matrix).map(|factors| factors.solve(right)),
            );
        }
    }

    fn roots<const N: usize>(
        &self,
        name: &str,
        numbers: &[f64],
        length: usize,
        sizes: [f64; N],
        equations: impl Fn(&[f64], [f64; N]) -> ([f64; N], [[f64; N]; N]),
    ) {
        let found = self.results(name, numbers, N + 2);
        let mut outcomes = [0; 4];
        for (given, found) in numbers.chunks(length).zip(found) {
            let guess = core::array::from_fn(|index| given[length - N + index]);
            same(
                given,
                &found,
                newton(guess, sizes, |unknowns| equations(given, unknowns)),
            );
            let kind = [0.0_f64, 1.0, 2.0, 3.0].map(f64::to_bits);
            let kind = kind.iter().position(|kind| *kind == found[0].to_bits());
            outcomes[kind.expect("one of four outcomes")] += 1;
        }
        assert!(outcomes[0] > 1000 && outcomes[1] > 100, "{name}: {outcomes:?}");
    }
}

/// Bits, with one for all that is not a number.
fn bits(number: f64) -> u64 {
    if number.is_nan() {
        f64::NAN.to_bits()
    } else {
        number.to_bits()
    }
}

/// Compares sine, cosine and angle with those of this crate, or with those of its platform where it leaves them to it.
fn elementary([y, x]: [f64; 2], found: [f64; 3]) {
    // Two platforms may round differently.
    let alike = |found: f64, expected: f64| {
        bits(found) == bits(expected)
            || (found - expected).abs() <= 2.0 * f64::EPSILON * expected.abs() && found.signum() == expected.signum()
    };
    let (sine, cosine) = if is_near(y) {
        let (sine, cosine) = near_sine_cosine::<false, false, _>(y);
        assert_eq!(found.map(bits)[..2], [sine, cosine].map(bits), "{y:e}: {found:?}");
        (sine, cosine)
    } else {
        y.sin_cos()
    };
    assert!(alike(found[0], sine) && alike(found[1], cosine), "{y:e}: {found:?}");
    let (angle, ordinary) = ordinary_arc_tangent::<false, false, _>(y, x);
    if ordinary {
        assert_eq!(bits(found[2]), bits(angle), "atan2({y:e}, {x:e}): {found:?} {angle:e}");
    } else {
        let angle = y.atan2(x);
        assert!(alike(found[2], angle), "atan2({y:e}, {x:e}): {found:?} {angle:e}");
    }
}

/// Compares the outcome, its detail and, if there is one, the root.
fn same<const N: usize>(given: &[f64], found: &[f64], expected: Result<[f64; N], Failure>) {
    let (code, detail, root) = match expected {
        Ok(root) => (0.0, 0.0, Some(root)),
        Err(Failure::NotConverged { residual, .. }) => (1.0, residual, None),
        Err(Failure::Singular { determinant }) => (2.0, determinant, None),
        Err(Failure::NotFinite { .. }) => (3.0, found[1], None),
        Err(other) => panic!("{other}"),
    };
    assert_eq!(found[0], code, "{given:?}: {found:?} {expected:?}");
    assert_eq!(bits(found[1]), bits(detail), "{given:?}: {found:?} {expected:?}");
    if let Some(root) = root {
        assert_eq!(
            found[2..].iter().copied().map(bits).collect::<Vec<_>>(),
            root.map(bits),
            "{given:?}: {found:?} {expected:?}"
        );
    }
}

fn four_bar(r: &[f64], [coupler, rocker]: [f64; 2]) -> ([f64; 2], [[f64; 2]; 2]) {
    let (s2, c2) = Number::sin_cos(r[4]);
    let (s3, c3) = Number::sin_cos(coupler);
    let (s4, c4) = Number::sin_cos(rocker);
    (
        [
            r[1] * c2 + r[2] * c3 - r[0] - r[3] * c4,
            r[1] * s2 + r[2] * s3 - r[3] * s4,
        ],
        [[-(r[2] * s3), r[3] * s4], [r[2] * c3, -(r[3] * c4)]],
    )
}

fn surfaces(g: &[f64], [x, y, z]: [f64; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
    (
        [x * x + y * y + z * z - g[0], x * y - g[1] * z, x + y * z - g[2]],
        [[2.0 * x, 2.0 * y, 2.0 * z], [y, x, -g[1]], [1.0, z, y]],
    )
}

#[test]
#[ignore = "gcc"]
fn c_finds_the_same_bits() {
    Translation::c("gcc", "gcc", &[]).agrees();
}

#[test]
#[ignore = "gcc"]
fn c_is_sound_under_sanitizers() {
    // Sanitizers with the optimiser cause false warnings about numbers that may not be set.
    let options = ["-fsanitize=undefined,address", "-fno-sanitize-recover=all", "-O1"];
    Translation::c("sanitizers", "gcc", &options).agrees();
}

#[test]
#[ignore = "clang"]
fn c_finds_the_same_bits_by_clang() {
    Translation::c("clang", "clang", &[]).agrees();
}

#[test]
#[ignore = "node"]
fn java_script_finds_the_same_bits() {
    Translation::java_script().agrees();
}

#[test]
#[ignore = "numpy"]
fn numpy_finds_the_same_bits() {
    Translation::python().agrees();
}
