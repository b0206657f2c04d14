//! `for (base, joint) in [(b1, p1), (b2, p2)] { … }`: statements that are repeated, each time with other names.
//!
//! The copies are statements like all others. So no later pass knows of repetition, but for one question: whether all
//! elements are of one kind.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Attribute, Token, braced, bracketed, parenthesized, token};

use crate::mistakes::{Extent, Mistakes};
use crate::syntax::formula::{self, Context};
use crate::syntax::{Declaration, FormulaKind, Statement, TypedFormula, name, split};
use crate::work;

const WORD: &str = "for";

const FORM: &str = "write `for (base, joint) in [(b1, p1), (b2, p2)] { … }`";

/// A `for` that has been read.
pub(super) struct Repetition {
    /// Its names.
    names: Vec<Ident>,
    /// The names that its body abbreviates by.
    locals: Vec<Ident>,
}

/// What stands before the body.
struct Head {
    names: Vec<Ident>,
    in_tuples: bool,
    list: TokenStream,
    list_extent: Extent,
    body: TokenStream,
    extent: Extent,
}

/// An element of the list: a value for each name.
type Element = Vec<TypedFormula>;

/// Whether the tokens begin a `for`, after doc comments.
pub(super) fn begins(tokens: &[TokenTree]) -> bool {
    let first = tokens.iter().find(|token| match token {
        TokenTree::Punct(hash) => hash.as_char() != '#',
        TokenTree::Group(group) => group.delimiter() != Delimiter::Bracket,
        TokenTree::Ident(_) | TokenTree::Literal(_) => true,
    });
    matches!(first, Some(TokenTree::Ident(word)) if word == WORD)
}

/// Whether a token may be the body of a `for`.
pub(super) fn is_body(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
}

/// Reads a `for` and adds its copies to the statements.
pub(super) fn read(tokens: &TokenStream, declaration: &mut Declaration, mistakes: &mut Mistakes) -> Option<Repetition> {
    let head = match head.parse2(tokens.clone()) {
        Ok(head) => head,
        Err(error) => {
            mistakes.push(error);
            declaration.poison(tokens);
            return None;
        }
    };
    mistakes.tell_once_within(tokens);
    let elements = elements(&head, mistakes);
    let complete = std::mem::replace(&mut declaration.complete, true);
    let body = body(&head.body, declaration, mistakes);
    let readable = declaration.complete;
    declaration.complete &= complete;
    if body.is_empty() && readable {
        mistakes.error_at(
            head.extent.last,
            "nothing is repeated here: write equations between these braces",
        );
        declaration.complete = false;
    }
    let locals: Vec<Ident> = body.iter().filter_map(local).cloned().collect();
    for name in head.names.iter().chain(&locals) {
        declaration.fresh.keep_inside(name);
    }
    let Some(elements) = elements.filter(|_| are_known_once(&head.names, &locals, mistakes)) else {
        declaration.poison(tokens);
        return None;
    };
    let used = used(body.clone());
    if readable && !body.is_empty() {
        for name in head.names.iter().filter(|name| !used.all.contains(&name.to_string())) {
            mistakes.error(
                name,
                format!("`{name}` is never used in this `for`: use it, or remove it here and from the list"),
            );
            declaration.complete = false;
        }
    }
    let columns = (0..head.names.len()).filter(|column| used.in_formulas.contains(&head.names[*column].to_string()));
    let columns = columns.map(|column| elements.iter().map(|element| element[column].clone()).collect());
    declaration.statements.push(Statement::Repeats(columns.collect()));
    for element in &elements {
        let local_names: BTreeMap<String, Ident> = locals
            .iter()
            .map(|local| (local.to_string(), declaration.fresh.copy_of(local)))
            .collect();
        let copy = Copy {
            names: &head.names,
            element,
            local_names: &local_names,
        };
        for statement in &body {
            if work::is_spent() {
                break;
            }
            match copy.of(statement.clone()) {
                Ok(statement) => declaration.statements.push(statement),
                Err(error) => {
                    mistakes.push(error);
                    declaration.complete = false;
                }
            }
        }
    }
    declaration.statements.push(Statement::Repeated);
    Some(Repetition {
        names: head.names,
        locals,
    })
}

/// Reports names of a `for` that mean something outside of it.
pub(super) fn check_names(repetitions: &[Repetition], declaration: &mut Declaration, mistakes: &mut Mistakes) {
    if repetitions.is_empty() {
        return;
    }
    let mut outer = declaration.quantity_names();
    outer.extend(declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Frame(frame) => Some(frame.name.to_string()),
        _ => None,
    }));
    for repetition in repetitions {
        for name in repetition.names.iter().chain(&repetition.locals) {
            if outer.contains(&name.to_string()) {
                mistakes.error(
                    name,
                    format!("`{name}` means something outside of this `for`: choose another name here"),
                );
                declaration.mentioned.insert(name.to_string());
                declaration.complete = false;
            }
        }
    }
}

fn head(input: ParseStream<'_>) -> Result<Head> {
    if let Some(attribute) = input.call(Attribute::parse_outer)?.first() {
        return Err(syn::Error::new_spanned(
            attribute,
            "a `for` has no documentation: write `//` here, and `///` before the outputs in it",
        ));
    }
    let word = Ident::parse_any(input)?.span();
    let in_tuples = input.peek(token::Paren);
    let names = if in_tuples {
        let content;
        let parentheses = parenthesized!(content in input);
        let mut names = Vec::new();
        while !content.is_empty() {
            names.push(name::parse(&content, "`for`", word)?);
            if !content.is_empty() {
                content
                    .parse::<Option<Token![,]>>()?
                    .ok_or_else(|| content.error("the names of a `for` stand between commas, as in `(base, joint)`"))?;
            }
        }
        if names.is_empty() {
            return Err(syn::Error::new(
                parentheses.span.open(),
                format!("this `for` has no names: {FORM}"),
            ));
        }
        names
    } else {
        vec![name::parse(input, "`for`", word)?]
    };
    expect(
        input,
        word,
        input.peek(Token![in]),
        "the names of a `for` are followed by `in`",
    )?;
    input.parse::<Token![in]>()?;
    expect(
        input,
        word,
        input.peek(token::Bracket),
        "a `for` goes through a list in brackets",
    )?;
    let content;
    let brackets = bracketed!(content in input);
    let list = content.parse()?;
    expect(
        input,
        word,
        input.peek(token::Brace),
        "a list is followed by the statements to repeat, in braces",
    )?;
    let content;
    let braces = braced!(content in input);
    Ok(Head {
        names,
        in_tuples,
        list,
        list_extent: Extent {
            first: brackets.span.open(),
            last: brackets.span.close(),
        },
        body: content.parse()?,
        extent: Extent {
            first: word,
            last: braces.span.close(),
        },
    })
}

fn expect(input: ParseStream<'_>, word: Span, is_there: bool, message: &str) -> Result<()> {
    if is_there {
        return Ok(());
    }
    let message = format!("{message}: {FORM}");
    Err(if input.is_empty() {
        syn::Error::new(word, message)
    } else {
        input.error(message)
    })
}

/// The elements of the list, `None` after a mistake.
fn elements(head: &Head, mistakes: &mut Mistakes) -> Option<Vec<Element>> {
    let mut elements = Vec::new();
    let mut is_sound = true;
    for tokens in split::fields(head.list.clone()) {
        match (|input: ParseStream<'_>| element(input, head)).parse2(tokens) {
            Ok(element) => elements.push(element),
            Err(error) => {
                mistakes.push(error);
                is_sound = false;
            }
        }
    }
    if elements.is_empty() && is_sound {
        mistakes.error(
            head.list_extent,
            "this list is empty, so nothing is repeated: write an element for each copy",
        );
        return None;
    }
    is_sound.then_some(elements)
}

fn element(input: ParseStream<'_>, head: &Head) -> Result<Element> {
    let tuple: Option<TokenTree> = input.fork().parse().ok();
    let parts = match &tuple {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis => {
            split::fields(group.stream()).len()
        }
        _ => 1,
    };
    let names = head.names.len();
    if head.in_tuples && !input.peek(token::Paren) || parts != names && (head.in_tuples || parts > 1) {
        let wanted: Vec<String> = head.names.iter().map(Ident::to_string).collect();
        let form = if head.in_tuples {
            format!("({})", wanted.join(", "))
        } else {
            wanted.concat()
        };
        let count = |count, noun| format!("{count} {noun}{}", if count == 1 { "" } else { "s" });
        return Err(syn::Error::new_spanned(
            Extent::at(input.span()),
            format!(
                "this element has {}, and the `for` has {}: write a value for each of `{form}`",
                count(parts, "value"),
                count(names, "name")
            ),
        ));
    }
    if !head.in_tuples {
        return Ok(vec![formula::parse(input, Context::Argument)?]);
    }
    let content;
    parenthesized!(content in input);
    let mut values = Vec::new();
    while !content.is_empty() {
        values.push(formula::parse(&content, Context::Argument)?);
        content.parse::<Option<Token![,]>>()?;
    }
    if !input.is_empty() {
        return Err(input.error("unexpected behind an element: write `,` before another one"));
    }
    Ok(values)
}

/// The statements that are repeated. Those that cannot be are mistakes.
fn body(tokens: &TokenStream, declaration: &mut Declaration, mistakes: &mut Mistakes) -> Vec<Statement> {
    let mut statements = Vec::new();
    for chunk in split::statements(tokens.clone(), mistakes) {
        let (what, advice) = if chunk.is_repetition() {
            ("another `for`", "write it behind this one, or one list of all pairs")
        } else {
            let statement = declaration.statement(&chunk, mistakes);
            match &statement {
                Some(Statement::Inputs(_)) => ("an input", "declare all of them there, `input a1: Angle, a2: Angle;`"),
                Some(Statement::Unknowns(_)) => (
                    "an unknown",
                    "declare all of them there, `unknown a1: Angle, a2: Angle;`",
                ),
                Some(Statement::Order(_)) => ("the order", "it is that of the whole mechanism"),
                Some(Statement::Requests(_)) => ("a request", "it is one of the whole mechanism"),
                _ => {
                    statements.extend(statement);
                    continue;
                }
            }
        };
        let first = chunk.tokens.clone().into_iter().next();
        mistakes.error_at(
            first.map_or_else(Span::call_site, |token| token.span()),
            format!("{what} stands outside of a `for`: {advice}"),
        );
        declaration.poison(&chunk.tokens);
    }
    statements
}

/// The name that a statement abbreviates by.
fn local(statement: &Statement) -> Option<&Ident> {
    match statement {
        Statement::Let(statement) => Some(&statement.name),
        Statement::Frame(statement) => Some(&statement.name),
        _ => None,
    }
}

/// Whether no name of a `for` stands for two things.
fn are_known_once(names: &[Ident], locals: &[Ident], mistakes: &mut Mistakes) -> bool {
    let mut known = BTreeSet::new();
    let mut once = true;
    for name in names.iter().chain(locals) {
        if !known.insert(name.to_string()) {
            mistakes.error(
                name,
                format!("`{name}` is declared twice in this `for`: choose another name"),
            );
            once = false;
        }
    }
    once
}

/// The names that a body uses.
struct Used {
    all: BTreeSet<String>,
    /// Those in formulas outside of the picture.
    in_formulas: BTreeSet<String>,
}

fn used(body: Vec<Statement>) -> Used {
    let (mut all, mut in_formulas) = (BTreeSet::new(), BTreeSet::new());
    for mut statement in body {
        match &statement {
            Statement::Output(output) => drop(all.insert(output.name.to_string())),
            Statement::Body(body) => drop(all.insert(body.name.to_string())),
            Statement::Slide(slide) => all.extend(slide.guide.iter().map(Ident::to_string)),
            _ => {}
        }
        let is_drawn = matches!(
            statement,
            Statement::Body(_) | Statement::Ground(_) | Statement::Slide(_)
        );
        for formula in statement.formulas() {
            formula.visit_names(&mut |name| {
                all.insert(name.to_string());
                if !is_drawn {
                    in_formulas.insert(name.to_string());
                }
            });
        }
    }
    Used { all, in_formulas }
}

/// One copy of a body.
struct Copy<'a> {
    names: &'a [Ident],
    element: &'a [TypedFormula],
    /// The names of the abbreviations of the copy.
    local_names: &'a BTreeMap<String, Ident>,
}

impl Copy<'_> {
    fn of(&self, mut statement: Statement) -> Result<Statement> {
        for formula in statement.formulas() {
            *formula = formula.with_names(&|name| self.meaning(name))?;
        }
        let rename = |name: &mut Ident| {
            if let Some(renamed) = self.local_names.get(&name.to_string()) {
                *name = renamed.clone();
            }
        };
        match &mut statement {
            Statement::Let(statement) => rename(&mut statement.name),
            Statement::Equation(equation) => equation.is_copy = true,
            Statement::Frame(statement) => rename(&mut statement.name),
            Statement::Output(output) => {
                output.name = self.label(&output.name, "an output")?;
                name::check(&output.name)?;
            }
            Statement::Body(body) => body.name = self.label(&body.name, "a body")?,
            Statement::Slide(slide) => {
                if let Some(guide) = &mut slide.guide
                    && self.value(guide).is_some()
                {
                    *guide = self.label(guide, "a body")?;
                }
            }
            _ => {}
        }
        Ok(statement)
    }

    /// The value that stands for a name of the `for`.
    fn value(&self, name: &Ident) -> Option<&TypedFormula> {
        let index = self.names.iter().position(|known| known == name)?;
        self.element.get(index)
    }

    fn meaning(&self, name: &Ident) -> Option<TypedFormula> {
        if let Some(value) = self.value(name) {
            return value.clone().grouped().ok();
        }
        let mut renamed = self.local_names.get(&name.to_string())?.clone();
        renamed.set_span(name.span());
        TypedFormula::new(FormulaKind::Name(renamed), Extent::at(name.span())).ok()
    }

    /// What stands for the name of an output or a body.
    fn label(&self, name: &Ident, what: &str) -> Result<Ident> {
        match self.value(name).map(|value| (&value.kind, value.extent)) {
            Some((FormulaKind::Name(label), _)) => Ok(label.clone()),
            Some((_, extent)) => Err(syn::Error::new_spanned(
                extent,
                format!("`{name}` is {what} here: write the name that it has in this copy"),
            )),
            None => Err(syn::Error::new(
                name.span(),
                format!(
                    "each copy needs {what} of its own: let the `for` give its name, as in `for {name} in [{name}1, \
                     {name}2]`"
                ),
            )),
        }
    }
}
