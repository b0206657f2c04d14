//! Jobs from files, candidates from tables, and tables of results.

use kin_core::any::Of;
use kin_core::library::WattI;
use kin_core::prelude::*;
use kin_fit::{Candidate, Job, polish};

use super::{COUPLER, KNOWN, placed};

fn job(rest: &str) -> String {
    let targets: Vec<[f64; 2]> = (0..5)
        .map(|step| placed(&KNOWN, 0.4 * f64::from(step), [0.0; 3]))
        .map(|[x, y, _]| [x, y])
        .collect();
    format!(
        r#"{{ "mechanism": "coupler", "goal": {{ "path": {{ "point": "point", "targets": {targets:?} }} }}, {rest} }}"#
    )
}

#[test]
fn from_a_job_to_a_table() {
    let job = Job::read(&job(
        r#""bounds": { "r2": [0.4, 0.8], "along": [0.5, 1.5] }, "travel": "turn", "sense": "forward",
        "terms": [{ "driver_turns": { "aim": 0.01, "weight": 1 } }], "evaluations": 300, "seed": 3"#,
    ))
    .expect("a good job");
    // the second line has no margin, and every line has two assemblies
    let candidates = job
        .candidates(
            COUPLER,
            "r1,r2,r3,r4,along,beside,mark,id,note\n2,0.55,1.8,1.5,1,0.7,0,8,\"a, \"\"b\"\"\"\n\n\
             2,0.55,1.8,0.5,1,0.7,0,9,\n3,1,1,1,1,1,1,10,\n",
            2,
        )
        .expect("a good table");
    assert_eq!(
        candidates.iter().map(|candidate| candidate.id).collect::<Vec<_>>(),
        [8, 8, 9, 9]
    );
    let objective = job.objective(COUPLER).expect("it fits");
    let found = polish(&objective, &candidates, &job.settings(1)).expect("it fits");
    assert!(found.results[0].polished.largest < 1e-12 && found.results[0].id == 8);
    let table = found.table();
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 5);
    assert!(
        lines[0].starts_with("id,defect,start,evolved,polished,largest,transmission,r1,r2,"),
        "{}",
        lines[0]
    );
    let columns = |line: &str| line.split(',').count();
    assert!(lines.iter().all(|line| columns(line) == columns(lines[0])), "{table}");
    assert!(
        lines[1].starts_with("8,,") && lines[1].ends_with(",\"open\""),
        "{}",
        lines[1]
    );
    assert!(lines.iter().any(|line| line.starts_with("9,margin,")), "{table}");
    // results are candidates again
    let again = job
        .candidates(COUPLER, &table, usize::MAX)
        .expect("the columns have the same names");
    assert_eq!(again[0].parameters, found.results[0].design.parameters());
}

#[test]
fn assemblies_by_their_words() {
    let job =
        Job::read(r#"{ "mechanism": "watt_i", "goal": { "function": { "quantity": "theta6", "pairs": [[0, 1]] } } }"#)
            .expect("a good job");
    let head = "r1,r2,r3,r4,p_x,p.y,q_x,q_y,r5,r6,assembly";
    let read = |word: &str| {
        job.candidates(
            Of::<WattI>::FUNCTIONS,
            &format!("{head}\n1,2,3,4,5,6,7,8,9,10,{word}\n"),
            1,
        )
    };
    let name = |candidate: &Candidate| {
        let assembly = candidate.choice.index().and_then(WattI::<f64>::assembly);
        format!("{:?}", assembly.expect("an assembly"))
    };
    let found = read("\"theta3_theta4=open, theta5_theta6: Crossed\"").expect("an assembly");
    assert_eq!(
        name(&found[0]),
        "WattIAssembly { theta3_theta4: Open, theta5_theta6: Crossed }"
    );
    let found = read("crossed").expect("an assembly");
    assert_eq!(
        name(&found[0]),
        "WattIAssembly { theta3_theta4: Crossed, theta5_theta6: Crossed }"
    );
    let error = read("left").expect_err("no assembly").to_string();
    assert!(
        error.starts_with("candidates, line 2: `left` is no assembly; there are `theta3_theta4=open,"),
        "{error}"
    );
}

#[test]
fn mistakes_have_a_line() {
    let error = Job::read("{\n \"mechanism\": \"coupler\",\n \"gaol\": 3 }")
        .expect_err("no such field")
        .to_string();
    assert!(
        error.contains("unknown field `gaol`") && error.contains("line 3"),
        "{error}"
    );
    let wrong = Job::read(&job(r#""bounds": { "r9": [0, 1] }"#)).expect("good JSON");
    let error = wrong.objective(COUPLER).expect_err("no such parameter").to_string();
    assert!(error.contains("no parameter `r9`"), "{error}");
    let good = Job::read(&job(r#""bounds": {}"#)).expect("good JSON");
    let table = |text: &str| good.candidates(COUPLER, text, 1).expect_err("a mistake").to_string();
    assert_eq!(table("r1,r2\n1,2\n"), "candidates, line 1: no column is called `r3`");
    let error = table("r1,r2,r3,r4,along,beside,mark\n\n1,2,3,4,5,6,x\n");
    assert_eq!(error, "candidates, line 3: `x` in the column `mark` is no number");
    // a range of inputs that are given, and a strategy without a step
    let both = Job::read(&job(r#""inputs": [0, 1, 2, 3, 4], "within": [0, 1]"#)).expect("good JSON");
    let error = both
        .objective(COUPLER)
        .expect_err("a range of given inputs")
        .to_string();
    assert_eq!(error, "an objective whose inputs are given has no range of inputs");
    let still = Job::read(&job(r#""bounds": { "r2": [0.4, 0.8] }, "spread": 0"#)).expect("good JSON");
    let objective = still.objective(COUPLER).expect("it fits");
    let error = polish(&objective, &[], &still.settings(1))
        .expect_err("no spread")
        .to_string();
    assert_eq!(error, "`spread` is 0; it must be positive");
    // nothing is sought but the inputs of the targets
    assert!(polish(&good.objective(COUPLER).expect("it fits"), &[], &good.settings(1)).is_ok());
}
