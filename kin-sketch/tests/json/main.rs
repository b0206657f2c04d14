//! Drawings in JSON: their form, the way there and back, and drawings that no person would draw.
#![allow(missing_docs, reason = "tests")]

use std::cell::Cell;

use kin_live::Mechanism;
use kin_sketch::{Body, Drive, Sketch, SketchLink, SketchPoint, SketchSlide};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};

fn ram() -> (Sketch, Value) {
    let mut sketch = Sketch::new("Ram");
    let [o, a, b] = [("o", 0.0, 0.0), ("a", 0.0, 1.0), ("b", 3.0, 0.0)].map(|(name, x, y)| sketch.point(name, x, y));
    sketch.fix(o);
    let crank = sketch.link("crank", &[o, a]);
    sketch.link("", &[a, b]);
    let ram = sketch.link("ram", &[b]);
    let slide = sketch.slide(b, Body::Ground, 0.25);
    sketch.slides[slide].guided = Some(ram);
    sketch.slide(o, Body::Link(ram), 0.0);
    let to = Body::Ground;
    sketch.drives = vec![Drive::Angle { of: crank, to }, Drive::Slide(slide)];
    let json = json!({
        "name": "Ram",
        "points": [
            {"name": "o", "x": 0.0, "y": 0.0},
            {"name": "a", "x": 0.0, "y": 1.0},
            {"name": "b", "x": 3.0, "y": 0.0},
        ],
        "ground": [0],
        "links": [
            {"name": "crank", "points": [0, 1]},
            {"name": "", "points": [1, 2]},
            {"name": "ram", "points": [2]},
        ],
        "slides": [
            {"point": 2, "on": "ground", "direction": 0.25, "guided": 2},
            {"point": 0, "on": 2, "direction": 0.0, "guided": null},
        ],
        "drives": [{"angle": {"of": 0, "to": "ground"}}, {"slide": 0}],
    });
    (sketch, json)
}

#[test]
fn form_is_readable() {
    let (sketch, json) = ram();
    assert_eq!(serde_json::to_value(&sketch).expect("it is finite"), json);
    assert_eq!(serde_json::from_value::<Sketch>(json).expect("it is a drawing"), sketch);
    let empty: Sketch = serde_json::from_str("{}").expect("every list may be left out");
    assert_eq!(empty, Sketch::default());
}

#[test]
fn texts_that_are_no_drawings() {
    let mistake = |text: &str| {
        serde_json::from_str::<Sketch>(text)
            .expect_err("it is no drawing")
            .to_string()
    };
    assert!(mistake(r#"{"pins": []}"#).contains("unknown field `pins`"));
    assert!(mistake(r#"{"ground": [-1]}"#).contains("invalid value"));
    assert!(mistake(r#"{"ground": [99999999999999999999]}"#).contains("invalid type"));
    let slide = r#"{"slides": [{"point": 0, "on": "air", "direction": 0}]}"#;
    assert!(mistake(slide).contains(r#"a body is "ground" or the index of a link"#));
    assert!(mistake(r#"{"points": [{"name": "o", "x": 1e999, "y": 0}]}"#).contains("out of range"));
}

#[test]
fn declaration_and_faults() {
    let (mut sketch, _) = ram();
    sketch.slides.pop();
    sketch.drives.pop();
    let declared = serde_json::to_value(sketch.declaration().expect("it moves")).expect("it is finite");
    assert_eq!(declared["dimensions"][0], json!(["crank", 1.0]));
    assert!(
        declared["text"]
            .as_str()
            .is_some_and(|text| text.starts_with("struct Ram"))
    );

    sketch.drives.push(Drive::Slide(7));
    let faults = sketch.declaration().expect_err("there is no slide 7");
    let expected = json!([{
        "message": "a drive has the slide 7, which is not drawn",
        "advice": "",
        "points": [], "links": [], "slides": [],
    }]);
    assert_eq!(serde_json::to_value(faults).expect("faults are data"), expected);

    sketch.drives[1] = sketch.drives[0];
    sketch.slides[0].guided = Some(0);
    let faults = sketch.declaration().expect_err("it makes no sense");
    let expected = json!([
        {
            "message": "`crank` is guided at `b`, which is no point of it",
            "advice": "give it the point",
            "points": [], "links": [], "slides": [0],
        },
        {
            "message": "`crank` is guided and cannot be turned",
            "advice": "remove its drive",
            "points": [], "links": [0], "slides": [],
        },
        {
            "message": "`crank` is guided and cannot be turned",
            "advice": "remove its drive",
            "points": [], "links": [0], "slides": [],
        },
        {
            "message": "`crank` is turned by two drives",
            "advice": "remove one of them",
            "points": [], "links": [0], "slides": [],
        },
    ]);
    assert_eq!(serde_json::to_value(faults).expect("faults are data"), expected);
}

/// Coordinates on a coarse grid, where points meet and lines are parallel, and numbers that overflow.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![20 => (-3..4).prop_map(f64::from), 1 => Just(f64::MAX), 1 => Just(f64::NAN), 1 => Just(1e-308)]
}

/// An index, most of the time of a part that is there.
fn index(count: usize) -> impl Strategy<Value = usize> {
    prop_oneof![30 => 0..count, 1 => Just(count), 1 => Just(usize::MAX)]
}

fn body() -> impl Strategy<Value = Body> {
    prop_oneof![Just(Body::Ground), index(4).prop_map(Body::Link)]
}

fn any_drawing() -> impl Strategy<Value = Sketch> {
    let point = (coordinate(), coordinate());
    let link = prop::collection::vec(index(6), 0..4);
    let slide = (index(6), body(), coordinate(), prop::option::of(index(4)));
    let drive = prop_oneof![
        (index(4), body()).prop_map(|(of, to)| Drive::Angle { of, to }),
        index(2).prop_map(Drive::Slide)
    ];
    let parts = (
        prop::collection::vec(point, 6),
        prop::collection::vec(index(6), 0..4),
        prop::collection::vec(link, 4),
        prop::collection::vec(slide, 0..3),
        prop::collection::vec(drive, 0..3),
    );
    parts.prop_map(|(points, ground, links, slides, drives)| Sketch {
        name: "Any".to_owned(),
        points: (0..)
            .zip(points)
            .map(|(number, (x, y))| SketchPoint {
                name: format!("p{number}"),
                x,
                y,
            })
            .collect(),
        ground,
        links: links
            .into_iter()
            .map(|points| SketchLink {
                name: String::new(),
                points,
            })
            .collect(),
        slides: slides
            .into_iter()
            .map(|(point, on, direction, guided)| SketchSlide {
                point,
                on,
                direction,
                guided,
            })
            .collect(),
        drives,
    })
}

/// One part of a sound drawing, changed to anything.
#[derive(Clone, Debug)]
enum Damage {
    Coordinate(usize, f64),
    Fixed(usize),
    OfLink(usize, usize),
    Slide(usize, SketchSlide),
    Drive(Drive),
}

fn damage() -> impl Strategy<Value = Damage> {
    let slide = (index(4), body(), coordinate(), prop::option::of(index(4)));
    prop_oneof![
        (0..4_usize, coordinate()).prop_map(|(point, x)| Damage::Coordinate(point, x)),
        index(4).prop_map(Damage::Fixed),
        (0..3_usize, index(4)).prop_map(|(link, point)| Damage::OfLink(link, point)),
        (0..2_usize, slide).prop_map(|(at, (point, on, direction, guided))| {
            Damage::Slide(
                at,
                SketchSlide {
                    point,
                    on,
                    direction,
                    guided,
                },
            )
        }),
        (index(4), body()).prop_map(|(of, to)| Damage::Drive(Drive::Angle { of, to })),
        index(2).prop_map(|slide| Damage::Drive(Drive::Slide(slide))),
    ]
}

/// A crank, a rod and a slide, of which some parts are changed.
fn damaged() -> impl Strategy<Value = Sketch> {
    prop::collection::vec(damage(), 0..4).prop_map(|all| {
        let (mut sketch, _) = ram();
        sketch.slides.pop();
        sketch.drives.pop();
        sketch.point("p", -1.0, 2.0);
        for one in all {
            match one {
                Damage::Coordinate(point, x) => sketch.points[point].x = x,
                Damage::Fixed(point) => sketch.ground.push(point),
                Damage::OfLink(link, point) => sketch.links[link].points.push(point),
                Damage::Slide(0, slide) => sketch.slides[0] = slide,
                Damage::Slide(_, slide) => sketch.slides.push(slide),
                Damage::Drive(drive) => sketch.drives = vec![drive],
            }
        }
        sketch
    })
}

/// The declaration of a drawing is one, or its faults name parts that are there.
fn holds(sketch: &Sketch) -> Result<bool, TestCaseError> {
    let faults = match sketch.declaration() {
        Ok(declared) => {
            let mechanism = Mechanism::declare(&declared.text);
            prop_assert!(mechanism.is_ok(), "{}\n{}", mechanism.unwrap_err(), declared.text);
            return Ok(true);
        }
        Err(faults) => faults,
    };
    prop_assert!(!faults.is_empty());
    for fault in faults {
        prop_assert!(
            fault.parts.points.iter().all(|point| *point < sketch.points.len()),
            "{fault:?}"
        );
        prop_assert!(
            fault.parts.links.iter().all(|link| *link < sketch.links.len()),
            "{fault:?}"
        );
        prop_assert!(
            fault.parts.slides.iter().all(|slide| *slide < sketch.slides.len()),
            "{fault:?}"
        );
    }
    Ok(false)
}

const CASES: u32 = 600;

/// Whatever is drawn is declared or refused. Returns how many drawings were declared.
fn sound_ones(drawings: &impl Strategy<Value = Sketch>) -> u32 {
    let sound = Cell::new(0);
    let config = ProptestConfig {
        cases: CASES,
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    let counted = |sketch: Sketch| {
        sound.set(sound.get() + u32::from(holds(&sketch)?));
        Ok(())
    };
    TestRunner::new(config)
        .run(drawings, counted)
        .unwrap_or_else(|error| panic!("{error}"));
    sound.get()
}

#[test]
fn no_drawing_panics() {
    sound_ones(&any_drawing());
}

#[test]
fn no_damage_panics() {
    let sound = sound_ones(&damaged());
    assert!(
        (CASES / 8..CASES - CASES / 8).contains(&sound),
        "{sound} of {CASES} drawings are sound"
    );
}
