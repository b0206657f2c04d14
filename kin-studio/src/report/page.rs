//! The files of the page.

/// The markup of the body.
pub(super) const MARKUP: &str = include_str!("../page/page.html");

/// The style.
pub(super) const STYLE: &str = include_str!("../page/page.css");

/// Lists modules with their texts.
macro_rules! modules {
    ($($name:literal)*) => {
        &[$(($name, include_str!(concat!("../page/", $name, ".mjs")))),*]
    };
}

/// The modules, each behind those that it imports. The last one has the function `start`.
pub(super) const MODULES: &[(&str, &str)] = modules! {
    "numbers"
    "elements"
    "drive"
    "model"
    "sweep"
    "pace"
    "reasons"
    "marks"
    "view"
    "labels"
    "anatomy"
    "rates"
    "picture"
    "plots"
    "scrubber"
    "nearest"
    "peaks"
    "transmission"
    "formulas"
    "saving"
    "dimensions"
    "paper"
    "hands"
    "words"
    "main"
};

#[cfg(test)]
mod tests {
    use super::MODULES;

    /// Every file of the folder is in the list, and stands behind all that it imports.
    #[test]
    fn modules_stand_behind_what_they_import() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/page");
        let files = std::fs::read_dir(folder).expect("the folder is there");
        let names = files.map(|file| {
            file.expect("it can be listed")
                .file_name()
                .into_string()
                .expect("it is a name")
        });
        let mut modules: Vec<String> = names
            .filter_map(|name| Some(name.strip_suffix(".mjs")?.to_owned()))
            .collect();
        modules.sort();
        let mut listed: Vec<&str> = MODULES.iter().map(|(name, _)| *name).collect();
        listed.sort_unstable();
        assert_eq!(modules, listed);
        for (place, (name, text)) in MODULES.iter().enumerate() {
            for line in text.lines().filter(|line| line.starts_with("import ")) {
                let from = line.split("\"./").nth(1).and_then(|rest| rest.strip_suffix(".mjs\";"));
                let from = from.unwrap_or_else(|| panic!("{name}: an import is one line: {line}"));
                let index = MODULES.iter().position(|(other, _)| *other == from);
                assert!(index.is_some_and(|index| index < place), "{name} stands before {from}");
            }
        }
    }

    /// All modules become one script, so every name at the start of a line is there once.
    #[test]
    fn names_of_modules_are_told_apart() {
        let mut names = std::collections::BTreeMap::new();
        for (module, text) in MODULES {
            for line in text.lines() {
                let item = line.strip_prefix("export ").unwrap_or(line);
                let item = item.strip_prefix("async ").unwrap_or(item);
                let kinds = ["function ", "const ", "let ", "class "];
                let Some(rest) = kinds.iter().find_map(|kind| item.strip_prefix(kind)) else {
                    continue;
                };
                let name: String = rest
                    .chars()
                    .take_while(|letter| letter.is_alphanumeric() || *letter == '_')
                    .collect();
                if let Some(other) = names.insert(name.clone(), module) {
                    panic!("`{name}` is in {other} and in {module}");
                }
            }
        }
    }
}
