//! The four-bar linkage with its symbols, its two assemblies, dyads, the torn triad, and a coupler curve.

use kin_core::library::{ClassThreeTriad, FourBar, HoekenLinkage};
use kin_core::prelude::*;
use kin_core::{Body, Outline, Slide};

use super::Figure;
use crate::drawing::{Canvas, GREY, Note, Scene, Style, canvas, draw};

/// The linkage of the figures.
const LINKAGE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 80.0,
    r4: 60.0,
};

/// A point of the plane.
fn at(x: f64, y: f64) -> Space {
    Space::new(x, y, 0.0)
}

/// The four-bar linkage with the names of its lengths and angles.
pub(super) fn four_bar() -> Result<Figure, SolveError> {
    let crank = 65_f64.to_radians();
    let pose = LINKAGE.position(crank, Assembly::Open)?;
    let [theta3, theta4] = pose.unknowns();
    let scene = Scene::of_mechanism(&LINKAGE, [crank], Assembly::Open)?;
    let [origin, pin, pivot] = [scene.joints[0], scene.joints[1], scene.joints[3]];
    let scene = scene
        .with(Note::Dashes {
            from: origin,
            to: pivot,
        })
        .with(Note::Angle {
            at: origin,
            angle: crank,
            text: "θ₂".to_owned(),
        })
        .with(Note::Angle {
            at: pin,
            angle: theta3,
            text: "θ₃".to_owned(),
        })
        .with(Note::Angle {
            at: pivot,
            angle: theta4,
            text: "θ₄".to_owned(),
        })
        .with(Note::Text {
            at: (origin + pivot).scale(0.5),
            text: "r1".to_owned(),
        });
    Ok(Figure {
        file: "four-bar.svg".to_owned(),
        svg: draw(&scene, &Style::default()),
    })
}

/// Several drawings side by side, each with its title.
fn row(file: &str, title: &str, scenes: &[(&str, Scene)], width: f64, height: f64) -> Figure {
    let mut all = Canvas::default();
    let mut left = 0.0;
    for (title, scene) in scenes {
        let style = Style {
            width,
            height,
            title: (*title).to_owned(),
            names: true,
        };
        all.place(&canvas(scene, &style), Plane::new(left, 0.0));
        left += width;
    }
    Figure {
        file: file.to_owned(),
        svg: all.finish(left, height, title),
    }
}

/// The two assemblies of one crank angle.
pub(super) fn open_and_crossed() -> Result<Figure, SolveError> {
    let crank = 65_f64.to_radians();
    let scenes = [
        (
            "Assembly::Open",
            Scene::of_mechanism(&LINKAGE, [crank], Assembly::Open)?,
        ),
        (
            "Assembly::Crossed",
            Scene::of_mechanism(&LINKAGE, [crank], Assembly::Crossed)?,
        ),
    ];
    Ok(row(
        "open-and-crossed.svg",
        "The two assemblies of a four-bar linkage",
        &scenes,
        330.0,
        300.0,
    ))
}

/// A scene of a dyad by itself.
fn dyad(outline: Outline, joints: &[Space], directions: &[Space]) -> Scene {
    Scene {
        outline,
        joints: joints.to_vec(),
        directions: directions.to_vec(),
        is_plane: true,
        sweep: Vec::new(),
        drives: Vec::new(),
        notes: Vec::new(),
    }
}

/// The three dyads with a closed form; their outer joints are given.
pub(super) fn dyads() -> Figure {
    let turning = const {
        Outline {
            ground: &[],
            bodies: &[Body::new("a", &[0, 1]), Body::new("b", &[1, 2])],
            slides: &[],
            points: &[("P", 0), ("Q", 2)],
            scalar_equations: &[],
            guess: None,
        }
    };
    let at_the_end = const {
        Outline {
            ground: &[],
            bodies: &[Body::new("a", &[0, 1])],
            slides: &[Slide::on_ground(1)],
            points: &[("P", 0)],
            scalar_equations: &[],
            guess: None,
        }
    };
    let in_the_middle = const {
        Outline {
            ground: &[],
            bodies: &[Body::new("lever", &[0, 2])],
            slides: &[Slide::on_body(1, 0)],
            points: &[("P", 0), ("Q", 1)],
            scalar_equations: &[],
            guess: None,
        }
    };
    let lever = at(3.0, 1.2);
    let mut swept = dyad(at_the_end, &[at(0.0, 2.0), at(2.8, 0.0)], &[at(1.0, 0.0)]);
    swept.sweep = [1.8, 2.8, 3.8]
        .map(|x| vec![at(0.0, 2.0), at(x, 0.0), at(1.0, 0.0)])
        .to_vec();
    let scenes = [
        ("RRR", dyad(turning, &[at(0.0, 0.0), at(1.4, 2.0), at(3.6, 0.6)], &[])),
        ("RRP", swept),
        (
            "RPR",
            dyad(in_the_middle, &[at(0.0, 0.0), lever, lever.scale(1.3)], &[lever]),
        ),
    ];
    row("dyads.svg", "The dyads RRR, RRP and RPR", &scenes, 240.0, 220.0)
}

/// The class III triad with one joint taken apart.
pub(super) fn torn_triad() -> Figure {
    let root = 3.0_f64.sqrt();
    let triad: ClassThreeTriad = ClassThreeTriad {
        base_b: Plane::new(4.0 * root, 0.0),
        base_c: Plane::new(2.0 * root, 6.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    // two legs and the platform close; the third leg ends elsewhere
    let (first, platform) = (at(2.3, 1.6), 0.25_f64);
    let rotated = |vector: Plane| {
        let turned = vector.times(Plane::cis(platform));
        at(turned.x, turned.y)
    };
    let [base_b, base_c] = [triad.base_b, triad.base_c].map(|base| at(base.x, base.y));
    let [second, third] = [triad.platform_b, triad.platform_c].map(|corner| first + rotated(corner));
    let loose = at(3.9, 3.6);
    let outline = const {
        Outline {
            ground: &[0, 1, 2],
            bodies: &[
                Body::new("first leg", &[0, 3]),
                Body::new("second leg", &[1, 4]),
                Body::new("third leg", &[2, 6]),
                Body::new("platform", &[3, 4, 5]),
            ],
            slides: &[],
            points: &[("on the platform", 5), ("on the leg", 6)],
            scalar_equations: &[],
            guess: None,
        }
    };
    let mut scene = dyad(
        outline,
        &[at(0.0, 0.0), base_b, base_c, first, second, third, loose],
        &[],
    );
    scene.notes = vec![Note::Dashes { from: third, to: loose }];
    let style = Style {
        title: "What Newton's method closes: one joint taken apart".to_owned(),
        ..Style::default()
    };
    Figure {
        file: "torn-triad.svg".to_owned(),
        svg: draw(&scene, &style),
    }
}

/// Hoeken's linkage with the path of its tracer.
pub(super) fn coupler_curve() -> Result<Figure, SolveError> {
    let linkage: HoekenLinkage = HoekenLinkage::PUBLISHED;
    let scene = Scene::of_mechanism(&linkage, [1.2], Assembly::Open)?;
    Ok(Figure {
        file: "coupler-curve.svg".to_owned(),
        svg: draw(&scene, &Style::default()),
    })
}

/// From a declaration to Rust: the rooms of the macro in their order.
pub(super) fn pipeline() -> Figure {
    let (width, height) = (860.0, 250.0);
    let boxes = [
        ("syntax", "tokens to tree"),
        ("model", "names, dimensions"),
        ("structure", "blocks, closed forms"),
        ("plan", "the cheapest way"),
        ("emit", "Rust, item by item"),
    ];
    let tried = [
        ("derive", "rates, Jacobians"),
        ("assemble", "steps of positions"),
        ("schedule", "straight-line code"),
    ];
    let mut page = Canvas::default();
    let (wide, high) = (132.0, 46.0);
    let frame = |page: &mut Canvas, at: Plane, (name, what): (&str, &str)| {
        let corners = [
            at,
            at + Plane::new(wide, 0.0),
            at + Plane::new(wide, high),
            at + Plane::new(0.0, high),
        ];
        page.path(&corners, true, r##"fill="#eceff1" stroke="#222222" stroke-width="1""##);
        let middle = at + Plane::new(0.5 * wide, 19.0);
        page.text(middle, 13.0, "middle", r#"font-weight="bold""#, name);
        page.text(middle + Plane::new(0.0, 17.0), 11.0, "middle", "", what);
    };
    let arrow = |page: &mut Canvas, from: Plane, to: Plane| {
        page.line(from, to, GREY, 1.2);
        page.arrow_head(to, from, GREY);
    };
    let (top, step) = (30.0, 168.0);
    let mut left = 28.0;
    for (index, item) in boxes.into_iter().enumerate() {
        frame(&mut page, Plane::new(left, top), item);
        if index > 0 {
            arrow(
                &mut page,
                Plane::new(left - step + wide, top + 0.5 * high),
                Plane::new(left, top + 0.5 * high),
            );
        }
        left += step;
    }
    // the plan tries several ways through three rooms
    let mut left = 28.0 + step;
    let below = 150.0;
    for (index, item) in tried.into_iter().enumerate() {
        frame(&mut page, Plane::new(left + step, below), item);
        if index > 0 {
            arrow(
                &mut page,
                Plane::new(left + wide, below + 0.5 * high),
                Plane::new(left + step, below + 0.5 * high),
            );
        }
        left += step;
    }
    let plan = Plane::new(28.0 + 3.0 * step + 0.5 * wide, top + high);
    arrow(
        &mut page,
        plan - Plane::new(20.0, 0.0),
        Plane::new(28.0 + 2.0 * step + 0.5 * wide, below),
    );
    arrow(
        &mut page,
        Plane::new(28.0 + 4.0 * step + 0.5 * wide, below),
        plan + Plane::new(20.0, 0.0),
    );
    page.text(
        Plane::new(28.0 + 3.0 * step + 0.5 * wide, 125.0),
        11.0,
        "middle",
        "",
        "several ways, counted",
    );
    // the closure and the skeleton skip the middle language
    frame(&mut page, Plane::new(28.0, below), ("translate", "closure, skeleton"));
    let tree = Plane::new(28.0 + 0.5 * wide, top + high);
    arrow(&mut page, tree, Plane::new(28.0 + 0.5 * wide, below));
    page.text(
        Plane::new(28.0, 222.0),
        11.0,
        "start",
        "",
        "operator by operator, to Rust",
    );
    Figure {
        file: "macro-pipeline.svg".to_owned(),
        svg: page.finish(width, height, "From a declaration to Rust"),
    }
}
