//! The assembly of a mechanism with several dyads.

/// The assembly of a mechanism with several dyads, as its solvers take it: `A` is the structure that the declaration
/// generates, with one [`Assembly`](crate::Assembly) for each block.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not choose the assembly of every block of this mechanism",
    label = "expected `{A}`",
    note = "`{A}` has a field for each block that can be assembled in two ways, named after the unknowns of the block: \
            write `{A} {{ first: Assembly::Open, second: Assembly::Crossed }}` with the names of the fields",
    note = "`{A}::all(Assembly::Open)` chooses the same for every block, and `ASSEMBLIES` of the mechanism lists all \
            choices"
)]
#[doc(hidden)]
pub trait IntoAssembly<A> {
    /// The assembly.
    fn into_assembly(self) -> A;
}

impl<A> IntoAssembly<A> for A {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn into_assembly(self) -> A {
        self
    }
}
