//! A declaration as editors see it: a dead function with the user's names at their positions.
//!
//! The parameters, inputs and unknowns are its arguments, and every expression is the tuple of its operands. An editor
//! finds there what it completes, explains and follows. A build strips the function before it reads it.
//!
//! An editor completes a name by two expansions, one with the unfinished word and one with a longer one. It compares
//! their positions. So the text is made from the tokens alone, whether or not they can be read, and it stands first.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};

use crate::syntax::{Declaration, is_frame, is_function, is_keyword};

/// Statements without expressions.
const SILENT: [&str; 1] = ["order"];

/// Words between the expressions of a statement.
const BETWEEN: [&str; 4] = ["along", "on", "where", "in"];

/// The dead function.
pub(crate) fn tokens(declaration: &Declaration, runtime: &TokenStream) -> TokenStream {
    let mut known = BTreeSet::from(["PI".to_owned()]);
    let mut arguments = Vec::new();
    let statements: Vec<Vec<TokenTree>> = declaration.source.iter().map(trees).collect();
    let declares = |statement: &&Vec<TokenTree>| begins(statement, &["input", "unknown"]);
    let fields = declaration.fields.iter().map(trees);
    let quantities = statements
        .iter()
        .filter(declares)
        .flat_map(|statement| items(&statement[1..]));
    for item in fields.chain(quantities) {
        arguments.extend(argument(&item, &mut known));
    }
    let body: TokenStream = statements
        .iter()
        .map(|tokens| statement(tokens, &mut known, runtime))
        .collect();
    quote_spanned! {Span::mixed_site()=>
        #[allow(unexpected_cfgs, unused, non_snake_case)]
        const _: () = {
            #[cfg(rust_analyzer)]
            use #runtime::editor::*;
            #[cfg(rust_analyzer)]
            fn declaration(#(#arguments,)*) {
                #body
            }
        };
    }
}

fn trees(tokens: &TokenStream) -> Vec<TokenTree> {
    tokens.clone().into_iter().collect()
}

/// Whether a statement begins with one of these words, and is no equation.
fn begins(tokens: &[TokenTree], words: &[&str]) -> bool {
    let [TokenTree::Ident(word), rest @ ..] = tokens else {
        return false;
    };
    let goes_on = match rest {
        [TokenTree::Punct(hash), TokenTree::Group(_), ..] => hash.as_char() == '#',
        [TokenTree::Punct(_), ..] | [] => false,
        _ => true,
    };
    goes_on && words.iter().any(|known| word == known)
}

/// The tokens between commas.
fn items(tokens: &[TokenTree]) -> Vec<Vec<TokenTree>> {
    tokens
        .split(|token| is_punct(token, ','))
        .filter(|item| !item.is_empty())
        .map(<[TokenTree]>::to_vec)
        .collect()
}

fn is_punct(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}

/// A declared quantity as an argument of the function.
fn argument(item: &[TokenTree], known: &mut BTreeSet<String>) -> Option<TokenStream> {
    let colon = item.iter().position(|token| is_punct(token, ':'));
    let before = &item[..colon.unwrap_or(item.len())];
    let name = before.iter().rev().find_map(name)?;
    if !known.insert(name.to_string()) {
        return None;
    }
    let after = colon.and_then(|colon| item.get(colon + 1));
    let dimension = match after {
        Some(TokenTree::Ident(dimension)) if !is_keyword(&dimension.to_string()) => quote!(#dimension),
        _ => quote_spanned!(Span::mixed_site()=> Quantity),
    };
    Some(quote!(#name: #dimension))
}

fn name(token: &TokenTree) -> Option<&Ident> {
    match token {
        TokenTree::Ident(name) if name != "_" && !is_keyword(&name.to_string()) => Some(name),
        _ => None,
    }
}

/// The statements of a `for`, which know its names.
fn repetition(tokens: &[TokenTree], known: &BTreeSet<String>, runtime: &TokenStream) -> TokenStream {
    let of = |token: &TokenTree| match token {
        TokenTree::Group(group) => trees(&group.stream()),
        token => vec![token.clone()],
    };
    let list = tokens
        .iter()
        .position(|token| matches!(token, TokenTree::Ident(word) if word == "in"));
    let (names, rest) = tokens[1..].split_at(list.unwrap_or(tokens.len()) - 1);
    let (list, body) = match rest {
        [_, list, body, ..] => (of(list), of(body)),
        [_, list] => (of(list), Vec::new()),
        _ => (Vec::new(), Vec::new()),
    };
    let elements = operands(&list, known, runtime, 0);
    let mut known = known.clone();
    let names = names.iter().flat_map(of);
    let bindings = names.filter_map(|name| argument(&[name], &mut known));
    let bindings: TokenStream = bindings
        .map(|binding| quote_spanned!(Span::mixed_site()=> let #binding = formula(());))
        .collect();
    let statements = body.split(|token| is_punct(token, ';'));
    let statements = statements.map(|tokens| statement(tokens, &mut known, runtime));
    quote!({ (#elements); #bindings #(#statements)* })
}

/// A statement with its expressions.
fn statement(tokens: &[TokenTree], known: &mut BTreeSet<String>, runtime: &TokenStream) -> TokenStream {
    if begins(tokens, &["for"]) {
        return repetition(tokens, known, runtime);
    }
    if begins(tokens, &["input", "unknown"]) {
        let ranges = tokens
            .split(|token| is_punct(token, ','))
            .filter_map(|item| {
                let start = item.iter().position(begins_range)?;
                Some(operands(&item[start..], known, runtime, 0))
            })
            .collect::<TokenStream>();
        return if ranges.is_empty() { ranges } else { quote!((#ranges);) };
    }
    if begins(tokens, &["with"]) {
        let requests = tokens[1..].iter().filter_map(name);
        return quote_spanned!(Span::mixed_site()=> use #runtime::editor::requests::{#(#requests),*};);
    }
    if begins(tokens, &["let", "output"]) {
        let rest = &tokens[1..];
        let equals = rest.iter().position(|token| is_punct(token, '=')).unwrap_or(rest.len());
        let value = operands(&rest[equals..], known, runtime, 0);
        let Some(binding) = argument(&rest[..equals], known) else {
            return quote!((#value););
        };
        return quote_spanned!(Span::mixed_site()=> let #binding = formula((#value)););
    }
    let start = match tokens {
        [TokenTree::Ident(word), rest @ ..] if SILENT.iter().any(|known| word == known) && gives(rest) => tokens.len(),
        [TokenTree::Ident(word), TokenTree::Ident(_), colon, ..] if word == "body" && is_punct(colon, ':') => 2,
        _ if begins(tokens, &["ground", "slide"]) => 1,
        _ => 0,
    };
    let operands = operands(&tokens[start..], known, runtime, 0);
    quote!((#operands);)
}

fn begins_range(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Ident(word) if word == "where" || word == "in")
}

/// Whether `= 6` follows, and not `==`.
fn gives(rest: &[TokenTree]) -> bool {
    matches!(rest, [equals, next, ..] if is_punct(equals, '=') && !is_punct(next, '='))
}

/// The depth of parentheses below which nothing is completed. Each level becomes several here, and the compiler reads
/// them by recursion.
const DEEPEST: usize = 24;

/// The operands of an expression, each with a comma behind it.
fn operands(tokens: &[TokenTree], known: &BTreeSet<String>, runtime: &TokenStream, depth: usize) -> TokenStream {
    let mut written = TokenStream::new();
    if depth > DEEPEST {
        return written;
    }
    let mut rest = tokens;
    while let Some((token, after)) = rest.split_first() {
        rest = after;
        let mut operand = match token {
            TokenTree::Ident(word) if BETWEEN.iter().any(|known| word == known) || is_keyword(&word.to_string()) => {
                continue;
            }
            TokenTree::Ident(word) => match rest.first() {
                Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis => {
                    rest = &rest[1..];
                    let arguments = arguments(&group.stream(), known, runtime, depth + 1);
                    if is_function(&word.to_string()) || is_frame(&word.to_string()) {
                        quote!(#word(#arguments))
                    } else {
                        let named = named(word, known, runtime);
                        quote!((#named, #arguments))
                    }
                }
                _ => named(word, known, runtime),
            },
            TokenTree::Group(group) => {
                let inner = operands(&trees(&group.stream()), known, runtime, depth + 1);
                quote_spanned!(Span::mixed_site()=> formula::<_, Quantity>((#inner)))
            }
            TokenTree::Punct(_) | TokenTree::Literal(_) => continue,
        };
        // parts and methods
        while let [dot, TokenTree::Ident(member), after @ ..] = rest
            && is_punct(dot, '.')
            && !is_keyword(&member.to_string())
        {
            rest = after;
            operand.extend([dot.clone(), TokenTree::Ident(member.clone())]);
            if let [TokenTree::Group(group), after @ ..] = rest
                && group.delimiter() == Delimiter::Parenthesis
            {
                rest = after;
                let arguments = arguments(&group.stream(), known, runtime, depth + 1);
                operand.extend(quote!((#arguments)));
            }
        }
        written.extend(quote!(#operand,));
    }
    written
}

/// The arguments of a function, as one tuple.
fn arguments(tokens: &TokenStream, known: &BTreeSet<String>, runtime: &TokenStream, depth: usize) -> TokenStream {
    let arguments = items(&trees(tokens));
    let arguments = arguments
        .iter()
        .map(|argument| operands(argument, known, runtime, depth));
    quote!((#((#arguments),)*))
}

/// A name in an expression. An unknown one is declared behind its use, so that the editor adds no error to the macro's
/// own.
fn named(word: &Ident, known: &BTreeSet<String>, runtime: &TokenStream) -> TokenStream {
    if known.contains(&word.to_string()) {
        quote!(#word)
    } else {
        quote_spanned!(Span::mixed_site()=> { let value = #word; use #runtime::editor::UNDECLARED as #word; value })
    }
}
