//! The savings of each pass over the whole library.

use std::fmt::Write;

use crate::passes::{Pass, Passes};
use crate::program::{Cost, Expression, Step};
use crate::testing::library::library;

/// The passes, with their names.
const PASSES: [(Pass, &str); 20] = [
    (Pass::CommonSubexpressions, "common subexpressions"),
    (Pass::Carrying, "carrying from one order to the next"),
    (Pass::ConstantFolding, "constant folding"),
    (Pass::LinkVectors, "shared P and Q"),
    (Pass::WholeTurnings, "whole Q"),
    (Pass::Influences, "influence coefficients"),
    (Pass::CommonNumbers, "common numbers"),
    (Pass::Radii, "radii"),
    (Pass::UnitVectors, "unit vectors"),
    (Pass::SineCosinePairs, "sine-cosine pairs"),
    (Pass::ProductsLeft, "products left"),
    (Pass::MultipliedOut, "equations multiplied out"),
    (Pass::SharedNumbers, "shared numbers"),
    (Pass::SharedPairs, "shared pairs"),
    (Pass::SharedFactors, "shared factors"),
    (Pass::FactorsLeft, "factors left"),
    (Pass::InvertedRoots, "inverted roots"),
    (Pass::SharedReciprocals, "reciprocals"),
    (Pass::ReducedJacobians, "reduced Jacobians"),
    (Pass::CramerOfThree, "Cramer's rule of three"),
];

/// The passes that stay although they save less than half a per cent of the operations.
const EXCEPTIONS: [(Pass, &str); 5] = [
    (
        Pass::InvertedRoots,
        "it saves time: a division beside the root, and not after it",
    ),
    (
        Pass::CramerOfThree,
        "it saves time: a formula instead of a factorisation, which exchanges rows at run time",
    ),
    (
        Pass::Radii,
        "the four-bar linkage takes 139 operations with it, and 143 without",
    ),
    (
        Pass::CommonNumbers,
        "the four-bar linkage takes 139 operations with it, and 142 without",
    ),
    (
        Pass::FactorsLeft,
        "a spherical four-bar linkage takes 159 operations with it, and 164 without",
    ),
];

/// Each pass, except the exceptions, saves at least half a per cent of the cost of the whole library. The snapshot
/// lists the cost of each mechanism, and the additional cost without each pass. `.ci/run samples` runs it.
#[test]
#[ignore = "takes a minute"]
fn every_pass_pays() {
    let library = library();
    let all: Vec<Cost> = library.iter().map(|declared| declared.cost(Passes::ALL)).collect();
    let whole = sum(&all);
    let mut lines: Vec<String> = library
        .iter()
        .zip(&all)
        .map(|(declared, cost)| format!("{:30} {:5}", declared.name, cost.total()))
        .collect();
    for (pass, name) in PASSES {
        let without: Vec<Cost> = library
            .iter()
            .map(|declared| declared.cost(Passes::without(pass)))
            .collect();
        for ((line, without), with) in lines.iter_mut().zip(&without).zip(&all) {
            let more = without.total().cast_signed() - with.total().cast_signed();
            write!(line, " {more:>+6}").expect("writing to a string succeeds");
        }
        let more = sum(&without).total().saturating_sub(whole.total());
        let is_excepted = EXCEPTIONS.iter().any(|&(other, _)| other == pass);
        let least = if is_excepted { 1 } else { whole.total() / 200 };
        assert!(more >= least, "{name} saves {more} of {}", whole.total());
    }
    let passes: Vec<&str> = PASSES.iter().map(|&(_, name)| name).collect();
    insta::assert_snapshot!(format!("without {}:\n{}", passes.join(", "), lines.join("\n")));
}

fn sum(costs: &[Cost]) -> Cost {
    costs.iter().fold(Cost::default(), |sum, &cost| sum + cost)
}

/// The book states the number of products that are used only in one sum or difference. A machine with fused operations
/// computes such a product and its sum in one operation.
#[test]
fn products_that_are_fused() {
    let mut additions = Additions::default();
    for declared in library() {
        for stage in declared.solvers(Passes::ALL).motion.stages {
            for expression in stage.steps.iter().flat_map(Step::expressions) {
                additions.expression(expression);
            }
        }
    }
    let count = format!("{} of {} additions", additions.fusable, additions.all);
    let book = include_str!("../../../docs/macro.md");
    assert!(book.contains(&count), "docs/macro.md should say {count}");
}

/// The additions and subtractions of a program.
#[derive(Default)]
struct Additions {
    all: usize,
    fusable: usize,
}

impl Additions {
    fn expression(&mut self, expression: &Expression) {
        match expression {
            Expression::Name(_) | Expression::Number(_) | Expression::Pi => {}
            Expression::Add(a, b) | Expression::Subtract(a, b) => {
                self.all += 1;
                let is_product = |operand: &Expression| matches!(operand, Expression::Multiply(..));
                self.fusable += usize::from(is_product(a) || is_product(b));
                self.expression(a);
                self.expression(b);
            }
            Expression::Multiply(a, b) | Expression::Divide(a, b) => {
                self.expression(a);
                self.expression(b);
            }
            Expression::Negate(a) => self.expression(a),
            Expression::Call(_, arguments) => arguments.iter().for_each(|argument| self.expression(argument)),
        }
    }
}
