//! The separation of the body into statements, before anything is parsed.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Group, Ident, Spacing, TokenStream, TokenTree};

use crate::mistakes::Mistakes;
use crate::syntax::name::{self, STATEMENT_WORDS};
use crate::syntax::{Dimension, picture, repetition, request};

/// The tokens of one statement without its `;`.
pub(crate) struct Chunk {
    pub(crate) tokens: TokenStream,
    /// Whether it ended in a `;`.
    pub(crate) terminated: bool,
}

impl Chunk {
    /// Whether it is a `for`.
    pub(crate) fn is_repetition(&self) -> bool {
        repetition::begins(&self.tokens.clone().into_iter().collect::<Vec<_>>())
    }
}

/// Cuts the body at every `;`. If a `;` is missing, cuts before a word that can only begin a statement.
pub(crate) fn statements(body: TokenStream, mistakes: &mut Mistakes) -> Vec<Chunk> {
    let tokens = visible_groups(body);
    let mut chunks = Vec::new();
    let mut current: Vec<TokenTree> = Vec::new();
    let mut finish = |current: &mut Vec<TokenTree>, terminated| {
        let tokens: TokenStream = current.drain(..).collect();
        if !tokens.is_empty() {
            chunks.push(Chunk { tokens, terminated });
        }
    };
    for (index, token) in tokens.iter().enumerate() {
        if is_punct(token, ';') {
            finish(&mut current, true);
            continue;
        }
        if repetition::is_body(token) && repetition::begins(&current) {
            current.push(token.clone());
            finish(&mut current, true);
            continue;
        }
        let attribute_count = trailing_attributes(&current);
        // after a `let` the word is a name
        let begins = begins_statement(&tokens[index..])
            || gives_order(&tokens[index..]) && ends_formula(&current) && !is_word(&current[..attribute_count], "let");
        if attribute_count > 0
            && begins
            && !is_word(&current[..attribute_count], "pub")
            && !is_word(&current[..attribute_count], request::WORD)
        {
            let after_item = is_item(&current[..attribute_count]);

            if !after_item {
                mistakes.error_at(
                    token.span(),
                    format!("a `;` is missing: write `;` before this `{token}`"),
                );
            }
            let attributes = current.split_off(attribute_count);
            finish(&mut current, true);
            current = attributes;
        }
        current.push(token.clone());
    }
    finish(&mut current, false);
    chunks
}

/// Cuts at the commas between fields, but not at commas within `<…>`.
pub(crate) fn fields(body: TokenStream) -> Vec<TokenStream> {
    let mut fields = vec![Vec::new()];
    let mut depth = 0_usize;
    for token in body {
        if is_punct(&token, '<') {
            depth += 1;
        } else if is_punct(&token, '>') {
            depth = depth.saturating_sub(1);
        }
        if depth == 0 && is_punct(&token, ',') {
            fields.push(Vec::new());
        } else if let Some(field) = fields.last_mut() {
            field.push(token);
        }
    }
    fields
        .into_iter()
        .filter(|field| !field.is_empty())
        .map(TokenStream::from_iter)
        .collect()
}

/// Adds all names that occur.
pub(crate) fn mentioned_names(tokens: &TokenStream, names: &mut BTreeSet<String>) {
    for token in tokens.clone() {
        match token {
            TokenTree::Ident(name) => {
                names.insert(name.to_string());
            }
            TokenTree::Group(group) => mentioned_names(&group.stream(), names),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

/// Adds the names that a statement or a field was probably meant to declare: those before a `:`, and those after its
/// first word, after `mut`, and after a dimension.
pub(crate) fn declared_names(tokens: &TokenStream, names: &mut BTreeSet<String>) {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    for pair in tokens.windows(2) {
        match pair {
            [TokenTree::Ident(word), TokenTree::Group(group)]
                if is_statement(word) || group.delimiter() == Delimiter::Brace =>
            {
                declared_names(&group.stream(), names);
            }
            [TokenTree::Ident(name), TokenTree::Punct(p)] if p.as_char() == ':' && p.spacing() == Spacing::Alone => {
                names.insert(name.to_string());
            }
            [TokenTree::Ident(word), TokenTree::Ident(declared)]
                if is_statement(word) || word == "mut" || Dimension::is_word(&word.to_string()) =>
            {
                names.insert(declared.to_string());
            }
            _ => {}
        }
    }
    // a definition behind a word of another language, as in `point pin = …`
    if let [TokenTree::Ident(_), TokenTree::Ident(declared), equals, ..] = tokens.as_slice()
        && is_punct(equals, '=')
    {
        names.insert(declared.to_string());
    }
}

fn is_statement(word: &Ident) -> bool {
    STATEMENT_WORDS.contains(&word.to_string().as_str())
}

/// The name before the first `:`, whatever stands before it.
pub(crate) fn name_before_colon(tokens: &TokenStream) -> Option<Ident> {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    tokens.windows(2).find_map(|pair| match pair {
        [TokenTree::Ident(name), colon] if is_punct(colon, ':') && !name::keyword(&name.to_string()) => {
            Some(name.clone())
        }
        _ => None,
    })
}

/// Removes groups without delimiters, which come from fragments of other macros. A single token needs no group; several
/// stay together in parentheses.
fn visible_groups(tokens: TokenStream) -> Vec<TokenTree> {
    let mut visible = Vec::new();
    for token in tokens {
        match token {
            TokenTree::Group(group) if has_invisible_groups(&group) => {
                let mut inner = visible_groups(group.stream());
                let delimiter = match group.delimiter() {
                    Delimiter::None if inner.len() <= 1 => {
                        visible.append(&mut inner);
                        continue;
                    }
                    Delimiter::None => Delimiter::Parenthesis,
                    delimiter => delimiter,
                };
                let mut regrouped = Group::new(delimiter, inner.into_iter().collect());
                regrouped.set_span(group.span());
                visible.push(TokenTree::Group(regrouped));
            }
            token => visible.push(token),
        }
    }
    visible
}

fn has_invisible_groups(group: &Group) -> bool {
    group.delimiter() == Delimiter::None
        || group
            .stream()
            .into_iter()
            .any(|token| matches!(token, TokenTree::Group(inner) if has_invisible_groups(&inner)))
}

/// The index where the attributes at the end of a statement begin. If the statement ends there, they belong to the next
/// one.
fn trailing_attributes(tokens: &[TokenTree]) -> usize {
    let mut end = tokens.len();
    while let [.., hash, TokenTree::Group(group)] = &tokens[..end]
        && is_punct(hash, '#')
        && group.delimiter() == Delimiter::Bracket
    {
        end -= 2;
    }
    end
}

/// Whether the tokens begin with `let`, with another of the words followed by a name and a colon, or with `with`
/// followed by names alone.
fn begins_statement(tokens: &[TokenTree]) -> bool {
    match tokens {
        [TokenTree::Ident(word), TokenTree::Ident(_), rest @ ..] => {
            let word = word.to_string();
            word == "let"
                || (STATEMENT_WORDS.contains(&word.as_str()) || word == picture::BODY)
                    && rest.first().is_some_and(|token| is_punct(token, ':'))
                || word == request::WORD
                    && rest
                        .first()
                        .is_none_or(|token| is_punct(token, ',') || is_punct(token, ';'))
        }
        _ => false,
    }
}

/// Whether the tokens begin with `order =`, but not `order ==`.
fn gives_order(tokens: &[TokenTree]) -> bool {
    matches!(tokens, [TokenTree::Ident(word), TokenTree::Punct(equals), ..]
        if word == "order" && equals.as_char() == '=' && equals.spacing() == Spacing::Alone)
}

/// Whether the tokens are one word alone.
fn is_word(tokens: &[TokenTree], expected: &str) -> bool {
    matches!(tokens, [TokenTree::Ident(word)] if word == expected)
}

/// Whether the tokens are an item of Rust that ends without a `;`.
fn is_item(tokens: &[TokenTree]) -> bool {
    matches!(tokens, [TokenTree::Ident(word), .., TokenTree::Group(group)]
        if name::keyword(&word.to_string()) && group.delimiter() == Delimiter::Brace)
}

/// Whether a formula may be complete here: it is not after an operator.
fn ends_formula(tokens: &[TokenTree]) -> bool {
    !matches!(tokens.last(), Some(TokenTree::Punct(_)))
}

fn is_punct(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}
