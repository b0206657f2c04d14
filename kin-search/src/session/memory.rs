//! The memory that a session may take.

use std::fmt;
use std::num::NonZero;
use std::sync::Arc;

use datafusion::common::Result;
use datafusion::execution::memory_pool::{
    GreedyMemoryPool, MemoryLimit, MemoryPool, MemoryReservation, TrackConsumersPool,
};

/// The number of the largest operators that an error names.
const NAMED: NonZero<usize> = NonZero::new(5).unwrap();

/// The operator that hands rows from threads to threads.
const REPARTITION: &str = "RepartitionExec";

/// A pool of so many bytes. Whoever asks for more gets an error, or writes to the disk if it can.
pub(super) fn pool(bytes: usize) -> Arc<dyn MemoryPool> {
    Arc::new(TrackConsumersPool::new(Pool(GreedyMemoryPool::new(bytes)), NAMED))
}

/// The engine's greedy pool, in which a repartition is counted and never refused.
///
/// A repartition that is refused writes rows to files. The engine up to its version 55.2 then stands still for ever if
/// two threads do so at a time: the reader waits for the older file, and its row is in the newer file
/// (apache/datafusion, issue 24883). The rows of a repartition wait for operators to take them, so they are few. The
/// memory that they take beyond the limit is refused to all other operators.
#[derive(Debug)]
struct Pool(GreedyMemoryPool);

impl MemoryPool for Pool {
    fn name(&self) -> &str {
        self.0.name()
    }

    fn grow(&self, reservation: &MemoryReservation, additional: usize) {
        self.0.grow(reservation, additional);
    }

    fn shrink(&self, reservation: &MemoryReservation, shrink: usize) {
        self.0.shrink(reservation, shrink);
    }

    fn try_grow(&self, reservation: &MemoryReservation, additional: usize) -> Result<()> {
        if reservation.consumer().name().starts_with(REPARTITION) {
            self.0.grow(reservation, additional);
            return Ok(());
        }
        self.0.try_grow(reservation, additional)
    }

    fn reserved(&self) -> usize {
        self.0.reserved()
    }

    fn memory_limit(&self) -> MemoryLimit {
        self.0.memory_limit()
    }
}

impl fmt::Display for Pool {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

#[cfg(test)]
mod tests {
    use datafusion::execution::memory_pool::MemoryConsumer;

    use super::*;

    #[test]
    fn a_repartition_is_counted_and_never_refused() {
        let pool = pool(1000);
        let hands_on = MemoryConsumer::new("RepartitionExec[0]")
            .with_can_spill(true)
            .register(&pool);
        let holds = MemoryConsumer::new("FinalHashAggregateStream[0]").register(&pool);
        holds.try_grow(900).expect("there is room");
        holds.try_grow(200).expect_err("there is none");
        hands_on.try_grow(200).expect("it is never refused");
        assert_eq!(pool.reserved(), 1100);
        holds
            .try_grow(1)
            .expect_err("the repartition has taken more than there was");
        hands_on.free();
        holds.try_grow(100).expect("there is room again");
    }
}
