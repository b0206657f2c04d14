//! The header of a solver in C, and the program that shows it.

use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::quantity::Dimension;
use crate::tape::c::{Text, comment, meaning_of_margin};
use crate::tape::{ResultOf, Role};

/// The unit of a quantity in the words of a comment.
fn unit(dimension: Dimension, order: usize) -> String {
    let base = match dimension {
        Dimension::Length => "length",
        Dimension::Angle => "rad",
        Dimension::Scalar => "1",
    };
    match order {
        0 => base.to_string(),
        1 => format!("{base}/time"),
        _ => format!("{base}/time^{order}"),
    }
}

/// A member of a structure with its documentation.
fn member(text: &Text<'_>, name: &str, description: &str, unit: &str) -> String {
    let mut printed = comment("    ", &format!("{description} [{unit}]"));
    printed.push_str(&format!("    {} {name};\n", text.number));
    printed
}

fn structure(text: &Text<'_>, suffix: &str, about: &str, members: &str) -> String {
    format!(
        "{}typedef struct {{\n{members}}} {}_{suffix};\n\n",
        comment("", about),
        text.name
    )
}

pub(super) fn header(text: &Text<'_>) -> String {
    let tape = text.tape;
    let (name, upper) = (&text.name, &text.upper);
    let mut printed = text.head(&format!("{name}.h"));
    let about = format!(
        "Angles are in radians and counter-clockwise. Lengths share any one unit, and times share any one unit. The \
         closure is: {}.",
        tape.description.equations.join("; ")
    );
    printed.push('\n');
    printed.push_str(&comment("", &about));
    printed.push_str(&format!("\n#ifndef KIN_{upper}_H\n#define KIN_{upper}_H\n\n"));
    printed.push_str("#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    for (suffix, members) in text.structures() {
        let about = match suffix {
            "dimensions" => "The dimensions.",
            "inputs" => "The inputs and their time derivatives.",
            "near" => {
                "Values near the unknowns, from which Newton's method starts: those of the pose before, or of a \
                 drawing. They choose the assembly and the revolutions of angles."
            }
            _ => "The assembly of each block that can be assembled in two ways: 1 for open, -1 for crossed.",
        };
        let mut fields = String::new();
        for index in members {
            let argument = &tape.arguments[index];
            let (description, unit) = match argument.role {
                Role::Input { order, .. } if order > 0 => (String::new(), unit(argument.dimension, order)),
                Role::Assembly(_) => (String::new(), "1 or -1".to_string()),
                _ => (argument.description.to_string(), unit(argument.dimension, 0)),
            };
            fields.push_str(&member(text, &text.arguments[index], &description, &unit));
        }
        printed.push_str(&structure(text, suffix, about, &fields));
    }
    let mut fields = String::new();
    for (result, field) in tape.results.iter().zip(&text.results) {
        let unit = unit(result.dimension, result.order);
        let (description, unit) = match result.quantity {
            ResultOf::UnknownPartial { parameter, .. } | ResultOf::OutputPartial { parameter, .. } => {
                let by = &tape.description.parameters[parameter];
                let per = match by.dimension {
                    Dimension::Length => " per length",
                    Dimension::Angle => " per rad",
                    Dimension::Scalar => "",
                };
                (
                    format!("The derivative with respect to {}.", by.name),
                    format!("{unit}{per}"),
                )
            }
            _ if result.order > 0 => (String::new(), unit),
            _ => (result.description.to_string(), unit),
        };
        fields.push_str(&member(text, field, &description, &unit));
    }
    printed.push_str(&structure(text, "pose", "What is found.", &fields));
    printed.push_str(&outcome(text));
    printed.push_str(&functions(text));
    printed.push_str("#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
    printed
}

/// The codes, and the structure that holds one.
fn outcome(text: &Text<'_>) -> String {
    let (name, upper) = (&text.name, &text.upper);
    let mut printed = comment(
        "",
        "The codes of an outcome: zero if the mechanism closes, otherwise positive for the check that failed and the \
         unknowns that it is about.",
    );
    printed.push_str("enum {\n");
    if text.choices().next().is_some() {
        printed.push_str(&comment(
            "    ",
            "A member of the assembly is neither 1 nor -1; the margin is this member.",
        ));
        printed.push_str(&format!("    {upper}_NO_ASSEMBLY = -1,\n"));
    }
    printed.push_str(&format!("    {upper}_CLOSED = 0"));
    for (index, (check, code)) in text.tape.checks.iter().zip(&text.codes).enumerate() {
        printed.push_str(",\n");
        let about = format!(
            "{} ({}); the margin is {}.",
            check.name,
            text.tape.block_of(check),
            meaning_of_margin(check.condition)
        );
        printed.push_str(&comment("    ", &about));
        printed.push_str(&format!("    {code} = {}", index + 1));
    }
    printed.push_str("\n};\n\n");
    let mut fields = String::from("    int code;\n");
    fields.push_str(&member(
        text,
        "margin",
        "How far the check is from passing; zero if the mechanism closes. About zero is a singular position, a limit \
         or a dead point. Not finite if an argument is not.",
        "the unit of what is checked",
    ));
    printed.push_str(&format!(
        "{}typedef struct {{\n{fields}}} {name}_outcome;\n\n",
        comment("", "Whether there is a pose.")
    ));
    printed
}

/// The number of private numbers that go from a position to its rates.
pub(super) fn carried_name(text: &Text<'_>) -> String {
    format!("{}_CARRIED", text.upper)
}

fn functions(text: &Text<'_>) -> String {
    let name = &text.name;
    let coupled = text.tape.searches.len();
    let limits = if coupled > 0 {
        " Coupled equations are solved by Newton's method, which takes at most 64 steps and may fail to converge from \
         values far away."
    } else {
        " The position is found in closed form: nothing is iterated."
    };
    let mut printed = comment(
        "",
        &format!(
            "Finds the pose with all its time derivatives. If the code of the outcome is not zero, the pose is not \
             changed. Nothing is allocated and nothing is static, so it may be called anywhere.{limits}"
        ),
    );
    printed.push_str(&format!("{};\n\n", text.signature("solve", "pose")));
    printed.push_str(&comment("", "What a code means, in a few words."));
    printed.push_str(&format!("const char *{name}_message(int code);\n\n"));
    if text.tape.order == 0 {
        return printed;
    }
    let carried = crate::tape::c::source::Inherited::new(text.tape).values.len();
    printed.push_str(&comment(
        "",
        "A pose on its way from order to order. The private numbers are what later orders take from earlier ones.",
    ));
    printed.push_str(&format!(
        "#define {} {}\n\ntypedef struct {{\n    {name}_pose pose;\n    {} carried[{}];\n}} {name}_chain;\n\n",
        carried_name(text),
        carried.max(1),
        text.number,
        carried_name(text)
    ));
    printed.push_str(&comment(
        "",
        "The same order by order: the position, then each derivative after the one before, with the same arguments. \
         The members of inputs above an order are not read up to it, and may be set between two calls. After an \
         outcome other than zero the chain holds nothing.",
    ));
    for order in 0..=text.tape.order {
        printed.push_str(&format!("{};\n", text.signature(&order_name(order), "chain")));
    }
    printed.push('\n');
    printed
}

/// The function that finds an order.
pub(super) fn order_name(order: usize) -> String {
    match order {
        0 => "position".to_string(),
        _ => crate::tape::words::of_order("", order)
            .trim_start_matches('_')
            .to_string(),
    }
}

/// A program that reads the arguments of one pose from each line of its input.
pub(super) fn example(text: &Text<'_>) -> String {
    let (name, number, tape) = (&text.name, text.number, text.tape);
    let count = tape.arguments.len();
    let order: Vec<&str> = text.arguments.iter().map(String::as_str).collect();
    let mut printed = text.head("main.c");
    printed.push_str(&comment(
        "",
        &format!(
            "Reads the arguments of one pose after the other from the standard input, separated by blanks or lines, in \
             this order: {}. Writes a line for each pose. Ends with 1 if an argument is no number, or the last pose \
             has too few of them.",
            order.join(" ")
        ),
    ));
    printed.push_str(&comment(
        "",
        &format!("Build it by: cc -O2 -std=c99 -ffp-contract=off main.c {name}.c -lm -o {name}"),
    ));
    printed.push_str(&format!("#include <stdio.h>\n\n#include \"{name}.h\"\n\n"));
    printed.push_str(
        "static int read_all(double *numbers, int count)\n{\n    int index = 0;\n    \
         while (index < count && scanf(\"%lf\", &numbers[index]) == 1) {\n        index++;\n    }\n    return \
         index;\n}\n\n",
    );
    printed.push_str(&format!(
        "int main(void)\n{{\n    double numbers[{count}];\n    int given;\n    while ((given = read_all(numbers, \
         {count})) == {count}) {{\n"
    ));
    let cast = |index: usize| {
        if number == "double" {
            format!("numbers[{index}]")
        } else {
            format!("({number})numbers[{index}]")
        }
    };
    for (suffix, members) in text.structures() {
        let values: Vec<String> = members.into_iter().map(cast).collect();
        printed.push_str(&format!(
            "        const {name}_{suffix} {suffix} = {{{}}};\n",
            values.join(", ")
        ));
    }
    let passed: Vec<String> = text
        .structures()
        .iter()
        .map(|(suffix, _)| format!("&{suffix}"))
        .collect();
    printed.push_str(&format!(
        "        {name}_pose pose;\n        const {name}_outcome outcome = {name}_solve({}, &pose);\n",
        passed.join(", ")
    ));
    printed.push_str(&format!(
        "        if (outcome.code != {}_CLOSED) {{\n            printf(\"%d: %s, margin %.17g\\n\", outcome.code, \
         {name}_message(outcome.code), (double)outcome.margin);\n            continue;\n        }}\n",
        text.upper
    ));
    for (index, field) in text.results.iter().enumerate() {
        let end = if index + 1 == text.results.len() { "\\n" } else { " " };
        printed.push_str(&format!(
            "        printf(\"{field} %.17g{end}\", (double)pose.{field});\n"
        ));
    }
    printed.push_str("    }\n    if (given > 0 || !feof(stdin)) {\n");
    printed.push_str(&format!(
        "        fprintf(stderr, \"a pose takes {count} numbers, and the last one has %d:\\n%s\\n\", \
         given, \"{}\");\n        return 1;\n",
        order.join(" ")
    ));
    printed.push_str("    }\n    return 0;\n}\n");
    printed
}
