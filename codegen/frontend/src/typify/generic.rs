//! C types that no author named: tuples, `Option`, `Result`, and the payloads of enums.
//!
//! A standard type is named by its content (`option_f64`, `pair_f64_bool`), so that further types do not change its
//! name.

use bessemer_ir::tree::{self, Site, Ty};
use bessemer_ir::{
    Enum, EnumId, Field, Form, Given, Scalar, Span, Struct, StructId, Type, Variant,
};

use super::context::{Case, Context, Home};
use super::names::{arity, part, snake};
use super::words;
use super::{Result, problem, refusals, refused};

/// The payload of a variant: one value, or a struct of several.
pub(super) struct Payload {
    pub ty: Type,
    /// rustc's type of the one value.
    pub only: Option<Ty>,
    /// The author's attributes of the one value.
    pub given: Given,
}

impl Context<'_> {
    /// Returns the struct for a tuple with parts of these types.
    pub(super) fn tuple(&mut self, types: Vec<Type>, site: Site) -> Result<StructId> {
        if types.contains(&Type::Unit) {
            return refused(site, refusals::EMPTY_PART);
        }
        let words: String = types.iter().map(|ty| self.word(ty)).collect();
        let name = format!("{}{words}", capitalised(&arity(types.len())));
        let shown: Vec<_> = types.iter().map(|ty| self.show(ty)).collect();
        let shown = format!("({}{})", shown.join(", "), if types.len() == 1 { "," } else { "" });
        let count = types.len();
        let fields = types.into_iter().enumerate();
        let fields = fields.map(|(index, ty)| field(&part(index, count), "", ty)).collect();
        self.own_struct(name, (shown, ""), fields, Form::Record, site)
    }

    /// Returns the struct that represents a slice in a value: two numbers, or one for `&mut T`.
    pub(super) fn borrowed_struct(
        &mut self,
        element: &Type,
        (mutable, one): (bool, bool),
        site: Site,
    ) -> Result<StructId> {
        let (word, shown) = (self.word(element), self.show(element));
        let (name, shown) = match (mutable, one) {
            (_, true) => (format!("ElementMut{word}"), format!("&mut {shown}")),
            (true, false) => (format!("SliceMut{word}"), format!("&mut [{shown}]")),
            (false, false) => (format!("Slice{word}"), format!("&[{shown}]")),
        };
        let (meaning, fields) = match one {
            true => (
                ": an element of an array, which stands beside it",
                [field(words::ENDS_OF_ONE[0], "Its index.", Type::USIZE)].into(),
            ),
            false => (
                ": some elements of an array, which stands beside it",
                vec![
                    field(words::ENDS[0], "The index of the first one.", Type::USIZE),
                    field(words::ENDS[1], "How many there are.", Type::USIZE),
                ],
            ),
        };
        self.own_struct(name, (shown, meaning), fields, Form::Record, site)
    }

    /// Returns the struct for a list of at most `n` elements.
    pub(super) fn list(&mut self, element: Type, n: u32, site: Site) -> Result<StructId> {
        if !self.slices_in(&element).is_empty() {
            return refused(site, refusals::MANY_SLICES);
        }
        if element == Type::Unit || n == 0 {
            return refused(site, refusals::EMPTY_LIST);
        }
        let name = format!("List{n}{}", self.word(&element));
        let shown = (format!("List<{}, {n}>", self.show(&element)), ": elements and their number");
        let items = Type::Array { element: Box::new(element), len: n };
        let fields = vec![
            field(words::LENGTH, "Number of elements.", Type::USIZE),
            field(words::ITEMS, "The elements; those behind the length mean nothing.", items),
        ];
        self.own_struct(name, shown, fields, Form::Sequence, site)
    }

    /// Returns the struct for an `Option`, or for a `Result` with this error: a tag, and a field for each payload.
    pub(super) fn outcome(
        &mut self,
        (of, value): (&Ty, Type),
        error: Option<(&Ty, Type)>,
        site: Site,
    ) -> Result<StructId> {
        let (or, error) = error.unzip();
        let (mut name, mut shown) = (self.content(of, &value), self.shown_content(of, &value));
        if let (Some(or), Some(error)) = (or, &error) {
            name += &self.content(or, error);
            shown = format!("{shown}, {}", self.shown_content(or, error));
        }
        let (kind, meaning, flag, [missing, there]) = match or {
            None => ("Option", ": a value, or none", words::IS_SOME, ["None", "Some"]),
            Some(_) => (
                "Result",
                ": a value, or the reason why there is none",
                words::IS_OK,
                ["Err", "Ok"],
            ),
        };
        let shown = (format!("{kind}<{shown}>"), meaning);
        let mut fields = vec![field(flag, "True if there is a value.", Type::BOOL)];
        let value = held(&mut fields, words::VALUE, "The value, if there is one.", value);
        let error = error
            .and_then(|ty| held(&mut fields, words::ERROR, "Reason why there is no value.", ty));
        let form = Form::Choice(vec![error, value]);
        let id = self.own_struct(format!("{kind}{name}"), shown, fields, form, site)?;
        // A value may differ from itself, as NaN does.
        let unequal = self.may_differ(of) || or.is_some_and(|or| self.may_differ(or));
        let case = |name: &str, field, single| Case { name: name.into(), field, single };
        let known = self.note(&Type::Struct(id));
        known.unequal |= unequal;
        known.error = or.cloned();
        known.cases = vec![case(missing, error, or.is_some()), case(there, value, true)];
        Ok(id)
    }

    /// Adds a struct for a standard type. It belongs to the header of the author's type that it contains; of several
    /// types, to the one defined last, so that headers do not include each other. Without an author's type it has its
    /// own header.
    fn own_struct(
        &mut self,
        name: String,
        (shown, meaning): (String, &str),
        fields: Vec<Field>,
        form: Form,
        site: Site,
    ) -> Result<StructId> {
        if self.types.generics.values().any(|ty| self.name_of(ty) == Some(&name)) {
            return problem(
                site,
                format!("two types would both be `{}_t` in the C", snake(&name)),
                "declare a struct marked `#[data]` in place of one of them",
            );
        }
        let home =
            fields.iter().filter_map(|field| self.home(&field.ty)).max_by_key(|home| home.order);
        let (module, span) = match &home {
            Some(home) => (home.module.clone(), home.span),
            None => {
                let package = self.module.name.replace('-', "_");
                (format!("{package}::{}", snake(&name)), Span::default())
            }
        };
        let docs = vec![format!("`{shown}`{meaning}.")];
        let item = Struct { name, module, docs, fields, form, span, ..Struct::default() };
        let id = self.add_struct(item);
        let known = self.note(&Type::Struct(id));
        known.shown = Some(shown);
        known.home = home;
        Ok(id)
    }

    /// Returns the location of the author's type in a type.
    fn home(&self, ty: &Type) -> Option<Home> {
        match ty {
            Type::Array { element, .. } => self.home(element),
            other => self.known(other).home.clone(),
        }
    }

    /// Returns the content of an `Option` or a `Result` as part of its name.
    fn content(&self, ty: &Ty, lowered: &Type) -> String {
        match self.nothing_of(ty) {
            Some(it) => self.qualified(&it.name, &it.module),
            None => self.word(lowered),
        }
    }

    /// Returns the content as its author writes it.
    fn shown_content(&self, ty: &Ty, lowered: &Type) -> String {
        self.nothing_of(ty).map_or_else(|| self.show(lowered), |it| it.name.clone())
    }

    /// Returns a type as part of a name.
    fn word(&self, ty: &Type) -> String {
        let scalar = |scalar: Scalar| capitalised(scalar.name());
        match ty {
            Type::Unit | Type::Slice(_) => "Unit".into(),
            Type::Scalar(it) => scalar(*it),
            Type::Array { element, len } => format!("{}x{len}", self.word(element)),
            Type::Matrix { element, rows, cols: 1 } => format!("Vector{rows}{}", scalar(*element)),
            Type::Matrix { element, rows, cols } => {
                format!("Matrix{rows}x{cols}{}", scalar(*element))
            }
            Type::Struct(id) => {
                let item = &self.module.structs[id.index()];
                self.qualified(&item.name, &item.module)
            }
            Type::Enum(id) => {
                let item = &self.module.enums[id.index()];
                self.qualified(&capitalised(&item.name), &item.module)
            }
        }
    }

    /// Returns the name of an author's type. It has its module if two types have the same name, and further modules if
    /// these are equal too.
    fn qualified(&self, name: &str, module: &str) -> String {
        let homes = self.package.types.iter().filter(|it| it.name == name);
        let homes: Vec<&str> = homes.map(|it| it.module.as_str()).collect();
        // `Option<F32>` of an author's `F32` is not the `Option<f32>` beside it.
        if homes.len() < 2 && Scalar::from_name(&snake(name)).is_some() {
            return format!("Own{name}");
        }
        if homes.len() < 2 {
            return name.to_owned();
        }
        let alike = homes.iter().any(|home| *home != module && last(home) == last(module));
        let below = module.split_once("::").map_or(module, |(_, below)| below);
        let told = if alike { below } else { last(module) };
        let words: String = told.split(['_', ':']).map(capitalised).collect();
        format!("{words}{name}")
    }

    /// Adds an enum: plain, or a tag with payloads.
    pub(super) fn define_enum(
        &mut self,
        variants: &[tree::Variant],
        payloads: Vec<Option<Payload>>,
        named: Enum,
    ) -> Type {
        if variants.iter().all(|variant| variant.fields.is_empty()) {
            self.module.enums.push(named);
            return Type::Enum(EnumId(self.module.enums.len() as u32 - 1));
        }
        let Enum { name, module, docs, given, span, .. } = named.clone();
        let tag = EnumId(self.module.enums.len() as u32);
        let mut fields = vec![field(words::TAG, "Which variant it is.", Type::Enum(tag))];
        // The tag refers to nothing.
        let (mut cases, mut rustc) = (Vec::new(), vec![Ty::Unit]);
        for (variant, payload) in variants.iter().zip(payloads) {
            let held = payload.map(|Payload { ty, only, given }| {
                let name = snake(&variant.name);
                let name = if name == "tag" { "tag_".to_owned() } else { name };
                let single = only.is_some();
                rustc.push(only.unwrap_or(Ty::Unit));
                fields.push(Field { name, docs: variant.docs.clone(), ty, given });
                (fields.len() as u32 - 1, single)
            });
            let (field, single) = held.unzip();
            let single = single.unwrap_or_default();
            cases.push(Case { name: variant.name.clone(), field, single });
        }
        self.module.enums.push(Enum {
            name: self.free_name(format!("{name}Tag")),
            docs: vec![format!("Which variant of `{name}`.")],
            given: beside(&named.given, words::TAG),
            ..named
        });
        let form = Form::Choice(cases.iter().map(|case| case.field).collect());
        let item = Struct { name, module, docs, fields, form, given, span, ..Struct::default() };
        let id = self.add_struct(item);
        let ty = Type::Struct(id);
        let known = self.note(&ty);
        (known.cases, known.rustc) = (cases, rustc);
        ty
    }

    /// Returns the payload of a variant with these fields; `kept` has false for a field that is zero-sized.
    pub(super) fn payload(
        &mut self,
        named: &Enum,
        variant: &tree::Variant,
        (fields, kept): (Vec<Field>, Vec<bool>),
        site: Site,
    ) -> Result<Option<Payload>> {
        if kept.len() > 1 && kept.contains(&false) {
            return problem(
                site,
                format!("a part of `{}` is zero-sized", variant.name),
                "leave it out of the variant",
            );
        }
        let is_tuple = variant.fields.iter().all(|field| field.name.parse::<u32>().is_ok());
        match fields.as_slice() {
            [] => Ok(None),
            [only] if is_tuple => {
                let (ty, given) = (only.ty.clone(), only.given.clone());
                let only = variant.fields.first().map(|part| part.ty.clone());
                Ok(Some(Payload { ty, only, given }))
            }
            _ => {
                let id = self.add_struct(Struct {
                    name: self.free_name(format!("{}{}", named.name, variant.name)),
                    module: named.module.clone(),
                    docs: vec![format!(
                        "Fields of the variant {} of {}.",
                        variant.name, named.name
                    )],
                    fields,
                    given: beside(&named.given, &snake(&variant.name)),
                    span: named.span,
                    ..Struct::default()
                });
                self.note_fields(id, &variant.fields, &kept);
                Ok(Some(Payload { ty: Type::Struct(id), only: None, given: Given::default() }))
            }
        }
    }

    /// Extends a name until no author's type has it.
    fn free_name(&self, mut name: String) -> String {
        while self.package.types.iter().any(|it| it.name == name) {
            name.push_str("Of");
        }
        name
    }
}

fn field(name: &str, docs: &str, ty: Type) -> Field {
    let docs = if docs.is_empty() { Vec::new() } else { vec![docs.to_owned()] };
    Field { name: name.to_owned(), docs, ty, given: Given::default() }
}

/// Returns the C name of a companion of a type with a name of the author's: `valve_t`, `valve_tag_t`.
fn beside(given: &Given, part: &str) -> Given {
    let name = given.name.as_ref().map(|name| match name.strip_suffix("_t") {
        Some(stem) => format!("{stem}_{part}_t"),
        None => format!("{name}_{part}"),
    });
    Given { name, site: given.site, ..Given::default() }
}

/// Returns the last segment of a path.
fn last(path: &str) -> &str {
    path.rsplit_once("::").map_or(path, |(_, last)| last)
}

/// Adds a field unless its type is zero-sized.
fn held(fields: &mut Vec<Field>, name: &str, docs: &str, ty: Type) -> Option<u32> {
    (ty != Type::Unit).then(|| {
        fields.push(field(name, docs, ty));
        fields.len() as u32 - 1
    })
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Returns the variants of an enum with their numbers: the author's, or from 0 upwards.
pub(super) fn numbered(variants: &[tree::Variant], site: Site) -> Result<Vec<Variant>> {
    let number = |(index, it): (i64, &tree::Variant)| {
        let Ok(value) = i32::try_from(it.value.unwrap_or(index)) else {
            return refused(site, refusals::VARIANT_NUMBER);
        };
        let (name, docs, given) = (it.name.clone(), it.docs.clone(), it.given.clone());
        Ok(Variant { name, docs, value, given })
    };
    (0..).zip(variants).map(number).collect()
}
