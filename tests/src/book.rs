//! The code in the README and in the book, compiled and run as documentation tests.

macro_rules! chapters {
    ($($name:ident: $path:literal;)+) => {
        $(
            #[cfg(doctest)]
            #[doc = include_str!($path)]
            mod $name {}
        )+
    };
}

chapters! {
    readme: "../../README.md";
    introduction: "../../docs/introduction.md";
    first_mechanism: "../../docs/first-mechanism.md";
    grammar: "../../docs/grammar.md";
    generated: "../../docs/generated.md";
    assemblies: "../../docs/assemblies.md";
    tracking: "../../docs/tracking.md";
    errors: "../../docs/errors.md";
    outputs: "../../docs/outputs.md";
    motion_laws: "../../docs/motion-laws.md";
    loads: "../../docs/loads.md";
    recipes: "../../docs/recipes.md";
    batches: "../../docs/batches.md";
    search: "../../docs/search.md";
    sweeps: "../../docs/sweeps.md";
    cycle: "../../docs/cycle.md";
    report: "../../docs/report.md";
    jansen_leg: "../../docs/jansen-leg.md";
    whole_programs: "../../docs/whole-programs.md";
    languages: "../../docs/languages.md";
    exact_tables: "../../docs/exact-tables.md";
    program: "../../docs/program.md";
    library: "../../docs/library.md";
    gallery: "../../docs/gallery.md";
    problems: "../../docs/problems.md";
    theory: "../../docs/theory.md";
    closed_forms: "../../docs/closed-forms.md";
    coupled: "../../docs/coupled.md";
    verification: "../../docs/verification.md";
    accuracy: "../../docs/accuracy.md";
    performance: "../../docs/performance.md";
    architecture: "../../docs/architecture.md";
    inner_loop: "../../docs/inner-loop.md";
    optimiser: "../../docs/optimiser.md";
    decisions: "../../docs/decisions.md";
}
