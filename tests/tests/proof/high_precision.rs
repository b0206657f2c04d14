//! The library's mechanisms against a reference of 50 digits and more: `errors.txt` and `docs/accuracy.md`
//! are what is measured here.
//!
//! The worst errors and their places are printed: `cargo test -p kin-tests --test proof high_precision -- --nocapture`.

use std::collections::BTreeMap;

use kin_core::library::FourBar;
use kin_core::{Assembly, Mechanism, Motion, Pose as _, Row};
use kin_tests::batches;
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};
use kin_tests::reference::{Errors, Given, Kind, Pose, Solution, poses, solution};

/// As many units of error are allowed, at every order.
const ALLOWED: f64 = 8.0;

fn given<M: ThroughSnap>(pose: &Pose<M>) -> Given {
    Given {
        parameters: pose.mechanism.parameters().as_ref().to_vec(),
        inputs: pose
            .inputs
            .as_ref()
            .iter()
            .map(|motion| motion.derivatives().to_vec())
            .collect(),
    }
}

/// The errors in double precision, of all poses.
fn double<M: ThroughSnap>(poses: &[Pose<M>]) -> Errors {
    let mut errors = Errors::new::<M>();
    for pose in poses {
        let motions: Vec<Vec<f64>> = pose.unknowns.iter().map(|motion| motion.to_vec()).collect();
        let place = format!("{:?} in {:?}", pose.kind, pose.assembly);
        let given = given(pose);
        let held = errors.hold::<M>(&given, &motions, f64::EPSILON, &place);
        assert_eq!(held, Ok(()), "{}, {place}: {given:?}", errors.name);
    }
    errors
}

/// A mechanism in single precision.
type Narrow<M> = <M as Mechanism>::With<f32>;

/// Poses in single precision, the assembly of each, and the numbers that are given, for the reference.
struct Narrowed<M: ThroughSnap> {
    poses: batches::Poses<Narrow<M>>,
    assemblies: Vec<M::Assembly>,
    given: Vec<(Given, String)>,
}

/// The poses rounded to single precision, without those near limits: they are as near as double precision can tell.
fn narrowed<M: ThroughSnap>(poses: &[Pose<M>]) -> Narrowed<M> {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the nearest single-precision number is meant"
    )]
    let nearest = |value: f64| value as f32;
    let mut narrowed = Narrowed::<M> {
        poses: batches::Poses {
            mechanisms: Vec::new(),
            inputs: Vec::new(),
            near: Vec::new(),
        },
        assemblies: Vec::new(),
        given: Vec::new(),
    };
    for pose in poses.iter().filter(|pose| pose.kind != Kind::NearLimit) {
        let mechanism: Narrow<M> = pose.mechanism.convert(nearest);
        let wide = given(pose);
        let inputs: <Narrow<M> as Mechanism>::Inputs<_> = Row::from_fn(|index| {
            let motion: M::Motion<f32> = Row::from_fn(|order| nearest(wide.inputs[index][order]));
            motion
        });
        let given = Given {
            parameters: mechanism
                .parameters()
                .as_ref()
                .iter()
                .map(|value| f64::from(*value))
                .collect(),
            inputs: widened::<M>(inputs.as_ref()),
        };
        narrowed.poses.mechanisms.push(mechanism);
        narrowed.poses.inputs.push(inputs);
        narrowed
            .poses
            .near
            .push(Row::from_fn(|unknown| nearest(pose.unknowns[unknown][0])));
        narrowed.assemblies.push(pose.assembly);
        narrowed
            .given
            .push((given, format!("{:?} in {:?}", pose.kind, pose.assembly)));
    }
    narrowed
}

fn widened<M: ThroughSnap>(motions: &[M::Motion<f32>]) -> Vec<Vec<f64>> {
    let motion = |motion: &M::Motion<f32>| motion.as_ref().iter().map(|value| f64::from(*value)).collect();
    motions.iter().map(motion).collect()
}

/// The errors in single precision.
fn single<M: ThroughSnap>(poses: &[Pose<M>]) -> Errors {
    let mut errors = Errors::new::<M>();
    let Narrowed {
        poses,
        assemblies,
        given,
    } = narrowed(poses);
    for (index, assembly) in assemblies.into_iter().enumerate() {
        if let Ok(found) = poses.mechanisms[index].solve(poses.inputs[index], assembly) {
            let motions = widened::<M>(found.unknown_motions().as_ref());
            let (given, place) = &given[index];
            let held = errors.hold::<M>(given, &motions, f32::EPSILON.into(), place);
            assert_eq!(held, Ok(()), "{}, {place}: {given:?}", errors.name);
        }
    }
    errors
}

/// The errors of batches in single precision, in all vectors.
fn in_lanes<M: ThroughSnap>(all: &[Pose<M>]) -> Errors {
    /// More than the lanes of the widest vectors: fewer poses are solved one by one.
    const LEAST: usize = 40;
    let mut errors = Errors::new::<M>();
    let all = narrowed(all);
    // all vectors have the same reference, which takes longer than they do
    let mut references: Vec<Option<Solution>> = all.given.iter().map(|_| None).collect();
    let assemblies: Vec<Option<M::Assembly>> = if const { M::ASSEMBLY_COUNT > 0 } {
        M::assemblies().map(Some).collect()
    } else {
        vec![None]
    };
    for assembly in assemblies {
        let is_wanted = |index: &usize| assembly.is_none_or(|assembly| all.assemblies[*index] == assembly);
        let places: Vec<usize> = (0..all.given.len()).filter(is_wanted).collect();
        if places.is_empty() {
            continue;
        }
        let count = places.len().max(LEAST);
        let places: Vec<usize> = places.into_iter().cycle().take(count).collect();
        let poses = batches::Poses::<Narrow<M>> {
            mechanisms: places.iter().map(|place| all.poses.mechanisms[*place]).collect(),
            inputs: places.iter().map(|place| all.poses.inputs[*place]).collect(),
            near: places.iter().map(|place| all.poses.near[*place]).collect(),
        };
        for vectors in batches::vectors() {
            let (table, outcomes, summary) = poses.solve(assembly, vectors);
            assert!(summary.alone <= count / 2, "{}: {summary:?}", errors.name);
            for (index, place) in places.iter().enumerate() {
                let alone = poses.solve_one(index, assembly);
                assert_eq!(outcomes[index].is_solved(), alone.is_ok(), "{}, {index}", errors.name);
                if outcomes[index].is_solved() {
                    let of = |motion: &Vec<Vec<f32>>| motion.iter().map(|column| f64::from(column[index])).collect();
                    let motions: Vec<Vec<f64>> = table.unknowns.iter().map(of).collect();
                    let (given, name) = &all.given[*place];
                    let reference = references[*place].get_or_insert_with(|| {
                        let position: Vec<f64> = motions.iter().map(|motion| motion[0]).collect();
                        solution::<M>(given, &position).expect("a pose that is found has a reference")
                    });
                    errors.hold_to::<M>(reference, given, &motions, f32::EPSILON.into(), name);
                }
            }
        }
    }
    errors
}

/// The recorded errors of every mechanism, by name.
fn recorded(heading: &str) -> BTreeMap<String, Vec<f64>> {
    include_str!("errors.txt")
        .lines()
        .skip_while(|line| *line != heading)
        .skip(1)
        .map_while(|line| line.strip_prefix("    ")?.split_once(' '))
        .map(|(name, errors)| {
            let errors = errors
                .split(' ')
                .map(|error| error.parse().expect("an error is a number"));
            (name.to_owned(), errors.collect())
        })
        .collect()
}

/// The table of the book has the largest recorded errors.
#[test]
fn the_book_has_the_largest_errors() {
    let book = include_str!("../../../docs/accuracy.md");
    for heading in ["double precision", "single precision", "single precision in lanes"] {
        let rows = recorded(heading);
        let largest: Vec<String> = (0..5)
            .map(|order| rows.values().map(|row| row[order]).fold(0.0, f64::max))
            .map(|error| format!("{error:.1}"))
            .collect();
        let row = format!("| {heading} | {} |", largest.join(" | "));
        assert!(
            book.lines().any(|line| line == row),
            "docs/accuracy.md should say\n{row}"
        );
    }
}

/// Measures every mechanism of a group, and compares with what is recorded.
struct Table<F> {
    rows: BTreeMap<String, Vec<f64>>,
    measure: F,
    kinds: BTreeMap<Kind, usize>,
    mistakes: Vec<String>,
}

trait Measure {
    fn errors<M: ThroughSnap>(&self, poses: &[Pose<M>]) -> Errors;
}

struct Double;

impl Measure for Double {
    fn errors<M: ThroughSnap>(&self, poses: &[Pose<M>]) -> Errors {
        double(poses)
    }
}

struct Single;

impl Measure for Single {
    fn errors<M: ThroughSnap>(&self, poses: &[Pose<M>]) -> Errors {
        single(poses)
    }
}

/// The mechanisms that are measured without the feature `every-case`.
const FEW: [&str; 4] = ["FourBar", "OffsetSliderCrank", "ScotchYoke", "Rssr"];

/// Whether a mechanism is measured: known when it is compiled, so that the measure is not compiled for the others.
const fn is_measured(name: &str) -> bool {
    let mut index = 0;
    while index < FEW.len() {
        if is_same(name.as_bytes(), FEW[index].as_bytes()) {
            return true;
        }
        index += 1;
    }
    cfg!(feature = "every-case")
}

const fn is_same(one: &[u8], other: &[u8]) -> bool {
    let mut index = 0;
    while index < one.len() && index < other.len() && one[index] == other[index] {
        index += 1;
    }
    index == one.len() && index == other.len()
}

struct SingleInLanes;

impl Measure for SingleInLanes {
    fn errors<M: ThroughSnap>(&self, poses: &[Pose<M>]) -> Errors {
        in_lanes(poses)
    }
}

impl<F: Measure> Visitor for Table<F> {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        if const { !is_measured(M::DESCRIPTION.name) } {
            assert!(
                self.rows.remove(M::DESCRIPTION.name).is_some(),
                "{}",
                M::DESCRIPTION.name
            );
            return;
        }
        let poses = poses::<M>(&case);
        for pose in &poses {
            *self.kinds.entry(pose.kind).or_default() += 1;
        }
        let errors = self.measure.errors(&poses);
        print!("{errors}");
        if errors.poses < 10 {
            self.mistakes
                .push(format!("{}: only {} poses", errors.name, errors.poses));
        }
        // written so that what is no number is a mistake, too
        if !errors.worst.iter().all(|worst| *worst <= ALLOWED) {
            self.mistakes.push(errors.to_string());
        }
        // the last digit of sines and cosines is not the same on all platforms
        let agrees = |measured: f64, said: f64| measured <= 1.5 * said + 0.2 && said <= 1.5 * measured + 0.2;
        let row = self.rows.remove(errors.name).unwrap_or_default();
        if row.len() != errors.worst.len() || !errors.worst.iter().zip(row).all(|(worst, said)| agrees(*worst, said)) {
            self.mistakes
                .push(format!("tests/proof/errors.txt should say\n    {}", errors.row()));
        }
    }
}

fn check(heading: &str, measure: impl Measure) -> BTreeMap<Kind, usize> {
    let mut table = Table {
        rows: recorded(heading),
        measure,
        kinds: BTreeMap::new(),
        mistakes: Vec::new(),
    };
    if cfg!(feature = "every-case") {
        cases::library(&mut table);
        cases::coupled_library(&mut table);
        assert!(table.rows.is_empty(), "not in the library: {:?}", table.rows);
    } else {
        cases::library_of_each_form(&mut table);
    }
    println!("{:?}", table.kinds);
    assert!(table.mistakes.is_empty(), "{}", table.mistakes.join("\n"));
    table.kinds
}

#[test]
fn double_precision() {
    let kinds = check("double precision", Double);
    if cfg!(feature = "every-case") {
        assert_eq!(kinds.len(), 6, "{kinds:?}");
        assert!(kinds.values().all(|count| *count >= 100), "{kinds:?}");
    }
}

#[test]
fn single_precision() {
    check("single precision", Single);
}

#[test]
fn single_precision_in_lanes() {
    check("single precision in lanes", SingleInLanes);
}

/// The reference itself: a parallelogram's rocker moves as its crank does, and its coupler does not turn.
#[test]
fn a_parallelogram_to_fifty_digits() {
    let crank = [0.7, -3.0, 2.0, 11.0, -50.0];
    let given = Given {
        parameters: vec![3.0, 1.0, 3.0, 1.0],
        inputs: vec![crank.to_vec()],
    };
    // from a position that is only near
    let found = solution::<FourBar>(&given, &[0.01, 0.69]).expect("a parallelogram closes");
    for (order, expected) in crank.into_iter().enumerate() {
        let theta3 = found.motions[0][order].nearest();
        let theta4 = (&found.motions[1][order] - &kin_precise::Number::exactly(expected)).nearest();
        assert!(
            theta3.abs() < 1e-52 && theta4.abs() < 1e-52,
            "order {order}: {theta3} {theta4}"
        );
    }
}

/// The test can fail: at every order it sees an error that other oracles let pass.
#[test]
fn a_wrong_twelfth_digit_is_found() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 60.0,
        r4: 45.0,
    };
    let crank = Motion::from([1.1, -10.0, 2.0, -0.5, 0.3]);
    let pose = linkage.solve(crank, Assembly::Open).expect("it closes");
    let right = [pose.theta3, pose.theta4].map(|motion| motion.derivatives().to_vec());
    let given = Given {
        parameters: linkage.parameters().to_vec(),
        inputs: vec![crank.derivatives().to_vec()],
    };
    let worst = |motions: &[Vec<f64>]| {
        let mut errors = Errors::new::<FourBar>();
        errors
            .hold::<FourBar>(&given, motions, f64::EPSILON, "")
            .expect("there is a reference");
        errors.worst
    };
    assert!(worst(&right).iter().all(|worst| *worst < 1.0));
    for unknown in 0..2 {
        for order in 0..5 {
            let mut wrong = right.clone();
            wrong[unknown][order] *= 1.0 + 1e-12;
            let found = worst(&wrong);
            assert!(found[order] > ALLOWED, "{unknown} {order}: {found:?}");
        }
    }
}
