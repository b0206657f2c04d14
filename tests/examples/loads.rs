//! The torque that a servo must give to a four-bar linkage, and the free fall of the same linkage without a drive.
//!
//! The torque and its rates are exact, since the accelerations come with their own derivatives. The free fall follows
//! from q'' = (Q - J' q'²/2)/J, which `Loads::accelerations` solves, and the crate `differential-equations` integrates
//! it. The energy drifts by the error of the integration alone, which falls with its tolerance, as the program prints.
//! The picture is written into the book.
//!
//! ```sh
//! cargo run -p kin-tests --features other-crates --example loads
//! ```

use std::cell::RefCell;
use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

use differential_equations::ivp::IVP;
use differential_equations::methods::ExplicitRungeKutta;
use kin_core::extremes::Over;
use kin_core::load::{Load, LoadError, Loads};
use kin_core::prelude::*;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

mechanism! {
    /// Four-bar linkage in metres, whose crank turns fully.
    pub(crate) struct Linkage {
        /// From the pivot of the crank to the pivot of the rocker.
        r1: Length,
        /// Crank.
        r2: Length,
        /// Coupler.
        r3: Length,
        /// Rocker.
        r4: Length,
    }
    input
        /// The angle of the crank.
        theta2: Angle;
    unknown
        /// The angle of the coupler.
        theta3: Angle,
        /// The angle of the rocker.
        theta4: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);

    // The centres of mass, which are the middles of the links.
    output crank: Point = r2 / 2 * cis(theta2);
    output coupler: Point = r2 * cis(theta2) + r3 / 2 * cis(theta3);
    output rocker: Point = r1 + r4 / 2 * cis(theta4);
}

const LINKAGE: Linkage = Linkage {
    r1: 0.4,
    r2: 0.12,
    r3: 0.36,
    r4: 0.28,
};

/// The speed of the driven crank.
const SPEED: f64 = 120.0;

/// The angle from which the crank falls, in degrees.
const RELEASED: f64 = 40.0;

/// The tolerances with which the fall is integrated.
pub(crate) const TOLERANCES: [f64; 4] = [1e-4, 1e-6, 1e-8, 1e-10];

/// The longest step of the picture, in seconds.
const STEP: f64 = 0.002;

/// The time of the fall, in seconds.
pub(crate) const FALL: f64 = 3.0;

/// Uniform bars of 4 kg per metre.
pub(crate) fn bars<T: Scalar>() -> Loads<Linkage<T>, impl Load<Linkage<T>>> {
    let mass = |length: f64| 4.0 * length;
    // about the middle
    let inertia = |length: f64| mass(length) * length * length / 12.0;
    Loads::<Linkage<T>>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(mass(LINKAGE.r2), |pose| pose.crank)
        .inertia(inertia(LINKAGE.r2), |pose| pose.theta2)
        .mass(mass(LINKAGE.r3), |pose| pose.coupler)
        .inertia(inertia(LINKAGE.r3), |pose| pose.theta3)
        .mass(mass(LINKAGE.r4), |pose| pose.rocker)
        .inertia(inertia(LINKAGE.r4), |pose| pose.theta4)
}

/// The angle of the crank and its velocity.
type State = [f64; 2];

/// The energies at one instant of the fall.
pub(crate) struct Instant {
    time: f64,
    kinetic: f64,
    potential: f64,
}

/// The fall from rest after every step of the method of order 8 of Dormand and Prince. Its steps are not longer than
/// `longest`.
pub(crate) fn fall(
    loads: &Loads<Linkage, impl Load<Linkage>>,
    tolerance: f64,
    longest: f64,
) -> Result<Vec<Instant>, Box<dyn Error>> {
    let failed = RefCell::new(None);
    let rates = |_: f64, [angle, velocity]: &State, rates: &mut State| {
        let accelerations = LINKAGE.accelerations(loads, [*angle], [*velocity], [0.0], Assembly::Open);
        *rates = match accelerations {
            Ok([acceleration]) => [*velocity, acceleration],
            Err(error) => {
                failed.borrow_mut().get_or_insert(error);
                [0.0; 2]
            }
        };
    };
    let solution = IVP::ode_from_fn(rates, 0.0, FALL, [RELEASED.to_radians(), 0.0])
        .method(
            ExplicitRungeKutta::dop853()
                .rtol(tolerance)
                .atol(tolerance)
                .h_max(longest),
        )
        .solve();
    if let Some(error) = failed.take() {
        return Err(error.into());
    }
    let solution = solution.map_err(|error| format!("{error:?}"))?;
    let instant = |(time, state): (&f64, &State)| {
        let crank = Motion::at_constant_speed(state[0], state[1]);
        let balance = LINKAGE.balance(loads, [crank], Assembly::Open)?;
        Ok(Instant {
            time: *time,
            kinetic: balance.kinetic_energy().value(),
            potential: balance.potential_energy().value(),
        })
    };
    solution.t.iter().zip(&solution.y).map(instant).collect()
}

/// The largest change of the energy, as a part of the largest kinetic energy.
pub(crate) fn drift(instants: &[Instant]) -> f64 {
    let energy = |instant: &Instant| instant.kinetic + instant.potential;
    let most = instants.iter().map(|instant| instant.kinetic).fold(0.0, f64::max);
    let changes = instants
        .iter()
        .map(|instant| (energy(instant) - energy(&instants[0])).abs());
    changes.fold(0.0, f64::max) / most
}

fn main() -> Result<(), Box<dyn Error>> {
    let loads = bars::<f64>();
    let mut torques = Vec::new();
    for degrees in 0..=360 {
        let crank = Motion::at_constant_speed(f64::from(degrees).to_radians(), rpm(SPEED));
        let [torque] = LINKAGE.balance(&loads, [crank], Assembly::Open)?.efforts();
        torques.push((f64::from(degrees), torque));
    }
    println!("the drive at {SPEED} revolutions per minute");
    let (swept, turn) = (
        bars(),
        LINKAGE.sweep(Assembly::Open).over(0.0..=TAU, 361).speed(rpm(SPEED)),
    );
    for (order, name, unit) in [
        (0, "torque", "N m"),
        (1, "its rate", "N m/s"),
        (2, "its second rate", "N m/s²"),
    ] {
        let peak = turn
            .of_expression(|at| {
                let balance = at.balance(&swept)?;
                let [torque] = balance.efforts();
                Ok::<_, LoadError>(torque.as_slice()[order])
            })
            .peak()?;
        println!(
            "  {name}: largest {:.2} {unit}, at {:.2} degrees",
            peak.value,
            peak.at.to_degrees()
        );
    }
    let mean = turn.of_expression(|at| at.effort(&swept, 0)).rms(Over::Time)?;
    println!("  torque, root mean square over a turn: {:.2} N m", mean.value);

    println!("the fall from {RELEASED} degrees, for {FALL} s: drift of the energy");
    for tolerance in TOLERANCES {
        let instants = fall(&loads, tolerance, FALL)?;
        println!(
            "  tolerance {tolerance:.0e}: {:.1e} of the largest kinetic energy, in {} steps",
            drift(&instants),
            instants.len() - 1
        );
    }

    let torque: Vec<(f64, f64)> = torques.iter().map(|(angle, torque)| (*angle, torque.value())).collect();
    let rate: Vec<(f64, f64)> = torques.iter().map(|(angle, torque)| (*angle, torque.rate())).collect();
    let instants = fall(&loads, TOLERANCES[3], STEP)?;
    let energy = |value: fn(&Instant) -> f64| -> Vec<(f64, f64)> {
        instants.iter().map(|instant| (instant.time, value(instant))).collect()
    };
    let lowest = instants
        .iter()
        .map(|instant| instant.potential)
        .fold(f64::INFINITY, f64::min);
    let potential: Vec<(f64, f64)> = energy(|instant| instant.potential)
        .into_iter()
        .map(|(time, energy)| (time, energy - lowest))
        .collect();
    let sum: Vec<(f64, f64)> = energy(|instant| instant.kinetic + instant.potential)
        .into_iter()
        .map(|(time, energy)| (time, energy - lowest))
        .collect();
    let picture = draw(
        &torque,
        &rate,
        &[
            (energy(|instant| instant.kinetic), BLUE, "kinetic"),
            (potential, VERMILION, "potential"),
            (sum, INK, "sum"),
        ],
    )?;
    std::fs::write(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/figures/loads.svg"),
        picture,
    )?;
    println!("figure docs/figures/loads.svg");
    Ok(())
}

// colours that people who do not see all of them can tell apart (M. Okabe and K. Ito, Color Universal Design, 2002)
const BLUE: RGBColor = RGBColor(0, 114, 178);
const VERMILION: RGBColor = RGBColor(213, 94, 0);
const INK: RGBColor = RGBColor(34, 34, 34);
const GREY: RGBColor = RGBColor(119, 119, 119);
const FONT: &str = "DejaVu Sans, Helvetica, Arial, sans-serif";
const SIZE: (u32, u32) = (960, 380);

/// The backend knows whole pixels only, so that it draws so many times as large.
const FINE: u32 = 8;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A curve with its colour and its name.
type Curve<'a> = (Vec<(f64, f64)>, RGBColor, &'a str);

/// The torque and its rate over the angle at the left, the energies of the fall at the right.
fn draw(torque: &[(f64, f64)], rate: &[(f64, f64)], energies: &[Curve<'_>]) -> Result<String, Box<dyn Error>> {
    let (width, height) = SIZE;
    let mut picture = String::new();
    {
        let area = SVGBackend::with_string(&mut picture, (FINE * width, FINE * height)).into_drawing_area();
        area.fill(&WHITE)?;
        let (left, right) = area.split_horizontally(480 * FINE);
        let (above, below) = left.split_vertically(190 * FINE);
        let degrees = |angle: f64| format!("{angle:.0}°");
        let seconds = |time: f64| format!("{time:.1} s");
        plot(
            &above,
            "torque of the drive, in N m",
            &[(torque.to_vec(), BLUE, "")],
            4.0,
            &degrees,
        )?;
        plot(
            &below,
            "its rate, in N m/s",
            &[(rate.to_vec(), BLUE, "")],
            4.0,
            &degrees,
        )?;
        plot(&right, "energies of the free fall, in J", energies, 6.0, &seconds)?;
        area.present()?;
    }
    let large = format!(r#"width="{}" height="{}""#, FINE * width, FINE * height);
    Ok(picture.replacen(&large, &format!(r#"width="{width}" height="{height}""#), 1))
}

/// Curves over one axis, which is divided into equal parts.
fn plot(
    area: &Area<'_>,
    title: &str,
    curves: &[Curve<'_>],
    parts: f64,
    shown: &dyn Fn(f64) -> String,
) -> Result<(), Box<dyn Error>> {
    let points = || curves.iter().flat_map(|(points, ..)| points);
    let low = points().map(|point| point.1).fold(0.0, f64::min);
    let high = points().map(|point| point.1).fold(0.0, f64::max);
    let end = points().map(|point| point.0).fold(0.0, f64::max);
    let margin = 0.06 * (high - low);
    let place = [52 * FINE, 12 * FINE].map(u32::cast_signed);
    area.draw(&Text::new(title, (place[0], place[1]), label(HPos::Left, INK)))?;
    let mut chart = ChartBuilder::on(area)
        .margin_right(22 * FINE)
        .margin_top(26 * FINE)
        .x_label_area_size(26 * FINE)
        .y_label_area_size(52 * FINE)
        .build_cartesian_2d(0.0..parts, low - margin..high + margin)?;
    chart
        .configure_mesh()
        .x_labels(7)
        .y_labels(6)
        .max_light_lines(0)
        .set_all_tick_mark_size(4 * FINE)
        .x_label_formatter(&|part| shown(part * end / parts))
        .y_label_formatter(&|value| format!("{value}").replace('-', "−"))
        .label_style((FONT, 12 * FINE).into_font().color(&INK))
        .axis_style(GREY.stroke_width(FINE))
        .bold_line_style(BLACK.mix(0.12).stroke_width(FINE))
        .draw()?;
    for (points, colour, _) in curves {
        chart.draw_series(LineSeries::new(
            points.iter().map(|point| (point.0 * parts / end, point.1)),
            colour.stroke_width(2 * FINE),
        ))?;
    }
    let mut across = 250 * FINE.cast_signed();
    for (_, colour, name) in curves {
        area.draw(&Text::new(*name, (across, place[1]), label(HPos::Left, *colour)))?;
        across += 80 * FINE.cast_signed();
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
