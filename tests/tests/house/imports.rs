//! Which module names which: every path of a crate's source that begins with `crate` or `super`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Attribute, ImplItem, Item, Meta, Visibility};

/// A source file without its tests.
pub(crate) struct Source {
    /// Its path below `src`, with `/`.
    pub(crate) file: String,
    /// The module that it is, without `crate`.
    module: Vec<String>,
    pub(crate) tokens: TokenStream,
    /// The types that it declares, outside of functions.
    pub(crate) types: Vec<Type>,
    /// The lines that are neither blank nor comments nor tests.
    pub(crate) lines: usize,
}

/// The declaration of a type or a trait.
pub(crate) struct Type {
    pub(crate) name: String,
    /// Whether other files may name it.
    pub(crate) is_shared: bool,
}

/// All source files of a crate that are compiled outside of tests, in alphabetical order.
pub(crate) fn sources(src: &Path) -> Vec<Source> {
    let mut files = Vec::new();
    list(src, &mut files);
    files.sort();
    let mut tests = BTreeSet::new();
    let mut sources: Vec<Source> = files.iter().map(|path| read(src, path, &mut tests)).collect();
    sources.retain(|source| !(0..=source.module.len()).any(|end| tests.contains(&source.module[..end])));
    sources
}

fn list(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the source is there") {
        let path = entry.expect("it can be listed").path();
        if path.is_dir() {
            list(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// Reads a file, and adds the modules that it declares for tests alone to `tests`.
fn read(src: &Path, path: &Path, tests: &mut BTreeSet<Vec<String>>) -> Source {
    let file = path
        .strip_prefix(src)
        .expect("a file of the source")
        .to_string_lossy()
        .replace('\\', "/");
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{file}: {error}"));
    let mut parsed = syn::parse_file(&text).unwrap_or_else(|error| panic!("{file}: {error}"));
    let module = module(&file);
    strip(&mut parsed.items, &module, tests);
    Source {
        lines: lines(&text),
        module,
        types: types(&parsed.items),
        tokens: parsed.items.iter().map(ToTokens::to_token_stream).collect(),
        file,
    }
}

/// The module of a file: `a/b.rs` and `a/b/mod.rs` are `a::b`, `lib.rs` is the root.
fn module(file: &str) -> Vec<String> {
    let path = file.strip_suffix(".rs").expect("a file of Rust");
    let mut segments: Vec<String> = path.split('/').map(ToOwned::to_owned).collect();
    if matches!(segments.last().map(String::as_str), Some("mod" | "lib")) {
        segments.pop();
    }
    segments
}

/// Leaves out what is compiled for tests alone.
fn strip(items: &mut Vec<Item>, module: &[String], tests: &mut BTreeSet<Vec<String>>) {
    items.retain(|item| {
        let is_test = is_for_tests(attributes(item));
        if is_test && let Item::Mod(own) = item {
            let mut name = module.to_vec();
            name.push(own.ident.to_string());
            tests.insert(name);
        }
        !is_test
    });
    for item in items {
        match item {
            Item::Mod(own) => {
                let mut name = module.to_vec();
                name.push(own.ident.to_string());
                if let Some((_, inner)) = &mut own.content {
                    strip(inner, &name, tests);
                }
            }
            Item::Impl(own) => own.items.retain(|item| match item {
                ImplItem::Fn(method) => !is_for_tests(&method.attrs),
                ImplItem::Const(constant) => !is_for_tests(&constant.attrs),
                _ => true,
            }),
            _ => {}
        }
    }
}

/// The types and traits among the items of a file, and of the modules in it.
fn types(items: &[Item]) -> Vec<Type> {
    let mut types = Vec::new();
    for item in items {
        let (name, visibility) = match item {
            Item::Enum(item) => (&item.ident, &item.vis),
            Item::Struct(item) => (&item.ident, &item.vis),
            Item::Trait(item) => (&item.ident, &item.vis),
            Item::Type(item) => (&item.ident, &item.vis),
            Item::Mod(item) => {
                types.extend(item.content.iter().flat_map(|(_, inner)| self::types(inner)));
                continue;
            }
            _ => continue,
        };
        types.push(Type {
            name: name.to_string(),
            is_shared: !matches!(visibility, Visibility::Inherited),
        });
    }
    types
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) if list.path.is_ident("cfg") => list.tokens.to_string() == "test",
        _ => false,
    })
}

/// The lines of code of a file up to its tests, which stand at its end.
fn lines(text: &str) -> usize {
    let code = text.split("\n#[cfg(test)]\nmod tests {").next().unwrap_or(text);
    let is_code = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with("//");
    code.lines().filter(is_code).count()
}

/// The thing that a path names.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Target<'s> {
    /// A module, by its file.
    File(&'s str),
    /// An item at the root of the crate: a declaration there, or a re-export.
    Root,
}

/// The targets of all paths of each file, by the names of the files. The path as it is written stands beside its target.
pub(crate) fn targets(sources: &[Source]) -> BTreeMap<&str, BTreeSet<(Target<'_>, String)>> {
    let modules: BTreeMap<&[String], &str> = sources
        .iter()
        .map(|source| (source.module.as_slice(), source.file.as_str()))
        .collect();
    let targets = sources.iter().map(|source| {
        let mut paths = BTreeSet::new();
        collect(source.tokens.clone(), &source.module, &mut paths);
        let found = paths.into_iter().map(|path| (target(&modules, &path), path.join("::")));
        (source.file.as_str(), found.collect())
    });
    targets.collect()
}

/// The deepest module on a path.
fn target<'s>(modules: &BTreeMap<&[String], &'s str>, path: &[String]) -> Target<'s> {
    let deepest = (1..=path.len()).rev().find_map(|end| modules.get(&path[..end]));
    deepest.map_or(Target::Root, |file| Target::File(file))
}

/// Adds the paths of a stream of tokens, arguments of macros included, as seen from the root of the crate.
fn collect(tokens: TokenStream, module: &[String], paths: &mut BTreeSet<Vec<String>>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut place = 0;
    while place < tokens.len() {
        match &tokens[place] {
            TokenTree::Ident(word) if word == "mod" => {
                if let [TokenTree::Ident(name), TokenTree::Group(body), ..] = &tokens[place + 1..] {
                    let mut inner = module.to_vec();
                    inner.push(name.to_string());
                    collect(body.stream(), &inner, paths);
                    place += 2;
                }
            }
            // A statement that is compiled for tests alone.
            TokenTree::Punct(mark) if mark.as_char() == '#' && is_test(tokens.get(place + 1)) => {
                let ends = |token: &TokenTree| match token {
                    TokenTree::Punct(mark) => mark.as_char() == ';',
                    TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
                    _ => false,
                };
                place += tokens[place..].iter().position(ends).unwrap_or(tokens.len() - place);
            }
            // `pub(crate)` has no path behind it.
            TokenTree::Ident(word) if (word == "crate" || word == "super") && is_colons(&tokens[place + 1..]) => {
                let base = if word == "crate" { Vec::new() } else { above(module) };
                place = follow(&tokens, place + 3, base, paths);
                continue;
            }
            TokenTree::Group(group) => collect(group.stream(), module, paths),
            _ => {}
        }
        place += 1;
    }
}

fn is_test(attribute: Option<&TokenTree>) -> bool {
    matches!(attribute, Some(TokenTree::Group(group)) if group.stream().to_string().replace(' ', "") == "cfg(test)")
}

fn above(module: &[String]) -> Vec<String> {
    module[..module.len().saturating_sub(1)].to_vec()
}

fn is_colons(tokens: &[TokenTree]) -> bool {
    matches!(tokens, [TokenTree::Punct(one), TokenTree::Punct(two), ..] if one.as_char() == ':' && two.as_char() == ':')
}

/// Adds the path, or the tree of paths, that goes on at a place, and returns the place behind it.
fn follow(tokens: &[TokenTree], mut place: usize, mut path: Vec<String>, paths: &mut BTreeSet<Vec<String>>) -> usize {
    loop {
        match tokens.get(place) {
            Some(TokenTree::Ident(word)) => {
                if word == "super" {
                    path.pop();
                } else if word != "self" {
                    path.push(word.to_string());
                }
                place += 1;
                if !is_colons(&tokens[place..]) {
                    break;
                }
                place += 2;
            }
            Some(TokenTree::Group(group)) => {
                let tree: Vec<TokenTree> = group.stream().into_iter().collect();
                let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(mark) if mark.as_char() == ',');
                for branch in tree.split(is_comma).filter(|branch| !branch.is_empty()) {
                    follow(branch, 0, path.clone(), paths);
                }
                return place + 1;
            }
            // A star, or the `<` of a turbofish.
            _ => break,
        }
    }
    paths.insert(path);
    place
}

#[cfg(test)]
mod tests {
    use super::{collect, module, strip};
    use quote::ToTokens;
    use std::collections::BTreeSet;

    fn found(file: &str, code: &str) -> Vec<String> {
        let mut parsed = syn::parse_str::<syn::File>(code).expect("the code is Rust");
        let (module, mut tests, mut paths) = (module(file), BTreeSet::new(), BTreeSet::new());
        strip(&mut parsed.items, &module, &mut tests);
        collect(parsed.to_token_stream(), &module, &mut paths);
        let tests = tests.iter().map(|path| format!("test {}", path.join("::")));
        paths.iter().map(|path| path.join("::")).chain(tests).collect()
    }

    #[test]
    fn paths_are_found_wherever_they_stand() {
        let trees = "use crate::{a::{self, B, c::*}, d}; pub(crate) use super::{e, super::f};";
        assert_eq!(found("x/y/z.rs", trees), ["a", "a::B", "a::c", "d", "x::f", "x::y::e"]);
        let code =
            "fn f(x: crate::a::B<crate::c::D>) -> u8 { g!(1, [super::h, super::super::i]); crate::j::k::<u8>() }";
        assert_eq!(found("x/y.rs", code), ["a::B", "c::D", "i", "j::k", "x::h"]);
        assert_eq!(
            found("x/mod.rs", "macro_rules! m { () => { $crate::a::B }; }"),
            ["a::B"]
        );
        assert_eq!(
            found("x/y.rs", "mod own { use super::a; use super::super::b; }"),
            ["x::b", "x::y::a"]
        );
    }

    #[test]
    fn tests_are_left_out() {
        let code = "#[cfg(test)] use crate::a; #[cfg(test)] mod tests; #[cfg(test)] mod inner { use crate::b; } \
                    impl X { #[cfg(test)] fn f() { crate::c() } #[cfg(unix)] fn g() { crate::d() } }";
        assert_eq!(found("x/mod.rs", code), ["d", "test x::inner", "test x::tests"]);
        let body = "fn f() { #[cfg(test)] crate::a::b(1); crate::c(); #[cfg(test)] { crate::d() } crate::e() }";
        assert_eq!(found("x.rs", body), ["c", "e"]);
    }
}
