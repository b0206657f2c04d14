//! Prepared reactions beside those of single poses.

use std::string::ToString;
use std::vec::Vec;

use super::mistakes::NFourBar;
use super::{FOUR_BAR, heavy};
use crate::any::PositionChoice;
use crate::linkage::AnyLinkage;
use crate::motion::Motion;
use crate::reaction::{NamedReactions, PoseReactions, ReactionError, Reactions};

/// Compares all forces, moments and efforts with both rates, or the errors.
fn agree(
    reactions: &NamedReactions<'_>,
    found: Result<PoseReactions<'_>, ReactionError>,
    expected: Result<Reactions, ReactionError>,
) {
    let (found, expected) = match (found, expected) {
        (Ok(found), Ok(expected)) => (found, expected),
        (found, expected) => {
            let message = expected.map(|_| ()).expect_err("it is solved").to_string();
            assert_eq!(found.map(|_| ()).expect_err("it is solved").to_string(), message);
            return;
        }
    };
    let mut pairs: Vec<([f64; 3], [f64; 3])> = Vec::new();
    for (index, name) in reactions.names().enumerate() {
        let Ok(reaction) = expected.of(name) else {
            let parts = (found.force(index), found.moment(index));
            assert!(parts.0.is_none() || parts.1.is_none(), "{name} is not determined");
            continue;
        };
        let (force, moment) = (found.force(index), found.moment(index));
        let force = force.expect("it is determined").into_iter();
        pairs.extend(force.zip([reaction.x, reaction.y, reaction.z]));
        let moment = moment.expect("it is determined").into_iter();
        pairs.extend(moment.zip(reaction.moments));
        let magnitude = found.magnitude(index).expect("it is determined");
        let size = reaction.magnitude()[0];
        assert!((magnitude[0] - size).abs() <= 1e-11 * size, "{name}");
    }
    assert_eq!(found.effort(0).is_some(), expected.effort(0).is_some());
    pairs.extend(found.effort(0).zip(expected.effort(0)));
    for order in 0..3 {
        let size = pairs
            .iter()
            .fold(0.0, |size: f64, (_, expected)| size.max(expected[order].abs()));
        for (found, expected) in &pairs {
            let error = (found[order] - expected[order]).abs();
            assert!(error <= 1e-11 * size, "{order}: {found:?} {expected:?}");
        }
    }
}

/// Compares poses of the first assembly, one by one and in lanes. The plan is made in the first one, and the mechanism
/// may rest there.
pub(super) fn compare(reactions: &NamedReactions<'_>, motions: &[Motion]) {
    let mut prepared = reactions.prepared();
    let rest = motions.first().map(|motion| Motion::constant(motion.value()));
    for motion in rest.iter().chain(motions).chain(&rest) {
        let choice = || PositionChoice::Assembly(0);
        let expected = reactions.at(&[*motion], choice());
        agree(reactions, prepared.at(&[*motion], choice()), expected);
    }
    let columns = core::array::from_fn(|order| motions.iter().map(|motion| motion[order]).collect());
    super::batch::compare(reactions, &columns, 1e-10);
}

/// Poses in all assemblies in turn, where links lie in one line and where the crank lies along an axis of coordinates,
/// so that entries of the equations are zero there alone.
#[test]
fn any_pose_makes_a_plan_for_the_others() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let loads = heavy(&linkage);
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let quarter = core::f64::consts::FRAC_PI_2;
    for start in [0.0, quarter, 2.0 * quarter, 3.0 * quarter, 0.7] {
        let mut prepared = reactions.prepared();
        let mut near = linkage
            .position(&[start], PositionChoice::Assembly(1))
            .expect("it closes");
        for step in 0..40_u8 {
            let crank = Motion::at_constant_speed(start + 0.2 * f64::from(step), 7.0);
            let choice = PositionChoice::Assembly(usize::from(step / 20));
            let expected = reactions.at(&[crank], choice);
            agree(&reactions, prepared.at(&[crank], choice), expected);
        }
        for step in 0..40_u8 {
            let crank = Motion::from((start + 0.2 * f64::from(step), 7.0, -3.0, 20.0, 80.0));
            let choice = PositionChoice::Near(&near);
            let expected = reactions.at(&[crank], choice);
            agree(&reactions, prepared.at(&[crank], choice), expected);
            near = linkage.position(&[crank.value()], choice).expect("it closes");
        }
    }
}

/// What equilibrium does not determine, and what does not close, is told as in a single pose, and does no harm to
/// others.
#[test]
fn what_has_no_plan() {
    let cranks = NFourBar { length: 1.0 };
    let linkage = AnyLinkage::of(&cranks);
    let reactions = linkage.reactions(&heavy(&linkage)).expect("its bodies are declared");
    compare(
        &reactions,
        &[1.0, 1.5, 2.0].map(|at| Motion::at_constant_speed(at, 2.0)),
    );

    let rocker = super::FourBar { r2: 1.1, ..FOUR_BAR };
    let linkage = AnyLinkage::of(&rocker);
    let reactions = linkage.reactions(&heavy(&linkage)).expect("its bodies are declared");
    compare(
        &reactions,
        &[0.3, 3.0, 0.4].map(|at| Motion::at_constant_speed(at, 2.0)),
    );
}

#[cfg(feature = "std")]
#[test]
fn threads_share_reactions() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let reactions = linkage.reactions(&heavy(&linkage)).expect("its bodies are declared");
    let effort = |at: f64| {
        let crank = Motion::at_constant_speed(at, 2.0);
        let found = reactions.at(&[crank], PositionChoice::Assembly(0));
        found.expect("it closes").effort(0)
    };
    let [one, other] = std::thread::scope(|scope| {
        let threads = [0.3, 0.9].map(|at| scope.spawn(move || effort(at)));
        threads.map(|thread| thread.join().expect("it does not panic"))
    });
    assert!(one == effort(0.3) && other == effort(0.9) && one != other);
}
