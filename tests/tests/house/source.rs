//! The source of a package as tokens, without what is compiled for tests alone.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// A path of modules below the root of a crate.
pub(crate) type Module = Vec<String>;

/// A source file: `a/b.rs` and `a/b/mod.rs` are the module `a::b`.
pub(crate) struct Source {
    pub(crate) file: String,
    pub(crate) module: Module,
    /// Comments are none of them.
    pub(crate) tokens: TokenStream,
    /// The lines that are neither blank nor comments nor tests.
    pub(crate) lines: usize,
}

/// All files of a folder but those of tests, which are called so or are declared so in `mod.rs`.
pub(crate) fn sources(folder: &Path) -> Vec<Source> {
    let mut sources = Vec::new();
    add(folder, &[], &mut sources);
    sources
}

fn add(folder: &Path, module: &[String], sources: &mut Vec<Source>) {
    let parent = fs::read_to_string(folder.join("mod.rs")).unwrap_or_default();
    for entry in fs::read_dir(folder).expect("the source is there") {
        let path = entry.expect("it can be listed").path();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let is_declared_so = ["", "pub(crate) "].map(|shared| format!("#[cfg(test)]\n{shared}mod {name};\n"));
        if matches!(name.as_str(), "tests" | "testing")
            || name.ends_with("_tests")
            || is_declared_so.iter().any(|line| parent.contains(line))
        {
            continue;
        }
        let own = if name == "mod" {
            module.to_vec()
        } else {
            [module, &[name]].concat()
        };
        if path.is_dir() {
            add(&path, &own, sources);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path).expect("a file of text");
            let code = text.split("\n#[cfg(test)]\nmod tests {").next().unwrap_or(&text);
            let is_code = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with("//");
            sources.push(Source {
                file: path.to_string_lossy().into_owned(),
                module: own,
                lines: code.lines().filter(is_code).count(),
                tokens: without_tests(
                    text.parse()
                        .unwrap_or_else(|error| panic!("{}: {error}", path.display())),
                ),
            });
        }
    }
}

/// Leaves out each item and each statement behind `#[cfg(test)]`.
fn without_tests(tokens: TokenStream) -> TokenStream {
    let ends = |token: &TokenTree| match token {
        TokenTree::Punct(mark) => mark.as_char() == ';',
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        _ => false,
    };
    let mut tokens = tokens.into_iter();
    let mut kept = Vec::new();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Group(group) if is_cfg_test(&group) => {
                kept.pop();
                tokens.find(ends);
            }
            TokenTree::Group(group) => {
                let inner = without_tests(group.stream());
                kept.push(Group::new(group.delimiter(), inner).into());
            }
            token => kept.push(token),
        }
    }
    kept.into_iter().collect()
}

fn is_cfg_test(attribute: &Group) -> bool {
    attribute.delimiter() == Delimiter::Bracket && attribute.stream().to_string().replace(' ', "") == "cfg(test)"
}

/// Adds what each path of the tokens names that begins with `crate` or `super`, as seen from the root of the crate.
pub(crate) fn add_paths(tokens: TokenStream, module: &[String], paths: &mut BTreeSet<Module>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut rest = tokens.as_slice();
    while let [token, following @ ..] = rest {
        rest = following;
        match (token, following) {
            (TokenTree::Ident(word), [TokenTree::Ident(name), TokenTree::Group(body), ..]) if word == "mod" => {
                add_paths(body.stream(), &[module, &[name.to_string()]].concat(), paths);
                rest = &following[2..];
            }
            (TokenTree::Ident(word), [colon, ..]) if word == "crate" && is_mark(colon, ':') => {
                rest = follow(following, Vec::new(), paths);
            }
            (TokenTree::Ident(word), [colon, ..]) if word == "super" && is_mark(colon, ':') => {
                rest = follow(following, module[..module.len().saturating_sub(1)].to_vec(), paths);
            }
            (TokenTree::Group(group), _) => add_paths(group.stream(), module, paths),
            _ => {}
        }
    }
}

pub(crate) fn is_mark(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(own) if own.as_char() == mark)
}

/// Adds the path, or the tree of paths, that goes on with these tokens, and returns those behind it.
fn follow<'t>(mut rest: &'t [TokenTree], mut path: Module, paths: &mut BTreeSet<Module>) -> &'t [TokenTree] {
    loop {
        match rest {
            [TokenTree::Punct(one), TokenTree::Punct(two), behind @ ..]
                if one.as_char() == ':' && two.as_char() == ':' =>
            {
                rest = behind;
            }
            [TokenTree::Ident(word), behind @ ..] => {
                match word.to_string().as_str() {
                    "super" => drop(path.pop()),
                    "self" => {}
                    name => path.push(name.to_owned()),
                }
                rest = behind;
                if !matches!(rest, [mark, ..] if is_mark(mark, ':')) {
                    break;
                }
            }
            [TokenTree::Group(group), behind @ ..] => {
                let tree: Vec<TokenTree> = group.stream().into_iter().collect();
                for branch in tree
                    .split(|token| is_mark(token, ','))
                    .filter(|branch| !branch.is_empty())
                {
                    follow(branch, path.clone(), paths);
                }
                return behind;
            }
            // A star, or the `<` of a turbofish.
            _ => break,
        }
    }
    paths.insert(path);
    rest
}
