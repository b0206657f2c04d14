//! The time of a declaration, and of its solvers beside those that rustc compiled, in one run.
//!
//! ```sh
//! cargo bench -p kin-live
//! ```

#![allow(clippy::cast_precision_loss, reason = "there are a thousand poses")]

use std::hint::black_box;
use std::time::{Duration, Instant};

use kin_core::any::{AssemblyMotionOver, Described, MotionNearOver, Of};
use kin_core::batch::{AnyFold, Column, ColumnChoice, Fold, GivenColumns, InputGrid, KeptMemory, Slot, Vectors};
use kin_core::library::{ClassThreeTriad, FourBar, JansenLeg, SliderCrank, WattI};
use kin_core::{Mechanism, Plane};

/// The text between the braces of the declaration of a structure.
fn declaration<'a>(file: &'a str, name: &str) -> &'a str {
    let mut declarations = file.split("\ncrate::mechanism! {").skip(1);
    let found = declarations.find(|rest| rest.contains(&format!("pub struct {name} {{")));
    let rest = found.expect("the file declares it");
    &rest[..rest.find("\n}\n").expect("it ends")]
}

/// The shortest time of several runs.
fn shortest(runs: usize, mut run: impl FnMut()) -> Duration {
    let mut best = Duration::MAX;
    for _ in 0..runs {
        let start = Instant::now();
        run();
        best = best.min(start.elapsed());
    }
    best
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// The poses of one revolution.
const POSES: usize = 1000;

fn compare<M: Mechanism<Scalar = f64>>(file: &str, mechanism: &M, input: impl Fn(f64) -> f64, near: &[f64]) {
    let parameters = mechanism.parameters();
    let parameters = parameters.as_ref();
    let description = M::DESCRIPTION;
    let text = declaration(file, description.name);
    let declared = shortest(5, || {
        black_box(kin_live::Mechanism::declare(text).expect("it is one of the library"));
    });
    let live = kin_live::Mechanism::declare(text).expect("it is one of the library");
    let compiled = Of::<M>::FUNCTIONS;
    let orders = description.order + 1;
    let [mut unknowns, mut outputs] =
        [description.unknowns.len(), description.outputs.len()].map(|count| vec![0.0; count * orders]);
    let mut inputs = vec![0.0; description.inputs.len() * orders];
    let mut run = |solver: &dyn Both| {
        let mut solved = 0_usize;
        for pose in 0..POSES {
            for motion in inputs.chunks_exact_mut(orders) {
                motion[0] = input(pose as f64 / POSES as f64);
                motion[1] = 10.0;
            }
            let result = if M::ASSEMBLY_COUNT == 0 {
                solver.motion_near(parameters, &inputs, near, &mut unknowns, &mut outputs)
            } else {
                solver.motion_of_assembly(parameters, &inputs, 0, &mut unknowns, &mut outputs)
            };
            solved += usize::from(result.is_ok());
            black_box((&unknowns, &outputs));
        }
        // a leg may not close all around
        assert!(solved > POSES / 2, "{}", description.name);
    };
    let (mut solved, mut expected) = (Duration::MAX, Duration::MAX);
    for _ in 0..30 {
        solved = solved.min(shortest(1, || run(&live)));
        expected = expected.min(shortest(1, || run(compiled)));
    }
    let nanoseconds = |time: Duration| time.as_secs_f64() * 1e9 / POSES as f64;
    println!(
        "{:20} declared in {:5.1} ms, solved in {:6.0} ns, compiled {:6.0} ns: {:4.1} times",
        description.name,
        milliseconds(declared),
        nanoseconds(solved),
        nanoseconds(expected),
        nanoseconds(solved) / nanoseconds(expected),
    );
    let given: Vec<Column<'_>> = parameters.iter().map(|value| Column::Same(*value)).collect();
    let positions: Vec<f64> = (0..POSES).map(|pose| input(pose as f64 / POSES as f64)).collect();
    let columns = [Column::Each(&positions), Column::Same(10.0)];
    let columns = vec![columns.as_slice(); description.inputs.len()];
    let near: Vec<Column<'_>> = near.iter().map(|value| Column::Same(*value)).collect();
    let given = GivenColumns {
        parameters: &given,
        inputs: &columns,
        choice: if M::ASSEMBLY_COUNT == 0 {
            ColumnChoice::Near(&near)
        } else {
            ColumnChoice::Assembly(0)
        },
    };
    for vectors in [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512] {
        if !vectors.are_there() {
            continue;
        }
        // a leg may not close all around
        let times = kin_vectors::nanoseconds(given, POSES, POSES / 2 + 1, &[(&live, vectors), (compiled, vectors)]);
        println!(
            "{:20} in batches of {vectors:?} {:6.1} ns, compiled {:6.1} ns: {:4.1} times",
            "",
            times[0],
            times[1],
            times[0] / times[1],
        );
        if M::ASSEMBLY_COUNT == 0 {
            continue;
        }
        let grid = InputGrid::revolution(0, POSES);
        let mut folds = [Fold::of(Slot::Unknown(0, orders - 1))];
        let mut memory = KeptMemory::default();
        let mut run = |fold: &dyn AnyFold| {
            let summary = fold.fold_batch(grid, given, &mut folds, &mut memory, vectors);
            black_box((summary.expect("the columns have one length"), &folds));
        };
        let (mut folded, mut expected) = (Duration::MAX, Duration::MAX);
        for _ in 0..100 {
            folded = folded.min(shortest(1, || run(&live)));
            expected = expected.min(shortest(1, || run(compiled)));
        }
        println!(
            "{:20} folded over a revolution {vectors:?} {:6.1} ns, compiled {:6.1} ns: {:4.1} times",
            "",
            nanoseconds(folded),
            nanoseconds(expected),
            nanoseconds(folded) / nanoseconds(expected),
        );
    }
}

trait Both: AssemblyMotionOver<f64> + MotionNearOver<f64> {}

impl<F: AssemblyMotionOver<f64> + MotionNearOver<f64>> Both for F {}

fn main() {
    let start = Instant::now();
    let four_bar = declaration(include_str!("../../kin-core/src/library/four_bar.rs"), "FourBar");
    let live = kin_live::Mechanism::declare(four_bar).expect("it is one of the library");
    assert_eq!(live.description().name, "FourBar");
    println!("the first four-bar: {:.1} ms", milliseconds(start.elapsed()));
    let angle = |part: f64| 6.2 * part;
    let four_bar = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 70.0,
        r4: 60.0,
    };
    compare(
        include_str!("../../kin-core/src/library/four_bar.rs"),
        &four_bar,
        angle,
        &[],
    );
    let slider_crank = SliderCrank { r: 0.1, l: 0.3 };
    compare(
        include_str!("../../kin-core/src/library/slider_crank.rs"),
        &slider_crank,
        angle,
        &[],
    );
    let watt = WattI {
        r1: 4.0,
        r2: 1.4,
        r3: 3.0,
        r4: 2.5,
        p: Plane::new(1.0, 1.2),
        q: Plane::new(2.0, 1.5),
        r5: 2.5,
        r6: 2.0,
    };
    compare(
        include_str!("../../kin-core/src/library/watt_six_bars.rs"),
        &watt,
        angle,
        &[],
    );
    let jansen: JansenLeg = JansenLeg::HOLY_NUMBERS;
    compare(
        include_str!("../../kin-core/src/library/jansen_leg.rs"),
        &jansen,
        angle,
        &[],
    );
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    let leg = |part: f64| 5.0_f64.sqrt() + 1e-3 * part;
    compare(
        include_str!("../../kin-core/src/library/class_three_triad.rs"),
        &triad,
        leg,
        &[0.1, 2.2, -2.0, 1.6],
    );
}
