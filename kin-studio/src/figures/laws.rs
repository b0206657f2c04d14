//! The motion laws beside each other: displacement through snap of a rise.

use kin_core::Plane;
use kin_core::law::{LawError, Piecewise as _, Rise, Shape};

use super::Figure;
use crate::drawing::{Canvas, GREY};

/// The laws with their colours, of Okabe's and Ito's palette.
const LAWS: [(&str, Shape, &str, &str); 6] = [
    ("3-4-5", Shape::Polynomial345, "#0072B2", ""),
    ("4-5-6-7", Shape::Polynomial4567, "#D55E00", ""),
    ("5-6-7-8-9", Shape::Polynomial56789, "#009E73", ""),
    ("cycloidal", Shape::Cycloidal, "#222222", r#" stroke-dasharray="5 3""#),
    ("modified sine", Shape::ModifiedSine, "#CC79A7", ""),
    ("modified trapezoid", Shape::ModifiedTrapezoid, "#E69F00", ""),
];

/// The orders with the unit of each, and the ends and the step of its axis.
const ORDERS: [(&str, [f64; 3]); 5] = [
    ("displacement s, in h", [0.0, 1.0, 0.5]),
    ("velocity, in h/T", [0.0, 2.5, 0.5]),
    ("acceleration, in h/T²", [-10.0, 10.0, 5.0]),
    ("jerk, in h/T³", [-80.0, 80.0, 40.0]),
    ("snap, in h/T⁴", [-1000.0, 1000.0, 500.0]),
];

/// The number of steps of each piece of a curve.
const STEPS: u32 = 80;

/// The size of one plot, and the space around it.
const PLOT: Plane = Plane { x: 200.0, y: 150.0 };
const SPACE: Plane = Plane { x: 58.0, y: 54.0 };

/// All pieces of a curve, joined by upright lines where the derivative jumps, with rest on both sides.
fn curve(rise: &Rise, order: usize) -> Vec<Plane> {
    let mut points = vec![Plane::new(0.0, 0.0)];
    let mut start = 0.0;
    for piece in 0..rise.pieces() {
        let end = rise.end(piece);
        if end > start {
            for step in 0..=STEPS {
                let time = start + (end - start) * f64::from(step) / f64::from(STEPS);
                let mut derivatives = [0.0; ORDERS.len()];
                rise.write(piece, time, &mut derivatives);
                points.push(Plane::new(time, derivatives[order]));
            }
            start = end;
        }
    }
    points.push(Plane::new(1.0, if order == 0 { 1.0 } else { 0.0 }));
    points
}

/// One plot, its upper left corner at the origin.
fn plot(order: usize) -> Result<Canvas, LawError> {
    let (title, [low, high, step]) = ORDERS[order];
    let point = |point: Plane| {
        let height = (point.y - low) / (high - low);
        Plane::new(PLOT.x * point.x, PLOT.y * (1.0 - height))
    };
    let mut page = Canvas::default();
    page.text(Plane::new(0.0, -10.0), 12.0, "start", "", title);
    for quarter in 0..=4_u8 {
        let part = f64::from(quarter) / 4.0;
        let x = PLOT.x * part;
        page.line(Plane::new(x, 0.0), Plane::new(x, PLOT.y), "#dddddd", 0.8);
        if quarter % 2 == 0 {
            let at = Plane::new(x, PLOT.y + 15.0);
            page.text(at, 11.0, "middle", "", ["0", "", "½ T", "", "T"][usize::from(quarter)]);
        }
    }
    let mut value = low;
    while value <= high {
        let y = point(Plane::new(0.0, value)).y;
        let colour = if value == 0.0 { GREY } else { "#dddddd" };
        page.line(Plane::new(0.0, y), Plane::new(PLOT.x, y), colour, 0.8);
        let shown = format!("{value}").replace('-', "−");
        page.text(Plane::new(-6.0, y + 4.0), 11.0, "end", "", &shown);
        value += step;
    }
    for (_, shape, colour, dashes) in LAWS {
        let rise = Rise::new(shape, 0.0, 1.0, 1.0)?;
        let points: Vec<Plane> = curve(&rise, order).into_iter().map(point).collect();
        let style = format!(r#"fill="none" stroke="{colour}" stroke-width="1.4" stroke-linejoin="round"{dashes}"#);
        page.path(&points, false, &style);
    }
    Ok(page)
}

/// The names of the laws beside their colours.
fn key() -> Canvas {
    let mut page = Canvas::default();
    for (row, (name, _, colour, dashes)) in (0_u8..).zip(LAWS) {
        let at = Plane::new(0.0, 6.0 + 24.0 * f64::from(row));
        let style = format!(r#"fill="none" stroke="{colour}" stroke-width="2"{dashes}"#);
        page.path(&[at, at + Plane::new(30.0, 0.0)], false, &style);
        page.text(at + Plane::new(40.0, 4.0), 12.0, "start", "", name);
    }
    page
}

/// Five plots and their key, in two rows.
pub(super) fn motion_laws() -> Result<Figure, LawError> {
    let mut page = Canvas::default();
    let corner = |index: u8| {
        let (column, row) = (f64::from(index % 3), f64::from(index / 3));
        Plane::new(
            SPACE.x - 10.0 + column * (PLOT.x + SPACE.x),
            34.0 + row * (PLOT.y + SPACE.y),
        )
    };
    for (index, order) in (0_u8..).zip(0..ORDERS.len()) {
        page.place(&plot(order)?, corner(index));
    }
    page.place(&key(), corner(5) + Plane::new(0.0, 4.0));
    let width = 3.0 * (PLOT.x + SPACE.x) + 6.0;
    let height = 2.0 * (PLOT.y + SPACE.y) + 16.0;
    Ok(Figure {
        file: "motion-laws.svg".to_owned(),
        svg: page.finish(
            width,
            height,
            "Displacement, velocity, acceleration, jerk and snap of six motion laws",
        ),
    })
}
