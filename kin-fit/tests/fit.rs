//! The example `fit` prints the text in its head.

#[allow(dead_code, reason = "the test calls what `main` calls")]
#[path = "../examples/fit.rs"]
mod example;

#[test]
fn the_fit_prints_what_its_head_says() {
    let mut printed = Vec::new();
    example::report(&mut printed).expect("it ends");
    let head = include_str!("../examples/fit.rs")
        .lines()
        .skip_while(|line| *line != "//! ```text")
        .skip(1)
        .take_while(|line| *line != "//! ```");
    let head: Vec<&str> = head.map(|line| line.strip_prefix("//! ").unwrap_or_default()).collect();
    let printed = String::from_utf8(printed).expect("it is text");
    assert_eq!(printed.lines().collect::<Vec<_>>(), head);
}
