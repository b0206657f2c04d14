//! Batches, in every kind of vectors that the machine has.

use kin_core::Mechanism;
use kin_core::any::{Described, Of};
use kin_core::batch::{AnyBatch, Column, ColumnChoice, GivenColumns, Outcome, Place, Vectors, WantedColumns};

use crate::bits::Bits;
use crate::random::Random;

/// The number of poses, which is no multiple of a number of lanes.
const POSES: usize = 61;

/// The columns of a batch.
struct Columns {
    parameters: Vec<Vec<f64>>,
    /// For each input its orders.
    inputs: Vec<Vec<Vec<f64>>>,
    near: Vec<Vec<f64>>,
}

/// All numbers that a batch finds, and its outcomes.
fn found<M: Mechanism>(
    own: &dyn AnyBatch,
    columns: &Columns,
    assembly: usize,
    vectors: Vectors,
) -> (Vec<Vec<u64>>, Vec<String>) {
    let description = own.description();
    let orders = description.order + 1;
    let each = |columns: &[Vec<f64>]| -> Vec<Column<'static>> {
        columns
            .iter()
            .map(|column| Column::Each(Vec::leak(column.clone())))
            .collect()
    };
    let parameters = each(&columns.parameters);
    let inputs: Vec<Vec<Column<'_>>> = columns.inputs.iter().map(|orders| each(orders)).collect();
    let inputs: Vec<&[Column<'_>]> = inputs.iter().map(Vec::as_slice).collect();
    let near = each(&columns.near);
    let given = GivenColumns {
        parameters: &parameters,
        inputs: &inputs,
        choice: if M::ASSEMBLY_COUNT == 0 {
            ColumnChoice::Near(&near)
        } else {
            ColumnChoice::Assembly(assembly)
        },
    };
    let mut places: Vec<Place> = Vec::new();
    for order in 0..orders {
        places.extend((0..description.inputs.len()).map(|index| Place::Input(index, order)));
        places.extend((0..description.unknowns.len()).map(|index| Place::Unknown(index, order)));
        places.extend((0..description.outputs.len()).map(|index| Place::Output(index, order)));
    }
    places.extend((0..description.unknowns.len()).map(Place::Sine));
    let mut numbers = vec![vec![0.5; POSES]; places.len()];
    let wanted = places
        .into_iter()
        .zip(&mut numbers)
        .map(|(place, column)| (place, column.as_mut_slice()));
    let mut outcomes = vec![Outcome::Unsolved; POSES];
    let summary = own
        .solve_batch(given, &mut WantedColumns::new(wanted.collect()), &mut outcomes, vectors)
        .expect("the columns have one length");
    let mut told: Vec<String> = outcomes.iter().map(|outcome| format!("{outcome:?}")).collect();
    told.push(format!("{} {} {}", summary.solved, summary.alone, summary.failed));
    (
        numbers
            .into_iter()
            .map(|column| column.into_iter().flat_map(Bits::bits).collect())
            .collect(),
        told,
    )
}

/// Compares batches in all assemblies. Returns how many poses were solved.
pub(crate) fn agreeing<M: Mechanism<Scalar = f64>>(live: &kin_live::Mechanism) -> usize {
    let description = live.description();
    let mut random = Random::new(5);
    let mut column = || (0..POSES).map(|_| random.number()).collect::<Vec<f64>>();
    let mut columns = |count: usize| (0..count).map(|_| column()).collect::<Vec<_>>();
    let columns = Columns {
        parameters: columns(description.parameters.len())
            .into_iter()
            .map(|column| column.into_iter().map(|value| value * value + 0.5).collect())
            .collect(),
        inputs: (0..description.inputs.len())
            .map(|_| columns(description.order + 1))
            .collect(),
        near: columns(description.unknowns.len()),
    };
    let mut solved = 0;
    for vectors in [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512] {
        for assembly in 0..M::ASSEMBLY_COUNT.clamp(1, 4) {
            let (own, told) = found::<M>(live, &columns, assembly, vectors);
            let (expected, expected_told) = found::<M>(Of::<M>::FUNCTIONS, &columns, assembly, vectors);
            assert_eq!(told, expected_told, "{} {vectors:?}", description.name);
            assert_eq!(own, expected, "{} {vectors:?}", description.name);
            solved += told.iter().filter(|outcome| *outcome == "Solved").count();
        }
    }
    solved
}
