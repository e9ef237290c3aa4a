//! `#[derive(State)]`: indices, retraction and difference of a struct of scalars, vectors and rotations.
//!
//! A block is a field. Its errors are its elements, or the three of a rotation vector for a rotation. The methods are ordinary Rust in an `impl` block
//! of the DSL, so they become C as the author's own would.
//!
//! Must not know: what an estimator does with the errors.

use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};

use crate::lower::refuse::{self, Place};
use crate::{lower, place};

/// The form of a block.
enum Form {
    Scalar,
    Vector,
    Rotation,
}

/// A number of errors.
enum Size {
    /// A literal.
    Known(usize),
    /// A constant of the author's.
    Named(TokenStream),
}

/// A field of the struct.
struct Block {
    name: syn::Ident,
    form: Form,
    /// Number of its errors.
    size: Size,
    /// Type of its numbers.
    number: TokenStream,
}

/// Returns the `impl` block of a struct, or the mistake at its place.
pub fn derived(item: TokenStream) -> TokenStream {
    syn::parse2(item).and_then(|it| implementation(&it)).unwrap_or_else(|it| it.to_compile_error())
}

fn implementation(item: &syn::DeriveInput) -> syn::Result<TokenStream> {
    let blocks = blocks(item)?;
    let Some(first) = blocks.first() else {
        return Err((&item.ident).error(refuse::STATE_EMPTY));
    };
    let number = &first.number;
    for (block, field) in blocks.iter().zip(fields(item)?) {
        if block.number.to_string() != number.to_string() {
            return Err((&field.ty).error(refuse::STATE_NUMBERS));
        }
    }

    let name = &item.ident;
    let (generics, parameters, bounds) = item.generics.split_for_impl();
    let total = sum(&blocks);
    let constants = blocks.iter().enumerate().map(|(at, block)| {
        let constant = constant(&block.name);
        let before = sum(&blocks[..at]);
        let doc = format!(" {}", first_error(block));
        quote! { #[doc = #doc] pub const #constant: usize = #before; }
    });
    let announced = announced(item, &blocks);
    let retracted = blocks.iter().map(retraction);
    let differences = blocks.iter().map(difference);
    let plain = blocks.iter().all(|it| !matches!(it.form, Form::Rotation));
    let vector = plain.then(|| {
        let written = blocks.iter().map(written);
        let read = blocks.iter().map(read);
        quote! {
            /// Returns the numbers of the blocks, one after the other.
            pub fn vector(&self) -> ::bessemer::nalgebra::SVector<#number, { #total }> {
                let mut vector = ::bessemer::nalgebra::SVector::<#number, { #total }>::zeros();
                #(#written)*
                vector
            }

            /// Returns the state with these numbers.
            pub fn of_vector(vector: &::bessemer::nalgebra::SVector<#number, { #total }>) -> Self {
                #name { #(#read,)* }
            }
        }
    });
    Ok(quote! {
        #[::bessemer::data]
        impl #generics #name #parameters #bounds {
            #(#constants)*

            /// Number of errors.
            pub const ERRORS: usize = #total;

            /// Returns the state moved by errors: a rotation by its three about the body's axes, rad; another block plus its own.
            pub fn retracted(&self, errors: &::bessemer::nalgebra::SVector<#number, { #total }>) -> Self {
                let mut moved = self.clone();
                #(#retracted)*
                moved
            }

            /// Returns the errors that move `from` to this state.
            pub fn difference(&self, from: &Self) -> ::bessemer::nalgebra::SVector<#number, { #total }> {
                let mut errors = ::bessemer::nalgebra::SVector::<#number, { #total }>::zeros();
                #(#differences)*
                errors
            }

            #vector
        }

        #announced
    })
}

/// Returns the registration of a state's indices, which the C has for the firmware. Each instance of a generic state has its own, which its definition adds by
/// [`of_instance`].
fn announced(item: &syn::DeriveInput, blocks: &[Block]) -> TokenStream {
    if !lower::generating() {
        return TokenStream::new();
    }
    let name = &item.ident;
    let (place, site, named) = (place::place(), place::site(name), place::named(name));
    let index = |constant: &syn::Ident, doc: &str| {
        let text = lower::text(constant);
        quote! { __cx.state_index((#named, __arguments), #text, #doc, #site, Self::#constant); }
    };
    let of_blocks = blocks.iter().map(|block| index(&constant(&block.name), &first_error(block)));
    let errors = index(&format_ident!("ERRORS"), "Number of errors.");
    let (generics, parameters, bounds) = item.generics.split_for_impl();
    let method = of_instance();
    let registered = item.generics.params.is_empty().then(|| {
        quote! {
            ::bessemer::generate::register! {
                ::bessemer::generate::Registered::table(#place, #site, |__cx| #name::#method(__cx, &[]))
            }
        }
    });
    quote! {
        const _: () = {
            impl #generics #name #parameters #bounds {
                #[doc(hidden)]
                pub fn #method(
                    __cx: &mut ::bessemer::generate::Builder,
                    __arguments: &[(::bessemer::generate::String, ::bessemer::generate::tree::Argument)],
                ) {
                    #(#of_blocks)*
                    #errors
                }
            }
            #registered
        };
    }
}

/// Returns the name of the method that adds the indices of an instance.
pub fn of_instance() -> syn::Ident {
    format_ident!("__state_indices")
}

/// Returns the documentation of a block's index.
fn first_error(block: &Block) -> String {
    format!("Index of the first error of `{}`.", block.name)
}

/// Returns the named fields of a struct.
fn fields(item: &syn::DeriveInput) -> syn::Result<impl Iterator<Item = &syn::Field>> {
    match &item.data {
        syn::Data::Struct(syn::DataStruct { fields: syn::Fields::Named(fields), .. }) => {
            Ok(fields.named.iter())
        }
        _ => Err((&item.ident).error(refuse::STATE_SHAPE)),
    }
}

fn blocks(item: &syn::DeriveInput) -> syn::Result<Vec<Block>> {
    let mut blocks = Vec::new();
    for field in fields(item)? {
        let Some(name) = field.ident.clone() else { continue };
        let numbers = item.generics.type_params().map(|it| it.ident.to_string());
        blocks.push(block(name, &field.ty, &numbers.collect::<Vec<_>>())?);
    }
    Ok(blocks)
}

/// Returns the block of a field by the name of its type.
///
/// `parameters` are the types over which the state is generic.
fn block(name: syn::Ident, ty: &syn::Type, parameters: &[String]) -> syn::Result<Block> {
    let refused = || ty.error(refuse::STATE_BLOCK);
    let syn::Type::Path(path) = ty else { return Err(refused()) };
    let Some(last) = path.path.segments.last() else { return Err(refused()) };
    let arguments: Vec<TokenStream> = match &last.arguments {
        syn::PathArguments::AngleBracketed(it) => {
            it.args.iter().map(ToTokens::to_token_stream).collect()
        }
        _ => Vec::new(),
    };
    let vector = last.ident.to_string().strip_prefix("Vector").and_then(|it| it.parse().ok());
    let (form, size, number) = match (last.ident.to_string().as_str(), &arguments[..]) {
        ("UnitQuaternion", [number]) => (Form::Rotation, Size::Known(3), number.clone()),
        ("SVector", [number, size]) => {
            let known =
                size.to_string().parse().map_or_else(|_| Size::Named(size.clone()), Size::Known);
            (Form::Vector, known, number.clone())
        }
        (_, [number]) if let Some(size) = vector => {
            (Form::Vector, Size::Known(size), number.clone())
        }
        (number, [])
            if number == "f64" || number == "f32" || parameters.iter().any(|it| it == number) =>
        {
            (Form::Scalar, Size::Known(1), last.ident.to_token_stream())
        }
        _ => return Err(refused()),
    };
    Ok(Block { name, form, size, number })
}

/// Returns the sum of the sizes: one literal, and the author's constants.
fn sum(blocks: &[Block]) -> TokenStream {
    let mut known = 0;
    let mut named = Vec::new();
    for block in blocks {
        match &block.size {
            Size::Known(size) => known += size,
            Size::Named(size) => named.push(size),
        }
    }
    let known = proc_macro2::Literal::usize_unsuffixed(known);
    quote! { #known #(+ #named)* }
}

/// Returns the constant of a block's first index.
fn constant(name: &syn::Ident) -> syn::Ident {
    format_ident!(
        "{}",
        name.to_string().trim_start_matches("r#").to_uppercase(),
        span = name.span()
    )
}

fn length(block: &Block) -> TokenStream {
    match &block.size {
        Size::Known(size) => proc_macro2::Literal::usize_unsuffixed(*size).to_token_stream(),
        Size::Named(size) => size.clone(),
    }
}

/// Returns the statements that move a block by its errors.
fn retraction(block: &Block) -> TokenStream {
    let Block { name, number, .. } = block;
    let (first, size) = (constant(name), length(block));
    match block.form {
        Form::Scalar => quote! { moved.#name += errors[Self::#first]; },
        Form::Vector => quote! {
            for n in 0..#size {
                moved.#name[n] += errors[Self::#first + n];
            }
        },
        Form::Rotation => {
            let turn = format_ident!("{name}_turn");
            quote! {
                let #turn = ::bessemer::nalgebra::Vector3::<#number>::new(
                    errors[Self::#first],
                    errors[Self::#first + 1],
                    errors[Self::#first + 2],
                );
                moved.#name = self.#name * ::bessemer::rotation::from_scaled_axis(#turn);
            }
        }
    }
}

/// Returns the statements that write the errors of a block.
fn difference(block: &Block) -> TokenStream {
    let name = &block.name;
    let (first, size) = (constant(name), length(block));
    match block.form {
        Form::Scalar => quote! { errors[Self::#first] = self.#name - from.#name; },
        Form::Vector => quote! {
            for n in 0..#size {
                errors[Self::#first + n] = self.#name[n] - from.#name[n];
            }
        },
        Form::Rotation => {
            let (change, turn) = (format_ident!("{name}_change"), format_ident!("{name}_turn"));
            quote! {
                let #change = from.#name.inverse() * self.#name;
                let #turn = ::bessemer::rotation::scaled_axis(&#change);
                for n in 0..#size {
                    errors[Self::#first + n] = #turn[n];
                }
            }
        }
    }
}

/// Returns the statements that write the numbers of a block.
fn written(block: &Block) -> TokenStream {
    let name = &block.name;
    let (first, size) = (constant(name), length(block));
    match block.form {
        Form::Scalar => quote! { vector[Self::#first] = self.#name; },
        Form::Vector | Form::Rotation => quote! {
            for n in 0..#size {
                vector[Self::#first + n] = self.#name[n];
            }
        },
    }
}

/// Returns the field of the state with the numbers of a vector.
fn read(block: &Block) -> TokenStream {
    let name = &block.name;
    let (first, size) = (constant(name), length(block));
    match block.form {
        Form::Scalar => quote! { #name: vector[Self::#first] },
        Form::Vector | Form::Rotation => {
            quote! { #name: vector.fixed_rows::<{ #size }>(Self::#first).into_owned() }
        }
    }
}
