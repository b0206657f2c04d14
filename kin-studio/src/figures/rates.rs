//! Jerk and snap of a four-bar linkage's rocker over a revolution of its crank.

use std::f64::consts::TAU;

use kin_core::library::FourBar;
use kin_core::prelude::*;

use super::Figure;
use crate::drawing::{Canvas, DRIVE, GREY, PATH};

/// The number of points of a curve.
const POINTS: u32 = 240;

/// The plot.
pub(super) fn jerk_and_snap() -> Result<Figure, SolveError> {
    let linkage: FourBar = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 80.0,
        r4: 60.0,
    };
    let (width, height) = (560.0, 300.0);
    let (left, right, top, bottom) = (52.0, width - 18.0, 26.0, height - 44.0);
    let mut curves = [Vec::new(), Vec::new()];
    for step in 0..=POINTS {
        let crank = TAU * f64::from(step) / f64::from(POINTS);
        let rocker = linkage
            .solve(Motion::at_constant_speed(crank, 1.0), Assembly::Open)?
            .theta4;
        for (curve, value) in curves.iter_mut().zip([rocker.jerk(), rocker.snap()]) {
            curve.push(Plane::new(crank, value));
        }
    }
    let most = curves
        .iter()
        .flatten()
        .fold(0.0_f64, |most, point| most.max(point.y.abs()))
        .ceil();
    let plotted = |point: Plane| {
        Plane::new(
            left + (right - left) * point.x / TAU,
            0.5 * (top + bottom) - 0.5 * (bottom - top) * point.y / most,
        )
    };
    let mut page = Canvas::default();
    for degrees in (0..=360).step_by(60) {
        let x = plotted(Plane::new(f64::from(degrees).to_radians(), 0.0)).x;
        page.line(Plane::new(x, top), Plane::new(x, bottom), "#dddddd", 0.8);
        page.text(Plane::new(x, bottom + 16.0), 11.0, "middle", "", &format!("{degrees}°"));
    }
    for part in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        let y = plotted(Plane::new(0.0, part * most)).y;
        let colour = if part == 0.0 { GREY } else { "#dddddd" };
        page.line(Plane::new(left, y), Plane::new(right, y), colour, 0.8);
        page.text(
            Plane::new(left - 8.0, y + 4.0),
            11.0,
            "end",
            "",
            &format!("{:.1}", part * most),
        );
    }
    for ((curve, colour), (name, dashes, row)) in curves.iter().zip([PATH, DRIVE]).zip([
        ("jerk of θ₄", "", 0.0),
        ("snap of θ₄", r#" stroke-dasharray="6 3""#, 1.0),
    ]) {
        let points: Vec<Plane> = curve.iter().map(|&point| plotted(point)).collect();
        let style = format!(r#"fill="none" stroke="{colour}" stroke-width="1.6"{dashes}"#);
        page.path(&points, false, &style);
        let key = Plane::new(right - 130.0, top + 12.0 + 18.0 * row);
        page.path(&[key, key + Plane::new(26.0, 0.0)], false, &style);
        page.text(key + Plane::new(32.0, 4.0), 12.0, "start", "", name);
    }
    let middle = Plane::new(0.5 * (left + right), height - 8.0);
    page.text(middle, 12.0, "middle", "", "θ₂, at the speed of 1 rad/s");
    Ok(Figure {
        file: "jerk-and-snap.svg".to_owned(),
        svg: page.finish(
            width,
            height,
            "Jerk and snap of a rocker over a revolution of the crank",
        ),
    })
}
