//! The implementation of the trait that all mechanisms share.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::prepared::PreparedValues;
use super::{assembly, closure, every, forms, jacobian, transmission};
use crate::describe::{self, DescribedQuantity, Description};
use crate::emit::compiled::{Compiled, local};
use crate::emit::vector_type;
use crate::model::Dimension;

/// `impl Mechanism` and `impl Pose`. The items of the picture and the outputs are added to the former.
pub(in crate::emit) fn tokens(
    mechanism: &Compiled<'_>,
    prepared: Option<&PreparedValues<'_>>,
    picture: &TokenStream,
    outputs: &TokenStream,
) -> TokenStream {
    let runtime = mechanism.runtime;
    let model = mechanism.model;
    let order = mechanism.order();
    let (name, pose) = (&model.name, mechanism.pose(order));
    let (assembly_type, value) = (mechanism.assembly_type(), mechanism.assembly_value());
    let index = local("index");
    let by_number = assembly::by_number(mechanism, &quote!(#index));
    let assembly_count = Literal::usize_unsuffixed(1 << mechanism.choices().len());
    let scalars = mechanism.scalar_parameters();
    let size = |count: usize| Literal::usize_unsuffixed(count);
    let residual_count = size(
        model
            .equations
            .iter()
            .map(|equation| equation.residual.nodes().len())
            .sum(),
    );
    let (parameter_count, input_count, unknown_count) = (
        size(scalars.len()),
        size(model.inputs.len()),
        size(model.unknowns.len()),
    );
    let output_count = size(model.outputs.iter().map(|output| output.value.nodes().len()).sum());
    let values = scalars.iter().map(|(_, value, ..)| value);
    let (parameters, convert) = (local("parameters"), local("convert"));
    let mut next = 0;
    let mut from_array = Vec::new();
    let mut converted = Vec::new();
    for parameter in &model.parameters {
        let field = &parameter.name;
        let shape = parameter.dimension.shape();
        if let Some(vector) = vector_type(shape) {
            let axes = shape.axes();
            let indices = (next..next + axes.len()).map(size);
            next += axes.len();
            from_array.push(quote!(#field: #runtime::#vector::new(#(#parameters[#indices]),*)));
            let axes = axes.iter().map(|axis| local(&axis.to_string()));
            converted.push(quote!(#field: #runtime::#vector::new(#(#convert(self.#field.#axes)),*)));
        } else {
            let index = size(next);
            next += 1;
            from_array.push(quote!(#field: #parameters[#index]));
            converted.push(quote!(#field: #convert(self.#field)));
        }
    }
    let inputs = local("inputs");
    let inputs_in_order: Vec<TokenStream> = (0..model.inputs.len())
        .map(|index| {
            let index = size(index);
            quote!(#inputs[#index])
        })
        .collect();
    let (unknowns, wanted, near) = (local("unknowns"), mechanism.fresh("assembly"), local("near"));
    let (length, block_count) = (size(order + 1), size(mechanism.blocks.len()));
    let is_coupled = mechanism.is_coupled();
    let (assembly_type, value) = if is_coupled {
        (quote!(#runtime::Near<#unknown_count>), quote!(#wanted))
    } else {
        (assembly_type, value)
    };
    let assembly_count = if is_coupled { size(0) } else { assembly_count };
    let assembly_by_number = if is_coupled {
        quote!(let _ = #index; ::core::option::Option::None)
    } else {
        quote! {
            (#index < Self::ASSEMBLY_COUNT).then(|| #by_number)
        }
    };
    let assembly_at = if is_coupled {
        quote!(let _ = #inputs; #runtime::Near(#near.map(#runtime::Number::real)))
    } else if value.is_empty() {
        quote!(let _ = (#inputs, #near);)
    } else {
        quote!(self.assembly_at(#(#inputs_in_order,)* #near))
    };
    let values_near = is_coupled.then(|| {
        quote! {
            fn values_near(
                #wanted: Self::Assembly,
            ) -> ::core::option::Option<[::core::primitive::f64; #unknown_count]> {
                ::core::option::Option::Some(#wanted.0)
            }
        }
    });
    let description = description(mechanism);
    let formulas = super::formulas::constant(mechanism);
    let unknown_motions = model.unknowns.iter().enumerate().map(|(index, unknown)| {
        let field = &unknown.name;
        if mechanism.is_direction(index) {
            let value = mechanism.unknown_value(index, &quote!(self));
            quote!(self.#field.motion_from(#value))
        } else {
            quote!(self.#field)
        }
    });
    let directions = directions(mechanism);
    let position_near = quote!(self.position_near(#(#inputs_in_order,)* #near));
    let unknowns_near = if mechanism.has_directions() {
        quote!(#position_near.map(|position| position.unknowns_near(#near)))
    } else {
        quote!(#position_near.map(|position| position.unknowns()))
    };
    let output_fields = model.outputs.iter().map(|output| {
        let field = &output.name;
        let axes = output.value.shape().axes();
        if axes.is_empty() {
            return quote!(self.#field);
        }
        let axes = axes.iter().map(|axis| local(&axis.to_string()));
        quote!(#(self.#field.#axes()),*)
    });
    let ignore = if value.is_empty() {
        quote!(let () = #wanted;)
    } else {
        TokenStream::new()
    };
    // A batch solves several poses at a time, and its calls are inlined from end to end.
    let number = mechanism.type_parameter("Number");
    let in_lanes = quote!(#[inline(always)]);
    let complete = |position: TokenStream| {
        quote! {
            let position = #position?;
            self.__complete(position, #(#inputs_in_order),*)
        }
    };
    let prepared_name = local("prepared");
    let given = prepared.map(|_| quote!(#prepared_name,));
    let (prepared_type, prepare, ignore_prepared) = prepared.map_or_else(
        || (quote!(()), TokenStream::new(), Some(quote!(let () = #prepared_name;))),
        |prepared| (prepared.kind(), quote!(self.__prepared()), None),
    );
    let (solve, solve_near) = if is_coupled {
        (
            quote!(self.solve(#(#inputs_in_order,)* #value)),
            complete(quote!(self.position_near(#(#inputs_in_order.position(),)* #near))),
        )
    } else {
        let value = if value.is_empty() { quote!() } else { quote!(#value,) };
        (
            complete(quote! {
                self.__position(#given #(#inputs_in_order.position(),)* #value ::core::option::Option::None)
            }),
            quote!(self.solve_near(#(#inputs_in_order,)* #near)),
        )
    };
    let (forms, jacobian) = (forms::tokens(mechanism), jacobian::tokens(mechanism));
    let (angles, positions, closure) = (
        transmission::implementation(mechanism),
        every::implementation(mechanism),
        closure::tokens(mechanism),
    );
    quote! {
        impl<T: #runtime::Scalar> #runtime::Mechanism for #name<T> {
            type Scalar = T;
            type With<#number: #runtime::Scalar> = #name<#number>;
            type Assembly = #assembly_type;
            type Motion<Element: ::core::marker::Copy> = #runtime::Motion<Element, #length>;
            type Pose = #pose<T>;
            type Parameters<Element: ::core::marker::Copy> = [Element; #parameter_count];
            type Inputs<Element: ::core::marker::Copy> = [Element; #input_count];
            type Unknowns<Element: ::core::marker::Copy> = [Element; #unknown_count];
            type Residuals<Element: ::core::marker::Copy> = [Element; #residual_count];
            type Prepared = #prepared_type;

            const DESCRIPTION: #runtime::Description = #description;
            const FORMULAS: #runtime::Formulas = #formulas;
            const ASSEMBLY_COUNT: ::core::primitive::usize = #assembly_count;

            #runtime::lent! { #parameter_count #input_count #unknown_count #block_count #length }

            fn assembly(#index: ::core::primitive::usize) -> ::core::option::Option<Self::Assembly> {
                #assembly_by_number
            }

            fn assembly_at(&self, #inputs: [T; #input_count], #near: [T; #unknown_count]) -> Self::Assembly {
                #assembly_at
            }

            #values_near

            fn from_parameters(#parameters: [T; #parameter_count]) -> Self {
                Self { #(#from_array),* }
            }

            fn parameters(&self) -> [T; #parameter_count] {
                [#(#values),*]
            }

            fn convert<#number: #runtime::Scalar>(
                &self,
                mut #convert: impl ::core::ops::FnMut(T) -> #number,
            ) -> #name<#number> {
                #name { #(#converted),* }
            }

            #in_lanes
            fn prepare(&self) -> Self::Prepared {
                #prepare
            }

            #in_lanes
            fn solve_prepared(
                &self,
                #prepared_name: &Self::Prepared,
                #inputs: [#runtime::Motion<T, #length>; #input_count],
                #wanted: Self::Assembly,
            ) -> ::core::result::Result<Self::Pose, #runtime::SolveError> {
                #ignore
                #ignore_prepared
                #solve
            }

            #in_lanes
            fn solve_near(
                &self,
                #inputs: [#runtime::Motion<T, #length>; #input_count],
                #near: [T; #unknown_count],
            ) -> ::core::result::Result<Self::Pose, #runtime::SolveError> {
                #solve_near
            }

            fn position(
                &self,
                #inputs: [T; #input_count],
                #wanted: Self::Assembly,
            ) -> ::core::result::Result<[T; #unknown_count], #runtime::SolveError> {
                #ignore
                self.position(#(#inputs_in_order,)* #value).map(|position| position.unknowns())
            }

            fn position_near(
                &self,
                #inputs: [T; #input_count],
                #near: [T; #unknown_count],
            ) -> ::core::result::Result<[T; #unknown_count], #runtime::SolveError> {
                #unknowns_near
            }

            fn closure(&self, #inputs: [T; #input_count], #unknowns: [T; #unknown_count]) -> [T; #residual_count] {
                self.closure(#(#inputs_in_order,)* #unknowns)
            }

            #forms

            #angles

            #jacobian

            #positions

            #closure

            #picture

            #outputs
        }

        impl<T: #runtime::Scalar> #runtime::Pose for #pose<T> {
            type Scalar = T;
            type Motion = #runtime::Motion<T, #length>;
            type Unknowns<Element: ::core::marker::Copy> = [Element; #unknown_count];
            type Outputs<Element: ::core::marker::Copy> = [Element; #output_count];

            #in_lanes
            fn unknown_motions(&self) -> [#runtime::Motion<T, #length>; #unknown_count] {
                [#(#unknown_motions),*]
            }

            #directions

            #in_lanes
            fn output_motions(&self) -> [#runtime::Motion<T, #length>; #output_count] {
                [#(#output_fields),*]
            }
        }
    }
}

/// The methods of a pose for unknowns that it holds as unit vectors.
fn directions(mechanism: &Compiled<'_>) -> TokenStream {
    if !mechanism.has_directions() {
        return TokenStream::new();
    }
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let [length, count] = [mechanism.order() + 1, model.unknowns.len()].map(Literal::usize_unsuffixed);
    let near = local("near");
    let (mut motions_near, mut columns, mut sines) = (Vec::new(), Vec::new(), Vec::new());
    for (index, unknown) in model.unknowns.iter().enumerate() {
        let (field, position) = (&unknown.name, Literal::usize_unsuffixed(index));
        if mechanism.is_direction(index) {
            let value = mechanism.unknown_value_near(index, &quote!(#near[#position]));
            motions_near.push(quote!(self.#field.motion_from(#value)));
            columns.push(quote!(self.#field.motion_from(self.#field.cosine())));
            sines.push(quote!(::core::option::Option::Some(self.#field.sine())));
        } else {
            motions_near.push(quote!(self.#field));
            columns.push(quote!(self.#field));
            sines.push(quote!(::core::option::Option::None));
        }
    }
    quote! {
        fn unknown_motions_near(&self, #near: [T; #count]) -> [#runtime::Motion<T, #length>; #count] {
            [#(#motions_near),*]
        }

        #[inline(always)]
        fn unknown_columns(&self) -> [#runtime::Motion<T, #length>; #count] {
            [#(#columns),*]
        }

        #[inline(always)]
        fn unknown_sines(&self) -> [::core::option::Option<T>; #count] {
            [#(#sines),*]
        }
    }
}

fn description(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let Description {
        name,
        parameters,
        inputs,
        unknowns,
        outputs,
        equations,
        blocks,
        order,
        ..
    } = describe::description(mechanism.model, mechanism.blocks, mechanism.solvers);
    let quantities = |quantities: Vec<DescribedQuantity>| {
        let quantities = quantities.iter().map(|quantity| {
            let kind = local(match quantity.dimension {
                Dimension::Angle => "angle",
                Dimension::Scalar => "scalar",
                _ => "length",
            });
            let (name, text) = (&quantity.name, &quantity.text);
            let range = quantity.has_range.then(|| quote!(.with_range()));
            let direction = quantity.is_direction.then(|| quote!(.as_direction()));
            quote!(#runtime::Quantity::#kind(#name, #text) #range #direction)
        });
        quote!(&[#(#quantities),*])
    };
    let [parameters, inputs, unknowns, outputs] = [parameters, inputs, unknowns, outputs].map(quantities);
    let blocks = blocks.iter().map(|block| {
        let (unknowns, solution) = (&block.unknowns, &block.solution);
        let [members, equations] = [&block.members, &block.equations].map(|indices| {
            let indices = indices.iter().map(|&index| Literal::usize_unsuffixed(index));
            quote!(&[#(#indices),*])
        });
        quote!(#runtime::Block::__new(#unknowns, #solution, #members, #equations))
    });
    let order = Literal::usize_unsuffixed(order);
    let operations = &mechanism.model.name;
    quote! {
        #runtime::Description::__new(
            #name,
            #parameters,
            #inputs,
            #unknowns,
            #outputs,
            &[#(#equations),*],
            &[#(#blocks),*],
            #order,
            &#operations::<::core::primitive::f64>::OPERATIONS,
        )
    }
}
