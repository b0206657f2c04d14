//! A four-bar linkage from position to snap, by three methods, compared with the values printed in lecture notes.
//!
//! ```sh
//! cargo run -p four-bar
//! ```
//!
//! It also writes a page on which the linkage moves, `four_bar.html`, or the file that is named behind `--`.
//!
//! The exit code is not zero if a value differs from the printed one by more than its last digit allows.

use std::error::Error;
use std::f64::consts::TAU;
use std::process::ExitCode;

use kin_core::prelude::*;

mechanism! {
    /// The linkage as one vector loop: ground 1, crank 2, coupler 3, rocker 4.
    pub struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// The same linkage, one triangle after the other. They share the diagonal `e` from the crank's pin to the rocker's
    /// pivot.
    pub struct Triangles { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown e: Length where e > 0, alpha: Angle, gamma: Angle, beta: Angle, theta4: Angle, theta3: Angle;

    e.powi(2) == r1.powi(2) + r2.powi(2) - 2 * r1 * r2 * cos(theta2);
    sin(alpha) == r2 * sin(theta2) / e;
    cos(gamma) == (r3.powi(2) + r4.powi(2) - e.powi(2)) / (2 * r3 * r4);
    sin(beta) == r3 * sin(gamma) / e;
    alpha + beta + theta4 == PI;
    theta3 == theta4 - gamma;
}

mechanism! {
    /// The same linkage by Freudenstein's equations, one for each angle.
    ///
    /// Source: F. Freudenstein, "Approximate synthesis of four-bar linkages", Transactions of the ASME 77, 1955.
    pub struct Freudenstein { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;

    let k1 = r1 / r2;
    let k2 = r1 / r4;
    let k3 = (r2.powi(2) - r3.powi(2) + r4.powi(2) + r1.powi(2)) / (2 * r2 * r4);
    let k4 = r1 / r3;
    let k5 = (r4.powi(2) - r1.powi(2) - r2.powi(2) - r3.powi(2)) / (2 * r2 * r3);

    k1 * cos(theta4) - k2 * cos(theta2) + k3 == cos(theta2 - theta4);
    k1 * cos(theta3) + k4 * cos(theta2) + k5 == cos(theta2 - theta3);
}

const ORDERS: [&str; 5] = ["position", "velocity", "acceleration", "jerk", "snap"];

/// A quantity as printed in the notes, position first. The notes end with the jerk; the snap comes from 50-digit
/// arithmetic.
struct Printed {
    name: &'static str,
    is_angle: bool,
    values: [&'static str; 5],
}

const PRINTED: [Printed; 6] = [
    Printed {
        name: "theta3",
        is_angle: true,
        values: ["13.1515", "3.9013", "7.0627", "490.7125", "-10396.8937614"],
    },
    Printed {
        name: "theta4",
        is_angle: true,
        values: ["114.8278", "-5.3533", "69.7682", "237.4051", "19274.1419587"],
    },
    Printed {
        name: "e",
        is_angle: false,
        values: ["81.9626", "-298.5547", "364.3867", "32987", "301182.2213"],
    },
    Printed {
        name: "alpha",
        is_angle: true,
        values: ["19.3737", "-0.3588", "-38.9682", "-363.3719", "-118.8449067"],
    },
    Printed {
        name: "gamma",
        is_angle: true,
        values: ["101.6763", "-9.2546", "62.7055", "-253.3073", "29671.03572"],
    },
    Printed {
        name: "beta",
        is_angle: true,
        values: ["45.7986", "5.7122", "-30.8000", "125.9668", "-19155.29705"],
    },
];

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let crank = Motion::from((65_f64.to_radians(), -10.0, 2.0, -0.5, 0.3));

    let agrees = methods(&linkage, crank)?;
    range_of_motion(&linkage)?;
    assemblies(&linkage);
    page(&linkage)?;

    Ok(if agrees { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Solves the same motion by three sets of equations, and returns whether every value agrees with the printed one.
fn methods(linkage: &FourBar, crank: Motion) -> Result<bool, SolveError> {
    let FourBar { r1, r2, r3, r4 } = *linkage;
    let triangles = Triangles { r1, r2, r3, r4 };
    let equations = Freudenstein { r1, r2, r3, r4 };
    // At this angle alpha and beta are acute.
    let of_triangles = TrianglesAssembly {
        alpha: Assembly::Open,
        gamma: Assembly::Open,
        beta: Assembly::Open,
    };
    // Each equation has two solutions. These two close the linkage.
    let of_equations = FreudensteinAssembly {
        theta3: Assembly::Crossed,
        theta4: Assembly::Crossed,
    };

    let by_loop = linkage.solve(crank, Assembly::Open)?;
    let by_triangles = triangles.solve(crank, of_triangles)?;
    let by_equations = equations.solve(crank, of_equations)?;

    // In the order of PRINTED.
    let found = [
        [
            Some(by_loop.theta3),
            Some(by_triangles.theta3),
            Some(by_equations.theta3),
        ],
        [
            Some(by_loop.theta4),
            Some(by_triangles.theta4),
            Some(by_equations.theta4),
        ],
        [None, Some(by_triangles.e), None],
        [None, Some(by_triangles.alpha), None],
        [None, Some(by_triangles.gamma), None],
        [None, Some(by_triangles.beta), None],
    ];

    println!("Four-bar linkage, r1 = {r1}, r2 = {r2}, r3 = {r3}, r4 = {r4} cm, open assembly");
    println!(
        "Crank: theta2 = {} deg, rates {}, {}, {}, {} (rad and s)\n",
        crank.value().to_degrees().round(),
        crank.velocity(),
        crank.acceleration(),
        crank.jerk(),
        crank.snap()
    );
    println!("Positions of angles are in degrees, their rates in radians; e is in centimetres.\n");
    println!(
        "{:8}{:14}{:>16}{:>16}{:>16}{:>16}{:>12}",
        "", "", "vector loop", "triangles", "Freudenstein", "printed", "deviation"
    );

    let mut agrees = true;
    let mut largest: f64 = 0.0;
    for (printed, motions) in PRINTED.iter().zip(found) {
        println!("{}", "-".repeat(98));
        for (order, text) in printed.values.into_iter().enumerate() {
            let values = motions.map(|motion| motion.map(|motion| shown(printed, motion, order)));
            let (value, last_digit) = read(text);
            let deviation = values
                .iter()
                .flatten()
                .fold(0.0, |most: f64, found| most.max((found - value).abs()));
            // Half of the last digit, plus a few roundings of double precision.
            let allowed = 0.5 * last_digit + 64.0 * f64::EPSILON * value.abs();
            let verdict = if deviation <= allowed { "" } else { " !" };
            agrees &= deviation <= allowed;
            largest = largest.max(deviation / last_digit);
            println!(
                "{:8}{:14}{:>16}{:>16}{:>16}{text:>16}{deviation:>12.1e}{verdict}",
                if order == 0 { printed.name } else { "" },
                ORDERS[order],
                cell(values[0]),
                cell(values[1]),
                cell(values[2]),
            );
        }
    }
    println!("{}", "-".repeat(98));
    println!("Largest deviation: {largest:.2} of the last printed digit (0.50 is rounding).");
    println!(
        "{}\n",
        if agrees {
            "All values agree with the printed ones."
        } else {
            "NOT all values agree."
        }
    );
    Ok(agrees)
}

/// A derivative in the units of the table. An angle is reduced by whole turns.
fn shown(printed: &Printed, motion: Motion, order: usize) -> f64 {
    let value = motion.derivatives()[order];
    if printed.is_angle && order == 0 {
        (value - TAU * (value / TAU).round()).to_degrees()
    } else {
        value
    }
}

/// The printed number, and the value of its last digit.
fn read(text: &str) -> (f64, f64) {
    let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let last_digit = (0..decimals).fold(1.0, |unit, _| unit / 10.0);
    (text.parse().expect("the table holds numbers"), last_digit)
}

fn cell(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| format!("{value:.7}"))
}

/// Prints the range of the crank, and the errors beyond it.
fn range_of_motion(linkage: &FourBar) -> Result<(), Box<dyn Error>> {
    println!("Range of motion\n");
    let cycle = linkage.cycle()?;
    let branch = cycle.branches().first().ok_or("the links do not close at any angle")?;
    let (low, high) = branch.range().into_inner();
    println!(
        "The linkage closes for theta2 from {:.4} to {:.4} degrees{}.",
        low.to_degrees(),
        high.to_degrees(),
        if branch.is_full_revolution() {
            ": the crank makes full turns"
        } else {
            "; the crank does not make full turns"
        }
    );
    for (place, angle) in [
        ("at the limit", high),
        ("half a degree beyond", high + 0.5_f64.to_radians()),
    ] {
        match linkage.position(angle, Assembly::Open) {
            Ok(position) => println!(
                "\n{place}: theta4 = {:.4} degrees",
                position.theta4.value().to_degrees()
            ),
            Err(error) => {
                let margin = error
                    .margin()
                    .map_or_else(String::new, |margin| format!(", margin {margin:.4} cm"));
                println!("\n{place}{margin}:\n{}", wrapped(&error.to_string(), 92));
            }
        }
    }
    println!();
    Ok(())
}

/// Writes the page on which the linkage moves, and says how to open it.
fn page(linkage: &FourBar) -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os().nth(1).unwrap_or_else(|| "four_bar.html".into());
    kin_studio::report(linkage)
        .at([65_f64.to_radians()])
        .speed(-10.0)
        .units("cm", "s")
        .title("Four-bar linkage")
        .documentation("The linkage of the lecture notes: ground 90, crank 30, coupler 60 and rocker 45 cm.")
        .write(&path)?;
    let path = std::path::absolute(path)?;
    println!(
        "\nA page on which the linkage moves: open this file in a browser.\n\n    {}",
        path.display()
    );
    Ok(())
}

/// Wraps a text into indented lines of at most `width` characters.
fn wrapped(text: &str, width: usize) -> String {
    let (mut result, mut column) = (String::from("   "), 0);
    for word in text.split_whitespace() {
        if column > 0 && column + word.len() >= width {
            result.push_str("\n   ");
            column = 0;
        }
        result.push(' ');
        result.push_str(word);
        column += word.len() + 1;
    }
    result
}

/// Prints the two assemblies of the linkage over the range of the crank.
fn assemblies(linkage: &FourBar) {
    println!("Both assemblies, at a crank speed of 1 rad/s\n");
    println!("{:>8} |{:^42} |{:^42}", "", Assembly::Open, Assembly::Crossed);
    let head = format!("{:>9}{:>9}{:>12}{:>12}", "theta3", "theta4", "theta4'", "theta4''");
    println!("{:>8} |{head} |{head}", "theta2");
    println!("{}", "-".repeat(98));
    for degrees in (-120..=120).step_by(15) {
        let crank = Motion::at_constant_speed(f64::from(degrees).to_radians(), 1.0);
        print!("{degrees:>8}");
        for assembly in FourBar::ASSEMBLIES {
            match linkage.solve(crank, assembly) {
                Ok(pose) => print!(
                    " |{:>9.3}{:>9.3}{:>12.5}{:>12.5}",
                    pose.theta3.position().to_degrees(),
                    pose.theta4.position().to_degrees(),
                    pose.theta4.velocity(),
                    pose.theta4.acceleration()
                ),
                Err(error) => {
                    let short = error
                        .margin()
                        .map_or_else(String::new, |margin| format!(" by {:.3} cm", -margin));
                    print!(" |{:>42}", format!("out of reach{short}"));
                }
            }
        }
        println!();
    }
}
