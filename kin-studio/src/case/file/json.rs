//! The mistakes of a file, or its outline, as JSON for editors.

use std::ops::Range;

use kin_compiler::{Quantity, fault_and_advice};
use kin_core::any::{Described as _, Pictured as _};
use proc_macro2::{TokenStream, TokenTree};
use serde_json::{Value, json};

use super::super::subject::Subject;
use super::super::value::unit_of;
use super::numbers::Number;
use super::read::KinFile;
use super::{Checked, Settings, asked, slip};
use crate::file::{Mistake, Sections, is_ident, is_punct, range_of};

/// The version of the form, which grows when a member changes or goes.
const VERSION: u32 = 1;

/// One object: see the chapter on the program. The mechanism of a text that was compiled comes with it.
pub(super) fn checked(file: &str, text: &str, read: Result<KinFile, Vec<Mistake>>) -> Checked {
    let (remarks, mistakes, outline, asked) = match read {
        Err(mistakes) => (Vec::new(), mistakes, Value::Null, None),
        Ok(file) => {
            let outline = outline(text, &file);
            let (subject, settings, sections) = asked(file);
            let remarks = remarks(text, &sections, &subject, &settings);
            let slip = slip(&sections, &subject, &settings);
            (remarks, slip.into_iter().collect(), outline, Some((subject, settings)))
        }
    };
    let errors = mistakes.iter();
    let errors = errors.map(|mistake| one(text, "error", &mistake.message, &mistake.range));
    let all: Vec<Value> = remarks.into_iter().chain(errors).collect();
    let object = json!({ "version": VERSION, "file": file, "mistakes": all, "outline": outline });
    Checked {
        object: format!("{object}\n"),
        mistakes: mistakes.len(),
        asked,
    }
}

fn one(text: &str, severity: &str, message: &str, range: &Range<usize>) -> Value {
    json!({
        "severity": severity,
        "message": message,
        "advice": fault_and_advice(message).1,
        "range": range_in_lines(text, range),
    })
}

/// A range as editors count: lines from zero, and units of UTF-16 in the line from zero.
fn range_in_lines(text: &str, range: &Range<usize>) -> Value {
    let position = |byte: usize| {
        let before = text.get(..byte).unwrap_or(text);
        let line = before.rsplit('\n').next().unwrap_or("");
        json!({ "line": before.matches('\n').count(), "character": line.encode_utf16().count() })
    };
    json!({ "start": position(range.start), "end": position(range.end.max(range.start)) })
}

/// What is remarkable about the dimensions, at their names.
fn remarks(text: &str, sections: &Sections, subject: &Subject, settings: &Settings) -> Vec<Value> {
    let remarks = settings.typed().remarks(subject).into_iter();
    remarks
        .map(|(name, remark)| one(text, "warning", &remark, &sections.named("dimensions", &name)))
        .collect()
}

fn outline(text: &str, file: &KinFile) -> Value {
    let compiled = file.mechanism.declaration();
    let description = file.mechanism.description();
    // the first line is none of the language
    let first = text.lines().next().map_or(0, str::len);
    let declared = format!("{}{}", " ".repeat(first), &text[first..]);
    let tokens: TokenStream = declared.parse().unwrap_or_default();
    let quantities = |quantities: &[Quantity]| -> Vec<Value> {
        let one = |quantity: &Quantity| {
            json!({
                "name": quantity.name,
                "dimension": format!("{:?}", quantity.dimension),
                "documentation": quantity.documentation,
                "range": find(tokens.clone(), &quantity.name, ':').map(|range| range_in_lines(text, &range)),
            })
        };
        quantities.iter().map(one).collect()
    };
    let blocks = description.blocks.iter();
    let blocks: Vec<Value> = blocks
        .map(|block| json!({ "unknowns": block.unknowns, "solution": block.solution.to_string() }))
        .collect();
    let sections = file.sections.spans.iter();
    let sections: Vec<Value> = sections
        .map(|section| json!({ "name": section.name, "range": range_in_lines(text, &section.whole) }))
        .collect();
    let number = |Number { name, dimension, value }: &Number| {
        let (unit, size) = unit_of(*dimension, &value.text, file.lengths);
        json!({ "name": name, "range": range_in_lines(text, &value.range), "unit": unit, "size": size })
    };
    let numbers: Vec<Value> = file.set.iter().map(number).collect();
    let outline = file.mechanism.outline();
    let declares_bodies = outline.guess.is_none();
    let bodies = outline.bodies.iter().filter(|_| declares_bodies);
    let bodies: Vec<&str> = bodies.map(|body| body.name).collect();
    json!({
        "name": compiled.name(),
        "documentation": compiled.documentation(),
        "dimensions": quantities(compiled.parameters()),
        "inputs": quantities(compiled.inputs()),
        "unknowns": quantities(compiled.unknowns()),
        "outputs": quantities(compiled.outputs()),
        "blocks": blocks,
        "assemblies": file.mechanism.assembly_names(),
        "space": file.mechanism.is_space(),
        "bodies": bodies,
        "sections": sections,
        "length_unit": file.lengths.name(),
        "numbers": numbers,
    })
}

/// The first range of a name before a sign.
fn find(tokens: TokenStream, name: &str, sign: char) -> Option<Range<usize>> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    tokens.iter().enumerate().find_map(|(index, token)| match token {
        TokenTree::Group(group) => find(group.stream(), name, sign),
        token => (is_ident(Some(token), name) && is_punct(tokens.get(index + 1), sign)).then(|| range_of(token)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_in_utf_16() {
        let text = "kin 1\n\u{1d703}ö = 30;";
        let start = text.find("30").unwrap();
        let position = json!({ "line": 1, "character": 6 });
        assert_eq!(range_in_lines(text, &(start..start + 2))["start"], position);
    }
}
