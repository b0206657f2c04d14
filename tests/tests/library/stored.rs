//! Everything that a program stores comes back from JSON as it was.

use std::collections::BTreeMap;
use std::fmt::Debug;

use kin_core::library::*;
use kin_core::prelude::*;
use kin_core::stored::{self, DescriptionRecord, FailureRecord, ParameterRecord, PoseRecord, SolveErrorRecord};
use kin_core::{Rotation, track};
use kin_tests::mechanisms::cases::{self, Case, Inputs, ThroughSnap, Visitor};
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

fn text(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("it can be written")
}

/// The value, after it has been written and read.
fn travelled<V: Serialize + DeserializeOwned>(value: &V) -> V {
    serde_json::from_str(&text(value)).expect("it has been written like this")
}

fn refusal<V: DeserializeOwned + Debug>(text: &str) -> String {
    serde_json::from_str::<V>(text)
        .expect_err("this is not sound")
        .to_string()
}

/// The dimensions of each mechanism of the library.
#[derive(Default)]
struct Dimensions(BTreeMap<&'static str, Case>);

impl Visitor for Dimensions {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        self.0.insert(M::DESCRIPTION.name, case);
    }
}

/// The number of poses of each mechanism in each assembly.
const STEPS: u32 = if cfg!(feature = "every-case") { 60 } else { 24 };

impl Dimensions {
    /// Parameters, poses and assemblies of one mechanism.
    fn travel<M>(&mut self)
    where
        M: ThroughSnap + PartialEq + Serialize + DeserializeOwned,
        M::Pose: Serialize + Into<PoseRecord<M>>,
        M::Assembly: Serialize + DeserializeOwned,
        Inputs<M>: Into<M::Inputs<M::Motion<f64>>>,
    {
        let name = M::DESCRIPTION.name;
        let case = self.0.remove(name);
        let case = case.unwrap_or_else(|| panic!("tests/src/mechanisms/cases.rs has no dimensions of {name}"));
        let mut random = Random::new(14);
        let mut poses = 0_u32;
        for step in 0..STEPS {
            let mechanism: M = case.varied(&mut random);
            assert_eq!(travelled(&mechanism), mechanism);
            assert_eq!(travelled(&ParameterRecord(mechanism)), ParameterRecord(mechanism));
            assert_eq!(text(&mechanism), text(&ParameterRecord(mechanism)));

            let inputs = case.inputs::<M>(f64::from(step) / f64::from(STEPS), &mut random);
            let near = M::Unknowns::from_fn(|_| random.between(-2.0, 2.0));
            let values = M::Inputs::from_fn(|input| inputs[input].value());
            let nearby = mechanism.assembly_at(values, near);
            for assembly in M::assemblies().chain([nearby]) {
                assert_eq!(travelled(&assembly), assembly, "{name}");
                if let Ok(pose) = mechanism.solve(inputs, assembly) {
                    poses += 1;
                    assert_returns(&mechanism, &pose);
                }
            }
        }
        // one in five random guesses leads a coupled block to a position
        assert!(12 * poses >= STEPS, "{name}: {poses} poses");
    }
}

fn assert_returns<M>(mechanism: &M, pose: &M::Pose)
where
    M: ThroughSnap,
    M::Pose: Serialize + Into<PoseRecord<M>>,
    Inputs<M>: Into<M::Inputs<M::Motion<f64>>>,
{
    let name = M::DESCRIPTION.name;
    let record: PoseRecord<M> = (*pose).into();
    assert_eq!(text(pose), text(&record));
    assert_eq!(record.unknowns.as_ref(), pose.unknown_motions().as_ref());
    assert_eq!(record.outputs.as_ref(), pose.output_motions().as_ref());
    let read: PoseRecord<M> = serde_json::from_str(&text(pose)).expect("a pose is written as its record");
    assert_eq!(read, record);

    // Solved again, it is the same pose up to rounding.
    let again = read.solve(mechanism).expect("it has been solved before");
    if M::ASSEMBLY_COUNT > 0 {
        // Nothing is iterated.
        assert_eq!(again.unknown_motions().as_ref(), record.unknowns.as_ref(), "{name}");
    }
    let gauge = Gauge::new(mechanism, &record.inputs, &record.unknowns);
    for (index, (again, before)) in again
        .unknown_motions()
        .as_ref()
        .iter()
        .zip(record.unknowns.as_ref())
        .enumerate()
    {
        for (order, allowed) in ALLOWED.into_iter().enumerate() {
            let allowed = allowed * gauge.unknown(index, order);
            let apart = (again[order] - before[order]).abs();
            assert!(
                apart <= allowed,
                "{name}, unknown {index}, order {order}: {apart:e} apart, allowed {allowed:e}"
            );
        }
    }
}

macro_rules! travel {
    ($($mechanism:ident)+) => {{
        let mut dimensions = Dimensions::default();
        cases::library(&mut dimensions);
        cases::coupled_library(&mut dimensions);
        $(dimensions.travel::<$mechanism>();)+
        assert!(dimensions.0.is_empty(), "{:?} are left out", dimensions.0);
    }};
}

#[test]
fn all_mechanisms_of_the_library_travel() {
    kin_core::each_library_mechanism!(travel);
}

mechanism! {
    /// A crank with a point, in the plane.
    #[derive(Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub struct Derived {
        pub pivot: Point,
        #[serde(default)]
        pub crank_arm: Length,
    }
    input phi: Angle;
    unknown reach: Length where reach > 0, theta: Direction;
    reach * cis(theta) == crank_arm * cis(2 * phi);
    output tip: Point = pivot + crank_arm * cis(theta);
}

mechanism! {
    /// The same in space, without a derive.
    pub struct Spatial { pub pivot: Point3, pub arm: Length }
    input phi: Angle;
    unknown x: Length, y: Length;
    x == dot(pivot + arm * vec3(cos(phi), sin(phi), 0), vec3(1, 0, 0));
    y == arm * sin(phi);
    order = 2;
}
kin_core::storable!(Spatial);

#[test]
fn a_structure_of_the_user_derives() {
    let derived = Derived {
        pivot: Plane::new(0.1, -0.2),
        crank_arm: 2.5,
    };
    assert_eq!(text(&derived), r#"{"pivot":{"x":0.1,"y":-0.2},"crank-arm":2.5}"#);
    assert_eq!(travelled(&derived), derived);
    let single: Derived<f32> = serde_json::from_str(r#"{"pivot":{"x":0.1,"y":-0.2}}"#).expect("the arm has a default");
    assert_eq!((single.pivot.x, single.crank_arm), (0.1, 0.0));
}

#[test]
fn without_a_derive_the_structure_is_storable() {
    let spatial = Spatial {
        pivot: Space::new(1.0, 2.0, 3.0),
        arm: 0.5,
    };
    assert_eq!(text(&spatial), r#"{"pivot":{"x":1.0,"y":2.0,"z":3.0},"arm":0.5}"#);
    assert_eq!(travelled(&spatial), spatial);
    let turned: Spatial = serde_json::from_str(r#"{"arm":0.5,"pivot":{"z":3,"x":1,"y":2}}"#).expect("in any order");
    assert_eq!(turned, spatial);
    for (wrong, message) in [
        (r#"{"arm":0.5}"#, "missing field `pivot`"),
        (r#"{"arm":0.5,"arm":0.5}"#, "duplicate field `arm`"),
        (
            r#"{"arm":0.5,"length":2.0}"#,
            "invalid value: string \"length\", expected one of the names `pivot`, `arm`",
        ),
        (r#"{"arm":null}"#, "arm: invalid type: null, expected f64"),
        (
            r#"{"pivot":{"x":1.0,"y":"a"}}"#,
            "pivot: invalid type: string \"a\", expected f64",
        ),
        (r#"{"pivot":{"x":1.0,"y":2.0}}"#, "pivot: missing field `z`"),
    ] {
        let refusal = refusal::<Spatial>(wrong);
        assert!(refusal.starts_with(message), "{refusal}");
    }
}

/// A pose of every order is written by names. A direction is written as its angle.
#[test]
fn a_pose_is_written_by_names() -> Result<(), SolveError> {
    let derived = Derived {
        pivot: Plane::new(1.0, 0.0),
        crank_arm: 2.0,
    };
    let velocity = derived.position(0.0)?.velocity(3.0);
    assert_eq!(
        text(&velocity).replace("-0.0", "0.0"),
        concat!(
            r#"{"mechanism":"Derived","inputs":{"phi":[0.0,3.0]},"unknowns":{"reach":[2.0,0.0],"theta":[0.0,6.0]},"#,
            r#""outputs":{"tip.x":[3.0,0.0],"tip.y":[0.0,12.0]}}"#
        )
    );
    let record: PoseRecord<Derived, 2> = serde_json::from_str(&text(&velocity)).expect("the order is right");
    assert_eq!(record, velocity.into());
    assert_eq!(
        derived
            .position_near(record.inputs[0].value(), record.near())?
            .velocity(3.0),
        velocity
    );

    let spatial = Spatial {
        pivot: Space::zero(),
        arm: 1.0,
    };
    let pose = spatial.solve(Motion::from([0.5, 1.0, 0.0]))?;
    let record: PoseRecord<Spatial, 3> = serde_json::from_str(&text(&pose)).expect("its order is the second");
    assert_eq!(record.solve(&spatial)?, pose);
    Ok(())
}

#[test]
fn a_record_of_something_else_is_refused() {
    for (wrong, message) in [
        (
            r#"{"mechanism":"FourBar","inputs":{}}"#,
            "invalid value: string \"FourBar\", expected a pose of the mechanism `Derived`",
        ),
        (
            r#"{"mechanism":"Derived","inputs":{"theta":[0.0]}}"#,
            "inputs: invalid value: string \"theta\", expected one of the names `phi`",
        ),
        (r#"{"mechanism":"Derived","inputs":{}}"#, "inputs.phi is missing"),
        (
            r#"{"mechanism":"Derived","inputs":{"phi":[0.0,1.0]}}"#,
            "inputs.phi: trailing characters",
        ),
        (
            r#"{"mechanism":"Derived","inputs":{"phi":[]}}"#,
            "inputs.phi: invalid length 0, expected a row of 1",
        ),
        (
            r#"{"mechanism":"Derived","inputs":{"phi":[0.0],"phi":[0.0]}}"#,
            "inputs.phi: stands there twice",
        ),
        (
            r#"{"mechanism":"Derived","inputs":{"phi":[null]}}"#,
            "inputs.phi: [0]: invalid type: null, expected f64",
        ),
        (
            r#"{"mechanism":"Derived","inputs":{"phi":[0.0]},"outputs":{"tip.x":[0.0],"tip.y":[0.0]}}"#,
            "missing field `unknowns`",
        ),
    ] {
        let refusal = refusal::<PoseRecord<Derived, 1>>(wrong);
        assert!(refusal.starts_with(message), "{refusal}");
    }
}

#[test]
fn numbers_that_are_not_finite_are_refused_by_name() -> Result<(), SolveError> {
    let refused =
        |written: Result<String, serde_json::Error>| written.expect_err("JSON has no such number").to_string();
    let nan = Motion::from([Plane::new(0.0, 1.0), Plane::new(f64::NAN, 1.0)]);
    assert_eq!(
        refused(serde_json::to_string(&nan)),
        "[1].x is NaN, and only finite numbers can be stored"
    );
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: f64::NEG_INFINITY,
        r4: 45.0,
    };
    assert_eq!(
        refused(serde_json::to_string(&[linkage])),
        "r3 is -inf, and only finite numbers can be stored"
    );
    assert_eq!(
        stored::check(&[linkage]).expect_err("it is the same").to_string(),
        "[0].r3 is -inf, and only finite numbers can be stored"
    );
    assert_eq!(
        refused(serde_json::to_string(&Near([0.0, f64::NAN]))),
        "[1] is NaN, and only finite numbers can be stored"
    );
    let direction = kin_core::Direction::new(Plane::new(f64::NAN, 0.0), [0.0]);
    assert_eq!(
        refused(serde_json::to_string(&direction)),
        "unit.x is NaN, and only finite numbers can be stored"
    );
    // What the user derives, serde writes; the check names it before.
    let derived = Derived {
        pivot: Plane::new(0.0, 0.0),
        crank_arm: f64::NAN,
    };
    assert_eq!(
        stored::check(&derived).expect_err("it is NaN").to_string(),
        "crank-arm is NaN, and only finite numbers can be stored"
    );
    let linkage = FourBar { r3: 60.0, ..linkage };
    let pose = linkage.position(1.0, Assembly::Open)?.velocity(f64::INFINITY);
    assert_eq!(
        refused(serde_json::to_string(&pose)),
        "inputs.theta2[1] is inf, and only finite numbers can be stored"
    );
    Ok(())
}

/// Every type with numbers, each with NaN and both infinities: no JSON, and an error that names the place.
#[test]
fn every_type_refuses_numbers_that_are_not_finite() -> Result<(), SolveError> {
    fn refuses(place: &str, number: f64, value: &impl Serialize) {
        let expected = format!("{place} is {number}, and only finite numbers can be stored");
        let refusal = serde_json::to_string(value).expect_err("JSON has no such number");
        assert_eq!(refusal.to_string(), expected);
        assert_eq!(stored::check(value).expect_err("it is the same").to_string(), expected);
        // a part of another value keeps its own place
        let refusal = serde_json::to_string(&[Some(value)]).expect_err("JSON has no such number");
        assert_eq!(refusal.to_string(), expected);
    }
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let pose = linkage.solve(1.0, Assembly::Open)?;
    for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refuses("y", number, &Plane::new(1.0, number));
        refuses("z", number, &Space::new(1.0, 2.0, number));
        refuses("[3]", number, &Motion::new([0.0, 0.0, 0.0, number, 0.0]));
        #[expect(clippy::cast_possible_truncation, reason = "no digit matters")]
        let single = number as f32;
        refuses("[0]", number, &Motion::new([single]));
        refuses(
            "rates[1]",
            number,
            &kin_core::Direction::new(Plane::new(1.0, 0.0), [0.0, number]),
        );
        refuses("[1]", number, &Near([0.0, number]));
        let rows = Rotation::about(Space::new(number, 0.0, 0.0), 1.0);
        assert!(serde_json::to_string(&rows).is_err());
        refuses("r2", number, &FourBar { r2: number, ..linkage });
        refuses(
            "r4",
            number,
            &stored::ParameterRecord(FourBar { r4: number, ..linkage }),
        );
        let mut record = PoseRecord::from(pose);
        record.unknowns[1] = Motion::new([1.0, 2.0, number, 3.0, 4.0]);
        refuses("unknowns.theta4[2]", number, &record);
        // a rate is not examined before the pose of the next order
        let position = linkage.position(1.0, Assembly::Open)?;
        refuses("inputs.theta2[1]", number, &position.velocity(number));
        let velocity = position.velocity(1.0);
        refuses("inputs.theta2[2]", number, &velocity.acceleration(number));
        let acceleration = velocity.acceleration(1.0);
        refuses("inputs.theta2[3]", number, &acceleration.jerk(number));
        refuses("inputs.theta2[4]", number, &acceleration.jerk(1.0).snap(number));
    }
    let derived = Derived {
        pivot: Plane::new(0.0, 0.0),
        crank_arm: 1.0,
    };
    let position = derived.position(0.3).expect("it closes");
    let mut record = PoseRecord::from(position);
    record.outputs[1] = Motion::new([f64::NAN]);
    refuses("outputs.tip.y[0]", f64::NAN, &record);
    Ok(())
}

#[test]
fn values_travel() {
    let rotation = Rotation::about(Space::new(1.0, 2.0, -0.5), 0.7);
    assert_eq!(travelled(&rotation), rotation);
    let motion: Motion<f64, 13> = Motion::at_constant_speed(0.1, 0.3);
    assert_eq!(travelled(&motion), motion);
    let direction = kin_core::Direction::new(Plane::new(0.6, 0.8), [1.0, 2.0]);
    assert_eq!(text(&direction), r#"{"unit":{"x":0.6,"y":0.8},"rates":[1.0,2.0]}"#);
    assert_eq!(travelled(&direction), direction);
    assert_eq!(text(&Assembly::Crossed), r#""Crossed""#);
    let six_bar = StephensonIII::ASSEMBLIES[1];
    assert!(text(&six_bar).starts_with(r#"{"theta"#), "{}", text(&six_bar));
}

#[test]
fn errors_are_written_with_their_messages_and_read_as_records() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let error = linkage.position(2.5, Assembly::Open).expect_err("it is out of reach");
    let record: SolveErrorRecord = serde_json::from_str(&text(&error)).expect("the error is written like its record");
    assert_eq!(record, error.into());
    assert_eq!(record.message, error.to_string());
    let FailureRecord::OutOfReach { margin } = record.failure else {
        panic!("{record:?}");
    };
    assert_eq!(Some(margin), error.margin());
    assert_eq!(travelled(&record), record);

    // The number that is the reason for the error is not lost.
    let error = linkage
        .position(f64::NAN, Assembly::Open)
        .expect_err("it is not a number");
    let record: SolveErrorRecord = serde_json::from_str(&text(&error)).expect("NaN is written as a word");
    assert!(record.inputs["theta2"].is_nan(), "{record:?}");

    let start = linkage.position(1.0, Assembly::Open).expect("it closes");
    let error = track(&linkage, [1.0], start.unknowns(), [2.5]).expect_err("it has a limit");
    let text: serde_json::Value = serde_json::from_str(&text(&error)).expect("it is JSON");
    assert_eq!(text["message"], error.to_string());
    assert!(text["reason"]["TurningPoint"]["fraction"].is_f64(), "{text}");
}

#[test]
fn a_description_is_read_as_a_record() {
    let description = AndrewsSqueezer::<f64>::DESCRIPTION;
    let record: DescriptionRecord = serde_json::from_str(&text(&description)).expect("it is written like its record");
    assert_eq!(record, description.into());
    assert_eq!(travelled(&record), record);
    assert_eq!(record.parameters[0].name, description.parameters[0].name);
}
