//! Curves that points of linkages draw: straight lines, similar figures, steps.

use core::f64::consts::PI;

use kin_core::library::*;
use kin_core::prelude::*;
use kin_tests::random::Random;
use kin_tests::samples;

use super::{assert_printed, cranks, extent, point_unit, points};

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
fn hoeken_draws_as_chebyshev() {
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
