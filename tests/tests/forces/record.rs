//! The file of all cases, as the reference writes it.

use std::fmt::{self, Write as _};
use std::path::PathBuf;

use kin_tests::reference::{Body, Connection, Cut, Forces, Inertia, Rates, Solid, SpaceCut, SpaceShape, written};

use super::{plane, space};

/// A case, with the positions in which its motion begins.
pub(super) struct Case {
    pub(super) name: &'static str,
    pub(super) declaration: &'static str,
    pub(super) given: Given,
    pub(super) starts: [f64; 3],
}

/// What is given: a mechanism of the plane, or one of space with the hinges of which the declaration has one point.
pub(super) enum Given {
    Plane(Cut),
    Space(SpaceCut, &'static [(&'static str, &'static str)]),
}

pub(super) fn file() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/data/joint-forces.json")
}

pub(super) fn cases() -> impl Iterator<Item = &'static Case> {
    plane::CASES.iter().chain(&space::CASES)
}

/// A joint with a force: its name, its place among the joints, and the body on which the force acts.
type Held = (&'static str, usize, &'static str);

impl Given {
    /// The names of the coordinates of a force and of its moment.
    pub(super) fn numbers(&self) -> &'static [&'static str] {
        match self {
            Self::Plane(_) => &["x", "y", "moment"],
            Self::Space(..) => &["x", "y", "z", "moment_x", "moment_y", "moment_z"],
        }
    }

    pub(super) fn joints(&self) -> Vec<Held> {
        match self {
            Self::Plane(cut) => {
                let all = cut.connections.iter();
                all.map(|own| (own.name, own.joint, cut.bodies[own.on].name)).collect()
            }
            Self::Space(cut, _) => {
                let all = cut.joints.iter();
                all.map(|own| (own.name, own.joint, cut.bodies[own.on].name)).collect()
            }
        }
    }

    /// The motion from a position on, and its forces with their conditions.
    fn from(&self, start: f64) -> ([f64; 5], Forces, Vec<f64>) {
        let begun = |motion: [f64; 5]| [start, motion[1], motion[2], motion[3], motion[4]];
        match *self {
            Self::Plane(mut cut) => {
                cut.motion = begun(cut.motion);
                let (found, conditions) = cut.forces();
                (cut.motion, found, conditions)
            }
            Self::Space(mut cut, _) => {
                cut.motion = begun(cut.motion);
                let (found, conditions) = cut.forces();
                (cut.motion, found, conditions)
            }
        }
    }

    fn bodies(&self) -> Vec<String> {
        match self {
            Self::Plane(cut) => cut.bodies.iter().map(of_plane).collect(),
            Self::Space(cut, _) => cut.bodies.iter().map(of_space).collect(),
        }
    }

    fn forces(&self) -> Vec<String> {
        let line = |at: &str, force: &[f64]| format!(r#"{{ "at": "{at}", "force": {force:?} }}"#);
        match self {
            Self::Plane(cut) => cut.force.iter().map(|(_, force)| line("slider", force)).collect(),
            Self::Space(cut, _) => {
                let (.., force) = cut.force;
                let at = if matches!(cut.shape, SpaceShape::Rssr) {
                    "tip"
                } else {
                    "beside"
                };
                vec![line(at, &force)]
            }
        }
    }

    fn friction(&self) -> Vec<String> {
        let Self::Plane(cut) = self else { return Vec::new() };
        let rubbed = cut.connections.iter().filter(|own| own.coefficient > 0.0);
        let line = |own: &Connection| {
            let radius = own.radius.map(|radius| format!(r#", "radius": {radius:?}"#));
            let (name, radius) = (own.name, radius.unwrap_or_default());
            format!(
                r#"{{ "joint": "{name}", "coefficient": {:?}{radius} }}"#,
                own.coefficient
            )
        };
        rubbed.map(line).collect()
    }

    fn hinges(&self) -> Vec<String> {
        let Self::Space(_, hinges) = self else {
            return Vec::new();
        };
        let line = |(name, axis): &(&str, &str)| format!(r#"{{ "joint": "{name}", "axis": "{axis}" }}"#);
        hinges.iter().map(line).collect()
    }
}

fn of_plane(
    Body {
        name,
        mass,
        centre,
        inertia,
        ..
    }: &Body,
) -> String {
    format!(r#"{{ "name": "{name}", "mass": {mass:?}, "centre": {centre:?}, "inertia": {inertia:?} }}"#)
}

fn of_space(
    Solid {
        name,
        mass,
        centre,
        inertia,
        ..
    }: &Solid,
) -> String {
    let inertia = match inertia {
        Inertia::Rod(across) => format!("{across:?}"),
        Inertia::Tensor(tensor) => format!("{tensor:?}"),
    };
    format!(r#"{{ "name": "{name}", "mass": {mass:?}, "centre": {centre:?}, "inertia": {inertia} }}"#)
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

/// A member that is a list, with a line for each entry.
fn list(text: &mut String, name: &str, entries: &[String]) -> fmt::Result {
    if entries.is_empty() {
        return writeln!(text, r#"      "{name}": [],"#);
    }
    let lines: Vec<String> = entries.iter().map(|entry| format!("        {entry}")).collect();
    writeln!(text, "      \"{name}\": [\n{}\n      ],", lines.join(",\n"))
}

fn entry(text: &mut String, case: &Case) -> fmt::Result {
    let (dimensions, gravity): (&[f64], &[f64]) = match &case.given {
        Given::Plane(cut) => (cut.dimensions, &cut.gravity),
        Given::Space(cut, _) => (cut.dimensions, &cut.gravity),
    };
    let declaration: Vec<String> = case.declaration.lines().map(|line| format!(r#""{line}""#)).collect();
    writeln!(text, r#"      "name": "{}","#, case.name)?;
    list(text, "declaration", &declaration)?;
    writeln!(text, r#"      "dimensions": {dimensions:?},"#)?;
    writeln!(text, r#"      "gravity": {gravity:?},"#)?;
    list(text, "bodies", &case.given.bodies())?;
    list(text, "hinges", &case.given.hinges())?;
    list(text, "forces", &case.given.forces())?;
    list(text, "friction", &case.given.friction())?;
    writeln!(text, r#"      "positions": ["#)?;
    for (place, start) in case.starts.iter().enumerate() {
        let (motion, found, conditions) = case.given.from(*start);
        let mut conditions = conditions.chunks_exact(3);
        let mut next = || conditions.next().expect("as many as numbers");
        writeln!(text, "        {{\n          \"motion\": {motion:?},")?;
        for ((name, joint, on), forces) in case.given.joints().into_iter().zip(&found.connections) {
            let at: Vec<String> = found.places[joint].iter().map(written).collect();
            writeln!(text, r#"          "{name}_at": [{}],"#, at.join(", "))?;
            writeln!(text, r#"          "{name}_on": "{on}","#)?;
            for (number, rates) in case.given.numbers().iter().zip(forces) {
                line(text, &format!("{name}_{number}"), rates, next(), ",");
            }
        }
        line(text, "torque", &found.torque, next(), ",");
        line(text, "heat", &found.heat, next(), "");
        writeln!(
            text,
            "        }}{}",
            if place + 1 < case.starts.len() { "," } else { "" }
        )?;
    }
    writeln!(text, "      ]")
}

/// The whole file.
pub(super) fn recorded() -> Result<String, fmt::Error> {
    let mut text = String::from(
        r#"{
  "about": [
    "Forces in the joints of mechanisms of the plane and of space, with two rates by time, to 20 digits.",
    "Bodies are cut free, and Newton's and Euler's equations are solved in Taylor series of 77 digits.",
    "Given numbers are the nearest of double precision. Units: m, kg, s, N, rad.",
    "Points and vectors are given by their coordinates. The motion is that of the crank: angle, speed, up to snap.",
    "A centre lies in the frame of its body, whose first axis leads from its first joint to its second one, or along",
    "x. In space, its third joint lies on the side of the second axis. Inertia is about the centre, along these axes:",
    "one moment in the plane, and across the line of a rod; else the entries xx, yy, zz, xy, xz and yz of the tensor.",
    "Bodies with two points in common have a hinge, with one a ball; a hinge with one is listed with its axis.",
    "Of a four-bar linkage, the knee is at the left of the line from the pin to the pivot. Of the linkage RSSR, the",
    "ball would move away from the pin if phi grew alone; of RSSP, the block is as far along the rail as the rod lets",
    "it. A force acts on the body that is named, and the opposite one on its neighbour. The moment is that about the",
    "joint: that of friction in a pin, across the axis of a hinge, and that with which a guide keeps its slider from",
    "turning. A condition is the size of a number plus its change with each given number: a careful calculation in",
    "double precision is off by a few times 2.2e-16 of it."
  ],
  "cases": [
"#,
    );
    for (index, case) in cases().enumerate() {
        writeln!(text, "    {{")?;
        entry(&mut text, case)?;
        writeln!(text, "    }}{}", if index + 1 < cases().count() { "," } else { "" })?;
    }
    text += "  ]\n}\n";
    Ok(text)
}
