//! The items to generate besides the solvers.

use proc_macro2::Ident;

use crate::mistakes::{Mistakes, suggestion};
use crate::syntax::{Declaration, Request, Statement, instead_of_request};

/// A request with its position in the source.
pub(crate) struct Requested {
    pub(crate) request: Request,
    pub(crate) name: Ident,
}

/// All requests in source order, each once.
pub(super) fn requests(declaration: &Declaration, mistakes: &mut Mistakes) -> Vec<Requested> {
    let mut requests: Vec<Requested> = Vec::new();
    let names = declaration.statements.iter().flat_map(|statement| match statement {
        Statement::Requests(names) => names.as_slice(),
        _ => &[],
    });
    for name in names {
        let word = name.to_string();
        let Some(request) = Request::ALL.into_iter().find(|request| request.name() == word) else {
            mistakes.error(
                name,
                format!(
                    "`{word}` cannot be requested: write `transmission_angles`, `sensitivities` or `test`{}",
                    instead_of_request(&word)
                        .map_or_else(|| suggestion(&word, Request::ALL.map(Request::name)), str::to_owned)
                ),
            );
            continue;
        };
        if let Some(first) = requests.iter().find(|earlier| earlier.request == request) {
            let mut error = syn::Error::new(name.span(), format!("`{word}` is requested twice: remove this one"));
            error.combine(syn::Error::new(
                first.name.span(),
                format!("the first `{word}` is requested here"),
            ));
            mistakes.push(error);
            continue;
        }
        requests.push(Requested {
            request,
            name: name.clone(),
        });
    }
    requests
}
