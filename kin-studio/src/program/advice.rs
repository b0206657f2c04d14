//! Advice on arguments that the program does not take.

use std::ffi::OsString;
use std::path::Path;

use super::command::Task;

/// The languages of `code`.
const LANGUAGES: [&str; 6] = ["c", "js", "javascript", "python", "py", "numpy"];

/// The advice on these arguments, of which the first is the program. `has_library` states that a mechanism is named
/// behind the command.
pub(super) fn advice(arguments: &[OsString], has_library: bool) -> Option<String> {
    let words: Vec<&str> = arguments.iter().skip(1).filter_map(|word| word.to_str()).collect();
    let is_argument = |word: &&str| !word.starts_with('-');
    let mut named = words.iter().copied().filter(is_argument);
    let (first, second, third) = (named.next()?, named.next(), named.next());
    if has_library && is_file(first) {
        let command = second.filter(|word| Task::NAMES.contains(word)).unwrap_or("report");
        return Some(format!(
            "a command comes before the file: write `kin {command} {first}`"
        ));
    }
    if !Task::NAMES.contains(&first) {
        return None;
    }
    if let ("code", true, Some(language), Some(mechanism)) = (first, has_library, second, third)
        && LANGUAGES.contains(&language)
        && !LANGUAGES.contains(&mechanism)
    {
        return Some(format!(
            "the mechanism comes before the language: write `kin code {mechanism} {language}`"
        ));
    }
    if let Some(option) = words.iter().find(|word| is_step(word)) {
        return Some(format!(
            "there is no `{option}`: the number of rows is `--rows`, as in `--rows 37`"
        ));
    }
    // an option takes the word behind it
    let mut before = "";
    for word in &words {
        let is_taken = before.starts_with('-') && !before.contains('=') && before != "--radians";
        if is_argument(word) && !is_taken && is_value(word) {
            return Some(format!("`{word}` is the value of a dimension: write `--set {word}`"));
        }
        before = word;
    }
    None
}

/// Whether a mechanism is a file, and no name of the library.
pub(super) fn is_file(word: &str) -> bool {
    Path::new(word).extension().is_some_and(|ending| ending == "kin")
}

/// Whether an option is the step that other programs take.
fn is_step(word: &str) -> bool {
    let name = word.split('=').next().unwrap_or(word);
    ["--step", "--steps", "--points", "--number", "--count"].contains(&name)
}

fn is_value(word: &str) -> bool {
    let is_name = |name: &str| {
        !name.is_empty()
            && name
                .chars()
                .all(|letter| letter.is_alphanumeric() || "_.".contains(letter))
    };
    word.split_once('=').is_some_and(|(name, _)| is_name(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(line: &str, has_library: bool) -> Option<String> {
        let words: Vec<OsString> = line.split_whitespace().map(OsString::from).collect();
        advice(&words, has_library)
    }

    #[test]
    fn what_is_right_has_no_advice() {
        for line in [
            "kin sweep four_bar --set r2=45",
            "kin sweep four_bar --over theta2=0..90deg --rows 3",
            "kin code four_bar c",
            "kin report w.kin",
            "kin",
        ] {
            assert_eq!(of(line, true), None, "{line}");
        }
        assert_eq!(of("pump code c", false), None);
    }

    #[test]
    fn arguments_of_other_programs() {
        for (line, advice) in [
            ("kin w.kin", "`kin report w.kin`"),
            ("kin w.kin sweep", "`kin sweep w.kin`"),
            ("kin code c four_bar", "`kin code four_bar c`"),
            ("kin sweep four_bar r2=45", "`--set r2=45`"),
            ("kin sweep four_bar --radians p.x=4", "`--set p.x=4`"),
            ("kin sweep four_bar --step 10", "`--rows 37`"),
            ("kin sweep four_bar --steps=10", "`--rows 37`"),
        ] {
            let advice_given = of(line, true).unwrap_or_default();
            assert!(advice_given.contains(advice), "{line}: {advice_given}");
        }
        let advice_given = of("pump sweep crank=45mm", false).unwrap_or_default();
        assert!(advice_given.contains("`--set crank=45mm`"), "{advice_given}");
    }
}
