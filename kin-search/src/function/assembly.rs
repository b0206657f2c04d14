//! An assembly as text.

use datafusion::common::{Result, plan_err};

/// The index of the assembly that a text names: its full name, or one word for all dyads.
///
/// Blanks do not count, nor does the case; `knee: open` is `knee=open`.
pub(crate) fn index_of(names: &[String], text: &str) -> Result<usize> {
    let plain = text.replace([' ', '{', '}', '"'], "").replace(':', "=").to_lowercase();
    if let Some(index) = names.iter().position(|name| *name == plain) {
        return Ok(index);
    }
    let is_all = |name: &String| name.contains('=') && words(name).all(|word| word == plain);
    if let Some(index) = names.iter().position(is_all) {
        return Ok(index);
    }
    plan_err!("`{text}` is no assembly; write one of {}", listed(names))
}

fn words(name: &str) -> impl Iterator<Item = &str> {
    name.split(',')
        .filter_map(|part| part.split_once('='))
        .map(|part| part.1)
}

/// The names in quotes.
pub(crate) fn listed(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("'{name}'")).collect();
    quoted.join(", ")
}

#[cfg(test)]
mod tests {
    use super::index_of;

    #[test]
    fn one_word_names_the_assembly_of_all_dyads() {
        let names = ["a=open,b=open", "a=open,b=crossed", "a=crossed,b=crossed"].map(String::from);
        assert_eq!(index_of(&names, "crossed").unwrap(), 2);
        assert_eq!(index_of(&names, "a: open, b: Crossed").unwrap(), 1);
        let message = index_of(&names, "left").unwrap_err().to_string();
        assert!(message.contains("'a=open,b=open'"), "{message}");
    }
}
