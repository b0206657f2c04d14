//! No solver allocates, and the sizes of what they return.
//!
//! The sizes are printed: `cargo test -p kin-tests --test speed allocation -- --nocapture`.
#![allow(clippy::cast_precision_loss, reason = "there are a hundred poses")]

use core::any::type_name;
use core::hint::black_box;

use allocation_counter::measure;
use kin_core::any::PositionChoice;
use kin_core::batch::{Batch, Column, Fold, FoldedNumber, InputGrid, Outcome, Slot, Vectors};
use kin_core::library::{
    self, ClassThreeTriad, ClassThreeTriadBatch, FourBar, FourBarBatch, StephensonII, WattIByDyad,
};
use kin_core::linkage::AnyLinkage;
use kin_core::prelude::*;
use kin_core::track;
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::mechanisms::sensitive::{self, SensitiveThroughSnap};
use kin_tests::random::Random;

/// Runs it, and asserts that it neither allocated nor freed: on this thread, as the tests run side by side.
#[track_caller]
fn without_allocation<M: Mechanism, R>(what: &str, run: impl FnOnce() -> R) -> R {
    let mut result = None;
    let allocations = measure(|| result = Some(black_box(run())));
    let name = M::DESCRIPTION.name;
    assert_eq!(allocations.count_total, 0, "{what} of {name} allocates");
    assert_eq!(allocations.count_current, 0, "{what} of {name} frees");
    result.expect("it has run")
}

/// The measure itself sees an allocation.
#[test]
fn allocations_are_counted() {
    let boxed = measure(|| drop(black_box(Box::new(1.0))));
    assert_eq!(boxed.count_total, 1);
    let grown = measure(|| drop(black_box(vec![1.0; black_box(100)])));
    assert_eq!((grown.count_total, grown.bytes_total), (1, 800));
}

mechanism! {
    /// Four-bar linkage whose joints have names.
    struct Press { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output pin: Point = r2 * cis(theta2);
    output knee: Point = r1 + r4 * cis(theta4);
    ground 0, vec2(r1, 0);
    body crank: 0, pin;
    body coupler: pin, knee;
    body rocker: vec2(r1, 0), knee;
}

/// The first pose makes the plan, and the others take it over.
#[test]
fn prepared_reactions_do_not_allocate() {
    let linkage = AnyLinkage::of(&Press {
        r1: 0.9,
        r2: 0.3,
        r3: 0.8,
        r4: 0.6,
    });
    let loads = linkage.loads().gravity(Plane::new(0.0, -9.81));
    let loads = loads.torque(-30.0, "theta4");
    let loads = loads.and_then(|loads| loads.mass_of("coupler", 1.5, Plane::new(0.4, 0.1), 0.02));
    let loads = loads.expect("all names are there");
    let reactions = linkage.reactions(&loads).expect("its bodies are declared");
    let mut prepared = reactions.prepared();
    let mut pose = |step: u8| {
        let crank = Motion::at_constant_speed(0.2 * f64::from(step), 12.0);
        let found = prepared.at(&[crank], PositionChoice::Assembly(0));
        black_box(found.expect("it is determined").effort(0));
    };
    pose(0);
    without_allocation::<Press, _>("a prepared pose", || (1..32).for_each(pose));
}

/// The numbers of poses that were solved and refused.
#[derive(Default)]
struct Outcomes {
    poses: usize,
    refusals: usize,
}

/// Solves one mechanism all over its ranges, and beyond, where it may not close.
fn solve<M: ThroughSnap>(case: Case, outcomes: &mut Outcomes, random: &mut Random) -> Option<(M, M::Pose)> {
    let mechanism = case.mechanism::<M>();
    let mut found = None;
    for step in 0..24 {
        let inputs = case.inputs::<M>(0.041 * f64::from(step) + 0.01, random);
        let values = M::Inputs::from_fn(|index| inputs[index].value());
        let some = M::Unknowns::from_fn(|_| random.between(0.2, 2.0));
        let near = without_allocation::<M, _>("assembly_at", || mechanism.assembly_at(values, some));
        let assembly = M::assembly(0).unwrap_or(near);
        let solved = without_allocation::<M, _>("solve", || mechanism.solve(inputs, assembly));
        let position = without_allocation::<M, _>("position", || mechanism.position(values, assembly));
        without_allocation::<M, _>("solve_near", || mechanism.solve_near(inputs, some)).ok();
        without_allocation::<M, _>("position_near", || mechanism.position_near(values, some)).ok();
        without_allocation::<M, _>("closure", || mechanism.closure(values, some));
        let Ok(pose) = solved else {
            outcomes.refusals += 1;
            continue;
        };
        assert!(position.is_ok(), "{} has a motion and no position", M::DESCRIPTION.name);
        outcomes.poses += 1;
        found = Some((mechanism, pose));
    }
    println!(
        "{:30} {:4} bytes: inputs and unknowns {:4}",
        M::DESCRIPTION.name,
        size_of::<M::Pose>(),
        (M::Inputs::<()>::LENGTH + M::Unknowns::<()>::LENGTH) * size_of::<Motion<f64, 5>>(),
    );
    found
}

struct All {
    outcomes: Outcomes,
    random: Random,
}

impl Visitor for All {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        solve::<M>(case, &mut self.outcomes, &mut self.random);
    }
}

impl sensitive::Visitor for All {
    fn visit<M: SensitiveThroughSnap>(&mut self, case: Case) {
        let (mechanism, pose) =
            solve::<M>(case, &mut self.outcomes, &mut self.random).expect("it closes somewhere in its range");
        without_allocation::<M, _>("sensitivities_of", || mechanism.sensitivities_of(&pose));
    }
}

impl All {
    fn new() -> Self {
        Self {
            outcomes: Outcomes::default(),
            random: Random::new(5),
        }
    }

    fn report(&self) {
        let Outcomes { poses, refusals } = self.outcomes;
        println!("{poses} poses, {refusals} refusals");
        assert!(poses > 200 && refusals > 0);
    }
}

#[test]
fn no_solver_allocates() {
    let mut all = All::new();
    cases::of_each_form(&mut all);
    cases::coupled_library(&mut all);
    all.report();
}

/// Tracks the mechanisms of the library a little way from each of several positions.
struct Tracks {
    random: Random,
    arrived: usize,
}

impl Visitor for Tracks {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let mechanism = case.mechanism::<M>();
        for step in 0..24 {
            let inputs = case.inputs::<M>(0.041 * f64::from(step) + 0.01, &mut self.random);
            let values = M::Inputs::from_fn(|index| inputs[index].value());
            let some = M::Unknowns::from_fn(|_| self.random.between(0.2, 2.0));
            let assembly = M::assembly(0).unwrap_or_else(|| mechanism.assembly_at(values, some));
            if let Ok(position) = mechanism.position(values, assembly) {
                let to = M::Inputs::from_fn(|index| values[index] + 0.02);
                let end = without_allocation::<M, _>("track", || track(&mechanism, values, position, to));
                self.arrived += usize::from(end.is_ok());
            }
        }
    }
}

/// The code of `track` is the same for every mechanism, so that those of the library stand for all.
#[test]
fn tracking_does_not_allocate() {
    let mut tracks = Tracks {
        random: Random::new(6),
        arrived: 0,
    };
    cases::library_of_each_form(&mut tracks);
    #[cfg(feature = "every-case")]
    cases::library_besides(&mut tracks);
    cases::coupled_library(&mut tracks);
    println!("{} ways from one position to another", tracks.arrived);
    assert!(tracks.arrived > 200);
}

/// Neither where poses are found together, nor where they are refused, nor where there is an iteration.
#[test]
fn batches_do_not_allocate() {
    let angles: [f64; 100] = core::array::from_fn(|index| 0.05 * index as f64 - 2.5);
    let theta2 = Motion::from([Column::Each(&angles), 2.0.into(), 0.0.into(), 0.0.into(), 0.0.into()]);
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let mut poses = FourBarBatch::filled(|| [0.0; 100]);
    let mut outcomes = [Outcome::Unsolved; 100];
    let summary = without_allocation::<FourBar, _>("batch", || {
        linkage.batch(theta2, Assembly::Open).solve(&mut poses, &mut outcomes)
    });
    let summary = summary.expect("the columns are of one length");
    assert!(summary.solved > 50 && summary.failed > 10, "{summary:?}");
    let mut folds = [
        Fold::of(Slot::Unknown(1, 4)),
        Fold::of(FoldedNumber::SmallestTransmissionAngle),
    ];
    let parameters = linkage.parameters().map(Column::Same);
    let turn = InputGrid::revolution(0, 1000);
    let summary = without_allocation::<FourBar, _>("fold", || {
        let vectors = Vectors::widest();
        Batch::<FourBar, _>::new(parameters, [theta2], Assembly::Open)
            .vectors(vectors)
            .fold(turn, &mut folds)
    });
    let summary = summary.expect("the inputs that do not turn are the same");
    assert!(summary.solved > 500 && summary.failed > 100, "{summary:?}");

    let triad = ClassThreeTriad {
        base_b: Plane::new(3.4, 0.2),
        base_c: Plane::new(1.7, 3.1),
        platform_b: Plane::new(1.6, 0.1),
        platform_c: Plane::new(0.8, 1.4),
    };
    let leg = Motion::at_constant_speed(2.1, 1.0);
    let near = [0.5, 2.0, 4.5, 0.5];
    let near = triad
        .solve_near(leg, leg, leg, near)
        .map_or(near, |pose| pose.unknowns());
    let lengths: [f64; 100] = core::array::from_fn(|index| 2.1 + 1e-3 * index as f64);
    let leg = Motion::from([Column::Each(&lengths), 1.0.into(), 0.0.into(), 0.0.into(), 0.0.into()]);
    let mut poses = ClassThreeTriadBatch::filled(|| [0.0; 100]);
    let summary = without_allocation::<ClassThreeTriad, _>("batch", || {
        triad
            .batch(leg, leg, leg, near.map(Column::Same))
            .solve(&mut poses, &mut outcomes)
    });
    let summary = summary.expect("the columns are of one length");
    assert!(summary.solved > 50, "{summary:?}");
}

#[test]
fn sensitivities_do_not_allocate() {
    let mut all = All::new();
    sensitive::all(&mut all);
    all.report();
}

/// All positions of a coupled block are found by following many paths, in a list that lies in the result.
#[test]
fn the_search_for_all_assemblies_does_not_allocate() {
    let watt = WattIByDyad::<f64>::from_parameters([4.0, 1.0, 3.0, 2.5, 1.5, 0.8, 2.0, 1.5, 2.5, 2.0]);
    let found = without_allocation::<WattIByDyad, _>("assemblies_at", || watt.assemblies_at(1.1));
    assert!(!found.expect("it closes").is_empty());
    let stephenson = StephensonII::<f64>::from_parameters([4.0, 2.0, 1.5, 1.2, 3.0, 0.3, 1.0, 0.5, 1.6, 3.0]);
    let found = without_allocation::<StephensonII, _>("assemblies_at", || stephenson.assemblies_at(0.4));
    assert!(!found.expect("it closes").is_empty());
    let triad = ClassThreeTriad::<f64>::from_parameters([3.4, 0.2, 1.7, 3.1, 1.6, 0.1, 0.8, 1.4]);
    let found = without_allocation::<ClassThreeTriad, _>("assemblies_at", || triad.assemblies_at(2.1, 2.1, 2.1));
    assert!(!found.expect("it closes").is_empty());
}

/// Each step's pose is as large as its motions and what the next steps reuse.
#[test]
fn sizes_of_the_poses_of_each_order() {
    fn print<T>(carried: usize) {
        println!(
            "{:50} {:4} bytes, of which {carried} carried",
            type_name::<T>(),
            size_of::<T>()
        );
    }
    let motions = |orders: usize| 3 * orders * size_of::<f64>();
    print::<library::FourBarPosition>(size_of::<library::FourBarPosition>() - motions(1));
    print::<library::FourBarVelocity>(size_of::<library::FourBarVelocity>() - motions(2));
    print::<library::FourBarAcceleration>(size_of::<library::FourBarAcceleration>() - motions(3));
    print::<library::FourBarJerk>(size_of::<library::FourBarJerk>() - motions(4));
    print::<library::FourBarSnap>(size_of::<library::FourBarSnap>() - motions(5));
    // at the last order nothing is left to be reused
    assert_eq!(size_of::<library::FourBarSnap>(), motions(5));
    assert_eq!(size_of::<library::FourBarSnap<f32>>(), motions(5) / 2);
}
