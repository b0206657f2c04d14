//! The statements that would declare what follows from the vector equations.

use super::SkeletonNames;
use super::terms::LinkTerm;
use super::turning::SlideDirection;
use crate::model::ValueShape;
use crate::translate::tree::Outline;

/// One statement in a line. `joint` writes a joint by its index.
pub(super) fn statements(outline: &Outline, directions: &[SlideDirection], joint: impl Fn(usize) -> String) -> String {
    let point = |index: &usize| {
        let mut named = outline.points.iter().filter(|(_, known)| known == index);
        named.next().map_or_else(|| joint(*index), |(name, _)| name.clone())
    };
    let list = |joints: &[usize]| joints.iter().map(point).collect::<Vec<_>>().join(", ");
    let names = names(outline);
    let mut lines = Vec::new();
    if !outline.ground.is_empty() {
        lines.push(format!("ground {};", list(&outline.ground)));
    }
    for (body, name) in outline.bodies.iter().zip(&names) {
        lines.push(format!("body {name}: {};", list(&body.joints)));
    }
    for (slide, direction) in outline.slides.iter().zip(directions) {
        let guide = slide.guide.map(|guide| format!(" on {}", names[guide]));
        let (point, direction, guide) = (point(&slide.joint), &direction.text, guide.unwrap_or_default());
        lines.push(format!("slide {point} along {direction}{guide};"));
    }
    lines.join("\n")
}

/// The names of the bodies as identifiers, each once.
fn names(outline: &Outline) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for body in &outline.bodies {
        let base = body
            .name
            .replace(|letter: char| !letter.is_alphanumeric() && letter != '_', "_");
        let numbers = (2..).map(|number| format!("{base}_{number}"));
        let free = std::iter::once(base.clone())
            .chain(numbers)
            .find(|name| !names.contains(name));
        names.extend(free);
    }
    names
}

/// A sum of terms as a vector.
pub(super) fn sum(terms: &[LinkTerm<'_>], shape: ValueShape, names: &SkeletonNames<'_>) -> String {
    let mut text = String::new();
    for LinkTerm { negative, formula } in terms {
        text.push_str(match (negative, text.is_empty()) {
            (true, true) => "-",
            (true, false) => " - ",
            (false, true) => "",
            (false, false) => " + ",
        });
        text.push_str(&formula.to_string());
    }
    if text.is_empty() {
        return "0".to_owned();
    }
    if terms.iter().any(|term| names.shape(term.formula) != ValueShape::Scalar) {
        return text;
    }
    // a scalar lies along x
    if shape == ValueShape::Space {
        format!("vec3({text}, 0, 0)")
    } else {
        format!("vec2({text}, 0)")
    }
}
