//! Positions that pylinkage itself has computed.

use std::fs;

use kin_core::any::{Pictured, SkeletonOver};
use kin_live::Mechanism;
use kin_sketch::SketchDeclaration;
use kin_sketch::foreign::Foreign;
use serde_json::Value;

use super::{declared, files, folder, followed, linkage, mechanism, values};

/// Of the size of the drawing. pylinkage solves with the distances of its joints, and rounds at each of its steps.
const TOLERANCE: f64 = 1e-9;

/// The points of the drawing in a position, the ground where it was.
fn points(
    mechanism: &Mechanism,
    foreign: &Foreign,
    declaration: &SketchDeclaration,
    inputs: &[f64],
    unknowns: &[f64],
) -> Vec<[f64; 2]> {
    let sketch = &foreign.sketch;
    let mut joints: Vec<[f64; 2]> = Vec::new();
    mechanism.skeleton_points(
        &values(&declaration.dimensions),
        inputs,
        unknowns,
        &mut |found: &[f64]| {
            joints.push([found[0] + declaration.origin[0], found[1] + declaration.origin[1]]);
        },
    );
    let mut places: Vec<[f64; 2]> = sketch.points.iter().map(|point| [point.x, point.y]).collect();
    let outline = mechanism.outline();
    // bodies are declared in the order of the links, with their points in order
    assert_eq!(outline.bodies.len(), sketch.links.len());
    for (link, body) in sketch.links.iter().zip(outline.bodies) {
        for (point, joint) in link.points.iter().zip(body.joints) {
            places[*point] = joints[*joint];
        }
    }
    places
}

#[test]
fn positions_are_those_of_pylinkage() {
    let mut compared = 0;
    for file in files("pylinkage", "json") {
        let text =
            fs::read_to_string(folder().join(format!("pylinkage/{}.positions", file.name))).expect("it is there");
        let positions: Value = serde_json::from_str(&text).expect("it is JSON");
        assert_eq!(positions["version"], "1.3.0");
        let foreign = file.foreign();
        let declaration = declared(&file.name, &foreign);
        let mechanism = mechanism(&declaration);
        let linkage = linkage(&mechanism, &declaration);
        let (mut inputs, mut unknowns) = (values(&declaration.inputs), values(&declaration.unknowns));
        let size = foreign
            .sketch
            .points
            .iter()
            .fold(0.0_f64, |size, point| size.max(point.x.hypot(point.y)));
        let mut before = 0.0;
        for row in positions["rows"].as_array().expect("they are rows") {
            let turned = row[0].as_f64().expect("it is an angle");
            followed(&linkage, &mut inputs, &mut unknowns, turned - before, 30).expect("pylinkage closes there");
            before = turned;
            let ours = points(&mechanism, &foreign, &declaration, &inputs, &unknowns);
            let theirs = row[1].as_array().expect("they are places");
            assert_eq!(ours.len(), theirs.len());
            for ((place, wanted), point) in ours.iter().zip(theirs).zip(&foreign.sketch.points) {
                let wanted = [0, 1].map(|axis| wanted[axis].as_f64().expect("it is a number"));
                let error = (place[0] - wanted[0]).hypot(place[1] - wanted[1]);
                let name = &point.name;
                assert!(
                    error < TOLERANCE * size,
                    "{} at {turned}: {name} {place:?} is not {wanted:?}",
                    file.name
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 800, "{compared}");
}
