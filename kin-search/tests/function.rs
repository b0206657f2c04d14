//! The functions of SQL give what the solvers give.

use std::f64::consts::TAU;

use datafusion::arrow::array::{Array, AsArray, RecordBatch};
use datafusion::arrow::datatypes::Float64Type;
use datafusion::prelude::SessionContext;
use kin_core::library::{FiveBar, FourBar, HoekenLinkage, JansenLeg, OffsetSliderCrank, WattI};
use kin_core::prelude::*;
use kin_search::session::{plan, statements};
use kin_search::{Functions, Options, session};

fn new() -> SessionContext {
    session(&Functions::library(), &Options::default()).unwrap()
}

async fn ask(session: &SessionContext, sql: &str) -> Result<RecordBatch, String> {
    let mut last = None;
    for statement in statements(sql).map_err(|error| error.to_string())? {
        let plan = plan(session, statement).await.map_err(|error| error.to_string())?;
        let frame = session
            .execute_logical_plan(plan)
            .await
            .map_err(|error| error.to_string())?;
        let schema = frame.schema().as_arrow().clone();
        let rows = frame.collect().await.map_err(|error| error.to_string())?;
        let schema = rows.first().map_or_else(|| schema.into(), RecordBatch::schema);
        last = Some(datafusion::arrow::compute::concat_batches(&schema, &rows).unwrap());
    }
    Ok(last.unwrap())
}

/// The numbers of a column; `None` where it is null.
fn numbers(rows: &RecordBatch, column: usize) -> Vec<Option<f64>> {
    rows.column(column).as_primitive::<Float64Type>().iter().collect()
}

async fn one(sql: &str) -> f64 {
    numbers(&ask(&new(), sql).await.unwrap(), 0)[0].unwrap()
}

/// Vectors round differently from single numbers. This is more than both can lose in these well-conditioned poses.
fn is_near(found: f64, wanted: f64) -> bool {
    (found - wanted).abs() <= 1e-12 * wanted.abs().max(1.0)
}

const LINKAGE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

#[tokio::test]
async fn rates_of_a_pose() {
    let rows = ask(
        &new(),
        "select p.* from (select unnest(p) from (select four_bar(90, 30, 60, 45, 1.1, -10, 2, -0.5, 0.3) as p)) p",
    )
    .await
    .unwrap();
    let pose = LINKAGE.solve([1.1, -10.0, 2.0, -0.5, 0.3], Assembly::Open).unwrap();
    for order in 0..5 {
        for (first, motion) in [(0, pose.theta3), (5, pose.theta4)] {
            let found = numbers(&rows, first + order)[0].unwrap();
            let wanted = motion.derivative(order).unwrap();
            assert!(is_near(found, wanted), "{order}: {found} {wanted}");
        }
    }
    // with less, there is less
    let message = ask(&new(), "select four_bar(90, 30, 60, 45, 1.1)['theta4_velocity']")
        .await
        .unwrap_err();
    assert!(message.contains("theta4_velocity"), "{message}");
}

#[tokio::test]
async fn named_arguments() {
    let crossed = LINKAGE
        .solve(Motion::at_constant_speed(1.1, -10.0), Assembly::Crossed)
        .unwrap()
        .theta4;
    for call in [
        "four_bar(r4 => 45, r3 => 60, r2 => 30, r1 => 90, assembly => 'crossed', theta2 => 1.1, \
         theta2_velocity => -10)",
        "four_bar(90, 30, 60, 45, 1.1, 'Crossed', -10)",
        "four_bar(90, 30, 60, 45, 1.1, -10, 'crossed')",
    ] {
        assert!(
            is_near(one(&format!("select {call}['theta4']")).await, crossed.position()),
            "{call}"
        );
        assert!(
            is_near(
                one(&format!("select {call}['theta4_velocity']")).await,
                crossed.velocity()
            ),
            "{call}"
        );
    }
    let message = ask(&new(), "select four_bar(90, 30, 60, 45, 1.1, 'left')['theta4']")
        .await
        .unwrap_err();
    assert!(message.contains("'open', 'crossed'"), "{message}");
}

#[tokio::test]
async fn column_of_assemblies() {
    let rows = ask(
        &new(),
        "select four_bar(90, 30, 60, 45, 1.1, a)['theta4'] from (values (1, 'crossed'), (2, 'open'), (3, 'crossed'), \
         (4, null)) as t(i, a) order by i",
    )
    .await
    .unwrap();
    let of = |assembly| LINKAGE.position(1.1, assembly).unwrap().theta4.position();
    let found = numbers(&rows, 0);
    for (row, assembly) in [Assembly::Crossed, Assembly::Open, Assembly::Crossed]
        .into_iter()
        .enumerate()
    {
        assert!(is_near(found[row].unwrap(), of(assembly)));
    }
    assert_eq!(found[3], None);
}

/// A loop that does not close has no numbers, but a margin.
#[tokio::test]
async fn out_of_reach() {
    let rows = ask(
        &new(),
        "select p['theta4'], p['margin'], p['outcome'] = 'out_of_reach' from \
         (select i, four_bar(1, r2, 1.5, 1.5, 2.0) as p from (values (1, 0.5), (2, 4.0), (3, null)) as t(i, r2)) \
         order by i",
    )
    .await
    .unwrap();
    let (angle, margin) = (numbers(&rows, 0), numbers(&rows, 1));
    assert!(angle[0].is_some() && margin[0].is_none());
    let alone = FourBar {
        r1: 1.0,
        r2: 4.0,
        r3: 1.5,
        r4: 1.5,
    }
    .position(2.0, Assembly::Open)
    .unwrap_err();
    let kin_core::Failure::OutOfReach { margin: missing } = alone.failure else {
        panic!("{alone}")
    };
    assert!(angle[1].is_none() && is_near(margin[1].unwrap(), missing));
    assert!(rows.column(2).as_boolean().value(1) && !rows.column(2).as_boolean().value(0));
    assert!(angle[2].is_none() && margin[2].is_none() && rows.column(2).is_null(2));
}

#[tokio::test]
async fn turn_by_poses() {
    let linkage = FourBar {
        r1: 90.0,
        r2: 30.0,
        r3: 80.0,
        r4: 60.0,
    };
    let (mut low, mut high, mut peak, mut place) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64, 0.0);
    let mut transmission = f64::INFINITY;
    for step in 0..90 {
        let angle = TAU * f64::from(step) / 90.0;
        let pose = linkage
            .solve(Motion::at_constant_speed(angle, 2.0), Assembly::Open)
            .unwrap();
        (low, high) = (low.min(pose.theta4.position()), high.max(pose.theta4.position()));
        let snap = pose.theta4.snap().abs();
        if snap > peak {
            (peak, place) = (snap, angle);
        }
        let between = (pose.theta4.position() - pose.theta3.position()).sin().abs().asin();
        transmission = transmission.min(between);
    }
    let rows = ask(
        &new(),
        "select t['closed'], t['theta4_swing'], t['theta4_peak_snap'], t['theta4_where_peak_snap'], \
         t['min_transmission'], t['rotates'] from (select four_bar_turn(90, 30, 80, 60, 'open', 90, 2) as t)",
    )
    .await
    .unwrap();
    for (column, wanted) in [1.0, high - low, peak, place, transmission].into_iter().enumerate() {
        let found = numbers(&rows, column)[0].unwrap();
        assert!(is_near(found, wanted), "{column}: {found} {wanted}");
    }
    assert!(rows.column(5).as_boolean().value(0));
}

/// It closes where the whole turn does not.
#[tokio::test]
async fn part_of_a_turn() {
    let sql = "select four_bar_turn(90, 30, 60, 45)['closed'], four_bar_turn(90, 30, 60, 45, 91, 1, -1, 1)['closed'], \
               four_bar_turn(90, null, 60, 45)['closed']";
    let rows = ask(&new(), sql).await.unwrap();
    // the crank stops at 112.024° on both sides
    let whole = numbers(&rows, 0)[0].unwrap();
    assert!((whole - 225.0 / 360.0).abs() < 1e-12, "{whole}");
    assert_eq!(numbers(&rows, 1)[0], Some(1.0));
    assert_eq!(numbers(&rows, 2)[0], None);
    let message = ask(&new(), "select four_bar_turn(90, 30, 60, 45, 0)")
        .await
        .unwrap_err();
    assert!(message.contains("poses"), "{message}");
    let message = ask(&new(), "select four_bar_turn(90, 30, 60, 45, 9, 1, 0)")
        .await
        .unwrap_err();
    assert!(message.contains("together with `to`"), "{message}");
}

/// The first of them turns, and the others stand.
#[tokio::test]
async fn several_inputs() {
    let linkage = FiveBar {
        ground: 3.0,
        left: 1.0,
        left_rod: 3.0,
        right_rod: 3.0,
        right: 1.0,
    };
    let mut high = f64::NEG_INFINITY;
    for step in 0..360 {
        let angle = TAU * f64::from(step) / 360.0;
        high = high.max(linkage.position(angle, 0.4, Assembly::Open).unwrap().hand.value().y);
    }
    let found = one("select five_bar_turn(3, 1, 3, 3, 1, beta => 0.4)['hand_y_greatest']").await;
    assert!(is_near(found, high), "{found} {high}");
}

#[tokio::test]
async fn published_line() {
    let line = "hoeken_linkage_line(2.2, 1, 2.8, 'open', 361, 1, pi() / 2, 3 * pi() / 2)";
    // R. L. Norton's table, the row of 180°: 4.181 cranks and 0.096 %
    assert!((one(&format!("select {line}['length']")).await - 4.181).abs() < 5e-4);
    assert!((one(&format!("select {line}['deviation']")).await - 0.000_96).abs() < 5e-6);
    assert!((one(&format!("select {line}['unevenness']")).await - 0.352).abs() < 5e-5);
}

#[tokio::test]
async fn line_in_a_turn() {
    let message = ask(&new(), "select hoeken_linkage_line(2.2, 1, 2.8, 'open')")
        .await
        .unwrap_err();
    assert!(message.contains("give `from` and `to`"), "{message}");
}

/// The engine has messages of its own, about types. None of them comes before these.
#[tokio::test]
async fn wrong_arguments() {
    for (call, wanted) in [
        (
            "four_bar(1, 2, 3)",
            "four_bar takes 5 to 10 arguments, and 3 are given: four_bar(r1, r2,",
        ),
        ("four_bar()", "four_bar takes 5 to 10 arguments, and 0 are given"),
        (
            "four_bar(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11)",
            "four_bar takes 5 to 10 arguments, and 11 are given",
        ),
        (
            "four_bar(1, 2, 3, 'a', 5)",
            "argument 4 of four_bar, r4, is a text instead of a number",
        ),
        (
            "four_bar(1, 2, 3, 4, true)",
            "argument 5 of four_bar, theta2, is no number but Boolean",
        ),
        (
            "four_bar(1, 2, 3, 4, 5, 'open', 'open')",
            "four_bar takes one text at most, the assembly",
        ),
        (
            "five_bar(3, 1, 3, 3, 1, 0, 0, 'open', 1)",
            "five_bar has 2 inputs, and 1 rates are given",
        ),
        (
            "four_bar_turn(1, 2, 3, 4, 360, 1, 0, 1, 5)",
            "four_bar_turn takes four numbers at most after the 4 that it needs, poses, speed, from and to, and 5 are \
             given",
        ),
        (
            "four_bar_turn(1, 2)",
            "four_bar_turn takes 4 to 9 arguments, and 2 are given",
        ),
        (
            "four_bar_turn(1, 2, 'a', 4)",
            "argument 3 of four_bar_turn, r3, is a text instead of a number",
        ),
        (
            "four_bar_turn(1, 2, 3, 4, 7.9)",
            "takes a whole number of poses from 1 to 1000000, and not 7.9",
        ),
        (
            "four_bar_turn(1, 2, 3, 4, 1.0e7)",
            "takes a whole number of poses from 1 to 1000000, and not 10000000",
        ),
        (
            "four_bar_turn(1, 2, 3, 4, 0.0 / 0.0)",
            "takes a whole number of poses from 1 to 1000000, and not NaN",
        ),
        (
            "hoeken_linkage_line()",
            "hoeken_linkage_line takes 3 to 8 arguments, and 0 are given",
        ),
        (
            "hoeken_linkage_path_error('0 1', 'a', 1, 2)",
            "argument 2 of hoeken_linkage_path_error, ground, is a text instead of a number",
        ),
        (
            "candidate(1, 2)",
            "candidate takes 5 arguments, and 2 are given: candidate(id, dimension, dimensions, low, high)",
        ),
        ("candidate_log()", "candidate_log takes 5 arguments, and 0 are given"),
        (
            "candidate(1.5, 1, 1, 0, 1)",
            "argument 1 of candidate, id, is no whole number but Float64",
        ),
        (
            "candidate(1, 1, 1, 'a', 1)",
            "argument 4 of candidate, low, is no number but Utf8",
        ),
    ] {
        for query in [
            format!("select {call}"),
            format!("select value from range(0, 3) where {call} is null"),
        ] {
            let message = ask(&new(), &query).await.unwrap_err();
            assert!(message.contains(wanted), "{query}: {message}");
        }
    }
}

#[tokio::test]
async fn all_arguments() {
    // As many arguments as there are names, with the assembly in another place than its name.
    let call = "four_bar(90, 30, 60, 45, 1.1, -10, 2, -0.5, 0.3, 'crossed')";
    let wanted = LINKAGE.solve([1.1, -10.0, 2.0, -0.5, 0.3], Assembly::Crossed).unwrap();
    for (order, name) in ["theta4", "theta4_velocity", "theta4_acceleration"].iter().enumerate() {
        let found = one(&format!("select {call}['{name}']")).await;
        assert!(
            is_near(found, wanted.theta4.derivative(order).unwrap()),
            "{name}: {found}"
        );
    }
    let texts = "select four_bar(90, 30, 60, 45, 1.1, null)['outcome'] is null";
    let rows = ask(&new(), texts).await.unwrap();
    assert!(rows.column(0).as_boolean().value(0));
}

#[tokio::test]
async fn wrong_candidates() {
    for (call, told) in [
        ("candidate(1, 0, 3, 0, 1)", "no dimension 0 of 3"),
        (
            "candidate(1, -9223372036854775808, 3, 0, 1)",
            "no dimension -9223372036854775808 of 3",
        ),
        ("candidate(1, 1, 3, -1e308, 1e308)", "must be finite"),
        ("candidate_log(1, 1, 3, 1e-200, 1e200)", "must be finite and positive"),
    ] {
        let message = ask(&new(), &format!("select {call}")).await.unwrap_err();
        assert!(message.contains(told), "{call}: {message}");
    }
}

/// A path misses its own points by rounding, and others by their distance.
#[tokio::test]
async fn path_error() {
    let linkage = HoekenLinkage::PUBLISHED;
    let session = new();
    let mut free = Vec::new();
    let mut timed = Vec::new();
    for degrees in [90, 135, 180, 260] {
        let angle = f64::from(degrees).to_radians();
        let tracer = linkage.position(angle, Assembly::Open).unwrap().tracer.value();
        free.push(format!("({:?}, {:?})", tracer.x, tracer.y));
        timed.push(format!("({angle:?}, {:?}, {:?})", tracer.x, tracer.y + 0.25));
    }
    let tables = format!(
        "create table free as select * from (values {}) as t(x, y); create table timed as select * from (values {}) \
         as t(input, x, y)",
        free.join(", "),
        timed.join(", ")
    );
    ask(&session, &tables).await.unwrap();
    let error =
        |points: &str, field: &str| format!("select hoeken_linkage_path_error('{points}', 2, 1, 2.5)['{field}']");
    let of = async |sql: String| numbers(&ask(&session, &sql).await.unwrap(), 0)[0].unwrap();
    assert!(of(error("free", "largest")).await < 1e-13);
    assert!(is_near(of(error("timed", "rms")).await, 0.25));
    // below the straight line
    let largest = of(error("2 4; 2 3.5", "largest")).await;
    assert!((0.49..0.500_001).contains(&largest), "{largest}");
    let message = ask(&session, &error("nothing", "rms")).await.unwrap_err();
    assert!(message.contains("there is no table `nothing`"), "{message}");
    let message = ask(&session, &error("0 1; 0 x", "rms")).await.unwrap_err();
    assert!(message.contains("`0 x` is no point"), "{message}");
}

/// They take values nearby, and have no turn.
#[tokio::test]
async fn coupled_mechanisms() {
    let functions = Functions::library();
    let names: Vec<&str> = functions.iter().map(|function| function.name()).collect();
    assert!(names.contains(&"watt_ii") && names.contains(&"watt_ii_turn"));
    let coupled = functions.list().into_iter().find(|line| line.contains("near_"));
    let coupled = coupled.expect("the library has coupled mechanisms");
    let name = coupled.split('(').next().unwrap();
    assert!(!names.contains(&format!("{name}_turn").as_str()), "{name}");
}

#[tokio::test]
async fn information_schema() {
    let rows = ask(
        &new(),
        "select parameter_name from information_schema.parameters where specific_name = 'four_bar' and \
         parameter_mode = 'IN' order by ordinal_position",
    )
    .await
    .unwrap();
    let names =
        datafusion::arrow::compute::cast(rows.column(0), &datafusion::arrow::datatypes::DataType::Utf8).unwrap();
    let names: Vec<&str> = names.as_string::<i32>().iter().flatten().collect();
    assert_eq!(
        names[..7],
        ["r1", "r2", "r3", "r4", "theta2", "assembly", "theta2_velocity"]
    );
    let rows = ask(
        &new(),
        "select description from information_schema.routines where routine_name = 'four_bar' and \
         description like '%rad/s^4%'",
    )
    .await
    .unwrap();
    assert_eq!(rows.num_rows(), 1);
}

mechanism! {
    /// A point on a wheel.
    struct Wheel { radius: Length }
    input theta: Angle;
    unknown height: Length;
    height == radius * sin(theta);
}

#[tokio::test]
async fn added_mechanism() {
    let session = new();
    kin_search::register::<Wheel>(&session);
    let found = numbers(
        &ask(&session, "select wheel(2, 0.5, 3)['height_velocity']")
            .await
            .unwrap(),
        0,
    )[0]
    .unwrap();
    assert!(is_near(found, 6.0 * 0.5_f64.cos()));
    let own = Functions::library().with::<Wheel>();
    assert_ne!(own.fingerprint(), Functions::library().fingerprint());
    assert_eq!(own.fingerprint(), Functions::library().with::<Wheel>().fingerprint());
}

/// They lie within their limits, and do not depend on the parts of a query.
#[tokio::test]
async fn candidates() {
    let sql = "select min(x), max(x), sum(y), min(y), max(y) from (select candidate(value, 1, 2, -3, 5) as x, \
               candidate_log(value, 2, 2, 0.01, 100) as y from range(0, 20000))";
    let rows = ask(&new(), sql).await.unwrap();
    let at = |column| numbers(&rows, column)[0].unwrap();
    assert!(-3.0 < at(0) && at(0) < -2.99 && 4.99 < at(1) && at(1) < 5.0);
    assert!(0.01 < at(3) && at(3) < 0.0101 && 99.0 < at(4) && at(4) < 100.0);
    // columns as limits give the same
    let same = "select sum(candidate_log(value, 2, 2, 0.01 + 0 * value, 100 + 0 * value)) from range(0, 20000)";
    assert!(is_near(one(same).await, at(2)));
    for wrong in [
        "candidate(1, 3, 2, 0, 1)",
        "candidate(1, 0, 2, 0, 1)",
        "candidate(1, 1, 65, 0, 1)",
        "candidate_log(1, 1, 1, -1, 1)",
    ] {
        assert!(ask(&new(), &format!("select {wrong}")).await.is_err(), "{wrong}");
    }
}

#[tokio::test]
async fn vectors_setting() {
    let sql = "set kin.vectors = 'compiled'; select four_bar(90, 30, 60, 45, 1.1)['theta4']";
    let found = numbers(&ask(&new(), sql).await.unwrap(), 0)[0].unwrap();
    assert!(is_near(
        found,
        LINKAGE.position(1.1, Assembly::Open).unwrap().theta4.position()
    ));
    let message = ask(&new(), &sql.replace("compiled", "wide")).await.unwrap_err();
    assert!(message.contains("'avx512'"), "{message}");
}

/// A query that needs more memory than it may take ends with an error.
#[tokio::test]
async fn memory_is_limited() {
    let options = Options {
        memory: Some(1_000_000),
        partitions: Some(1),
    };
    let session = session(&Functions::library(), &options).unwrap();
    let sql = "select count(*) from range(0, 3000000) a join range(0, 3000000) b on a.value = b.value";
    let message = ask(&session, sql).await.unwrap_err();
    assert!(message.contains("Resources exhausted"), "{message}");
}

/// The text of a mechanism of the library, with another name.
fn renamed(file: &str, name: &str, other: &str) -> String {
    let head = format!("pub struct {name} {{");
    let found = file.split("\ncrate::mechanism! {").find(|text| text.contains(&head));
    let text = found.unwrap().split("\n}\n").next().unwrap();
    text.replace(&head, &format!("pub struct {other} {{"))
}

/// All fields of a function in many rows.
fn rows_of(name: &str, arguments: &str) -> String {
    format!("select unnest({name}({arguments})) from range(0, 300) as ids(id)")
}

/// Declarations give the bits of compiled mechanisms.
#[tokio::test]
async fn declarations_agree() {
    let four_bar = include_str!("../../kin-core/src/library/four_bar.rs");
    let hoeken = include_str!("../../kin-core/src/library/hoeken_linkage.rs");
    let slider_crank = include_str!("../../kin-core/src/library/slider_crank.rs");
    let watt = include_str!("../../kin-core/src/library/watt_six_bars.rs");
    let jansen = include_str!("../../kin-core/src/library/jansen_leg.rs");
    let mut functions = Functions::library()
        .with::<FourBar>()
        .with::<HoekenLinkage>()
        .with::<OffsetSliderCrank>()
        .with::<WattI>()
        .with::<JansenLeg>();
    for (file, name) in [
        (four_bar, "FourBar"),
        (hoeken, "HoekenLinkage"),
        (slider_crank, "OffsetSliderCrank"),
        (watt, "WattI"),
        (jansen, "JansenLeg"),
    ] {
        functions = functions
            .with_declaration(&renamed(file, name, &format!("Own{name}")))
            .unwrap();
    }
    let session = session(&functions, &Options::default()).unwrap();
    let calls = [
        ("four_bar", "90, 30, 60 + id / 10.0, 45, 0.02 * id, -10, 2, -0.5, 0.3"),
        ("four_bar", "90, 30, 60, 45, 0.02 * id, 'crossed'"),
        ("four_bar_turn", "90, 30, 70 + id / 10.0, 60"),
        ("four_bar_turn", "90, 30, 80, 60, 'crossed', 700, 2, 0.5, 1 + 0.01 * id"),
        ("hoeken_linkage", "2, 1, 2.5, 0.02 * id, 1"),
        ("hoeken_linkage_turn", "2, 0.5 + 0.001 * id, 2.5"),
        (
            "hoeken_linkage_line",
            "2, 0.9 + 0.001 * id, 2.5, 'open', 90, 1, 2.0, 4.2",
        ),
        ("hoeken_linkage_path_error", "'0 4; 1 4; 2 4', 2, 0.9 + 0.001 * id, 2.5"),
        ("offset_slider_crank_turn", "1, 3, 0.01 * id"),
    ];
    for (name, arguments) in calls {
        let compiled = ask(&session, &rows_of(name, arguments)).await.unwrap();
        let own = ask(&session, &rows_of(&format!("own_{name}"), arguments))
            .await
            .unwrap();
        assert_eq!(compiled.num_rows(), 300);
        let mut numbers_seen = 0;
        for (compiled, own) in compiled.columns().iter().zip(own.columns()) {
            // bits, since arrays of numbers that are equal may differ in the sign of a zero
            assert_eq!(compiled.to_data(), own.to_data(), "{name}({arguments})");
            if let Some(numbers) = compiled.as_primitive_opt::<Float64Type>() {
                let own = own.as_primitive::<Float64Type>();
                let bits = |value: Option<f64>| value.map(f64::to_bits);
                assert!(numbers.iter().map(bits).eq(own.iter().map(bits)), "{name}({arguments})");
                numbers_seen += numbers.iter().flatten().count();
            }
        }
        assert!(numbers_seen > 300, "{name}({arguments})");
    }
    // every function of a mechanism is there, with the same arguments
    let of = |prefix: &str| -> Vec<String> {
        let lines = functions.list().into_iter();
        lines
            .filter_map(|line| line.strip_prefix(prefix).map(str::to_owned))
            .collect()
    };
    for name in ["four_bar", "watt_i", "jansen_leg"] {
        let own = of(&format!("own_{name}"));
        assert!(own.len() >= 2, "{name}");
        assert!(own.iter().all(|line| of(name).contains(line)), "{name}");
    }
}

const WIPER: &str = "
    struct Wiper { crank: Length, rod: Length, rocker: Length, frame: Length }
    input theta: Angle;
    unknown phi: Angle, psi: Angle;
    crank * cis(theta) + rod * cis(phi) == frame + rocker * cis(psi);
    output tip: Point = frame + 2 * rocker * cis(psi);
";

#[test]
fn names_that_are_taken() {
    let functions = Functions::library().with_declaration(WIPER).unwrap();
    for suffix in ["(", "_turn(", "_line(", "_path_error("] {
        let name = format!("wiper{suffix}");
        assert!(functions.list().iter().any(|line| line.starts_with(&name)), "{name}");
    }
    let message = |text: &str| functions.clone().with_declaration(text).unwrap_err().to_string();
    for (name, told) in [
        (
            "Wiper",
            "the mechanism `Wiper` would have the function `wiper`, which another declaration has already",
        ),
        (
            "FourBar",
            "would have the function `four_bar`, which the library has already",
        ),
        (
            "FourBarTurn",
            "would have the function `four_bar_turn`, which the library has already",
        ),
        ("Lag", "would have the function `lag`, which SQL has already"),
        ("Sqrt", "would have the function `sqrt`, which SQL has already"),
    ] {
        let message = message(&WIPER.replace("Wiper", name));
        assert!(message.contains(told), "{message}");
    }
    for (quantity, told) in [
        ("speed", "would have `speed` twice: names in SQL"),
        ("ROD", "the function `blade` would have `rod` twice"),
    ] {
        let text = WIPER.replace("Wiper", "Blade").replace("crank", quantity);
        let message = message(&text);
        assert!(message.contains(told), "{message}");
    }
    let message = message("struct Empty { a: Length }\ninput b: Angle;\nunknown c: Angle;\nc == d;");
    assert!(message.contains('d'), "{message}");
}

/// Every query of the chapter on searches runs, and every number that it asks for is there.
#[tokio::test]
async fn queries_of_the_chapter() {
    let chapter = include_str!("../../docs/search.md");
    let mut count = 0;
    for block in chapter.split("```sql\n").skip(1) {
        let sql = block.split("```").next().unwrap();
        let rows = ask(&new(), sql).await.unwrap_or_else(|error| panic!("{error}\n{sql}"));
        assert!(rows.num_rows() > 0, "no rows:\n{sql}");
        for column in rows.columns() {
            assert_eq!(column.null_count(), 0, "{rows:?}\n{sql}");
        }
        count += 1;
    }
    assert!(count > 0, "the chapter has no queries");
}
