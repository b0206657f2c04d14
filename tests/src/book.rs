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
    theory: "../../docs/theory.md";
    grammar: "../../docs/grammar.md";
    outputs: "../../docs/outputs.md";
    closed_forms: "../../docs/closed-forms.md";
    coupled: "../../docs/coupled.md";
    batches: "../../docs/batches.md";
    errors: "../../docs/errors.md";
    verification: "../../docs/verification.md";
    accuracy: "../../docs/accuracy.md";
    library: "../../docs/library.md";
    performance: "../../docs/performance.md";
    optimiser: "../../docs/optimiser.md";
    architecture: "../../docs/architecture.md";
    decisions: "../../docs/decisions.md";
}
