//! One pose at a time: the generated solvers against the notes' formulas, automatic differentiation, and a kernel
//! written by hand.
//!
//! `cargo bench -p kin-tests --bench scalar` prints lines `ratio NAME VALUE`, from times taken in one run. None is
//! asserted: what is asserted, before anything is timed, is that the contenders find the same.
#![allow(missing_docs, reason = "a program")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "single precision is made from double precision, and there are hundreds of poses"
)]

mod careful;
mod floor;
mod measure;

use core::hint::black_box;

use kin_core::library::{FourBar, InvertedSliderCrank, SliderCrank};
use kin_core::prelude::*;
use kin_core::series::Series;
use kin_tests::notes::{self, four_bar_geometric, inverted_slider_crank, sample, slider_crank};
use kin_tests::random::Random;
use measure::Race;
use num_dual::{Dual, Dual3, HyperDual};

/// Poses in each turn.
const POSES: usize = 256;

/// Motions about angles all over a range, one after the other as in a sweep or a control loop, so that branches within
/// arctangents are as foreseeable as they are there; the rates are random.
fn motions(low: f64, high: f64) -> Vec<[f64; 5]> {
    let mut random = Random::new(1);
    let step = (high - low) / POSES as f64;
    (0..POSES)
        .map(|index| random.motion(low + step * (index as f64 + 0.5)))
        .collect()
}

/// Asserts that two ways agree: to a part in 10⁸ of the largest value of each order, as these poses are well
/// conditioned and the snap loses no more than that.
fn assert_same(name: &str, own: &[[f64; 5]], other: &[[f64; 5]]) {
    for order in 0..5 {
        let size = other.iter().map(|motion| motion[order].abs()).fold(1.0, f64::max);
        for (own, other) in own.iter().zip(other) {
            let difference = (own[order] - other[order]).abs();
            assert!(
                difference <= 1e-8 * size,
                "{name}, order {order}: {own:?} against {other:?}"
            );
        }
    }
}

mechanism! {
    /// The library's four-bar linkage once more, for a program that solves it in one place only: there the position
    /// solver is compiled into its caller, where with many callers it is one function for all.
    pub struct SolvedInOnePlace { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// The same with unit vectors in the place of the angles.
    pub struct ToUnitVectors { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
    input theta2: Angle;
    unknown theta3: Direction, theta4: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

/// A motion with the angle of a unit vector.
fn derivatives(unit: [f64; 2], rates: [f64; 4]) -> [f64; 5] {
    let [a, b, c, d] = rates;
    [Number::atan2(unit[1], unit[0]), a, b, c, d]
}

type Nested = HyperDual<HyperDual<f64>>;
type Mixed = Dual<Dual3<f64>>;

fn nested(d: [f64; 5]) -> Nested {
    let inner = |k: usize| HyperDual::new(d[k], d[k + 1], d[k + 1], d[k + 2]);
    HyperDual::new(inner(0), inner(1), inner(1), inner(2))
}

fn mixed(d: [f64; 5]) -> Mixed {
    Dual::new(Dual3::new(d[0], d[1], d[2], d[3]), Dual3::new(d[1], d[2], d[3], d[4]))
}

fn four_bar() {
    let r = sample::DIMENSIONS;
    let linkage = FourBar {
        r1: r.r1,
        r2: r.r2,
        r3: r.r3,
        r4: r.r4,
    };
    let by_hand = floor::FourBar {
        r1: r.r1,
        r2: r.r2,
        r3: r.r3,
        r4: r.r4,
    };
    // where the linkage closes with room to spare, all round the ground line
    let motions = motions(-1.8, 1.8);
    let with_branches: Vec<_> = motions
        .iter()
        .map(|motion| {
            let branch = four_bar_geometric::Branch::closing(r, motion[0], notes::Assembly::Open);
            (*motion, branch)
        })
        .collect();
    let values = || motions.iter().map(|motion| motion[0]).collect::<Vec<_>>();
    let typed = || motions.iter().map(|motion| Motion::new(*motion)).collect::<Vec<_>>();

    let generated: Vec<[[f64; 5]; 2]> = motions
        .iter()
        .map(|motion| {
            let pose = linkage.solve(Motion::new(*motion), Assembly::Open).expect("it closes");
            [pose.theta3.derivatives(), pose.theta4.derivatives()]
        })
        .collect();
    let to_unit_vectors = ToUnitVectors::from_parameters(linkage.parameters());
    let unit_vectors: Vec<[[f64; 5]; 2]> = motions
        .iter()
        .map(|motion| {
            let pose = to_unit_vectors
                .solve(Motion::new(*motion), Assembly::Open)
                .expect("it closes");
            [pose.theta3, pose.theta4]
                .map(|direction| derivatives([direction.cosine(), direction.sine()], direction.rates()))
        })
        .collect();
    let vectors: Vec<[[f64; 5]; 2]> = motions
        .iter()
        .map(|motion| {
            let (units, rates) = by_hand.solve_to_vectors::<false>(*motion).expect("it closes");
            [derivatives(units[0], rates[0]), derivatives(units[1], rates[1])]
        })
        .collect();
    let hand: Vec<[[f64; 5]; 2]> = motions
        .iter()
        .map(|motion| by_hand.solve::<false>(*motion).expect("it closes"))
        .collect();
    let notes: Vec<[[f64; 5]; 2]> = with_branches
        .iter()
        .map(|(motion, branch)| {
            let pose = four_bar_geometric::derivatives(r, *motion, four_bar_geometric::position(r, motion[0], *branch));
            [pose.theta3, pose.theta4]
        })
        .collect();
    let with_care: Vec<[[f64; 5]; 2]> = with_branches
        .iter()
        .map(|(motion, branch)| careful::solve(r, *motion, *branch))
        .collect();
    let beside: Vec<[[f64; 5]; 2]> = motions
        .iter()
        .map(|motion| by_hand.solve::<true>(*motion).expect("it closes"))
        .collect();
    for unknown in 0..2 {
        let of = |poses: &[[[f64; 5]; 2]]| poses.iter().map(|pose| pose[unknown]).collect::<Vec<_>>();
        assert_same("by hand", &of(&hand), &of(&generated));
        assert_same("by hand, beside", &of(&beside), &of(&generated));
        assert_same("unit vectors", &of(&unit_vectors), &of(&generated));
        assert_same("vectors by hand", &of(&vectors), &of(&generated));
        // the notes give theta4 from 0 to a whole turn; and theta3 with it
        for (name, poses) in [("notes", &notes), ("notes with care", &with_care)] {
            let mut poses = of(poses);
            for (own, generated) in poses.iter_mut().zip(of(&generated)) {
                let turn = core::f64::consts::TAU;
                own[0] -= turn * ((own[0] - generated[0]) / turn).round();
            }
            assert_same(name, &poses, &of(&generated));
        }
    }

    let mut race = Race::new(POSES);
    race.enter("four_bar.notes_with_care", with_branches.clone(), |(motion, branch)| {
        careful::solve(black_box(r), motion, branch)
    });
    race.enter("four_bar.notes", with_branches, |(motion, branch)| {
        let r = black_box(r);
        four_bar_geometric::derivatives(r, motion, four_bar_geometric::position(r, motion[0], branch))
    });
    race.enter("four_bar.generated", typed(), |motion| {
        black_box(linkage).solve(motion, Assembly::Open)
    });
    let alone = SolvedInOnePlace::from_parameters(linkage.parameters());
    race.enter("four_bar.generated_in_one_place", typed(), move |motion| {
        black_box(alone).solve(motion, Assembly::Open)
    });
    race.enter("four_bar.by_hand", motions.clone(), |motion| {
        black_box(by_hand).solve::<false>(motion)
    });
    race.enter("four_bar.by_hand_beside", motions.clone(), |motion| {
        black_box(by_hand).solve::<true>(motion)
    });
    race.enter("four_bar.by_hand_without_arctangents", motions.clone(), |motion| {
        black_box(by_hand).solve_to_vectors::<false>(motion)
    });
    race.enter("four_bar.generated_without_arctangents", typed(), move |motion| {
        black_box(to_unit_vectors).solve(motion, Assembly::Open)
    });
    let single = linkage.convert(|length| length as f32);
    let inputs = motions
        .iter()
        .map(|motion| Motion::new(motion.map(|entry| entry as f32)))
        .collect();
    race.enter("four_bar.single_precision", inputs, move |motion| {
        black_box(single).solve(motion, Assembly::Open)
    });
    let lifted = linkage.convert(<Nested as Number>::constant);
    race.enter("four_bar.nested_dual_numbers", motions.clone(), move |motion| {
        black_box(lifted).position(nested(motion), Assembly::Open)
    });
    let lifted = linkage.convert(<Mixed as Number>::constant);
    race.enter("four_bar.mixed_dual_numbers", motions.clone(), move |motion| {
        black_box(lifted).position(mixed(motion), Assembly::Open)
    });
    let lifted = linkage.convert(Series::<5>::constant);
    race.enter("four_bar.series", motions.clone(), move |motion| {
        black_box(lifted).position(Series::from_derivatives(motion), Assembly::Open)
    });
    race.enter("four_bar.sine_cosine_and_two_arctangents", values(), |angle| {
        let (sine, cosine) = Number::sin_cos(black_box(angle));
        [Number::atan2(sine, cosine + 0.5), Number::atan2(sine, cosine - 0.5)]
    });
    race.enter(
        "four_bar.single_precision_sine_cosine_and_two_arctangents",
        values(),
        |angle| {
            let (sine, cosine) = Number::sin_cos(black_box(angle) as f32);
            [Number::atan2(sine, cosine + 0.5), Number::atan2(sine, cosine - 0.5)]
        },
    );
    race.enter(
        "four_bar.the_library_s_sine_cosine_and_two_arctangents",
        values(),
        |angle| {
            let (sine, cosine) = black_box(angle).sin_cos();
            [sine.atan2(cosine + 0.5), sine.atan2(cosine - 0.5)]
        },
    );

    race.enter("four_bar.position", typed(), |motion| {
        black_box(linkage).position(motion.value(), Assembly::Open)
    });
    race.enter("four_bar.through_velocity", typed(), |motion| {
        let position = black_box(linkage).position(motion.value(), Assembly::Open)?;
        Ok::<_, SolveError>(position.velocity(motion.velocity()))
    });
    race.enter("four_bar.through_acceleration", typed(), |motion| {
        let position = black_box(linkage).position(motion.value(), Assembly::Open)?;
        let velocity = position.velocity(motion.velocity());
        Ok::<_, SolveError>(velocity.acceleration(motion.acceleration()))
    });
    race.enter("four_bar.through_jerk", typed(), |motion| {
        let position = black_box(linkage).position(motion.value(), Assembly::Open)?;
        let velocity = position.velocity(motion.velocity());
        let acceleration = velocity.acceleration(motion.acceleration());
        Ok::<_, SolveError>(acceleration.jerk(motion.jerk()))
    });
    race.enter("four_bar.through_snap", typed(), |motion| {
        let position = black_box(linkage).position(motion.value(), Assembly::Open)?;
        let velocity = position.velocity(motion.velocity());
        let acceleration = velocity.acceleration(motion.acceleration());
        Ok::<_, SolveError>(acceleration.jerk(motion.jerk()).snap(motion.snap()))
    });

    let times = race.run();
    for other in [
        "notes",
        "notes_with_care",
        "by_hand",
        "by_hand_beside",
        "nested_dual_numbers",
        "mixed_dual_numbers",
        "series",
    ] {
        times.ratio("four_bar.generated", &format!("four_bar.{other}"));
    }
    for (name, other) in [
        ("generated_in_one_place", "notes"),
        ("generated_in_one_place", "by_hand"),
        ("by_hand", "notes"),
        ("generated_without_arctangents", "generated"),
        ("generated_without_arctangents", "notes"),
        ("generated_without_arctangents", "by_hand_without_arctangents"),
        ("sine_cosine_and_two_arctangents", "generated"),
        (
            "sine_cosine_and_two_arctangents",
            "the_library_s_sine_cosine_and_two_arctangents",
        ),
        ("single_precision", "generated"),
        (
            "single_precision_sine_cosine_and_two_arctangents",
            "sine_cosine_and_two_arctangents",
        ),
        ("position", "generated"),
        ("through_velocity", "generated"),
        ("through_acceleration", "generated"),
        ("through_jerk", "generated"),
        ("through_snap", "generated"),
    ] {
        times.ratio(&format!("four_bar.{name}"), &format!("four_bar.{other}"));
    }
}

fn slider_cranks() {
    let dimensions = slider_crank::Dimensions { r: 0.4, l: 1.1 };
    let mechanism = SliderCrank {
        r: dimensions.r,
        l: dimensions.l,
    };
    let motions = motions(-3.1, 3.1);
    let typed: Vec<_> = motions.iter().map(|motion| Motion::new(*motion)).collect();
    let notes: Vec<_> = motions
        .iter()
        .map(|motion| slider_crank::solve(dimensions, *motion, slider_crank::Rod::Forward))
        .collect();
    let generated: Vec<_> = typed
        .iter()
        .map(|motion| mechanism.solve(*motion, Assembly::Open).expect("it closes"))
        .collect();
    assert_same(
        "slider-crank, phi",
        &notes.iter().map(|pose| pose.phi).collect::<Vec<_>>(),
        &generated.iter().map(|pose| pose.phi.derivatives()).collect::<Vec<_>>(),
    );
    assert_same(
        "slider-crank, s",
        &notes.iter().map(|pose| pose.s).collect::<Vec<_>>(),
        &generated.iter().map(|pose| pose.s.derivatives()).collect::<Vec<_>>(),
    );

    let by_hand = floor::SliderCrank {
        r: dimensions.r,
        l: dimensions.l,
    };
    let hand: Vec<[[f64; 5]; 2]> = motions
        .iter()
        .map(|motion| by_hand.solve::<false>(*motion).expect("it closes"))
        .collect();
    assert_same(
        "slider-crank by hand, phi",
        &hand.iter().map(|pose| pose[0]).collect::<Vec<_>>(),
        &generated.iter().map(|pose| pose.phi.derivatives()).collect::<Vec<_>>(),
    );
    assert_same(
        "slider-crank by hand, s",
        &hand.iter().map(|pose| pose[1]).collect::<Vec<_>>(),
        &generated.iter().map(|pose| pose.s.derivatives()).collect::<Vec<_>>(),
    );

    let mut race = Race::new(POSES);
    race.enter("slider_crank.by_hand", motions.clone(), move |motion| {
        black_box(by_hand).solve::<false>(motion)
    });
    race.enter("slider_crank.by_hand_beside", motions.clone(), move |motion| {
        black_box(by_hand).solve::<true>(motion)
    });
    race.enter("slider_crank.notes", motions, |motion| {
        slider_crank::solve(black_box(dimensions), motion, slider_crank::Rod::Forward)
    });
    race.enter("slider_crank.generated", typed, |motion| {
        black_box(mechanism).solve(motion, Assembly::Open)
    });
    let times = race.run();
    times.ratio("slider_crank.generated", "slider_crank.notes");
    times.ratio("slider_crank.generated", "slider_crank.by_hand");
    times.ratio("slider_crank.generated", "slider_crank.by_hand_beside");
}

fn inverted_slider_cranks() {
    let dimensions = inverted_slider_crank::Dimensions { r1: 2.0, r2: 0.8 };
    let mechanism = InvertedSliderCrank {
        r1: dimensions.r1,
        r2: dimensions.r2,
    };
    let motions = motions(-3.1, 3.1);
    let typed: Vec<_> = motions.iter().map(|motion| Motion::new(*motion)).collect();
    // the lever swings by less than a right angle
    let branch = inverted_slider_crank::Branch::closing(dimensions, 0.0, false);
    let solve = move |dimensions, motion: [f64; 5]| {
        let position = inverted_slider_crank::position(dimensions, motion[0], branch);
        inverted_slider_crank::derivatives(dimensions, motion, position)
    };
    let notes: Vec<_> = motions.iter().map(|motion| solve(dimensions, *motion)).collect();
    let generated: Vec<_> = typed
        .iter()
        .map(|motion| mechanism.solve(*motion).expect("it closes"))
        .collect();
    assert_same(
        "inverted slider-crank, r4",
        &notes.iter().map(|pose| pose.r4).collect::<Vec<_>>(),
        &generated.iter().map(|pose| pose.r4.derivatives()).collect::<Vec<_>>(),
    );
    assert_same(
        "inverted slider-crank, theta4",
        &notes.iter().map(|pose| pose.theta4).collect::<Vec<_>>(),
        &generated
            .iter()
            .map(|pose| pose.theta4.derivatives())
            .collect::<Vec<_>>(),
    );

    let by_hand = floor::InvertedSliderCrank {
        r1: dimensions.r1,
        r2: dimensions.r2,
    };
    let hand: Vec<[[f64; 5]; 2]> = motions
        .iter()
        .map(|motion| by_hand.solve::<false>(*motion).expect("it closes"))
        .collect();
    assert_same(
        "inverted slider-crank by hand, r4",
        &hand.iter().map(|pose| pose[0]).collect::<Vec<_>>(),
        &generated.iter().map(|pose| pose.r4.derivatives()).collect::<Vec<_>>(),
    );
    assert_same(
        "inverted slider-crank by hand, theta4",
        &hand.iter().map(|pose| pose[1]).collect::<Vec<_>>(),
        &generated
            .iter()
            .map(|pose| pose.theta4.derivatives())
            .collect::<Vec<_>>(),
    );

    let mut race = Race::new(POSES);
    race.enter("inverted_slider_crank.by_hand", motions.clone(), move |motion| {
        black_box(by_hand).solve::<false>(motion)
    });
    race.enter("inverted_slider_crank.by_hand_beside", motions.clone(), move |motion| {
        black_box(by_hand).solve::<true>(motion)
    });
    race.enter("inverted_slider_crank.notes", motions, move |motion| {
        solve(black_box(dimensions), motion)
    });
    race.enter("inverted_slider_crank.generated", typed, |motion| {
        black_box(mechanism).solve(motion)
    });
    let times = race.run();
    times.ratio("inverted_slider_crank.generated", "inverted_slider_crank.notes");
    times.ratio("inverted_slider_crank.generated", "inverted_slider_crank.by_hand");
    times.ratio(
        "inverted_slider_crank.generated",
        "inverted_slider_crank.by_hand_beside",
    );
}

fn main() {
    four_bar();
    slider_cranks();
    inverted_slider_cranks();
}
