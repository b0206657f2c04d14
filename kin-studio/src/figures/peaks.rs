//! The rocker's acceleration over a revolution of the crank, with its extremes.

use std::error::Error;
use std::f64::consts::TAU;

use kin_core::Plane;
use kin_core::library::FourBar;
use kin_core::prelude::*;

use super::Figure;
use crate::drawing::{Canvas, DRIVE, GREY, PATH};

/// The plot, and the space around it.
const PLOT: Plane = Plane { x: 520.0, y: 200.0 };
const CORNER: Plane = Plane { x: 60.0, y: 34.0 };
/// The ends of the axis of the acceleration.
const HIGHEST: f64 = 125.0;
const LOWEST: f64 = -75.0;

pub(super) fn peaks() -> Result<Figure, Box<dyn Error>> {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 70.0,
        r4: 60.0,
    };
    let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 13).speed(10.0);
    let table = sweep.adaptive_table(1e-3, 2, 1000)?;
    let point = |at: f64, value: f64| {
        let height = (value - LOWEST) / (HIGHEST - LOWEST);
        CORNER + Plane::new(PLOT.x * at / TAU, PLOT.y * (1.0 - height))
    };
    let mut page = Canvas::default();
    page.text(
        CORNER + Plane::new(0.0, -14.0),
        12.0,
        "start",
        "",
        "acceleration of the rocker, in rad/s²",
    );
    for quarter in 0..=4_u8 {
        let at = TAU * f64::from(quarter) / 4.0;
        page.line(point(at, LOWEST), point(at, HIGHEST), "#dddddd", 0.8);
        let below = point(at, LOWEST) + Plane::new(0.0, 16.0);
        page.text(below, 11.0, "middle", "", &format!("{}°", 90 * u16::from(quarter)));
    }
    for step in -3..=5_i8 {
        let value = 25.0 * f64::from(step);
        let colour = if step == 0 { GREY } else { "#dddddd" };
        page.line(point(0.0, value), point(TAU, value), colour, 0.8);
        let beside = point(0.0, value) + Plane::new(-6.0, 4.0);
        page.text(beside, 11.0, "end", "", &format!("{value}").replace('-', "−"));
    }
    let (angles, values) = (table.column("theta2")?, table.column("theta4_acceleration")?);
    let points: Vec<Plane> = angles
        .iter()
        .zip(values)
        .map(|(at, value)| point(*at, *value))
        .collect();
    page.path(
        &points,
        false,
        &format!(r#"fill="none" stroke="{PATH}" stroke-width="1.6""#),
    );
    for extreme in sweep.of("theta4_acceleration").extremes()? {
        let Some(value) = extreme.value else { continue };
        let at = point(extreme.at, value);
        for (one, other) in [((-4.0, 0.0), (4.0, 0.0)), ((0.0, -4.0), (0.0, 4.0))] {
            page.line(
                at + Plane::new(one.0, one.1),
                at + Plane::new(other.0, other.1),
                DRIVE,
                1.6,
            );
        }
        let text = format!("{value:.4} at {:.4}°", extreme.at.to_degrees()).replace('-', "−");
        let above = if extreme.is_maximum { -10.0 } else { 20.0 };
        let anchor = if extreme.at < 0.5 { "start" } else { "middle" };
        page.text(at + Plane::new(0.0, above), 11.0, anchor, "", &text);
    }
    Ok(Figure {
        file: "peaks.svg".to_owned(),
        svg: page.finish(
            PLOT.x + CORNER.x + 30.0,
            PLOT.y + CORNER.y + 30.0,
            "The acceleration of a rocker over a revolution of the crank, with its four extremes",
        ),
    })
}
