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
    sweeps: "../../docs/sweeps.md";
    cycle: "../../docs/cycle.md";
    laws: "../../docs/laws.md";
    loads: "../../docs/loads.md";
    forces: "../../docs/forces.md";
    batches: "../../docs/batches.md";
    programs: "../../docs/programs.md";
    search: "../../docs/search.md";
    program: "../../docs/program.md";
    languages: "../../docs/languages.md";
    live: "../../docs/live.md";
    python: "../../docs/python.md";
    browser: "../../docs/browser.md";
    library: "../../docs/library.md";
    theory: "../../docs/theory.md";
    closed_forms: "../../docs/closed-forms.md";
    coupled: "../../docs/coupled.md";
    verification: "../../docs/verification.md";
    accuracy: "../../docs/accuracy.md";
    performance: "../../docs/performance.md";
    architecture: "../../docs/architecture.md";
    macro_pass_by_pass: "../../docs/macro.md";
    decisions: "../../docs/decisions.md";
}
