//! `let platform = frame(center, rotation);`: what `platform * point` and products of frames stand for.
//!
//! They are written out, as a person would: `center + rotation * point` in space, `pin + point * cis(angle)` in the
//! plane. So no later pass knows of frames.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Token, parenthesized, token};

use crate::mistakes::{Extent, Mistakes};
use crate::syntax::chain::Chain;
use crate::syntax::formula::{self, Context};
use crate::syntax::frame::{Frame, is_zero};
use crate::syntax::{
    ArithmeticOperator, Declaration, FormulaKind, FreshNames, LetStatement, Operand, Statement, TypedFormula,
    ValueShape, shape,
};

const WORD: &str = "frame";

/// The message about a frame that is part of a formula.
pub(super) const ALONE: &str = "a frame has a name of its own: write `let platform = frame(center, rotation);`, and \
                                then `platform * point`";

/// Whether a call is that of a frame. The word is not reserved.
pub(crate) fn is_frame(word: &str) -> bool {
    word == WORD
}

/// Reads `= frame(center, rotation)` behind the name of a `let`, if that stands there.
pub(super) fn parse(input: ParseStream<'_>) -> Result<Option<(TypedFormula, TypedFormula)>> {
    let ahead = input.fork();
    let is_frame = ahead.parse::<Token![=]>().is_ok()
        && Ident::parse_any(&ahead).is_ok_and(|word| word == WORD)
        && ahead.peek(token::Paren);
    if !is_frame {
        return Ok(None);
    }
    input.parse::<Token![=]>()?;
    let word = Ident::parse_any(input)?;
    let content;
    let parentheses = parenthesized!(content in input);
    let mut arguments = Vec::new();
    while !content.is_empty() {
        arguments.push(formula::parse(&content, Context::Argument)?);
        content.parse::<Option<Token![,]>>()?;
    }
    if !input.is_empty() {
        return Err(syn::Error::new(word.span(), ALONE));
    }
    let given = arguments.len();
    let [origin, rotation] = <[TypedFormula; 2]>::try_from(arguments).map_err(|_| {
        syn::Error::new_spanned(
            Extent::at(word.span()).to(Extent::at(parentheses.span.close())),
            format!(
                "`frame` takes 2 arguments, but is given {given}: write `frame(center, rotation)`, and `frame(pin, \
                 angle)` in the plane"
            ),
        )
    })?;
    Ok(Some((origin, rotation)))
}

/// Writes out all frames.
pub(super) fn write_out(declaration: &mut Declaration, mistakes: &mut Mistakes) {
    let names = declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Frame(frame) => Some(frame.name.to_string()),
        _ => None,
    });
    let mut later: BTreeSet<String> = names.collect();
    if later.is_empty() {
        return;
    }
    let taken = declaration.quantity_names();
    later.retain(|name| !taken.contains(name));
    let mut frames = Frames {
        shapes: declaration.shapes(),
        known: BTreeMap::new(),
        later,
        used: BTreeSet::new(),
    };
    for mut statement in std::mem::take(&mut declaration.statements) {
        match frames.written_out(&mut statement, &mut declaration.fresh) {
            Ok(None) => declaration.statements.push(statement),
            Ok(Some(parts)) => declaration.statements.extend(parts.into_iter().map(Statement::Let)),
            Err(error) => {
                mistakes.push(error);
                declaration.complete = false;
                if let Statement::Let(LetStatement { name, .. }) = &statement {
                    declaration.broken.insert(name.to_string());
                }
                if let Statement::Frame(frame) = &statement {
                    declaration.broken.insert(frame.name.to_string());
                }
                for formula in statement.formulas() {
                    formula.visit_names(&mut |name| {
                        declaration.mentioned.insert(name.to_string());
                    });
                }
            }
        }
    }
    for (word, frame) in &frames.known {
        if !frames.used.contains(word) && !declaration.mentioned.contains(word) {
            let written = declaration.fresh.written(word);
            mistakes.error(
                &frame.name,
                format!("`let {written}` is never used: use it, or remove it"),
            );
            declaration.complete = false;
        }
    }
}

/// A frame with a name.
struct NamedFrame {
    name: Ident,
    frame: Frame,
}

/// A formula, or a frame that it stands for.
enum Value {
    Formula(TypedFormula),
    Frame(Frame),
}

struct Frames {
    /// The shapes of the names so far.
    shapes: BTreeMap<String, ValueShape>,
    known: BTreeMap<String, NamedFrame>,
    /// The frames that come later.
    later: BTreeSet<String>,
    used: BTreeSet<String>,
}

impl Frames {
    /// Writes out the frames in a statement. For a frame itself, the result is the abbreviations of its parts.
    fn written_out(&mut self, statement: &mut Statement, fresh: &mut FreshNames) -> Result<Option<Vec<LetStatement>>> {
        match statement {
            Statement::Frame(statement) => {
                let word = statement.name.to_string();
                if !self.later.remove(&word) {
                    return Err(syn::Error::new(
                        statement.name.span(),
                        format!("`{word}` is declared twice: choose another name for this frame"),
                    ));
                }
                statement.origin = self.formula(&statement.origin)?;
                statement.rotation = self.formula(&statement.rotation)?;
                let frame = self.frame(&statement.origin, &statement.rotation)?;
                self.declare(&statement.name, frame, fresh).map(Some)
            }
            Statement::Let(statement) => match self.value(&statement.value)? {
                Value::Frame(frame) => self.declare(&statement.name, frame, fresh).map(Some),
                Value::Formula(value) => {
                    if let Some(shape) = self.shape(&value) {
                        self.shapes.insert(statement.name.to_string(), shape);
                    }
                    statement.value = value;
                    Ok(None)
                }
            },
            Statement::Repeats(columns) => {
                columns.retain(|column| !column.iter().any(|element| self.is_frame(element)));
                Ok(None)
            }
            _ => {
                for formula in statement.formulas() {
                    *formula = self.formula(formula)?;
                }
                if let Statement::Output(output) = statement {
                    self.shapes.insert(output.name.to_string(), output.dimension.shape());
                }
                Ok(None)
            }
        }
    }

    /// The frame of an origin and a rotation, if they can be that.
    fn frame(&self, origin: &TypedFormula, rotation: &TypedFormula) -> Result<Frame> {
        let wrong = |at: &TypedFormula, message: &str| Err(syn::Error::new_spanned(at.extent, message));
        let in_plane = match self.shape(rotation) {
            Some(ValueShape::Plane) => {
                return wrong(
                    rotation,
                    "a frame of the plane is turned by an angle: write `frame(pin, angle)`, without `cis`",
                );
            }
            Some(ValueShape::Space) => {
                return wrong(
                    rotation,
                    "a frame is turned by a rotation, but this is a vector: write `frame(center, rot_z(angle))`",
                );
            }
            Some(ValueShape::Scalar) => Some(true),
            Some(ValueShape::Rotation) => Some(false),
            None => None,
        };
        match self.shape(origin) {
            Some(ValueShape::Space) if in_plane == Some(true) => wrong(
                rotation,
                "a frame of space is turned by a rotation, but this is a scalar: write `rot_z(angle)`, or another \
                 rotation",
            ),
            Some(ValueShape::Rotation) => wrong(
                origin,
                "a frame has a point as its origin, but this is a rotation: write the point first, `frame(center, \
                 rotation)`",
            ),
            Some(ValueShape::Plane) if in_plane == Some(false) => wrong(
                origin,
                "a frame of space has its origin in space: write `vec3(v.x, v.y, 0)` to place a plane vector v in \
                 space",
            ),
            Some(ValueShape::Scalar) if in_plane == Some(false) && !is_zero(origin) => wrong(
                origin,
                "a frame of space has its origin in space, but this is a scalar: write `vec3(x, y, z)`",
            ),
            _ => Ok(Frame {
                origin: origin.clone(),
                rotation: rotation.clone(),
                in_plane,
            }),
        }
    }

    /// Gives a frame its name. Parts that are no names get one.
    fn declare(&mut self, name: &Ident, mut frame: Frame, fresh: &mut FreshNames) -> Result<Vec<LetStatement>> {
        let part_name = if frame.in_plane == Some(true) {
            "angle"
        } else {
            "rotation"
        };
        let mut parts = Vec::new();
        for (part, value) in [("origin", &mut frame.origin), (part_name, &mut frame.rotation)] {
            let is_short = matches!(
                value.kind,
                FormulaKind::Name(_) | FormulaKind::Number { .. } | FormulaKind::Degrees { .. } | FormulaKind::Pi
            );
            if is_short {
                continue;
            }
            let name = fresh.part_of_frame(name, part);
            if let Some(shape) = self.shape(value) {
                self.shapes.insert(name.to_string(), shape);
            }
            let named = TypedFormula::new(FormulaKind::Name(name.clone()), value.extent)?;
            let value = std::mem::replace(value, named);
            parts.push(LetStatement { name, value });
        }
        let name = name.clone();
        self.known.insert(name.to_string(), NamedFrame { name, frame });
        Ok(parts)
    }

    /// The shape of a formula, `None` where a name in it is not known.
    fn shape(&self, formula: &TypedFormula) -> Option<ValueShape> {
        let mut known = true;
        formula.visit_names(&mut |name| known &= self.shapes.contains_key(&name.to_string()));
        known.then(|| shape(formula, &|name| self.shapes.get(name).copied()))
    }

    fn is_frame(&self, formula: &TypedFormula) -> bool {
        matches!(&formula.kind, FormulaKind::Name(name) if self.known.contains_key(&name.to_string()))
    }

    fn formula(&mut self, formula: &TypedFormula) -> Result<TypedFormula> {
        match self.value(formula)? {
            Value::Formula(formula) => Ok(formula),
            Value::Frame(_) => Err(syn::Error::new_spanned(
                formula.extent,
                format!("this is a frame and no quantity: write `{formula} * point` for the place of a point"),
            )),
        }
    }

    fn value(&mut self, formula: &TypedFormula) -> Result<Value> {
        let value = match &formula.kind {
            FormulaKind::Name(name) => {
                let word = name.to_string();
                if self.later.contains(&word) {
                    return Err(syn::Error::new(
                        name.span(),
                        format!("`{word}` is used before it is known: move `let {word} = …;` above this"),
                    ));
                }
                if let Some(named) = self.known.get(&word) {
                    self.used.insert(word);
                    return Ok(Value::Frame(named.frame.at(name.span())));
                }
                formula.clone()
            }
            FormulaKind::Parenthesis(inner) => match self.value(inner)? {
                Value::Frame(frame) => return Ok(Value::Frame(frame)),
                Value::Formula(inner) => TypedFormula::new(FormulaKind::Parenthesis(Box::new(inner)), formula.extent)?,
            },
            FormulaKind::Product { first, rest } => return self.product(first, rest),
            FormulaKind::Sum { first, rest } => {
                let mut terms = Chain::of_terms(self.formula(first)?);
                for operand in rest {
                    let term = self.formula(&operand.formula)?;
                    terms.add(operand.operator, operand.span, term)?;
                }
                terms.sum()?
            }
            _ => formula.with_parts(&mut |part| self.formula(part))?,
        };
        Ok(Value::Formula(value))
    }

    /// A product, from left to right.
    fn product(&mut self, first: &TypedFormula, rest: &[Operand]) -> Result<Value> {
        /// The product so far.
        enum Product {
            Factors(Chain),
            Frame(Frame),
        }
        let mut product = match self.value(first)? {
            Value::Formula(formula) => Product::Factors(Chain::of_factors(formula)),
            Value::Frame(frame) => Product::Frame(frame),
        };
        for Operand {
            operator,
            span,
            formula,
        } in rest
        {
            let wrong = |message: &str| Err(syn::Error::new(*span, message));
            product = match (product, operator, self.value(formula)?) {
                (Product::Factors(mut factors), _, Value::Formula(right)) => {
                    factors.times(*operator, *span, right)?;
                    Product::Factors(factors)
                }
                (Product::Frame(frame), ArithmeticOperator::Multiply, Value::Formula(point)) => {
                    self.check_point(&frame, &point)?;
                    Product::Factors(Chain::of_factors(frame.place(point, *span)?))
                }
                (Product::Frame(outer), ArithmeticOperator::Multiply, Value::Frame(inner)) => {
                    if outer.in_plane.is_some() && inner.in_plane.is_some() && outer.in_plane != inner.in_plane {
                        return wrong(
                            "one of these frames is of the plane, and the other of space: declare both alike",
                        );
                    }
                    Product::Frame(outer.times(inner, *span)?)
                }
                (Product::Factors(_), ArithmeticOperator::Multiply, Value::Frame(_)) => {
                    return wrong("a frame places what stands behind it: write the frame first, `platform * point`");
                }
                _ => return wrong("a frame cannot be divided, and nothing by it: write `platform * point`"),
            };
        }
        Ok(match product {
            Product::Factors(factors) => Value::Formula(factors.product()?),
            Product::Frame(frame) => Value::Frame(frame),
        })
    }

    fn check_point(&self, frame: &Frame, point: &TypedFormula) -> Result<()> {
        let (Some(shape), Some(in_plane)) = (self.shape(point), frame.in_plane) else {
            return Ok(());
        };
        let message = match (shape, in_plane) {
            (ValueShape::Space | ValueShape::Rotation, true) => {
                "this frame is one of the plane: write a point of the plane behind it, as `vec2(x, y)`"
            }
            (ValueShape::Scalar, false) if !is_zero(point) => {
                "a frame of space places points of space, but this is a scalar: write `vec3(x, y, z)`"
            }
            (ValueShape::Plane, false) => {
                "a frame of space places points of space, but this is a plane vector: write `vec3(v.x, v.y, 0)`"
            }
            (ValueShape::Rotation, false) => {
                "a frame places points: write the product of rotations without it, or `frame(0, rotation)` for this one"
            }
            _ => return Ok(()),
        };
        Err(syn::Error::new_spanned(point.extent, message))
    }
}
