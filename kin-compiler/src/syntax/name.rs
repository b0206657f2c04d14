//! The names that quantities may have.

use proc_macro2::{Ident, Span};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Token, token};

use crate::syntax::callee::is_function;

/// Words that begin a statement.
pub(crate) const STATEMENT_WORDS: [&str; 4] = ["input", "unknown", "let", "output"];

const KEYWORDS: [&str; 52] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod",
    "move", "mut", "override", "priv", "pub", "ref", "return", "self", "Self", "static", "struct", "super", "trait",
    "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Whether Rust reserves this word.
pub(crate) fn keyword(word: &str) -> bool {
    KEYWORDS.contains(&word)
}

/// Reads the name of a quantity that is being declared. If the name is missing, the message says `what` is declared. At
/// the end of the source, which has no position, the mistake is reported at the token `before`.
pub(crate) fn parse(input: ParseStream<'_>, what: &str, before: Span) -> Result<Ident> {
    if input.is_empty() {
        return Err(syn::Error::new(
            before,
            format!("the name of the {what} is missing after this"),
        ));
    }
    if input.peek(Token![:]) {
        return Err(input.error(format!("the name of the {what} comes first: remove this `:`")));
    }
    if input.peek(token::Paren) || input.peek(token::Brace) || input.peek(token::Bracket) {
        return Err(input.error(format!("the name of the {what} stands without brackets: remove them")));
    }
    if !input.peek(Ident::peek_any) {
        return Err(input.error(format!("expected the name of the {what} here")));
    }
    let name = Ident::parse_any(input)?;
    check(&name)?;
    Ok(name)
}

/// Whether a quantity may have this name.
pub(crate) fn check(name: &Ident) -> Result<()> {
    let word = name.to_string();
    let complaint = if word.starts_with("r#") {
        format!("`{word}` is a raw identifier; choose a plain name")
    } else if word.chars().all(|letter| letter == '_') {
        format!("`{word}` is not a name; choose one with a letter in it")
    } else if STATEMENT_WORDS.contains(&word.as_str()) && word != "let" {
        format!("`{word}` begins a statement of the declaration language; choose another name")
    } else if keyword(&word) {
        format!("`{word}` is a keyword of Rust; choose another name")
    } else if word == "PI" {
        "`PI` is the number π of the declaration language; choose another name".to_owned()
    } else if is_function(&word) {
        format!("`{word}` is a function of the declaration language; choose another name")
    } else {
        return Ok(());
    };
    Err(syn::Error::new(name.span(), complaint))
}
