//! Trees of links drawn at random: the text of their declarations, and of their closures over the campaign's series.
//!
//! The contribution of a part is written twice, as a person would write the equation and as operations on series, so that neither text
//! follows from the other. The text lies in `drawn.rs`; a test holds it to be what the seed draws.

use std::fmt::Write;

use kin_tests::random::Random;

use crate::draw::choice;

/// How many trees there are, and of how many parts each.
const TREES: usize = 3;
const PARTS: usize = 4;

const SEED: u64 = 40;

/// A quantity by its name in the declaration and by its expression in the closure.
#[derive(Clone)]
struct Named {
    name: String,
    series: String,
}

/// Where parts may hang.
#[derive(Clone)]
enum Carrier {
    /// Any points of a link: the joint about which it turns, one on the ground if there is none, and its angle.
    Link(Option<Named>, Named),
    /// The end of a slide.
    Slide(Named),
}

/// A part that hangs on points and angles of those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    /// Two links.
    Dyad,
    /// A link whose end slides along a line.
    Slider,
    /// A rod through a swivel.
    Lever,
    /// A gear, geared to a link.
    Gear,
    /// A spatial rocker, coupled to a link by a rod with ball joints.
    Spatial,
    /// A plate on three links.
    Plate,
}

impl Part {
    const ALL: [Self; 6] = [
        Self::Dyad,
        Self::Slider,
        Self::Lever,
        Self::Gear,
        Self::Spatial,
        Self::Plate,
    ];
}

/// A tree so far.
struct Tree {
    random: Random,
    parameters: Vec<String>,
    /// How many scalars the parameters have.
    scalars: usize,
    unknowns: Vec<String>,
    declaration: String,
    closure: String,
    /// How many points have names.
    points: usize,
    carriers: Vec<Carrier>,
    angles: Vec<Named>,
    parts: Vec<Part>,
}

impl Tree {
    /// A crank alone.
    fn new(random: Random) -> Self {
        let theta = Named {
            name: "theta".into(),
            series: "q[0]".into(),
        };
        Self {
            random,
            parameters: Vec::new(),
            scalars: 0,
            unknowns: Vec::new(),
            declaration: String::new(),
            closure: String::new(),
            points: 0,
            carriers: vec![Carrier::Link(None, theta.clone())],
            angles: vec![theta],
            parts: Vec::new(),
        }
    }

    fn parameter(&mut self, kind: &str) -> Named {
        let name = format!("a{}", self.parameters.len());
        let place = self.scalars;
        let (scalars, series) = match kind {
            "Point" | "Vector" => (2, format!("Flat::new(&p[{place}..])")),
            "Point3" | "Vector3" => (3, format!("Spatial::new(&p[{place}..])")),
            _ => (1, format!("p[{place}]")),
        };
        self.scalars += scalars;
        self.parameters.push(format!("pub {name}: {kind}"));
        Named { name, series }
    }

    fn unknown(&mut self, kind: &str) -> Named {
        let place = self.unknowns.len();
        let unknown = Named {
            name: format!("x{place}"),
            series: format!("u[{place}]"),
        };
        self.unknowns.push(format!("{}: {kind}", unknown.name));
        unknown
    }

    /// Notes a link that may carry others.
    fn link(&mut self, joint: Option<Named>, angle: &Named) {
        self.carriers.push(Carrier::Link(joint, angle.clone()));
        self.angles.push(angle.clone());
    }

    /// Gives a point of a carrier a name, the same in both texts.
    fn point(&mut self, carrier: &Carrier) -> Named {
        let name = format!("point{}", self.points);
        self.points += 1;
        let point = match carrier {
            Carrier::Slide(end) => end.clone(),
            Carrier::Link(joint, angle) => {
                let joint = joint.clone().unwrap_or_else(|| self.parameter("Point"));
                let arm = self.parameter("Vector");
                Named {
                    name: format!("{} + {} * cis({})", joint.name, arm.name, angle.name),
                    series: format!("{}.plus({}.turned({}))", joint.series, arm.series, angle.series),
                }
            }
        };
        let _ = writeln!(self.declaration, "    let {name} = {};", point.name);
        let _ = writeln!(self.closure, "    let {name} = {};", point.series);
        Named {
            series: name.clone(),
            name,
        }
    }

    fn equation(&mut self, declared: &str, series: &str) {
        let _ = writeln!(self.declaration, "    {declared};");
        let _ = writeln!(self.closure, "    rows.extend({series});");
    }

    /// So many points, no two the same: the first moves, the others may be on the ground.
    fn anchors<const N: usize>(&mut self) -> [Named; N] {
        let mut slides = Vec::new();
        std::array::from_fn(|index| {
            let place = choice(&mut self.random, self.carriers.len());
            let carrier = self.carriers[place].clone();
            if slides.contains(&place) || index > 0 && choice(&mut self.random, 2) == 0 {
                return self.parameter("Point");
            }
            if matches!(carrier, Carrier::Slide(_)) {
                slides.push(place);
            }
            self.point(&carrier)
        })
    }

    fn angle(&mut self) -> Named {
        self.angles[choice(&mut self.random, self.angles.len())].clone()
    }

    fn add(&mut self, part: Part) {
        self.parts.push(part);
        match part {
            Part::Dyad => {
                let [one, other] = self.anchors();
                let [a, b] = [(); 2].map(|()| self.parameter("Length"));
                let [x, y] = [(); 2].map(|()| self.unknown("Angle"));
                self.equation(
                    &format!(
                        "{} + {} * cis({}) == {} + {} * cis({})",
                        one.name, a.name, x.name, other.name, b.name, y.name
                    ),
                    &format!(
                        "{}.plus(polar({}, {})).minus({}.plus(polar({}, {}))).0",
                        one.series, a.series, x.series, other.series, b.series, y.series
                    ),
                );
                self.link(Some(one), &x);
                self.link(Some(other), &y);
            }
            Part::Slider => {
                let [start] = self.anchors();
                let [rod, base, line] = ["Length", "Point", "Angle"].map(|kind| self.parameter(kind));
                let [x, s] = ["Angle", "Length"].map(|kind| self.unknown(kind));
                let slide = Named {
                    name: format!("{} + {} * cis({})", base.name, s.name, line.name),
                    series: format!("{}.plus(polar({}, {}))", base.series, s.series, line.series),
                };
                self.equation(
                    &format!("{} + {} * cis({}) == {}", start.name, rod.name, x.name, slide.name),
                    &format!(
                        "{}.plus(polar({}, {})).minus({}).0",
                        start.series, rod.series, x.series, slide.series
                    ),
                );
                self.link(Some(start), &x);
                self.carriers.push(Carrier::Slide(slide));
            }
            Part::Lever => {
                let [end, swivel] = self.anchors();
                let [s, x] = ["Length", "Angle"].map(|kind| self.unknown(kind));
                self.equation(
                    &format!("{} == {} + {} * cis({})", end.name, swivel.name, s.name, x.name),
                    &format!(
                        "{}.minus({}.plus(polar({}, {}))).0",
                        end.series, swivel.series, s.series, x.series
                    ),
                );
                self.link(Some(swivel), &x);
            }
            Part::Gear => {
                let angle = self.angle();
                let [ratio, phase] = ["Scalar", "Angle"].map(|kind| self.parameter(kind));
                let x = self.unknown("Angle");
                self.equation(
                    &format!("{} == {} * {} + {}", x.name, ratio.name, angle.name, phase.name),
                    &format!(
                        "[{} - {} * {} - {}]",
                        x.series, ratio.series, angle.series, phase.series
                    ),
                );
                self.link(None, &x);
            }
            Part::Spatial => {
                let angle = self.angle();
                let [throw, stand, axis, swing, rod] =
                    ["Length", "Point3", "Vector3", "Vector3", "Length"].map(|kind| self.parameter(kind));
                let x = self.unknown("Angle");
                let coupler = format!("coupler{}", self.parts.len());
                let _ = writeln!(
                    self.declaration,
                    "    let {coupler} = {} + rot({}, {}) * {} - rot_z({}) * vec3({}, 0, 0);",
                    stand.name, axis.name, x.name, swing.name, angle.name, throw.name
                );
                let _ = writeln!(
                    self.closure,
                    "    let {coupler} = {}.plus({}.turned({}, {})).minus(Spatial::flat(polar({}, {})));",
                    stand.series, swing.series, axis.series, x.series, throw.series, angle.series
                );
                self.equation(
                    &format!("dot({coupler}, {coupler}) == {}.powi(2)", rod.name),
                    &format!("[{coupler}.dot({coupler}) - {0} * {0}]", rod.series),
                );
                self.angles.push(x);
            }
            Part::Plate => {
                let [one, two, three] = self.anchors();
                let [a, b, c] = [(); 3].map(|()| self.parameter("Length"));
                let [second, third] = [(); 2].map(|()| self.parameter("Vector"));
                let [x, y, z, plate] = [(); 4].map(|()| self.unknown("Angle"));
                for (corner, other, length, angle) in [(&second, &two, &b, &y), (&third, &three, &c, &z)] {
                    self.equation(
                        &format!(
                            "{} + {} * cis({}) + {} * cis({}) == {} + {} * cis({})",
                            one.name, a.name, x.name, corner.name, plate.name, other.name, length.name, angle.name
                        ),
                        &format!(
                            "{}.plus(polar({}, {})).plus({}.turned({})).minus({}.plus(polar({}, {}))).0",
                            one.series,
                            a.series,
                            x.series,
                            corner.series,
                            plate.series,
                            other.series,
                            length.series,
                            angle.series
                        ),
                    );
                }
                self.link(Some(two), &y);
            }
        }
    }

    fn text(&self, number: usize) -> String {
        format!(
            "
mechanism! {{
    /// {:?}.
    pub struct Drawn{number} {{
        {},
    }}
    input theta: Angle;
    unknown {};

{}}}

pub(super) fn closure{number}(p: &[Taylor], q: &[Taylor], u: &[Taylor]) -> Vec<Taylor> {{
    let mut rows = Vec::new();
{}    rows
}}
",
            self.parts,
            self.parameters.join(",\n        "),
            self.unknowns.join(", "),
            self.declaration,
            self.closure,
        )
    }
}

/// The text of `drawn.rs`.
fn text() -> String {
    let mut text = String::from(
        "//! Trees of links, written by `generator.rs`.

use kin_core::mechanism;

use crate::taylor::Taylor;
use crate::vectors::{Flat, Spatial, polar};
",
    );
    for number in 0..TREES {
        let mut tree = Tree::new(Random::new(SEED + number as u64));
        for _ in 0..PARTS {
            let part = Part::ALL[choice(&mut tree.random, Part::ALL.len())];
            tree.add(part);
        }
        text += &tree.text(number);
    }
    text
}

#[test]
fn the_trees_are_those_that_the_seed_draws() {
    let text = text();
    for part in Part::ALL {
        assert!(text.contains(&format!("{part:?}")), "no tree has a {part:?}");
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/campaign/drawn.rs");
    if std::env::var_os("KIN_CAMPAIGN_WRITE").is_some() {
        std::fs::write(path, &text).expect("the file can be written");
    }
    let written = std::fs::read_to_string(path).expect("the file is there");
    assert!(
        written.replace('\r', "") == text,
        "drawn.rs is another; KIN_CAMPAIGN_WRITE=1 writes it anew"
    );
}
