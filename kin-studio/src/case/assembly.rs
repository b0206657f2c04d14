//! Assemblies as people type them: `open`, `knee=open,foot=crossed`, values of the unknowns nearby, `open or crossed`.

use kin_core::any::Quantity;
use kin_core::assembly_named;

use super::fault::{listed, similar};
use super::subject::Wanted;
use super::value::{self, Lengths};

/// The assemblies between `or`, or all assemblies.
pub(crate) fn each(text: &str, names: &[String]) -> Vec<String> {
    if text.trim() == "all" {
        return names.to_vec();
    }
    text.split(" or ").map(|one| one.trim().to_owned()).collect()
}

/// One assembly.
pub(crate) fn wanted(
    names: &[String],
    unknowns: &[Quantity<'_>],
    text: &str,
    lengths: &mut Lengths,
) -> Result<Wanted, String> {
    if let Some(index) = assembly_named(names, text) {
        return Ok(Wanted::Named(index));
    }
    if text.contains('=') && (names.is_empty() || text.contains(|letter: char| letter.is_ascii_digit())) {
        return near(unknowns, text, lengths);
    }
    if names.is_empty() {
        let example: Vec<String> = unknowns.iter().map(|unknown| format!("{}=…", unknown.name)).collect();
        return Err(format!(
            "the positions of this mechanism have no names: give values of its unknowns near the one you mean, as in \
             `--assembly {}`",
            example.join(",")
        ));
    }
    if names.iter().all(String::is_empty) {
        return Err("this mechanism has one assembly only: leave `--assembly` out".to_owned());
    }
    let words: Vec<&str> = text.split(',').map(str::trim).collect();
    if words.len() > 1 && words.iter().all(|word| assembly_named(names, word).is_some()) {
        return Err(format!(
            "several assemblies have `or` between them: write `{}`",
            words.join(" or ")
        ));
    }
    Err(format!(
        "there is no assembly `{text}`; {}",
        similar(text, names.iter().map(String::as_str))
    ))
}

/// Values of all unknowns near a position.
fn near(unknowns: &[Quantity<'_>], text: &str, lengths: &mut Lengths) -> Result<Wanted, String> {
    let mut values = vec![None; unknowns.len()];
    for part in text.split(',').map(str::trim).filter(|part| !part.is_empty()) {
        let Some((name, value)) = part.split_once('=') else {
            return Err(format!("`{part}` is not an unknown with a value near its own"));
        };
        let name = name.trim();
        let Some(index) = unknowns.iter().position(|unknown| unknown.name == name) else {
            return Err(format!(
                "there is no unknown `{name}`; {}",
                similar(name, unknowns.iter().map(|unknown| unknown.name))
            ));
        };
        let value = value::quantity(unknowns[index].dimension, value, lengths)
            .map_err(|message| format!("{name}: {message}"))?;
        values[index] = Some(value);
    }
    let missing: Vec<&str> = unknowns
        .iter()
        .zip(&values)
        .filter_map(|(unknown, value)| value.is_none().then_some(unknown.name))
        .collect();
    if missing.is_empty() {
        Ok(Wanted::Near(values.into_iter().flatten().collect()))
    } else {
        Err(format!("the assembly gives no value near {}", listed(&missing)))
    }
}
