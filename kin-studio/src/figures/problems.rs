//! Published problems: the paths of the linkages of the literature, and of linkages that a search found.

use std::f64::consts::{PI, TAU};

use kin_core::library::{FourBar, HoekenLinkage, JansenLeg};
use kin_core::prelude::*;

use super::Figure;
use crate::drawing::{Canvas, DRIVE, GREY, PATH};

/// A four-bar linkage with a point of its coupler, rotated and moved.
struct Traced {
    linkage: FourBar,
    point: Plane,
    rotation: f64,
    pivot: Plane,
    assembly: Assembly,
}

impl Traced {
    fn at(&self, angle: f64) -> Result<Plane, SolveError> {
        let pose = self.linkage.position(angle, self.assembly)?;
        let theta3 = Plane::polar(1.0, pose.theta3.value());
        let tracer = Plane::polar(self.linkage.r2, angle) + times(self.point, theta3);
        Ok(self.pivot + times(tracer, Plane::polar(1.0, self.rotation)))
    }
}

/// A vector rotated by the angle of a unit vector.
fn times(one: Plane, other: Plane) -> Plane {
    Plane::new(one.x * other.x - one.y * other.y, one.x * other.y + one.y * other.x)
}

/// A path over a revolution of the crank, along and above the chord of the half revolution that starts at an angle, in
/// shares of the chord.
fn shares(start: f64, at: impl Fn(f64) -> Result<Plane, SolveError>) -> Result<Vec<Plane>, SolveError> {
    let from = at(start)?;
    let way = at(start + PI)? - from;
    let chord = way.norm();
    let back = Plane::new(way.x / chord, -way.y / chord);
    let mut path = Vec::new();
    for step in 0..=720 {
        let point = at(start + TAU * f64::from(step) / 720.0)? - from;
        path.push(times(point, back).scale(1.0 / chord));
    }
    // the foot returns above the line
    let mean: f64 = path[360..].iter().map(|point| point.y).sum();
    if mean < 0.0 {
        for point in &mut path {
            point.y = -point.y;
        }
    }
    Ok(path)
}

/// One path with its name and colour.
type Curve<'a> = (&'a str, &'a str, Vec<Plane>);

/// The width of a panel, and the height of one for whole paths and of one for magnified lines.
const WIDTH: f64 = 330.0;
const WHOLE: f64 = 190.0;
const LINE: f64 = 120.0;

/// Whole paths at the left, and their half revolutions with the heights magnified at the right.
fn flat(file: &str, title: &str, curves: &[Curve<'_>], magnified: f64, unit: f64) -> Figure {
    let mut page = Canvas::default();
    let (left, ground) = (40.0, 40.0 + WHOLE);
    let scale = WIDTH * 0.7;
    let base = Plane::new(left + 0.15 * WIDTH, ground);
    page.line(
        Plane::new(left, ground),
        Plane::new(left + WIDTH, ground),
        "#dddddd",
        0.8,
    );
    for (_, colour, path) in curves {
        let points: Vec<Plane> = path
            .iter()
            .map(|at| base + Plane::new(scale * at.x, -scale * at.y))
            .collect();
        page.path(
            &points,
            false,
            &format!(r#"fill="none" stroke="{colour}" stroke-width="1.6""#),
        );
    }
    let right = left + WIDTH + 60.0;
    let middle = 40.0 + 0.5 * WHOLE;
    for multiple in -2..=2 {
        let height = middle - f64::from(multiple) * LINE / 4.0;
        let colour = if multiple == 0 { GREY } else { "#dddddd" };
        page.line(
            Plane::new(right, height),
            Plane::new(right + WIDTH, height),
            colour,
            0.8,
        );
        let text = format!("{:.2} %", 100.0 * unit * f64::from(multiple)).replace('-', "−");
        page.text(Plane::new(right - 6.0, height + 4.0), 10.0, "end", "", &text);
    }
    for (_, colour, path) in curves {
        let points: Vec<Plane> = path[..=360]
            .iter()
            .map(|at| Plane::new(right + WIDTH * at.x, middle - at.y * magnified))
            .collect();
        page.path(
            &points,
            false,
            &format!(r#"fill="none" stroke="{colour}" stroke-width="1.6""#),
        );
    }
    for ((name, colour, _), index) in curves.iter().zip([0.0, 1.0, 2.0]) {
        let at = Plane::new(left + 225.0 * index, ground + 34.0);
        page.line(at, at + Plane::new(18.0, 0.0), colour, 2.0);
        page.text(at + Plane::new(24.0, 4.0), 11.0, "start", "", name);
    }
    page.text(
        Plane::new(right + 0.5 * WIDTH, ground + 2.0),
        11.0,
        "middle",
        "",
        "the half revolution, heights in per cent of its length",
    );
    Figure {
        file: file.to_owned(),
        svg: page.finish(right + WIDTH + 24.0, ground + 52.0, title),
    }
}

const FIRST: &str = GREY;
const SECOND: &str = DRIVE;
const THIRD: &str = PATH;

/// Hoeken's linkage with the proportions of Norton's table, and straighter ones.
pub(super) fn straight_lines() -> Result<Figure, SolveError> {
    let hoeken = HoekenLinkage {
        ground: 2.2,
        crank: 1.0,
        coupler: 2.8,
    };
    let straightest = symmetrical(1.916_729, 3.160_500, 5.646_992, -1.950_927);
    let most_even = symmetrical(1.674_893, 2.851_746, 4.793_844, -2.088_232);
    let start = 0.5 * PI;
    let curves = [
        (
            "Hoeken, 2.2 : 1 : 2.8",
            FIRST,
            shares(start, |angle| {
                Ok(hoeken.position(angle, Assembly::Open)?.tracer.value())
            })?,
        ),
        (
            "straightest found",
            SECOND,
            shares(start, |angle| straightest.at(angle))?,
        ),
        (
            "straightest at 9.3 % unevenness",
            THIRD,
            shares(start, |angle| most_even.at(angle))?,
        ),
    ];
    let unit = 0.0014;
    Ok(flat(
        "straight-lines.svg",
        "The paths of Hoeken's linkage and of two that a search found, and their straight parts magnified",
        &curves,
        LINE / 4.0 / unit,
        unit,
    ))
}

/// A linkage whose coupler and rocker are equal, with a crank of 1.
fn symmetrical(r1: f64, equal: f64, along: f64, beside: f64) -> Traced {
    Traced {
        linkage: FourBar {
            r1,
            r2: 1.0,
            r3: equal,
            r4: equal,
        },
        point: Plane::new(along, beside),
        rotation: 0.0,
        pivot: Plane::new(0.0, 0.0),
        assembly: Assembly::Open,
    }
}

/// The foot of Jansen's leg with his dimensions and with others nearby.
pub(super) fn flat_steps() -> Result<Figure, SolveError> {
    let better = JansenLeg {
        a: 34.2053,
        b: 43.3853,
        c: 35.9160,
        d: 42.4771,
        e: 50.2203,
        f: 43.3400,
        g: 40.3699,
        h: 59.1300,
        i: 53.8999,
        j: 54.9991,
        k: 56.2979,
        l: 7.2986,
        m: 13.5000,
    };
    let foot = |leg: JansenLeg| move |angle: f64| Ok(leg.position(angle, JansenLeg::WALKING)?.foot.value());
    let curves = [
        (
            "Jansen's holy numbers",
            FIRST,
            shares(275.4_f64.to_radians(), foot(JansenLeg::HOLY_NUMBERS))?,
        ),
        (
            "found within 10 % of them",
            SECOND,
            shares(273.2_f64.to_radians(), foot(better))?,
        ),
    ];
    let unit = 0.014;
    Ok(flat(
        "flat-steps.svg",
        "The foot of Jansen's leg with his dimensions and with those of a search, and their steps magnified",
        &curves,
        LINE / 4.0 / unit,
        unit,
    ))
}

/// Eighteen points, with the path of the literature and that of the search.
pub(super) fn eighteen_points() -> Result<Figure, SolveError> {
    let literature = Traced {
        linkage: FourBar {
            r1: 3.057_878,
            r2: 0.237_803,
            r3: 4.828_954,
            r4: 2.056_456,
        },
        point: Plane::new(0.767_038, 1.850_828),
        rotation: 1.002_168,
        pivot: Plane::new(1.776_808, -0.641_991),
        assembly: Assembly::Open,
    };
    let found = Traced {
        linkage: FourBar {
            r1: 0.777_634,
            r2: 0.312_749,
            r3: 0.441_900,
            r4: 0.674_563,
        },
        point: Plane::new(-0.040_786, -0.354_563),
        rotation: -0.348_723,
        pivot: Plane::new(0.548_309, 0.716_512),
        assembly: Assembly::Crossed,
    };
    let points = [
        (0.5, 1.1),
        (0.4, 1.1),
        (0.3, 1.1),
        (0.2, 1.0),
        (0.1, 0.9),
        (0.05, 0.75),
        (0.02, 0.6),
        (0.0, 0.5),
        (0.0, 0.4),
        (0.03, 0.3),
        (0.1, 0.25),
        (0.15, 0.2),
        (0.2, 0.3),
        (0.3, 0.4),
        (0.4, 0.5),
        (0.5, 0.7),
        (0.6, 0.9),
        (0.6, 1.0),
    ];
    let mut page = Canvas::default();
    let scale = 260.0;
    for (column, title, linkage, first) in [
        (0.0, "Cabrera, Simon, Prado 2002: 0.0337", literature, 0.226_186),
        (1.0, "found: 0.0090", found, 0.891_556),
    ] {
        let corner = Plane::new(60.0 + 300.0 * column, 360.0);
        let point = |at: Plane| corner + Plane::new(scale * at.x, -scale * at.y);
        let mut path = Vec::new();
        for step in 0..=720 {
            path.push(point(linkage.at(TAU * f64::from(step) / 720.0)?));
        }
        page.path(
            &path,
            true,
            &format!(r#"fill="none" stroke="{PATH}" stroke-width="1.6""#),
        );
        for (index, (x, y)) in (0_u8..).zip(points) {
            let target = point(Plane::new(x, y));
            let reached = point(linkage.at(first + f64::from(index) * PI / 9.0)?);
            page.line(target, reached, DRIVE, 1.2);
            page.circle(
                target,
                3.0,
                &format!(r##"fill="#ffffff" stroke="{GREY}" stroke-width="1.2""##),
            );
            page.circle(reached, 1.8, &format!(r#"fill="{DRIVE}""#));
        }
        page.text(corner + Plane::new(0.3 * scale, 24.0), 12.0, "middle", "", title);
    }
    Ok(Figure {
        file: "eighteen-points.svg".to_owned(),
        svg: page.finish(
            580.0,
            400.0,
            "Eighteen points, with the tracer of the literature's linkage and of the one that a search found at the \
             same times",
        ),
    })
}
