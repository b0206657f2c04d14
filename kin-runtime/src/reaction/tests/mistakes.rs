//! What is not determined, and what is not known.

use std::string::{String, ToString};
use std::vec::Vec;

use super::FOUR_BAR;
use crate::any::{AssemblyChoice, PositionChoice};
use crate::geometry::Plane;
use crate::library;
use crate::linkage::AnyLinkage;
use crate::load::{Loads, NamedLoads};
use crate::motion::Motion;
use crate::reaction::{NamedReactions, ReactionError, ReactionPart, Reactions};

crate::mechanism! {
    /// A coupler on three cranks of one length: problem A02 of the library of benchmarks of `IFToMM`.
    pub(super) struct NFourBar { pub(super) length: Length }
    input theta: Angle;
    unknown tip_x: Length, tip_y: Length;
    tip_x == length * cos(theta);
    tip_y == length * sin(theta);
    output b0: Point = length * cis(theta);
    output b1: Point = length + length * cis(theta);
    output b2: Point = 2 * length + length * cis(theta);
    ground 0, vec2(length, 0), vec2(2 * length, 0);
    body first: 0, b0;
    body second: vec2(length, 0), b1;
    body third: vec2(2 * length, 0), b2;
    body coupler: b0, b1, b2;
}

crate::mechanism! {
    /// Two wheels in mesh, of which the second one is held by an equation.
    struct Wheels { distance: Length, ratio: Scalar }
    input theta: Angle;
    unknown phi: Angle;
    phi == -ratio * theta;
    output rim: Point = distance + polar(distance / 3, phi);
    let tooth = polar(distance / 2, theta);
    ground 0, vec2(distance, 0);
    body pinion: 0, tooth;
    body wheel: vec2(distance, 0), rim;
}

crate::mechanism! {
    /// A crank and a rod that are said to be one body.
    struct Bent { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, s: Length;
    crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
    let pin = crank * cis(theta);
    ground 0;
    body both: 0, pin, vec2(s, 0);
}

pub(super) fn still(reactions: &NamedReactions<'_>, inputs: &[f64]) -> Result<Reactions, ReactionError> {
    let inputs: Vec<Motion> = inputs
        .iter()
        .map(|input| Motion::at_constant_speed(*input, 1.0))
        .collect();
    reactions.at(&inputs, PositionChoice::Assembly(0))
}

pub(super) fn message<T>(result: Result<T, ReactionError>) -> String {
    result.err().expect("a mistake").to_string()
}

#[test]
fn a_coupler_on_three_cranks() {
    let linkage = AnyLinkage::of(&NFourBar { length: 1.0 });
    let loads = linkage
        .loads()
        .gravity(Plane::new(0.0, -9.81))
        .mass_of("coupler", 2.0, "b1", 0.0);
    let loads = loads.expect("its bodies are declared");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    assert_eq!(
        message(still(&reactions, &[1.1])),
        "the drive of `theta` could act on each of `first`, `second`, `third`, on which the forces in joints depend: \
         say which by `driving`, or in a file by `drive of .. = ..;`"
    );
    let reactions = reactions.driving("theta", "first").expect("a body");
    let found = still(&reactions, &[1.1]).expect("it has a solution");
    // the cranks share the coupler in their directions, and that alone is open
    let error = found.of("b1").expect_err("it is not determined");
    let ReactionError::Undetermined { all, .. } = &error else {
        panic!("{error}")
    };
    assert_eq!(
        all.iter().map(String::as_str).collect::<Vec<_>>(),
        ["ground_first", "ground_second", "ground_third", "b0", "b1", "b2"]
    );
    let typed = Loads::<NFourBar>::new()
        .gravity(Plane::new(0.0, -9.81))
        .mass(2.0, |pose| pose.b1);
    let own = found.effort(0).expect("the drive is determined");
    let balance = NFourBar { length: 1.0 }.balance(&typed, [Motion::at_constant_speed(1.1, 1.0)]);
    for (own, other) in own.iter().zip(balance.expect("it closes").efforts()[0].as_slice()) {
        assert!((own - other).abs() < 1e-13 * (1.0 + other.abs()), "{own} {other}");
    }
}

/// The cranks and the coupler lie on one line.
#[test]
fn a_change_point_is_singular() {
    let linkage = AnyLinkage::of(&NFourBar { length: 1.0 });
    let reactions = linkage.reactions(&linkage.loads()).expect("its bodies are declared");
    let reactions = reactions.driving("theta", "first").expect("a body");
    let error = still(&reactions, &[0.0]).expect_err("it is singular");
    let ReactionError::Singular { pivot, grows } = &error else {
        panic!("{error}")
    };
    assert!(*pivot < 1e-12, "{pivot}");
    assert!(grows.contains(&"b2".to_string()), "{grows:?}");
    assert!(
        error
            .to_string()
            .starts_with("the position is singular: towards it the forces `"),
        "{error}"
    );
}

#[test]
fn what_no_joint_holds() {
    let linkage = AnyLinkage::of(&Wheels {
        distance: 0.3,
        ratio: 1.5,
    });
    let reactions = linkage.reactions(&linkage.loads()).expect("its bodies are declared");
    let error = still(&reactions, &[0.4]);
    assert_eq!(
        message(error),
        "the joints leave `wheel` 1 freedom while the inputs stand: declare the joint that is missing; if gears or \
         racks stand for `phi == -ratio * theta`, say by `rolling`, in a file by `gears` or `rack`, \
         which bodies they are"
    );
}

#[test]
fn bodies_are_rigid() {
    let linkage = AnyLinkage::of(&Bent { crank: 1.0, rod: 3.0 });
    let reactions = linkage.reactions(&linkage.loads()).expect("its bodies are declared");
    let expected = "the points of the body `both` do not keep their distances: one moves against the others by ";
    let error = message(still(&reactions, &[0.4]));
    assert!(error.starts_with(expected), "{error}");
}

#[test]
fn guesses_are_shown() {
    let linkage = library::FourBar {
        r1: 0.9,
        r2: 0.3,
        r3: 0.8,
        r4: 0.6,
    };
    let linkage = AnyLinkage::of(&linkage);
    assert_eq!(
        message(linkage.reactions(&linkage.loads())),
        "the declaration does not state its bodies, on which the forces in joints depend; if this is how they are \
         joined, add\n\
         ground 0, vec2(r1, 0);\n\
         body r2: 0, r2 * cis(theta2);\n\
         body r3: r2 * cis(theta2), r2 * cis(theta2) + r3 * cis(theta3);\n\
         body r4: r2 * cis(theta2) + r3 * cis(theta3), vec2(r1, 0);"
    );
}

#[test]
fn rates_end() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let reactions = linkage.reactions(&linkage.loads()).expect("its bodies are declared");
    let sweep = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[1.0], 3);
    let error = |name, order| {
        let quantity = sweep.of_reaction(&reactions, name, ReactionPart::X, order);
        quantity.peak().expect_err("a mistake").to_string()
    };
    assert_eq!(
        error("knee", 3),
        "a force in a joint has the orders 0, 1 and 2, its value and two rates: there is no order 3"
    );
    assert!(error("nee", 0).starts_with("there is no reaction `nee`; there is `base`"));
}

#[test]
fn loads_without_a_place() {
    let linkage = AnyLinkage::of(&FOUR_BAR);
    let error = |loads: NamedLoads| {
        message(still(
            &linkage.reactions(&loads).expect("its bodies are declared"),
            &[0.7],
        ))
    };
    assert_eq!(
        error(linkage.loads().mass(1.0, "knee").expect("a point")),
        "load 1, at `knee`, could act on each of `coupler`, `rocker`, on which the forces in joints depend: let it \
         act on a point that one body alone has"
    );
    assert_eq!(
        error(
            linkage
                .loads()
                .mass_of("crank", -1.0, "crank_centre", 0.0)
                .expect("a body")
        ),
        "load 1: the mass is -1: give one that is not negative; a hole is part of its link, whose mass and centre are \
         those of the whole"
    );
    let missing = linkage
        .loads()
        .mass_of("crnk", 1.0, "crank_centre", 0.0)
        .expect_err("no body");
    assert_eq!(
        missing.to_string(),
        "there is no body `crnk`; there is `crank`, `coupler`, `rocker`"
    );
    let bare = NamedLoads::new(linkage.description()).mass_of("crank", 1.0, "crank_centre", 0.0);
    assert_eq!(
        bare.expect_err("no bodies").to_string(),
        "there is no body `crank`; state the bodies, as in `body crank: 0, pin;`"
    );
}

/// Near the limit of a rocker that drives, forces grow with one over the root of the distance; at it, there is no pose.
#[test]
fn limits_have_no_forces() {
    let rocker = super::FourBar {
        r1: 0.9,
        r2: 0.6,
        r3: 0.3,
        r4: 0.45,
    };
    let linkage = AnyLinkage::of(&rocker);
    let loads = linkage.loads().torque(1.0, "theta4").expect("an angle");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    // cos θ = (r1² + r2² - (r3 + r4)²) / (2 r1 r2)
    let limit = ((0.81 + 0.36 - 0.75 * 0.75) / (2.0 * 0.9 * 0.6_f64)).acos();
    let force = |distance: f64| {
        let found = still(&reactions, &[limit - distance]).expect("it is determined");
        found.of("knee").expect("it is determined").magnitude()[0]
    };
    let ratio = force(1e-8) / force(1e-6);
    assert!((ratio - 10.0).abs() < 0.1, "{ratio}");
    let error = still(&reactions, &[limit + 1e-6]).expect_err("it does not close");
    assert!(matches!(error, ReactionError::Solve(_)), "{error}");
}
