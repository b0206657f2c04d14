//! Unknowns as unit vectors: they are what the same mechanism finds as angles, without an arctangent, and whatever
//! speaks of angles goes on doing so.

use core::f64::consts::{PI, TAU};

use kin_core::batch::{Column, LengthMismatch, Outcome};
use kin_core::prelude::*;
use kin_core::series::Series;
use kin_core::{Operations, PoseOf, TrackError, solve, track};
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::coupled::{Built, Kepler, Triad};
use kin_tests::mechanisms::directions::{DirectedFarther, DirectedKepler, DirectedTriad};
use kin_tests::oracles::Gauge;
use kin_tests::random::Random;

/// By how much what is found in two ways may differ, in units of rounding times the condition.
const UNITS: f64 = 4.0;

/// Mechanisms whose angles are of one kind or the other.
macro_rules! mechanisms {
    ($kind:ident) => {
        use kin_core::prelude::*;

        mechanism! {
            pub(crate) struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
            input theta2: Angle;
            unknown theta3: $kind, theta4: $kind;
            r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
            with transmission_angles, sensitivities;
        }

        mechanism! {
            /// The coupler's angle is counted from a line in it that swings about π.
            pub(crate) struct Swinging { r1: Length, r2: Length, r3: Length, r4: Length, turn: Angle }
            input theta2: Angle;
            unknown theta3: $kind, theta4: $kind;
            r2 * cis(theta2) + r3 * cis(theta3 + turn) == r1 + r4 * cis(theta4);
        }

        mechanism! {
            pub(crate) struct SliderCrank { r: Length, l: Length, h: Length }
            input theta: Angle;
            unknown phi: $kind, s: Length;
            r * cis(theta) + l * cis(-phi) == vec2(s, h);
            output rod: Point = r * cis(theta) + l / 3 * cis(-phi);
        }

        mechanism! {
            pub(crate) struct ByInverseSine { r: Length, l: Length, h: Length }
            input theta: Angle;
            unknown phi: $kind, s: Length;
            sin(phi) == (r * sin(theta) - h) / l;
            s == r * cos(theta) + l * cos(phi);
        }

        mechanism! {
            pub(crate) struct AtSlider { r: Length, l: Length, h: Length }
            input s: Length;
            unknown theta: $kind, phi: $kind;
            r * cis(theta) + l * cis(phi) == vec2(s, h);
        }

        mechanism! {
            pub(crate) struct Lever { r1: Length, r2: Length }
            input theta2: Angle;
            unknown r4: Length, theta4: $kind;
            r1 + r2 * cis(theta2) == polar(r4, theta4);
        }

        mechanism! {
            pub(crate) struct OffsetLever { r1: Length, r2: Length, offset: Length }
            input theta2: Angle;
            unknown r4: Length, theta4: $kind;
            r1 + r2 * cis(theta2) == vec2(r4, offset) * cis(theta4);
        }

        mechanism! {
            pub(crate) struct Arm { upper: Length, lower: Length }
            input x: Length, y: Length;
            unknown q1: $kind, q2: $kind;
            upper * cis(q1) + lower * cis(q1 + q2) == vec2(x, y);
        }

        mechanism! {
            pub(crate) struct Freudenstein { r1: Length, r2: Length, r3: Length, r4: Length }
            input theta2: Angle;
            unknown theta4: $kind;
            let k = r2.powi(2) - r3.powi(2) + r4.powi(2) + r1.powi(2);
            r1 / r2 * cos(theta4) - r1 / r4 * cos(theta2) + k / (2 * r2 * r4) == cos(theta2 - theta4);
        }

        mechanism! {
            /// Outputs that need the angles themselves.
            pub(crate) struct Rack { r1: Length, r2: Length, r3: Length, r4: Length, pinion: Length }
            input theta2: Angle;
            unknown theta3: $kind, theta4: $kind, rack: Length, cam: Length;
            r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
            rack == pinion * theta4;
            cam == pinion * theta4.powi(2);
            output between: Angle = theta4 - theta3;
        }

        mechanism! {
            pub(crate) struct WithinRange { r1: Length, r2: Length, r3: Length, r4: Length }
            input theta2: Angle;
            unknown theta3: $kind, theta4: $kind in PI..=2.0*PI;
            r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
        }

        mechanism! {
            /// A motor between crank and coupler: one angle is the other and the input.
            pub(crate) struct Drive { r1: Length, r2: Length, r3: Length, r4: Length }
            input drive: Angle;
            unknown theta2: $kind, theta3: $kind, theta4: $kind;
            r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
            theta3 - theta2 == drive;
        }

        mechanism! {
            /// A strut by the cosine rule: its angle counts from another one, which a linear equation gives.
            pub(crate) struct Strut { ratio: Scalar, boom: Length, mast: Length, lean: Angle }
            input drum: Angle;
            unknown luff: $kind, strut: Length where strut > 0;
            luff == ratio * sin(drum);
            strut.powi(2) == boom.powi(2) + mast.powi(2) - 2 * boom * mast * cos(luff + lean);
        }
    };
}

mod angles {
    mechanisms!(Angle);
}

mod as_directions {
    mechanisms!(Direction);
}

/// Holds the directions of a mechanism against the angles of its like.
fn compare<A, D>(parameters: &[f64], ranges: &[(f64, f64)]) -> usize
where
    A: ThroughSnap,
    D: ThroughSnap,
{
    let (angles, directions) = (
        A::from_parameters(A::Parameters::from_fn(|index| parameters[index])),
        D::from_parameters(D::Parameters::from_fn(|index| parameters[index])),
    );
    let mut random = Random::new(31);
    let mut poses = 0;
    for _ in 0..200 {
        let motions: Vec<[f64; 5]> = ranges
            .iter()
            .map(|(low, high)| {
                let value = random.between(*low, *high);
                random.motion(value)
            })
            .collect();
        let inputs = A::Inputs::from_fn(|index| Motion::new(motions[index]));
        for (assembly, same) in A::assemblies().zip(D::assemblies()) {
            let one = angles.solve(inputs, assembly);
            let other = directions.solve(D::Inputs::from_fn(|index| Motion::new(motions[index])), same);
            let (one, other) = match (one, other) {
                (Ok(one), Ok(other)) => (one, other),
                (one, other) => {
                    assert_eq!(one.map(|_| ()), other.map(|_| ()), "{}", D::DESCRIPTION.name);
                    continue;
                }
            };
            poses += 1;
            let unknowns = one.unknown_motions();
            let gauge = Gauge::new(&angles, &inputs, &unknowns);
            let (columns, sines) = (other.unknown_columns(), other.unknown_sines());
            for (place, motion) in unknowns.as_ref().iter().enumerate() {
                let found = columns[place];
                let mut expected = motion.derivatives();
                if let Some(sine) = sines[place] {
                    let unit = gauge.unknown(place, 0).max(f64::EPSILON);
                    let error = (sine - expected[0].sin()).abs() / unit;
                    assert!(error <= UNITS, "{} {place}: {error}", D::DESCRIPTION.name);
                    let error = (found.value() - expected[0].cos()).abs() / unit;
                    assert!(error <= UNITS, "{} {place}: {error}", D::DESCRIPTION.name);
                    expected[0] = found.value();
                }
                for (order, (found, expected)) in found.derivatives().into_iter().zip(expected).enumerate() {
                    let error = (found - expected).abs();
                    let allowed = UNITS * gauge.unknown(place, order);
                    assert!(error <= allowed, "{} {place} {order}: {error}", D::DESCRIPTION.name);
                }
            }
            // whoever asks for angles finds angles: the same, on the same turns
            let pairs = other.unknown_motions();
            for (place, (one, other)) in unknowns.as_ref().iter().zip(pairs.as_ref()).enumerate() {
                let error = (one.value() - other.value()).abs();
                assert!(
                    error <= UNITS * gauge.unknown(place, 0),
                    "{} {place}",
                    D::DESCRIPTION.name
                );
            }
        }
    }
    poses
}

#[test]
fn unit_vectors_are_those_of_the_angles() {
    const LINKAGE: [f64; 4] = [90.0, 30.0, 60.0, 45.0];
    const CRANK: &[(f64, f64)] = &[(-1.9, 1.9)];
    const ALL_ROUND: &[(f64, f64)] = &[(-3.1, 3.1)];
    const SLIDER: [f64; 3] = [1.0, 3.0, 0.4];
    let mut poses = 0;
    poses += compare::<angles::FourBar, as_directions::FourBar>(&LINKAGE, CRANK);
    poses += compare::<angles::Swinging, as_directions::Swinging>(&[90.0, 30.0, 60.0, 45.0, 0.7 - PI], CRANK);
    poses += compare::<angles::SliderCrank, as_directions::SliderCrank>(&SLIDER, ALL_ROUND);
    poses += compare::<angles::ByInverseSine, as_directions::ByInverseSine>(&SLIDER, ALL_ROUND);
    poses += compare::<angles::AtSlider, as_directions::AtSlider>(&SLIDER, &[(1.9, 4.1)]);
    poses += compare::<angles::Lever, as_directions::Lever>(&[2.0, 0.8], ALL_ROUND);
    poses += compare::<angles::OffsetLever, as_directions::OffsetLever>(&[2.0, 0.8, 0.5], ALL_ROUND);
    poses += compare::<angles::Arm, as_directions::Arm>(&[1.2, 0.9], &[(-1.4, 1.4), (-1.3, 1.4)]);
    poses += compare::<angles::Freudenstein, as_directions::Freudenstein>(&LINKAGE, CRANK);
    poses += compare::<angles::Rack, as_directions::Rack>(&[90.0, 30.0, 60.0, 45.0, 10.0], CRANK);
    poses += compare::<angles::WithinRange, as_directions::WithinRange>(&LINKAGE, CRANK);
    poses += compare::<angles::Drive, as_directions::Drive>(&LINKAGE, ALL_ROUND);
    poses += compare::<angles::Strut, as_directions::Strut>(&[0.3, 5.0, 4.0, 0.5], ALL_ROUND);
    assert!(poses > 3500, "{poses}");
}

/// The rates do not know the difference.
#[test]
fn rates_of_the_four_bar_are_the_same_to_the_bit() {
    let parameters = [90.0, 30.0, 60.0, 45.0];
    let (angles, directions) = (
        angles::FourBar::<f64>::from_parameters(parameters),
        as_directions::FourBar::<f64>::from_parameters(parameters),
    );
    let mut random = Random::new(32);
    for _ in 0..200 {
        let value = random.between(-1.9, 1.9);
        let crank = Motion::new(random.motion(value));
        for assembly in Assembly::BOTH {
            let (Ok(one), Ok(other)) = (angles.solve(crank, assembly), directions.solve(crank, assembly)) else {
                continue;
            };
            assert_eq!(other.theta3.rates()[..], one.theta3.derivatives()[1..]);
            assert_eq!(other.theta4.rates()[..], one.theta4.derivatives()[1..]);
            // and who asks for sensitivities gets those of the angles
            let (one, other) = (angles.sensitivities(&one), directions.sensitivities(&other));
            assert_eq!(one.r3.theta4.derivatives(), other.r3.theta4.derivatives());
            assert_eq!(one.r1.theta3.derivatives(), other.r1.theta3.derivatives());
        }
    }
}

fn arc_tangents<M: Mechanism>() -> usize {
    M::DESCRIPTION.operations.iter().map(|order| order.arc_tangents).sum()
}

/// None is calculated that nothing asks for; one that something asks for is.
#[test]
fn arctangents_are_left_out() {
    assert_eq!(arc_tangents::<angles::FourBar>(), 2);
    assert_eq!(
        [
            arc_tangents::<as_directions::FourBar>(),
            arc_tangents::<as_directions::Swinging>(),
            arc_tangents::<as_directions::SliderCrank>(),
            arc_tangents::<as_directions::ByInverseSine>(),
            arc_tangents::<as_directions::AtSlider>(),
            arc_tangents::<as_directions::Lever>(),
            arc_tangents::<as_directions::OffsetLever>(),
            arc_tangents::<as_directions::Arm>(),
            arc_tangents::<as_directions::Freudenstein>(),
        ],
        [0; 9]
    );
    assert_eq!(
        arc_tangents::<as_directions::Rack>(),
        arc_tangents::<angles::Rack>(),
        "of both angles, as equations and an output ask for them"
    );
    // the range is that of theta4, both solutions of which are looked at
    assert_eq!(arc_tangents::<as_directions::WithinRange>(), 2);
    assert_eq!(arc_tangents::<angles::WithinRange>(), 4);

    // two quotients by a link's length, each by its inverse
    let more =
        as_directions::FourBar::<f64>::OPERATIONS[0].arithmetic() - angles::FourBar::<f64>::OPERATIONS[0].arithmetic();
    assert_eq!(more, 6);
    let rates = |operations: [Operations; 5]| operations.map(|order| order.arithmetic());
    assert_eq!(
        rates(as_directions::FourBar::<f64>::OPERATIONS)[1..],
        rates(angles::FourBar::<f64>::OPERATIONS)[1..]
    );
}

/// Goes to some places one after the other, and compares with the angles that are found on the way.
fn go_round<A: ThroughSnap, D: ThroughSnap>(parameters: &[f64], places: &[f64]) -> Vec<f64> {
    let (angles, directions) = (
        A::from_parameters(A::Parameters::from_fn(|index| parameters[index])),
        D::from_parameters(D::Parameters::from_fn(|index| parameters[index])),
    );
    let mut widest = vec![0.0; A::DESCRIPTION.unknowns.len()];
    for (assembly, same) in A::assemblies().zip(D::assemblies()) {
        let mut at = places[0];
        let mut one = angles
            .position(A::Inputs::from_fn(|_| at), assembly)
            .expect("it closes");
        let mut other = directions.position(D::Inputs::from_fn(|_| at), same).expect("so");
        for &next in &places[1..] {
            one = track(&angles, A::Inputs::from_fn(|_| at), one, A::Inputs::from_fn(|_| next)).expect("it goes round");
            other = match track(
                &directions,
                D::Inputs::from_fn(|_| at),
                other,
                D::Inputs::from_fn(|_| next),
            ) {
                Ok(end) => end,
                Err(error) => panic!("{} from {at} to {next}: {error:?}", D::DESCRIPTION.name),
            };
            at = next;
            for (place, (one, other)) in one.as_ref().iter().zip(other.as_ref()).enumerate() {
                assert!(
                    (one - other).abs() <= 1e-12 * one.abs().max(1.0),
                    "{} at {at}, unknown {place}: {one} {other}",
                    D::DESCRIPTION.name
                );
                widest[place] = one.abs().max(widest[place]);
            }
        }
    }
    widest
}

/// The angle of a unit vector jumps by a whole turn at π: that is none of the way's business.
#[test]
fn directions_are_followed_through_half_a_turn() {
    let places: Vec<f64> = (0..=48).map(|step| 0.3 + TAU / 16.0 * f64::from(step)).collect();
    let there_and_back: Vec<f64> = places.iter().chain(places.iter().rev()).copied().collect();
    // a crank-rocker whose coupler swings about π
    let swing =
        go_round::<angles::Swinging, as_directions::Swinging>(&[90.0, 30.0, 70.0, 60.0, 0.7 - PI], &there_and_back);
    assert!(swing[0] > PI && swing[0] < TAU, "{swing:?}");
    // a drag-link: coupler and rocker go round with the crank
    let drag_link = [30.0, 70.0, 60.0, 80.0];
    let turns = go_round::<angles::FourBar, as_directions::FourBar>(&drag_link, &there_and_back);
    assert!(turns[0] > 2.5 * TAU && turns[1] > 2.5 * TAU, "{turns:?}");
    // three turns at once
    let turns = go_round::<angles::FourBar, as_directions::FourBar>(&drag_link, &[0.3, 0.3 + 3.0 * TAU, 0.3 - TAU]);
    assert!(turns[0] > 2.5 * TAU && turns[1] > 2.5 * TAU, "{turns:?}");
    // a lever that goes round beside its slide
    let turns = go_round::<angles::OffsetLever, as_directions::OffsetLever>(&[1.0, 2.0, 0.3], &there_and_back);
    assert!(turns[1] > 2.5 * TAU, "{turns:?}");
    // and what hangs on an angle counts its turns
    let turns = go_round::<angles::Rack, as_directions::Rack>(&[30.0, 70.0, 60.0, 80.0, 10.0], &there_and_back);
    assert!(turns[2] > 10.0 * 2.5 * TAU, "{turns:?}");
}

/// The generated method hands out a position, in which a direction is on no turn.
#[test]
fn a_pose_is_followed_from_pose_to_pose() {
    let linkage = as_directions::FourBar::<f64>::from_parameters([30.0, 70.0, 60.0, 80.0]);
    let mut pose = linkage.position(0.3, Assembly::Crossed).expect("it closes");
    let start = pose;
    for step in 1..=16 {
        let theta2 = 0.3 + TAU / 16.0 * f64::from(step);
        pose = linkage.track(&pose, theta2).expect("it goes round");
        let direct = linkage.position(theta2, Assembly::Crossed).expect("it closes");
        assert!((pose.theta3.cosine() - direct.theta3.cosine()).abs() <= 1e-13);
        assert!((pose.theta3.sine() - direct.theta3.sine()).abs() <= 1e-13);
    }
    assert!((pose.theta4.angle() - start.theta4.angle()).abs() <= 1e-13);
    // with the wrong turns as a guess, too
    let near = pose.unknowns().map(|angle| angle + 3.0 * TAU);
    let there = linkage.position_near(0.3 + TAU, near).expect("it closes");
    assert_eq!(there.theta4.angle(), pose.theta4.angle());
    for (near, found) in near.into_iter().zip(there.unknowns_near(near)) {
        assert!((near - found).abs() <= 1e-13 * near.abs());
    }
    let values = Mechanism::position_near(&linkage, [0.3 + TAU], near).expect("it closes");
    assert_eq!(values, there.unknowns_near(near));
}

/// Where a way ends, the place is told as for angles.
#[test]
fn limits_are_where_they_are() {
    let parameters = [90.0, 30.0, 60.0, 45.0, 0.7 - PI];
    let (angles, directions) = (
        angles::Swinging::<f64>::from_parameters(parameters),
        as_directions::Swinging::<f64>::from_parameters(parameters),
    );
    for assembly in Assembly::BOTH {
        let start = angles.position(0.5, assembly).expect("it closes").unknowns();
        let Err(TrackError::TurningPoint(one)) = track(&angles, [0.5], start, [3.0]) else {
            panic!("the links do not reach");
        };
        let start = directions.position(0.5, assembly).expect("it closes").unknowns();
        let Err(TrackError::TurningPoint(other)) = track(&directions, [0.5], start, [3.0]) else {
            panic!("the links do not reach");
        };
        assert!((one.inputs[0] - other.inputs[0]).abs() <= 1e-14);
        for (one, other) in one.unknowns.into_iter().zip(other.unknowns) {
            // at a fold an angle is known to the root of the rounding of the inputs
            assert!((one - other).abs() <= 1e-7, "{one} {other}");
        }
    }
}

/// Quantities that depend on an angle follow that angle, on the turn that is asked for; the equations hold.
#[test]
fn an_angle_that_is_asked_for_is_kept() {
    let mechanism = as_directions::Rack::<f64>::from_parameters([90.0, 30.0, 60.0, 45.0, 10.0]);
    let first = mechanism.position(0.7, Assembly::Open).expect("it closes");
    assert!((first.rack.value() - 10.0 * first.theta4.angle()).abs() <= 1e-14);
    let turned = mechanism
        .position_near(0.7, first.unknowns().map(|value| value + TAU))
        .expect("it closes");
    assert_eq!(turned.theta4.unit(), first.theta4.unit());
    assert!((turned.rack.value() - first.rack.value() - 10.0 * TAU).abs() <= 1e-13);
    assert!((turned.unknowns()[1] - first.unknowns()[1] - TAU).abs() <= 1e-15);
    for left in mechanism.closure(0.7, turned.unknowns()) {
        assert!(left.abs() <= 1e-13, "{left}");
    }
    // through every order
    let velocity = turned.velocity(2.0);
    let expected = 20.0 * velocity.unknowns()[1] * velocity.theta4.velocity();
    assert!((velocity.cam.velocity() - expected).abs() <= 1e-12);

    let ranged = as_directions::WithinRange::<f64>::from_parameters([90.0, 30.0, 60.0, 45.0]);
    let pose = ranged.position(-0.7).expect("it closes");
    assert!((PI..=TAU).contains(&pose.unknowns()[1]) && pose.theta4.angle() < 0.0);
}

/// Newton's method finds numbers; cosine and sine are those of what it finds.
#[test]
fn coupled_blocks() {
    let mut random = Random::new(33);
    let mut poses = 0;
    for _ in 0..100 {
        let Built {
            mechanism,
            input,
            unknowns,
        } = Triad::built(&mut random);
        let directed = DirectedTriad::from_angles(&mechanism);
        let theta = Motion::new(random.motion(input));
        let (Ok(one), Ok(other)) = (
            mechanism.solve_near(theta, unknowns),
            directed.solve_near(theta, unknowns),
        ) else {
            continue;
        };
        poses += 1;
        assert_eq!(other.alpha.rates()[..], one.alpha.derivatives()[1..]);
        let motions = one.unknown_motions();
        let gauge = Gauge::new(&mechanism, &[theta], &motions);
        for (place, direction) in [other.alpha, other.beta, other.gamma].into_iter().enumerate() {
            let (sine, cosine) = motions[place].value().sin_cos();
            let unit = gauge.unknown(place, 0).max(f64::EPSILON);
            assert!((direction.cosine() - cosine).abs() <= UNITS * unit);
            assert!((direction.sine() - sine).abs() <= UNITS * unit);
        }
        if poses <= 10 {
            let (all, same) = (
                mechanism.assemblies_at(input).expect("it closes"),
                directed.assemblies_at(input).expect("it closes"),
            );
            assert_eq!(
                (all.len(), all.is_complete(), all.singular()),
                (same.len(), same.is_complete(), same.singular())
            );
            for (Near(one), Near(other)) in all.iter().zip(same.iter()) {
                for (one, other) in one.iter().zip(other) {
                    assert!((one - solve::unwrap_near(*other, *one)).abs() <= 1e-9, "{one} {other}");
                }
            }
        }
        // along with the angles, as far as these come
        let to = [input + 2.0 * PI];
        match (
            track(&mechanism, [input], unknowns, to),
            track(&directed, [input], unknowns, to),
        ) {
            (Ok(one), Ok(other)) => {
                for (one, other) in one.into_iter().zip(other) {
                    assert!((one - other).abs() <= 1e-9, "{one} {other}");
                }
            }
            (Err(TrackError::TurningPoint(one)), Err(TrackError::TurningPoint(other))) => {
                assert!((one.fraction - other.fraction).abs() <= 1e-9);
            }
            (one, other) => assert_eq!(
                core::mem::discriminant(&one.map(|_| ())),
                core::mem::discriminant(&other.map(|_| ()))
            ),
        }

        let Built {
            mechanism: Kepler { eccentricity },
            input,
            unknowns,
        } = Kepler::built(&mut random);
        let orbit = DirectedKepler { eccentricity };
        let position = orbit.position_near(input, unknowns).expect("it has a root");
        assert!((position.unknowns()[0] - unknowns[0]).abs() <= 1e-12);
        assert!((position.eccentric.sine() - position.height.value()).abs() <= f64::EPSILON);
    }
    assert!(poses > 90, "{poses}");
}

/// The picture and the transmission angle ask for angles.
#[test]
fn whatever_takes_poses_takes_these() {
    let parameters = [90.0, 30.0, 60.0, 45.0];
    let (angles, directions) = (
        angles::FourBar::<f64>::from_parameters(parameters),
        as_directions::FourBar::<f64>::from_parameters(parameters),
    );
    let one = angles.position(1.1, Assembly::Open).expect("it closes");
    let other = directions
        .position(1.1, Assembly::Open)
        .expect("it closes")
        .velocity(2.0);
    let (one_angle, other_angle) = (
        angles.transmission_angles(&one)[0],
        directions.transmission_angles(&other)[0],
    );
    assert!((one_angle.angle - other_angle.angle).abs() <= 4.0 * f64::EPSILON);
    let (one_picture, other_picture) = (angles.skeleton(&one), directions.skeleton(&other));
    for (one, other) in one_picture.joints().iter().zip(other_picture.joints()) {
        assert!((one.x - other.x).abs() <= 1e-13 && (one.y - other.y).abs() <= 1e-13);
    }
    assert_eq!(PoseOf::<as_directions::FourBar>::unknowns(&other), other.unknowns());
    assert_eq!(directions.assembly_at(1.1, other.unknowns()), Assembly::Open);
}

#[test]
fn columns_of_unit_vectors() {
    use as_directions::{FourBar, FourBarBatch};

    let linkage = FourBar::<f64>::from_parameters([90.0, 30.0, 60.0, 45.0]);
    let angles: Vec<f64> = (0..41).map(|index| 0.05 * f64::from(index) - 1.0).collect();
    let theta2 = Motion::from([Column::Each(&angles), 2.0.into(), 0.5.into(), 0.0.into(), 0.0.into()]);
    let mut outcomes = [Outcome::Unsolved; 41];
    let mut poses = FourBarBatch::filled(|| Some(vec![0.0; 41]));
    // one number is not wanted
    let (unit, rates) = poses.theta3.parts_mut();
    (unit.y, rates[1]) = (None, None);
    linkage
        .batch(theta2, Assembly::Crossed)
        .solve(&mut poses, &mut outcomes)
        .expect("lengths");
    let wanted = |column: &Option<Vec<f64>>, index: usize| column.as_ref().expect("it is wanted")[index];
    for (index, angle) in angles.iter().enumerate() {
        let pose = linkage
            .solve(Motion::from([*angle, 2.0, 0.5, 0.0, 0.0]), Assembly::Crossed)
            .expect("it closes");
        let (unit, rates) = poses.theta4.parts();
        assert!((wanted(&unit.x, index) - pose.theta4.cosine()).abs() <= 4.0 * f64::EPSILON);
        assert!((wanted(&unit.y, index) - pose.theta4.sine()).abs() <= 4.0 * f64::EPSILON);
        for (column, rate) in rates.iter().zip(pose.theta4.rates()) {
            assert!((wanted(column, index) - rate).abs() <= 1e-13 * rate.abs().max(1.0));
        }
        let (unit, _) = poses.theta3.parts();
        assert!((wanted(&unit.x, index) - pose.theta3.cosine()).abs() <= 4.0 * f64::EPSILON);
    }

    // on all cores the same
    let mut one = FourBarBatch::filled(|| vec![0.0; 41]);
    let mut all = FourBarBatch::filled(|| vec![0.0; 41]);
    linkage
        .batch(theta2, Assembly::Open)
        .solve(&mut one, &mut outcomes)
        .expect("lengths");
    linkage
        .batch(theta2, Assembly::Open)
        .on_all_cores()
        .solve(&mut all, &mut outcomes)
        .expect("lengths");
    assert_eq!(one, all);

    all.theta4.parts_mut().0.y.pop();
    let error = linkage
        .batch(theta2, Assembly::Open)
        .solve(&mut all, &mut outcomes)
        .expect_err("too short");
    let expected = LengthMismatch {
        quantity: "theta4".into(),
        poses: 41,
        length: 40,
    };
    assert_eq!(error, expected);
}

/// Every number type, and every order.
#[test]
#[expect(
    clippy::cast_possible_truncation,
    reason = "the nearest numbers of single precision are meant"
)]
fn of_any_number_and_order() {
    let linkage = as_directions::FourBar::<f64>::from_parameters([90.0, 30.0, 60.0, 45.0]);
    let pose = linkage
        .solve(Motion::at_constant_speed(1.1, 2.0), Assembly::Open)
        .expect("it closes");

    let single = linkage.convert(|length| length as f32);
    let found = single
        .solve(Motion::at_constant_speed(1.1, 2.0), Assembly::Open)
        .expect("it closes");
    assert!((f64::from(found.theta4.sine()) - pose.theta4.sine()).abs() <= 8.0 * f64::from(f32::EPSILON));
    assert!((f64::from(found.theta4.angle()) - pose.theta4.angle()).abs() <= 8.0 * f64::from(f32::EPSILON));

    // a series knows the rates of the unit vector itself
    let series = linkage.convert(Series::<3>::constant);
    let theta2 = Series::from_derivatives([1.1, 2.0, 0.0]);
    let unit = series
        .position(theta2, Assembly::Open)
        .expect("it closes")
        .theta4
        .unit();
    let (cosine, sine, speed) = (pose.theta4.cosine(), pose.theta4.sine(), pose.theta4.velocity());
    assert!((unit.x.coefficients()[1] + sine * speed).abs() <= 1e-14);
    assert!((unit.y.coefficients()[1] - cosine * speed).abs() <= 1e-14);

    let farther = DirectedFarther::<f64>::from_parameters([90.0, 30.0, 60.0, 45.0]);
    let far = farther
        .solve(Motion::at_constant_speed(1.1, 2.0), Assembly::Open)
        .expect("it closes");
    assert_eq!(far.theta4.unit(), pose.theta4.unit());
    for (one, other) in far.theta4.truncate::<4>().rates().into_iter().zip(pose.theta4.rates()) {
        assert!((one - other).abs() <= 1e-14 * other.abs(), "{one} {other}");
    }
    assert!(far.theta4.derivative_12().is_finite() && far.theta4.derivative_12() != 0.0);
    assert_eq!(far.theta4.derivative(13), None);
    assert_eq!(far.theta4.derivative(12), Some(far.theta4.derivative_12()));
}

/// A position alone is finite, or an error.
#[test]
fn nothing_that_is_not_finite_comes_out() {
    let numbers = [
        f64::NAN,
        f64::INFINITY,
        0.0,
        1e-320,
        f64::MIN_POSITIVE,
        1e-160,
        1e160,
        f64::MAX,
    ];
    for place in 0..5 {
        for number in numbers {
            for assembly in Assembly::BOTH {
                let mut values = [90.0, 30.0, 60.0, 45.0, 1.1];
                values[place] = number;
                let [r1, r2, r3, r4, theta2] = values;
                if let Ok(pose) = as_directions::FourBar::from_parameters([r1, r2, r3, r4]).position(theta2, assembly) {
                    assert!(pose.theta3.is_finite() && pose.theta4.is_finite(), "{values:?}");
                }
                let mut values = [1.0, 3.0, 0.4, 1.1];
                if let Some(value) = values.get_mut(place) {
                    *value = number;
                }
                let [r, l, h, theta] = values;
                if let Ok(pose) = as_directions::SliderCrank::from_parameters([r, l, h]).position(theta, assembly) {
                    assert!(pose.phi.is_finite(), "{values:?}");
                }
                let mut values = [2.0, 0.8, 0.5, 1.1];
                if let Some(value) = values.get_mut(place) {
                    *value = number;
                }
                let [r1, r2, offset, theta2] = values;
                if let Ok(pose) = as_directions::Lever::from_parameters([r1, r2]).position(theta2, assembly) {
                    assert!(pose.theta4.is_finite(), "{values:?}");
                }
                let offset = as_directions::OffsetLever::from_parameters([r1, r2, offset]);
                if let Ok(pose) = offset.position(theta2, assembly) {
                    assert!(pose.theta4.is_finite(), "{values:?}");
                }
            }
        }
    }
}
