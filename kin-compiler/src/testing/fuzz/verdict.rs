//! The result of an expansion: accepted or refused, with its work, or a defect of the macro.

use std::any::Any;
use std::collections::BTreeMap;
use std::panic::{self, AssertUnwindSafe};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Mutex, Once};
use std::thread;
use std::time::Duration;

use kin_declarations::Random;
use proc_macro2::{TokenStream, TokenTree};

use super::fragments::{with_fragments, with_operands_as_fragments};
use crate::expand::expand;
use crate::work::{self, Work};

/// The size of the stack of the threads of rustc, on which macros run.
const STACK: usize = 8 << 20;

/// The time after which an expansion counts as endless. Work that is counted ends long before, by [`work::ENDLESS`].
const PATIENCE: Duration = Duration::from_mins(10);

/// The bounds of look-ups and of iterations of other loops, for each token read and operation written. A refused
/// declaration may take as much work as an accepted one, but has no operations. It is refused after the derivation of
/// every order at the latest, so its bounds grow with the orders that it asks for.
fn bounds(is_refused: bool, order: usize) -> [usize; 2] {
    if is_refused {
        [1_000, 2_000].map(|bound| bound * (order.max(SNAP) + 1) / (SNAP + 1))
    } else {
        [100, 1_000]
    }
}

/// The order of a declaration that does not ask for another.
const SNAP: usize = 4;

/// The largest order that a declaration asks for, as far as the macro allows it.
fn order(tokens: &TokenStream) -> usize {
    let mut words = tokens.clone().into_iter().map(|token| token.to_string());
    let mut order = SNAP;
    while let Some(word) = words.next() {
        if word == "order" && words.next().as_deref() == Some("=") {
            let asked = words.next().and_then(|number| number.parse().ok());
            order = order.max(asked.unwrap_or(SNAP));
        }
    }
    order.min(12)
}

/// The tokens that are put into groups without delimiters, by a seed.
#[derive(Clone, Copy)]
pub(super) enum Fragments {
    None,
    Operands(u64),
    Any(u64),
}

/// A declaration and the way to expand it.
#[derive(Clone, Copy)]
pub(super) struct Subject<'a> {
    /// The name in the message of a stack overflow.
    pub(super) name: &'a str,
    pub(super) declaration: &'a str,
    /// The way to group tokens as if they came from other macros.
    pub(super) fragments: Fragments,
    /// Whether the declaration is expanded twice, to compare the results.
    pub(super) twice: bool,
}

/// An expansion without a defect.
#[derive(Clone, Debug)]
pub(super) struct Expansion {
    /// The first message, if the declaration was refused.
    pub(super) refusal: Option<String>,
    /// The number of tokens of the declaration.
    pub(super) read: usize,
    /// The number of operations of the solvers, including sensitivities.
    pub(super) operations: usize,
    work: Work,
}

impl Expansion {
    /// The look-ups, and the iterations of other loops, for each token read and each operation written.
    pub(super) fn rates(&self) -> [usize; 2] {
        let Work { look_ups, iterations } = self.work;
        [look_ups, iterations].map(|work| work / (self.read + self.operations).max(1))
    }
}

/// The positions of panics, by their messages. A panic that is passed from one thread to another loses its position.
static POSITIONS: Mutex<BTreeMap<String, String>> = Mutex::new(BTreeMap::new());

/// The prefixes of the names of two kinds of threads: those that expand declarations, and those on which the macro does
/// most of its work.
const THREADS: [&str; 2] = ["declaration", "kin"];

/// Records the position of a panic during an expansion without printing it.
fn remember_panics() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let others = panic::take_hook();
        panic::set_hook(Box::new(move |information| {
            let thread = thread::current();
            let name = thread.name().unwrap_or_default();
            if THREADS.iter().any(|known| name.starts_with(known)) {
                let words = words(information.payload());
                POSITIONS
                    .lock()
                    .expect("nothing panics")
                    .insert(words, information.to_string());
            } else {
                others(information);
            }
        }));
    });
}

fn words(panic: &dyn Any) -> String {
    let text = panic.downcast_ref::<&str>().map(|&words| words.to_owned());
    text.or_else(|| panic.downcast_ref().cloned()).unwrap_or_default()
}

/// The message of a panic and its position.
fn described(panic: &dyn Any) -> String {
    let words = words(panic);
    let positions = POSITIONS.lock().expect("nothing panics");
    positions.get(&words).cloned().unwrap_or(words)
}

/// The message about a text that the compiler itself refuses.
pub(super) const NO_TOKENS: &str = "it is no sequence of tokens";

/// Expands a declaration on a separate thread. An error is a defect of the macro, or [`NO_TOKENS`].
pub(super) fn expansion(subject: Subject<'_>) -> Result<Expansion, String> {
    remember_panics();
    let (sender, receiver) = mpsc::channel();
    let Subject {
        name,
        declaration,
        fragments,
        twice,
    } = subject;
    let declaration = declaration.to_owned();
    let thread = thread::Builder::new()
        .name(format!("declaration {name}"))
        .stack_size(STACK)
        .spawn(move || {
            let caught = panic::catch_unwind(AssertUnwindSafe(|| expanded(&declaration, fragments, twice)));
            let verdict = caught.unwrap_or_else(|panic| Err(described(&*panic)));
            // the receiver is gone if the expansion took too long
            let _ = sender.send(verdict);
        })
        .expect("a thread can be started");
    match receiver.recv_timeout(PATIENCE) {
        Ok(verdict) => verdict,
        Err(RecvTimeoutError::Timeout) => Err(format!("it takes longer than {PATIENCE:?}")),
        Err(RecvTimeoutError::Disconnected) => Err(format!("{:?}", thread.join())),
    }
}

fn expanded(declaration: &str, fragments: Fragments, twice: bool) -> Result<Expansion, String> {
    let Ok(mut tokens) = declaration.parse::<TokenStream>() else {
        return Err(NO_TOKENS.to_owned());
    };
    tokens = match fragments {
        Fragments::None => tokens,
        Fragments::Operands(seed) => with_operands_as_fragments(&mut Random::new(seed), tokens),
        Fragments::Any(seed) => with_fragments(&mut Random::new(seed), tokens),
    };
    let (read, order) = (count(&tokens), order(&tokens));
    let again = twice.then(|| tokens.clone());
    let (output, work) = work::of(|| expand(tokens));
    if again.is_some_and(|tokens| expand(tokens).to_string() != output.to_string()) {
        return Err("it expands to something else the second time".to_owned());
    }
    let (refusal, operations) = (message(&output), operations(&output));
    match syn::parse2::<syn::File>(output) {
        Ok(file) if file.items.is_empty() => return Err("it expands to nothing".to_owned()),
        Ok(_) => {}
        Err(error) => return Err(format!("the expansion is not a list of items: {error}")),
    }
    let expansion = Expansion {
        refusal,
        read,
        operations,
        work,
    };
    let is_within = |(rate, bound)| rate < bound;
    let bounds = bounds(expansion.refusal.is_some(), order);
    if expansion.rates().into_iter().zip(bounds).all(is_within) {
        Ok(expansion)
    } else {
        Err(format!("the work is out of bounds: `{expansion:?}`"))
    }
}

/// The number of all tokens, including those within groups.
fn count(tokens: &TokenStream) -> usize {
    tokens
        .clone()
        .into_iter()
        .map(|token| match token {
            TokenTree::Group(group) => 1 + count(&group.stream()),
            _ => 1,
        })
        .sum()
}

/// The first message to the user.
fn message(tokens: &TokenStream) -> Option<String> {
    let mut is_error = false;
    tokens.clone().into_iter().find_map(|token| match token {
        TokenTree::Ident(word) => {
            is_error = word == "compile_error";
            None
        }
        TokenTree::Group(group) if is_error => Some(group.stream().to_string()),
        TokenTree::Group(group) => message(&group.stream()),
        _ => None,
    })
}

/// The sum of the numbers in the constants of operations.
fn operations(tokens: &TokenStream) -> usize {
    let mut sum = 0;
    let mut tokens = tokens.clone().into_iter();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Group(group) => sum += operations(&group.stream()),
            TokenTree::Ident(word) if word == "const" => {
                let is_count =
                    matches!(tokens.next(), Some(TokenTree::Ident(name)) if name.to_string().ends_with("OPERATIONS"));
                if is_count {
                    let value = tokens
                        .by_ref()
                        .skip_while(|token| !matches!(token, TokenTree::Punct(sign) if sign.as_char() == '='))
                        .take_while(|token| !matches!(token, TokenTree::Punct(sign) if sign.as_char() == ';'));
                    sum += numbers(&value.collect());
                }
            }
            _ => {}
        }
    }
    sum
}

fn numbers(tokens: &TokenStream) -> usize {
    tokens
        .clone()
        .into_iter()
        .map(|token| match token {
            TokenTree::Literal(number) => number.to_string().parse().unwrap_or(0),
            TokenTree::Group(group) => numbers(&group.stream()),
            _ => 0,
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(declaration: &str) -> Result<Expansion, String> {
        expansion(Subject {
            name: "case",
            declaration,
            fragments: Fragments::None,
            twice: true,
        })
    }

    #[test]
    fn what_is_published_is_counted() {
        let expansion = of("struct M { a: Length } input t: Angle; unknown u: Length; u == a * cos(t); order = 1;");
        let expansion = expansion.expect("there is no defect");
        // u is a product after a cosine; its rate is a product of rate, length and sine with a change of sign
        assert_eq!((expansion.refusal, expansion.read, expansion.operations), (None, 29, 5));
        assert!(expansion.work.look_ups > 0);
    }

    #[test]
    fn the_bounds_of_a_refusal_grow_with_the_order() {
        let of = |declaration: &str| order(&declaration.parse().expect("these are tokens"));
        assert_eq!(of("struct M { order: Length } input t: Angle;"), 4);
        assert_eq!(of("struct M { a: Length } order = 2;"), 4);
        assert_eq!(of("struct M { a: Length } order = 12; input t: Angle;"), 12);
        assert_eq!(of("order = 99;"), 12);
        assert_eq!(bounds(true, 4), [1_000, 2_000]);
        assert_eq!(bounds(true, 12), [2_600, 5_200]);
        assert_eq!(bounds(false, 12), [100, 1_000]);
    }

    #[test]
    fn refusals_are_reported() {
        let refusal = of("struct M { a: Length }").map(|expansion| expansion.refusal);
        assert!(matches!(refusal, Ok(Some(message)) if message.contains("nothing is said of")));
        assert_eq!(of("struct M {").map(|_| ()), Err(NO_TOKENS.to_owned()));
    }
}
