//! A printout of the middle language: the way that was kept and the ways that were tried, then the steps of each order
//! with their costs.

use std::fmt::{self, Display, Formatter};

use super::{Cost, Expression, Names, Program, Solvers, Step, order_name};
use crate::algebra::Symbol;

/// The widest line of names.
const WIDTH: usize = 120;

impl Display for Solvers {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        writeln!(formatter, "ways (`>` is kept):")?;
        write!(formatter, "{}", self.trials)?;
        for (order, stage) in self.orders().iter().enumerate() {
            stage_of(formatter, &order_name(order), &self.motion, order, stage.cost)?;
        }
        if let Some(stage) = self.sensitivities() {
            let index = self.motion.stages.len() - 1;
            stage_of(formatter, "sensitivities", &self.motion, index, stage.cost)?;
        }
        let further = [
            ("assembly of a guess", Some(&self.orientations)),
            ("all positions", self.every.as_ref()),
            ("transmission angles", Some(&self.transmission.program)),
            ("lengths", Some(&self.lengths.program)),
            (
                "coefficients of the closure",
                self.closure.as_ref().map(|closure| &closure.program),
            ),
        ];
        for (title, program) in further {
            if let Some(program) = program.filter(|program| !program.stages[0].steps.is_empty()) {
                stage_of(formatter, title, program, 0, program.cost())?;
            }
        }
        Ok(())
    }
}

fn stage_of(
    formatter: &mut Formatter<'_>,
    title: &str,
    program: &Program<Expression>,
    index: usize,
    cost: Cost,
) -> fmt::Result {
    let stage = &program.stages[index];
    writeln!(
        formatter,
        "\n{title}: {} operations{}",
        cost.arithmetic(),
        functions(cost)
    )?;
    let mut values = Vec::new();
    for step in &stage.steps {
        // values that are plain expressions are listed on separate lines
        if let Step::Define { symbol, .. } = step {
            values.push(program.names.of(*symbol));
            continue;
        }
        write_values(formatter, &mut values)?;
        if let Some(line) = line(step, &program.names) {
            writeln!(formatter, "  {line}")?;
        }
    }
    write_values(formatter, &mut values)?;
    let carried: Vec<&str> = stage
        .carries
        .iter()
        .map(|carried| program.names.of(carried.symbol))
        .collect();
    wrapped(formatter, "  later orders use", &carried)
}

fn write_values(formatter: &mut Formatter<'_>, values: &mut Vec<&str>) -> fmt::Result {
    wrapped(formatter, "  let", &std::mem::take(values))
}

/// Writes names after a word, on as many lines as they need.
fn wrapped(formatter: &mut Formatter<'_>, word: &str, names: &[&str]) -> fmt::Result {
    let mut line = String::new();
    for (index, name) in names.iter().enumerate() {
        if line.is_empty() {
            word.clone_into(&mut line);
        }
        line.push(' ');
        line.push_str(name);
        let is_last = index + 1 == names.len();
        if !is_last {
            line.push(',');
        }
        if is_last || line.len() > WIDTH {
            writeln!(formatter, "{line}")?;
            line.clear();
        }
    }
    Ok(())
}

/// A step without its expressions; `None` for a step that computes nothing.
fn line(step: &Step<Expression>, names: &Names) -> Option<String> {
    let list = |symbols: Vec<Symbol>| -> String {
        let list: Vec<&str> = symbols.into_iter().map(|symbol| names.of(symbol)).collect();
        list.join(", ")
    };
    let defined = list(step.defines());
    Some(match step {
        Step::Define { .. } | Step::Bound { .. } | Step::Open { .. } | Step::Close { .. } => return None,
        Step::Check { guard, .. } => format!("{}: {defined}", guard.name),
        Step::SineCosine { .. } => format!("sine and cosine: {defined}"),
        Step::Solve { solver, .. } => format!("{}: {defined}", solver.name()),
        Step::Angle { .. } => format!("direction: {defined}"),
        Step::Newton { unknowns, body, .. } => {
            let unknowns = unknowns.iter().map(|&unknown| Symbol::Unknown(unknown)).collect();
            let body = body.iter().flat_map(Step::defines).collect();
            format!("Newton's method for {}, each time with {}", list(unknowns), list(body))
        }
        Step::Every { .. } => format!("all solutions: {defined}"),
        Step::Factor { matrix, .. } => format!("factors of {0} × {0}: {defined}", matrix.len()),
        Step::Substitute { .. } => format!("substitution: {defined}"),
        Step::Regular { .. } => "a divisor is checked".to_owned(),
    })
}

/// The functions of a cost in words, each after a comma.
fn functions(cost: Cost) -> String {
    let counts = [
        (cost.square_roots, "square root"),
        (cost.sine_cosines, "sine-cosine"),
        (cost.arc_tangents, "arctangent"),
        (cost.others, "other function"),
    ];
    let words: Vec<String> = counts
        .into_iter()
        .filter(|&(count, _)| count > 0)
        .map(|(count, name)| format!(", {count} {name}{}", if count == 1 { "" } else { "s" }))
        .collect();
    words.concat()
}

#[cfg(test)]
mod tests {
    use crate::passes::Passes;
    use crate::testing::{declarations, sound};

    #[test]
    fn of_the_four_bar() {
        insta::assert_snapshot!(sound(declarations::four_bar()).solvers(Passes::ALL));
    }

    #[test]
    fn of_a_triad() {
        insta::assert_snapshot!(sound(declarations::triad()).solvers(Passes::ALL));
    }

    /// The chapter on the macro shows the printout of the four-bar through the position.
    #[test]
    fn the_book_shows_it() {
        let book = include_str!("../../../docs/macro.md");
        let printout = sound(declarations::four_bar()).solvers(Passes::ALL).to_string();
        let (position, _) = printout.split_once("\nvelocity:").expect("the velocity follows");
        assert!(book.contains(position), "docs/macro.md should show\n{position}");
    }
}
