//! Degrees that were typed where radians are meant.
//!
//! Angles are plain numbers to the dimensions. So this pass follows which formulas are angles, and looks for numbers
//! beyond a revolution beside them: `theta + 30`, `cis(90)`, `sin(s + 45)`. It also looks for angles that a factor
//! converts: `cis(theta * PI / 180)`.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use crate::algebra::{Gives, Takes};
use crate::mistakes::{Extent, Mistakes};
use crate::model::{Dimension, Range};
use crate::syntax::{
    ArithmeticOperator, Callee, Declaration, FormulaKind, RangeClause, RangeKind, Statement, TypedFormula,
};

/// The largest number that passes for radians: a revolution, which may have been typed in few digits.
const LARGEST: f64 = TAU * 1.001;

/// The part that a formula plays among angles.
#[derive(Clone, Copy, Default)]
struct Sort {
    /// Whether it is an angle.
    is_angle: bool,
    /// Whether it has no dimension.
    is_plain: bool,
    /// Its value, if it is made of numbers without `PI` and `deg`.
    number: Option<f64>,
    /// A term of it that is a number beyond a revolution, and its position.
    beyond: Option<(f64, Extent)>,
    /// Its value, if it is made of numbers, `PI` and `deg`.
    constant: Option<f64>,
    /// The conversion between degrees and radians that it applies to an angle.
    conversion: Option<Conversion>,
}

/// The conversion of an angle by a factor in the formula.
#[derive(Clone, Copy)]
enum Conversion {
    FromDegrees,
    ToDegrees,
}

impl Conversion {
    /// The conversion that multiplies by this factor.
    fn of_factor(factor: f64) -> Option<Self> {
        // the number may have been typed in five digits or more
        let is = |wanted: f64| (factor / wanted - 1.0).abs() < 1e-5;
        if is(PI / 180.0) {
            Some(Self::FromDegrees)
        } else if is(180.0 / PI) {
            Some(Self::ToDegrees)
        } else {
            None
        }
    }

    fn message(self) -> &'static str {
        match self {
            Self::FromDegrees => {
                "an angle is in radians already: write it without this factor, or declare it a `Scalar` if it is in \
                 degrees"
            }
            Self::ToDegrees => {
                "angles are in radians: write the angle without this factor and convert the result by `to_degrees`, or \
                 declare the number of degrees a `Scalar`"
            }
        }
    }
}

impl Sort {
    const ANGLE: Self = Self {
        is_angle: true,
        is_plain: true,
        number: None,
        beyond: None,
        constant: None,
        conversion: None,
    };

    const PLAIN: Self = Self {
        is_angle: false,
        ..Self::ANGLE
    };

    fn of_number(value: f64) -> Self {
        Self {
            number: Some(value),
            constant: Some(value),
            ..Self::PLAIN
        }
    }

    fn of_dimension(dimension: Option<Dimension>) -> Self {
        match dimension {
            Some(Dimension::Angle) => Self::ANGLE,
            Some(Dimension::Scalar) => Self::PLAIN,
            _ => Self::default(),
        }
    }

    /// A number beyond a revolution that it is or contains, and its position.
    fn suspect(&self, at: Extent) -> Option<(f64, Extent)> {
        self.beyond.or_else(|| {
            let number = self.number.filter(|number| number.abs() > LARGEST)?;
            Some((number, at))
        })
    }
}

/// Reports numbers beyond a revolution where angles are meant, in all formulas.
pub(super) fn check(declaration: &Declaration, mistakes: &mut Mistakes) {
    let parameters = declaration.parameters.iter();
    let mut names: BTreeMap<String, Sort> = parameters
        .map(|field| (field.name.to_string(), Sort::of_dimension(field.dimension)))
        .collect();
    for statement in &declaration.statements {
        let mut declare = |name: String, dimension| names.insert(name, Sort::of_dimension(Some(dimension)));
        match statement {
            Statement::Inputs(items) => {
                for item in items {
                    declare(item.name.to_string(), item.dimension);
                }
            }
            Statement::Unknowns(items) => {
                for item in items {
                    declare(item.quantity.name.to_string(), item.quantity.dimension);
                }
            }
            _ => {}
        }
    }
    let mut search = Search { names, mistakes };
    for statement in &declaration.statements {
        match statement {
            Statement::Let(statement) => {
                let sort = search.sort(&statement.value);
                search.names.insert(statement.name.to_string(), sort);
            }
            Statement::Output(statement) => {
                let sort = search.sort(&statement.value);
                if statement.dimension == Dimension::Angle {
                    search.tell_conversion(sort, statement.value.extent);
                }
                search.names.insert(statement.name.to_string(), sort);
            }
            Statement::Equation(equation) => {
                let sides = [&equation.left, &equation.right].map(|side| (search.sort(side), side.extent));
                let [(left, _), (right, _)] = sides;
                for (sort, at) in sides {
                    if left.is_angle || right.is_angle {
                        search.report(sort.suspect(at));
                        search.tell_conversion(sort, at);
                    }
                }
            }
            _ => {}
        }
    }
}

/// Whether a range of an angle is in radians; otherwise the mistake is reported.
pub(super) fn is_range_in_radians(clause: &RangeClause, range: &Range, mistakes: &mut Mistakes) -> bool {
    let bounds = match &clause.kind {
        RangeKind::Comparison { bound, .. } => vec![bound],
        RangeKind::Between { low, high, .. } => vec![low, high],
    };
    let mut search = Search {
        names: BTreeMap::new(),
        mistakes,
    };
    let suspects: Vec<_> = bounds
        .into_iter()
        .filter_map(|bound| search.sort(bound).suspect(bound.extent))
        .collect();
    let is_sound = suspects.is_empty();
    for suspect in suspects {
        search.report(Some(suspect));
    }
    let is_short = range.high - range.low <= LARGEST || !(range.high - range.low).is_finite();
    if is_sound && !is_short {
        mistakes.error(
            clause.extent,
            "the range of an angle is at most a turn, in radians: write `0..2 * PI` or `0deg..360deg`",
        );
    }
    is_sound && is_short
}

struct Search<'a> {
    names: BTreeMap<String, Sort>,
    mistakes: &'a mut Mistakes,
}

impl Search<'_> {
    fn sort(&mut self, formula: &TypedFormula) -> Sort {
        match &formula.kind {
            FormulaKind::Number { value, .. } => Sort::of_number(*value),
            FormulaKind::Degrees { value, .. } => Sort {
                constant: Some(value.to_radians()),
                ..Sort::ANGLE
            },
            FormulaKind::Pi => Sort {
                constant: Some(PI),
                ..Sort::ANGLE
            },
            FormulaKind::Name(name) => {
                let sort = self.names.get(&name.to_string()).copied().unwrap_or_default();
                // the number is reported where the name is used
                Sort {
                    beyond: sort.beyond.map(|(number, _)| (number, formula.extent)),
                    ..sort
                }
            }
            FormulaKind::Parenthesis(inner) => self.sort(inner),
            FormulaKind::Negate(of) => {
                let sort = self.sort(of);
                Sort {
                    number: sort.number.map(|number| -number),
                    constant: sort.constant.map(|constant| -constant),
                    ..sort
                }
            }
            FormulaKind::Sum { first, rest } => {
                let mut terms = vec![(ArithmeticOperator::Add, self.sort(first), first.extent)];
                for term in rest {
                    terms.push((term.operator, self.sort(&term.formula), term.formula.extent));
                }
                self.sum(&terms)
            }
            FormulaKind::Product { first, rest } => {
                let mut product = self.sort(first);
                let mut factors = vec![(ArithmeticOperator::Multiply, product)];
                for factor in rest {
                    let sort = self.sort(&factor.formula);
                    product = Self::product(product, factor.operator, sort);
                    factors.push((factor.operator, sort));
                }
                Sort {
                    constant: constant(&factors),
                    conversion: conversion(&factors),
                    ..product
                }
            }
            FormulaKind::Call { callee, arguments, .. } => self.call(*callee, arguments),
            FormulaKind::Power { base, exponent, .. } => {
                let base = self.sort(base);
                Sort {
                    is_plain: base.is_plain,
                    number: base.number.map(|number| number.powi(*exponent)),
                    ..Sort::default()
                }
            }
            FormulaKind::Part { of, .. } => {
                self.sort(of);
                Sort::default()
            }
        }
    }

    fn sum(&mut self, terms: &[(ArithmeticOperator, Sort, Extent)]) -> Sort {
        let numbers: Option<f64> = terms
            .iter()
            .map(|(operator, sort, _)| {
                let sign = if *operator == ArithmeticOperator::Subtract {
                    -1.0
                } else {
                    1.0
                };
                sort.number.map(|number| sign * number)
            })
            .sum();
        if let Some(number) = numbers {
            return Sort::of_number(number);
        }
        let is_angle = terms.iter().any(|(_, sort, _)| sort.is_angle);
        let mut beyond = None;
        for (_, sort, at) in terms {
            let suspect = sort.suspect(*at);
            if is_angle {
                self.tell_conversion(*sort, *at);
                self.report(suspect);
            } else {
                beyond = beyond.or(suspect);
            }
        }
        Sort {
            is_angle,
            is_plain: terms.iter().all(|(_, sort, _)| sort.is_plain),
            beyond,
            ..Sort::default()
        }
    }

    fn product(left: Sort, operator: ArithmeticOperator, right: Sort) -> Sort {
        let number = left.number.zip(right.number).map(|(left, right)| match operator {
            ArithmeticOperator::Divide => left / right,
            _ => left * right,
        });
        let is_plain = left.is_plain && right.is_plain;
        let is_angle = match operator {
            ArithmeticOperator::Divide => left.is_angle && !right.is_angle,
            _ => left.is_angle != right.is_angle,
        };
        Sort {
            is_angle: is_plain && is_angle,
            is_plain,
            number,
            ..Sort::default()
        }
    }

    fn call(&mut self, callee: Callee, arguments: &[TypedFormula]) -> Sort {
        let sorts: Vec<Sort> = arguments.iter().map(|argument| self.sort(argument)).collect();
        let angle = match callee {
            Callee::Cis | Callee::RotX | Callee::RotY | Callee::RotZ => Some(0),
            Callee::Polar | Callee::Rot => Some(1),
            Callee::Elementary(function) if matches!(function.takes(), Takes::Angle) => Some(0),
            Callee::Elementary(_) | Callee::Vec2 | Callee::Vec3 | Callee::Dot | Callee::Cross | Callee::Norm => None,
        };
        if let Some(index) = angle
            && let (Some(sort), Some(argument)) = (sorts.get(index), arguments.get(index))
        {
            self.report(sort.suspect(argument.extent));
            self.tell_conversion(*sort, argument.extent);
        }
        match callee {
            Callee::Elementary(function) => match function.gives() {
                Gives::Angle => Sort::ANGLE,
                Gives::Number => Sort::PLAIN,
                Gives::Root => Sort {
                    is_plain: sorts.first().is_some_and(|sort| sort.is_plain),
                    ..Sort::default()
                },
            },
            _ => Sort::default(),
        }
    }

    fn tell_conversion(&mut self, sort: Sort, at: Extent) {
        if let Some(conversion) = sort.conversion {
            self.mistakes.error(at, conversion.message());
        }
    }

    fn report(&mut self, suspect: Option<(f64, Extent)>) {
        if let Some((number, at)) = suspect {
            let degrees = number.abs();
            self.mistakes.error(
                at,
                format!(
                    "angles are in radians: write `{degrees}deg`{} for {degrees} degrees",
                    part_of_pi(degrees)
                ),
            );
        }
    }
}

/// The value of a product of constants.
fn constant(factors: &[(ArithmeticOperator, Sort)]) -> Option<f64> {
    factors.iter().try_fold(1.0, |product, (operator, sort)| {
        let factor = sort.constant?;
        Some(match operator {
            ArithmeticOperator::Divide => product / factor,
            _ => product * factor,
        })
    })
}

/// The conversion by a product of one angle and constants.
fn conversion(factors: &[(ArithmeticOperator, Sort)]) -> Option<Conversion> {
    let (constants, others): (Vec<_>, Vec<_>) = factors.iter().partition(|(_, sort)| sort.constant.is_some());
    match others.as_slice() {
        [(ArithmeticOperator::Multiply, angle)] if angle.is_angle => Conversion::of_factor(constant(&constants)?),
        _ => None,
    }
}

/// The same angle as a multiple of `PI`, where that is short.
fn part_of_pi(degrees: f64) -> String {
    const LARGEST_DIVISOR: u32 = 36;
    let short = (1..=LARGEST_DIVISOR).find(|&divisor| (degrees * f64::from(divisor) / 180.0).fract() == 0.0);
    let Some(divisor) = short else {
        return String::new();
    };
    let multiple = degrees * f64::from(divisor) / 180.0;
    match (multiple, divisor) {
        (1.0, 1) => " or `PI`".to_owned(),
        (1.0, _) => format!(" or `PI / {divisor}`"),
        (_, 1) => format!(" or `{multiple} * PI`"),
        _ => format!(" or `{multiple} * PI / {divisor}`"),
    }
}
