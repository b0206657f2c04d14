//! Searches on a cluster: real processes on this machine, each executor with one core.
#![cfg(feature = "cluster")]

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use datafusion::arrow::datatypes::DataType;
use datafusion::logical_expr::{ColumnarValue, Volatility, create_udf};
use kin_search::Functions;
use kin_search::cluster::{Endpoint, Executor};

/// How long a line may take. It is long enough for a machine that does many other things.
const LIMIT: Duration = Duration::from_mins(2);

/// A process that ends with the test, whether the test passes or not.
struct Process {
    child: Child,
    lines: Receiver<String>,
    seen: Vec<String>,
}

impl Process {
    fn start(command: &mut Command) -> Self {
        let mut child = command
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let (sender, lines) = channel();
        let streams: [Option<Box<dyn Read + Send>>; 2] = [
            child.stdout.take().map(|stream| Box::new(stream) as _),
            child.stderr.take().map(|stream| Box::new(stream) as _),
        ];
        for stream in streams.into_iter().flatten() {
            let sender = sender.clone();
            std::thread::spawn(move || {
                for line in BufReader::new(stream).lines().map_while(Result::ok) {
                    // Nobody listens after the test.
                    let _ = sender.send(line);
                }
            });
        }
        Self {
            child,
            lines,
            seen: Vec::new(),
        }
    }

    fn program(arguments: &[&str]) -> Self {
        Self::start(Command::new(env!("CARGO_BIN_EXE_kin-search")).args(arguments))
    }

    /// Waits for a line that contains a text, and gives the rest of the line.
    fn wait_for(&mut self, text: &str) -> String {
        let until = Instant::now() + LIMIT;
        while let Ok(line) = self.lines.recv_timeout(until.saturating_duration_since(Instant::now())) {
            self.seen.push(line);
            let line = &self.seen[self.seen.len() - 1];
            if let Some(at) = line.find(text) {
                return line[at + text.len()..].to_owned();
            }
        }
        panic!("no line with {text:?}, but:\n{}", self.seen.join("\n"));
    }

    /// Waits for the end, and gives all lines.
    fn end(mut self) -> (ExitStatus, String) {
        // Both streams are closed at the end.
        while let Ok(line) = self.lines.recv_timeout(LIMIT) {
            self.seen.push(line);
        }
        let until = Instant::now() + LIMIT;
        let status = loop {
            match self.child.try_wait().expect("the process can be waited for") {
                Some(status) => break status,
                None if Instant::now() < until => std::thread::sleep(Duration::from_millis(20)),
                None => panic!("the process does not end, after:\n{}", self.seen.join("\n")),
            }
        };
        (status, self.seen.join("\n"))
    }

    fn signal(&self, signal: &str) {
        let sent = Command::new("kill")
            .args([&format!("-{signal}"), &self.child.id().to_string()])
            .status();
        assert!(sent.expect("kill is a program").success());
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A folder that ends with the test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cluster-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("the folder can be made");
        Self(folder)
    }

    fn file(&self, name: &str, text: &str) -> String {
        let path = self.0.join(name);
        fs::write(&path, text).expect("the file can be written");
        path.display().to_string()
    }

    fn path(&self, name: &str) -> String {
        self.0.join(name).display().to_string()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn scheduler(arguments: &[&str]) -> (Process, String) {
    let mut scheduler = Process::program(&[&["scheduler"], arguments].concat());
    let address = scheduler.wait_for("listening on ");
    (scheduler, address)
}

fn executor(scheduler: &str) -> Process {
    executor_with(scheduler, &[]).0
}

/// An executor with more arguments, and the address on which it listens.
fn executor_with(scheduler: &str, arguments: &[&str]) -> (Process, String) {
    let first = ["executor", "--scheduler", scheduler, "--cores", "1"];
    let mut executor = Process::program(&[&first, arguments].concat());
    let address = executor.wait_for("listening on ");
    (executor, address)
}

/// Poses of four-bars whose dimensions follow from an id by residues. Most of them close.
fn poses(ids: u64) -> String {
    format!(
        "(select value as id, four_bar(1.0, 0.1 + 0.4 * (value % 1009) / 1009.0, 0.7 + 0.7 * (value % 997) / 997.0,
            0.6 + 0.8 * (value % 991) / 991.0, 1.134, -10.0)['theta4_velocity'] as velocity from range(0, {ids}))"
    )
}

/// The fastest rockers, by value and then by id.
fn fastest(ids: u64) -> String {
    format!(
        "set kin.vectors = 'compiled';
         select id, velocity from {} where velocity is not null order by velocity desc, id limit 5;",
        poses(ids)
    )
}

/// The table in the output of a query: its lines that begin with a bar.
fn table(output: &str) -> Vec<&str> {
    output.lines().filter(|line| line.starts_with('|')).collect()
}

fn answer(arguments: &[&str]) -> String {
    let (status, output) = Process::program(&[&["query"], arguments].concat()).end();
    assert!(status.success(), "{output}");
    output
}

#[test]
fn the_cluster_answers_as_one_process() {
    let folder = Folder::new("same");
    let query = folder.file("fastest.sql", &fastest(200_000));
    let (mut scheduler, address) = scheduler(&[]);
    let executors = [executor(&address), executor(&address)];
    scheduler.wait_for("joined");
    scheduler.wait_for("joined");

    let here = answer(&[&query]);
    let there = answer(&[&query, "--cluster", &address, "--range", "50000"]);
    assert!(table(&here).len() >= 6, "{here}");
    assert_eq!(table(&here), table(&there));
    assert!(there.contains("range 4 of 4: finished"), "{there}");
    assert!(there.contains("200000 of 200000 ids"), "{there}");

    // Sums are added in another order on several processes: each of the 200 000 terms is below 100, and rounds once.
    let sum = folder.file(
        "sum.sql",
        &format!(
            "select count(velocity) as rows, sum(velocity) as sum from {};",
            poses(200_000)
        ),
    );
    let numbers = |output: &str| -> (u64, f64) {
        let row = table(output)[1].split('|').map(str::trim).collect::<Vec<_>>();
        (row[1].parse().expect("a count"), row[2].parse().expect("a sum"))
    };
    let (here, there) = (answer(&[&sum]), answer(&[&sum, "--cluster", &address]));
    let ((rows_here, here), (rows_there, there)) = (numbers(&here), numbers(&there));
    assert_eq!(rows_here, rows_there);
    assert!(rows_here > 100_000);
    assert!((here - there).abs() <= 1e-12 * here.abs(), "{here} and {there}");

    for process in executors.into_iter().chain([scheduler]) {
        process.signal("TERM");
        let (status, output) = process.end();
        assert!(status.success(), "{output}");
    }
}

#[test]
fn a_killed_executor_changes_nothing() {
    let folder = Folder::new("killed");
    let query = folder.file("fastest.sql", &fastest(400_000));
    let (_scheduler, address) = scheduler(&["--patience", "5"]);
    let (_one, other) = (executor(&address), executor(&address));

    let mut there = Process::program(&["query", &query, "--cluster", &address, "--range", "50000"]);
    there.wait_for("range 1 of 8: finished");
    other.signal("KILL");
    let (status, output) = there.end();
    assert!(status.success(), "{output}");
    assert_eq!(table(&answer(&[&query])), table(&output));
}

/// A wiper whose blade is so many levers long.
fn wiper(levers: u32) -> String {
    format!(
        "kin 1
struct Wiper {{ crank: Length, rod: Length, lever: Length, frame: Length }}
input theta: Angle;
unknown phi: Angle, psi: Angle;
crank * cis(theta) + rod * cis(phi) == frame + lever * cis(psi);
output tip: Point = frame + {levers} * lever * cis(psi);
"
    )
}

/// Neither scheduler nor executors know the mechanism: its declaration goes with the query.
#[test]
fn a_declaration_goes_with_the_query() {
    let folder = Folder::new("declaration");
    let query = folder.file(
        "wipers.sql",
        "set kin.vectors = 'compiled';
         select id, turn['psi_swing'] as swing, turn['tip_y_greatest'] as top
         from (select value as id, wiper_turn(1 + 0.001 * (value % 997), 8 + 0.001 * (value % 1009), 5, 10) as turn
               from range(0, 2000))
         where turn['rotates'] order by swing desc, id limit 5;
         select sum(wiper(1, 9 + 0.001 * value, 5, 10, 0.7)['tip_x']) > 0 as is_there from range(0, 2000);",
    );
    let (_scheduler, address) = scheduler(&[]);
    let _executors = [executor(&address), executor(&address)];
    let mut answers = Vec::new();
    // the same name stands for another mechanism in the next query
    for levers in [2, 3, 2] {
        let file = folder.file("wiper.kin", &wiper(levers));
        let here = answer(&[&query, "--mechanism", &file]);
        let there = answer(&[&query, "--mechanism", &file, "--cluster", &address, "--range", "500"]);
        assert!(table(&here).len() >= 8, "{here}");
        assert!(there.contains("range 4 of 4: finished"), "{there}");
        assert_eq!(table(&here), table(&there));
        answers.push(table(&here).concat());
    }
    assert_ne!(answers[0], answers[1]);
    assert_eq!(answers[0], answers[2]);

    // ranges that were kept for one mechanism are not those of another
    let parts = folder.path("parts");
    let kept = |levers: u32| {
        let file = folder.file("wiper.kin", &wiper(levers));
        let search = [&query, "--mechanism", &file, "--cluster", &address, "--parts", &parts];
        Process::program(&[&["query"], search.as_slice()].concat()).end()
    };
    let (status, output) = kept(2);
    assert!(status.success(), "{output}");
    let (status, output) = kept(2);
    assert!(status.success() && output.contains("were finished before"), "{output}");
    let (_, output) = kept(3);
    assert!(!output.contains("were finished before"), "{output}");
}

/// The search of the book for a straight line, in which each round begins with the rows of the one before. One of two
/// executors is killed while a round is searched.
fn straight_line(sql: &str) {
    let folder = Folder::new("straight");
    let query = folder.file("straight_line.sql", sql);
    let (_scheduler, address) = scheduler(&["--patience", "5"]);
    let (_one, other) = (executor(&address), executor(&address));
    let mut there = Process::program(&["query", &query, "--cluster", &address]);
    for _ in 0..3 {
        there.wait_for("ids in one query");
    }
    other.signal("KILL");
    let (status, output) = there.end();
    assert!(status.success(), "{output}");
    assert!(table(&output).len() >= 6, "{output}");
    assert_eq!(table(&answer(&[&query])), table(&output));
}

const STRAIGHT_LINE: &str = include_str!("../examples/straight_line.sql");

#[test]
fn rounds_go_on_where_an_executor_is_killed() {
    let part = STRAIGHT_LINE
        .replace("range(0, 200000)", "range(0, 4000)")
        .replace("range(0, 20000)", "range(0, 500)")
        .replace("limit 20", "limit 10")
        .replace("'open', 61,", "'open', 25,");
    assert_eq!(part.matches("range(0, 500)").count(), 8);
    straight_line(&part);
}

#[test]
#[ignore = "takes an hour without optimisation, and a minute with it"]
fn all_rounds_go_on_where_an_executor_is_killed() {
    straight_line(STRAIGHT_LINE);
}

/// Rounds that take a moment each, so that the executor is killed in the middle of a stage, between two, or between two
/// queries.
#[test]
fn rounds_go_on_whenever_an_executor_is_killed() {
    let folder = Folder::new("whenever");
    let rounds: Vec<String> = (1..=6)
        .map(|round| {
            format!(
                "create table round_{round} as select id, d from (
                    select ids.value + 10000 * best.id as id, candidate(ids.value, 1, 6, near - 1, near + 1) as d
                    from (select row_number() over (order by d, id) as id, d as near from round_{}) as best
                    cross join range(0, 2000) as ids)
                where d > 0.001 order by d, id limit 20;\n",
                round - 1
            )
        })
        .collect();
    let query = folder.file(
        "rounds.sql",
        &format!(
            "create table round_0 as select 0 as id, 0.5e0 as d;\n{}select * from round_6 order by d, id;",
            rounds.concat()
        ),
    );
    let here = answer(&[&query]);
    for milliseconds in [100, 350, 600, 850] {
        let (_scheduler, address) = scheduler(&["--patience", "3"]);
        let (killed, _stays) = (executor(&address), executor(&address));
        let mut search = Process::program(&["query", &query, "--cluster", &address]);
        search.wait_for("query: finished");
        std::thread::sleep(Duration::from_millis(milliseconds));
        killed.signal("KILL");
        let (status, output) = search.end();
        assert!(status.success(), "killed after {milliseconds} ms: {output}");
        assert_eq!(table(&here), table(&output));
    }
}

#[test]
fn a_search_goes_on_with_a_scheduler_that_was_restarted() {
    let folder = Folder::new("restarted");
    let query = folder.file("fastest.sql", &fastest(400_000));
    let parts = folder.path("parts");
    let (first, address) = scheduler(&[]);
    let mut executor = executor(&address);

    let search = [
        "query",
        &query,
        "--cluster",
        &address,
        "--range",
        "50000",
        "--parts",
        &parts,
    ];
    let mut interrupted = Process::program(&search);
    interrupted.wait_for("range 2 of 8: finished");
    first.signal("KILL");
    let (status, output) = interrupted.end();
    assert!(!status.success(), "{output}");
    assert!(
        output.contains(&format!("the scheduler at {address} does not answer")),
        "{output}"
    );
    assert!(output.contains("the same command goes on from there"), "{output}");

    drop(first);
    let (mut second, _) = scheduler(&["--listen", &address]);
    // The executor comes back by itself, with its next heartbeat or after it has given up the first scheduler.
    second.wait_for("joined");
    let (status, output) = Process::program(&search).end();
    assert!(status.success(), "{output}");
    let before = output
        .lines()
        .find_map(|line| line.split_once(" of 8 ranges were finished before"))
        .and_then(|(before, _)| before.parse::<usize>().ok());
    assert!(before.is_some_and(|before| before >= 1), "{output}");
    assert_eq!(before, Some(8 - output.matches(" of 8: finished").count()), "{output}");
    assert_eq!(table(&answer(&[&query])), table(&output));
    assert!(executor.child.try_wait().expect("the process can be asked").is_none());
}

#[test]
fn an_interrupted_query_leaves_no_work() {
    let folder = Folder::new("interrupted");
    // It would take hours.
    let long = folder.file("long.sql", &fastest(10_000_000_000));
    let short = folder.file("short.sql", &fastest(20_000));
    let (mut scheduler, address) = scheduler(&[]);
    let _executor = executor(&address);
    scheduler.wait_for("joined");

    let mut interrupted = Process::program(&["query", &long, "--cluster", &address, "--range", "20000"]);
    interrupted.wait_for("finished");
    interrupted.signal("INT");
    let (status, output) = interrupted.end();
    assert!(!status.success(), "{output}");
    assert!(output.contains("interrupted"), "{output}");
    // The only core is free.
    let output = answer(&[&short, "--cluster", &address]);
    assert_eq!(table(&answer(&[&short])), table(&output));
}

/// The processor time of a process, in hundredths of a second.
#[cfg(target_os = "linux")]
fn ticks(process: &Process) -> u64 {
    let stat = fs::read_to_string(format!("/proc/{}/stat", process.child.id())).expect("the process is there");
    let (_, fields) = stat.rsplit_once(')').expect("a name in parentheses");
    let ticks = fields.split_whitespace().skip(11).take(2);
    ticks.map(|ticks| ticks.parse::<u64>().expect("a number")).sum()
}

/// A query whose first stage takes minutes, and a search whose first range does. Neither has reported anything to the
/// client when it is interrupted.
#[cfg(target_os = "linux")]
#[test]
fn interrupt_before_the_first_stage_is_finished() {
    let folder = Folder::new("idle");
    let (mut scheduler, address) = scheduler(&[]);
    let executor = executor(&address);
    scheduler.wait_for("joined");
    for (name, select, signal) in [
        (
            "groups.sql",
            "select value % 7 as k, count(*) as n from range(0, 500000000) group by 1",
            "INT",
        ),
        (
            "range.sql",
            "select value from range(0, 500000000) where value % 1000000007 = 1",
            "TERM",
        ),
    ] {
        let query = folder.file(name, select);
        let mut interrupted = Process::program(&["query", &query, "--cluster", &address, "--range", "500000000"]);
        interrupted.wait_for("searching");
        let before = ticks(&executor);
        while ticks(&executor) < before + 50 {
            std::thread::sleep(Duration::from_millis(20));
        }
        let since = Instant::now();
        interrupted.signal(signal);
        let (status, output) = interrupted.end();
        assert_eq!(status.code(), Some(130), "{output}");
        assert!(output.contains("interrupted"), "{output}");
        // It would not have heard of its job's number for minutes, and would have given up after five seconds.
        let waited = since.elapsed();
        assert!(waited < Duration::from_secs(4), "{waited:?}: {output}");
        // The executor is idle when it takes no time for a second.
        let until = Instant::now() + Duration::from_secs(30);
        loop {
            let before = ticks(&executor);
            std::thread::sleep(Duration::from_secs(1));
            if ticks(&executor) < before + 10 {
                break;
            }
            assert!(Instant::now() < until, "{name}: the executor works on");
        }
    }
}

#[test]
fn poses_and_outcomes_come_back() {
    let folder = Folder::new("outcomes");
    let pose = "four_bar(1, 0.1 + 0.02 * (value % 100), 1.2, 1.1, 0.01 * value, 'open', 2)";
    let query = folder.file(
        "poses.sql",
        &format!(
            "set kin.vectors = 'compiled';
             select value, {pose} as pose from range(0, 300) order by value;
             select pose['outcome'] as outcome, count(*) as n, min(value) as first
             from (select value, {pose} as pose from range(0, 20000)) group by 1 order by 1;
             create table kept as select value, pose['outcome'] as outcome
                from (select value, {pose} as pose from range(0, 300));
             select outcome, count(*) as n from kept group by 1 order by 1;"
        ),
    );
    let (_scheduler, address) = scheduler(&[]);
    let _executors = [executor(&address), executor(&address)];
    let here = answer(&[&query]);
    let there = answer(&[&query, "--cluster", &address, "--range", "100"]);
    assert!(here.contains("solved") && here.contains("out_of_reach"), "{here}");
    assert!(table(&here).len() > 300, "{here}");
    assert_eq!(table(&here), table(&there));
}

#[test]
fn more_ids_than_can_be_listed_are_refused() {
    let folder = Folder::new("many");
    let search = folder.file(
        "search.sql",
        "select value from range(0, 9223372036854775806) where value < 0",
    );
    let sum = folder.file(
        "sum.sql",
        "select count(*) from range(0, 9223372036854775806) where value % 2 = 0",
    );
    let both = folder.file(
        "both.sql",
        "select count(*) from range(-9, 9223372036854775797) a, range(0, 9223372036854775806) b where \
         a.value = b.value",
    );
    let (_scheduler, address) = scheduler(&[]);
    let _executor = executor(&address);
    for (query, range, messages) in [
        (
            &search,
            "1000000",
            ["9223372036855 ranges of 1000000", "1000000 ranges at most"],
        ),
        (
            &search,
            "9000000000000000000",
            ["68719476736 ids at most", "9000000000000000000"],
        ),
        (&sum, "1000000", ["68719476736 ids at most", "9223372036854775806"]),
        (&both, "1000000", ["68719476736 ids at most", "9223372036854775806"]),
    ] {
        let arguments = ["query", query, "--cluster", &address, "--range", range];
        let (status, output) = Process::program(&arguments).end();
        assert_eq!(status.code(), Some(1), "{output}");
        assert!(messages.iter().all(|message| output.contains(message)), "{output}");
    }
    // The scheduler and the executor are still there.
    let short = folder.file("short.sql", &fastest(2000));
    assert_eq!(
        table(&answer(&[&short])),
        table(&answer(&[&short, "--cluster", &address]))
    );
}

#[test]
fn query_beyond_the_memory_of_an_executor() {
    let folder = Folder::new("memory");
    let query = folder.file(
        "large.sql",
        "select array_length(array_agg(value)) as n from range(0, 2000000)",
    );
    let short = folder.file("short.sql", &fastest(20_000));
    let (_scheduler, address) = scheduler(&[]);
    let (mut executor, _) = executor_with(&address, &["--memory", "10MB"]);
    let (status, output) = Process::program(&["query", &query, "--cluster", &address]).end();
    assert_eq!(status.code(), Some(1), "{output}");
    assert!(
        output.contains("an executor has too little memory") && output.contains("pool_size"),
        "{output}"
    );
    assert_eq!(
        table(&answer(&[&short])),
        table(&answer(&[&short, "--cluster", &address]))
    );
    assert!(executor.child.try_wait().expect("the process can be asked").is_none());
}

#[test]
fn a_query_that_loses_a_second_executor_fails() {
    let folder = Folder::new("second");
    let query = folder.file(
        "groups.sql",
        "select value % 7 as k, count(*) as n from range(0, 2000000000) group by 1",
    );
    let (mut scheduler, address) = scheduler(&["--patience", "2"]);
    let (one, two, mut three) = (executor(&address), executor(&address), executor(&address));
    for _ in 0..3 {
        scheduler.wait_for("joined");
    }
    let mut search = Process::program(&["query", &query, "--cluster", &address]);
    search.wait_for("searching");
    std::thread::sleep(Duration::from_secs(1));
    one.signal("KILL");
    search.wait_for("it is searched again");
    std::thread::sleep(Duration::from_secs(1));
    two.signal("KILL");
    let (status, output) = search.end();
    assert_eq!(status.code(), Some(1), "{output}");
    assert!(output.contains("2 executors were lost"), "{output}");
    assert!(three.child.try_wait().expect("the process can be asked").is_none());
}

#[test]
fn what_is_no_scheduler_is_named() {
    let folder = Folder::new("another");
    let query = folder.file("fastest.sql", &fastest(2000));
    let (_scheduler, address) = scheduler(&[]);
    let (_executor, results) = executor_with(&address, &[]);
    let (status, output) = Process::program(&["query", &query, "--cluster", &results]).end();
    assert_eq!(status.code(), Some(1), "{output}");
    assert!(
        output.contains(&format!("what listens at {results} is no scheduler")),
        "{output}"
    );
}

#[test]
fn another_list_of_functions_is_refused() {
    let (mut scheduler, address) = scheduler(&[]);
    let mut other = Command::new(std::env::current_exe().expect("a test has a file"));
    other
        .args(["--exact", "executor_of_another_list", "--ignored", "--nocapture"])
        .env("KIN_TEST_SCHEDULER", &address);
    let refused = Process::start(&mut other);
    scheduler.wait_for("refused");
    let (_, output) = refused.end();
    let (here, there) = (other_functions().fingerprint(), Functions::library().fingerprint());
    assert!(output.contains("the scheduler refuses this process"), "{output}");
    assert!(output.contains(&here) && output.contains(&there), "{output}");
    assert!(output.contains(" seven "), "{output}");
}

/// The library's functions, and one more.
fn other_functions() -> Functions {
    let seven = create_udf(
        "seven",
        vec![DataType::Float64],
        DataType::Float64,
        Volatility::Immutable,
        std::sync::Arc::new(|_| Ok(ColumnarValue::Scalar(7.0.into()))),
    );
    Functions::library().with_function(seven)
}

/// A process of the test above. An executor that is refused ends, and says why.
#[test]
#[ignore = "a process of another test"]
fn executor_of_another_list() {
    let Ok(address) = std::env::var("KIN_TEST_SCHEDULER") else {
        return;
    };
    let (host, port) = address.rsplit_once(':').expect("a host and a port");
    let executor = Executor {
        scheduler: Endpoint {
            host: host.to_owned(),
            port: port.parse().expect("a port"),
        },
        listen: kin_search::cluster::Listen::default(),
        cores: 1,
        memory: None,
        folder: None,
    };
    let runtime = tokio::runtime::Runtime::new().expect("a runtime");
    let fault = runtime
        .block_on(executor.run(&other_functions()))
        .expect_err("it is refused");
    println!("{fault}");
}

#[test]
fn processes_start_in_any_order() {
    let folder = Folder::new("order");
    let query = folder.file("fastest.sql", &fastest(20_000));
    let free = std::net::TcpListener::bind("127.0.0.1:0").and_then(|listener| listener.local_addr());
    let address = free.expect("a free port").to_string();
    let mut client = Process::program(&["query", &query, "--cluster", &address]);
    client.wait_for("waiting for the scheduler");
    let mut executor = Process::program(&["executor", "--scheduler", &address, "--cores", "1"]);
    executor.wait_for("waiting for the scheduler");
    let (_scheduler, listening) = scheduler(&["--listen", &address]);
    assert_eq!(listening, address);
    let (status, output) = client.end();
    assert!(status.success(), "{output}");
    assert_eq!(table(&answer(&[&query])), table(&output));
}

#[test]
fn an_executor_whose_port_is_taken_ends() {
    let (_scheduler, address) = scheduler(&[]);
    let taken = std::net::TcpListener::bind("127.0.0.1:0").expect("a free port");
    let listen = taken.local_addr().expect("it listens").to_string();
    let (status, output) = Process::program(&["executor", "--scheduler", &address, "--listen", &listen]).end();
    assert!(!status.success(), "{output}");
    assert!(output.contains(&format!("cannot listen on {listen}")), "{output}");
}

#[test]
fn a_failed_range_ends_the_search() {
    let folder = Folder::new("failed");
    // The second range has a candidate with no dimension 0.
    let query = folder.file(
        "wrong.sql",
        "select value, case when value < 25000 then 0.0 else candidate(value, 1, 1, value - value, -1e0 / 0) end as r2 \
         from range(0, 1000000) order by r2, value limit 3",
    );
    let (mut scheduler, address) = scheduler(&[]);
    let _executor = executor(&address);
    scheduler.wait_for("joined");
    let (status, output) = Process::program(&["query", &query, "--cluster", &address, "--range", "20000"]).end();
    assert!(!status.success(), "{output}");
    assert!(output.contains("must be finite"), "{output}");
    // The executor has no work left.
    let short = folder.file("short.sql", &fastest(20_000));
    assert_eq!(
        table(&answer(&[&short])),
        table(&answer(&[&short, "--cluster", &address]))
    );
}

#[test]
fn rows_are_inserted_into_a_table_of_the_client() {
    let folder = Folder::new("insert");
    let query = folder.file(
        "insert.sql",
        "create table found (id bigint); insert into found select value from range(0, 5000) where value % 1000 = 7; \
         select count(*) as rows, max(id) as last from found;",
    );
    let (_scheduler, address) = scheduler(&[]);
    let _executor = executor(&address);
    assert_eq!(
        table(&answer(&[&query])),
        table(&answer(&[&query, "--cluster", &address]))
    );
}

#[test]
fn an_address_that_others_reach_is_warned_of() {
    let mut reachable = Process::program(&["scheduler", "--listen", "0.0.0.0"]);
    let warning = reachable.wait_for("warning: 0.0.0.0 can be reached from other machines");
    assert!(warning.contains("reads and writes files as the user"), "{warning}");
    // Executors could not call it back.
    reachable.wait_for("give one with --host");
}
