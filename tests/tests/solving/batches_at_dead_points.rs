//! Dead points, up to rounding: a batch says of each pose what `solve` says, in every kind of vectors, though they are
//! rounded differently.
//!
//! Each form is put where the number under its root, or its determinant, is zero; some of the given numbers are then
//! moved by a few units in the last place, so that about as many poses close as do not.

use core::f64::consts::{FRAC_PI_4, FRAC_PI_6, PI, TAU};

use kin_core::Dimension;
use kin_core::batch::{Batch, Column, Columns, Element, Outcome, Slot, Vectors, Visitor};
use kin_core::prelude::*;
use kin_tests::mechanisms::multi_loop::TwoDyads;
use kin_tests::random::Random;

/// Poses of each form.
const POSES: usize = kin_tests::samples::of(2000);

/// By how much positions may differ at most, in double precision: by the root of what is rounded, as both lie at a dead
/// point.
const CLOSE: f64 = 1e-6;

mod forms {
    use kin_core::prelude::*;

    mechanism! {
        pub struct Links { a: Length, b: Length, g: Point, c: Length }
        input q: Angle;
        unknown u: Angle, v: Angle;
        order = 1;
        a * cis(q) + b * cis(u) == g + c * cis(v);
    }

    mechanism! {
        pub struct TernaryLinks { a: Length, b: Vector, g: Point, c: Vector }
        input q: Angle;
        unknown u: Angle, v: Angle;
        order = 1;
        a * cis(q) + b * cis(u) == g + c * cis(v);
    }

    mechanism! {
        pub struct Slide { a: Length, b: Length, g: Point, direction: Angle }
        input q: Angle;
        unknown u: Angle, s: Length;
        order = 1;
        a * cis(q) + b * cis(u) == g + s * cis(direction);
    }

    mechanism! {
        pub struct SlideAlongX { a: Length, b: Vector, h: Length }
        input q: Angle;
        unknown u: Angle, s: Length;
        order = 1;
        a * cis(q) + b * cis(u) == vec2(s, h);
    }

    mechanism! {
        pub struct SlideAlongY { a: Length, b: Vector, h: Length }
        input q: Angle;
        unknown u: Angle, s: Length;
        order = 1;
        a * cis(q) + b * cis(u) == vec2(h, s);
    }

    mechanism! {
        pub struct Lever { g: Point, a: Length }
        input q: Angle;
        unknown u: Angle, s: Length;
        order = 1;
        g + a * cis(q) == s * cis(u);
    }

    mechanism! {
        pub struct LeverWithOffset { g: Point, a: Length, h: Vector }
        input q: Angle;
        unknown u: Angle, s: Length;
        order = 1;
        g + a * cis(q) == (s + h) * cis(u);
    }

    mechanism! {
        pub struct ByCosine { a: Length, b: Length, h: Length }
        input q: Angle;
        unknown u: Angle;
        order = 1;
        a * cos(q) + b * cos(u) == h;
    }

    mechanism! {
        pub struct BySine { a: Length, b: Length, h: Length }
        input q: Angle;
        unknown u: Angle;
        order = 1;
        a * sin(q) - b * sin(u) == h;
    }

    mechanism! {
        pub struct Circular { a: Length, b: Length, c: Length, h: Length }
        input q: Angle;
        unknown u: Angle;
        order = 1;
        a * cos(u) + b * sin(u) == c * cos(q) + h;
    }

    mechanism! {
        pub struct Squared { a: Length, b: Length, c: Length }
        input q: Angle;
        unknown x: Length;
        order = 1;
        x.powi(2) == a.powi(2) + b.powi(2) - 2 * a * b * cos(q) - c.powi(2);
    }

    mechanism! {
        pub struct Quadratic { a: Scalar, b: Length, c: Length }
        input q: Angle;
        unknown x: Length;
        order = 1;
        a * x.powi(2) + 2 * b * x * cos(q) + c.powi(2) == 0;
    }

    mechanism! {
        pub struct Linear { a: Length, b: Length, c: Length }
        input q: Angle;
        unknown x: Length;
        order = 1;
        (a - b * cos(q)) * x == c.powi(2);
    }

    mechanism! {
        pub struct TwoSlides { g: Point, p: Vector, t: Vector }
        input q: Angle;
        unknown r: Scalar, s: Scalar;
        order = 1;
        r * p * cis(q) + s * t == g;
    }

    mechanism! {
        pub struct Root { a: Length, b: Length, h: Length }
        input q: Angle;
        unknown x: Length;
        order = 1;
        x == sqrt(a.powi(2) - (b * sin(q) + h).powi(2));
    }

    mechanism! {
        pub struct ArcSine { a: Length, b: Length, h: Length }
        input q: Angle;
        unknown x: Angle;
        order = 1;
        x == asin((b * sin(q) + h) / a) + acos((h - b * sin(-q)) / a);
    }

    mechanism! {
        pub struct Logarithm { a: Scalar, h: Scalar }
        input q: Angle;
        unknown x: Scalar;
        order = 1;
        exp(x) == a * cos(q) + h;
    }

    mechanism! {
        pub struct SineOfArc { a: Length, h: Angle }
        input q: Angle;
        unknown x: Length;
        order = 1;
        asin(x / a) == 0.3 * q + 0.7 * h;
    }

    mechanism! {
        pub struct TangentOfArc { a: Length, h: Angle }
        input q: Angle;
        unknown x: Length;
        order = 1;
        atan(x / a) == 0.3 * q + 0.7 * h;
    }

    mechanism! {
        pub struct CosineOfArc { a: Length, h: Angle }
        input q: Angle;
        unknown x: Length;
        order = 1;
        acos(x / a) == 0.3 * q + 0.7 * h;
    }

    mechanism! {
        pub struct SquareOfRoot { a: Scalar, h: Scalar }
        input q: Angle;
        unknown x: Scalar;
        order = 1;
        sqrt(x) == a * cos(q) + h;
    }

    mechanism! {
        pub struct InARange { a: Length, b: Length, h: Length }
        input q: Angle;
        unknown u: Angle in 0.0..=PI, s: Length in 1.0..=2.0;
        order = 1;
        a * cos(q) + b * cos(u) == h;
        s == a * cos(q) + 2 * h;
    }

    mechanism! {
        /// Three legs of which the lines meet in a point: the platform can be turned a little about it.
        pub struct Platform { a: Length, b: Length, c: Length, pivot_a: Point, pivot_b: Point, pivot_c: Point,
            p: Vector, q: Vector }
        input theta: Angle;
        unknown alpha: Angle, beta: Angle, gamma: Angle, phi: Angle;
        order = 1;
        let joint = pivot_a + a * cis(alpha);
        joint + p * cis(phi) == pivot_b + b * cis(beta);
        joint + q * cis(phi) == pivot_c + c * cis(gamma + theta);
    }
}

use forms::*;

/// Places for all numbers of a pose.
struct Table<E> {
    unknowns: Vec<Vec<Vec<E>>>,
}

impl<E> Columns<Vec<E>> for Table<E> {
    fn each<'a>(&'a mut self, visitor: &mut impl Visitor<'a, Vec<E>>)
    where
        E: 'a,
    {
        for (index, motion) in self.unknowns.iter_mut().enumerate() {
            for (order, column) in motion.iter_mut().enumerate() {
                visitor.visit(Slot::Unknown(index, order), column);
            }
        }
    }
}

/// The numbers that a pose is solved from.
struct Given {
    parameters: Vec<f64>,
    input: f64,
    /// Values of the unknowns near by, where there are no assemblies.
    near: Vec<f64>,
}

/// How many poses closed, and how many did not.
#[derive(Debug, Default)]
struct Tally {
    closed: usize,
    failed: usize,
}

fn kinds() -> impl Iterator<Item = Vectors> {
    [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512]
        .into_iter()
        .filter(|vectors| vectors.are_there())
}

fn motion<M: Mechanism<Scalar: Element>>(value: f64) -> M::Inputs<M::Motion<M::Scalar>> {
    M::Inputs::from_fn(|_| M::Motion::from_fn(|order| M::Scalar::constant(if order == 0 { value } else { 1.0 })))
}

/// Solves the poses one by one and as batches, and compares what is said of each.
fn compare<M: Mechanism<Scalar: Element>>(poses: &[Given], assembly: Option<M::Assembly>) -> Tally {
    let name = M::DESCRIPTION.name;
    let number = <M::Scalar as Number>::constant;
    let close = CLOSE * (M::Scalar::EPSILON / f64::EPSILON).sqrt();
    let count = poses.len();
    let alone: Vec<_> = poses
        .iter()
        .map(|pose| {
            let mechanism = M::from_parameters(Row::from_fn(|place| number(pose.parameters[place])));
            let result = match assembly {
                Some(assembly) => mechanism.solve(motion::<M>(pose.input), assembly),
                None => mechanism.solve_near(motion::<M>(pose.input), Row::from_fn(|place| number(pose.near[place]))),
            };
            result.map(|pose| {
                let motions = pose.unknown_motions();
                let motions = motions.as_ref().iter();
                motions.map(|motion| motion[0].real()).collect::<Vec<f64>>()
            })
        })
        .collect();
    let column = |of: &dyn Fn(&Given) -> f64| -> Vec<M::Scalar> { poses.iter().map(|pose| number(of(pose))).collect() };
    let parameters: Vec<Vec<M::Scalar>> = (0..M::DESCRIPTION.parameters.len())
        .map(|place| column(&|pose| pose.parameters[place]))
        .collect();
    let input = column(&|pose| pose.input);
    let near: Vec<Vec<M::Scalar>> = (0..M::DESCRIPTION.unknowns.len())
        .map(|place| column(&|pose| pose.near.get(place).copied().unwrap_or(0.0)))
        .collect();
    for vectors in kinds() {
        let mut table = Table {
            unknowns: vec![vec![vec![number(0.0); count]; 2]; M::DESCRIPTION.unknowns.len()],
        };
        let mut outcomes = vec![Outcome::Unsolved; count];
        let parameters = Row::from_fn(|place| Column::Each(&parameters[place]));
        let inputs = M::Inputs::from_fn(|_| {
            <M::Motion<Column<'_, M::Scalar>> as Row<Column<'_, M::Scalar>>>::from_fn(|order| match order {
                0 => Column::Each(&input),
                _ => Column::Same(number(1.0)),
            })
        });
        let summary = if let Some(assembly) = assembly {
            Batch::<M, _>::new(parameters, inputs, assembly)
                .vectors(vectors)
                .solve(&mut table, &mut outcomes)
        } else {
            let near = Row::from_fn(|place| Column::Each(&near[place]));
            Batch::<M, _>::near(parameters, inputs, near)
                .vectors(vectors)
                .solve(&mut table, &mut outcomes)
        };
        let summary = summary.expect("all columns are of one length");
        assert_eq!(summary.solved + summary.failed, count, "{name}");
        let mut in_doubt = 0;
        for (index, (outcome, alone)) in outcomes.iter().zip(&alone).enumerate() {
            let Given {
                parameters,
                input,
                near,
            } = &poses[index];
            let place = format!("{name}, {vectors:?}, {assembly:?}, {parameters:?}, {input:?}");
            match alone {
                Ok(alone) => {
                    assert_eq!(*outcome, Outcome::Solved, "{place}");
                    for (column, (alone, quantity)) in
                        table.unknowns.iter().zip(alone.iter().zip(M::DESCRIPTION.unknowns))
                    {
                        let mut error = column[0][index].real() - alone;
                        if quantity.dimension == Dimension::Angle {
                            // Half a turn has two signs.
                            error -= TAU * (error / TAU).round();
                        }
                        assert!(
                            error.abs() <= close * alone.abs().max(1.0),
                            "{place}: {error:e} of {alone}"
                        );
                    }
                }
                Err(error) => match (outcome.margin(), Outcome::from(error).margin()) {
                    // The block before may be at a dead point.
                    (Some(found), Some(margin)) => {
                        let size = parameters.iter().map(|length| length.abs()).sum::<f64>();
                        assert!(
                            (found - margin).abs() <= close * size,
                            "{place}: {found:e} for {margin:e}"
                        );
                    }
                    // Rounding decides whether two roots coincide, and vectors round differently.
                    _ if assembly.is_none() && outcome.is_solved() && Outcome::from(error) == Outcome::Singular => {
                        in_doubt += 1;
                        for (column, near) in table.unknowns.iter().zip(near) {
                            let error = column[0][index].real() - near;
                            assert!(error.abs() <= 0.01, "{place}: {error:e} from the double root");
                        }
                    }
                    _ => assert_eq!(*outcome, Outcome::from(error), "{place}"),
                },
            }
        }
        assert!(
            in_doubt <= count / 100,
            "{name}, {vectors:?}: {in_doubt} of {count} poses in doubt"
        );
    }
    let closed = alone.iter().filter(|alone| alone.is_ok()).count();
    println!("{name}, {assembly:?}: {closed} of {count} closed");
    Tally {
        closed,
        failed: count - closed,
    }
}

/// A number that is so many units in the last place away, in single precision.
#[expect(clippy::cast_possible_truncation, reason = "rounding is what is wanted")]
fn moved_single(number: f64, units: i32) -> f64 {
    let next = if units > 0 { f32::next_up } else { f32::next_down };
    (0..units.abs()).fold(number as f32, |number, _| next(number)).into()
}

/// A number that is so many units in the last place away.
fn moved(number: f64, units: i32) -> f64 {
    let next = if units > 0 { f64::next_up } else { f64::next_down };
    (0..units.abs()).fold(number, |number, _| next(number))
}

/// Poses that a function of random numbers gives, a quarter of them moved by a unit or two in the last place of one
/// parameter.
fn poses(seed: u64, moved: fn(f64, i32) -> f64, given: impl Fn(&mut Random) -> Given) -> Vec<Given> {
    let mut random = Random::new(seed);
    (0..POSES)
        .map(|index| {
            let mut given = given(&mut random);
            let place = index / 3 % given.parameters.len();
            let parameter = &mut given.parameters[place];
            let units = match index % 15 {
                0 => 1,
                3 => -1,
                6 => 2,
                9 => -2,
                _ => 0,
            };
            *parameter = moved(*parameter, units);
            given
        })
        .collect()
}

/// A form in every assembly, in both precisions.
fn every_assembly<M: Mechanism<Scalar = f64>>(solution: &str, given: impl Fn(&mut Random) -> Given) {
    let blocks = M::DESCRIPTION.blocks;
    assert!(blocks.iter().any(|block| block.solution == solution), "{blocks:?}");
    let [double, single] = [moved, moved_single].map(|moved| poses(M::DESCRIPTION.name.len() as u64, moved, &given));
    for assembly in M::assemblies() {
        for tally in [
            compare::<M>(&double, Some(assembly)),
            compare::<M::With<f32>>(&single, Some(assembly)),
        ] {
            assert!(tally.closed > POSES / 50 && tally.failed > POSES / 50, "{tally:?}");
        }
    }
}

/// A length of few digits, as people choose them.
fn length(random: &mut Random) -> f64 {
    (random.between(1.0, 9.0) * 4.0).round() / 4.0
}

/// Any length.
fn odd_length(random: &mut Random) -> f64 {
    if random.between(0.0, 1.0) < 0.5 {
        length(random)
    } else {
        random.between(0.5, 9.0)
    }
}

/// An angle, often one of whole twelfths or eighths of a turn.
fn angle(random: &mut Random) -> f64 {
    let any = random.between(-PI, PI);
    let step = [None, Some(FRAC_PI_4), Some(FRAC_PI_6)]
        .into_iter()
        .find(|_| random.between(0.0, 1.0) < 0.4)
        .flatten();
    step.map_or(any, |step| (any / step).round() * step)
}

fn sign(random: &mut Random) -> f64 {
    if random.between(0.0, 1.0) < 0.5 { 1.0 } else { -1.0 }
}

fn at(length: f64, angle: f64) -> Plane {
    let (sine, cosine) = angle.sin_cos();
    Plane::new(length * cosine, length * sine)
}

fn given(parameters: impl Into<Vec<f64>>, input: f64) -> Given {
    Given {
        parameters: parameters.into(),
        input,
        near: Vec::new(),
    }
}

#[test]
fn dyads() {
    every_assembly::<Links<f64>>("circle meets circle (RRR dyad)", |random| {
        let [a, b, c] = [0; 3].map(|_| odd_length(random));
        let (q, u) = (angle(random), angle(random));
        let g = at(a, q) + at(b, u) + at(c * sign(random), u);
        given([a, b, g.x, g.y, c], q)
    });
    // ends that coincide
    every_assembly::<Links<f64>>("circle meets circle (RRR dyad)", |random| {
        let [a, b] = [0; 2].map(|_| odd_length(random));
        let q = angle(random);
        let g = at(a, q);
        given([a, b, g.x, g.y, b], q)
    });
    every_assembly::<TernaryLinks<f64>>("circle meets circle (RRR dyad)", |random| {
        let a = odd_length(random);
        let [b, c] = [0; 2].map(|_| Plane::new(odd_length(random), length(random)));
        let (q, u) = (angle(random), angle(random));
        let ratio = sign(random) * (c.norm_squared() / b.norm_squared()).sqrt();
        let arm = b.times(at(1.0, u));
        let g = at(a, q) + arm + arm.scale(ratio);
        given([a, b.x, b.y, g.x, g.y, c.x, c.y], q)
    });
    every_assembly::<Slide<f64>>("circle meets line (RRP dyad)", |random| {
        let [a, b] = [0; 2].map(|_| odd_length(random));
        let (q, direction) = (angle(random), angle(random));
        let g = at(a, q) + at(b, direction).times(Plane::new(0.0, sign(random))) + at(length(random), direction);
        given([a, b, g.x, g.y, direction], q)
    });
    every_assembly::<SlideAlongX<f64>>("a cos x + b sin x = c", |random| {
        let a = odd_length(random);
        let b = Plane::new(length(random), odd_length(random));
        let q = angle(random);
        let h = at(a, q).y + sign(random) * b.norm_squared().sqrt();
        given([a, b.x, b.y, h], q)
    });
    every_assembly::<SlideAlongY<f64>>("a cos x + b sin x = c", |random| {
        let a = odd_length(random);
        let b = Plane::new(length(random), odd_length(random));
        let q = angle(random);
        let h = at(a, q).x + sign(random) * b.norm_squared().sqrt();
        given([a, b.x, b.y, h], q)
    });
    every_assembly::<Lever<f64>>("polar form (RPR dyad)", |random| {
        let a = odd_length(random);
        let q = angle(random);
        let g = -at(a, q);
        given([g.x, g.y, a], q)
    });
    every_assembly::<LeverWithOffset<f64>>("polar form with offset (RPR dyad)", |random| {
        let a = odd_length(random);
        let (q, u) = (angle(random), angle(random));
        let h = Plane::new(length(random), odd_length(random));
        let g = Plane::new(0.0, h.y).times(at(1.0, u)) - at(a, q);
        given([g.x, g.y, a, h.x, h.y], q)
    });
}

#[test]
fn one_unknown() {
    every_assembly::<ByCosine<f64>>("inverse cosine", |random| {
        let [a, b] = [0; 2].map(|_| odd_length(random));
        let q = angle(random);
        given([a, b, at(a, q).x + sign(random) * b], q)
    });
    every_assembly::<BySine<f64>>("inverse sine", |random| {
        let [a, b] = [0; 2].map(|_| odd_length(random));
        let q = angle(random);
        given([a, b, at(a, q).y + sign(random) * b], q)
    });
    every_assembly::<Circular<f64>>("a cos x + b sin x = c", |random| {
        let [a, b, c] = [0; 3].map(|_| odd_length(random));
        let q = angle(random);
        given([a, b, c, sign(random) * a.hypot(b) - at(c, q).x], q)
    });
    every_assembly::<Squared<f64>>("square root", |random| {
        let [a, b] = [0; 2].map(|_| odd_length(random));
        let q = angle(random);
        let c = (a * a + b * b - 2.0 * a * b * q.cos()).sqrt();
        given([a, b, c], q)
    });
    every_assembly::<Quadratic<f64>>("quadratic equation", |random| {
        let (a, b) = (length(random), odd_length(random));
        let q = angle(random);
        given([a, b, (b * q.cos()) / a.sqrt()], q)
    });
    every_assembly::<Linear<f64>>("linear equation", |random| {
        let b = odd_length(random);
        let q = angle(random);
        given([b * q.cos(), b, length(random)], q)
    });
    every_assembly::<TwoSlides<f64>>("two linear equations", |random| {
        // A turned vector along an axis has one coordinate that is all rounding.
        let (p, q, t) = loop {
            let p = Plane::new(length(random), odd_length(random));
            let q = angle(random);
            let t = p.times(at(length(random), q));
            if t.x.abs().min(t.y.abs()) > 1e-3 {
                break (p, q, t);
            }
        };
        given([length(random), length(random), p.x, p.y, t.x, t.y], q)
    });
}

#[test]
fn functions() {
    every_assembly::<Root<f64>>("linear equation", |random| {
        let [a, b] = [0; 2].map(|_| odd_length(random));
        let q = angle(random);
        given([a, b, sign(random) * a - at(b, q).y], q)
    });
    every_assembly::<ArcSine<f64>>("linear equation", |random| {
        let [a, b] = [0; 2].map(|_| odd_length(random));
        let q = angle(random);
        given([a, b, sign(random) * a - at(b, q).y], q)
    });
    every_assembly::<Logarithm<f64>>("inverse of exp, then linear equation", |random| {
        let a = odd_length(random);
        let q = angle(random);
        given([a, -(a * q.cos())], q)
    });
    every_assembly::<SquareOfRoot<f64>>("inverse of sqrt, then linear equation", |random| {
        let a = odd_length(random);
        let q = angle(random);
        given([a, -(a * q.cos())], q)
    });
    every_assembly::<SineOfArc<f64>>("inverse of asin, then linear equation", |random| {
        let a = odd_length(random);
        let q = angle(random);
        given([a, (sign(random) * 0.5 * PI - 0.3 * q) / 0.7], q)
    });
    every_assembly::<TangentOfArc<f64>>("inverse of atan, then linear equation", |random| {
        let a = odd_length(random);
        let q = angle(random);
        given([a, (sign(random) * 0.5 * PI - 0.3 * q) / 0.7], q)
    });
    every_assembly::<CosineOfArc<f64>>("inverse of acos, then linear equation", |random| {
        let a = odd_length(random);
        let q = angle(random);
        let end = if random.between(0.0, 1.0) < 0.5 { 0.0 } else { PI };
        given([a, (end - 0.3 * q) / 0.7], q)
    });
}

#[test]
fn ends_of_ranges() {
    let poses = poses(1, moved, |random| {
        let [a, b] = [0; 2].map(|_| odd_length(random));
        let q = angle(random);
        let end = if random.between(0.0, 1.0) < 0.5 { 1.0 } else { 2.0 };
        let h = 0.5 * (end - a * q.cos());
        given([a, b, h], q)
    });
    for assembly in InARange::<f64>::assemblies() {
        compare::<InARange<f64>>(&poses, Some(assembly));
        compare::<InARange<f32>>(&poses, Some(assembly));
    }
}

#[test]
fn one_dyad_after_the_other() {
    let poses = poses(2, moved, |random| {
        let [a, b, c, d, e] = [0; 5].map(|_| length(random));
        let w = Plane::new(length(random), length(random));
        let (q, u, v, x) = (angle(random), angle(random), angle(random), angle(random));
        let g = at(a, q) + at(b, u) - at(c, v);
        let h = at(a, q) + w.times(at(1.0, u)) + at(d, x) + at(e * sign(random), x);
        given([a, b, g.x, g.y, c, w.x, w.y, d, h.x, h.y, e], q)
    });
    for assembly in TwoDyads::<f64>::assemblies() {
        compare::<TwoDyads<f64>>(&poses, Some(assembly));
        compare::<TwoDyads<f32>>(&poses, Some(assembly));
    }
}

#[test]
fn a_platform_whose_legs_meet_in_a_point() {
    let poses = poses(3, moved, |random| {
        let centre = Plane::new(length(random), length(random));
        let [alpha, beta, gamma] = [0; 3].map(|_| angle(random));
        let [a, b, c] = [0; 3].map(|_| odd_length(random));
        let theta = angle(random);
        let tips = [alpha, beta, gamma].map(|direction| centre + at(length(random), direction));
        let pivots = [tips[0] - at(a, alpha), tips[1] - at(b, beta), tips[2] - at(c, gamma)];
        let (p, q) = (tips[1] - tips[0], tips[2] - tips[0]);
        let phi = angle(random);
        let (p, q) = (p.times(at(1.0, -phi)), q.times(at(1.0, -phi)));
        let [pa, pb, pc] = pivots;
        Given {
            parameters: vec![a, b, c, pa.x, pa.y, pb.x, pb.y, pc.x, pc.y, p.x, p.y, q.x, q.y],
            input: theta,
            near: [alpha, beta, gamma - theta, phi]
                .map(|value| value + random.between(-1e-3, 1e-3))
                .to_vec(),
        }
    });
    compare::<Platform<f64>>(&poses, None);
    compare::<Platform<f32>>(&poses, None);
}

/// Both dyads are stretched at this crank angle, and rounding makes the second one close in one kind of vectors and not
/// in others.
#[test]
fn a_stephenson_linkage_at_a_dead_point() {
    let parameters = [
        3.0,
        5.0,
        -5.0,
        -2.000_000_000_000_000_4,
        1.0,
        5.0,
        4.0,
        1.0,
        -4.999_999_999_999_999,
        -4.0,
        4.0,
    ];
    let poses: Vec<Given> = (0..16).map(|_| given(parameters, -PI / 2.0)).collect();
    for assembly in TwoDyads::<f64>::assemblies() {
        compare::<TwoDyads<f64>>(&poses, Some(assembly));
        compare::<TwoDyads<f32>>(&poses, Some(assembly));
    }
}

#[test]
fn half_turns() {
    let poses = poses(4, moved, |random| {
        let [a, b, c] = [0; 3].map(|_| odd_length(random));
        let (q, v) = (angle(random), angle(random));
        let g = at(a, q) - Plane::new(b, 0.0) - at(c, v);
        given([a, b, g.x, g.y, c], q)
    });
    for assembly in Links::<f64>::assemblies() {
        compare::<Links<f64>>(&poses, Some(assembly));
        compare::<Links<f32>>(&poses, Some(assembly));
    }
}
