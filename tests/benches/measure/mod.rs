//! Times of contenders that take turns.

use std::hint::black_box;
use std::time::Instant;

/// How often each contender has its turn.
const ROUNDS: usize = 600;

/// A race: contenders that each do the same number of poses in a turn.
///
/// They take turns, so that whatever else the machine does meets them all, and of each the shortest turn counts, which
/// is the one that was disturbed least.
pub(crate) struct Race<'a> {
    poses: usize,
    contenders: Vec<(String, Box<dyn FnMut() + 'a>)>,
}

impl<'a> Race<'a> {
    /// A race over so many poses in each turn.
    pub(crate) fn new(poses: usize) -> Self {
        Self {
            poses,
            contenders: Vec::new(),
        }
    }

    /// Enters a contender: a function of one of the inputs, for each of which it is called once in a turn. There must
    /// be as many as there are poses.
    #[allow(dead_code, reason = "the benchmarks of sweeps and cycles enter whole turns")]
    pub(crate) fn enter<I: Copy + 'a, R>(
        &mut self,
        name: impl Into<String>,
        inputs: Vec<I>,
        solve: impl Fn(I) -> R + 'a,
    ) {
        let name = name.into();
        assert_eq!(inputs.len(), self.poses, "{name} does not run the whole course");
        let turn = move || {
            for input in black_box(inputs.as_slice()) {
                // by reference: moved into the black box the result would be copied once more
                black_box(&solve(*input));
            }
        };
        self.contenders.push((name, Box::new(turn)));
    }

    /// Enters a contender that does all poses of a turn in one call.
    #[allow(dead_code, reason = "of the benchmarks, one is about batches")]
    pub(crate) fn enter_batch(&mut self, name: impl Into<String>, turn: impl FnMut() + 'a) {
        self.contenders.push((name.into(), Box::new(turn)));
    }

    /// Runs it, and prints the time of each contender.
    pub(crate) fn run(mut self) -> Times {
        let mut fastest = vec![f64::INFINITY; self.contenders.len()];
        for _ in 0..ROUNDS {
            for ((_, turn), fastest) in self.contenders.iter_mut().zip(&mut fastest) {
                let start = Instant::now();
                turn();
                *fastest = fastest.min(start.elapsed().as_secs_f64());
            }
        }
        #[allow(clippy::cast_precision_loss, reason = "there are hundreds")]
        let poses = self.poses as f64;
        let times: Vec<(String, f64)> = self
            .contenders
            .into_iter()
            .zip(fastest)
            .map(|((name, _), fastest)| (name, fastest / poses * 1e9))
            .collect();
        for (name, time) in &times {
            println!("time {name} {time:.1} ns");
        }
        Times(times)
    }
}

/// Nanoseconds per pose of each contender.
pub(crate) struct Times(Vec<(String, f64)>);

impl Times {
    /// The time of one of them, if it ran.
    pub(crate) fn of(&self, name: &str) -> Option<f64> {
        let found = self.0.iter().find(|(contender, _)| contender == name);
        found.map(|&(_, time)| time)
    }

    /// Prints how many times as long as the other one a contender takes.
    pub(crate) fn ratio(&self, name: &str, other: &str) {
        let [time, other_time] =
            [name, other].map(|name| self.of(name).unwrap_or_else(|| panic!("{name} was not timed")));
        ratio(&format!("{name}/{other}"), time / other_time);
    }
}

/// Prints a ratio in the form in which all are printed.
pub(crate) fn ratio(name: &str, value: f64) {
    println!("ratio {name} {value:.3}");
}
