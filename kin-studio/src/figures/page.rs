//! The content of a page at a glance: a mechanism that moves, and its motion through snap over one revolution.

use std::error::Error;
use std::f64::consts::TAU;

use kin_core::prelude::*;
use kin_core::{Plane, RATES};

use super::Figure;
use crate::drawing::{Canvas, DRIVE, GREY, Keyframe, PATH, Scene, Style, moving};

/// The size of the whole.
const SIZE: Plane = Plane { x: 860.0, y: 410.0 };
/// The size of the mechanism's part.
const PICTURE: Plane = Plane { x: 470.0, y: 330.0 };
/// The plots: the corner of the first one, the size of each, and the distance from one to the next.
const CORNER: Plane = Plane { x: 590.0, y: 34.0 };
const PLOT: Plane = Plane { x: 240.0, y: 50.0 };
const STEP: f64 = 62.0;
/// The crank's position where nothing moves.
const CRANK: f64 = 65.0;
/// The time of a revolution.
const SECONDS: f64 = 6.0;

mechanism! {
    /// The program of the README.
    struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);

    output midpoint: Point = r2 * cis(theta2) + r3 / 2 * cis(theta3);
}

/// The first picture of the README.
pub(super) fn page() -> Result<Figure, Box<dyn Error>> {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 80.0,
        r4: 60.0,
    };
    let scene = Scene::of_mechanism(&linkage, [CRANK.to_radians()], Assembly::Open)?;
    let style = Style {
        width: PICTURE.x,
        height: PICTURE.y,
        title: String::new(),
        names: false,
    };
    let mut page = Canvas::default();
    let linkage_moves = moving(&scene, &style, SECONDS).ok_or("the crank does not go round")?;
    page.place(&linkage_moves, Plane::new(10.0, 20.0));
    plots(&mut page, &linkage)?;
    scrubber(&mut page, &linkage)?;
    Ok(Figure {
        file: "page.svg".to_owned(),
        svg: page.finish(SIZE.x, SIZE.y, "A four-bar linkage and its motion through snap"),
    })
}

/// The position of an angle of the crank along the axis of the plots.
fn along(crank: f64) -> f64 {
    CORNER.x + PLOT.x * crank / TAU
}

/// A part that goes with the crank from one end of its revolution to the other.
fn carry(page: &mut Canvas, name: &str, part: &Canvas, ends: [Plane; 2]) {
    let keyframe = |at| Keyframe { at, degrees: 0.0 };
    let start = CRANK / 360.0;
    page.motion(name, &ends.map(keyframe), SECONDS, start);
    page.follow(name, keyframe(ends[0] + (ends[1] - ends[0]).scale(start)), part);
}

/// Five plots below each other, each with coupler and rocker, and one cursor through all.
fn plots(page: &mut Canvas, linkage: &FourBar) -> Result<(), Box<dyn Error>> {
    let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 181).speed(10.0);
    let table = sweep.table()?;
    let cranks = table.column("theta2")?;
    let rates = RATES.map(|rate| (rate, format!("_{rate}")));
    let orders = std::iter::once(("position", String::new())).chain(rates);
    for ((name, rate), top) in orders.zip([0.0, 1.0, 2.0, 3.0, 4.0].map(|row| CORNER.y + STEP * row)) {
        let curves = [
            (table.column(&format!("theta3{rate}"))?, PATH),
            (table.column(&format!("theta4{rate}"))?, DRIVE),
        ];
        let all = || curves.iter().flat_map(|(values, _)| values.iter().copied());
        let (low, high) = (
            all().fold(f64::INFINITY, f64::min),
            all().fold(f64::NEG_INFINITY, f64::max),
        );
        let point =
            |crank: f64, value: f64| Plane::new(along(crank), top + PLOT.y * (1.0 - (value - low) / (high - low)));
        for quarter in [0.0, 0.25, 0.5, 0.75, 1.0] {
            page.line(point(quarter * TAU, low), point(quarter * TAU, high), "#dddddd", 0.8);
        }
        if low < 0.0 && high > 0.0 {
            page.line(point(0.0, 0.0), point(TAU, 0.0), "#bbbbbb", 0.8);
        }
        for (values, colour) in curves {
            let points: Vec<Plane> = cranks
                .iter()
                .zip(values)
                .map(|(crank, value)| point(*crank, *value))
                .collect();
            let style = format!(r#"fill="none" stroke="{colour}" stroke-width="1.6" stroke-linejoin="round""#);
            page.path(&points, false, &style);
        }
        page.text(
            Plane::new(CORNER.x - 10.0, top + 0.5 * PLOT.y + 4.0),
            11.0,
            "end",
            "",
            name,
        );
    }
    let height = 4.0 * STEP + PLOT.y + 6.0;
    let mut cursor = Canvas::default();
    cursor.line(Plane::new(0.0, 0.0), Plane::new(0.0, height), GREY, 1.0);
    let top = CORNER.y - 6.0;
    carry(
        page,
        "cursor",
        &cursor,
        [0.0, TAU].map(|crank| Plane::new(along(crank), top)),
    );
    for (text, colour, x) in [("θ₃", PATH, 0.0), ("θ₄", DRIVE, 26.0)] {
        let at = CORNER + Plane::new(PLOT.x - 44.0 + x, -14.0);
        page.text(at, 13.0, "start", &format!(r#"fill="{colour}""#), text);
    }
    Ok(())
}

/// The bar of the input, with a mark at the rocker's largest snap.
fn scrubber(page: &mut Canvas, linkage: &FourBar) -> Result<(), Box<dyn Error>> {
    let (left, right, height) = (30.0, SIZE.x - 30.0, SIZE.y - 42.0);
    let point = |crank: f64| Plane::new(left + (right - left) * crank / TAU, height);
    page.line(point(0.0), point(TAU), "#cccccc", 6.0);
    let mut knob = Canvas::default();
    let style = format!(r##"fill="#ffffff" stroke="{PATH}" stroke-width="2""##);
    knob.circle(Plane::new(0.0, 0.0), 8.0, &style);
    carry(page, "knob", &knob, [0.0, TAU].map(point));
    for quarter in 0..=4_u8 {
        let at = point(TAU * f64::from(quarter) / 4.0) + Plane::new(0.0, 26.0);
        page.text(at, 11.0, "middle", "", &format!("{}°", 90 * u16::from(quarter)));
    }
    let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 181).speed(10.0);
    let at = point(sweep.of("theta4_snap").peak()?.at);
    page.circle(at, 3.5, &format!(r#"fill="{DRIVE}" stroke="none""#));
    let above = at + Plane::new(-4.0, -12.0);
    page.text(
        above,
        11.0,
        "start",
        &format!(r#"fill="{DRIVE}""#),
        "largest snap of θ₄",
    );
    Ok(())
}
