//! Joint forces beside the cases of `docs/data/joint-forces.json`, which the reference writes:
//!
//! ```sh
//! KIN_RECORD=1 cargo test -p kin-tests --test forces
//! ```

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use kin_core::any::{Described as _, PositionChoice};
use kin_core::prelude::*;
use kin_core::reaction::Friction;
use kin_live::Mechanism;
use kin_tests::reference::{Body, Connection, Cut, Rates, Shape, written};
use serde_json::Value;

const FOUR_BAR: &str = "\
struct FourBar { ground: Length, crank: Length, coupler: Length, rocker: Length }
input theta: Angle;
unknown phi: Angle, psi: Angle;
crank * cis(theta) + coupler * cis(phi) == ground + rocker * cis(psi);
output pin: Point = crank * cis(theta);
output knee: Point = ground + rocker * cis(psi);
output pivot: Point = vec2(ground, 0);
ground 0, pivot;
body crank: 0, pin;
body coupler: pin, knee;
body rocker: pivot, knee;
";

const SLIDER_CRANK: &str = "\
struct SliderCrank { crank: Length, rod: Length }
input theta: Angle;
unknown phi: Angle, s: Length;
crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
output pin: Point = crank * cis(theta);
output slider: Point = vec2(s, 0);
ground 0;
body crank: 0, pin;
body rod: pin, slider;
body piston: slider;
slide slider along vec2(1, 0);
";

const fn body(name: &'static str, joints: (usize, Option<usize>), mass: f64, centre: [f64; 2], inertia: f64) -> Body {
    Body {
        name,
        joints,
        mass,
        centre,
        inertia,
    }
}

const BARS: [Body; 3] = [
    body("crank", (0, Some(1)), 0.8, [0.05, 0.01], 0.004),
    body("coupler", (1, Some(2)), 1.4, [0.3, 0.08], 0.09),
    body("rocker", (3, Some(2)), 1.1, [0.25, -0.03], 0.05),
];

const ENGINE: [Body; 3] = [
    body("crank", (0, Some(1)), 2.5, [0.005, 0.0], 0.003),
    body("rod", (1, Some(2)), 0.7, [0.05, 0.002], 0.0025),
    body("piston", (2, None), 0.6, [0.004, 0.001], 0.0004),
];

const fn connection(
    name: &'static str,
    joint: usize,
    pair: (usize, Option<usize>),
    coefficient: f64,
    radius: Option<f64>,
) -> Connection {
    let (on, by) = pair;
    Connection {
        name,
        joint,
        on,
        by,
        coefficient,
        radius,
    }
}

const fn of_bars(coefficient: f64) -> [Connection; 4] {
    let radius = Some(0.012);
    [
        connection("ground_crank", 0, (0, None), coefficient, radius),
        connection("pin", 1, (1, Some(0)), coefficient, radius),
        connection("knee", 2, (2, Some(1)), coefficient, radius),
        connection("pivot", 3, (2, None), coefficient, radius),
    ]
}

const fn of_engine(coefficient: f64) -> [Connection; 4] {
    let radius = Some(0.015);
    [
        connection("ground_crank", 0, (0, None), coefficient, radius),
        connection("pin", 1, (1, Some(0)), coefficient, radius),
        connection("slider", 2, (1, Some(2)), coefficient, radius),
        connection("slider_slide", 2, (2, None), coefficient, None),
    ]
}

const DRY_BARS: [Connection; 4] = of_bars(0.15);
const EASY_BARS: [Connection; 4] = of_bars(0.0);
const DRY_ENGINE: [Connection; 4] = of_engine(0.1);
const EASY_ENGINE: [Connection; 4] = of_engine(0.0);

/// Each case, with the positions in which its motion begins.
const CASES: [(&str, &str, Cut, [f64; 3]); 4] = [
    ("four-bar linkage", FOUR_BAR, bars(&EASY_BARS), BARS_AT),
    ("four-bar linkage with friction", FOUR_BAR, bars(&DRY_BARS), BARS_AT),
    ("slider-crank", SLIDER_CRANK, engine(&EASY_ENGINE), ENGINE_AT),
    (
        "slider-crank with friction",
        SLIDER_CRANK,
        engine(&DRY_ENGINE),
        ENGINE_AT,
    ),
];

const BARS_AT: [f64; 3] = [0.5, 2.25, 4.75];
const ENGINE_AT: [f64; 3] = [0.25, 1.75, 5.5];

const fn bars(connections: &'static [Connection]) -> Cut {
    Cut {
        shape: Shape::FourBar,
        dimensions: &[0.9, 0.3, 0.8, 0.6],
        bodies: &BARS,
        connections,
        gravity: [0.0, -9.81],
        force: None,
        motion: [0.0, 12.0, -30.0, 200.0, 1500.0],
    }
}

const fn engine(connections: &'static [Connection]) -> Cut {
    Cut {
        shape: Shape::SliderCrank,
        dimensions: &[0.05, 0.16],
        bodies: &ENGINE,
        connections,
        gravity: [0.0, -9.81],
        force: Some((2, [-900.0, 0.0])),
        motion: [0.0, 90.0, -20.0, 500.0, -4000.0],
    }
}

const NUMBERS: [&str; 3] = ["x", "y", "moment"];

fn file() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/data/joint-forces.json")
}

/// A line with a number, its rates and their conditions.
fn line(text: &mut String, name: &str, rates: &Rates, conditions: &[f64], end: &str) {
    let rates: Vec<String> = rates.iter().map(written).collect();
    let conditions: Vec<String> = conditions.iter().map(|own| format!("{own:.2e}")).collect();
    let (rates, conditions) = (rates.join(", "), conditions.join(", "));
    writeln!(
        text,
        r#"          "{name}": {{ "rates": [{rates}], "conditions": [{conditions}] }}{end}"#
    )
    .expect("a text");
}

fn entry(text: &mut String, (name, declaration, cut, _): &(&str, &str, Cut, [f64; 3])) -> Result<(), std::fmt::Error> {
    writeln!(text, r#"      "name": "{name}","#)?;
    let lines: Vec<String> = declaration.lines().map(|line| format!(r#"        "{line}""#)).collect();
    writeln!(text, "      \"declaration\": [\n{}\n      ],", lines.join(",\n"))?;
    writeln!(text, r#"      "dimensions": {:?},"#, cut.dimensions)?;
    writeln!(text, r#"      "gravity": {:?},"#, cut.gravity)?;
    let bodies: Vec<String> = cut
        .bodies
        .iter()
        .map(|own| {
            let Body {
                name,
                mass,
                centre,
                inertia,
                ..
            } = own;
            format!(r#"        {{ "name": "{name}", "mass": {mass:?}, "centre": {centre:?}, "inertia": {inertia:?} }}"#)
        })
        .collect();
    writeln!(text, "      \"bodies\": [\n{}\n      ],", bodies.join(",\n"))?;
    let force = cut.force.map_or_else(String::new, |(_, force)| {
        format!(r#"{{ "at": "slider", "force": {force:?} }}"#)
    });
    writeln!(text, r#"      "forces": [{force}],"#)?;
    let rubbed = cut.connections.iter().filter(|own| own.coefficient > 0.0);
    let frictions: Vec<String> = rubbed
        .map(|own| {
            let radius = own
                .radius
                .map_or_else(String::new, |radius| format!(r#", "radius": {radius:?}"#));
            format!(
                r#"        {{ "joint": "{}", "coefficient": {:?}{radius} }}"#,
                own.name, own.coefficient
            )
        })
        .collect();
    if frictions.is_empty() {
        writeln!(text, r#"      "friction": [],"#)?;
    } else {
        writeln!(text, "      \"friction\": [\n{}\n      ],", frictions.join(",\n"))?;
    }
    Ok(())
}

/// The whole file.
fn recorded() -> Result<String, std::fmt::Error> {
    let mut text = String::from(
        r#"{
  "about": [
    "Forces in the joints of mechanisms of the plane, with two rates by time, to 20 digits.",
    "Bodies are cut free, and Newton's and Euler's equations are solved in Taylor series of 77 digits.",
    "Given numbers are the nearest of double precision. Units: m, kg, s, N, rad.",
    "A centre lies in the frame of its body, whose first axis leads from its first joint to its second one, or along x.",
    "The moment of inertia is that about the centre. The motion is that of the crank: angle, speed, and so on to snap.",
    "Of a four-bar linkage, the knee is at the left of the line from the pin to the pivot.",
    "A force acts on the body that is named, and the opposite one on its neighbour. The moment is that about the joint:",
    "that of friction in a pin, and that with which a guide keeps its slider from turning.",
    "A condition is the size of a number plus its change with each given number: a careful calculation in double",
    "precision is off by a few times 2.2e-16 of it."
  ],
  "cases": [
"#,
    );
    for (index, case) in CASES.iter().enumerate() {
        writeln!(text, "    {{")?;
        entry(&mut text, case)?;
        let (_, _, cut, starts) = case;
        writeln!(text, r#"      "positions": ["#)?;
        for (place, start) in starts.iter().enumerate() {
            let mut cut = *cut;
            cut.motion[0] = *start;
            let (found, conditions) = cut.forces();
            let mut conditions = conditions.chunks_exact(3);
            let mut next = || conditions.next().expect("as many as numbers");
            writeln!(text, "        {{\n          \"motion\": {:?},", cut.motion)?;
            for (own, forces) in cut.connections.iter().zip(&found.connections) {
                let [x, y] = [0, 1].map(|axis| written(&found.places[own.joint][axis]));
                writeln!(text, r#"          "{}_at": [{x}, {y}],"#, own.name)?;
                writeln!(text, r#"          "{}_on": "{}","#, own.name, cut.bodies[own.on].name)?;
                for (name, rates) in NUMBERS.iter().zip(forces) {
                    line(&mut text, &format!("{}_{name}", own.name), rates, next(), ",");
                }
            }
            line(&mut text, "torque", &found.torque, next(), ",");
            line(&mut text, "heat", &found.heat, next(), "");
            writeln!(text, "        }}{}", if place + 1 < starts.len() { "," } else { "" })?;
        }
        writeln!(
            text,
            "      ]\n    }}{}",
            if index + 1 < CASES.len() { "," } else { "" }
        )?;
    }
    text += "  ]\n}\n";
    Ok(text)
}

fn numbers(value: &Value) -> Vec<f64> {
    let numbers = value.as_array().expect("a list").iter();
    numbers.map(|number| number.as_f64().expect("a number")).collect()
}

/// The largest error, in roundings of the condition.
const WORST: f64 = 1.0;

#[test]
fn kin_finds_the_forces_of_the_reference() {
    let text = recorded().expect("a text");
    if std::env::var_os("KIN_RECORD").is_some() {
        fs::write(file(), &text).expect("it can be written");
    }
    assert!(
        fs::read_to_string(file()).expect("it is there") == text,
        "record it again"
    );
    let file: Value = serde_json::from_str(&text).expect("it is JSON");
    let mut count = 0;
    for case in file["cases"].as_array().expect("cases") {
        let lines = case["declaration"].as_array().expect("lines").iter();
        let lines: Vec<&str> = lines.map(|line| line.as_str().expect("a line")).collect();
        let mechanism = Mechanism::declare(&lines.join("\n")).expect("it is declared");
        let names: Vec<&str> = mechanism.description().parameters.iter().map(|own| own.name).collect();
        let dimensions: Vec<_> = names.into_iter().zip(numbers(&case["dimensions"])).collect();
        let linkage = mechanism.linkage(&dimensions).expect("its dimensions");
        let point = |value: &Value| {
            let point = numbers(value);
            Plane::new(point[0], point[1])
        };
        let each = |name: &str| case[name].as_array().expect("a list").clone();
        let text = |value: &Value| value.as_str().expect("a name").to_owned();
        let number = |value: &Value| value.as_f64().expect("a number");
        let mut loads = linkage.loads().gravity(point(&case["gravity"]));
        for body in each("bodies") {
            let (mass, inertia) = (number(&body["mass"]), number(&body["inertia"]));
            let centre = point(&body["centre"]);
            loads = loads
                .mass_of(&text(&body["name"]), mass, centre, inertia)
                .expect("a body");
        }
        for force in each("forces") {
            loads = loads
                .force(point(&force["force"]), &text(&force["at"]))
                .expect("a point");
        }
        let mut reactions = linkage.reactions(&loads).expect("its bodies are declared");
        for own in each("friction") {
            let coefficient = number(&own["coefficient"]);
            let friction = match own["radius"].as_f64() {
                Some(radius) => Friction::Pin { coefficient, radius },
                None => Friction::Slide {
                    coefficient,
                    length: None,
                },
            };
            reactions = reactions.friction(&text(&own["joint"]), friction).expect("a joint");
        }
        let mut worst = (0.0, String::new());
        for position in each("positions") {
            let motion = numbers(&position["motion"]);
            let motion = Motion::new(core::array::from_fn(|order| motion[order]));
            let found = reactions
                .at(&[motion], PositionChoice::Assembly(0))
                .expect("it is determined");
            let mut compare = |name: &str, own: [f64; 3]| {
                let expected = &position[name];
                let pairs = own
                    .into_iter()
                    .zip(numbers(&expected["rates"]))
                    .zip(numbers(&expected["conditions"]));
                for (order, ((own, expected), condition)) in pairs.enumerate() {
                    let difference = (own - expected).abs();
                    let roundings = if difference == 0.0 {
                        0.0
                    } else {
                        difference / (f64::EPSILON * condition)
                    };
                    if roundings > worst.0 {
                        worst = (roundings, format!("{name} {order}: {own} {expected}"));
                    }
                    count += 1;
                }
            };
            for (name, force) in found.all() {
                let force = force.expect("it is determined");
                assert_eq!(
                    reactions.bodies_of(name).expect("a joint")[0],
                    text(&position[&format!("{name}_on")])
                );
                compare(&format!("{name}_x"), force.x);
                compare(&format!("{name}_y"), force.y);
                compare(&format!("{name}_moment"), force.moment);
            }
            compare("torque", found.effort(0).expect("it is determined"));
            compare("heat", found.heat());
        }
        println!("{}: {:.1} roundings, {}", text(&case["name"]), worst.0, worst.1);
        assert!(worst.0 <= WORST, "{}", worst.1);
    }
    assert_eq!(count, 4 * 3 * (4 * 9 + 6));
}
