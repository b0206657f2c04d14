//! The Jansen leg with its step, and the height and speed of its foot over a revolution of the crank.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use kin_core::cycle::FullCycle as _;
use kin_core::library::JansenLeg;
use kin_core::prelude::*;
use kin_core::sweep::{StraightLine, Sweep, Table};

use super::Figure;
use crate::drawing::{Canvas, DRIVE, GREY, Note, PATH, Scene, Style, canvas};

/// The drawing of the leg.
const DRAWING: Plane = Plane { x: 360.0, y: 420.0 };
/// A plot, and the upper left corners of both.
const PLOT: Plane = Plane { x: 400.0, y: 150.0 };
const CORNERS: [Plane; 2] = [Plane { x: 420.0, y: 34.0 }, Plane { x: 420.0, y: 232.0 }];
/// The foot stands on the ground within 1 mm of its lowest position.
const CONTACT: f64 = 1.0;

type LegSweep = Sweep<JansenLeg, StraightLine>;

/// A plot over a revolution of the crank.
struct Plot<'a> {
    corner: Plane,
    title: &'a str,
    column: &'a str,
    low: f64,
    high: f64,
    step: f64,
}

impl Plot<'_> {
    fn point(&self, at: f64, value: f64) -> Plane {
        let height = (value - self.low) / (self.high - self.low);
        self.corner + Plane::new(PLOT.x * (at - PI) / TAU, PLOT.y * (1.0 - height))
    }

    fn draw(
        &self,
        page: &mut Canvas,
        sweep: &LegSweep,
        table: &Table,
        contact: [f64; 2],
    ) -> Result<(), Box<dyn Error>> {
        page.text(self.corner + Plane::new(0.0, -12.0), 12.0, "start", "", self.title);
        let [from, to] = contact;
        let corners = [(from, self.low), (to, self.low), (to, self.high), (from, self.high)];
        let band = corners.map(|(at, value)| self.point(at, value));
        page.path(&band, true, r##"fill="#eef3f7" stroke="none""##);
        for (quarter, text) in (2_u8..).zip(["180°", "270°", "0", "90°", "180°"]) {
            let at = TAU * f64::from(quarter) / 4.0;
            page.line(self.point(at, self.low), self.point(at, self.high), "#dddddd", 0.8);
            page.text(
                self.point(at, self.low) + Plane::new(0.0, 16.0),
                11.0,
                "middle",
                "",
                text,
            );
        }
        let mut value = self.low;
        while value <= self.high {
            let colour = if value == 0.0 { GREY } else { "#dddddd" };
            page.line(self.point(PI, value), self.point(3.0 * PI, value), colour, 0.8);
            let text = format!("{value}").replace('-', "−");
            page.text(self.point(PI, value) + Plane::new(-6.0, 4.0), 11.0, "end", "", &text);
            value += self.step;
        }
        let pairs = table.column("theta")?.iter().zip(table.column(self.column)?);
        let points: Vec<Plane> = pairs.map(|(at, value)| self.point(*at, *value)).collect();
        page.path(
            &points,
            false,
            &format!(r#"fill="none" stroke="{PATH}" stroke-width="1.6""#),
        );
        for extreme in sweep.of(self.column).extremes()? {
            let Some(value) = extreme.value else { continue };
            let at = self.point(extreme.at, value);
            for arm in [Plane::new(4.0, 0.0), Plane::new(0.0, 4.0)] {
                page.line(at - arm, at + arm, DRIVE, 1.6);
            }
        }
        Ok(())
    }
}

pub(super) fn walking() -> Result<Figure, Box<dyn Error>> {
    let leg = JansenLeg::HOLY_NUMBERS;
    // half a revolution before and behind the step
    let sweep = leg.sweep(JansenLeg::WALKING).over(PI..=3.0 * PI, 25).speed(rpm(60.0));
    let table = sweep.adaptive_table(1e-3, 1, 1000)?;
    let cycle = leg.cycle()?;
    let walking = cycle.branches_of(JansenLeg::WALKING).next();
    let circuit = walking.ok_or("the leg does not walk")?.1.circuit();
    let ground = cycle.along(circuit).of("foot.y").stroke()?.low;
    let dwells = sweep.of("foot.y").dwells(ground.value + 0.5 * CONTACT, 0.5 * CONTACT)?;
    let contact = dwells.first().ok_or("the foot does not stand")?;

    let positions = [contact.from, contact.to].map(|at| leg.position(at, JansenLeg::WALKING));
    let mut ends = Vec::new();
    for position in positions {
        let foot = position?.foot.value();
        ends.push(Space::new(foot.x, ground.value, 0.0));
    }
    let scene = Scene::of_mechanism(&leg, [contact.from.rem_euclid(TAU)], JansenLeg::WALKING)?.with(Note::Dashes {
        from: ends[0],
        to: ends[1],
    });
    let style = Style {
        width: DRAWING.x,
        height: DRAWING.y,
        title: String::new(),
        names: false,
    };
    let mut page = Canvas::default();
    page.place(&canvas(&scene, &style), Plane::new(0.0, 0.0));
    let plots = [
        Plot {
            corner: CORNERS[0],
            title: "height of the foot, in mm",
            column: "foot.y",
            low: -95.0,
            high: -65.0,
            step: 5.0,
        },
        Plot {
            corner: CORNERS[1],
            title: "speed of the foot at 60 rev/min, in mm/s",
            column: "foot.x_velocity",
            low: -400.0,
            high: 200.0,
            step: 100.0,
        },
    ];
    for plot in plots {
        plot.draw(&mut page, &sweep, &table, [contact.from, contact.to])?;
    }
    let below = CORNERS[1] + Plane::new(0.5 * PLOT.x, PLOT.y + 32.0);
    page.text(below, 11.0, "middle", "", "crank; on the ground where shaded");
    Ok(Figure {
        file: "jansen-leg.svg".to_owned(),
        svg: page.finish(
            CORNERS[1].x + PLOT.x + 26.0,
            DRAWING.y + 10.0,
            "The Jansen leg, and the height and the horizontal speed of its foot over a revolution of the crank",
        ),
    })
}
