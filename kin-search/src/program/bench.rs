//! `bench`: how fast a search is, and what SQL costs.

use std::hint::black_box;
use std::time::Instant;

use kin_core::Mechanism;
use kin_core::batch::{Batch, Column, Fold, FoldedNumber, InputGrid, Outcome, Slot, Vectors};
use kin_core::library::{FourBar, FourBarBatch};
use kin_core::prelude::*;
use kin_search::candidates::Sequence;
use kin_search::{Functions, Options, session};

use super::fault::Fault;
use super::processor::seconds;

/// What `bench` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct BenchArguments {
    /// The number of candidates whose turns are measured
    #[arg(long, value_parser = clap::value_parser!(u32).range(1000..), default_value_t = 1_000_000)]
    ids: u32,
    /// How often each is measured, taking turns; the median counts
    #[arg(long, default_value_t = 5)]
    rounds: u32,
}

/// The poses of a turn.
const ANGLES: usize = 360;
/// The poses that the engine solves at a time.
const ROWS: usize = 8192;
/// The ids of the function for each pose, as a multiple of those of turns.
const POSES_PER_ID: u32 = 20;

const LOW: [f64; 3] = [0.1, 0.3, 0.3];
const HIGH: [f64; 3] = [1.0, 2.0, 2.0];

/// What is measured, in the order of the lines.
#[derive(Clone, Copy)]
enum Measured {
    RawTurns,
    FoldedTurns,
    Turns,
    DeclaredTurns,
    WholeTurns,
    RawPoses,
    Poses,
    Candidates,
}

const ALL: [Measured; 8] = [
    Measured::RawTurns,
    Measured::FoldedTurns,
    Measured::Turns,
    Measured::DeclaredTurns,
    Measured::WholeTurns,
    Measured::RawPoses,
    Measured::Poses,
    Measured::Candidates,
];

/// Seconds of this process's processor, or of the clock where the system does not tell them. Other programs on the
/// machine do not count.
fn processor() -> impl Fn() -> f64 {
    let (start, before) = (Instant::now(), seconds("self"));
    move || match seconds("self").zip(before) {
        Some((after, before)) => after - before,
        None => start.elapsed().as_secs_f64(),
    }
}

/// Measures, on one core. Everything but the time to a first answer is the median of some rounds.
pub(crate) async fn run(arguments: &BenchArguments, functions: &Functions) -> Result<(), Fault> {
    let (ids, rounds) = (arguments.ids.max(1), arguments.rounds.max(1));
    let poses = ids.saturating_mul(POSES_PER_ID);
    let options = Options {
        partitions: Some(1),
        ..Options::default()
    };
    let start = Instant::now();
    // compiled by rustc whatever the library is
    let with_compiled = functions.clone().with::<FourBar>();
    let with_declared = with_compiled.with_declaration(DECLARED);
    let with_declared = with_declared.map_err(|error| Fault::Wrong(error.to_string()))?;
    let session = session(&with_declared, &options)?;
    session.sql(&turns("four_bar_turn", 1)).await?.collect().await?;
    let first = start.elapsed();

    let mut times = ALL.map(|_| Vec::new());
    for _ in 0..rounds {
        for (measured, times) in ALL.into_iter().zip(&mut times) {
            let spent = processor();
            let query = match measured {
                Measured::RawTurns => {
                    black_box(raw_turns(ids));
                    None
                }
                Measured::FoldedTurns => {
                    black_box(folded_turns(ids));
                    None
                }
                Measured::RawPoses => {
                    black_box(raw_poses(poses));
                    None
                }
                Measured::Turns => Some(turns("four_bar_turn", ids)),
                Measured::DeclaredTurns => Some(turns("declared_turn", ids)),
                Measured::WholeTurns => Some(whole_turns(ids)),
                Measured::Poses => Some(single_poses(poses)),
                Measured::Candidates => Some(only_candidates(poses)),
            };
            if let Some(query) = query {
                black_box(session.sql(&query).await?.collect().await?);
            }
            times.push(spent().max(1e-9));
        }
    }
    let [
        raw_turns,
        folded,
        turns,
        declared_turns,
        whole_turns,
        raw_poses,
        poses_in_sql,
        candidates,
    ] = times.map(median);

    println!(
        "one core, {:?} vectors, {ids} turns of {ANGLES} poses, {poses} single poses, medians of {rounds} by processor \
         time",
        Vectors::widest()
    );
    let line = |name: &str, count: u32, poses: f64, time: f64, raw: f64| {
        let count = f64::from(count);
        println!(
            "{name:34} {:12.0} candidates/s {:14.0} poses/s {:7.2} ns/pose  {:5.2} of the raw batch",
            count / time,
            count * poses / time,
            1e9 * time / (count * poses),
            raw / time
        );
    };
    line("turns, raw batch into slices", ids, 360.0, raw_turns, raw_turns);
    line("turns, folded without SQL", ids, 360.0, folded, raw_turns);
    line("turns, four_bar_turn in SQL", ids, 360.0, turns, raw_turns);
    line("the same, declared by a text", ids, 360.0, declared_turns, raw_turns);
    line("compiled, with all 26 fields", ids, 360.0, whole_turns, raw_turns);
    line("single poses, raw batch", poses, 1.0, raw_poses, raw_poses);
    line("single poses, four_bar in SQL", poses, 1.0, poses_in_sql, raw_poses);
    let each = |time: f64, count: u32| 1e9 * time / f64::from(count);
    println!(
        "price of SQL: {:.0} ns a turn, {:.1} ns a pose; candidates alone take {:.2} ns a row",
        each(turns - folded, ids),
        each(poses_in_sql - raw_poses, poses),
        each(candidates, poses)
    );
    println!(
        "a mechanism that is declared by a text has {:.2} of the rate of a compiled one in turns",
        turns / declared_turns
    );
    println!(
        "time to a first answer, with the session: {:.1} ms",
        first.as_secs_f64() * 1e3
    );
    #[cfg(feature = "cluster")]
    on_executors(ids, functions).await?;
    Ok(())
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// The same on executors, and what 10¹² candidates would take.
#[cfg(feature = "cluster")]
async fn on_executors(ids: u32, functions: &Functions) -> Result<(), Fault> {
    const CANDIDATES: f64 = 1e12;
    const CORES: f64 = 64.0;
    println!();
    let scaling = super::scaling::ScalingArguments {
        ids: 4 * u64::from(ids),
        executors: 2,
    };
    let Some(cost) = scaling.measure(functions).await? else {
        println!("this system does not tell what processes take, so nothing is calculated from it");
        return Ok(());
    };
    let hours = CANDIDATES / cost.rate / 3600.0;
    let range = 4.0 * f64::from(ids) / cost.ranges;
    let cores = cost.ranges / cost.scheduler * range / cost.rate;
    println!(
        "\n10^12 candidates, each with a turn of {ANGLES} poses, from the last line:\n\
         {hours:.0} hours of one core, or {:.1} hours of one machine with {CORES} cores, or one hour of {:.0} such \
         machines\n{:.0} ranges, {:.1} GB over the wire, {:.1} hours of the scheduler\n\
         the scheduler keeps {cores:.0} cores at work with ranges of {range:.0} ids, and {:.0} with ranges a hundred \
         times as long",
        hours / CORES,
        (hours / CORES).ceil(),
        CANDIDATES / range,
        1e-9 * CANDIDATES / range * cost.bytes / cost.ranges,
        CANDIDATES / range * cost.scheduler / cost.ranges / 3600.0,
        100.0 * cores
    );
    Ok(())
}

fn dimension(index: usize) -> String {
    format!(
        "candidate(value, {}, 3, {:?}, {:?})",
        index + 1,
        LOW[index],
        HIGH[index]
    )
}

/// The four-bar linkage of the library, declared while the program runs.
const DECLARED: &str = "
    struct Declared { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
";

/// The least of the largest snaps over the turns of some candidates.
fn turns(function: &str, ids: u32) -> String {
    of_turns(function, "min(turn['theta4_peak_snap']) as snap", ids)
}

/// The same from turns with all of their fields, since the turns are counted as a whole.
fn whole_turns(ids: u32) -> String {
    let wanted = "min(turn['theta4_peak_snap']) as snap, count(turn) as turns";
    of_turns("four_bar_turn", wanted, ids)
}

fn of_turns(function: &str, wanted: &str, ids: u32) -> String {
    format!(
        "select {wanted} from (select {function}(1, {}, {}, {}) as turn from range(0, {ids})) \
         where turn['rotates']",
        dimension(0),
        dimension(1),
        dimension(2)
    )
}

/// The least of the snaps of single poses.
fn single_poses(ids: u32) -> String {
    format!(
        "select min(pose['theta4_snap']) as snap from (select four_bar(1, {}, {}, {}, candidate(value, 4, 4, 0, 6.2), \
         1, 0, 0, 0) as pose from range(0, {ids}))",
        dimension(0),
        dimension(1),
        dimension(2)
    )
}

fn only_candidates(ids: u32) -> String {
    format!(
        "select min({} + {} + {}) as least from range(0, {ids})",
        dimension(0),
        dimension(1),
        dimension(2)
    )
}

fn linkage(sequence: &Sequence, id: u64) -> FourBar {
    let at = |index: usize| LOW[index] + sequence.coordinate(id, index) * (HIGH[index] - LOW[index]);
    FourBar {
        r1: 1.0,
        r2: at(0),
        r3: at(1),
        r4: at(2),
    }
}

fn three() -> Sequence {
    Sequence::new(3).unwrap_or_else(|| unreachable!("three dimensions are allowed"))
}

/// The same candidates by a batch: every number of every pose is stored.
fn raw_turns(ids: u32) -> f64 {
    let sequence = three();
    let turn = InputGrid::revolution(0, ANGLES);
    let angles: Vec<f64> = (0..ANGLES).map(|pose| turn.value(pose)).collect();
    let mut poses = FourBarBatch::filled(|| vec![0.0; ANGLES]);
    let mut outcomes = vec![Outcome::Unsolved; ANGLES];
    let mut motion = [Column::Same(0.0); 5];
    (motion[0], motion[1]) = (Column::Each(&angles), Column::Same(1.0));
    let mut least = f64::INFINITY;
    for id in 0..u64::from(ids) {
        let done = linkage(&sequence, id)
            .batch(Motion::from(motion), Assembly::Open)
            .solve(&mut poses, &mut outcomes);
        least = least.min(poses.theta4[4][0]);
        black_box(&poses);
        if done.is_err() {
            return f64::NAN;
        }
    }
    least
}

/// The same candidates by folds, as the function of SQL solves them for one field.
fn folded_turns(ids: u32) -> f64 {
    let sequence = three();
    let snap = FoldedNumber::At(Slot::Unknown(1, 4));
    let mut folds = [Fold::of(snap)];
    let mut least = f64::INFINITY;
    let motion = Motion::at_constant_speed(0.0, 1.0).map(Column::Same);
    for id in 0..u64::from(ids) {
        let parameters = linkage(&sequence, id).parameters().map(Column::Same);
        let turn = InputGrid::revolution(0, ANGLES);
        let done = Batch::<FourBar, _>::new(parameters, [motion], Assembly::Open).fold(turn, &mut folds);
        if done.is_ok() {
            least = folds[0].folded().peak().map_or(least, |peak| least.min(peak.1));
        }
    }
    least
}

/// Single poses by batches, with columns that are made on the way.
fn raw_poses(ids: u32) -> f64 {
    let (sequence, angle) = (three(), Sequence::new(4));
    let mut columns = [const { Vec::new() }; 4];
    let mut poses = FourBarBatch::filled(|| vec![0.0; ROWS]);
    let mut outcomes = vec![Outcome::Unsolved; ROWS];
    let mut least = f64::INFINITY;
    let mut first = 0;
    while first + ROWS as u64 <= u64::from(ids) {
        for (index, column) in columns.iter_mut().enumerate() {
            column.clear();
            column.extend((first..first + ROWS as u64).map(|id| match (index, angle) {
                (3, Some(angle)) => 6.2 * angle.coordinate(id, 3),
                _ => LOW[index] + sequence.coordinate(id, index) * (HIGH[index] - LOW[index]),
            }));
        }
        let [r2, r3, r4, theta2] = &columns;
        let mut motion = [Column::Same(0.0); 5];
        (motion[0], motion[1]) = (Column::Each(theta2), Column::Same(1.0));
        let done = Batch::<FourBar, _>::new(
            [Column::Same(1.0), Column::Each(r2), Column::Each(r3), Column::Each(r4)],
            [Motion::from(motion)],
            Assembly::Open,
        )
        .solve(&mut poses, &mut outcomes);
        if done.is_err() {
            return f64::NAN;
        }
        least = poses.theta4[4].iter().copied().fold(least, f64::min);
        first += ROWS as u64;
    }
    least
}
