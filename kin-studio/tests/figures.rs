//! The figures of the book are up to date, and the drawings are right.

use std::fs;
use std::path::Path;

use kin_core::Space;
use kin_studio::figures::{all, gallery};

/// The mechanisms whose rod keeps its length approximately, and the relative error of that length, which the series
/// leaves out.
const APPROXIMATE: [(&str, f64); 2] = [
    ("SliderCrankFirstApproximation", 0.005),
    ("SliderCrankHigherApproximation", 0.0001),
];

#[test]
fn the_figures_of_the_book_are_what_is_drawn() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/figures");
    for figure in all().expect("every mechanism closes") {
        let written = fs::read_to_string(folder.join(&figure.file)).unwrap_or_default();
        assert!(
            written == figure.svg,
            "docs/figures/{} is not what is drawn: run `cargo run -p kin-studio --features gallery --example figures` \
             and look at it",
            figure.file
        );
    }
}

/// Every `mechanism!` of the library has an entry, and a picture in the chapter on the library.
#[test]
fn every_mechanism_of_the_library_is_drawn() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let page = fs::read_to_string(root.join("docs/library.md")).expect("the page is there");
    let entries = gallery().expect("every mechanism closes");
    let mut declared = 0;
    for file in fs::read_dir(root.join("kin-core/src/library")).expect("the library is there") {
        let path = file.expect("it can be listed").path();
        let source = fs::read_to_string(path).expect("it is a file");
        declared += source.matches("crate::mechanism! {").count();
    }
    assert_eq!(entries.len(), declared);
    for entry in &entries {
        let heading = format!(
            "### {}\n\n![{}](figures/{})",
            entry.name,
            entry.name,
            entry.figure().file
        );
        assert!(page.contains(&heading), "docs/library.md lacks {}", entry.name);
        let outline = entry.scene.outline;
        assert!(!outline.ground.is_empty(), "{} has no ground", entry.name);
        assert!(!outline.bodies.is_empty(), "{} has no bodies", entry.name);
        assert!(!entry.scene.sweep.is_empty(), "{} does not move", entry.name);
        // the angle between two links that share no joint has no mark
        assert_eq!(
            entry.scene.drives.is_empty(),
            entry.name == "WattIIByCouplers",
            "{}: what the input drives",
            entry.name
        );
    }
}

/// The joints of a body keep their distances, what stands on the ground stands still, and slides stay on their lines.
///
/// Sweeps end beside limit positions, where rounding is magnified by the reciprocal of a step's square root: some
/// hundred times beside Newton's tolerance, so that 1e-9 of the size is far below the error of a wrong body.
#[test]
fn bodies_are_rigid() {
    for entry in gallery().expect("every mechanism closes") {
        let (name, scene) = (entry.name, &entry.scene);
        let size = scene.joints.iter().map(|joint| joint.norm()).fold(1e-3, f64::max);
        let allowed = APPROXIMATE
            .iter()
            .find(|(known, _)| *known == name)
            .map_or(1e-9, |&(_, part)| part);
        let distance = |joints: &[Space], one: usize, other: usize| (joints[one] - joints[other]).norm();
        for points in &scene.sweep {
            for body in scene.outline.bodies {
                for (&one, &other) in body.joints.iter().zip(body.joints.iter().skip(1)) {
                    let change = distance(points, one, other) - distance(&scene.joints, one, other);
                    assert!(
                        change.abs() <= allowed * size,
                        "{name}: {} stretches by {change:e}",
                        body.name
                    );
                }
            }
            for &joint in scene.outline.ground {
                assert_eq!(points[joint], scene.joints[joint], "{name}: ground moves");
            }
            for (number, slide) in scene.outline.slides.iter().enumerate() {
                let direction = points[scene.joints.len() + number];
                let from = match slide.guide {
                    None => scene.joints[slide.joint],
                    Some(body) => points[scene.outline.bodies[body].joints[0]],
                };
                let beside = (points[slide.joint] - from).cross(direction).norm() / direction.norm();
                assert!(
                    beside <= 1e-9 * size,
                    "{name}: a slide is beside its line by {beside:e}"
                );
            }
        }
    }
}
