//! The messages about mistakes: one mistake in each file, named after it, and its message beside it. The folders are the
//! kinds of mistakes: `syntax`, `names`, `dimensions`, `space`, `structure`, `ranges` (of unknowns, functions and numbers), `requests`,
//! `picture`, and `calls` of the generated code.
//!
//! `cargo test --workspace --test book -- --ignored` compares them, as `.ci/run` does. With `TRYBUILD=overwrite` before it the command
//! writes the messages anew. Read them before you keep them.

#[test]
#[ignore = "compiles two hundred declarations, see .ci/run"]
fn mistakes_are_told_where_they_are_made() {
    trybuild::TestCases::new().compile_fail("compile-fail/*/*.rs");
}
