//! Draws mechanisms from nothing but their closure: a four-bar linkage and a quick-return, at several crank angles.
//!
//! ```sh
//! cargo run --release --example skeleton -- skeletons.svg
//! ```
//!
//! Without a file name, the picture goes to the standard output.

use std::error::Error;
use std::f64::consts::TAU;
use std::fmt::Write as _;

use kin_core::Skeleton;
use kin_core::prelude::*;

mechanism! {
    /// Planar four-bar linkage with a point on its coupler.
    struct FourBar {
        ground: Length,
        crank: Length,
        coupler: Length,
        rocker: Length,
        /// From the crank's pin, in the coupler.
        tracer: Vector,
    }
    input theta: Angle;
    unknown phi: Angle, psi: Angle;

    crank * cis(theta) + coupler * cis(phi) == ground + rocker * cis(psi);

    output tip: Point = crank * cis(theta) + tracer * cis(phi);
    with transmission_angles;
}

mechanism! {
    /// Whitworth quick-return: the crank's pin slides in a lever, which drives a ram.
    struct QuickReturn {
        ground: Length,
        crank: Length,
        arm: Length,
        rod: Length,
    }
    input theta: Angle;
    unknown slide: Length where slide > 0, phi: Angle, psi: Angle, ram: Length;

    vec2(0, ground) + crank * cis(theta) == slide * cis(phi);
    arm * cis(phi) + rod * cis(psi) == vec2(ram, 0);

    output pin: Point = slide * cis(phi);
}

/// How many crank angles are shown over a turn, and which of them is drawn in bold.
const POSES: u32 = 8;
const BOLD: u32 = 1;
/// The colours of the bodies, in their order.
const COLOURS: [&str; 4] = ["#1f6fb4", "#d1662a", "#2f8a4b", "#8a4fa0"];
/// The size of one picture, and the margin within, in pixels.
const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 420.0;
const MARGIN: f64 = 40.0;

fn main() -> Result<(), Box<dyn Error>> {
    let four_bar = FourBar {
        ground: 90.0,
        crank: 30.0,
        coupler: 80.0,
        rocker: 60.0,
        tracer: Plane::new(50.0, 30.0),
    };
    let quick_return = QuickReturn {
        ground: 20.0,
        crank: 48.0,
        arm: 90.0,
        rod: 200.0,
    };

    let (mut linkages, mut presses) = (Drawing::default(), Drawing::default());
    let mut deviation: f64 = 0.0;
    for step in 0..POSES {
        let theta = TAU * f64::from(step) / f64::from(POSES);
        let pose = four_bar.position(theta, Assembly::Open)?;
        linkages.pose(&four_bar.skeleton(&pose), step == BOLD);
        let [transmission] = four_bar.transmission_angles(&pose);
        deviation = deviation.max(transmission.deviation());
        let pose = quick_return.position(theta, Assembly::Open)?;
        presses.pose(&quick_return.skeleton(&pose), step == BOLD);
    }

    // the coupler point's path, and how sharply it bends
    let mut curvature: f64 = 0.0;
    let mut path = Vec::new();
    for degrees in 0..=360 {
        let crank = Motion::at_constant_speed(f64::from(degrees).to_radians(), 1.0);
        let tip = four_bar.solve(crank, Assembly::Open)?.tip;
        curvature = tip.curvature().map_or(curvature, |here| curvature.max(here.abs()));
        path.push(tip.position());
    }
    linkages.line(path, "#999999", 1.5);
    eprintln!(
        "four-bar: transmission angle up to {:.1} degrees off a right angle, coupler curve's radius down to {:.2}",
        deviation.to_degrees(),
        1.0 / curvature
    );

    let picture = page(&[("four-bar linkage", &linkages), ("quick-return", &presses)])?;
    match std::env::args().nth(1) {
        Some(file) => std::fs::write(file, picture)?,
        None => print!("{picture}"),
    }
    Ok(())
}

/// The drawing of one mechanism, in its own unit of length.
#[derive(Default)]
struct Drawing {
    lines: Vec<(Vec<Plane>, &'static str, f64)>,
    dots: Vec<(Plane, &'static str, f64)>,
    labels: Vec<(Plane, &'static str)>,
}

impl Drawing {
    fn line(&mut self, corners: Vec<Plane>, colour: &'static str, width: f64) {
        self.lines.push((corners, colour, width));
    }

    /// Any mechanism's skeleton; a bold one bears the names of its bodies and points.
    fn pose<const PLACES: usize>(&mut self, skeleton: &Skeleton<[Plane; PLACES]>, bold: bool) {
        let (width, dot) = if bold { (4.0, 5.0) } else { (0.8, 1.6) };
        for ((name, joints), colour) in skeleton.bodies().zip(COLOURS.into_iter().cycle()) {
            let mut corners: Vec<Plane> = joints.collect();
            if bold && let [first, .., last] = corners[..] {
                self.labels.push(((first + last).scale(0.5), name));
            }
            self.dots.extend(corners.iter().map(|&joint| (joint, colour, dot)));
            // around a body of three joints or more
            corners.extend(corners.first().copied());
            self.line(corners, colour, width);
        }
        for (name, point) in skeleton.points() {
            self.dots.push((point, "#222222", dot));
            if bold {
                self.labels.push((point, name));
            }
        }
    }

    /// The lower left and the upper right corner.
    fn corners(&self) -> [Plane; 2] {
        let [mut low, mut high]: [Plane; 2] = [Plane::new(0.0, 0.0); 2];
        for corner in self.lines.iter().flat_map(|(corners, ..)| corners) {
            low = Plane::new(low.x.min(corner.x), low.y.min(corner.y));
            high = Plane::new(high.x.max(corner.x), high.y.max(corner.y));
        }
        [low, high]
    }

    fn write(&self, svg: &mut String) -> std::fmt::Result {
        let [low, high] = self.corners();
        let size = high - low;
        let scale = ((WIDTH - 2.0 * MARGIN) / size.x).min((HEIGHT - 2.0 * MARGIN) / size.y);
        // the y axis of a picture points down
        let place = |point: Plane| {
            (
                MARGIN + (point.x - low.x) * scale,
                HEIGHT - MARGIN - (point.y - low.y) * scale,
            )
        };
        for (corners, colour, width) in &self.lines {
            write!(
                svg,
                r#"<polyline fill="none" stroke="{colour}" stroke-width="{width}" points=""#
            )?;
            for &corner in corners {
                let (x, y) = place(corner);
                write!(svg, "{x:.2},{y:.2} ")?;
            }
            writeln!(svg, r#""/>"#)?;
        }
        for &(dot, colour, radius) in &self.dots {
            let (x, y) = place(dot);
            writeln!(svg, r#"<circle cx="{x:.2}" cy="{y:.2}" r="{radius}" fill="{colour}"/>"#)?;
        }
        for &(point, label) in &self.labels {
            let (x, y) = place(point);
            writeln!(svg, r#"<text x="{:.2}" y="{:.2}">{label}</text>"#, x + 8.0, y - 6.0)?;
        }
        Ok(())
    }
}

/// All drawings, one below the other.
fn page(drawings: &[(&str, &Drawing)]) -> Result<String, std::fmt::Error> {
    let mut svg = String::new();
    let count = u32::try_from(drawings.len()).map_err(|_| std::fmt::Error)?;
    writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{}\" \
         font-family=\"sans-serif\" font-size=\"12\">",
        HEIGHT * f64::from(count)
    )?;
    writeln!(svg, r##"<rect width="100%" height="100%" fill="#ffffff"/>"##)?;
    for (number, (title, drawing)) in (0_u32..).zip(drawings) {
        let top = HEIGHT * f64::from(number);
        writeln!(svg, r#"<g transform="translate(0 {top})">"#)?;
        writeln!(svg, r#"<text x="{MARGIN}" y="20" font-size="16">{title}</text>"#)?;
        drawing.write(&mut svg)?;
        writeln!(svg, "</g>")?;
    }
    writeln!(svg, "</svg>")?;
    Ok(svg)
}
