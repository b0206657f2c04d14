//! Pages of refined candidates.

use kin_core::any::Of;
use kin_core::library::HoekenLinkage;
use kin_core::prelude::*;
use kin_fit::{Candidate, Objective, Settings, polish};
use kin_search::pages::write_pages;

#[test]
fn pages_are_written() {
    let known: HoekenLinkage = HoekenLinkage {
        ground: 2.0,
        crank: 1.0,
        coupler: 2.5,
    };
    let targets = (0..6).map(|step| {
        let input = 0.2 + std::f64::consts::TAU * f64::from(step) / 6.0;
        let tracer = known.position(input, Assembly::Open).expect("it closes").tracer.value();
        [tracer.x, tracer.y]
    });
    let objective = Objective::path(Of::<HoekenLinkage>::FUNCTIONS, "tracer", targets)
        .and_then(|objective| objective.bounds("crank", 0.8..=1.2))
        .expect("a point and a parameter");
    let candidate = Candidate::new(&known, Assembly::Open).numbered(42);
    let found = polish(&objective, &[candidate], &Settings::default()).expect("a good objective");
    let folder = std::env::temp_dir().join(format!("kin-search-pages-{}", std::process::id()));
    let paths =
        write_pages(Of::<HoekenLinkage>::FUNCTIONS, &found, &objective, &folder).expect("a folder for temporary files");
    assert_eq!(paths.len(), 1);
    assert!(paths[0].ends_with("hoeken-linkage-1-42.html"), "{paths:?}");
    let page = std::fs::read_to_string(&paths[0]).expect("it was written");
    assert!(page.starts_with("<!doctype html>") && page.contains("HoekenLinkage, candidate 42"));
    std::fs::remove_dir_all(folder).expect("it is there");
}
