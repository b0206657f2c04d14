//! Many poses in one call: the four-bar linkage through snap in every kind of vectors that the machine has, against the
//! notes' formulas one pose after the other; other mechanisms against their own solver of one pose.
//!
//! `cargo bench -p kin-tests --bench batch` prints lines `ratio NAME VALUE`, from times taken in one run.
#![allow(missing_docs, reason = "a program")]
#![allow(clippy::cast_precision_loss, reason = "there are hundreds of poses")]

mod careful;
mod measure;

use core::hint::black_box;

use kin_core::Prepared;
use kin_core::batch::{Batch, Column, Fold, FoldedNumber, InputGrid, Outcome, Slot, Vectors};
use kin_core::library::{
    ClassThreeTriad, ClassThreeTriadBatch, FourBar, FourBarBatch, JansenLeg, Rssr, SliderCrank, SliderCrankBatch,
    SphericalFourBar,
};
use kin_core::prelude::*;
use kin_tests::batches::Table;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::notes::{self, four_bar_geometric, sample};
use kin_tests::random::Random;
use measure::{Race, ratio};

mechanism! {
    /// The library's four-bar linkage with unit vectors in the place of the angles.
    pub struct ToUnitVectors { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
    input theta2: Angle;
    unknown theta3: Direction, theta4: Direction;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

/// Poses in each turn: their columns fit into the first cache, as those of a sweep do that is looked at piece by piece.
const POSES: usize = 256;

/// Poses of a turn on all cores.
const MANY: usize = 1 << 16;

fn kinds() -> impl Iterator<Item = (Vectors, &'static str)> {
    [
        (Vectors::Compiled, "compiled"),
        (Vectors::Avx2, "avx2"),
        (Vectors::Avx512, "avx512"),
    ]
    .into_iter()
    .filter(|(vectors, _)| vectors.are_there())
}

fn motions(low: f64, high: f64, count: usize) -> Vec<[f64; 5]> {
    let mut random = Random::new(1);
    let step = (high - low) / count as f64;
    (0..count)
        .map(|index| random.motion(low + step * (index as f64 + 0.5)))
        .collect()
}

fn columns(motions: &[[f64; 5]]) -> [Vec<f64>; 5] {
    [0, 1, 2, 3, 4].map(|order| motions.iter().map(|motion| motion[order]).collect())
}

fn each(columns: &[Vec<f64>; 5]) -> Motion<Column<'_>, 5> {
    Motion::new([0, 1, 2, 3, 4].map(|order| Column::Each(black_box(&columns[order]))))
}

fn linkage() -> FourBar {
    let r = sample::DIMENSIONS;
    FourBar {
        r1: r.r1,
        r2: r.r2,
        r3: r.r3,
        r4: r.r4,
    }
}

/// Places for what is unknown; the inputs are there already.
fn places(count: usize) -> FourBarBatch<Option<Vec<f64>>> {
    let mut poses = FourBarBatch::filled(|| Some(vec![0.0; count]));
    poses.theta2.as_mut().fill(None);
    poses
}

fn four_bar() {
    let r = sample::DIMENSIONS;
    let linkage = linkage();
    let motions = motions(-1.8, 1.8, POSES);
    let columns = columns(&motions);
    let with_branches: Vec<_> = motions
        .iter()
        .map(|motion| {
            let branch = four_bar_geometric::Branch::closing(r, motion[0], notes::Assembly::Open);
            (*motion, branch)
        })
        .collect();
    let mut race = Race::new(POSES);
    race.enter("four_bar.notes_with_care", with_branches.clone(), |(motion, branch)| {
        careful::solve(black_box(r), motion, branch)
    });
    race.enter("four_bar.notes", with_branches, |(motion, branch)| {
        let r = black_box(r);
        four_bar_geometric::derivatives(r, motion, four_bar_geometric::position(r, motion[0], branch))
    });
    let typed = motions.iter().map(|motion| Motion::new(*motion)).collect::<Vec<_>>();
    race.enter("four_bar.generated", typed, |motion| {
        black_box(linkage).solve(motion, Assembly::Open)
    });
    for (vectors, name) in kinds() {
        let (mut poses, mut outcomes) = (places(POSES), vec![Outcome::Unsolved; POSES]);
        let columns = &columns;
        race.enter_batch(format!("four_bar.batch.{name}"), move || {
            let parameters = black_box(linkage).parameters().map(Column::Same);
            let (inputs, assembly) = ([each(columns)], Assembly::Open);
            let summary = Batch::<FourBar, _>::new(parameters, inputs, assembly)
                .vectors(vectors)
                .solve(&mut poses, &mut outcomes)
                .expect("the columns are of one length");
            assert_eq!((summary.solved, summary.alone), (POSES, 0));
            black_box((&mut poses, &mut outcomes));
        });
    }
    let to_unit_vectors = ToUnitVectors::<f64>::from_parameters(linkage.parameters());
    for (vectors, name) in kinds() {
        let mut poses = ToUnitVectorsBatch::filled(|| Some(vec![0.0; POSES]));
        poses.theta2.as_mut().fill(None);
        let mut outcomes = vec![Outcome::Unsolved; POSES];
        let columns = &columns;
        race.enter_batch(format!("four_bar.batch_to_unit_vectors.{name}"), move || {
            let parameters = black_box(to_unit_vectors).parameters().map(Column::Same);
            let (inputs, assembly) = ([each(columns)], Assembly::Open);
            let summary = Batch::<ToUnitVectors, _>::new(parameters, inputs, assembly)
                .vectors(vectors)
                .solve(&mut poses, &mut outcomes)
                .expect("the columns are of one length");
            assert_eq!((summary.solved, summary.alone), (POSES, 0));
            black_box((&mut poses, &mut outcomes));
        });
    }
    let varying = columns[0].iter().map(|angle| 60.0 + angle.sin()).collect::<Vec<_>>();
    let (mut poses, mut outcomes) = (places(POSES), vec![Outcome::Unsolved; POSES]);
    let columns = &columns;
    race.enter_batch("four_bar.batch.varying", move || {
        let linkage = linkage.parameters().map(Column::Same);
        let linkage = FourBar {
            r1: linkage[0],
            r2: linkage[1],
            r3: Column::Each(black_box(&varying)),
            r4: linkage[3],
        };
        let summary = linkage
            .batch(each(columns), Assembly::Open)
            .solve(&mut poses, &mut outcomes)
            .expect("the columns are of one length");
        assert_eq!(summary.solved, POSES);
        black_box((&mut poses, &mut outcomes));
    });
    let times = race.run();
    times.ratio("four_bar.generated", "four_bar.notes");
    for (_, name) in kinds() {
        times.ratio(&format!("four_bar.batch.{name}"), "four_bar.notes");
        times.ratio(&format!("four_bar.batch.{name}"), "four_bar.notes_with_care");
        times.ratio(&format!("four_bar.batch_to_unit_vectors.{name}"), "four_bar.notes");
        times.ratio(
            &format!("four_bar.batch_to_unit_vectors.{name}"),
            &format!("four_bar.batch.{name}"),
        );
    }
    times.ratio("four_bar.batch.varying", "four_bar.notes");
}

/// A batch of the four-bar linkage in one precision.
macro_rules! enter_in_precision {
    ($race:ident, $float:ty, $columns:ident, $vectors:ident, $name:expr) => {{
        let columns: [Vec<$float>; 5] = $columns
            .each_ref()
            .map(|column| column.iter().map(|value| *value as $float).collect());
        let parameters = linkage().parameters().map(|length| length as $float);
        let mut poses = FourBarBatch::filled(|| Some(vec![0.0; POSES]));
        poses.theta2.as_mut().fill(None);
        let mut outcomes = vec![Outcome::Unsolved; POSES];
        $race.enter_batch($name, move || {
            let parameters = black_box(parameters).map(Column::Same);
            let theta2 = Motion::new([0, 1, 2, 3, 4].map(|order| Column::Each(black_box(&columns[order]))));
            let summary = Batch::<FourBar<$float>, _>::new(parameters, [theta2], Assembly::Open)
                .vectors($vectors)
                .solve(&mut poses, &mut outcomes)
                .expect("the columns are of one length");
            assert_eq!((summary.solved, summary.alone), (POSES, 0));
            black_box((&mut poses, &mut outcomes));
        });
    }};
}

/// Single precision against double, in which there are half as many lanes: in batches, and of one pose.
#[allow(clippy::cast_possible_truncation, reason = "that is single precision")]
#[allow(clippy::cast_lossless, reason = "one macro writes both precisions")]
fn single_precision() {
    let motions = motions(-1.8, 1.8, POSES);
    let columns = columns(&motions);
    let mut race = Race::new(POSES);
    for (vectors, name) in kinds() {
        enter_in_precision!(race, f64, columns, vectors, format!("four_bar.double.{name}"));
        enter_in_precision!(race, f32, columns, vectors, format!("four_bar.single.{name}"));
    }
    let linkage = linkage();
    let typed = motions.iter().map(|motion| Motion::new(*motion)).collect::<Vec<_>>();
    race.enter("four_bar.double.one", typed, |motion| {
        black_box(linkage).solve(motion, Assembly::Open)
    });
    let linkage = FourBar::<f32>::from_parameters(linkage.parameters().map(|length| length as f32));
    let typed = motions
        .iter()
        .map(|motion| Motion::new(motion.map(|value| value as f32)))
        .collect::<Vec<_>>();
    race.enter("four_bar.single.one", typed, |motion| {
        black_box(linkage).solve(motion, Assembly::Open)
    });
    let times = race.run();
    for name in kinds().map(|(_, name)| name).chain(["one"]) {
        times.ratio(&format!("four_bar.single.{name}"), &format!("four_bar.double.{name}"));
    }
}

/// Shares of poses that are out of reach, in percent.
const SHARES: [u16; 5] = [0, 5, 38, 90, 100];

/// Poses of a turn in which some fail: more than a processor's memory of branches holds.
const MIXED: usize = 4096;

/// A linkage that closes over a part of the turn, at angles of which a share is out of reach, in no order.
fn out_of_reach() {
    let linkage = FourBar { r3: 40.0, ..linkage() };
    let closes = |angle: f64| linkage.position(angle, Assembly::Open).is_ok();
    let mut random = Random::new(2);
    let mut race = Race::new(MIXED);
    for share in SHARES {
        let mut poses = Vec::new();
        for _ in 0..MIXED {
            let fails = random.between(0.0, 100.0) < f64::from(share);
            let mut angle = random.between(-3.1, 3.1);
            while closes(angle) == fails {
                angle = random.between(-3.1, 3.1);
            }
            poses.push(random.motion(angle));
        }
        let failed = poses.iter().filter(|motion| !closes(motion[0])).count();
        let columns = columns(&poses);
        for (vectors, name) in kinds() {
            let (mut poses, mut outcomes) = (places(MIXED), vec![Outcome::Unsolved; MIXED]);
            let columns = columns.clone();
            race.enter_batch(format!("four_bar.batch_out_of_reach.{name}.{share}"), move || {
                let parameters = black_box(linkage).parameters().map(Column::Same);
                let (inputs, assembly) = ([each(&columns)], Assembly::Open);
                let summary = Batch::<FourBar, _>::new(parameters, inputs, assembly)
                    .vectors(vectors)
                    .solve(&mut poses, &mut outcomes)
                    .expect("the columns are of one length");
                assert_eq!((summary.failed, summary.alone), (failed, 0));
                black_box((&mut poses, &mut outcomes));
            });
        }
    }
    let times = race.run();
    for (_, name) in kinds() {
        for share in &SHARES[1..] {
            let of = |share: u16| format!("four_bar.batch_out_of_reach.{name}.{share}");
            times.ratio(&of(*share), &of(SHARES[0]));
        }
    }
}

fn slider_crank() {
    let crank = SliderCrank { r: 1.0, l: 3.0 };
    let motions = motions(-3.1, 3.1, POSES);
    let columns = columns(&motions);
    let mut race = Race::new(POSES);
    let typed = motions.iter().map(|motion| Motion::new(*motion)).collect::<Vec<_>>();
    race.enter("slider_crank.generated", typed, |motion| {
        black_box(crank).solve(motion, Assembly::Open)
    });
    let mut poses = SliderCrankBatch::filled(|| vec![0.0; POSES]);
    let mut outcomes = vec![Outcome::Unsolved; POSES];
    race.enter_batch("slider_crank.batch", move || {
        let summary = black_box(crank)
            .batch(each(&columns), Assembly::Open)
            .solve(&mut poses, &mut outcomes)
            .expect("the columns are of one length");
        assert_eq!(summary.solved, POSES);
        black_box((&mut poses, &mut outcomes));
    });
    let times = race.run();
    times.ratio("slider_crank.batch", "slider_crank.generated");
}

/// A block without a closed form: Newton's method, from one guess for all poses.
fn coupled() {
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    let near = [0.1, 2.2, -2.0, 1.6];
    let legs: Vec<[f64; 5]> = motions(-0.02, 0.02, POSES)
        .into_iter()
        .map(|[change, rates @ ..]| [5.0_f64.sqrt() + change, rates[0], rates[1], rates[2], rates[3]])
        .collect();
    let leg = columns(&legs);
    let mut race = Race::new(POSES);
    let typed = legs.iter().map(|motion| Motion::new(*motion)).collect::<Vec<_>>();
    race.enter("triad.generated", typed, |leg| {
        black_box(triad).solve_near(leg, leg, leg, near)
    });
    let mut poses = ClassThreeTriadBatch::filled(|| vec![0.0; POSES]);
    let mut outcomes = vec![Outcome::Unsolved; POSES];
    race.enter_batch("triad.batch", move || {
        let near = near.map(Column::Same);
        let summary = black_box(triad)
            .batch(each(&leg), each(&leg), each(&leg), near)
            .solve(&mut poses, &mut outcomes)
            .expect("the columns are of one length");
        assert_eq!(summary.solved, POSES);
        black_box((&mut poses, &mut outcomes));
    });
    let times = race.run();
    times.ratio("triad.batch", "triad.generated");
}

/// Turns of a crank-rocker that are folded, against the same turns stored in slices: one number, three numbers, and one
/// with the transmission angle. Of many poses, and of one for each degree.
fn folds() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 80.0,
        r4: 60.0,
    };
    let parameters = || black_box(linkage).parameters().map(Column::Same);
    let [position, snap, speed] = [0, 4, 1].map(|order| Slot::Unknown(1, order));
    for count in [360, MANY] {
        let turn = InputGrid::revolution(0, count);
        let angles: Vec<f64> = (0..count).map(|index| turn.value(index)).collect();
        let mut theta2 = Motion::at_constant_speed(0.0, 10.0).map(Column::Same);
        theta2[0] = Column::Each(&angles);
        for (vectors, name) in kinds() {
            let mut race = Race::new(count);
            for orders in [&[0][..], &[0, 4, 1]] {
                let mut poses = FourBarBatch::filled(|| None);
                for order in orders {
                    poses.theta4[*order] = Some(vec![0.0; count]);
                }
                let mut outcomes = vec![Outcome::Unsolved; count];
                race.enter_batch(format!("turn.{count}.stored.{}.{name}", orders.len()), move || {
                    let (inputs, assembly) = ([theta2], Assembly::Open);
                    let summary = Batch::<FourBar, _>::new(parameters(), inputs, assembly)
                        .vectors(vectors)
                        .solve(&mut poses, &mut outcomes);
                    assert_eq!(summary.expect("the columns are of one length").solved, count);
                    black_box((&mut poses, &mut outcomes));
                });
            }
            let transmission = FoldedNumber::SmallestTransmissionAngle;
            for (kind, numbers) in [
                ("1", vec![FoldedNumber::At(position)]),
                ("3", vec![position.into(), snap.into(), speed.into()]),
                ("1_and_transmission", vec![position.into(), transmission]),
            ] {
                let mut folds: Vec<Fold> = numbers.into_iter().map(Fold::of).collect();
                race.enter_batch(format!("turn.{count}.folded.{kind}.{name}"), move || {
                    let summary = Batch::<FourBar, _>::new(parameters(), [theta2], Assembly::Open)
                        .vectors(vectors)
                        .fold(turn, &mut folds);
                    assert_eq!(summary.expect("the columns are of one length").solved, count);
                    black_box(&mut folds);
                });
            }
            let times = race.run();
            for (kind, stored) in [("1", "1"), ("3", "3"), ("1_and_transmission", "1")] {
                times.ratio(
                    &format!("turn.{count}.folded.{kind}.{name}"),
                    &format!("turn.{count}.stored.{stored}.{name}"),
                );
            }
        }
    }
}

/// All cores against one, far more poses than a cache holds.
fn all_cores() {
    let linkage = linkage();
    let columns = columns(&motions(-1.8, 1.8, MANY));
    let mut race = Race::new(MANY);
    for parallel in [false, true] {
        let (mut poses, mut outcomes) = (places(MANY), vec![Outcome::Unsolved; MANY]);
        let columns = &columns;
        let name = if parallel {
            "four_bar.all_cores"
        } else {
            "four_bar.one_core"
        };
        race.enter_batch(name, move || {
            let summary = if parallel {
                linkage
                    .batch(each(columns), Assembly::Open)
                    .on_all_cores()
                    .solve(&mut poses, &mut outcomes)
            } else {
                linkage
                    .batch(each(columns), Assembly::Open)
                    .solve(&mut poses, &mut outcomes)
            };
            assert_eq!(summary.expect("the columns are of one length").solved, MANY);
            black_box((&mut poses, &mut outcomes));
        });
    }
    let times = race.run();
    times.ratio("four_bar.all_cores", "four_bar.one_core");
    let cores = std::thread::available_parallelism().map_or(1, core::num::NonZero::get);
    ratio("four_bar.one_core/cores", 1.0 / cores as f64);
}

/// One pose after the other and in batches, with and without preparation. A batch with a column for each parameter is
/// not prepared.
fn prepared<M: ThroughSnap>(name: &str, mechanism: M, assembly: M::Assembly) {
    let motions = motions(-3.1, 3.1, POSES);
    let columns = columns(&motions);
    let inputs: Vec<_> = motions.iter().map(|motion| Motion::new(*motion)).collect();
    let prepared = Prepared::of(mechanism);
    let parameters = mechanism.parameters();
    let parameters: Vec<Vec<f64>> = parameters
        .as_ref()
        .iter()
        .map(|parameter| vec![*parameter; POSES])
        .collect();
    let mut race = Race::new(POSES);
    race.enter(format!("{name}.solve"), inputs.clone(), move |motion| {
        black_box(&mechanism).solve(M::Inputs::splat(motion), assembly)
    });
    race.enter(format!("{name}.prepared"), inputs, move |motion| {
        black_box(&prepared).solve(M::Inputs::splat(motion), assembly)
    });
    for (vectors, kind) in kinds() {
        for is_prepared in [false, true] {
            let (columns, parameters) = (&columns, &parameters);
            let mut poses = Table::new(&M::DESCRIPTION, POSES);
            let mut outcomes = vec![Outcome::Unsolved; POSES];
            let way = if is_prepared { "prepared" } else { "columns" };
            race.enter_batch(format!("{name}.batch.{way}.{kind}"), move || {
                let parameters = Row::from_fn(|index| {
                    let column: &Vec<f64> = &parameters[index];
                    if is_prepared {
                        Column::Same(black_box(column[0]))
                    } else {
                        Column::Each(black_box(column))
                    }
                });
                let motion: M::Motion<Column<'_>> = Row::from_fn(|order| Column::Each(black_box(&columns[order])));
                let inputs = M::Inputs::splat(motion);
                let summary = Batch::<M, _>::new(parameters, inputs, assembly)
                    .vectors(vectors)
                    .solve(&mut poses, &mut outcomes)
                    .expect("the columns are of one length");
                assert_eq!((summary.solved, summary.alone), (POSES, 0));
                black_box((&mut poses, &mut outcomes));
            });
        }
    }
    let times = race.run();
    times.ratio(&format!("{name}.prepared"), &format!("{name}.solve"));
    for (_, kind) in kinds() {
        times.ratio(
            &format!("{name}.batch.prepared.{kind}"),
            &format!("{name}.batch.columns.{kind}"),
        );
    }
}

fn what_is_prepared() {
    let [ground, crank, coupler, rocker] = [80.0_f64, 25.0, 70.0, 60.0].map(f64::to_radians);
    let spherical = SphericalFourBar {
        ground,
        crank,
        coupler,
        rocker,
    };
    prepared("spherical_four_bar", spherical, Assembly::Open);
    let rssr = Rssr {
        crank: 1.0,
        pivot: Space::new(3.0, 0.5, 0.8),
        axis: Space::new(0.2, 0.9, 0.3),
        arm: Space::new(0.4, -0.3, 1.9),
        rod: 3.3,
    };
    prepared("rssr", rssr, Assembly::Open);
    let leg = JansenLeg::HOLY_NUMBERS;
    prepared("jansen_leg", leg, JansenLeg::WALKING);
}

fn main() {
    four_bar();
    single_precision();
    out_of_reach();
    slider_crank();
    what_is_prepared();
    coupled();
    folds();
    all_cores();
}
