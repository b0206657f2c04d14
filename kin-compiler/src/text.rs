//! Declarations from text.

use std::fmt;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use proc_macro2::{Ident, LineColumn, Span, TokenStream};
use quote::quote;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Expr, ExprLit, Lit};

use crate::budget::{Budget, Refusal, Resource, TooLarge};
use crate::bug::bug;
use crate::expand::{expand, solved, structure};
use crate::formulas::{Formulas, formulas};
use crate::lower;
use crate::mistakes::Mistakes;
use crate::model;
use crate::room::with_room;
use crate::structure::Structure;
use crate::syntax::{self, Dimension, QuantityItem, Statement};
use crate::translate::sheets;
use crate::translate::tree::Sheets;
use crate::work;

/// A declaration that has been compiled.
///
/// ```
/// use kin_compiler::Declaration;
///
/// let slider_crank = "
///     /// A crank, a rod, and a slide.
///     struct SliderCrank { r: Length, l: Length }
///     input theta: Angle;
///     unknown phi: Angle, s: Length;
///     r * cis(theta) + l * cis(phi) == vec2(s, 0);
/// ";
/// let compiled = Declaration::parse(slider_crank).expect("there is no mistake");
/// assert_eq!((compiled.name(), compiled.documentation()), ("SliderCrank", "A crank, a rod, and a slide."));
/// assert_eq!(compiled.inputs()[0].name, "theta");
/// assert!(compiled.rust().contains("pub fn velocity"));
/// // the steps of each order, with their costs
/// assert!(compiled.printout().contains("velocity: "));
///
/// let mistakes = Declaration::parse(&slider_crank.replace("cis(phi)", "cis(psi)")).unwrap_err();
/// let message = "6:30: no parameter, input, unknown, `let` or output is called `psi`; did you mean `phi`?";
/// assert_eq!(mistakes[0].to_string(), message);
/// assert_eq!(&slider_crank[mistakes[0].bytes.clone()], "phi");
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Declaration {
    name: String,
    documentation: String,
    parameters: Vec<Quantity>,
    inputs: Vec<Quantity>,
    unknowns: Vec<Quantity>,
    outputs: Vec<Quantity>,
    printout: String,
    text: String,
    program: lower::Mechanism,
    sheets: Sheets,
    work: usize,
}

/// A declared quantity.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Quantity {
    /// Its name.
    pub name: String,
    /// Its dimension.
    pub dimension: Dimension,
    /// The lines of its documentation.
    pub documentation: String,
}

/// A mistake in a declaration.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Mistake {
    /// What is wrong, and then what to do about it.
    pub message: String,
    /// The first letter of the tokens at fault.
    pub start: Position,
    /// The position behind their last letter.
    pub end: Position,
    /// The bytes of these tokens in the text.
    pub bytes: Range<usize>,
}

impl Mistake {
    /// What is wrong: the message up to the first colon or semicolon outside of code.
    #[must_use]
    pub fn fault(&self) -> &str {
        fault_and_advice(&self.message).0
    }

    /// What to do about it, the rest of the message; `None` where the fault alone says it, or belongs to another
    /// mistake.
    #[must_use]
    pub fn advice(&self) -> Option<&str> {
        fault_and_advice(&self.message).1
    }
}

/// The part of a message that says what is wrong, and the part that says what to do: see [`Mistake::fault`] and
/// [`Mistake::advice`].
///
/// ```
/// let (fault, advice) = kin_compiler::fault_and_advice("an angle has a unit: write `3deg`");
/// assert_eq!((fault, advice), ("an angle has a unit", Some("write `3deg`")));
/// ```
#[must_use]
pub fn fault_and_advice(message: &str) -> (&str, Option<&str>) {
    let mut is_code = false;
    for (index, letter) in message.char_indices() {
        is_code ^= letter == '`';
        let (fault, rest) = message.split_at(index);
        if let Some(advice) = rest.strip_prefix(": ").or(rest.strip_prefix("; "))
            && !is_code
        {
            return (fault, Some(advice));
        }
    }
    (message, None)
}

/// A position in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// The number of the line, from 1.
    pub line: usize,
    /// The number of the letter in the line, from 1.
    pub column: usize,
}

/// Why a quantity cannot have this name, and what to do; `None` if it can.
///
/// ```
/// assert_eq!(kin_compiler::name_mistake("coupler"), None);
/// assert!(kin_compiler::name_mistake("sin").is_some_and(|message| message.contains("is a function")));
/// ```
#[must_use]
pub fn name_mistake(name: &str) -> Option<String> {
    let read = |input: ParseStream<'_>| syntax::parse_name(input, "quantity", Span::call_site());
    let error = read.parse_str(name).err()?;
    let is_word = name.chars().all(|letter| letter.is_alphanumeric() || letter == '_')
        && name.starts_with(|letter: char| !letter.is_numeric());
    Some(if is_word {
        error.to_string()
    } else {
        format!("`{name}` is no name: begin with a letter, and go on with letters, digits and `_`")
    })
}

/// Every name that an expression can call, in the order in which messages list the names.
///
/// ```
/// assert!(kin_compiler::function_names().any(|name| name == "cis"));
/// ```
pub fn function_names() -> impl Iterator<Item = &'static str> {
    syntax::function_names()
}

impl Declaration {
    /// Compiles the declaration of a mechanism, which is the text between the braces of `mechanism! { … }`. Its memory
    /// ends with the result.
    ///
    /// It compiles what the macro compiles, however long that takes: see [`Self::parse_within`] for texts of others.
    ///
    /// Where no thread can be started, as in WebAssembly, spans of `proc-macro2` that the caller's thread keeps become
    /// invalid.
    ///
    /// # Errors
    /// Every mistake of the declaration, in the order of the text.
    pub fn parse(text: &str) -> Result<Self, Vec<Mistake>> {
        Self::compiled(text, usize::MAX).0
    }

    /// Compiles a declaration, as far as a budget allows it.
    ///
    /// # Errors
    /// Every mistake of the declaration, in the order of the text; or what it takes too much of.
    pub fn parse_within(text: &str, budget: &Budget) -> Result<Self, Refusal> {
        if text.len() > budget.text {
            return Err(Refusal::TooLarge(TooLarge::new(Resource::Text, budget.text)));
        }
        let (result, work) = Self::compiled(text, budget.work);
        if work > budget.work {
            return Err(Refusal::TooLarge(TooLarge::new(Resource::Work, budget.work)));
        }
        result.map_err(Refusal::Mistakes)
    }

    /// The result, which means nothing if more work was done than the budget allows, and the work.
    fn compiled(text: &str, budget: usize) -> (Result<Self, Vec<Mistake>>, usize) {
        // Positions are kept by thread for every text that is read. They go with the thread of this one.
        let on_a_thread = || {
            with_room(|| {
                let compiled = catch_unwind(AssertUnwindSafe(|| compile(text))).unwrap_or_else(|panic| {
                    let start = Position { line: 1, column: 1 };
                    Err(vec![Mistake {
                        message: bug(&*panic),
                        start,
                        end: start,
                        bytes: 0..0,
                    }])
                });
                forget_positions();
                compiled
            })
        };
        let (mut result, work) = work::within(budget, on_a_thread);
        let work = work.total();
        if let Ok(declaration) = &mut result {
            declaration.work = work;
        }
        (result, work)
    }

    /// The name of the mechanism.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The lines of its documentation.
    #[must_use]
    pub fn documentation(&self) -> &str {
        &self.documentation
    }

    /// The parameters.
    #[must_use]
    pub fn parameters(&self) -> &[Quantity] {
        &self.parameters
    }

    /// The inputs.
    #[must_use]
    pub fn inputs(&self) -> &[Quantity] {
        &self.inputs
    }

    /// The unknowns.
    #[must_use]
    pub fn unknowns(&self) -> &[Quantity] {
        &self.unknowns
    }

    /// The outputs.
    #[must_use]
    pub fn outputs(&self) -> &[Quantity] {
        &self.outputs
    }

    /// The program of its solvers: the ways that were compared, and the steps of each order with their costs.
    #[must_use]
    pub fn printout(&self) -> &str {
        &self.printout
    }

    /// The work that its compilation took, in the unit of [`Budget::work`].
    #[must_use]
    pub fn work(&self) -> usize {
        self.work
    }

    /// The mechanism as kin-live runs it.
    #[doc(hidden)]
    #[must_use]
    pub fn program(&self) -> &lower::Mechanism {
        &self.program
    }

    /// The methods of the mechanism that are translated from its syntax tree: they take few bytes beside the printout.
    #[doc(hidden)]
    #[must_use]
    pub fn sheets(&self) -> &Sheets {
        &self.sheets
    }

    /// Its equations and their solution, to be read.
    #[doc(hidden)]
    #[must_use]
    pub fn formulas(&self) -> Formulas {
        with_room(|| {
            let mistakes = &mut Mistakes::new();
            let found = syntax::parse(self.tokens(), mistakes).and_then(|declaration| {
                let model = model::build(&declaration, mistakes)?;
                let Structure {
                    graph,
                    residuals,
                    blocks,
                } = structure(&declaration, &model, mistakes)?;
                Some(formulas(&declaration, &model, graph, &residuals, &blocks))
            });
            found.unwrap_or_else(|| unreachable!("a compiled declaration has no mistakes"))
        })
    }

    /// The tokens of the text. What has been read once can be read again.
    fn tokens(&self) -> TokenStream {
        self.text.parse().unwrap_or_default()
    }

    /// The code that the macro writes for it, in which `kin_core` stands for the library.
    #[must_use]
    pub fn rust(&self) -> String {
        with_room(|| {
            let tokens = self.tokens();
            let items = expand(quote!((::kin_core) #tokens)).to_string();
            forget_positions();
            items
        })
    }
}

/// Frees the positions of the tokens on this thread. They are kept for every text that is read, and only where no
/// thread could be started for it are there other texts on this one.
fn forget_positions() {
    proc_macro2::extra::invalidate_current_thread_spans();
}

fn compile(text: &str) -> Result<Declaration, Vec<Mistake>> {
    let tokens: TokenStream = text.parse().map_err(|error: proc_macro2::LexError| {
        let message = "this is no text of Rust: close each bracket, quote and comment, and write letters, digits and \
            operators alone";
        vec![Mistake::at(error.span(), message.to_owned())]
    })?;
    let mut mistakes = Mistakes::new();
    let (declaration, solved) = solved(tokens, &mut mistakes);
    let mut mistakes: Vec<Mistake> = mistakes
        .into_errors()
        .map(|error| Mistake::at(error.span(), error.to_string()))
        .collect();
    mistakes.sort_by_key(|mistake| (mistake.start, mistake.end));
    match (declaration, solved) {
        (Some(declaration), Some((model, structure, solvers))) if mistakes.is_empty() => {
            let program = lower::mechanism(&model, &structure.blocks, &solvers);
            let sheets = sheets(&declaration, &model);
            let printout = solvers.to_string();
            Ok(Declaration::new(
                &declaration,
                printout,
                text.to_owned(),
                program,
                sheets,
            ))
        }
        _ => Err(mistakes),
    }
}

impl Declaration {
    fn new(
        declaration: &syntax::Declaration,
        printout: String,
        text: String,
        program: lower::Mechanism,
        sheets: Sheets,
    ) -> Self {
        let parameters = declaration.parameters.iter().filter_map(|field| {
            let dimension = field.dimension?;
            Some(Quantity::new(&field.name, dimension, &field.attributes))
        });
        let mut compiled = Self {
            name: declaration.name.to_string(),
            documentation: documentation(&declaration.attributes),
            parameters: parameters.collect(),
            inputs: Vec::new(),
            unknowns: Vec::new(),
            outputs: Vec::new(),
            printout,
            text,
            program,
            sheets,
            work: 0,
        };
        let quantity = |item: &QuantityItem| Quantity::new(&item.name, item.dimension, &item.documentation);
        for statement in &declaration.statements {
            match statement {
                Statement::Inputs(items) => compiled.inputs.extend(items.iter().map(quantity)),
                Statement::Unknowns(items) => {
                    let quantities = items.iter().map(|item| quantity(&item.quantity));
                    compiled.unknowns.extend(quantities);
                }
                Statement::Output(output) => {
                    let output = Quantity::new(&output.name, output.dimension, &output.documentation);
                    compiled.outputs.push(output);
                }
                _ => {}
            }
        }
        compiled
    }
}

impl Quantity {
    fn new(name: &Ident, dimension: Dimension, attributes: &[Attribute]) -> Self {
        Self {
            name: name.to_string(),
            dimension,
            documentation: documentation(attributes),
        }
    }
}

/// The lines of doc comments.
fn documentation(attributes: &[Attribute]) -> String {
    let line = |attribute: &Attribute| match &attribute.meta.require_name_value().ok()?.value {
        Expr::Lit(ExprLit {
            lit: Lit::Str(text), ..
        }) => attribute.path().is_ident("doc").then(|| text.value()),
        _ => None,
    };
    let lines = attributes.iter().filter_map(line);
    lines.map(|line| line.trim().to_owned()).collect::<Vec<_>>().join("\n")
}

impl Mistake {
    fn at(span: Span, message: String) -> Self {
        let position = |LineColumn { line, column }| Position {
            line,
            column: column + 1,
        };
        Self {
            message,
            start: position(span.start()),
            end: position(span.end()),
            bytes: span.byte_range(),
        }
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Position { line, column } = self.start;
        write!(formatter, "{line}:{column}: {}", self.message)
    }
}

impl std::error::Error for Mistake {}

#[cfg(test)]
mod tests {
    use kin_declarations::{FAMILIES, Random};

    use super::Declaration;
    use crate::budget::{Budget, Refusal, Resource, TooLarge};

    /// Positions are kept nowhere: the bytes of each text count from its own beginning.
    #[test]
    fn texts_do_not_add_up() {
        for _ in 0..3 {
            let mistakes =
                Declaration::parse("struct Crank { r: Lenght } input theta: Angle; unknown x: Length; x == r;")
                    .expect_err("`Lenght` is no dimension");
            assert_eq!(mistakes[0].bytes, 18..24, "{mistakes:?}");
        }
    }

    /// Code has colons of its own.
    #[test]
    fn advice_follows_the_fault() {
        let text = "struct Crank { r: Lenght } input theta: Angle; unknown x: Length; x == r;";
        let mistakes = Declaration::parse(text).expect_err("`Lenght` is no dimension");
        let parts = |mistake: &super::Mistake| (mistake.fault().to_owned(), mistake.advice().map(str::to_owned));
        let (fault, advice) = parts(&mistakes[0]);
        assert_eq!(fault, "`Lenght` is not a dimension");
        assert!(advice.is_some_and(|advice| advice.starts_with("write `Length`")));
        let mut mistake = mistakes[0].clone();
        mistake.message = "`a: b; c` stands here; write `a`: it is shorter".to_owned();
        assert_eq!(
            parts(&mistake),
            (
                "`a: b; c` stands here".to_owned(),
                Some("write `a`: it is shorter".to_owned())
            )
        );
        mistake.message = "comments begin with `//`".to_owned();
        assert_eq!(parts(&mistake), ("comments begin with `//`".to_owned(), None));
    }

    /// A budget ends the work soon after it is spent, wherever that happens, and the work that was counted is enough.
    #[test]
    fn work_ends_with_its_budget() {
        let family = |name: &str, size| {
            let family = FAMILIES.iter().find(|family| family.name == name);
            family
                .expect("it is one of them")
                .declaration(&mut Random::new(1), size)
        };
        for (name, size) in [
            ("serial_arm", 4),
            ("four_bars_in_series", 4),
            ("ring_of_products", 4),
            ("many_parameters", 30),
            ("sensitivities_of_all_orders", 4),
        ] {
            let text = family(name, size);
            let whole = Declaration::parse(&text).unwrap_or_else(|mistakes| panic!("{name}: {}", mistakes[0]));
            let least = Budget {
                work: whole.work(),
                ..Budget::default()
            };
            assert_eq!(Declaration::parse_within(&text, &least), Ok(whole.clone()), "{name}");
            for part in [1, 10, 50, 90, 99] {
                let work = whole.work() * part / 100;
                let refusal = Declaration::parse_within(&text, &Budget { work, ..least }).expect_err(name);
                assert_eq!(
                    refusal,
                    Refusal::TooLarge(TooLarge::new(Resource::Work, work)),
                    "{name}"
                );
                let (_, done) = Declaration::compiled(&text, work);
                assert!(
                    done <= 2 * work + 1_000,
                    "{name}: {done} for {work} of {}",
                    whole.work()
                );
            }
        }
        let text = "struct M { a: Length }";
        let refusal = Declaration::parse_within(
            text,
            &Budget {
                text: 21,
                ..Budget::default()
            },
        );
        assert_eq!(refusal, Err(Refusal::TooLarge(TooLarge::new(Resource::Text, 21))));
    }

    #[test]
    fn what_is_no_text_of_rust() {
        for text in ["struct Crank { r: Length", "x == \"", "r · cos(θ)"] {
            let mistakes = Declaration::parse(text).expect_err("it cannot be read");
            assert!(!mistakes.is_empty() && mistakes[0].start.line == 1, "{mistakes:?}");
        }
        assert_eq!(Declaration::parse("").expect_err("it is empty").len(), 1);
    }
}
