//! The map of circuits: the rocker's angle over the crank's, for two four-bars.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use kin_core::LimitKind;
use kin_core::Plane;
use kin_core::cycle::{Cycle, FullCycle as _};
use kin_core::library::FourBar;

use super::Figure;
use crate::drawing::{Canvas, GREY};

/// The size of a map, and the space around it.
const MAP: Plane = Plane { x: 300.0, y: 300.0 };
const SPACE: Plane = Plane { x: 70.0, y: 64.0 };
/// The colours of branches, of Okabe's and Ito's palette.
const COLOURS: [&str; 4] = ["#0072B2", "#D55E00", "#009E73", "#CC79A7"];
/// The number of steps of each branch.
const STEPS: u32 = 240;

/// One map, its upper left corner at the origin. The crank's angle runs from -180 to 180 degrees, the rocker's from 0
/// to 360.
fn map(cycle: &Cycle<FourBar>, title: &str) -> Canvas {
    let point =
        |crank: f64, rocker: f64| Plane::new(MAP.x * (crank + PI) / TAU, MAP.y * (1.0 - rocker.rem_euclid(TAU) / TAU));
    let mut page = Canvas::default();
    page.text(Plane::new(0.0, -12.0), 12.0, "start", "", title);
    let names = [
        ("−180°", "0"),
        ("−90°", "90°"),
        ("0", "180°"),
        ("90°", "270°"),
        ("180°", "360°"),
    ];
    for (quarter, (crank, rocker)) in (0_u8..).zip(names) {
        let part = f64::from(quarter) / 4.0;
        let colour = if quarter == 2 { GREY } else { "#dddddd" };
        page.line(
            Plane::new(MAP.x * part, 0.0),
            Plane::new(MAP.x * part, MAP.y),
            colour,
            0.8,
        );
        page.line(
            Plane::new(0.0, MAP.y * (1.0 - part)),
            Plane::new(MAP.x, MAP.y * (1.0 - part)),
            colour,
            0.8,
        );
        page.text(Plane::new(MAP.x * part, MAP.y + 16.0), 11.0, "middle", "", crank);
        page.text(Plane::new(-6.0, MAP.y * (1.0 - part) + 4.0), 11.0, "end", "", rocker);
    }
    page.text(Plane::new(0.5 * MAP.x, MAP.y + 32.0), 11.0, "middle", "", "crank");
    page.text(Plane::new(6.0, 14.0), 11.0, "start", "", "rocker");
    for (index, branch) in cycle.branches().iter().enumerate() {
        let style = format!(
            r#"fill="none" stroke="{}" stroke-width="1.8" stroke-linejoin="round""#,
            COLOURS[index % COLOURS.len()]
        );
        let [low, high] = branch.ends();
        let mut inner = vec![(low.input, low.unknowns[1])];
        for step in 1..STEPS {
            // Close to a limit the curve is upright, so the steps are small there.
            let part = 0.5 - 0.5 * (PI * f64::from(step) / f64::from(STEPS)).cos();
            let crank = low.input + (high.input - low.input) * part;
            if let Ok([_, rocker]) = cycle.position_on(index, crank) {
                inner.push((crank, rocker));
            }
        }
        inner.push((high.input, high.unknowns[1]));
        // A curve that leaves the map on one side comes back on the other.
        let mut run: Vec<Plane> = Vec::new();
        let mut before: Option<Plane> = None;
        for (crank, rocker) in inner {
            let wrapped = |angle: f64| angle - TAU * (angle / TAU).round();
            let at = point(wrapped(crank), rocker);
            if before.is_some_and(|before| (at - before).norm() > 0.5 * MAP.x) {
                page.path(&run, false, &style);
                run.clear();
            }
            run.push(at);
            before = Some(at);
        }
        page.path(&run, false, &style);
        for end in branch.ends() {
            if end.limit() == Some(LimitKind::TurningPoint) {
                let rocker = end.unknowns[1] - TAU * (end.unknowns[1] / TAU).round();
                page.circle(
                    point(end.input, rocker),
                    4.0,
                    r##"fill="#ffffff" stroke="#222222" stroke-width="1.4""##,
                );
            }
        }
    }
    page
}

/// Two maps beside each other.
pub(super) fn circuits() -> Result<Figure, Box<dyn Error>> {
    let swinging = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    }
    .cycle()?;
    let turning = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 70.0,
        r4: 60.0,
    }
    .cycle()?;
    let mut page = Canvas::default();
    let corner = |column: f64| Plane::new(52.0 + column * (MAP.x + SPACE.x), 40.0);
    page.place(
        &map(&swinging, "90, 30, 60, 45: one circuit of two branches"),
        corner(0.0),
    );
    page.place(
        &map(&turning, "90, 30, 70, 60: two circuits, each of one branch"),
        corner(1.0),
    );
    Ok(Figure {
        file: "circuits.svg".to_owned(),
        svg: page.finish(
            2.0 * MAP.x + SPACE.x + 78.0,
            MAP.y + SPACE.y + 24.0,
            "The rocker's angle over the crank's: the circuits and branches of two four-bars",
        ),
    })
}
