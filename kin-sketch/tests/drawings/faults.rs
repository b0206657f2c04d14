//! Drawings that are no mechanisms, and what they are told.

use kin_sketch::{Body, Drive, Sketch, SketchFaultKind};

use super::{at, drawn};

fn told(sketch: &Sketch) -> Vec<String> {
    let faults = sketch.declaration().expect_err("it is no mechanism");
    faults.iter().map(ToString::to_string).collect()
}

fn four_bar() -> Sketch {
    let points = [("o", 0.0, 0.0), ("a", 0.0, 2.0), ("b", 4.0, 3.0), ("d", 5.0, 0.0)];
    drawn(&points, &["o", "d"], &[&["o", "a"], &["a", "b"], &["d", "b"]])
}

#[test]
fn drives_are_counted() {
    let mut sketch = four_bar();
    sketch.drives.clear();
    assert_eq!(
        told(&sketch),
        [
            "the drawing moves in one way and has no drive; link 2, link 3 and link 4 can move while the \
             drives stand still: add a drive, or a link"
        ]
    );
    sketch.drives = [0, 2].map(|of| Drive::Angle { of, to: Body::Ground }).to_vec();
    assert_eq!(
        told(&sketch),
        ["the drawing moves in one way and has 2 drives: remove a drive"]
    );
    // a link that hangs
    let mut sketch = four_bar();
    let tip = sketch.point("tip", 6.0, 6.0);
    let b = at(&sketch, "b");
    sketch.link("", &[b, tip]);
    assert_eq!(
        told(&sketch),
        [
            "the drawing moves in 2 ways and has one drive; link 5 can move while the drives stand still: \
             add a drive, or a link"
        ]
    );
    // a strut
    let mut sketch = four_bar();
    let (o, b) = (at(&sketch, "o"), at(&sketch, "b"));
    sketch.link("", &[o, b]);
    assert_eq!(told(&sketch), ["the drawing cannot move: remove a link"]);
}

#[test]
fn third_rod_of_a_parallelogram() {
    let points = [
        ("o", 0.0, 0.0),
        ("a", 0.5, 2.0),
        ("m", 2.5, 2.0),
        ("b", 4.5, 2.0),
        ("e", 2.0, 0.0),
        ("d", 4.0, 0.0),
    ];
    let sketch = drawn(
        &points,
        &["o", "e", "d"],
        &[&["o", "a"], &["a", "m", "b"], &["e", "m"], &["d", "b"]],
    );
    assert_eq!(
        told(&sketch),
        [
            "the drawing moves only because its lengths fit, one equation follows from the others: remove \
             one of these, and nothing moves differently: link 4, link 5"
        ]
    );
    // with one length that does not fit, it is a frame
    let mut sketch = sketch;
    sketch.points[2].y = 2.3;
    assert_eq!(told(&sketch), ["the drawing cannot move: remove a link"]);
}

#[test]
fn dead_points() {
    // rod and rocker in line: the rocker's dead point
    let points = [("o", 0.0, 0.0), ("a", 0.0, 1.0), ("b", 3.0, 1.0), ("d", 5.0, 1.0)];
    let sketch = drawn(&points, &["o", "d"], &[&["o", "a"], &["a", "b"], &["d", "b"]]);
    let faults = sketch.declaration().expect_err("it stands at a limit");
    assert_eq!(faults.len(), 1);
    assert_eq!(faults[0].kind, SketchFaultKind::DeadPoint);
    assert_eq!(faults[0].parts.links, [1, 2]);
}

#[test]
fn parts_without_sense() {
    let mut sketch = four_bar();
    sketch.points[1].name = "sin".to_owned();
    sketch.points[2].name = "d".to_owned();
    sketch.points[0].name = "o'".to_owned();
    assert_eq!(
        told(&sketch),
        [
            "`o'` is no name: begin with a letter, and go on with letters, digits and `_`",
            "`sin` is a function of the declaration language; choose another name",
            "two points are called `d`: choose another name for one",
        ]
    );

    let mut sketch = four_bar();
    sketch.links[1].points = vec![1, 9];
    sketch.drives.push(Drive::Slide(3));
    assert_eq!(
        told(&sketch),
        [
            "link 3 has the point 9, which is not drawn",
            "a drive has the slide 3, which is not drawn",
        ]
    );

    let mut sketch = four_bar();
    sketch.points[2].x = -1e200;
    assert_eq!(
        told(&sketch)[0],
        "`b` stands 1e200 away from the origin: choose another unit of length"
    );

    let mut sketch = four_bar();
    sketch.points[2].x = f64::NAN;
    sketch.links.push(sketch.links[0].clone());
    sketch.links[3].points.clear();
    sketch.slide(0, Body::Ground, f64::INFINITY);
    sketch.slides[0].guided = Some(1);
    sketch.drives.push(sketch.drives[0]);
    assert_eq!(
        told(&sketch),
        [
            "`b` stands at (NaN, 3)",
            "`o` slides in the direction inf",
            "link 5 has no point: draw it through a joint",
            "`o` slides along the ground, of which it is a point: take it from there",
            "link 3 is guided at `o`, which is no point of it: give it the point",
            "link 2 is turned by two drives: remove one of them",
        ]
    );

    let mut sketch = four_bar();
    let [x, y] = [("x", 8.0, 0.0), ("y", 9.0, 0.0)].map(|(name, x, y)| sketch.point(name, x, y));
    sketch.link("lever", &[x, y]);
    assert_eq!(
        told(&sketch),
        ["no joint connects `lever` with the ground: give one of its points to another link, or fix it"]
    );
    assert!(!told(&Sketch::new("Empty")).is_empty());
}

#[test]
fn angles_that_count_from_themselves() {
    let mut sketch = four_bar();
    sketch.drives = vec![
        Drive::Angle {
            of: 0,
            to: Body::Link(1),
        },
        Drive::Angle {
            of: 1,
            to: Body::Link(0),
        },
    ];
    assert_eq!(
        told(&sketch),
        [
            "the angle of link 2 counts from itself: guide or drive it from another body",
            "the angle of link 3 counts from itself: guide or drive it from another body",
        ]
    );
}
