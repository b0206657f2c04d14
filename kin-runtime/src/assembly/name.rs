//! Assemblies as text.

use alloc::format;
use alloc::string::String;
use core::fmt::Debug;

/// The name of an assembly, from its debug form: `Open`, or `WattIAssembly { knee: Open, foot: Crossed }`.
pub(crate) fn assembly_name(assembly: &impl Debug) -> String {
    let shown = format!("{assembly:?}");
    plain(shown.split_once('{').map_or(&*shown, |(_, fields)| fields))
}

/// The index of the name that a text means: the whole name, or one word for all dyads.
///
/// Blanks, braces and the case do not count, and `knee: open` is `knee=open`. The names are those that
/// [`Mechanism::assembly_name`](crate::Mechanism::assembly_name) gives.
///
/// ```
/// use kin_core::assembly_named;
///
/// let names = ["knee=open,foot=open", "knee=open,foot=crossed", "knee=crossed,foot=crossed"];
/// assert_eq!(assembly_named(&names, "knee: open, foot: Crossed"), Some(1));
/// assert_eq!(assembly_named(&names, "crossed"), Some(2));
/// assert_eq!(assembly_named(&names, "left"), None);
/// ```
#[must_use]
pub fn assembly_named(names: &[impl AsRef<str>], text: &str) -> Option<usize> {
    let wanted = plain(text);
    let words = |name: &str| {
        let mut words = name.split(',').map(|part| part.split_once('=').map(|part| part.1));
        words.all(|word| word == Some(&wanted))
    };
    names
        .iter()
        .position(|name| name.as_ref() == wanted)
        .or_else(|| names.iter().position(|name| words(name.as_ref())))
}

fn plain(text: &str) -> String {
    text.replace([' ', '{', '}', '(', ')', '"'], "")
        .replace(':', "=")
        .to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::assembly_name;

    #[test]
    fn assemblies_have_names() {
        #[derive(Debug)]
        enum Own {
            Open,
        }
        #[derive(Debug)]
        #[expect(dead_code, reason = "only its debug form is read")]
        struct Both {
            knee: Own,
            foot: Own,
        }
        assert_eq!(assembly_name(&Own::Open), "open");
        assert_eq!(assembly_name(&()), "");
        let both = Both {
            knee: Own::Open,
            foot: Own::Open,
        };
        assert_eq!(assembly_name(&both), "knee=open,foot=open");
    }
}
