//! The errors of the crates: `?` in a `main` and `unwrap` print `Debug`, so `Debug` prints the sentence of `Display`.

use std::collections::BTreeMap;

use proc_macro2::TokenTree;

use crate::source::Source;

/// The errors of a crate, each with whether `__debug_by_display` writes its `Debug`, and its file.
pub(crate) fn errors(sources: Vec<Source>) -> BTreeMap<String, (bool, String)> {
    let mut errors = BTreeMap::new();
    for source in sources {
        let tokens: Vec<TokenTree> = source.tokens.into_iter().collect();
        let mut printed = Vec::new();
        let mut found = Vec::new();
        for (place, token) in tokens.iter().enumerate() {
            let following = &tokens[place + 1..];
            match (token.to_string().as_str(), following) {
                ("__debug_by_display", [_, TokenTree::Group(argument), ..]) => {
                    let names = argument.stream().into_iter();
                    printed.extend(
                        names
                            .filter(|name| matches!(name, TokenTree::Ident(_)))
                            .map(|name| name.to_string()),
                    );
                }
                // `impl ser::Error for` is another trait
                ("Error", [word, TokenTree::Ident(name), ..])
                    if word.to_string() == "for" && !is_path(&tokens[..place], "ser") =>
                {
                    found.push(name.to_string());
                }
                _ => {}
            }
        }
        for name in found {
            errors.insert(name.clone(), (printed.contains(&name), source.file.clone()));
        }
    }
    errors
}

/// Whether these tokens end on `name::`.
fn is_path(tokens: &[TokenTree], name: &str) -> bool {
    matches!(tokens, [.., word, first, second]
        if word.to_string() == name && first.to_string() == ":" && second.to_string() == ":")
}
