//! Translated methods as Rust.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};

use super::vector_type;
use crate::model::{Model, ValueShape};
use crate::precedence::Precedence;
use crate::syntax::{Declaration, Statement};
use crate::translate::tree::{Binding, Local, Operation, Sheet, Step, Tree, TreeKind};

/// The names that a translated method calls its values by.
pub(super) struct SheetText<'a> {
    pub(super) model: &'a Model,
    pub(super) runtime: &'a TokenStream,
    abbreviations: Vec<&'a Ident>,
    /// The fields of the parameters, by the numbers of their scalars.
    fields: Vec<&'a Ident>,
}

/// A formula in Rust.
struct Written {
    precedence: Precedence,
    tokens: TokenStream,
}

impl Written {
    fn atom(tokens: TokenStream) -> Self {
        let precedence = Precedence::Atom;
        Self { precedence, tokens }
    }

    /// The formula, in parentheses if its operator binds less tightly than the formula around it requires.
    fn within(self, outside: Precedence) -> TokenStream {
        let tokens = self.tokens;
        if self.precedence.needs_parentheses(outside) {
            quote_spanned!(Span::mixed_site()=> (#tokens))
        } else {
            tokens
        }
    }

    /// An operator behind the formula. It is not copied, because it may be long.
    fn extended(&mut self, precedence: Precedence, operator: impl ToTokens) {
        let formula = std::mem::replace(self, Self::atom(TokenStream::new()));
        let mut tokens = formula.within(precedence);
        operator.to_tokens(&mut tokens);
        *self = Self { precedence, tokens };
    }
}

impl<'a> SheetText<'a> {
    pub(super) fn new(declaration: &'a Declaration, model: &'a Model, runtime: &'a TokenStream) -> Self {
        let abbreviations = declaration.statements.iter().filter_map(Statement::abbreviation);
        let abbreviations = abbreviations.map(|(name, _)| name);
        let fields = model.parameters.iter().flat_map(|parameter| {
            let scalars = parameter.dimension.shape().axes().len().max(1);
            std::iter::repeat_n(&parameter.name, scalars)
        });
        Self {
            model,
            runtime,
            abbreviations: abbreviations.collect(),
            fields: fields.collect(),
        }
    }

    /// `let` for the inputs and unknowns that a method uses.
    pub(super) fn rows(&self, sheet: &Sheet) -> TokenStream {
        let inputs: Vec<&Ident> = self.model.inputs.iter().map(|input| &input.name).collect();
        let unknowns: Vec<&Ident> = self.model.unknowns.iter().map(|unknown| &unknown.name).collect();
        let [used_inputs, used_unknowns] = used(sheet);
        let mut body = TokenStream::new();
        for (names, used, row) in [(inputs, used_inputs, "inputs"), (unknowns, used_unknowns, "unknowns")] {
            let row = Ident::new(row, Span::mixed_site());
            if used.is_empty() {
                body.extend(quote!(let _ = #row;));
            } else {
                let pattern = pattern(names.into_iter(), &used);
                body.extend(quote!(let #pattern = #row;));
            }
        }
        body
    }

    /// The local values of a method.
    pub(super) fn bindings(&self, sheet: &Sheet) -> TokenStream {
        let bindings = sheet.bindings.iter().map(|Binding { local, value }| {
            let (name, tokens) = (self.local(*local), self.tokens(value));
            let kind = matches!(local, Local::Joint(_)).then(|| {
                let (runtime, vector) = (self.runtime, vector_type(value.shape));
                quote!(: #runtime::#vector<T>)
            });
            quote_spanned!(Span::mixed_site()=> let #name #kind = #tokens;)
        });
        bindings.collect()
    }

    /// The results of a method.
    pub(super) fn results(&self, sheet: &Sheet) -> Vec<TokenStream> {
        sheet.results.iter().map(|result| self.tokens(result)).collect()
    }

    fn local(&self, local: Local) -> TokenStream {
        let name = match local {
            Local::Abbreviation(index) => return self.abbreviations[index].to_token_stream(),
            Local::Equation(number) => format!("equation_{number}"),
            Local::Output(number) => format!("output_{number}"),
            Local::Joint(number) => format!("joint_{number}"),
        };
        Ident::new(&name, Span::mixed_site()).to_token_stream()
    }

    fn tokens(&self, tree: &Tree) -> TokenStream {
        self.written(tree).tokens
    }

    fn written(&self, tree: &Tree) -> Written {
        let site = Span::mixed_site();
        Written::atom(match &tree.kind {
            TreeKind::Number(value) => number(*value),
            TreeKind::Pi => quote_spanned!(site=> T::constant(::core::f64::consts::PI)),
            TreeKind::Parameter(index) => {
                let name = self.fields[*index];
                quote_spanned!(site=> self.#name)
            }
            TreeKind::Input(index) => self.model.inputs[*index].name.to_token_stream(),
            TreeKind::Unknown(index) => self.model.unknowns[*index].name.to_token_stream(),
            TreeKind::Local(local) => self.local(*local),
            TreeKind::Negative(of) => {
                let operand = self.written(of).within(Precedence::Atom);
                let (precedence, tokens) = (Precedence::Sign, quote_spanned!(site=> -#operand));
                return Written { precedence, tokens };
            }
            TreeKind::Chain { first, steps } => return self.chain(first, steps),
            TreeKind::Call(operation, arguments) => self.call(tree.shape, *operation, arguments),
            TreeKind::Power(base, exponent) => {
                let base = self.written(base).within(Precedence::Atom);
                let exponent = Literal::i32_unsuffixed(*exponent);
                quote_spanned!(site=> #base.powi(#exponent))
            }
            TreeKind::Part(of, axis) => {
                let of = self.written(of).within(Precedence::Atom);
                let part = Ident::new(&axis.to_string(), site);
                quote_spanned!(site=> #of.#part)
            }
        })
    }

    fn chain(&self, first: &Tree, steps: &[Step]) -> Written {
        let (site, runtime) = (Span::mixed_site(), self.runtime);
        let mut written = self.written(first);
        let mut kind = vector_type(first.shape);
        let mut before = TokenStream::new();
        for step in steps {
            let value = &written.tokens;
            written = Written::atom(match step {
                Step::Named => {
                    let name = Ident::new("value", site);
                    before.extend(quote_spanned!(site=> let #name = #value;));
                    quote!(#name)
                }
                Step::Lifted(shape) => {
                    kind = vector_type(*shape);
                    self.lifted(*shape, value)
                }
                Step::Plus(operand) => {
                    let operand = self.written(operand).within(Precedence::Product);
                    written.extended(Precedence::Sum, quote_spanned!(site=> + #operand));
                    continue;
                }
                Step::Minus(operand) => {
                    let operand = self.written(operand).within(Precedence::Product);
                    written.extended(Precedence::Sum, quote_spanned!(site=> - #operand));
                    continue;
                }
                Step::Times(operand) => {
                    let operand = self.written(operand).within(Precedence::Sign);
                    written.extended(Precedence::Product, quote_spanned!(site=> * #operand));
                    continue;
                }
                Step::Over(operand) => {
                    let operand = self.written(operand).within(Precedence::Sign);
                    written.extended(Precedence::Product, quote_spanned!(site=> / #operand));
                    continue;
                }
                Step::ScaledBy(operand) => {
                    let operand = self.tokens(operand);
                    quote_spanned!(site=> #runtime::#kind::scale(#value, #operand))
                }
                Step::Scaling(operand) => {
                    kind = vector_type(operand.shape);
                    let operand = self.tokens(operand);
                    quote_spanned!(site=> #runtime::#kind::scale(#operand, #value))
                }
                Step::ScaledByInverse(operand) => {
                    let (one, operand) = (number(1.0), self.written(operand).within(Precedence::Sign));
                    quote_spanned!(site=> #runtime::#kind::scale(#value, #one / #operand))
                }
                Step::LengthAt(operand) => {
                    kind = vector_type(ValueShape::Plane);
                    let operand = self.tokens(operand);
                    quote_spanned!(site=> #runtime::Plane::polar(#value, #operand))
                }
                Step::ComplexTimes(operand) => {
                    let operand = self.tokens(operand);
                    quote_spanned!(site=> #runtime::Plane::times(#value, #operand))
                }
                Step::RotationTimes(operand) => {
                    let operand = self.tokens(operand);
                    quote_spanned!(site=> #runtime::Rotation::times(#value, #operand))
                }
                Step::Rotating(operand) => {
                    kind = vector_type(operand.shape);
                    let operand = self.tokens(operand);
                    quote_spanned!(site=> #runtime::Rotation::rotate(#value, #operand))
                }
            });
        }
        if before.is_empty() {
            return written;
        }
        let tokens = written.tokens;
        Written::atom(quote_spanned!(site=> { #before #tokens }))
    }

    fn lifted(&self, shape: ValueShape, x: &TokenStream) -> TokenStream {
        let (runtime, vector, zero) = (self.runtime, vector_type(shape), number(0.0));
        let zeros = shape.axes().iter().skip(1).map(|_| &zero);
        quote_spanned!(Span::mixed_site()=> #runtime::#vector::new(#x #(, #zeros)*))
    }

    fn call(&self, shape: ValueShape, operation: Operation, arguments: &[Tree]) -> TokenStream {
        let (site, runtime) = (Span::mixed_site(), self.runtime);
        let taken = arguments.first().map_or(shape, |first| first.shape);
        let arguments: Vec<TokenStream> = arguments.iter().map(|argument| self.tokens(argument)).collect();
        let of = |kind: TokenStream, function: &str| {
            let function = Ident::new(function, site);
            quote_spanned!(site=> #kind::#function(#(#arguments),*))
        };
        let typed = |kind: &str| {
            let kind = Ident::new(kind, site);
            quote_spanned!(site=> #runtime::#kind)
        };
        let vector = |shape: ValueShape| {
            let kind = vector_type(shape);
            quote_spanned!(site=> #runtime::#kind)
        };
        match operation {
            Operation::Sine => quote_spanned!(site=> T::sin_cos(#(#arguments),*).0),
            Operation::Cosine => quote_spanned!(site=> T::sin_cos(#(#arguments),*).1),
            Operation::Tangent => quote_spanned! {site=> {
                let (sine, cosine) = T::sin_cos(#(#arguments),*);
                sine / cosine
            }},
            Operation::Method(function) => of(quote_spanned!(site=> T), function.name()),
            Operation::Zero => of(vector(shape), "zero"),
            Operation::Vector => of(vector(shape), "new"),
            Operation::Lifted => self.lifted(shape, &quote!(#(#arguments)*)),
            Operation::InSpace => {
                let (plane, zero) = (Ident::new("plane", site), number(0.0));
                quote!({ let #plane = #(#arguments)*; #runtime::Space::new(#plane.x, #plane.y, #zero) })
            }
            Operation::Cis => of(typed("Plane"), "cis"),
            Operation::Polar => of(typed("Plane"), "polar"),
            Operation::AboutX => of(typed("Rotation"), "about_x"),
            Operation::AboutY => of(typed("Rotation"), "about_y"),
            Operation::AboutZ => of(typed("Rotation"), "about_z"),
            Operation::About => of(typed("Rotation"), "about"),
            Operation::Dot => of(vector(taken), "dot"),
            Operation::Cross => of(vector(taken), "cross"),
            Operation::Norm => of(vector(taken), "norm"),
        }
    }
}

/// The inputs and the unknowns in a method.
pub(super) fn used(sheet: &Sheet) -> [BTreeSet<usize>; 2] {
    let [mut inputs, mut unknowns] = [BTreeSet::new(), BTreeSet::new()];
    sheet.visit(&mut |tree| {
        match tree.kind {
            TreeKind::Input(index) => inputs.insert(index),
            TreeKind::Unknown(index) => unknowns.insert(index),
            _ => false,
        };
    });
    [inputs, unknowns]
}

/// A pattern of names, without the unused ones.
pub(super) fn pattern<'a>(names: impl Iterator<Item = &'a Ident>, used: &BTreeSet<usize>) -> TokenStream {
    let names = names.enumerate().map(|(index, name)| {
        if used.contains(&index) {
            quote!(#name)
        } else {
            quote!(_)
        }
    });
    quote_spanned!(Span::mixed_site()=> [#(#names),*])
}

/// A number of the type `T`.
fn number(value: f64) -> TokenStream {
    let value = Literal::f64_unsuffixed(value);
    quote_spanned!(Span::mixed_site()=> T::constant(#value))
}
