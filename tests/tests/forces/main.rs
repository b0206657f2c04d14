//! Joint forces beside the cases of `docs/data/joint-forces.json`, which the reference writes:
//!
//! ```sh
//! KIN_RECORD=1 cargo test -p kin-tests --test forces
//! ```

mod plane;
mod record;
mod space;

use std::fs;

use kin_core::any::{Described as _, Pictured as _, PositionChoice};
use kin_core::load::Solid;
use kin_core::prelude::*;
use kin_core::reaction::Friction;
use kin_live::Mechanism;
use record::{Case, cases, file, recorded};
use serde_json::Value;

fn numbers(value: &Value) -> Vec<f64> {
    let numbers = value.as_array().expect("a list").iter();
    numbers.map(|number| number.as_f64().expect("a number")).collect()
}

fn solid(mass: f64, centre: Space<f64>, inertia: &[f64]) -> Solid {
    let [xx, yy, zz, xy, xz, yz] = *inertia else {
        panic!("a tensor has six entries");
    };
    Solid {
        mass,
        centre,
        inertia: [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]],
    }
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
            Space::new(point[0], point[1], point.get(2).copied().unwrap_or(0.0))
        };
        let each = |name: &str| case[name].as_array().expect("a list").clone();
        let text = |value: &Value| value.as_str().expect("a name").to_owned();
        let number = |value: &Value| value.as_f64().expect("a number");
        let mut loads = linkage.loads().gravity(point(&case["gravity"]));
        for body in each("bodies") {
            let (name, mass, centre) = (text(&body["name"]), number(&body["mass"]), point(&body["centre"]));
            loads = match body["inertia"].as_f64() {
                Some(inertia) => loads.mass_of(&name, mass, centre, inertia),
                None => loads.solid_of(&name, solid(mass, centre, &numbers(&body["inertia"]))),
            }
            .expect("a body");
        }
        for force in each("forces") {
            loads = loads
                .force(point(&force["force"]), &text(&force["at"]))
                .expect("a point");
        }
        let mut reactions = linkage.reactions(&loads).expect("its bodies are declared");
        for own in each("hinges") {
            let axis = text(&own["axis"]);
            reactions = reactions.hinge(&text(&own["joint"]), axis.as_str()).expect("a joint");
        }
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
                if mechanism.is_space() {
                    compare(&format!("{name}_z"), force.z);
                    for (axis, moment) in ["x", "y", "z"].iter().zip(force.moments) {
                        compare(&format!("{name}_moment_{axis}"), moment);
                    }
                } else {
                    compare(&format!("{name}_moment"), force.moment);
                }
            }
            compare("torque", found.effort(0).expect("it is determined"));
            compare("heat", found.heat());
        }
        println!("{}: {:.1} roundings, {}", text(&case["name"]), worst.0, worst.1);
        assert!(worst.0 <= WORST, "{}", worst.1);
    }
    // value and rates of the parts of each force, of the torque and of the heat
    let parts = |case: &Case| 3 * (case.given.joints().len() * case.given.numbers().len() + 2);
    assert_eq!(
        count,
        cases().map(|case| case.starts.len() * parts(case)).sum::<usize>()
    );
}
