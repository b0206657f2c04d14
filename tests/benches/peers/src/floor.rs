//! The time below which no batch can be: that of its operations at full throughput, or of its columns through the
//! memory.
//!
//! Additions do not count, because most of them are fused with a product or run beside one. Of Newton's method only the
//! rates count.

use core::hint::black_box;
use std::path::Path;
use std::process::Command;

use kin_core::any::Of;
use kin_core::batch::{AnyBatch as _, Column, ColumnChoice, GivenColumns, Outcome, Slot, Vectors, WantedColumns};
use kin_core::prelude::*;
use kin_core::{Operations, Row};
use kin_tests::mechanisms::cases::ThroughSnap;

use crate::race::shortest;

/// How often each measurement is repeated. The shortest time counts.
const REPETITIONS: usize = 50;

/// Numbers of the columns that are copied: more than caches hold.
const COPIED: usize = 1 << 23;

/// Nanoseconds for one number, in vectors of all instructions of the machine.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    multiplication: f64,
    division: f64,
    square_root: f64,
    sine_cosine: f64,
    arc_tangent: f64,
    /// For a number that is read from the memory or written to it.
    memory: f64,
}

impl Units {
    /// What a program of this crate that is built for this machine measures.
    pub(crate) fn of(native: &Path) -> Option<Self> {
        let output = Command::new(native).arg("--units").output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        let &[multiplication, division, square_root, sine_cosine, arc_tangent, memory] = numbers.as_slice() else {
            return None;
        };
        Some(Self {
            multiplication,
            division,
            square_root,
            sine_cosine,
            arc_tangent,
            memory,
        })
    }

    /// Measures them, in a program that is built for this machine.
    pub(crate) fn print() {
        let factor = black_box(0.999_999);
        let multiplication = throughput(|number| number * factor);
        let division = throughput(|number| factor / number);
        let square_root = throughput(f64::sqrt);
        let mut units = Self {
            multiplication,
            division,
            square_root,
            sine_cosine: 0.0,
            arc_tangent: 0.0,
            memory: memory(),
        };
        let more = |few: (f64, Operations), many: (f64, Operations)| {
            let rest = units.of_operations(&many.1) - units.of_operations(&few.1);
            let functions = |own: &Operations| own.sine_cosines + own.arc_tangents;
            (many.0 - few.0 - rest) / as_number(functions(&many.1) - functions(&few.1))
        };
        let sine_cosine = more(
            time_of(OneSine { k: 0.3 }),
            time_of(FourSines { k: 0.3, l: 0.7, m: 1.1 }),
        );
        let arc_tangent = more(
            time_of(OneArcTangent { k: 0.3 }),
            time_of(FourArcTangents {
                k: 0.3,
                l: 0.7,
                m: 1.1,
                n: 1.9,
            }),
        );
        (units.sine_cosine, units.arc_tangent) = (sine_cosine, arc_tangent);
        println!(
            "{} {} {} {} {} {}",
            units.multiplication, units.division, units.square_root, units.sine_cosine, units.arc_tangent, units.memory
        );
    }

    /// The nanoseconds of the operations of a pose.
    fn of_operations(&self, operations: &Operations) -> f64 {
        let each = [
            (operations.multiplications, self.multiplication),
            (operations.divisions, self.division),
            (operations.square_roots, self.square_root),
            (operations.sine_cosines, self.sine_cosine),
            (operations.arc_tangents, self.arc_tangent),
        ];
        each.into_iter().map(|(count, time)| as_number(count) * time).sum()
    }

    /// The nanoseconds below which no batch of a mechanism can be, whose columns do or do not fit into the caches.
    pub(crate) fn floor<M: ThroughSnap>(&self, is_long: bool) -> f64 {
        let of_pose = total::<M>();
        let arithmetic = self.of_operations(&of_pose);
        if !is_long {
            return arithmetic;
        }
        let rows = M::DESCRIPTION.inputs.len() + <M::Results<f64> as Row<f64>>::LENGTH;
        // an outcome takes as much as two numbers
        let numbers = <M::Motion<f64> as Row<f64>>::LENGTH * rows + 2;
        arithmetic.max(as_number(numbers) * self.memory)
    }
}

fn total<M: Mechanism>() -> Operations {
    let orders = M::DESCRIPTION.operations.iter();
    orders.fold(Operations::NONE, |sum, order| sum.plus(*order))
}

#[allow(clippy::cast_precision_loss, reason = "there are millions at most")]
fn as_number(count: usize) -> f64 {
    count as f64
}

/// The time of an operation on one of many numbers that do not wait for each other.
fn throughput(operation: impl Fn(f64) -> f64) -> f64 {
    const NUMBERS: usize = 256;
    const STEPS: usize = 2_000;
    let mut numbers = [1.0; NUMBERS];
    let time = shortest(REPETITIONS, || {
        for _ in 0..STEPS {
            // eight steps for each number that is read and written
            for number in &mut numbers {
                let once = operation(operation(operation(operation(*number))));
                *number = operation(operation(operation(operation(once))));
            }
            black_box(&mut numbers);
        }
    });
    time / as_number(8 * STEPS * NUMBERS)
}

/// The time of a number that is read or written where columns are copied.
fn memory() -> f64 {
    let (from, mut to) = (vec![1.0; COPIED], vec![0.0; COPIED]);
    let time = shortest(REPETITIONS, || to.copy_from_slice(black_box(&from)));
    black_box(&mut to);
    time / as_number(2 * COPIED)
}

mechanism! {
    struct OneSine { k: Scalar }
    input a: Angle;
    unknown x: Scalar;
    order = 1;
    x == sin(k * a) * cos(k * a);
}

mechanism! {
    struct FourSines { k: Scalar, l: Scalar, m: Scalar }
    input a: Angle;
    unknown x: Scalar;
    order = 1;
    x == sin(a) * cos(a) + sin(k * a) * cos(k * a) + sin(l * a) * cos(l * a) + sin(m * a) * cos(m * a);
}

mechanism! {
    struct OneArcTangent { k: Scalar }
    input a: Scalar;
    unknown x: Angle;
    order = 1;
    x == atan2(a, k);
}

mechanism! {
    struct FourArcTangents { k: Scalar, l: Scalar, m: Scalar, n: Scalar }
    input a: Scalar;
    unknown x: Angle;
    order = 1;
    x == atan2(a, k) + atan2(a, l) + atan2(a, m) + atan2(a, n);
}

/// The time of a pose in a batch whose columns stay in the first cache, and its operations.
fn time_of<M: Mechanism<Scalar = f64> + 'static>(mechanism: M) -> (f64, Operations) {
    const POSES: usize = 480;
    let parameters: Vec<Column<'_>> = mechanism
        .parameters()
        .as_ref()
        .iter()
        .map(|value| Column::Same(*value))
        .collect();
    let positions: Vec<f64> = (0..POSES).map(|row| 0.006 * as_number(row) + 0.1).collect();
    let motion = [Column::Each(&positions), Column::Same(1.0)];
    let mut found = [vec![0.0; POSES], vec![0.0; POSES]];
    let mut outcomes = vec![Outcome::Unsolved; POSES];
    let [position, velocity] = &mut found;
    let mut wanted = WantedColumns::new(vec![
        (Slot::Unknown(0, 0), position.as_mut_slice()),
        (Slot::Unknown(0, 1), velocity.as_mut_slice()),
    ]);
    let choice = ColumnChoice::Assembly(0);
    let time = shortest(REPETITIONS, || {
        for _ in 0..100 {
            let given = GivenColumns {
                parameters: black_box(&parameters),
                inputs: &[&motion],
                choice,
            };
            let summary = Of::<M>::FUNCTIONS.solve_batch(given, &mut wanted, &mut outcomes, Vectors::widest());
            assert_eq!(summary.expect("the columns are of one length").solved, POSES);
        }
    });
    (time / as_number(100 * POSES), total::<M>())
}
