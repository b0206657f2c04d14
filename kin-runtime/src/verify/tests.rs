//! Tests of the oracles themselves. A mechanism written by hand, of high order and without named assemblies, can be
//! made wrong on purpose.

use std::string::ToString;
use std::{assert, assert_eq, println};

use super::{Sampling, mechanism, of};
use crate::assembly::{Assembly, Near};
use crate::failure::{Failure, InputValues, SolveError};
use crate::geometry::Plane;
use crate::library::{FourBar, InvertedSliderCrank, SliderCrank};
use crate::mechanism::{Block, BlockForm, Description, Formula, Formulas, Mechanism, Pose};
use crate::motion::Motion;
use crate::number::{Number, Operations};
use crate::picture::{Outline, TransmissionAngle};
use crate::quantity::Quantity;
use crate::solve::Scalar;

/// The tests read no formulas.
const NO_FORMULA: Formula<'static> = Formula::new("", "", "");
/// One more than the order of the [`Hyperbola`].
const LENGTH: usize = 7;
/// The order of a wrong derivative if nothing is wrong.
const NOTHING: usize = usize::MAX;

/// The equation y² = x² + a² for y, with the output x y, up to the sixth order, by Newton's method. The unknown's
/// derivative of order `UNKNOWN` and the output's derivative of order `OUTPUT` are wrong in the seventh digit.
#[derive(Clone, Copy, Debug)]
struct Hyperbola<T, const UNKNOWN: usize, const OUTPUT: usize> {
    a: T,
}

#[derive(Clone, Copy, Debug)]
struct HyperbolaPose<T> {
    y: Motion<T, LENGTH>,
    product: Motion<T, LENGTH>,
}

impl<T: Scalar> Pose for HyperbolaPose<T> {
    type Scalar = T;
    type Motion = Motion<T, LENGTH>;
    type Unknowns<V: Copy> = [V; 1];
    type Outputs<V: Copy> = [V; 1];

    fn unknown_motions(&self) -> [Motion<T, LENGTH>; 1] {
        [self.y]
    }

    fn output_motions(&self) -> [Motion<T, LENGTH>; 1] {
        [self.product]
    }
}

const fn quantity(name: &'static str) -> Quantity<'static> {
    Quantity::length(name, "")
}

/// The n-th derivative of a product without the terms that contain an n-th derivative of a factor, by Leibniz's rule.
fn inner<T: Scalar>(f: &[T], g: &[T], n: usize) -> T {
    let mut sum = T::constant(0.0);
    let mut binomial = 1.0;
    for k in 1..n {
        binomial *= f64::from(u32::try_from(n - k + 1).unwrap()) / f64::from(u32::try_from(k).unwrap());
        sum = sum + T::constant(binomial) * f[k] * g[n - k];
    }
    sum
}

fn spoilt<T: Scalar>(value: T, order: usize, wrong: usize) -> T {
    if order == wrong {
        value * T::constant(1.0 + 1e-7)
    } else {
        value
    }
}

impl<T: Scalar, const UNKNOWN: usize, const OUTPUT: usize> Hyperbola<T, UNKNOWN, OUTPUT> {
    fn motion(&self, x: Motion<T, LENGTH>, near: T) -> Result<HyperbolaPose<T>, SolveError> {
        let two = T::constant(2.0);
        let [position] = self.position_near([x.value()], [near])?;
        let x = x.derivatives();
        let mut y = [position; LENGTH];
        let mut product = [x[0] * position; LENGTH];
        for n in 1..LENGTH {
            let right = two * x[0] * x[n] + inner(&x, &x, n);
            y[n] = spoilt((right - inner(&y, &y, n)) / (two * y[0]), n, UNKNOWN);
            product[n] = spoilt(x[0] * y[n] + x[n] * y[0] + inner(&x, &y, n), n, OUTPUT);
        }
        Ok(HyperbolaPose {
            y: Motion::new(y),
            product: Motion::new(product),
        })
    }
}

impl<T: Scalar, const UNKNOWN: usize, const OUTPUT: usize> Mechanism for Hyperbola<T, UNKNOWN, OUTPUT> {
    type Scalar = T;
    type With<S: Scalar> = Hyperbola<S, UNKNOWN, OUTPUT>;
    type Assembly = Near<1>;
    type Motion<V: Copy> = Motion<V, LENGTH>;
    type Pose = HyperbolaPose<T>;
    type Parameters<V: Copy> = [V; 1];
    type Inputs<V: Copy> = [V; 1];
    type Unknowns<V: Copy> = [V; 1];
    type Results<V: Copy> = [V; 2];
    type Residuals<V: Copy> = [V; 1];
    type Prepared = ();
    type Blocks<V: Copy> = [V; 1];
    type Dyads<V: Copy> = [V; 0];
    type SkeletonPoints = [Plane<T>; 0];

    crate::__lent! { 1 1 1 1 LENGTH }

    const DESCRIPTION: Description<'static> = Description {
        name: "Hyperbola",
        parameters: &[quantity("a")],
        inputs: &[quantity("x")],
        unknowns: &[quantity("y")],
        outputs: &[quantity("product")],
        equations: &["y.powi(2) == x.powi(2) + a.powi(2)"],
        blocks: &[Block {
            unknowns: "y",
            solution: "Newton's method",
            members: &[0],
            equations: &[0],
        }],
        order: LENGTH - 1,
        operations: &[Operations::NONE; LENGTH],
        groups: &[],
    };
    const FORMULAS: Formulas<'static> = Formulas::new(NO_FORMULA, &[], &[], NO_FORMULA, NO_FORMULA);
    const ASSEMBLY_COUNT: usize = 0;
    const OUTLINE: Outline<'static> = Outline::NONE;

    fn assembly(_: usize) -> Option<Near<1>> {
        None
    }

    fn assembly_at(&self, _: [T; 1], near: [T; 1]) -> Near<1> {
        Near(near.map(Number::real))
    }

    fn from_parameters([a]: [T; 1]) -> Self {
        Self { a }
    }

    fn parameters(&self) -> [T; 1] {
        [self.a]
    }

    fn convert<S: Scalar>(&self, mut convert: impl FnMut(T) -> S) -> Self::With<S> {
        Hyperbola { a: convert(self.a) }
    }

    fn prepare(&self) {}

    fn solve_prepared(
        &self,
        (): &(),
        [x]: [Motion<T, LENGTH>; 1],
        Near([near]): Near<1>,
    ) -> Result<Self::Pose, SolveError> {
        self.motion(x, T::constant(near))
    }

    fn solve_near(&self, [x]: [Motion<T, LENGTH>; 1], [near]: [T; 1]) -> Result<Self::Pose, SolveError> {
        self.motion(x, near)
    }

    fn position(&self, x: [T; 1], Near([near]): Near<1>) -> Result<[T; 1], SolveError> {
        self.position_near(x, [T::constant(near)])
    }

    /// Each further step doubles the number of digits and of derivatives. Guesses beyond ten (an arbitrary limit) are
    /// refused.
    fn position_near(&self, [x]: [T; 1], [near]: [T; 1]) -> Result<[T; 1], SolveError> {
        if near.real().abs() > 10.0 {
            return Err(
                Failure::OutOfReach { margin: -1.0 }.at("y", InputValues::new(Self::DESCRIPTION.inputs, &[x.real()]))
            );
        }
        let square = x * x + self.a * self.a;
        let mut y = near;
        for _ in 0..16 {
            y = (y + square / y) / T::constant(2.0);
        }
        Ok([y])
    }

    fn closure(&self, [x]: [T; 1], [y]: [T; 1]) -> [T; 1] {
        [y * y - x * x - self.a * self.a]
    }

    fn skeleton_points(&self, _: [T; 1], _: [T; 1]) -> [Plane<T>; 0] {
        []
    }

    fn outputs_at(&self, [x]: [T; 1], [y]: [T; 1]) -> [T; 1] {
        [x * y]
    }

    fn block_forms(&self) -> [BlockForm<T>; 1] {
        [BlockForm::Coupled]
    }

    fn transmission_angles_at(&self, _: [T; 1], _: [T; 1]) -> [TransmissionAngle<T>; 0] {
        []
    }

    fn jacobian_near(&self, [x]: [T; 1], near: [T; 1]) -> Result<[[T; 1]; 2], SolveError> {
        let [y] = self.position_near([x], near)?;
        let slope = x / y;
        Ok([[slope], [y + x * slope]])
    }
}

#[test]
fn a_right_mechanism_passes() {
    let report = mechanism::<Hyperbola<f64, NOTHING, NOTHING>>();
    println!("{report}");
    report.assert();
    assert_eq!(report.worst.closure.len(), LENGTH);
    assert_eq!(report.worst.outputs.len(), LENGTH);
    assert_eq!(report.worst.poses, 200);
}

/// Both oracles find an unknown with one derivative wrong in the seventh digit, at that order first.
#[test]
fn a_wrong_derivative_is_found_by_both_oracles() {
    fn check<const WRONG: usize>() {
        let report = mechanism::<Hyperbola<f64, WRONG, NOTHING>>();
        println!("{report}");
        assert!(!report.passed());
        for errors in [&report.worst.differentiation, &report.worst.closure] {
            for order in 0..WRONG {
                assert!(errors[order] <= super::allowed(order), "order {order}: {errors:?}");
            }
            assert!(errors[WRONG] > super::allowed(WRONG), "order {WRONG}: {errors:?}");
        }
        assert!(report.to_string().contains("FAILED"));
        assert!(report.to_string().contains("worst of all: "));
    }
    check::<1>();
    check::<2>();
    check::<3>();
    check::<4>();
    check::<5>();
    check::<6>();
}

#[test]
fn a_wrong_output_is_found() {
    fn check<const WRONG: usize>() {
        let report = mechanism::<Hyperbola<f64, NOTHING, WRONG>>();
        assert!(!report.passed());
        let errors = &report.worst.outputs;
        assert!(errors[WRONG] > super::allowed(WRONG), "order {WRONG}: {errors:?}");
        let finding = report.worst.finding.expect("there are poses");
        assert_eq!((finding.quantity.as_str(), finding.order), ("product", WRONG));
        assert!(
            finding.location.contains("x = [") && finding.location.contains("a = "),
            "{finding}"
        );
    }
    check::<1>();
    check::<4>();
    check::<6>();
}

/// A mechanism that does not close is not verified, and the report says so.
#[test]
fn too_few_poses_do_not_pass() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 1.0,
        r3: 2.0,
        r4: 3.0,
    };
    let report = of(&linkage, [(-3.0, 3.0)]);
    assert_eq!((report.worst.poses, report.closed), (0, 0));
    assert_eq!(report.tried, Sampling::default().draws);
    assert!(!report.passed());
    let text = report.to_string();
    assert!(
        text.starts_with("FourBar: NOT VERIFIED, too few poses, 0 poses; closed at 0 of 50000 draws, seed 1"),
        "{text}"
    );
    assert!(
        !Sampling {
            poses: 0,
            ..Sampling::default()
        }
        .mechanism::<FourBar>()
        .passed()
    );
}

#[test]
#[should_panic(expected = "NOT VERIFIED")]
fn assert_panics_with_the_table() {
    let slider = SliderCrank { r: f64::NAN, l: 1.0 };
    of(&slider, [(0.0, 1.0)]).assert();
}

#[test]
fn every_seed_is_reproducible() {
    let sampling = Sampling {
        poses: 40,
        seed: 12,
        ..Sampling::default()
    };
    let first = sampling.mechanism::<InvertedSliderCrank>();
    assert_eq!(first, sampling.mechanism::<InvertedSliderCrank>());
    let other = Sampling { seed: 13, ..sampling }.mechanism::<InvertedSliderCrank>();
    assert!(first.worst != other.worst);
}

/// A mechanism that closes in only one of its assemblies is verified there.
#[test]
fn poses_are_counted_one_by_one() {
    let linkage: FourBar = FourBar {
        r1: 4.0,
        r2: 1.0,
        r3: 3.0,
        r4: 2.5,
    };
    let mut worst = super::Worst::default();
    assert!(worst.check(&linkage, [Motion::constant(0.3)], Assembly::Open));
    assert!(!worst.check(&linkage, [Motion::constant(f64::NAN)], Assembly::Open));
    assert_eq!(worst.poses, 1);
    assert!(worst.is_allowed());
    assert!(worst.outputs.is_empty());
}

/// The expansion of `with test;`.
#[test]
fn the_body_of_a_declared_test() {
    crate::__private::assert_verified!(FourBar<f64>);
}
