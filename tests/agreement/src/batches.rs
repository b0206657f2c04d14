//! Batches, in every kind of vectors that the machine has.

use kin_core::Mechanism;
use kin_core::any::{Described, Of};
use kin_core::batch::{
    AnyBatch, AnyFold, Column, ColumnChoice, Fold, FoldedNumber, GivenColumns, InputGrid, KeptMemory, Outcome, Slot,
    Vectors, WantedColumns,
};

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

/// The places of all numbers of a mechanism.
fn places(own: &(impl Described + ?Sized)) -> Vec<Slot> {
    let description = own.description();
    let mut places: Vec<Slot> = Vec::new();
    for order in 0..=description.order {
        places.extend((0..description.inputs.len()).map(|index| Slot::Input(index, order)));
        places.extend((0..description.unknowns.len()).map(|index| Slot::Unknown(index, order)));
        places.extend((0..description.outputs.len()).map(|index| Slot::Output(index, order)));
    }
    places.extend((0..description.unknowns.len()).map(Slot::Sine));
    places
}

/// All numbers that a batch finds, and its outcomes.
fn found<M: Mechanism>(
    own: &dyn AnyBatch,
    columns: &Columns,
    assembly: usize,
    vectors: Vectors,
) -> (Vec<Vec<u64>>, Vec<String>) {
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
    let places = places(own);
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

/// The poses of a turn: two pieces, of which the second one is no multiple of a number of lanes.
const TURN: usize = 801;

/// The summaries of all numbers over a turn of the first input, and the count of poses.
fn folded(
    own: &dyn AnyFold,
    parameters: &[f64],
    speeds: &[f64],
    assembly: usize,
    memory: &mut KeptMemory,
    vectors: Vectors,
) -> Vec<String> {
    let numbers = places(own).into_iter().map(FoldedNumber::At);
    let dyads = (0..own.dyad_count()).map(FoldedNumber::TransmissionAngle);
    let smallest = (own.dyad_count() > 0).then_some(FoldedNumber::SmallestTransmissionAngle);
    let mut folds: Vec<Fold> = numbers.chain(dyads).chain(smallest).map(Fold::of).collect();
    let parameters: Vec<Column<'_>> = parameters.iter().copied().map(Column::Same).collect();
    let motion = speeds.iter().copied().map(Column::Same).collect::<Vec<_>>();
    let inputs = vec![motion.as_slice(); own.description().inputs.len()];
    let given = GivenColumns {
        parameters: &parameters,
        inputs: &inputs,
        choice: ColumnChoice::Assembly(assembly),
    };
    let summary = own.fold_batch(InputGrid::revolution(0, TURN), given, &mut folds, memory, vectors);
    let told = summary.map(|summary| format!("{} {} {}", summary.solved, summary.alone, summary.failed));
    let bits = |found: Option<(usize, f64)>| found.map(|(pose, value)| (pose, value.to_bits()));
    let all = folds.iter().map(|fold| {
        let folded = fold.folded();
        let sums = [folded.sum, folded.sum_of_squares].map(f64::to_bits);
        let number = fold.number();
        format!(
            "{number:?} {} {:?} {:?} {sums:?}",
            folded.count,
            bits(folded.least),
            bits(folded.greatest)
        )
    });
    [format!("{told:?}")].into_iter().chain(all).collect()
}

/// Compares folds over a turn in all assemblies, with memory that is kept from one to the next. Returns how many
/// numbers were summarised.
pub(crate) fn agreeing_folds<M: Mechanism<Scalar = f64>>(live: &kin_live::Mechanism, memory: &mut KeptMemory) -> usize {
    let description = live.description();
    let mut random = Random::new(6);
    let mut count = 0;
    for vectors in [Vectors::Compiled, Vectors::Avx2, Vectors::Avx512] {
        for assembly in 0..M::ASSEMBLY_COUNT.clamp(1, 4) {
            for _ in 0..4 {
                let mut numbers = |count: usize| (0..count).map(|_| random.number()).collect::<Vec<f64>>();
                let parameters = numbers(description.parameters.len());
                let parameters: Vec<f64> = parameters.into_iter().map(|value| value * value + 0.5).collect();
                let speeds = numbers(description.order + 1);
                let own = folded(live, &parameters, &speeds, assembly, memory, vectors);
                let none = &mut KeptMemory::default();
                let expected = folded(Of::<M>::FUNCTIONS, &parameters, &speeds, assembly, none, vectors);
                assert_eq!(own, expected, "{} {vectors:?}", description.name);
                count += own.iter().filter(|line| line.contains("Some")).count();
            }
        }
    }
    count
}
