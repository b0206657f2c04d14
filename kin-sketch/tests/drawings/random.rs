//! Random drawings: chains of dyads of every kind, from the ground and a crank on.

use kin_sketch::{Body, Sketch, SketchFaultKind, SketchLink};
use proptest::prelude::*;

use super::{compare, drawn};

/// A dyad that is added: its kind, where it starts, and where its points lie.
#[derive(Clone, Debug)]
struct Added {
    kind: usize,
    from: usize,
    to: usize,
    middle: [f64; 2],
    free: [f64; 2],
    direction: f64,
}

fn coordinates() -> impl Strategy<Value = [f64; 2]> {
    [-10.0..10.0, -10.0..10.0]
}

fn added() -> impl Strategy<Value = Added> {
    (
        0_usize..5,
        0_usize..100,
        0_usize..100,
        coordinates(),
        coordinates(),
        -3.0..3.0,
    )
        .prop_map(|(kind, from, to, middle, free, direction)| Added {
            kind,
            from,
            to,
            middle,
            free,
            direction,
        })
}

/// Adds a dyad with one more point that nothing else has.
fn add(sketch: &mut Sketch, dyad: &Added) {
    let count = sketch.points.len();
    let from = dyad.from % count;
    let to = (from + 1 + dyad.to % (count - 1)) % count;
    let name = |letter: &str| format!("{letter}{count}");
    let middle = sketch.point(&name("m"), dyad.middle[0], dyad.middle[1]);
    let free = sketch.point(&name("f"), dyad.free[0], dyad.free[1]);
    match dyad.kind {
        // two links between two points
        0 | 1 => {
            sketch.link("", &[from, middle, free]);
            sketch.link("", &[to, middle]);
        }
        // a link from a point to a slide of the ground
        2 => {
            sketch.link("", &[from, middle, free]);
            sketch.slide(middle, Body::Ground, dyad.direction);
        }
        // a link from a point, on which another point slides
        3 => {
            let rail = sketch.link("", &[from, middle, free]);
            sketch.slide(to, Body::Link(rail), dyad.direction);
        }
        // a ram in a guide of the ground
        _ => {
            sketch.link("", &[from, middle]);
            let ram = sketch.link("", &[middle, free]);
            let slide = sketch.slide(middle, Body::Ground, dyad.direction);
            sketch.slides[slide].guided = Some(ram);
        }
    }
}

fn crank() -> Sketch {
    let points = [("o", 0.0, 0.0), ("a", 1.0, 2.0), ("d", 7.0, 1.0)];
    drawn(&points, &["o", "d"], &[&["o", "a"]])
}

fn sketch(dyads: &[Added]) -> Sketch {
    let mut sketch = crank();
    for dyad in dyads {
        add(&mut sketch, dyad);
    }
    sketch
}

/// Whether nothing is near a limit: the drawing is not to be decided by rounding.
fn is_regular(sketch: &Sketch) -> bool {
    [0.002, -0.002]
        .iter()
        .all(|by| super::oracle::moved(sketch, &[*by]).is_some())
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 16,
        // the smallest drawings are none: their points lie on each other
        max_shrink_iters: 0,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn dyads_move_as_they_are_drawn(dyads in proptest::collection::vec(added(), 1..5)) {
        let sketch = sketch(&dyads);
        prop_assume!(is_regular(&sketch));
        compare(&sketch, &[0.002]);
    }

    /// A link more than there can be makes a frame; one less leaves a way without a drive.
    #[test]
    fn freedom_is_counted(dyads in proptest::collection::vec(added(), 1..4), number in 0_usize..100) {
        let sketch = sketch(&dyads);
        prop_assume!(is_regular(&sketch));
        let mut frame = sketch.clone();
        let points = frame.points.len();
        let is_of_one_link = |link: &SketchLink| [2, points - 1].iter().all(|point| link.points.contains(point));
        prop_assume!(!frame.links.iter().any(is_of_one_link));
        frame.link("", &[2, points - 1]);
        let faults = frame.declaration().expect_err("it is held twice");
        // where the rest stood still already, one equation repeats the others
        let is_told = faults.len() == 1
            && match faults[0].kind {
                SketchFaultKind::TooManyDrives { freedom, drives } => (freedom, drives) == (0, 1),
                SketchFaultKind::Overconstrained { redundant: 1 } => {
                    faults[0].parts.links.contains(&(frame.links.len() - 1))
                }
                _ => false,
            };
        prop_assert!(is_told, "{faults:?}");

        let mut open = sketch.clone();
        let tip = open.point("tip", 3.0, 20.0);
        let on = number % points;
        open.link("", &[on, tip]);
        let faults = open.declaration().expect_err("a link hangs");
        let kind = SketchFaultKind::NeedsDrives { freedom: 2, drives: 1 };
        let needs = faults.len() == 1 && faults[0].kind == kind && faults[0].parts.links == [open.links.len() - 1];
        prop_assert!(needs, "{faults:?}");
    }
}
