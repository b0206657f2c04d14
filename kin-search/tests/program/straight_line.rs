//! The search of the book for a straight line.

use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use kin_core::Plane;
use kin_core::prelude::*;
use kin_fit::TracedFourBar;
use serde_json::Value;

use super::published::straight_line::{LINKS, TRANSMISSION, samples_of};
use super::published::stroke::Stroke;

/// The steps of a revolution whose half has the poses at which the last query measures.
const STEPS: usize = 7200;

/// Searches, and checks the linkages without SQL: each is as straight as the query says, and the first is better than
/// the best of Hoeken's.
fn search(sql: &str, name: &str) {
    let query = super::file(&format!("{name}.sql"), sql);
    let (rows, pages) = (query.with_extension("json"), query.with_extension("pages"));
    let _ = fs::remove_dir_all(&pages);
    let began = Instant::now();
    let output = super::program()
        .arg("query")
        .args([&query, Path::new("--output"), &rows, Path::new("--pages"), &pages])
        .output()
        .unwrap();
    println!("{:.1} s", began.elapsed().as_secs_f64());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let rows: Vec<Value> = fs::read_to_string(&rows)
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let strokes: Vec<(Stroke, &str)> = rows.iter().map(checked).collect();
    let hoeken = strokes.iter().find(|stroke| stroke.1 == "Hoeken").unwrap().0;
    let best = strokes[0].0;
    println!("{best:?}\n{hoeken:?}");
    assert_eq!(strokes[0].1, "searched");
    assert!(best.deviation < hoeken.deviation && best.unevenness <= hoeken.unevenness);

    let pages: Vec<PathBuf> = fs::read_dir(pages).unwrap().map(|page| page.unwrap().path()).collect();
    assert_eq!(pages.len(), rows.len());
    let id = &rows[0]["id"];
    let first = pages
        .iter()
        .find(|page| page.ends_with(format!("traced-four-bar-1-{id}.html")));
    let page = fs::read_to_string(first.unwrap()).unwrap();
    assert!(page.contains("found: searched; "));
}

/// The stroke of a linkage, which keeps the limits of the search.
fn checked(row: &Value) -> (Stroke, &str) {
    let number = |name: &str| row[name].as_f64().unwrap();
    let linkage = TracedFourBar {
        r1: number("r1"),
        r2: number("r2"),
        r3: number("r3"),
        r4: number("r4"),
        point: Plane::new(number("point_x"), number("point_y")),
        turn: number("turn"),
        pivot: Plane::new(number("pivot_x"), number("pivot_y")),
    };
    let start = number("start");
    let samples = samples_of(&linkage, Assembly::Open, start, STEPS).unwrap();
    let stroke = Stroke::of(&samples, start, STEPS / 2).unwrap();
    for (found, stated, error) in [
        // Some ten roundings of coordinates of about ten cranks.
        (stroke.chord, "length", 1e-13),
        (stroke.deviation, "deviation", 1e-13),
        // The query has the mean speed by the trapezoidal rule. Its error is h²/12 times the change of the
        // acceleration, which is some cranks, over a way of some cranks.
        (stroke.unevenness, "unevenness", (PI / 3600.0).powi(2) / 12.0 * 10.0),
        (stroke.transmission.to_degrees(), "transmission", 1e-11),
    ] {
        let stated = number(stated);
        assert!((found - stated).abs() <= error, "{found} and {stated}");
    }
    assert!(linkage.shortfall() <= 0.0 && stroke.transmission >= TRANSMISSION);
    for link in [linkage.r1, linkage.r2, linkage.r3, linkage.r4] {
        assert!((LINKS[0]..=LINKS[1]).contains(&(link / stroke.chord)));
    }
    (stroke, row["found"].as_str().unwrap())
}

const WHOLE: &str = include_str!("../../examples/straight_line.sql");

#[test]
fn straighter_than_hoekens_linkage() {
    let part = WHOLE
        .replace("range(0, 200000)", "range(0, 4000)")
        .replace("range(0, 20000)", "range(0, 500)")
        .replace("limit 20", "limit 10")
        .replace("'open', 61,", "'open', 25,");
    assert_eq!(part.matches("range(0, 500)").count(), 8);
    search(&part, "part_of_straight_line");
}

#[test]
#[ignore = "takes an hour without optimisation, and a minute with it"]
fn the_search_finds_a_straighter_line_than_hoekens() {
    search(WHOLE, "straight_line");
}
