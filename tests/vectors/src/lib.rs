//! The times of batches beside each other.

use std::hint::black_box;
use std::time::{Duration, Instant};

use kin_core::batch::{AnyBatch, GivenColumns, Outcome, Slot, Vectors, WantedColumns};

/// The runs of each contender.
const RUNS: usize = 100;

/// The nanoseconds that each contender, a batch with some vectors, takes for a pose: the shortest of many runs, which
/// alternate. A batch solves the unknowns through the highest order.
///
/// # Panics
/// If lengths of columns differ from the number of poses, or fewer poses are solved than `least_solved`.
#[must_use]
pub fn nanoseconds(
    given: GivenColumns<'_>,
    poses: usize,
    least_solved: usize,
    contenders: &[(&dyn AnyBatch, Vectors)],
) -> Vec<f64> {
    let mut outcomes = vec![Outcome::Unsolved; poses];
    let columns = |batch: &dyn AnyBatch| -> Vec<(Slot, Vec<f64>)> {
        let description = batch.description();
        let orders = 0..=description.order;
        let slots =
            orders.flat_map(|order| (0..description.unknowns.len()).map(move |index| Slot::Unknown(index, order)));
        slots.map(|slot| (slot, vec![0.0; poses])).collect()
    };
    let mut columns: Vec<_> = contenders.iter().map(|(batch, _)| columns(*batch)).collect();
    let mut shortest = vec![Duration::MAX; contenders.len()];
    for _ in 0..RUNS {
        for (((batch, vectors), columns), shortest) in contenders.iter().zip(&mut columns).zip(&mut shortest) {
            let wanted = columns.iter_mut().map(|(slot, column)| (*slot, column.as_mut_slice()));
            let mut wanted = WantedColumns::new(wanted.collect());
            let start = Instant::now();
            let summary = batch.solve_batch(black_box(given), &mut wanted, &mut outcomes, *vectors);
            *shortest = (*shortest).min(start.elapsed());
            let solved = summary.expect("the columns have one length").solved;
            assert!(
                solved >= least_solved,
                "{}: {solved} are solved",
                batch.description().name
            );
        }
    }
    #[expect(clippy::cast_precision_loss, reason = "there are less than 2⁵³ poses")]
    let nanoseconds = |time: &Duration| time.as_secs_f64() * 1e9 / poses as f64;
    shortest.iter().map(nanoseconds).collect()
}
