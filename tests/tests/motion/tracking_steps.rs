//! How many steps a track takes: few, and never more than it promises, however extreme the proportions.

use core::f64::consts::{PI, TAU};

use kin_core::library::{FourBar, OffsetSliderCrank};
use kin_core::prelude::*;
use kin_core::{MOST_TRACK_STEPS, TrackError, TrackErrorOf, track};
use kin_tests::counting::{Calls, Counting, calls_of};
use kin_tests::mechanisms::coupled::Triad;
use kin_tests::mechanisms::dyads::FourBarOnGround;
use kin_tests::mechanisms::slider_crank_typings::SliderCrankDrivenAtSlider;
use kin_tests::random::Random;
use kin_tests::samples;

mechanism! {
    /// A dyad on the second angle of that loop.
    struct TwoLoops { a: Length, b: Length, c: Length, ground: Point, d: Length, e: Length, pivot: Point }
    input q: Angle;
    unknown u: Angle, v: Angle, x: Angle, y: Angle;
    a * cis(q) + b * cis(u) == ground + c * cis(v);
    c * cis(v) + d * cis(x) == pivot + e * cis(y);
}

mechanism! {
    /// A slide in a lever.
    struct Lever { ground: Point, crank: Length }
    input q: Angle;
    unknown s: Length, u: Angle;
    ground + crank * cis(q) == s * cis(u);
}

mechanism! {
    /// Gears: however fast, this is straight.
    struct Gears { ratio: Scalar }
    order = 1;
    input q: Angle;
    unknown x: Angle;
    x == ratio * q;
}

fn at(length: f64, angle: f64) -> Plane {
    Plane::new(length * angle.cos(), length * angle.sin())
}

fn minus(one: Plane, other: Plane) -> Plane {
    Plane::new(one.x - other.x, one.y - other.y)
}

fn plus(one: Plane, other: Plane) -> Plane {
    Plane::new(one.x + other.x, one.y + other.y)
}

/// A length from 10⁻⁸ to 10⁸, all sizes being as likely.
fn length(random: &mut Random) -> f64 {
    10.0_f64.powf(random.between(-8.0, 8.0))
}

fn angle(random: &mut Random) -> f64 {
    random.between(-PI, PI)
}

/// The work of many tracks.
#[derive(Debug, Default)]
struct Tally {
    tracks: u64,
    all: Calls,
    most: Calls,
    arrived: u64,
    limits: u64,
    others: u64,
}

impl Tally {
    fn go<M: Mechanism<Scalar = f64>>(
        &mut self,
        mechanism: &M,
        from: M::Inputs<f64>,
        start: M::Unknowns<f64>,
        to: M::Inputs<f64>,
    ) -> Result<M::Unknowns<f64>, TrackErrorOf<M>> {
        let counting = Counting(*mechanism);
        let (result, calls) = calls_of(|| track(&counting, from, start, to));
        self.tracks += 1;
        self.all.solutions += calls.solutions;
        self.all.closures += calls.closures;
        self.most.solutions = self.most.solutions.max(calls.solutions);
        self.most.closures = self.most.closures.max(calls.closures);
        match &result {
            Ok(_) => self.arrived += 1,
            Err(TrackError::TurningPoint(_)) => self.limits += 1,
            Err(TrackError::TooManySteps(halt)) => panic!("{mechanism:?} {from:?}: {halt:?}", from = from.as_ref()),
            Err(_) => self.others += 1,
        }
        result
    }

    /// From every assembly that has a name, and from known values of the unknowns, forward and backward.
    fn around<M: Mechanism<Scalar = f64>>(
        &mut self,
        mechanism: &M,
        from: f64,
        known: Option<M::Unknowns<f64>>,
        way: f64,
        mut judge: impl FnMut(f64, Result<M::Unknowns<f64>, TrackErrorOf<M>>),
    ) {
        let inputs = |value: f64| M::Inputs::from_fn(|_| value);
        let named = M::assemblies().filter_map(|assembly| mechanism.position(inputs(from), assembly).ok());
        for start in named.chain(known) {
            for to in [from + way, from - way] {
                judge(to, self.go(mechanism, inputs(from), start, inputs(to)));
            }
        }
    }

    /// A step is at most one solution, and few of them are needed.
    fn is_within(&self, most: Calls, mean: u64) {
        println!("{self:?}");
        assert!(most.solutions < u64::from(MOST_TRACK_STEPS) / 100);
        assert!(self.most.solutions <= most.solutions, "{self:?}");
        assert!(self.most.closures <= most.closures, "{self:?}");
        assert!(self.all.solutions <= mean * self.tracks, "{self:?}");
    }
}

/// How long the diagonal of a loop is that coupler and rocker must span.
fn diagonal(linkage: &FourBarOnGround, q: f64) -> f64 {
    let diagonal = minus(linkage.ground, at(linkage.a, q));
    diagonal.x.hypot(diagonal.y)
}

/// The lengths that the diagonal may have, and by how much rounding of the loop blurs them.
fn span(linkage: &FourBarOnGround) -> ([f64; 2], f64) {
    let FourBarOnGround { a, b, c, ground } = *linkage;
    let ends = [(b - c).abs(), b + c];
    (ends, 16.0 * f64::EPSILON * (a + b + c + ground.x.hypot(ground.y)))
}

/// A limit must be where the diagonal is as long as it may be, or as short, and not before.
fn is_the_first_limit(linkage: &FourBarOnGround, from: f64, limit: f64) {
    let (ends, blur) = span(linkage);
    let there = diagonal(linkage, limit);
    assert!(
        ends.iter().any(|end| (there - end).abs() <= blur),
        "{linkage:?} {from} {limit}: {there} {ends:?}"
    );
    for part in 1..64 {
        let between = diagonal(linkage, from + (limit - from) * f64::from(part) / 64.0);
        assert!(
            ends[0] - blur <= between && between <= ends[1] + blur,
            "{linkage:?} {from} {limit}: {between}"
        );
    }
}

/// A crank of 6·10⁶ in a loop with a coupler of 10⁻⁷: over the whole motion of the coupler its angle changes by 10⁻¹³.
#[test]
fn a_way_shorter_than_rounding_lets_see_ends_at_its_limits() {
    let (q, u, v) = (2.7, -2.5, 2.4);
    for b in [1e-5, 1e-6, 1e-7, 3e-8, 1e-8] {
        let (a, c) = (6e6, 2e-3);
        let ground = minus(plus(at(a, q), at(b, u)), at(c, v));
        let linkage = FourBarOnGround { a, b, c, ground };
        let mut tally = Tally::default();
        tally.around(&linkage, q, Some([u, v]), TAU, |to, result| {
            let Err(TrackError::TurningPoint(limit)) = result else {
                panic!("{linkage:?} to {to}: {result:?}");
            };
            assert_eq!(limit.block, "u, v");
            is_the_first_limit(&linkage, q, limit.inputs[0]);
            assert!((limit.inputs[0] - q).abs() <= 2.0 * b / a * 4.0, "{limit:?}");
        });
        assert_eq!(tally.tracks, 6);
        assert!(tally.most.solutions <= 64 && tally.most.closures <= 2_000, "{tally:?}");
    }
}

#[test]
fn four_bars_of_extreme_proportions() {
    let (mut random, mut tally) = (Random::new(31), Tally::default());
    let mut unclear = 0;
    for _ in 0..samples::of(300) {
        let [a, b, c] = [(); 3].map(|()| length(&mut random));
        let [q, u, v] = [(); 3].map(|()| angle(&mut random));
        let ground = minus(plus(at(a, q), at(b, u)), at(c, v));
        let linkage = FourBarOnGround { a, b, c, ground };
        let (ends, blur) = span(&linkage);
        tally.around(&linkage, q, Some([u, v]), TAU, |_, result| match result {
            Ok(_) => {
                let ground = ground.x.hypot(ground.y);
                assert!(
                    ends[0] - blur <= (ground - a).abs() && ground + a <= ends[1] + blur,
                    "{linkage:?}"
                );
            }
            Err(TrackError::TurningPoint(limit)) => is_the_first_limit(&linkage, q, limit.inputs[0]),
            Err(_) => {
                // Where rounding of the longest link is as long as the shortest one.
                assert!(blur > 1e-4 * a.min(b).min(c), "{linkage:?} {q}: {result:?}");
                unclear += 1;
            }
        });
    }
    assert!(unclear * 20 < tally.tracks, "{unclear} {tally:?}");
    assert!(tally.arrived > 0 && tally.limits > 0, "{tally:?}");
    let most = Calls {
        solutions: 300,
        closures: 10_000,
    };
    tally.is_within(most, 15);
}

#[test]
fn other_mechanisms_of_extreme_proportions() {
    let mut random = Random::new(32);
    let mut tallies = [(); 5].map(|()| Tally::default());
    let [six_bars, sliders, pumps, levers, triads] = &mut tallies;
    for _ in 0..samples::of(120) {
        let [a, b, c, d, e, f] = [(); 6].map(|()| length(&mut random));
        let [q, u, v, x, y, turn] = [(); 6].map(|()| angle(&mut random));
        let joint = plus(at(a, q), at(b, u));
        let ground = minus(joint, at(c, v));

        let pivot = minus(plus(at(c, v), at(d, x)), at(e, y));
        let six_bar = TwoLoops {
            a,
            b,
            c,
            ground,
            d,
            e,
            pivot,
        };
        six_bars.around(&six_bar, q, Some([u, v, x, y]), TAU, |_, _| {});

        let slider = OffsetSliderCrank { r: a, l: b, h: joint.y };
        sliders.around(&slider, q, None, TAU, |_, _| {});

        let pump = SliderCrankDrivenAtSlider::from_parameters([a, b, joint.y]);
        pumps.around(&pump, joint.x, Some([q, u]), f, |_, _| {});

        let lever = Lever {
            ground: at(b, u),
            crank: a,
        };
        levers.around(&lever, q, None, TAU, |_, _| {});

        let triad = Triad::around([q, u, v, x, y], [a, b, c, d, e, f], turn);
        triads.around(&triad, q, Some([u, v, x, y]), TAU, |_, _| {});
    }
    for tally in &tallies {
        assert!(3 * tally.tracks >= 5 * samples::of(120) as u64, "{tally:?}");
        assert!(tally.arrived > 0 || !cfg!(feature = "every-case"), "{tally:?}");
        let most = Calls {
            solutions: 500,
            closures: 50_000,
        };
        tally.is_within(most, 25);
    }
}

/// Cranks of ordinary proportions, turn for turn.
#[test]
fn a_turn_takes_few_steps() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 70.0,
        r4: 60.0,
    };
    let slider = OffsetSliderCrank { r: 1.0, l: 2.5, h: 0.4 };
    for assembly in Assembly::BOTH {
        for turns in [1_u32, 10, 100] {
            let mut tally = Tally::default();
            let way = TAU * f64::from(turns);
            let position = linkage.position(0.5, assembly).unwrap();
            tally.go(&linkage, [0.5], position.unknowns(), [0.5 + way]).unwrap();
            let position = slider.position(0.5, assembly).unwrap();
            tally.go(&slider, [0.5], position.unknowns(), [0.5 - way]).unwrap();
            assert!(
                tally.most.solutions <= 20 * u64::from(turns),
                "{turns} turns: {tally:?}"
            );
        }
    }
}

#[test]
fn too_long_a_way_ends_with_the_place_from_which_it_goes_on() {
    let gears: Gears = Gears { ratio: 3.0 };
    let way = 1e5;
    let Err(TrackError::TooManySteps(halt)) = track(&gears, [0.0], [0.0], [way]) else {
        panic!("as many steps as that are not allowed");
    };
    assert_eq!(halt.steps, MOST_TRACK_STEPS);
    assert!((halt.fraction - halt.inputs[0] / way).abs() <= f64::EPSILON);
    // Half a radian is the longest step.
    assert!(
        (halt.inputs[0] - 0.5 * f64::from(MOST_TRACK_STEPS)).abs() <= 1.0,
        "{halt:?}"
    );
    assert!((halt.unknowns[0] - 3.0 * halt.inputs[0]).abs() <= 1e-9 * way);
    assert!(halt.rounding <= 64.0 * f64::EPSILON * halt.unknowns[0]);
    let [end] = track(&gears, halt.inputs, halt.unknowns, [halt.inputs[0] + 10.0]).unwrap();
    assert!((end - halt.unknowns[0] - 30.0).abs() <= 1e-9 * way);
}
