//! What the compiler says about programs with mistakes: one mistake in each file, named after it, and its message
//! beside it. The folders are `calls` of the generated code, `characters` on which it remarks, and `uses` of wrong
//! declarations, which give no further errors. The messages of the macro itself are tested in
//! `kin-compiler/src/testing/mistakes`, without the compiler.
//!
//! `cargo test -p kin-messages -- --ignored` compares them, as `.ci/run messages` does. With `TRYBUILD=overwrite`
//! before it the command writes the messages anew. Read them before you keep them.

#[test]
#[ignore = "compiles fifty programs, see .ci/run"]
fn mistakes_are_told_where_they_are_made() {
    trybuild::TestCases::new().compile_fail("compile-fail/*/*.rs");
}
