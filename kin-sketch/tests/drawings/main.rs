//! Drawn mechanisms: their declarations hold the pose that is drawn, and move as the drawing does.
#![allow(missing_docs, reason = "tests")]

mod faults;
mod mechanisms;
mod oracle;
mod random;

use kin_live::Mechanism;
use kin_sketch::{Body, Drive, Sketch, SketchDeclaration};

/// A drawing by words: points, fixed points, and links, of which the first is driven.
pub(crate) fn drawn(points: &[(&str, f64, f64)], ground: &[&str], links: &[&[&str]]) -> Sketch {
    let mut sketch = Sketch::new("Drawn");
    for (name, x, y) in points {
        sketch.point(name, *x, *y);
    }
    for point in ground {
        sketch.fix(at(&sketch, point));
    }
    for link in links {
        let points: Vec<usize> = link.iter().map(|point| at(&sketch, point)).collect();
        sketch.link("", &points);
    }
    sketch.drives.push(Drive::Angle {
        of: 0,
        to: Body::Ground,
    });
    sketch
}

pub(crate) fn at(sketch: &Sketch, name: &str) -> usize {
    sketch
        .points
        .iter()
        .position(|point| point.name == name)
        .expect("it is a point")
}

fn rows(values: &[(String, f64)]) -> Vec<(&str, f64)> {
    values.iter().map(|(name, value)| (&**name, *value)).collect()
}

fn values(values: &[(String, f64)]) -> Vec<f64> {
    values.iter().map(|(_, value)| *value).collect()
}

/// Compares what a declaration finds with the drawing, where it is drawn and after moving its drives.
pub(crate) fn compare(sketch: &Sketch, drives: &[f64]) -> SketchDeclaration {
    let declaration = sketch
        .declaration()
        .unwrap_or_else(|faults| panic!("{faults:?}\n{sketch:?}"));
    let text = &declaration.text;
    let mechanism = Mechanism::declare(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let linkage = mechanism
        .linkage(&rows(&declaration.dimensions))
        .expect("every dimension is measured");
    let (start, guess) = (values(&declaration.inputs), values(&declaration.unknowns));
    let choice = linkage.assembly_at(&start, &guess);
    let still = vec![0.0; drives.len()];
    for drives in [&still[..], drives] {
        let Some(moved) = oracle::moved(sketch, drives) else {
            continue;
        };
        let inputs: Vec<f64> = start.iter().zip(drives).map(|(start, drive)| start + drive).collect();
        let found = linkage
            .position(&inputs, choice.position())
            .unwrap_or_else(|error| panic!("{error} at {inputs:?}\n{text}"));
        for (((name, value), found), drawn) in declaration.unknowns.iter().zip(&found).zip(&guess) {
            assert_eq!(value, drawn);
            let error = if let Some(link) = name.strip_prefix("theta") {
                let link: usize = link.parse().expect("links have numbers here");
                let turned = moved.turned(Body::Link(link - 2));
                ((found - drawn - turned) / 2.0).sin().abs()
            } else {
                // a point of several slides has several distances
                let point = name.split('_').nth(1).map(|point| at(sketch, point));
                let slides = sketch.slides.iter().enumerate();
                let of_point = slides.filter(|(_, slide)| point.is_none_or(|point| slide.point == point));
                let errors = of_point.map(|(slide, _)| (found - drawn - moved.slid(slide)).abs());
                errors.fold(f64::INFINITY, f64::min)
            };
            assert!(error < 1e-7, "{name} differs by {error} at {inputs:?}\n{text}");
        }
        let outputs = linkage.outputs(&inputs, &found);
        let names = mechanism.declaration().outputs();
        for (output, [x, y]) in names.iter().zip(outputs.as_chunks::<2>().0) {
            let [to_x, to_y] = moved.point(at(sketch, &output.name));
            let [from_x, from_y] = declaration.origin;
            let error = (x + from_x - to_x).hypot(y + from_y - to_y);
            assert!(error < 1e-7, "{} differs by {error}\n{text}", output.name);
        }
    }
    declaration
}
