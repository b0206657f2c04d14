//! A cam that moves a four-bar linkage: its profile, pressure angle and radius of curvature.
//!
//! A motion law says how the rocker shall move while the cam turns. The linkage is solved the other way round, from the
//! rocker to the lever that carries the roller, and the roller's path as seen from the turning cam is the pitch curve.
//! Its curvature needs the second derivatives only, which are exact, so that nothing is fitted. The picture is written
//! into the book.
//!
//! ```sh
//! cargo run -p kin-tests --example cam
//! ```
//!
//! ```text
//! the joints of the rocker's law, over the angle of the cam:
//!       0 degrees: C3 at 0: snap jumps by 16.59568
//!     130 degrees: C3 at 2.268928: snap jumps by 16.59568
//!     180 degrees: C3 at 3.141593: snap jumps by -16.59568
//!     310 degrees: C3 at 5.410521: snap jumps by -16.59568
//! largest pressure angle 29.5 degrees, at 235.0 degrees
//! smallest radius of the profile 56.8 mm, at 88.0 degrees
//! the profile is convex
//! ```

use std::error::Error;
use std::f64::consts::PI;
use std::io::Write;
use std::path::Path;

use kin_core::law::{Dwell, Law, Rise, Sequence, Shape};
use kin_core::prelude::*;
use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

mechanism! {
    /// A four-bar linkage whose lever, a bell crank about the origin, carries the roller of a cam.
    struct CamLinkage {
        /// From the lever's pivot to the rocker's.
        ground: Length,
        /// The lever's arm to the coupler.
        lever: Length,
        /// Coupler.
        coupler: Length,
        /// Rocker, which the law moves.
        rocker: Length,
        /// The lever's arm to the roller.
        arm: Length,
        /// The angle from one arm to the other.
        bend: Angle,
        /// The axis of the cam.
        axis: Point,
    }
    input
        /// The angle of the cam.
        phi: Angle,
        /// The angle of the rocker.
        theta4: Angle;
    unknown
        /// The angle of the lever.
        theta2: Angle,
        /// The angle of the coupler.
        theta3: Angle;

    lever * cis(theta2) + coupler * cis(theta3) == ground + rocker * cis(theta4);

    // The pin of the lever and the coupler.
    output elbow: Point = lever * cis(theta2);
    // The pin of the coupler and the rocker.
    output pin: Point = ground + rocker * cis(theta4);
    // The centre of the roller.
    output roller: Point = arm * cis(theta2 + bend);
    // The centre of the roller, as seen from the turning cam.
    output pitch: Point = cis(-phi) * (arm * cis(theta2 + bend) - axis);
}

/// The roller's radius, in mm like all lengths.
const ROLLER: f64 = 16.0;

/// The angle of the cam in the picture, in degrees.
const SHOWN: f64 = 63.0;

/// The rocker's angles at rest, in degrees.
const LOW: f64 = 78.0;
const HIGH: f64 = 108.0;

/// The cam's angles for rise, dwell, return and dwell, in degrees.
const PARTS: [f64; 4] = [130.0, 50.0, 130.0, 50.0];

// colours that people who do not see all of them can tell apart (M. Okabe and K. Ito, Color Universal Design, 2002)
const BLUE: RGBColor = RGBColor(0, 114, 178);
const VERMILION: RGBColor = RGBColor(213, 94, 0);
const INK: RGBColor = RGBColor(34, 34, 34);
const GREY: RGBColor = RGBColor(119, 119, 119);
const FONT: &str = "DejaVu Sans, Helvetica, Arial, sans-serif";
const SIZE: (u32, u32) = (960, 560);

/// The backend knows whole pixels only, so that it draws so many times as large.
const FINE: u32 = 8;

/// The cam at one angle.
struct Row {
    degrees: f64,
    rocker: f64,
    pitch: Plane,
    profile: Plane,
    /// From the normal of the cam to the direction in which the roller can move.
    pressure: f64,
    /// Of the profile, if it is not straight; negative where it is hollow.
    radius: Option<f64>,
    elbow: Plane,
    pin: Plane,
    roller: Plane,
}

fn row(linkage: &CamLinkage, law: &impl Law<f64>, degrees: f64) -> Result<Row, Box<dyn Error>> {
    let phi: Motion = Motion::at_constant_speed(degrees.to_radians(), 1.0);
    let rocker = law.driven(phi);
    let pose = linkage.solve(phi, rocker, Assembly::Open)?;
    // the cam turns counter-clockwise, so that the roller goes round it clockwise, and the outside is to the left
    let tangent = pose.pitch.tangent().ok_or("the roller rests on the cam")?;
    let normal = Plane::new(-tangent.y, tangent.x);
    let roller = pose.roller.position();
    let turned = |vector: Plane, angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        Plane::new(vector.x * cosine - vector.y * sine, vector.x * sine + vector.y * cosine)
    };
    let push = turned(normal, phi.position());
    let way = turned(roller, 0.5 * PI);
    Ok(Row {
        degrees,
        rocker: rocker.position().to_degrees(),
        pitch: pose.pitch.position(),
        profile: pose.pitch.position() - normal.scale(ROLLER),
        pressure: push.cross(way).atan2(push.dot(way)).to_degrees(),
        radius: pose.pitch.radius_of_curvature().map(|radius| -radius - ROLLER),
        elbow: pose.elbow.position(),
        pin: pose.pin.position(),
        roller,
    })
}

/// Writes about the cam, and draws it.
pub(crate) fn report(out: &mut impl Write) -> Result<String, Box<dyn Error>> {
    let linkage: CamLinkage = CamLinkage {
        ground: 180.0,
        lever: 70.0,
        coupler: 170.0,
        rocker: 80.0,
        arm: 80.0,
        bend: -120_f64.to_radians(),
        axis: Plane::new(0.0, -125.0),
    };
    let [low, high] = [LOW, HIGH].map(f64::to_radians);
    let [rise, upper, fall, lower] = PARTS.map(f64::to_radians);
    let up = Rise::new(Shape::Polynomial4567, low, high, rise)?;
    let top = Dwell::new(high, upper)?;
    let down = Rise::new(Shape::Polynomial4567, high, low, fall)?;
    let bottom = Dwell::new(low, lower)?;
    let law = Sequence::new([&up, &top, &down, &bottom])?.repeated();

    writeln!(out, "the joints of the rocker's law, over the angle of the cam:")?;
    for joint in law.joints::<5>() {
        writeln!(out, "  {:>5.0} degrees: {joint}", joint.time.to_degrees())?;
    }
    let rows = (0..=360)
        .map(|step| row(&linkage, &law, f64::from(step)))
        .collect::<Result<Vec<_>, _>>()?;
    let steepest = rows
        .iter()
        .max_by(|one, other| one.pressure.abs().total_cmp(&other.pressure.abs()));
    let sharpest = rows
        .iter()
        .filter_map(|row| Some((row.radius.filter(|radius| *radius > 0.0)?, row.degrees)))
        .min_by(|one, other| one.0.total_cmp(&other.0));
    if let (Some(steepest), Some((radius, degrees))) = (steepest, sharpest) {
        writeln!(
            out,
            "largest pressure angle {:.1} degrees, at {:.1} degrees",
            steepest.pressure.abs(),
            steepest.degrees
        )?;
        writeln!(
            out,
            "smallest radius of the profile {radius:.1} mm, at {degrees:.1} degrees"
        )?;
    }
    let hollow = rows.iter().any(|row| row.radius.is_some_and(|radius| radius < 0.0));
    writeln!(
        out,
        "the profile is {}",
        if hollow { "hollow in places" } else { "convex" }
    )?;

    let shown = row(&linkage, &law, SHOWN)?;
    let mut picture = String::new();
    draw(&linkage, &rows, &shown, &mut picture)?;
    let (width, height) = SIZE;
    let large = format!(r#"width="{}" height="{}""#, FINE * width, FINE * height);
    Ok(picture.replacen(&large, &format!(r#"width="{width}" height="{height}""#), 1))
}

fn main() -> Result<(), Box<dyn Error>> {
    let picture = report(&mut std::io::stdout().lock())?;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/figures/cam.svg");
    std::fs::write(path, picture)?;
    println!("figure docs/figures/cam.svg");
    Ok(())
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The whole picture.
fn draw(linkage: &CamLinkage, rows: &[Row], shown: &Row, picture: &mut String) -> Result<(), Box<dyn Error>> {
    let (width, height) = SIZE;
    let area = SVGBackend::with_string(picture, (FINE * width, FINE * height)).into_drawing_area();
    area.fill(&WHITE)?;
    let (left, right) = area.split_horizontally(470 * FINE);
    machine(&left, linkage, rows, shown)?;
    let [first, second, third] = &right.split_evenly((3, 1))[..] else {
        return Err("three plots have three places".into());
    };
    let points = |value: fn(&Row) -> Option<f64>| -> Vec<(f64, f64)> {
        rows.iter().filter_map(|row| Some((row.degrees, value(row)?))).collect()
    };
    plot(
        first,
        "rocker, in degrees",
        &points(|row| Some(row.rocker)),
        70.0..110.0,
        10,
    )?;
    plot(
        second,
        "pressure angle, in degrees",
        &points(|row| Some(row.pressure)),
        -30.0..30.0,
        10,
    )?;
    plot(
        third,
        "radius of curvature of the profile, in mm",
        &points(|row| row.radius),
        0.0..400.0,
        100,
    )?;
    area.present()?;
    Ok(())
}

/// A quantity over a turn of the cam, whose axis is divided into quarters of a turn.
fn plot(
    area: &Area<'_>,
    title: &'static str,
    points: &[(f64, f64)],
    range: std::ops::Range<f64>,
    step: u32,
) -> Result<(), Box<dyn Error>> {
    let labels = (range.end - range.start) / f64::from(step);
    let top = range.end;
    let place = [44 * FINE, 12 * FINE].map(u32::cast_signed);
    area.draw(&Text::new(title, (place[0], place[1]), label(HPos::Left, INK)))?;
    let mut chart = ChartBuilder::on(area)
        .margin_right(22 * FINE)
        .margin_top(26 * FINE)
        .x_label_area_size(26 * FINE)
        .y_label_area_size(44 * FINE)
        .build_cartesian_2d(0.0..4.0, range)?;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "there are a few labels"
    )]
    let count = labels as usize + 1;
    chart
        .configure_mesh()
        .x_labels(5)
        .y_labels(count)
        .max_light_lines(0)
        .set_all_tick_mark_size(4 * FINE)
        .x_label_formatter(&|quarters| format!("{:.0}°", 90.0 * quarters))
        .y_label_formatter(&|value| format!("{value:.0}").replace('-', "−"))
        .label_style((FONT, 12 * FINE).into_font().color(&INK))
        .axis_style(GREY.stroke_width(FINE))
        .bold_line_style(BLACK.mix(0.12).stroke_width(FINE))
        .draw()?;
    // the parts of the law
    let mut border = 0.0;
    for part in &PARTS[..3] {
        border += part / 90.0;
        let line = [(border, chart.y_range().start), (border, top)];
        chart.draw_series(DashedLineSeries::new(line, 3 * FINE, 3 * FINE, GREY.stroke_width(FINE)))?;
    }
    let inside = points
        .iter()
        .filter(|(_, value)| *value <= top)
        .map(|&(degrees, value)| (degrees / 90.0, value));
    // where the curve leaves the plot, it is interrupted
    let mut piece: Vec<(f64, f64)> = Vec::new();
    for point in inside {
        if piece.last().is_some_and(|last| point.0 - last.0 > 0.02) {
            chart.draw_series(LineSeries::new(piece.drain(..), BLUE.stroke_width(2 * FINE)))?;
        }
        piece.push(point);
    }
    chart.draw_series(LineSeries::new(piece, BLUE.stroke_width(2 * FINE)))?;
    Ok(())
}

/// The cam, the roller and the linkage at one angle.
fn machine(area: &Area<'_>, linkage: &CamLinkage, rows: &[Row], shown: &Row) -> Result<(), Box<dyn Error>> {
    // one millimetre is as many pixels in both directions
    let (width, height) = area.dim_in_pixel();
    let scale = 1.38 * f64::from(FINE);
    let (left, top) = (-142.0, 138.0);
    let right = left + f64::from(width) / scale;
    let bottom = top - f64::from(height) / scale;
    let chart = ChartBuilder::on(area).build_cartesian_2d(left..right, bottom..top)?;
    let page = chart.plotting_area();
    let (sine, cosine) = SHOWN.to_radians().sin_cos();
    let fixed = |point: Plane| {
        let turned = Plane::new(point.x * cosine - point.y * sine, point.x * sine + point.y * cosine);
        let place = turned + linkage.axis;
        (place.x, place.y)
    };
    let at = |point: Plane| (point.x, point.y);
    let pixels = |length: f64| length * scale;
    let profile: Vec<(f64, f64)> = rows.iter().map(|row| fixed(row.profile)).collect();
    page.draw(&Polygon::new(profile.clone(), BLUE.mix(0.12)))?;
    page.draw(&PathElement::new(profile, BLUE.stroke_width(2 * FINE)))?;
    let pitch = rows.iter().map(|row| fixed(row.pitch));
    page.draw(&DashedPathElement::new(
        pitch,
        5 * FINE,
        4 * FINE,
        BLUE.stroke_width(FINE),
    ))?;

    // the direction of the push, and that in which the roller can move
    let push = Plane::new(
        fixed(shown.pitch).0 - fixed(shown.profile).0,
        fixed(shown.pitch).1 - fixed(shown.profile).1,
    );
    let way = Plane::new(-shown.roller.y, shown.roller.x).scale(ROLLER / linkage.arm);
    for (direction, colour) in [(push, VERMILION), (way, GREY)] {
        let end = shown.roller + direction.scale(62.0 / ROLLER);
        page.draw(&PathElement::new(
            vec![at(shown.roller), at(end)],
            colour.stroke_width(FINE),
        ))?;
    }

    let angle = |direction: Plane| direction.y.atan2(direction.x);
    let arc = (0..=20).map(|part| {
        let (sine, cosine) = (angle(push) + (angle(way) - angle(push)) * f64::from(part) / 20.0).sin_cos();
        at(shown.roller + Plane::new(cosine, sine).scale(50.0))
    });
    page.draw(&PathElement::new(
        arc.collect::<Vec<_>>(),
        VERMILION.stroke_width(2 * FINE),
    ))?;

    let ink = INK.stroke_width(3 * FINE);
    let pivots = [Plane::new(0.0, 0.0), Plane::new(linkage.ground, 0.0), linkage.axis];
    let bell = vec![at(shown.elbow), at(pivots[0]), at(shown.roller)];
    page.draw(&PathElement::new(bell, ink))?;
    page.draw(&PathElement::new(vec![at(shown.elbow), at(shown.pin)], ink))?;
    page.draw(&PathElement::new(vec![at(shown.pin), at(pivots[1])], ink))?;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a radius of some pixels"
    )]
    let size = pixels(ROLLER) as u32;
    page.draw(&Circle::new(at(shown.roller), size, WHITE.mix(0.6).filled()))?;
    page.draw(&Circle::new(at(shown.roller), size, INK.stroke_width(2 * FINE)))?;
    for pivot in pivots {
        ground(page, pivot)?;
    }
    for joint in pivots.into_iter().chain([shown.elbow, shown.pin, shown.roller]) {
        page.draw(&Circle::new(at(joint), 5 * FINE, WHITE.filled()))?;
        page.draw(&Circle::new(at(joint), 5 * FINE, INK.stroke_width(2 * FINE)))?;
    }
    let middle = |one: Plane, other: Plane| (one + other).scale(0.5);
    let labels: [(&str, Plane, HPos, RGBColor); 7] = [
        ("cam", linkage.axis + Plane::new(36.0, 0.0), HPos::Center, BLUE),
        ("pitch curve", linkage.axis + Plane::new(-118.0, 62.0), HPos::Left, BLUE),
        (
            "lever",
            middle(pivots[0], shown.elbow) + Plane::new(-10.0, 6.0),
            HPos::Right,
            INK,
        ),
        (
            "coupler",
            middle(shown.elbow, shown.pin) + Plane::new(0.0, 16.0),
            HPos::Center,
            INK,
        ),
        (
            "rocker",
            middle(shown.pin, pivots[1]) + Plane::new(-8.0, 0.0),
            HPos::Right,
            INK,
        ),
        ("roller", shown.roller + Plane::new(22.0, 4.0), HPos::Left, INK),
        (
            "pressure angle",
            shown.roller + Plane::new(36.0, 36.0),
            HPos::Left,
            VERMILION,
        ),
    ];
    for (name, place, anchor, colour) in labels {
        page.draw(&Text::new(name, at(place), label(anchor, colour)))?;
    }
    Ok(())
}

/// The style of a name in the picture.
fn label(anchor: HPos, colour: RGBColor) -> TextStyle<'static> {
    TextStyle {
        color: colour.to_backend_color(),
        ..TextStyle::from((FONT, 14 * FINE).into_font()).pos(Pos::new(anchor, VPos::Center))
    }
}

/// The hatched triangle below a pivot.
fn ground<C: plotters::coord::CoordTranslate<From = (f64, f64)>>(
    page: &DrawingArea<SVGBackend<'_>, C>,
    pivot: Plane,
) -> Result<(), Box<dyn Error>> {
    let at = |x: f64, y: f64| (pivot.x + x, pivot.y + y);
    let stand = vec![at(0.0, 0.0), at(-9.0, -15.0), at(9.0, -15.0), at(0.0, 0.0)];
    page.draw(&PathElement::new(stand, GREY.stroke_width(FINE)))?;
    for stroke in -2..=2 {
        let x = 4.5 * f64::from(stroke);
        page.draw(&PathElement::new(
            vec![at(x, -15.0), at(x - 4.0, -20.0)],
            GREY.stroke_width(FINE),
        ))?;
    }
    Ok(())
}
