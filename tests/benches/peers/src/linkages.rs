//! The linkages of the race: random poses, more of them than caches hold, and a sweep at constant speed.

use core::f64::consts::TAU;

use kin_core::library::{
    ClassThreeTriad, FourBar, GearedFiveBar, InvertedSliderCrank, JansenLeg, Rssr, SliderCrank, WattII,
};
use kin_core::prelude::*;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::random::Random;

use crate::solved::Wanted;

/// Poses that stay in the caches. No power of two: columns of such a length lie on top of each other in a cache.
const POSES: usize = 500;

/// Poses that do not.
const MANY: usize = 400_000;

const SWEEP: usize = 3600;

/// Something that is done with the courses of the race.
pub(crate) trait Visitor {
    /// Does it with the poses that a linkage is to find.
    fn visit<M: ThroughSnap>(&mut self, course: Course<M>);
}

/// Poses of a linkage.
pub(crate) struct Course<M: ThroughSnap> {
    /// The name of its closed form.
    pub(crate) linkage: &'static str,
    pub(crate) kind: &'static str,
    pub(crate) mechanism: M,
    pub(crate) wanted: Vec<Wanted<M>>,
}

impl<M: ThroughSnap> Course<M> {
    pub(crate) fn name(&self) -> String {
        format!("{}.{}", self.linkage, self.kind)
    }

    /// Whether the poses do not fit into the caches.
    pub(crate) fn is_long(&self) -> bool {
        self.wanted.len() == MANY
    }
}

/// Leads a visitor along all courses.
pub(crate) fn visit_all(visitor: &mut impl Visitor) {
    // The first one has limits at 1.96 rad; the second one makes full revolutions.
    let rocker = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let turning = FourBar {
        r3: 70.0,
        r4: 60.0,
        ..rocker
    };
    scattered(visitor, "four_bar", rocker, 1.8, 0);
    revolving(visitor, "four_bar", turning, 0);
    both(visitor, "slider_crank", SliderCrank { r: 0.4, l: 1.1 }, 0);
    both(
        visitor,
        "inverted_slider_crank",
        InvertedSliderCrank { r1: 2.0, r2: 0.8 },
        0,
    );
    let geared = GearedFiveBar {
        r1: 2.0,
        r2: 0.5,
        r3: 2.5,
        r4: 2.5,
        r5: 0.5,
        ratio: -2.0,
        phase: 0.7,
    };
    both(visitor, "geared_five_bar", geared, 0);
    let watt = WattII {
        r1: 4.0,
        r2: 1.0,
        r3: 3.0,
        r4: 2.5,
        arm: Plane::new(2.0, 1.0),
        pivot: Plane::new(7.0, 0.5),
        r5: 3.0,
        r6: 2.5,
    };
    both(visitor, "watt_two", watt, 0);
    let rssr = Rssr {
        crank: 1.0,
        pivot: Space::new(3.0, 0.5, 0.8),
        axis: Space::new(0.2, 0.9, 0.3),
        arm: Space::new(0.4, -0.3, 1.9),
        rod: 3.3,
    };
    both(visitor, "rssr", rssr, 0);
    let walking = (0..JansenLeg::<f64>::ASSEMBLY_COUNT)
        .find(|index| JansenLeg::<f64>::assembly(*index) == Some(JansenLeg::WALKING));
    both(
        visitor,
        "jansen_leg",
        JansenLeg::HOLY_NUMBERS,
        walking.expect("it is one of the assemblies"),
    );
    triad(visitor);
}

fn both<M: ThroughSnap>(visitor: &mut impl Visitor, linkage: &'static str, mechanism: M, assembly: usize) {
    scattered(visitor, linkage, mechanism, 3.1, assembly);
    revolving(visitor, linkage, mechanism, assembly);
}

/// Random poses of a linkage with a crank, a few and many.
fn scattered<M: ThroughSnap>(
    visitor: &mut impl Visitor,
    linkage: &'static str,
    mechanism: M,
    reach: f64,
    assembly: usize,
) {
    for (kind, count) in [("poses", POSES), ("many", MANY)] {
        let mut random = Random::new(8);
        let wanted = (0..count).map(|_| {
            let angle = random.between(-reach, reach);
            let crank = random.motion(angle);
            Wanted::in_assembly(M::Inputs::from_fn(|_| Motion::new(crank)), assembly)
        });
        visitor.visit(Course {
            linkage,
            kind,
            mechanism,
            wanted: wanted.collect(),
        });
    }
}

/// A revolution of the crank.
fn revolving<M: ThroughSnap>(visitor: &mut impl Visitor, linkage: &'static str, mechanism: M, assembly: usize) {
    let wanted = (0..SWEEP).map(|row| {
        #[allow(clippy::cast_precision_loss, reason = "there are thousands")]
        let fraction = row as f64 / SWEEP as f64;
        let crank = Motion::at_constant_speed(TAU * fraction, 10.0);
        Wanted::in_assembly(M::Inputs::from_fn(|_| crank), assembly)
    });
    visitor.visit(Course {
        linkage,
        kind: "sweep",
        mechanism,
        wanted: wanted.collect(),
    });
}

/// A platform on three legs, whose position is found from one guess for all lengths.
fn triad(visitor: &mut impl Visitor) {
    let root = 3.0_f64.sqrt();
    let mechanism = ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    let near = [0.1, 2.2, -2.0, 1.6];
    for (kind, count) in [("poses", POSES), ("many", MANY)] {
        let mut random = Random::new(8);
        let wanted = (0..count).map(|_| {
            let legs = core::array::from_fn(|_| {
                let length = 5.0_f64.sqrt() + random.between(-0.02, 0.02);
                Motion::new(random.motion(length))
            });
            Wanted::near(legs, near)
        });
        visitor.visit(Course {
            linkage: "class_three_triad",
            kind,
            mechanism,
            wanted: wanted.collect(),
        });
    }
}
