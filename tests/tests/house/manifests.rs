//! The manifests of kin-core and of kin-runtime, which users see as one crate.

use std::fs;

use crate::root;

/// The lines of a section of a package's manifest, as keys and values.
fn section(package: &str, name: &str) -> Vec<(String, String)> {
    let path = root().join(package).join("Cargo.toml");
    let text = fs::read_to_string(path).expect("the package has a manifest");
    let heading = format!("[{name}]");
    let lines = text.lines().skip_while(|line| *line != heading).skip(1);
    lines
        .take_while(|line| !line.starts_with('['))
        .filter_map(|line| line.split_once(" = "))
        .filter(|(key, _)| !key.starts_with('#'))
        .map(|(key, value)| (key.to_owned(), value.to_owned()))
        .collect()
}

#[test]
fn kin_core_hands_on_every_feature() {
    let (own, behind) = (section("kin-core", "features"), section("kin-runtime", "features"));
    assert!(behind.len() > 5, "{behind:?}");
    for (name, enabled) in &behind {
        let (_, handed_on) = own.iter().find(|(own, _)| own == name).expect(name);
        if name == "default" {
            assert_eq!(handed_on, enabled);
        } else {
            assert!(
                handed_on.contains(&format!("\"kin-runtime/{name}\"")),
                "{name}: {handed_on}"
            );
        }
    }
}

/// Cargo builds the library and the compiler at the same time, which takes a third off a first build.
#[test]
fn the_library_does_not_wait_for_the_compiler() {
    let dependencies = section("kin-runtime", "dependencies");
    assert!(
        dependencies.iter().any(|(name, _)| name == "num-traits.workspace"),
        "{dependencies:?}"
    );
    let awaited = dependencies.iter().find(|(name, _)| name.starts_with("kin-"));
    assert_eq!(awaited, None);
}
