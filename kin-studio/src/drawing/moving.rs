//! A drawing that moves: each body follows the poses of a revolution.

use kin_core::{Plane, Space};

use super::canvas::{Canvas, Keyframe};
use super::shapes::Pen;
use super::sweep::extent;
use super::{Scene, Style};

/// Every second pose of a sweep is a keyframe. Between two of them, 4° apart, a joint cuts its circle's arc by 0.06 %
/// of the radius.
const STRIDE: usize = 2;

/// Draws a scene whose bodies go through its sweep, again and again. Bodies bear no names.
///
/// `None` for mechanisms of space, for those with slides, and where the sweep does not end as it begins.
#[must_use]
pub fn moving(scene: &Scene, style: &Style, seconds: f64) -> Option<Canvas> {
    let (first, last) = (scene.sweep.first()?, scene.sweep.last()?);
    let moved = first.iter().zip(last).map(|(&from, &to)| (to - from).norm());
    if !scene.is_plane || !scene.outline.slides.is_empty() || moved.fold(0.0, f64::max) > 1e-6 * extent(first) {
        return None;
    }
    let everywhere: Vec<Space> = scene.sweep.concat();
    let mut pen = Pen::new(scene, style, &everywhere);
    pen.ground();
    pen.paths();
    let motions: Vec<(String, Vec<Keyframe>)> = scene
        .outline
        .bodies
        .iter()
        .map(|body| (format!("body-{}", body.name), keyframes(&pen, scene, body.joints)))
        .collect();
    for (number, (name, keyframes)) in motions.iter().enumerate() {
        pen.canvas.motion(name, keyframes, seconds, 0.0);
        follow(&mut pen, name, keyframes, |pen| pen.body(number));
    }
    for joint in pen.marked() {
        // a mark is round, so that any of its bodies may carry it
        let mut bodies = scene.outline.bodies.iter().zip(&motions);
        match bodies.find(|(body, _)| body.joints.contains(&joint)) {
            Some((_, (name, keyframes))) => follow(&mut pen, name, keyframes, |pen| pen.mark(joint)),
            None => pen.mark(joint),
        }
    }
    pen.drives();
    Some(pen.canvas)
}

/// The motion of a body: of its first joint, and the rotation of the line from this joint to the next.
fn keyframes(pen: &Pen<'_>, scene: &Scene, joints: &[usize]) -> Vec<Keyframe> {
    let mut degrees = 0.0_f64;
    let mut last: Option<Plane> = None;
    let poses = scene.sweep.iter().step_by(STRIDE);
    poses
        .map(|points| {
            let corner = |number: usize| joints.get(number).map(|&joint| pen.frame.point(points[joint]));
            let at = corner(0).unwrap_or(Plane::new(0.0, 0.0));
            if let Some(here) = corner(1).map(|other| other - at) {
                let before = last.replace(here).unwrap_or(here);
                degrees += before.cross(here).atan2(before.dot(here)).to_degrees();
            }
            Keyframe { at, degrees }
        })
        .collect()
}

/// Lets a part of the drawing follow a motion that begins where the scene stands.
fn follow(pen: &mut Pen<'_>, name: &str, keyframes: &[Keyframe], draw: impl FnOnce(&mut Pen<'_>)) {
    let Some(&start) = keyframes.first() else { return };
    let before = std::mem::take(&mut pen.canvas);
    draw(pen);
    let drawn = std::mem::replace(&mut pen.canvas, before);
    let mut part = Canvas::default();
    part.place(&drawn, -start.at);
    pen.canvas.follow(name, start, &part);
}

#[cfg(test)]
mod tests {
    use kin_core::library::{FourBar, JansenLeg, SliderCrank};
    use kin_core::prelude::*;

    use super::*;

    fn four_bar(r2: f64) -> Scene {
        let linkage = FourBar {
            r1: 90.0,
            r2,
            r3: 80.0,
            r4: 60.0,
        };
        Scene::of_mechanism(&linkage, [1.0], Assembly::Open).expect("it closes")
    }

    /// Every joint of every body goes where the poses have it.
    #[test]
    fn bodies_follow_the_poses() {
        let leg = Scene::of_mechanism(&JansenLeg::HOLY_NUMBERS, [0.0], JansenLeg::WALKING).expect("it closes");
        let style = Style::default();
        for scene in [four_bar(30.0), leg] {
            let pen = Pen::new(&scene, &style, &[]);
            for body in scene.outline.bodies {
                let keyframes = keyframes(&pen, &scene, body.joints);
                let start = keyframes[0].at;
                for (keyframe, points) in keyframes.iter().zip(scene.sweep.iter().step_by(STRIDE)) {
                    for &joint in body.joints {
                        let arm = pen.frame.point(scene.joints[joint]) - start;
                        let carried = keyframe.at + arm.times(Plane::cis(keyframe.degrees.to_radians()));
                        let off = (carried - pen.frame.point(points[joint])).norm();
                        assert!(off < 1e-6, "{}: {off} pixels", body.name);
                    }
                }
                let revolutions = (keyframes[keyframes.len() - 1].degrees / 360.0).abs();
                assert!(
                    (revolutions - revolutions.round()).abs() < 1e-6,
                    "{} ends turned",
                    body.name
                );
            }
        }
    }

    #[test]
    fn what_cannot_be_drawn_moving_is_refused() {
        let style = Style::default();
        assert!(moving(&four_bar(30.0), &style, 6.0).is_some());
        // its crank is stopped by a limit
        assert!(moving(&four_bar(80.0), &style, 6.0).is_none());
        let slider_crank = SliderCrank { r: 30.0, l: 80.0 };
        let slider_crank = Scene::of_mechanism(&slider_crank, [1.0], Assembly::Open).expect("it closes");
        assert!(moving(&slider_crank, &style, 6.0).is_none());
    }
}
