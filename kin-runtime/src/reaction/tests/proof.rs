//! Proved bounds beside forces in single poses, over inputs and over tolerances.

use std::f64::consts::TAU;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::{ENGINE, FOUR_BAR, FourBar, LIFT, heavy, pin, rubbed};
use crate::any::{AssemblyChoice, Of, PositionChoice};
use crate::geometry::Plane;
use crate::library;
use crate::linkage::{AnyLinkage, LinkageFunctions};
use crate::load::NamedLoads;
use crate::mechanism::Mechanism;
use crate::motion::Motion;
use crate::number::samples;
use crate::reaction::{
    ForceProof, ForceVerdict, NamedReactions, PeakBounds, ProofError, ReactionPart, UndecidedReason,
};
use crate::verify::Random;

/// The speeds and accelerations of the tests.
const SPEED: [f64; 2] = [11.0, 12.0];
const ACCELERATION: [f64; 2] = [-8.0, 3.0];

/// A motion of a linkage, of which forces are proved.
struct Case {
    functions: &'static dyn LinkageFunctions,
    linkage: AnyLinkage<'static>,
    loads: NamedLoads,
    assembly: AssemblyChoice,
    range: [f64; 2],
    /// The dimensions with tolerances.
    tolerances: Vec<(usize, f64)>,
}

impl Case {
    /// A motion with all masses, without tolerances.
    fn new<M: Mechanism<Scalar = f64>>(mechanism: &M, range: [f64; 2]) -> Self {
        let linkage = AnyLinkage::of(mechanism);
        Self {
            functions: Of::<M>::FUNCTIONS,
            loads: heavy(&linkage),
            linkage,
            assembly: AssemblyChoice::Index(0),
            range,
            tolerances: Vec::new(),
        }
    }

    /// The same with a tolerance of some dimensions, as a part of them.
    fn within(mut self, part: f64, which: &[usize]) -> Self {
        let value = |index: usize| self.linkage.parameters()[index];
        self.tolerances = which.iter().map(|index| (*index, part * value(*index).abs())).collect();
        self
    }

    fn reactions(&self) -> NamedReactions<'static> {
        self.linkage
            .reactions_as_guessed(&self.loads)
            .expect("bodies of the plane")
    }

    fn proof<'r>(&self, reactions: &'r NamedReactions<'r>) -> ForceProof<'r> {
        let [from, to] = self.range;
        let sweep = self.linkage.sweep(self.assembly.clone()).between(&[from], &[to], 2);
        let proof = sweep.speed(SPEED[1]).proof(reactions);
        self.tolerances.iter().fold(proof, |proof, (index, tolerance)| {
            let name = self.linkage.description().parameters[*index].name;
            proof.tolerance(name, *tolerance).expect("a dimension")
        })
    }

    /// The largest size of a part of a force at `count` inputs, for the dimensions and for random ones of the corners,
    /// and at one of some speeds and accelerations for each.
    fn sampled(&self, name: &str, part: ReactionPart, count: u32, moves_freely: bool) -> f64 {
        let mut random = Random::new(7);
        let mut largest = 0.0_f64;
        for corner in 0..6 {
            let mut parameters = self.linkage.parameters().to_vec();
            let mut sign = || if random.between(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
            for (index, tolerance) in self.tolerances.iter().filter(|_| corner > 0) {
                parameters[*index] += sign() * tolerance;
            }
            let (mut speed, mut acceleration) = (SPEED[1], 0.0);
            if moves_freely {
                speed = random.between(SPEED[0], SPEED[1]);
                acceleration = random.between(ACCELERATION[0], ACCELERATION[1]);
            }
            let linkage = AnyLinkage::new(self.functions, &parameters);
            let reactions = linkage.reactions_as_guessed(&self.loads).expect("bodies of the plane");
            let mut near = linkage
                .position(&[self.range[0]], self.assembly.position())
                .expect("it closes");
            for row in 0..=count {
                let at = self.range[0] + (self.range[1] - self.range[0]) * f64::from(row) / f64::from(count);
                near = linkage.position(&[at], PositionChoice::Near(&near)).expect("it closes");
                let crank = motion([at, speed, acceleration]);
                let found = reactions.at(&[crank], PositionChoice::Near(&near)).expect("a pose");
                let [force, ..] = found.of(name).expect("it is determined").part(part);
                largest = largest.max(force.abs());
            }
            if self.tolerances.is_empty() && !moves_freely {
                break;
            }
        }
        largest
    }
}

fn motion([at, velocity, acceleration]: [f64; 3]) -> Motion {
    Motion::from((at, velocity, acceleration, 0.0, 0.0))
}

/// The bounds hold what is sampled and are close to it, a limit above them is proved, and one below is refuted there.
fn compare(case: &Case, name: &str, part: ReactionPart) {
    let reactions = case.reactions();
    let force = case.proof(&reactions).of(name, part).expect("a force");
    let PeakBounds { lower, upper, .. } = force.peak(5e-3).expect("it is proved");
    let sampled = case.sampled(name, part, samples::of(1000), false);
    let tightness = upper / sampled;
    std::println!("{name} {part:?}: {sampled} of {upper}, {tightness}");
    assert!(sampled <= upper && lower.force <= upper && upper <= 1.005 * lower.force);
    // few corners are sampled, and few inputs
    let lacking = if case.tolerances.is_empty() { 0.006 } else { 0.03 };
    assert!(tightness < 1.0 + lacking, "{name}: {sampled} {upper}");
    let holds = force.below(1.001 * upper).expect("an answer");
    assert!(
        matches!(holds, ForceVerdict::Holds { upper: own, .. } if own <= 1.001 * upper),
        "{holds:?}"
    );
    let ForceVerdict::Fails(place) = force.below(0.999 * lower.force).expect("an answer") else {
        panic!("{name} is more")
    };
    // the place is within the bounds, and the force there is what it is said to be
    let linkage = AnyLinkage::new(case.functions, &place.dimensions);
    for (index, tolerance) in &case.tolerances {
        let change = (place.dimensions[*index] - case.linkage.parameters()[*index]).abs();
        assert!(change <= tolerance * (1.0 + 1e-9), "{place:?}");
    }
    let reactions = linkage.reactions_as_guessed(&case.loads).expect("bodies of the plane");
    let mut near = linkage
        .position(&[case.range[0]], case.assembly.position())
        .expect("it closes");
    for part in 1..=20 {
        let at = case.range[0] + (place.at - case.range[0]) * f64::from(part) / 20.0;
        near = linkage.position(&[at], PositionChoice::Near(&near)).expect("it closes");
    }
    let crank = motion([place.at, place.velocity, place.acceleration]);
    let found = reactions.at(&[crank], PositionChoice::Near(&near)).expect("a pose");
    let [own, ..] = found.of(name).expect("it is determined").part(part);
    assert!(
        (own.abs() - place.force).abs() <= 1e-9 * upper && own.abs() > 0.998 * lower.force,
        "{own} {place:?}"
    );
}

#[test]
fn four_bars() {
    let mut random = Random::new(3);
    for _ in 0..samples::of(10) {
        // by Grashof's condition, each is a crank-rocker
        let [r1, r2, r3, r4] =
            [(0.8, 1.0), (0.2, 0.3), (0.7, 0.9), (0.65, 0.7)].map(|(low, high)| random.between(low, high));
        let case = Case::new(&FourBar { r1, r2, r3, r4 }, [0.0, TAU]);
        compare(&case, "knee", ReactionPart::Force);
        compare(&case, "base", ReactionPart::Y);
        compare(&case.within(1e-3, &[0, 1, 2, 3]), "pin", ReactionPart::Force);
    }
}

#[test]
fn slides_and_moments() {
    let engine = Case::new(&ENGINE, [TAU, 0.0]);
    compare(&engine, "pin", ReactionPart::Force);
    compare(&engine, "piston_slide", ReactionPart::Force);
    compare(&engine.within(2e-3, &[0, 1]), "piston_slide", ReactionPart::Moment);
    let mut lift = Case::new(&LIFT, [0.4, 2.2]);
    let springs = lift
        .loads
        .spring(300.0, 0.1, "load", Plane::new(0.5, 0.2))
        .and_then(|loads| loads.damper(20.0, "load", Plane::new(0.1, 0.9)))
        .and_then(|loads| loads.torsion_spring(4.0, 0.3, "chi"))
        .and_then(|loads| loads.torsion_damper(3.0, "height"))
        .and_then(|loads| loads.inertia(0.04, "psi"));
    lift.loads = springs.expect("all names are there");
    compare(&lift, "foot_slide", ReactionPart::Moment);
    compare(&lift, "edge", ReactionPart::Force);
    let inverted: library::InvertedSliderCrank = library::InvertedSliderCrank { r1: 0.5, r2: 0.2 };
    let case = Case::new(&inverted, [0.0, TAU]);
    let names: Vec<String> = case.reactions().names().map(ToString::to_string).collect();
    compare(&case, &names[0], ReactionPart::Force);
}

#[test]
fn six_bars() {
    let watt = library::WattI {
        r1: 0.9,
        r2: 0.3,
        r3: 0.8,
        r4: 0.6,
        p: Plane::new(0.35, 0.1),
        q: Plane::new(0.4, 0.3),
        r5: 0.5,
        r6: 0.45,
    };
    let case = Case::new(&watt, [0.6, 1.4]);
    let names: Vec<String> = case.reactions().names().map(ToString::to_string).collect();
    compare(&case, &names[2], ReactionPart::Force);
    compare(&case.within(5e-4, &[1, 4, 8]), &names[0], ReactionPart::Force);
}

/// A block without a closed form, whose position is followed from the beginning.
#[test]
fn coupled_blocks() {
    let triad = library::StephensonII {
        r1: 4.0,
        r2: 2.0,
        p: Plane::new(1.5, 1.2),
        r3: 3.0,
        q: Plane::new(0.3, 1.0),
        r4: 0.5,
        r5: 1.6,
        r6: 3.0,
    };
    let mut case = Case::new(&triad, [-0.2, 0.2]);
    let (all, _) = case.linkage.positions_at(&[case.range[0]]).expect("it closes");
    case.assembly = AssemblyChoice::Near(all[0].clone());
    let names: Vec<String> = case.reactions().names().map(ToString::to_string).collect();
    compare(&case, &names[1], ReactionPart::Force);
    case.range = [-0.2, -0.1];
    compare(&case.within(1e-4, &[0]), &names[0], ReactionPart::Force);
}

/// The torque of the drive, at any speed and acceleration of a range.
#[test]
fn speeds_and_accelerations() {
    let case = Case::new(&FOUR_BAR, [0.0, TAU]);
    let reactions = case.reactions();
    let proof = || {
        let proof = case.proof(&reactions).speed_within(SPEED[0]..=SPEED[1]);
        proof.acceleration_within(ACCELERATION[0]..=ACCELERATION[1])
    };
    let knee = proof().of("knee", ReactionPart::Force).expect("a force");
    let found = knee.peak(3e-2).expect("it is proved");
    let sampled = case.sampled("knee", ReactionPart::Force, samples::of(1000), true);
    assert!(
        sampled <= found.upper && found.upper <= 1.15 * sampled,
        "{sampled} {found:?}"
    );
    let effort = proof().of_effort(0).expect("a drive").peak(3e-2).expect("it is proved");
    let place = &effort.lower;
    let crank = motion([place.at, place.velocity, place.acceleration]);
    let own = reactions
        .at(&[crank], PositionChoice::Assembly(0))
        .expect("a pose")
        .effort(0);
    let [own, ..] = own.expect("it is determined");
    assert!((own.abs() - place.force).abs() < 1e-10 * effort.upper);
    let sweep = case
        .linkage
        .sweep(case.assembly.clone())
        .between(&[0.0], &[TAU], 91)
        .speed(SPEED[1]);
    let steady = sweep
        .of_effort_with_friction(&reactions, 0, 0)
        .peak()
        .expect("it closes");
    assert!(steady.value.abs() <= effort.upper);
}

/// Where the range leaves the poses, or comes close to it, nothing is proved, and the place is told.
#[test]
fn limits_and_change_points() {
    let rocker = FourBar {
        r1: 0.9,
        r2: 0.3,
        r3: 0.6,
        r4: 0.45,
    };
    // the crank swings until coupler and rocker are stretched
    let limit = (-0.375_f64).acos();
    let case = Case::new(&rocker, [1.0, 2.5]);
    let reactions = case.reactions();
    let knee = case.proof(&reactions).of("knee", ReactionPart::Force).expect("a force");
    let ForceVerdict::Undecided(found) = knee.below(1e40).expect("an answer") else {
        panic!("the pose ends")
    };
    let [low, high] = found.range;
    assert!(
        found.reason == UndecidedReason::Pose && low <= limit && limit <= high,
        "{found:?}"
    );
    // towards the limit, the force exceeds whatever is reached before it
    assert!(matches!(knee.below(20.0), Ok(ForceVerdict::Fails(place)) if place.at < limit));
    let error = knee.peak(1e-2).expect_err("the pose ends").to_string();
    assert!(error.starts_with("from the input 1.95519"), "{error}");
    // up to a place before the limit all is proved, but not with tolerances that reach it
    let before = Case::new(&rocker, [1.0, limit - 1e-2]);
    let proof = |part: f64| {
        let case = Case::new(&rocker, before.range).within(part, &[2, 3]);
        let reactions = case.reactions();
        let knee = case.proof(&reactions).budget(2000).of("knee", ReactionPart::Force);
        knee.expect("a force").below(1e6).expect("an answer")
    };
    assert!(matches!(proof(0.0), ForceVerdict::Holds { .. }));
    assert!(matches!(proof(0.02), ForceVerdict::Undecided(found) if found.reason == UndecidedReason::Pose));
    // a parallelogram folds
    let parallelogram = FourBar {
        r1: 0.9,
        r2: 0.3,
        r3: 0.9,
        r4: 0.3,
    };
    let case = Case::new(&parallelogram, [0.5, 4.0]);
    let reactions = case.reactions();
    let knee = case.proof(&reactions).of("knee", ReactionPart::Force).expect("a force");
    let ForceVerdict::Undecided(found) = knee.below(1e40).expect("an answer") else {
        panic!("the pose is not proved")
    };
    assert!((found.range[1] - core::f64::consts::PI).abs() < 1e-3, "{found:?}");
}

#[test]
fn what_is_not_proved() {
    let case = Case::new(&FOUR_BAR, [0.0, TAU]);
    let reactions = case.reactions();
    let proof = || case.proof(&reactions);
    let text = |error: ProofError| format!("{error}");
    let knee = proof().of("knee", ReactionPart::Force).expect("a force");
    let ForceVerdict::Undecided(found) = proof()
        .budget(3)
        .of("knee", ReactionPart::Force)
        .expect("a force")
        .below(50.8)
        .expect("an answer")
    else {
        panic!("the budget is spent")
    };
    assert!(found.reason == UndecidedReason::Budget && found.force[0] < 50.8 && found.force[1] > 50.8);
    assert!(
        found.to_string().contains(" pieces do not decide: between the inputs "),
        "{found}"
    );
    let errors = [
        proof().tolerance("r5", 0.1).expect_err("no dimension"),
        proof().tolerance("r4", -0.1).expect_err("no tolerance"),
        proof().of("ankle", ReactionPart::Force).expect_err("no joint"),
        proof().of_effort(1).expect_err("no input"),
        proof().speed_within(1.0..=f64::NAN).of_effort(0).expect_err("no speed"),
        knee.below(f64::NAN).expect_err("no limit"),
    ];
    let rubbed = rubbed(reactions.clone(), &[("knee", pin(0.1, 0.01))]);
    let friction = case.proof(&rubbed).of_effort(0).expect_err("friction");
    let messages: Vec<String> = errors.into_iter().chain([friction]).map(text).collect();
    assert_eq!(
        messages,
        [
            "there is no dimension `r5`; there is `r1`, `r2`, `r3`, `r4`",
            "the tolerance of `r4` is -0.1: give a finite one from zero on",
            "there is no reaction `ankle`; there is `base`, `pivot`, `pin`, `knee`",
            "the drive of input 1, counted from 0, has no effort: there is no such input, or the mechanism is declared \
             without accelerations",
            "the inputs stand, or a dimension or a number of the motion is not finite: give a range that is finite and \
             has a length",
            "the limit is NaN: give a number from zero on",
            "the joints have friction, for which no proof is given: leave it out, or look at the peak along a sweep",
        ]
    );
}
