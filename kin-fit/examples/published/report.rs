//! The printed results of each problem.

use std::fmt::Write as _;
use std::time::Instant;

use kin_core::library::FourBar;
use kin_core::prelude::*;
use kin_fit::Effort;

use super::path::{CASES, PathCase};
use super::straight_line::{MOST_EVEN, STRAIGHTEST, StraightLine, best_hoeken, straightest};
use super::stroke::Stroke;
use super::walking::{Leg, Limits};
use super::{dwell, logarithm, walking};

/// A problem with the effort with which the book's numbers were found.
pub(crate) struct Problem {
    /// Its name in a terminal.
    pub(crate) name: &'static str,
    pub(crate) starts: u64,
    pub(crate) generations: u64,
    report: fn(Effort) -> String,
}

const fn problem(name: &'static str, starts: u64, generations: u64, report: fn(Effort) -> String) -> Problem {
    Problem {
        name,
        starts,
        generations,
        report,
    }
}

/// All problems.
pub(crate) static PROBLEMS: [Problem; 5] = [
    problem("straight-line", 16, 300, straight_line),
    problem("walking", 8, 300, legs),
    problem("dwell", 4, 300, dwells),
    problem("logarithm", 32, 300, generators),
    problem("path", 300, 1000, paths),
];

impl Problem {
    /// Searches, and writes the results of the literature and of the search.
    ///
    /// The text depends on the effort alone, but for the seconds in its last line.
    pub(crate) fn solve(&self, effort: Effort) -> String {
        let clock = Instant::now();
        let mut text = (self.report)(effort);
        let _ = writeln!(
            text,
            "\n{} starts, {} generations, seed {}: {:.1} s",
            effort.starts,
            effort.generations,
            effort.seed,
            clock.elapsed().as_secs_f64()
        );
        text
    }
}

/// A table whose columns are as wide as their widest cell. The first column is flush left.
fn table(rows: &[Vec<String>]) -> String {
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        rows.iter()
            .filter_map(|row| row.get(column))
            .map(|cell| cell.chars().count())
            .max()
    };
    let widths: Vec<usize> = (0..count).map(|column| width(column).unwrap_or(0)).collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
            let _ = match column {
                0 => write!(line, "{cell:<width$}"),
                _ => write!(line, "  {cell:>width$}"),
            };
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}

fn cells(cells: &[&str]) -> Vec<String> {
    cells.iter().map(|cell| (*cell).to_owned()).collect()
}

fn percent(value: f64, digits: usize) -> String {
    format!("{:.digits$} %", 100.0 * value)
}

fn degrees(value: f64, digits: usize) -> String {
    format!("{:.digits$}°", value.to_degrees())
}

fn lengths(found: &StraightLine) -> String {
    let linkage = &found.linkage;
    format!(
        "r1 {:.4}, r2 {:.0}, r3 {:.4}, r4 {:.4}, tracer ({:.4}, {:.4}), {} from {:.2}°",
        linkage.r1,
        linkage.r2,
        linkage.r3,
        linkage.r4,
        linkage.point.x,
        linkage.point.y,
        word(found.assembly),
        found.stroke.start.to_degrees()
    )
}

fn word(assembly: Assembly) -> &'static str {
    match assembly {
        Assembly::Open => "open",
        Assembly::Crossed => "crossed",
    }
}

fn straight_line(effort: Effort) -> String {
    let mut text = "Hoeken's linkages of Norton's table 3-1: printed, and computed here\n".to_owned();
    let mut rows = vec![cells(&[
        "range",
        "deviation",
        "computed",
        "unevenness",
        "computed",
        "line",
        "computed",
    ])];
    for row in STRAIGHTEST.iter().chain(&MOST_EVEN) {
        let Some(stroke) = row.stroke(20) else { continue };
        rows.push(vec![
            format!("{}°", row.range),
            format!("{} %", row.deviation),
            percent(stroke.deviation, 4),
            format!("{} %", row.unevenness),
            percent(stroke.unevenness, 3),
            format!("{:.3}", row.line),
            format!("{:.4}", stroke.chord),
        ]);
    }
    text += &table(&rows);
    text += "\nhalf a revolution, transmission angle at least 40° in it, links between 0.1 and 10 lines\n";
    let mut rows = vec![cells(&[
        "",
        "deviation",
        "unevenness",
        "transmission",
        "over the revolution",
    ])];
    let mut found = Vec::new();
    let line = |name: String, stroke: &Stroke| {
        vec![
            name,
            percent(stroke.deviation, 4),
            percent(stroke.unevenness, 2),
            degrees(stroke.transmission, 1),
            degrees(stroke.worst_transmission, 1),
        ]
    };
    for row in [STRAIGHTEST[3], MOST_EVEN[3]] {
        let Some(stroke) = row.stroke(20) else { continue };
        rows.push(line(format!("Norton {} : 1 : {}", row.ground, row.coupler), &stroke));
        if let Some(hoeken) = best_hoeken(stroke.unevenness, Effort { starts: 4, ..effort }) {
            rows.push(line("best of Hoeken's, no less even".to_owned(), &hoeken.stroke));
        }
        if let Some(any) = straightest(stroke.unevenness, effort) {
            rows.push(line("best four-bar linkage, no less even".to_owned(), &any.stroke));
            found.push(any);
        }
    }
    text += &table(&rows);
    for found in &found {
        let _ = writeln!(text, "found: {}", lengths(found));
    }
    text
}

fn legs(effort: Effort) -> String {
    let mut rows = vec![cells(&["", "links", "bob", "unevenness", "lift", "transmission"])];
    let line = |name: String, leg: &Leg| {
        let step = &leg.step;
        vec![
            name,
            leg.links.to_string(),
            percent(step.deviation, 3),
            percent(step.unevenness, 1),
            format!("{:.3}", step.lift),
            degrees(step.worst_transmission, 1),
        ]
    };
    let mut notes = String::new();
    if let Some(jansen) = walking::jansen() {
        rows.push(line("Jansen's leg, holy numbers".to_owned(), &jansen));
        if let Some((dimensions, better)) = walking::better_jansen(WITHIN, effort) {
            rows.push(line("Jansen's leg, within 10 %".to_owned(), &better));
            let _ = writeln!(notes, "found: {dimensions:.4?}");
        }
        let limits = Limits {
            unevenness: jansen.step.unevenness,
            lift: jansen.step.lift,
            transmission: jansen.step.worst_transmission,
        };
        if let Some((linkage, leg)) = walking::four_bar(&limits, effort) {
            rows.push(line("four-bar linkage, no worse than Jansen's".to_owned(), &leg));
            let _ = writeln!(notes, "found: {}", lengths(&linkage));
        }
    }
    if let Some(klann) = walking::klann() {
        rows.push(line("Klann's leg, patent".to_owned(), &klann));
        if let Some((dimensions, better)) = walking::better_klann(WITHIN, effort) {
            rows.push(line("Klann's leg, within 10 %".to_owned(), &better));
            let _ = writeln!(notes, "found: {dimensions:.4?}");
        }
    }
    format!(
        "the straightest half revolution of the foot, in shares of the step\n{}{notes}",
        table(&rows)
    )
}

/// The part by which the dimensions of a leg may differ from those of its inventor.
const WITHIN: f64 = 0.1;

fn dwells(effort: Effort) -> String {
    let mut rows = vec![cells(&["", "rest within", "swing", "transmission"])];
    let mut notes = String::new();
    let found = [
        (
            "construction on a symmetrical coupler curve",
            dwell::constructed(effort),
        ),
        ("search over all dimensions", dwell::best(effort)),
    ];
    for (name, found) in found {
        let Some(found) = found else { continue };
        rows.push(vec![
            name.to_owned(),
            degrees(found.deviation, 4),
            degrees(found.swing, 2),
            degrees(found.transmission, 1),
        ]);
        let _ = writeln!(
            notes,
            "found: {:.4?}, from {:.2}°",
            found.linkage,
            found.start.to_degrees()
        );
    }
    format!(
        "link 6 of a Stephenson III linkage rests for 120° of the crank and swings by 30° or more\n{}{notes}",
        table(&rows)
    )
}

fn generators(effort: Effort) -> String {
    let mut rows = vec![cells(&["", "largest error", "transmission"])];
    let mut notes = String::new();
    let equal = logarithm::NEAR_EQUAL.equalised(2000);
    let mut found = vec![
        (
            "five precision points".to_owned(),
            equal.and_then(|equal| equal.exact_at(logarithm::chebyshev())),
        ),
        ("the same linkage with six equal errors".to_owned(), equal),
    ];
    for limit in [40.0_f64, 15.0] {
        let angle = limit.to_radians();
        found.extend([
            (
                format!("transmission ≥ {limit}°: three precision points, best start angles"),
                logarithm::best_of_three_points(angle, effort),
            ),
            (
                format!("transmission ≥ {limit}°: smallest largest error"),
                logarithm::best(angle, effort),
            ),
        ]);
    }
    for (name, found) in found {
        let Some(found) = found else { continue };
        let Ok(quality) = found.quality(5000) else { continue };
        rows.push(vec![name, degrees(quality.error, 5), degrees(quality.transmission, 1)]);
        let FourBar { r2, r3, r4, .. } = found.linkage;
        let _ = writeln!(
            notes,
            "found: r2 {r2:.5}, r3 {r3:.5}, r4 {r4:.5}, {}, from {:.4}° and {:.4}°, follower {}",
            word(found.assembly),
            found.crank.to_degrees(),
            found.follower.to_degrees(),
            if found.direction > 0.0 {
                "with the crank"
            } else {
                "against the crank"
            }
        );
    }
    format!(
        "log x, 1 ≤ x ≤ 2: crank 60°, follower 90°, ground link 1\n{}{notes}",
        table(&rows)
    )
}

fn paths(effort: Effort) -> String {
    let all = CASES.iter().map(|case| path(case, effort));
    all.collect::<Vec<_>>().join("\n")
}

fn path(case: &PathCase, effort: Effort) -> String {
    let mut text = format!("{}: {}\n", case.name, case.title);
    for published in case.published {
        let computed = case
            .recomputed(published)
            .map_or_else(|error| error.to_string(), |error| format!("{error:.4e}"));
        let _ = writeln!(
            text,
            "  printed  {:.1e}, computed {computed}: {}",
            published.error, published.source
        );
    }
    if !case.remark.is_empty() {
        let _ = writeln!(text, "  remark   {}", case.remark);
    }
    if let Ok(Some(found)) = case.search(effort) {
        let linkage = &found.linkage;
        let _ = writeln!(
            text,
            "  found    {:.6e}: r1 {:.5}, r2 {:.5}, r3 {:.5}, r4 {:.5}, tracer ({:.5}, {:.5}), turn {:.4}°, pivot \
             ({:.5}, {:.5}), {}",
            found.error,
            linkage.r1,
            linkage.r2,
            linkage.r3,
            linkage.r4,
            linkage.point.x,
            linkage.point.y,
            linkage.turn.to_degrees(),
            linkage.pivot.x,
            linkage.pivot.y,
            word(found.assembly)
        );
    }
    text
}
