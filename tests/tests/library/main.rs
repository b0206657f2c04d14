//! The library's mechanisms against published values and exact geometry.
//!
//! Both oracles are run over the whole library in the tests of `proof`.

mod stored;

use core::f64::consts::{PI, TAU};

use kin_core::library::*;
use kin_core::prelude::*;
use kin_core::{Dimension, TrackError, track};
use kin_tests::compare::{assert_agree, turned_back};
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;
use kin_tests::samples;

type Path = Motion<Plane, 5>;

/// Crank motions with random rates, evenly spread.
fn cranks(low: f64, high: f64, seed: u64) -> Vec<Motion> {
    let mut random = Random::new(seed);
    (0..60)
        .map(|step| low + (high - low) * (f64::from(step) + 0.5) / 60.0)
        .map(|angle| Motion::new(random.motion(angle)))
        .collect()
}

/// The error that the links of lengths `links`, at angles with the places `angles` among the unknowns, leave in a point.
fn point_unit<M: ThroughSnap>(
    mechanism: &M,
    inputs: M::Inputs<Motion>,
    unknowns: &M::Unknowns<Motion>,
    links: &[(f64, usize)],
    order: usize,
) -> f64 {
    let gauge = Gauge::new(mechanism, &inputs, unknowns);
    let links: f64 = links
        .iter()
        .map(|(length, angle)| length * gauge.unknown(*angle, order))
        .sum();
    ALLOWED[order] * links
}

/// The points that a crank's angles in degrees give.
fn points(degrees: impl Iterator<Item = f64>, point: impl Fn(f64) -> Plane) -> Vec<Plane> {
    degrees.map(|angle| point(angle.to_radians())).collect()
}

/// The largest extent of points along x and along y.
fn extent(points: &[Plane]) -> Plane {
    let spread = |coordinate: fn(&Plane) -> f64| {
        let low = points.iter().map(coordinate).fold(f64::INFINITY, f64::min);
        points.iter().map(coordinate).fold(f64::NEG_INFINITY, f64::max) - low
    };
    Plane::new(spread(|point| point.x), spread(|point| point.y))
}

/// Asserts that a figure is the published one, to the digits that are printed.
#[track_caller]
fn assert_printed(own: f64, printed: f64, last_digit: f64) {
    assert!(
        (own - printed).abs() <= 0.5 * last_digit,
        "{own} is not printed as {printed}"
    );
}

/// Hairer and Wanner's initial position, to its printed digits.
#[test]
fn andrews_position() {
    let squeezer = AndrewsSqueezer::PUBLISHED;
    let position = squeezer
        .position(0.0, AndrewsSqueezer::PUBLISHED_ASSEMBLY)
        .expect("it is published");
    let motion = squeezer
        .solve(Motion::constant(0.0), AndrewsSqueezer::PUBLISHED_ASSEMBLY)
        .expect("it closes");
    let gauge = Gauge::new(&squeezer, &[Motion::constant(0.0)], &motion.unknown_motions());
    let published = [
        -0.061_713_890_014_276_45,
        0.455_279_819_163_070_4,
        0.222_668_390_165_885_9,
        0.487_364_979_543_842_55,
        -0.222_668_390_165_885_9,
        1.230_547_444_549_821_2,
    ];
    let own = [
        position.beta,
        position.gamma,
        position.phi,
        position.delta,
        position.omega,
        position.epsilon,
    ]
    .map(|angle| angle.value());
    for (index, (own, published)) in own.into_iter().zip(published).enumerate() {
        let difference = (own - published).abs();
        assert!(difference <= ALLOWED[0] * gauge.unknown(index, 0), "{own} {published}");
        // and in plain digits
        assert!(difference < 5e-16, "{own} {published}");
    }
}

/// At rest only what the crank's rod moves is accelerated: Hairer and Wanner's initial accelerations.
#[test]
fn andrews_start() {
    let start = Motion::from((0.0, 0.0, -10_666.832_939_965_585, 0.0, 0.0));
    let squeezer = AndrewsSqueezer::PUBLISHED;
    let pose = squeezer
        .solve(start, AndrewsSqueezer::PUBLISHED_ASSEMBLY)
        .expect("it closes");
    let gauge = Gauge::new(&squeezer, &[start], &pose.unknown_motions());
    let published = [14_222.443_919_954_114, 0.0, 0.0, 0.0, 0.0, 0.0];
    for (index, (own, published)) in pose.unknown_motions().into_iter().zip(published).enumerate() {
        assert_eq!(own.velocity(), 0.0);
        assert!(
            (own.acceleration() - published).abs() <= ALLOWED[2] * gauge.unknown(index, 2),
            "{}, {published}",
            own.acceleration()
        );
    }
}

/// The state after 0.03 s of F. Mazzia and C. Magherini's Test Set for Initial Value Problem Solvers, Bari 2008: given
/// the motion of theta to the acceleration, those of the other angles follow.
#[test]
fn andrews_after_integration() {
    let theta = Motion::from((
        -15.756_371_059_842_98,
        -1_424.379_294_994_111,
        51_850.377_016_103_29,
        0.0,
        0.0,
    ));
    // beta, gamma, phi, delta, omega, epsilon: value, velocity, acceleration
    let published: [[f64; 3]; 6] = [
        [15.810_771_196_299_04, 1_139.920_302_151_208, -24_631.763_166_951_96],
        [0.040_822_240_130_731_01, 11.032_912_219_371_34, 324_102.564_137_812_6],
        [-0.534_730_116_322_694_8, 19.293_374_644_213_85, 566_749.364_517_621_3],
        [0.524_409_965_880_530_4, 0.573_569_928_479_080_8, 16_743.629_294_793_61],
        [0.534_730_116_322_694_8, -19.293_374_644_213_85, -566_749.364_517_622_2],
        [1.048_080_741_042_263, 0.323_179_165_802_695_5, 9_826.520_791_458_422],
    ];
    let pose = AndrewsSqueezer::PUBLISHED
        .solve(theta, AndrewsSqueezer::PUBLISHED_ASSEMBLY)
        .expect("it closes");
    // the constraints hold for the published positions; velocities and accelerations are as good as the integration,
    // which did not impose the constraints on them
    let largest = |order: usize| published.iter().map(|state| state[order].abs()).fold(0.0, f64::max);
    let allowed = [0.0, 1e-10 * largest(1), 1e-6 * largest(2)];
    for (own, published) in pose.unknown_motions().into_iter().zip(published) {
        assert!(turned_back(own.value() - published[0]).abs() <= 8.0 * f64::EPSILON * published[0].abs());
        for order in [1, 2] {
            let difference = own.derivatives()[order] - published[order];
            assert!(difference.abs() <= allowed[order], "order {order}: {difference}");
        }
    }
}

/// The traced point stays on the line x = (arm² - side²) / (2 ground) at every order, in both assemblies that do so.
#[test]
fn peaucellier_is_straight() {
    let mut random = Random::new(41);
    let mirrored = PeaucellierLinkageAssembly {
        alpha_gamma: Assembly::Crossed,
        beta_delta: Assembly::Open,
        epsilon_zeta: Assembly::Crossed,
    };
    let mut count = 0;
    for _ in 0..samples::of(8) {
        // arm² - side² > 4 ground²: the tracer never meets the crank's pin
        let ground = random.between(1.8, 2.1);
        let linkage = PeaucellierLinkage {
            ground,
            crank: ground,
            arm: random.between(5.9, 6.1),
            side: random.between(3.9, 4.1),
        };
        let line = (linkage.arm * linkage.arm - linkage.side * linkage.side) / (2.0 * ground);
        for crank in cranks(-1.7, 1.7, 42) {
            for assembly in [PeaucellierLinkage::STRAIGHT, mirrored] {
                let pose = linkage.solve(crank, assembly).expect("it reaches");
                let links = [(linkage.arm, 0), (linkage.side, 4)];
                for (order, x) in pose.tracer.x().derivatives().into_iter().enumerate() {
                    let unit = point_unit(&linkage, [crank], &pose.unknown_motions(), &links, order);
                    let deviation = if order == 0 { x - line } else { x };
                    assert!(deviation.abs() <= unit, "order {order}: {deviation} beside {unit}");
                }
                // it moves on the line, and is the inverse of the crank's pin
                assert!(pose.tracer.y().velocity().abs() > 0.1 * crank.velocity().abs());
                let pin = ground * (2.0 + 2.0 * crank.value().cos()).sqrt();
                let tracer = pose.tracer.position().norm_squared().sqrt();
                let power = linkage.arm * linkage.arm - linkage.side * linkage.side;
                assert!((pin * tracer - power).abs() < 1e-11 * power);
                count += 1;
            }
        }
    }
    assert!(8 * count > 500 * samples::of(8), "{count}");
}

/// The pen's motion is the tracer's, enlarged, at every order.
#[test]
fn pantograph_is_similar() {
    let mirrored = PantographAssembly {
        alpha_gamma: Assembly::Crossed,
        beta_delta: Assembly::Crossed,
    };
    let mut random = Random::new(43);
    for factor in [1.5, 2.5, 7.0] {
        let pantograph = Pantograph {
            upper: 2.0,
            lower: 1.5,
            factor,
        };
        for x in cranks(0.7, 2.3, 44) {
            let y = Motion::new(random.motion(0.8));
            for assembly in [Pantograph::SIMILAR, mirrored] {
                let pose = pantograph.solve(x, y, assembly).expect("it reaches");
                let links = [(factor * 2.0, 0), (factor * 1.5, 2)];
                for (pen, tracer) in [(pose.pen.x(), x), (pose.pen.y(), y)] {
                    for order in 0..5 {
                        let unit = point_unit(&pantograph, [x, y], &pose.unknown_motions(), &links, order);
                        let deviation = pen.derivatives()[order] - factor * tracer.derivatives()[order];
                        assert!(deviation.abs() <= unit, "order {order}: {deviation} beside {unit}");
                    }
                }
            }
        }
    }
}

fn chebyshev(angle: f64) -> Plane {
    ChebyshevLinkage::PUBLISHED
        .position(angle, Assembly::Crossed)
        .expect("it closes")
        .tracer
        .value()
}

fn hoeken(linkage: HoekenLinkage, angle: f64) -> Plane {
    linkage
        .position(angle, Assembly::Open)
        .expect("the crank turns fully")
        .tracer
        .value()
}

/// Three exact points, and less than 0.01 beside the line between them: 0.244 % of the stroke.
#[test]
fn chebyshev_line() {
    for (angle, x) in [(PI / 2.0, 0.0), (f64::atan2(4.0, 3.0), 2.0)] {
        let tracer = chebyshev(angle);
        assert!((tracer.x - x).abs() < 1e-14 && (tracer.y - 4.0).abs() < 1e-14);
    }
    // the right end is a limit position, at which a position is found to half of its digits
    let end = chebyshev(f64::atan2(3.0, 4.0) + 1e-12);
    assert!((end.x - 4.0).abs() < 1e-5 && (end.y - 4.0).abs() < 1e-5);

    let stroke = points((37..=90).map(f64::from), chebyshev);
    assert_printed(100.0 * extent(&stroke).y / 4.0, 0.244, 0.01);
}

/// Three exact points, the same departure, and one of Norton's rows of ratios.
#[test]
fn hoeken_line() {
    let linkage = HoekenLinkage::PUBLISHED;
    for (degrees, x) in [(90.0_f64, 4.0), (180.0, 2.0), (270.0, 0.0)] {
        let tracer = hoeken(linkage, degrees.to_radians());
        assert!((tracer.x - x).abs() < 2e-15 && (tracer.y - 4.0).abs() < 2e-15);
    }
    let stroke = points((900..=2700).map(|tenth| f64::from(tenth) / 10.0), |angle| {
        hoeken(linkage, angle)
    });
    assert_printed(100.0 * extent(&stroke).y / 4.0, 0.244, 0.001);

    let longer = HoekenLinkage {
        ground: 2.5,
        crank: 1.0,
        coupler: 3.25,
    };
    let line = points([110.0, 250.0].into_iter(), |angle| hoeken(longer, angle));
    assert_printed(extent(&line).x, 3.623, 0.001);
}

/// A point of Hoeken's curve lies on Chebyshev's: with the coupler's direction (c, s), both arms' lengths give a linear
/// equation for c and s, and their solution is a direction.
#[test]
fn hoeken_and_chebyshev_draw_one_curve() {
    for degrees in (0..360).step_by(7) {
        let p = hoeken(HoekenLinkage::PUBLISHED, f64::from(degrees).to_radians());
        // the two ends of the coupler: |p + (c, s)| = 5 and |p - (c, s) - (4, 0)| = 5, or the other way round
        let q = Plane::new(p.x - 4.0, p.y);
        let first = (24.0 - p.norm_squared()) / 2.0;
        let second = (q.norm_squared() - 24.0) / 2.0;
        let determinant = p.cross(q);
        let c = (first * q.y - p.y * second) / determinant;
        let s = (p.x * second - first * q.x) / determinant;
        assert!((c * c + s * s - 1.0).abs() < 1e-12, "at {degrees}°: {}", c * c + s * s);
    }
}

/// Three exact points, and the departures that its documentation gives.
#[test]
fn roberts_line() {
    for (arm, percent) in [(1.2_f64, 0.68), (2.0, 0.11)] {
        let linkage = RobertsLinkage { base: 1.0, arm };
        let at = |angle: f64| {
            linkage
                .position(angle, Assembly::Open)
                .expect("it closes")
                .tracer
                .value()
        };
        let right = (1.0 / arm).acos();
        let left = right + 2.0 * (0.5 / arm).asin();
        let middle = (0.5 / arm).acos();
        for (angle, x) in [(left, 0.0), (middle, 1.0), (right, 2.0)] {
            let tracer = at(angle);
            assert!((tracer.x - x).abs() < 1e-14 && tracer.y.abs() < 1e-14, "{tracer:?}");
        }
        let departure = (0..=1000)
            .map(|step| at(right + (left - right) * f64::from(step) / 1000.0).y.abs())
            .fold(0.0, f64::max);
        assert_printed(100.0 * departure / 2.0, percent, 0.01);
    }
}

/// The patent's coordinates, stride and straightness, and the step height of Klann's table.
#[test]
fn klann_step() {
    let leg = KlannLeg::PATENT;
    let foot = |angle: f64| {
        let foot = leg.position(angle, KlannLeg::WALKING).expect("it walks").foot.value();
        // from the crank's axle to the patent's origin
        Plane::new(foot.x + 1.599, foot.y + 0.75)
    };
    for (angle, x) in [(0.0, 1.0), (PI, 0.0)] {
        assert_printed(foot(angle).x, x, 0.001);
        assert_printed(foot(angle).y, 0.0, 0.001);
    }
    let straight = extent(&points((0..=180).map(f64::from), foot));
    assert_printed(100.0 * straight.y, 5.5, 0.1);
    let path = extent(&points((0..360).map(f64::from), foot));
    assert_printed(100.0 * path.y / path.x, 52.3, 0.1);
}

/// The leg turns fully, its triangles keep their sides, and the path has the figures of the documentation.
#[test]
fn jansen_step() {
    let leg = JansenLeg::HOLY_NUMBERS;
    let mut path = Vec::new();
    for step in 0..3600 {
        let angle = f64::from(step).to_radians() / 10.0;
        let position = leg.position(angle, JansenLeg::WALKING).expect("it walks");
        let link = |length: f64, angle: f64| Plane::new(length * angle.cos(), length * angle.sin());
        let pivot = Plane::new(-leg.a, -leg.l);
        let upper = pivot + link(leg.b, position.angle_b.value());
        let knee = pivot + link(leg.c, position.angle_c.value());
        let corner = knee + link(leg.g, position.angle_g.value());
        let outer = corner - link(leg.f, position.angle_f.value());
        let pin = link(leg.m, angle);
        let foot = position.foot.value();
        for (from, to, length) in [
            (pin, upper, leg.j),
            (pin, knee, leg.k),
            (pivot, outer, leg.d),
            (upper, outer, leg.e),
            (knee, foot, leg.i),
            (corner, foot, leg.h),
        ] {
            let distance = (to - from).norm_squared().sqrt();
            assert!((distance - length).abs() < 1e-12, "{distance} {length}");
        }
        // the foot is the lowest point
        assert!(foot.y < knee.y.min(corner.y).min(outer.y));
        path.push(foot);
    }
    assert_printed(extent(&path).x, 67.9, 0.1);
    assert_printed(extent(&path).y, 22.5, 0.1);
    let low = path.iter().map(|foot| foot.y).fold(f64::INFINITY, f64::min);
    path.retain(|foot| foot.y < low + 1.0);
    assert_printed(extent(&path).x, 57.4, 0.1);
    assert_printed(f64::from(u32::try_from(path.len()).expect("a few")) / 10.0, 155.0, 1.0);
}

/// The strokes take 180° and the angle of the pivots to either side, and the ram reverses between them.
#[test]
fn whitworth_time_ratio() {
    for ground in [0.02, 0.05, 0.08] {
        let press = WhitworthQuickReturn {
            ground,
            crank: 0.1,
            arm: 0.15,
            rod: 0.5,
        };
        let delta = (ground / press.crank).asin();
        let speed = |angle: f64| {
            press
                .solve(Motion::at_constant_speed(angle, 1.0), Assembly::Open)
                .expect("it turns")
                .ram
                .velocity()
        };
        for reversal in [-delta, PI + delta] {
            assert!(speed(reversal).abs() < 1e-15);
        }
        for step in 1..100 {
            let part = f64::from(step) / 100.0;
            assert!(speed(-delta + part * (PI + 2.0 * delta)) < 0.0);
            assert!(speed(PI + delta + part * (PI - 2.0 * delta)) > 0.0);
        }
    }
}

/// The yoke's motion by the rule of sines, for any motion of the crank.
#[test]
fn scotch_yoke_is_harmonic() {
    for gamma in [PI / 2.0, 1.0, 2.2] {
        let yoke = ScotchYoke { crank: 2.0, gamma };
        for crank in cranks(-PI, PI, 45) {
            let own = yoke.solve(crank).expect("it turns");
            let gauge = Gauge::new(&yoke, &[crank], &own.unknown_motions());
            let (sine, cosine) = crank.sin_cos();
            let expected = cosine.scale(2.0) - sine.scale(2.0 / gamma.tan());
            assert_agree("x", own.x, expected, false, &[(&gauge, 0)]);
        }
    }
}

/// Cartwright's line, and rods that do not turn with equal cranks at equal speed.
#[test]
fn geared_five_bars() {
    let mut linkage = GearedFiveBar {
        r1: 2.0,
        r2: 0.5,
        r3: 2.5,
        r4: 2.5,
        r5: 0.5,
        ratio: -1.0,
        phase: PI,
    };
    for crank in cranks(-PI, PI, 46) {
        for assembly in Assembly::BOTH {
            let pose = linkage.solve(crank, assembly).expect("it turns");
            for (order, x) in pose.tool.x().derivatives().into_iter().enumerate() {
                let unit = point_unit(&linkage, [crank], &pose.unknown_motions(), &[(2.5, 0), (0.5, 0)], order);
                let deviation = if order == 0 { x - 1.0 } else { x };
                assert!(deviation.abs() <= unit, "order {order}: {deviation} beside {unit}");
            }
        }
    }
    linkage.ratio = 1.0;
    linkage.phase = 0.0;
    for crank in cranks(-PI, PI, 47) {
        let pose = linkage.solve(crank, Assembly::Open).expect("it turns");
        let gauge = Gauge::new(&linkage, &[crank], &pose.unknown_motions());
        for (order, allowed) in ALLOWED.into_iter().enumerate().skip(1) {
            for (index, rod) in [pose.theta3, pose.theta4].into_iter().enumerate() {
                assert!(rod.derivatives()[order].abs() <= allowed * gauge.unknown(index, order));
            }
        }
    }
}

/// In mirror image the hand of a five-bar linkage moves in mirror image, for any motion of its cranks.
#[test]
fn five_bar_mirrors() {
    let robot = FiveBar {
        ground: 2.0,
        left: 1.5,
        left_rod: 2.0,
        right_rod: 1.8,
        right: 1.3,
    };
    let mirrored = FiveBar {
        ground: 2.0,
        left: 1.3,
        left_rod: 1.8,
        right_rod: 2.0,
        right: 1.5,
    };
    let half = Motion::constant(PI);
    for (alpha, beta) in cranks(1.2, 2.4, 48).into_iter().zip(cranks(0.7, 1.9, 49)) {
        let own = robot.solve(alpha, beta, Assembly::Open).expect("it reaches");
        let other = mirrored
            .solve(half - beta, half - alpha, Assembly::Open)
            .expect("so does its mirror image");
        let links = [(2.0, 0), (1.8, 1)];
        for order in 0..5 {
            let unit = point_unit(&robot, [alpha, beta], &own.unknown_motions(), &links, order);
            let (hand, image): (Path, Path) = (own.hand, other.hand);
            let across = hand.derivatives()[order].x + image.derivatives()[order].x;
            let along = hand.derivatives()[order].y - image.derivatives()[order].y;
            let across = if order == 0 { across - robot.ground } else { across };
            assert!(across.abs() <= 2.0 * unit && along.abs() <= 2.0 * unit, "order {order}");
        }
    }
}

/// Every mechanism whose crank turns fully keeps its assembly for the whole turn, with the input at every degree.
#[test]
fn full_turns() {
    fn turn<M: ThroughSnap>(mechanism: M, assembly: M::Assembly) {
        let mut last: Option<Vec<f64>> = None;
        for degrees in 0..=360 {
            let crank = f64::from(degrees).to_radians();
            let inputs = M::Inputs::from_fn(|_| Motion::at_constant_speed(crank, 1.0));
            let pose = mechanism.solve(inputs, assembly).expect("it turns");
            let unknowns: Vec<f64> = pose.unknown_motions().as_ref().iter().map(Motion::value).collect();
            assert_eq!(
                mechanism.assembly_at(M::Inputs::from_fn(|_| crank), M::Unknowns::from_fn(|i| unknowns[i])),
                assembly,
                "{} at {degrees}°",
                M::DESCRIPTION.name
            );
            // no jump: a degree changes no angle and no length by more than its own rate allows
            if let Some(last) = last {
                for ((own, before), motion) in unknowns.iter().zip(last).zip(pose.unknown_motions().as_ref()) {
                    let step = 1_f64.to_radians();
                    let allowed = step * (motion.velocity().abs() + step * motion.acceleration().abs() + 0.1);
                    let change = turned_back(own - before);
                    assert!(change.abs() <= allowed, "{} at {degrees}°", M::DESCRIPTION.name);
                }
            }
            last = Some(unknowns);
        }
    }
    turn(HoekenLinkage::PUBLISHED, Assembly::Open);
    turn(KlannLeg::PATENT, KlannLeg::WALKING);
    turn(JansenLeg::HOLY_NUMBERS, JansenLeg::WALKING);
    turn(AndrewsSqueezer::PUBLISHED, AndrewsSqueezer::PUBLISHED_ASSEMBLY);
    turn(ScotchYoke { crank: 1.0, gamma: 1.0 }, ());
    for assembly in WattII::ASSEMBLIES {
        let linkage = WattII {
            r1: 4.0,
            r2: 1.0,
            r3: 3.0,
            r4: 2.5,
            arm: Plane::new(1.5, 0.8),
            pivot: Plane::new(7.0, 0.5),
            r5: 3.0,
            r6: 2.5,
        };
        turn(linkage, assembly);
    }
}

/// How often a linkage, driven at another link by the motion that the crank gives to that link, gives the crank's motion
/// back, in well-conditioned poses.
#[derive(Default)]
struct DrivenBack(usize);

impl DrivenBack {
    /// `own` is the gauge of the pose that the drive is from: the drive is known to its condition squared, and what the
    /// drive is wrong by, the driven linkage makes larger in its own units.
    fn check<M: ThroughSnap>(&mut self, own: &Gauge, driven: &M, drive: Motion, expected: &[Motion]) {
        let inputs = M::Inputs::from_fn(|_| drive);
        let exact = M::Unknowns::from_fn(|index| expected[index]);
        let gauge = Gauge::new(driven, &inputs, &exact);
        if gauge.condition > 100.0 {
            return;
        }
        let name = M::DESCRIPTION.name;
        let near = M::Unknowns::from_fn(|index| expected[index].value() + 1e-3);
        let found = match driven.solve_near(inputs, near) {
            Ok(pose) => pose.unknown_motions(),
            Err(error) => panic!("{name}: {error}"),
        };
        for (index, (found, expected)) in found.as_ref().iter().zip(expected).enumerate() {
            for (order, allowed) in ALLOWED.into_iter().enumerate() {
                let difference = found.derivatives()[order] - expected.derivatives()[order];
                let difference = if order == 0 {
                    turned_back(difference)
                } else {
                    difference
                };
                let unit = gauge.unknown(index, order) * (1.0 + own.condition * own.condition);
                let unknown = M::DESCRIPTION.unknowns[index].name;
                assert!(
                    difference.abs() <= allowed * unit,
                    "{unknown} of {name}, order {order}: {difference} beside {unit}"
                );
            }
        }
        self.0 += 1;
    }
}

/// Watt's and Stephenson's linkages, driven at the crank, then at a link for which nothing closes by itself.
#[test]
fn six_bars_are_driven_back() {
    let dimensions = [4.0, 1.0, 3.0, 2.5];
    let mut counts = [(); 4].map(|()| DrivenBack::default());
    let [watt1, watt2, stephenson1, stephenson3] = &mut counts;
    for crank in cranks(-PI, PI, 50) {
        let first = [&dimensions[..], &[1.5, 0.8, 2.0, 1.5, 2.5, 2.0]].concat();
        let by_crank = WattI::from_parameters(core::array::from_fn(|index| first[index]));
        let driven = WattIByDyad::from_parameters(by_crank.parameters());
        for pose in WattI::ASSEMBLIES
            .into_iter()
            .filter_map(|a| by_crank.solve(crank, a).ok())
        {
            let own = Gauge::new(&by_crank, &[crank], &pose.unknown_motions());
            watt1.check(
                &own,
                &driven,
                pose.theta5,
                &[crank, pose.theta3, pose.theta4, pose.theta6],
            );
        }

        let second = [&dimensions[..], &[2.0, 1.0, 7.0, 0.5, 3.0, 2.5]].concat();
        let by_crank = WattII::from_parameters(core::array::from_fn(|index| second[index]));
        let driven = WattIIByCouplers::from_parameters(by_crank.parameters());
        for pose in WattII::ASSEMBLIES
            .into_iter()
            .filter_map(|a| by_crank.solve(crank, a).ok())
        {
            let own = Gauge::new(&by_crank, &[crank], &pose.unknown_motions());
            let drive = pose.theta5 - pose.theta3;
            watt2.check(&own, &driven, drive, &[crank, pose.theta3, pose.theta4, pose.theta6]);
        }

        let first = [&dimensions[..], &[0.5, 1.0, 1.5, 1.0, 2.5, 2.0]].concat();
        let by_crank = StephensonI::from_parameters(core::array::from_fn(|index| first[index]));
        let driven = StephensonIByDyad::from_parameters(by_crank.parameters());
        for pose in StephensonI::ASSEMBLIES
            .into_iter()
            .filter_map(|a| by_crank.solve(crank, a).ok())
        {
            let own = Gauge::new(&by_crank, &[crank], &pose.unknown_motions());
            stephenson1.check(
                &own,
                &driven,
                pose.theta5,
                &[crank, pose.theta3, pose.theta4, pose.theta6],
            );
        }

        let third = [&dimensions[..], &[1.5, 1.0, 3.0, 5.0, 3.0, 2.5]].concat();
        let by_crank = StephensonIII::from_parameters(core::array::from_fn(|index| third[index]));
        let driven = StephensonIIIByDyad::from_parameters(by_crank.parameters());
        for pose in StephensonIII::ASSEMBLIES
            .into_iter()
            .filter_map(|a| by_crank.solve(crank, a).ok())
        {
            let own = Gauge::new(&by_crank, &[crank], &pose.unknown_motions());
            stephenson3.check(
                &own,
                &driven,
                pose.theta6,
                &[crank, pose.theta3, pose.theta4, pose.theta5],
            );
        }
    }
    for (count, name) in counts
        .iter()
        .zip(["Watt I", "Watt II", "Stephenson I", "Stephenson III"])
    {
        println!("{name}: {} poses", count.0);
        assert!(count.0 > 100, "{name}: {}", count.0);
    }
}

/// Stephenson's linkage of the second kind, driven at the elbow in relative angles, then at the crank in absolute ones.
#[test]
fn stephenson_second_kind_is_driven_back() {
    let by_elbow = StephensonIIByElbow::from_parameters([4.0, 2.0, 1.5, 1.2, 3.0, 0.3, 1.0, 0.5, 1.6, 3.0]);
    let driven = StephensonII::from_parameters(by_elbow.parameters());
    let mut count = DrivenBack::default();
    for elbow in cranks(-PI, PI, 51) {
        for assembly in StephensonIIByElbow::ASSEMBLIES {
            let Ok(pose) = by_elbow.solve(elbow, assembly) else {
                continue;
            };
            let own = Gauge::new(&by_elbow, &[elbow], &pose.unknown_motions());
            let [link3, link4, link5] = [elbow, pose.alpha, pose.beta].map(|relative| pose.theta2 + relative);
            count.check(&own, &driven, pose.theta2, &[link3, link4, link5, pose.theta6]);
        }
    }
    assert!(count.0 > 50, "{}", count.0);
}

/// With equal legs an equilateral platform turns about the centre, l² = R² + ρ² - 2 R ρ cos phi; at l² = R² + ρ² both
/// sides agree at every order with the cosine's own expansion.
#[test]
fn triad_turns_about_its_centre() {
    let (outer, inner) = (2.0, 1.0);
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(outer * root, 0.0),
        base_c: Plane::new(outer * root / 2.0, outer * 1.5),
        platform_b: Plane::new(inner * root, 0.0),
        platform_c: Plane::new(inner * root / 2.0, inner * 1.5),
    };
    let mut random = Random::new(52);
    for _ in 0..60 {
        let angle = random.between(0.4, 2.6);
        let phi = Motion::new(random.motion(angle));
        // the motion of the legs that belongs to it, as a series in time
        let square: Motion =
            Motion::constant(outer * outer + inner * inner) - phi.sin_cos().1.scale(2.0 * outer * inner);
        let leg = root_of(square);
        let corner = Plane::new(-inner * root / 2.0, -inner / 2.0);
        let ends = [Plane::new(0.0, 0.0), triad.platform_b, triad.platform_c];
        let bases = [Plane::new(0.0, 0.0), triad.base_b, triad.base_c];
        let centre = Plane::new(outer * root / 2.0, outer / 2.0);
        let turned = Plane::new(phi.value().cos(), phi.value().sin());
        let angles: Vec<f64> = ends
            .iter()
            .zip(bases)
            .map(|(end, base)| centre + (corner + *end).times(turned) - base)
            .map(|along| along.y.atan2(along.x) + 1e-3)
            .collect();
        let near = Near([angles[0], angles[1], angles[2], phi.value() - 1e-3]);
        let pose = triad.solve(leg, leg, leg, near).expect("it is near");
        let gauge = Gauge::new(&triad, &[leg, leg, leg], &pose.unknown_motions());
        assert_agree("phi", pose.phi, phi, true, &[(&gauge, 3), (&gauge, 3)]);
        for (coordinate, value) in [(pose.centre.x(), centre.x), (pose.centre.y(), centre.y)] {
            for (order, own) in coordinate.derivatives().into_iter().enumerate() {
                let deviation = if order == 0 { own - value } else { own };
                let unit = leg.value() * gauge.unknown(0, order) + inner * gauge.unknown(3, order);
                assert!(
                    deviation.abs() <= ALLOWED[order] * unit,
                    "order {order}: {deviation} beside {unit}"
                );
            }
        }
    }
}

/// The square root of a motion: r r = s, differentiated by Leibniz's rule.
fn root_of(square: Motion) -> Motion {
    let [s, s1, s2, s3, s4] = square.derivatives();
    let r = s.sqrt();
    let r1 = s1 / (2.0 * r);
    let r2 = (s2 - 2.0 * r1 * r1) / (2.0 * r);
    let r3 = (s3 - 6.0 * r1 * r2) / (2.0 * r);
    let r4 = (s4 - 8.0 * r1 * r3 - 6.0 * r2 * r2) / (2.0 * r);
    Motion::from((r, r1, r2, r3, r4))
}

/// Whether one of the positions is that of given motions.
fn holds(positions: &[Near<4>], expected: [Motion; 4]) -> bool {
    positions.iter().any(|Near(position)| {
        position
            .iter()
            .zip(expected)
            .all(|(own, expected)| turned_back(own - expected.value()).abs() < 1e-6)
    })
}

/// Driven at a link for which nothing closes by itself, a linkage has the crank's position among all of its own.
#[test]
fn all_assemblies_hold_the_one_driven_by_the_crank() {
    let dimensions = [4.0, 1.0, 3.0, 2.5];
    let with = |extra: [f64; 6]| core::array::from_fn(|index| [&dimensions[..], &extra].concat()[index]);
    let watt1 = WattI::from_parameters(with([1.5, 0.8, 2.0, 1.5, 2.5, 2.0]));
    let watt2 = WattII::from_parameters(with([2.0, 1.0, 7.0, 0.5, 3.0, 2.5]));
    let stephenson1 = StephensonI::from_parameters(with([0.5, 1.0, 1.5, 1.0, 2.5, 2.0]));
    let stephenson2 = StephensonIIByElbow::from_parameters([4.0, 2.0, 1.5, 1.2, 3.0, 0.3, 1.0, 0.5, 1.6, 3.0]);
    let stephenson3 = StephensonIII::from_parameters(with([1.5, 1.0, 3.0, 5.0, 3.0, 2.5]));
    let mut count = 0;
    for crank in cranks(-PI, PI, 53).into_iter().step_by(5) {
        if let Ok(pose) = watt1.solve(crank, WattI::ASSEMBLIES[0]) {
            let driven = WattIByDyad::from_parameters(watt1.parameters());
            let all = driven.assemblies_at(pose.theta5.value()).expect("finite");
            assert!(holds(&all, [crank, pose.theta3, pose.theta4, pose.theta6]), "{all:?}");
            count += usize::from(all.is_complete());
        }
        if let Ok(pose) = watt2.solve(crank, WattII::ASSEMBLIES[0]) {
            let driven = WattIIByCouplers::from_parameters(watt2.parameters());
            let drive = pose.theta5.value() - pose.theta3.value();
            let all = driven.assemblies_at(drive).expect("finite");
            assert!(holds(&all, [crank, pose.theta3, pose.theta4, pose.theta6]), "{all:?}");
            count += usize::from(all.is_complete());
        }
        if let Ok(pose) = stephenson1.solve(crank, StephensonI::ASSEMBLIES[0]) {
            let driven = StephensonIByDyad::from_parameters(stephenson1.parameters());
            let all = driven.assemblies_at(pose.theta5.value()).expect("finite");
            assert!(holds(&all, [crank, pose.theta3, pose.theta4, pose.theta6]), "{all:?}");
            count += usize::from(all.is_complete());
        }
        if let Ok(pose) = stephenson2.solve(crank, StephensonIIByElbow::ASSEMBLIES[0]) {
            let driven = StephensonII::from_parameters(stephenson2.parameters());
            let all = driven.assemblies_at(pose.theta2.value()).expect("finite");
            let [link3, link4, link5] = [crank, pose.alpha, pose.beta].map(|relative| pose.theta2 + relative);
            assert!(holds(&all, [link3, link4, link5, pose.theta6]), "{all:?}");
            // what the crank leaves is a class III triad
            assert!(all.len() <= 6);
            count += usize::from(all.is_complete());
        }
        if let Ok(pose) = stephenson3.solve(crank, StephensonIII::ASSEMBLIES[0]) {
            let driven = StephensonIIIByDyad::from_parameters(stephenson3.parameters());
            let all = driven.assemblies_at(pose.theta6.value()).expect("finite");
            assert!(holds(&all, [crank, pose.theta3, pose.theta4, pose.theta5]), "{all:?}");
            assert!(all.len() <= 6);
            count += usize::from(all.is_complete());
        }
    }
    assert!(count > 40, "{count} complete");
}

/// Equal legs under an equilateral platform: both turns about the centre are among no more than six positions.
#[test]
fn all_positions_of_a_symmetric_platform() {
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    for phi in [0.7_f64, 1.3, 2.2] {
        let leg = (5.0 - 4.0 * phi.cos()).sqrt();
        let all = triad.assemblies_at(leg, leg, leg).expect("finite");
        assert!(all.is_complete(), "{all:?}");
        println!("{phi}: {} positions, {} singular", all.len(), all.singular());
        for turn in [phi, -phi] {
            assert!(
                all.iter()
                    .any(|Near(position)| turned_back(position[3] - turn).abs() < 1e-9),
                "{turn}: {all:?}"
            );
        }
        assert!(all.len() <= 6);
    }
}

/// Tracks the first input through a full turn from the middle of its range, from every position there is.
#[derive(Default)]
struct FullTurn {
    turned: Vec<&'static str>,
    limited: Vec<&'static str>,
    crossed: Vec<&'static str>,
    wrong: Vec<String>,
}

impl FullTurn {
    fn go<M: ThroughSnap>(&mut self, mechanism: &M, from: M::Inputs<f64>, start: M::Unknowns<f64>) {
        let name = M::DESCRIPTION.name;
        let mut to = from;
        to[0] += TAU;
        let assembly = mechanism.assembly_at(from, start);
        match track(mechanism, from, start, to) {
            Ok(end) => {
                self.turned.push(name);
                // the way back ends where it began, for coupled blocks too, whose assemblies may change places in a turn
                match track(mechanism, to, end, from) {
                    Ok(back) => self.compare::<M>("on the way back", start, back),
                    Err(error) => self.wrong.push(format!("{name}: back {error}")),
                }
                if M::ASSEMBLY_COUNT > 0 {
                    if mechanism.assembly_at(to, end) != assembly {
                        self.wrong.push(format!("{name}: {assembly:?} is left"));
                    }
                    self.compare::<M>("after a turn", start, end);
                }
            }
            Err(TrackError::TurningPoint(limit)) => {
                self.limited.push(name);
                let (low, high) = (from[0], to[0]);
                if !(low..=high).contains(&limit.inputs[0]) {
                    self.wrong.push(format!("{name}: {limit:?}"));
                }
            }
            Err(TrackError::ChangePoint(_)) => self.crossed.push(name),
            Err(error) => self.wrong.push(format!("{name}, {assembly:?}: {error}")),
        }
    }

    /// Compares two positions at inputs that are a full turn apart or equal.
    fn compare<M: ThroughSnap>(&mut self, place: &str, start: M::Unknowns<f64>, end: M::Unknowns<f64>) {
        let pairs = start.as_ref().iter().zip(end.as_ref()).zip(M::DESCRIPTION.unknowns);
        for ((start, end), quantity) in pairs {
            let is_angle = quantity.dimension == Dimension::Angle;
            let difference = if is_angle {
                turned_back(end - start)
            } else {
                end - start
            };
            if difference.abs() > 1e-9 * (1.0 + start.abs()) {
                let name = M::DESCRIPTION.name;
                self.wrong
                    .push(format!("{name}, {place}: {} is off by {difference}", quantity.name));
            }
        }
    }
}

impl Visitor for FullTurn {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        // a length does not turn
        if const { !matches!(M::DESCRIPTION.inputs[0].dimension, Dimension::Angle) } {
            return;
        }
        let mechanism: M = case.mechanism();
        let at = |fraction: f64| {
            M::Inputs::from_fn(|index| {
                let (low, high) = case.inputs[index];
                low + fraction * (high - low)
            })
        };
        let from = at(0.6);
        if M::ASSEMBLY_COUNT > 0 {
            for assembly in M::assemblies() {
                if let Ok(start) = mechanism.position(from, assembly) {
                    self.go(&mechanism, from, start);
                }
            }
            return;
        }
        let mut random = Random::new(54);
        for step in 0..40 {
            let from = at(f64::from(step % 8) / 8.0);
            let guess = M::Unknowns::from_fn(|_| random.between(-PI, PI));
            if let Ok(start) = mechanism.position_near(from, guess) {
                self.go(&mechanism, from, start);
            }
        }
    }
}

/// A crank is tracked through a full turn without leaving its assembly, or to a limit position on the way.
#[test]
fn every_input_is_tracked_through_a_turn() {
    let mut turn = FullTurn::default();
    cases::library(&mut turn);
    cases::coupled_library(&mut turn);
    println!(
        "turned: {:?}\n\nlimited: {:?}\n\nchange points: {:?}",
        turn.turned, turn.limited, turn.crossed
    );
    assert!(turn.wrong.is_empty(), "{:#?}", turn.wrong);
    for name in [
        "HoekenLinkage",
        "KlannLeg",
        "JansenLeg",
        "WhitworthQuickReturn",
        "AndrewsSqueezer",
        "Rssr",
    ] {
        assert!(turn.turned.contains(&name), "{name}");
    }
}

/// With a short crank Stephenson's linkage of the second kind turns fully, its class III triad solved by Newton's method all
/// the way round.
#[test]
fn a_coupled_six_bar_turns_fully() {
    let linkage = StephensonII {
        r1: 4.0,
        r2: 0.5,
        r3: 3.0,
        r4: 1.5,
        p: Plane::new(0.3, 0.4),
        q: Plane::new(0.8, 0.6),
        r5: 2.6,
        r6: 2.5,
    };
    let all = linkage.assemblies_at(0.3).expect("finite");
    assert!(all.is_complete() && !all.is_empty(), "{all:?}");
    for &Near(start) in &all {
        let mut near = start;
        let end = track(&linkage, [0.3], start, [0.3 + TAU]).expect("no limit is on the way");
        // the same position again, and small steps lead there as well
        for step in 1..=360 {
            let crank = 0.3 + f64::from(step).to_radians();
            near = linkage.position_near(crank, near).expect("it turns").unknowns();
        }
        for index in 0..4 {
            assert!((near[index] - end[index]).abs() < 1e-11, "{near:?} {end:?}");
            assert!(
                turned_back(end[index] - start[index]).abs() < 1e-11,
                "{end:?} {start:?}"
            );
        }
    }
}
