//! The examples of this package print what their heads say. Those that need no further crate have a test of their own.

use std::fs;
use std::path::Path;

#[allow(dead_code, reason = "the test calls what `main` calls")]
#[path = "../../examples/cam.rs"]
mod cam;

/// The text of a file of the repository, by its path from the folder of this package.
fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect("it is there")
}

/// The lines of the block of text in the head of an example.
fn head(example: &str) -> String {
    read(&format!("examples/{example}.rs"))
        .lines()
        .skip_while(|line| *line != "//! ```text")
        .skip(1)
        .take_while(|line| *line != "//! ```")
        .flat_map(|line| [line.strip_prefix("//! ").unwrap_or_default(), "\n"])
        .collect()
}

#[test]
fn the_picture_of_the_cam_is_up_to_date() {
    let mut printed = Vec::new();
    let picture = cam::report(&mut printed).expect("it is drawn");
    assert_eq!(String::from_utf8(printed).expect("it is text"), head("cam"));
    assert!(
        picture == read("../docs/figures/cam.svg"),
        "run `cargo run -p kin-tests --example cam`, and look at the picture"
    );
}
