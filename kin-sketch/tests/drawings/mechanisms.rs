//! Mechanisms as people draw them.

use std::f64::consts::FRAC_PI_2;

use kin_core::any::Described;
use kin_core::library::{JansenLeg, WattI};
use kin_core::prelude::*;
use kin_live::Mechanism;
use kin_sketch::{Body, Drive, Sketch};

use super::{at, compare, drawn};

/// The product of two complex numbers.
fn turned(vector: Plane, unit: Plane) -> Plane {
    Plane::new(
        vector.x * unit.x - vector.y * unit.y,
        vector.x * unit.y + vector.y * unit.x,
    )
}

#[test]
fn four_bar() {
    let points = [
        ("o", 1.0, 1.0),
        ("a", 1.0, 3.0),
        ("b", 5.0, 5.0),
        ("d", 6.0, 1.0),
        ("c", 3.0, 6.0),
    ];
    let four_bar = drawn(&points, &["o", "d"], &[&["o", "a"], &["a", "b", "c"], &["d", "b"]]);
    let expected = "\
struct Drawn { r1: Length, r2: Length, r3: Length, r3_c: Vector, r4: Length }
input theta2: Angle;
unknown theta3: Angle, theta4: Angle;
let d = vec2(r1, 0);
let a = r2 * cis(theta2);
let b = a + r3 * cis(theta3);
b == d + r4 * cis(theta4);
output c: Point = a + r3_c * cis(theta3);
ground 0, d;
body link2: 0, a;
body link3: a, b, c;
body link4: d, b;
";
    assert_eq!(compare(&four_bar, &[0.4]).text, expected);
}

#[test]
fn slider_crank() {
    let points = [("o", 0.0, 0.0), ("a", 0.0, 1.0), ("b", 3.0, 0.0)];
    let mut sketch = drawn(&points, &["o"], &[&["o", "a"], &["a", "b"]]);
    sketch.slide(at(&sketch, "b"), Body::Ground, 0.0);
    let expected = "\
struct Drawn { r2: Length, r3: Length }
input theta2: Angle;
unknown theta3: Angle, s: Length;
let a = r2 * cis(theta2);
let b = a + r3 * cis(theta3);
b == vec2(s, 0);
ground 0;
body link2: 0, a;
body link3: a, b;
slide b along vec2(1, 0);
";
    assert_eq!(compare(&sketch, &[0.7]).text, expected);
    // a ram with a tool, its guide inclined, driven at the ram
    sketch.point("t", 5.0, 1.0);
    sketch.link("", &[2, 3]);
    sketch.slides[0].guided = Some(2);
    sketch.slides[0].direction = 0.2;
    compare(&sketch, &[0.7]);
    sketch.drives = vec![Drive::Slide(0)];
    compare(&sketch, &[0.2]);
    // upright
    sketch.slides[0].direction = FRAC_PI_2;
    compare(&sketch, &[0.1]);
}

#[test]
fn inverted_slider_crank() {
    let points = [("o", 0.0, 0.0), ("a", 0.0, 1.0), ("d", 3.0, 0.0), ("t", -3.0, 2.0)];
    let mut sketch = drawn(&points, &["o", "d"], &[&["o", "a"], &["d", "t"]]);
    sketch.slide(at(&sketch, "a"), Body::Link(1), (-1.0_f64).atan2(3.0));
    let text = compare(&sketch, &[0.7]).text;
    assert!(text.contains("a == d + s * cis(theta3);"), "{text}");
    sketch.slides[0].direction = 0.3;
    let text = compare(&sketch, &[0.7]).text;
    assert!(text.contains("a == d + vec2(s, offset_a) * cis(theta3);"), "{text}");
}

#[test]
fn watt_is_that_of_the_library() {
    let watt = WattI {
        r1: 4.0,
        r2: 1.5,
        r3: 3.5,
        r4: 3.0,
        p: Plane::new(1.2, 1.0),
        q: Plane::new(2.0, 1.5),
        r5: 2.5,
        r6: 2.0,
    };
    let assembly = WattI::ASSEMBLIES[0];
    let pose = watt.position(1.0, assembly).expect("it closes");
    let unit = |angle: f64| Plane::new(angle.cos(), angle.sin());
    let crank = unit(1.0);
    let a = crank * watt.r2;
    let b = a + unit(pose.theta3.value()) * watt.r3;
    let p = turned(watt.p, crank);
    let q = a + turned(watt.q, unit(pose.theta3.value()));
    let tool = pose.tool.value();
    let points = [
        ("o", 0.0, 0.0),
        ("d", watt.r1, 0.0),
        ("a", a.x, a.y),
        ("b", b.x, b.y),
        ("p", p.x, p.y),
        ("q", q.x, q.y),
    ];
    let mut points = points.to_vec();
    points.push(("t", tool.x, tool.y));
    let links: [&[&str]; 5] = [
        &["o", "a", "p"],
        &["a", "b", "q"],
        &["d", "b"],
        &["p", "t"],
        &["q", "t"],
    ];
    let sketch = drawn(&points, &["o", "d"], &links);
    let declaration = compare(&sketch, &[0.3]);
    let mechanism = Mechanism::declare(&declaration.text).expect("it is sound");
    let dimensions: Vec<_> = declaration
        .dimensions
        .iter()
        .map(|(name, value)| (&**name, *value))
        .collect();
    let linkage = mechanism.linkage(&dimensions).expect("all are given");
    let guess: Vec<f64> = declaration.unknowns.iter().map(|(_, value)| *value).collect();
    let start = declaration.inputs[0].1;
    let choice = linkage.assembly_at(&[start], &guess);
    for step in -4..=4 {
        let by = f64::from(step) * 0.1;
        let own = linkage.position(&[start + by], choice.position()).expect("it closes");
        let library = watt.position(1.0 + by, assembly).expect("it closes");
        // links 5 and 6 are numbered 5 and 6 in both
        for (name, expected) in [("theta5", library.theta5), ("theta6", library.theta6)] {
            let index = declaration
                .unknowns
                .iter()
                .position(|(own, _)| own == name)
                .expect("it is an unknown");
            let error = (own[index] - expected.value()).sin();
            assert!(error.abs() < 1e-12, "{name} at {by}: {error}");
        }
    }
}

#[test]
fn jansen_is_solved_dyad_by_dyad() {
    let leg = JansenLeg::HOLY_NUMBERS;
    let pose = leg.position(0.6, JansenLeg::WALKING).expect("it closes");
    let unit = |angle: f64| Plane::new(angle.cos(), angle.sin());
    let pivot = Plane::new(-leg.a, -leg.l);
    let pin = unit(0.6) * leg.m;
    let upper = pivot + unit(pose.angle_b.value()) * leg.b;
    let knee = pivot + unit(pose.angle_c.value()) * leg.c;
    let along = (leg.b.powi(2) + leg.d.powi(2) - leg.e.powi(2)) / (2.0 * leg.b);
    let beside = (leg.d.powi(2) - along.powi(2)).sqrt();
    let outer = pivot + turned(Plane::new(along, beside), unit(pose.angle_b.value()));
    let lower = knee + unit(pose.angle_g.value()) * leg.g;
    let foot = pose.foot.value();
    let points = [
        ("o", 0.0, 0.0),
        ("v", pivot.x, pivot.y),
        ("p", pin.x, pin.y),
        ("u", upper.x, upper.y),
        ("k", knee.x, knee.y),
        ("w", outer.x, outer.y),
        ("l", lower.x, lower.y),
        ("foot", foot.x, foot.y),
    ];
    let links: [&[&str]; 7] = [
        &["o", "p"],
        &["p", "u"],
        &["v", "u", "w"],
        &["p", "k"],
        &["v", "k"],
        &["w", "l"],
        &["k", "l", "foot"],
    ];
    let sketch = drawn(&points, &["o", "v"], &links);
    let declaration = compare(&sketch, &[0.5]);
    let mechanism = Mechanism::declare(&declaration.text).expect("it is sound");
    // three dyads, and no block of more than two equations
    let forms: Vec<&str> = mechanism
        .description()
        .blocks
        .iter()
        .map(|block| block.solution)
        .collect();
    assert_eq!(forms.len(), 3, "{forms:?}");
    assert!(
        forms
            .iter()
            .all(|form| form.contains("dyad") || form.contains("circle")),
        "{forms:?}"
    );
}

#[test]
fn klann_toggle_scissors_wiper() {
    // a Stephenson III six-bar: Klann's leg
    let points = [
        ("o", 0.0, 0.0),
        ("a", 0.5, 0.9),
        ("b", -1.6, 0.6),
        ("c", -3.4, -0.2),
        ("d", -1.2, -1.2),
        ("e", -2.6, 2.4),
        ("f", -5.0, -3.0),
        ("g", -1.0, 1.6),
    ];
    let links: [&[&str]; 5] = [
        &["o", "a"],
        &["a", "b", "c"],
        &["d", "b"],
        &["g", "e"],
        &["c", "e", "f"],
    ];
    compare(&drawn(&points, &["o", "d", "g"], &links), &[0.3]);
    // a toggle clamp: a handle, a knee, and a bar that presses
    let points = [
        ("o", 0.0, 0.0),
        ("a", 1.0, 3.0),
        ("b", 3.0, 2.5),
        ("d", 3.5, 0.0),
        ("tip", 7.0, 1.0),
    ];
    compare(
        &drawn(&points, &["o", "d"], &[&["o", "a"], &["a", "b"], &["d", "b", "tip"]]),
        &[0.1],
    );
    // a scissor lift of one stage: a fixed and a sliding foot, a table whose second end slides
    let points = [
        ("o", 0.0, 0.0),
        ("f", 4.0, 0.0),
        ("m", 2.0, 1.5),
        ("t", 0.0, 3.0),
        ("u", 4.0, 3.0),
        ("v", 5.0, 3.2),
    ];
    let mut lift = drawn(&points, &["o"], &[&["o", "m", "u"], &["f", "m", "t"], &["t", "v"]]);
    lift.slide(1, Body::Ground, 0.0);
    lift.slide(4, Body::Link(2), 0.0);
    compare(&lift, &[0.2]);
    lift.drives = vec![Drive::Slide(0)];
    compare(&lift, &[-0.3]);
    // an excavator's arm: a cylinder turns the boom, another one the arm
    let points = [
        ("o", 0.0, 0.0),
        ("b", 4.0, 3.0),
        ("h", 2.0, 1.8),
        ("c", 1.0, -0.5),
        ("t", 7.0, 0.5),
        ("e", 3.8, 4.0),
        ("r", 1.5, 2.6),
    ];
    let mut arm = drawn(
        &points,
        &["o", "c"],
        &[&["o", "h", "b", "r"], &["b", "t", "e"], &["c"], &["r"]],
    );
    let (boom, cylinder) = (0.0_f64.atan2(1.0), (1.8_f64 + 0.5).atan2(2.0 - 1.0));
    assert!(boom.abs() < cylinder);
    arm.slide(at(&arm, "h"), Body::Link(2), cylinder);
    arm.slide(at(&arm, "e"), Body::Link(3), (4.0_f64 - 2.6).atan2(3.8 - 1.5));
    arm.drives = vec![Drive::Slide(0), Drive::Slide(1)];
    let declaration = compare(&arm, &[0.2, -0.1]);
    assert_eq!(declaration.inputs.len(), 2);
}

#[test]
fn five_bar_and_serial_arm() {
    let points = [
        ("o", 0.0, 0.0),
        ("a", -1.0, 2.0),
        ("c", 1.5, 4.0),
        ("b", 4.0, 2.0),
        ("d", 3.0, 0.0),
    ];
    let mut five = drawn(
        &points,
        &["o", "d"],
        &[&["o", "a"], &["a", "c"], &["d", "b"], &["b", "c"]],
    );
    five.drives.push(Drive::Angle {
        of: 2,
        to: Body::Ground,
    });
    compare(&five, &[0.2, -0.3]);
    // an arm whose second drive counts from the first link; a dyad hangs on it
    let points = [
        ("o", 0.0, 0.0),
        ("a", 2.0, 1.0),
        ("b", 4.0, 0.5),
        ("t", 5.0, 3.0),
        ("d", 7.0, 0.0),
    ];
    let mut arm = drawn(
        &points,
        &["o", "d"],
        &[&["o", "a"], &["a", "b"], &["b", "t"], &["d", "t"]],
    );
    arm.drives.push(Drive::Angle {
        of: 1,
        to: Body::Link(0),
    });
    compare(&arm, &[0.2, -0.3]);
}

#[test]
fn coupled_loops_are_written_too() {
    // a class III triad: a ternary link on three rods, two of which stand on a crank each
    let points = [
        ("o", 0.0, 0.0),
        ("a", 0.5, 1.0),
        ("p", 1.0, 4.0),
        ("q", 4.0, 4.5),
        ("r", 3.0, 6.0),
        ("d", 5.0, 0.0),
        ("e", 7.0, 6.0),
    ];
    let links: [&[&str]; 5] = [&["o", "a"], &["a", "p"], &["p", "q", "r"], &["d", "q"], &["e", "r"]];
    let sketch = drawn(&points, &["o", "d", "e"], &links);
    compare(&sketch, &[0.1]);
}

#[test]
fn links_with_names() {
    let mut sketch = Sketch::new("Wiper");
    let [o, a, b, d, tip] = [
        ("o", 0.0, 0.0),
        ("a", 0.0, 40.0),
        ("b", 180.0, 60.0),
        ("d", 200.0, 0.0),
        ("tip", 150.0, 400.0),
    ]
    .map(|(name, x, y)| sketch.point(name, x, y));
    sketch.fix(o);
    sketch.fix(d);
    let crank = sketch.link("crank", &[o, a]);
    sketch.link("rod", &[a, b]);
    sketch.link("blade", &[d, b, tip]);
    sketch.drives.push(Drive::Angle {
        of: crank,
        to: Body::Ground,
    });
    let text = sketch.declaration().expect("it is sound").text;
    let expected = "\
struct Wiper { r1: Length, crank: Length, rod: Length, blade: Length, blade_tip: Vector }
input crank_angle: Angle;
unknown rod_angle: Angle, blade_angle: Angle;
let d = vec2(r1, 0);
let a = crank * cis(crank_angle);
let b = a + rod * cis(rod_angle);
b == d + blade * cis(blade_angle);
output tip: Point = d + blade_tip * cis(blade_angle);
ground 0, d;
body crank: 0, a;
body rod: a, b;
body blade: d, b, tip;
";
    assert_eq!(text, expected);
    Mechanism::declare(&text).expect("it is sound");
}
