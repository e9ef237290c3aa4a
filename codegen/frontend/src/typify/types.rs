//! Definitions and types, from paths to handles; and the constants with which an author writes lengths of fields,
//! parameters and results.
//!
//! A length is written as a constant in the C only if a marked constant has this name and this value, and other
//! modules can see it. Else the C has the number.

use bessemer_ir::tree::{self, Definition, DefinitionKind, Site, Table, Ty};
use bessemer_ir::{Attributes, Const, ConstId, Enum, Field, Given, Local, Span, Struct, Type};

use super::borrowed::is_element;
use super::context::{Borrowed, Context, Home};
use super::generic::{Payload, numbered};
use super::names::{self, part};
use super::{OUR_FAULT, Result, problem, refusals, refused};

impl<'a> Context<'a> {
    /// Adds to each field the expression with which `impl Default` computes it, unless that is a plain number.
    fn tell_defaults(&self, definition: &Definition, fields: &mut [Field]) {
        for (name, expression) in self.sources.computed_defaults(&definition.file, &definition.name)
        {
            let field = fields.iter_mut().find(|field| field.name == name);
            field.into_iter().for_each(|it| it.given.expression = Some(expression.clone()));
        }
    }

    pub(super) fn define(&mut self, definition: &Definition) -> Result<()> {
        let (span, site) = (self.span(&definition.file, definition.site), definition.site);
        let suffix = self.suffix(&definition.arguments);
        let mut name = self.instance_name(&definition.module, &definition.name, &suffix);
        let Definition { module, docs, given, .. } = definition;
        let (mut module, mut docs, mut given) = (module.clone(), docs.clone(), given.clone());
        // The author named this instance.
        if let Some(alias) = self.aliases.get(definition.path.as_str()).copied() {
            (module, name, given) = (alias.module.clone(), alias.name.clone(), alias.given.clone());
            if !alias.docs.is_empty() {
                docs.clone_from(&alias.docs);
            }
            if alias.file != definition.file {
                given.site = Site::default();
            }
        }
        let home = module.clone();
        let ty = match &definition.kind {
            DefinitionKind::Struct { fields, initial, defaults } => {
                let all = fields;
                let (mut fields, kept) = self.kept_fields(&definition.module, all, site)?;
                if fields.is_empty() {
                    return self.define_nothing(definition, name);
                }
                let (initial, defaults) = (initial.clone(), defaults.clone());
                for words in [&initial, &defaults].into_iter().flatten() {
                    if let Err(clash) = self.no_clash(words, false, site) {
                        self.tell(&definition.file, clash);
                    }
                }
                if initial.is_some() || defaults.is_some() {
                    self.tell_defaults(definition, &mut fields);
                }
                let item = Struct { name, module, docs, given, span, ..Struct::default() };
                let id = self.add_struct(Struct { fields, initial, defaults, ..item });
                self.note_fields(id, all, &kept);
                Type::Struct(id)
            }
            DefinitionKind::Enum(variants) => {
                let named = numbered(variants, site)?;
                let named = Enum { name, module, docs, variants: named, given, span };
                let payloads = self.payloads(variants, &named, site)?;
                self.define_enum(variants, payloads, named)
            }
        };
        let differ = |fields: &[tree::Field]| fields.iter().any(|field| self.may_differ(&field.ty));
        let may_differ = match &definition.kind {
            DefinitionKind::Struct { fields, .. } => differ(fields),
            DefinitionKind::Enum(variants) => variants.iter().any(|it| differ(&it.fields)),
        };
        let (path, order) = (definition.path.as_str(), self.types.by_path.len());
        let known = self.note(&ty);
        known.home = Some(Home { order, module: home, span });
        known.unequal = !definition.equal || may_differ;
        known.ordered = definition.ordered;
        known.reversed = path.starts_with("bessemer::comparison::Reverse<");
        known.bounded = path.starts_with("bessemer::bounded::BoundedMatrix<");
        known.range = match path.split_once('<') {
            Some(("bessemer::range::HalfOpen", _)) => Some(false),
            Some(("bessemer::range::Closed", _)) => Some(true),
            _ => None,
        };
        known.unit = quaternion(path);
        self.types.by_path.insert(definition.path.clone(), ty);
        Ok(())
    }

    /// Returns the IR type of a value; references are refused.
    pub(super) fn value_type(&mut self, ty: &Ty, site: Site) -> Result<Type> {
        match ty {
            Ty::Ref(inner, _) if !matches!(**inner, Ty::Slice(_)) => {
                refused(site, refusals::REFERENCE_VALUE)
            }
            ty => self.pointee(ty, site),
        }
    }

    /// Returns the type of a struct's or a variant's content. A shared reference becomes a copy, since nothing writes
    /// to its place during the borrow.
    pub(super) fn held_type(&mut self, ty: &Ty, site: Site) -> Result<Type> {
        match ty {
            Ty::Ref(inner, false) if !matches!(**inner, Ty::Slice(_)) => {
                self.held_type(inner, site)
            }
            ty => self.value_type(ty, site),
        }
    }

    /// Returns the IR type of a value, or of a reference's referent.
    pub(super) fn pointee(&mut self, ty: &Ty, site: Site) -> Result<Type> {
        Ok(match ty {
            Ty::Unit => Type::Unit,
            Ty::Scalar(scalar) => Type::Scalar(*scalar),
            Ty::Array(_, 0) | Ty::Matrix(_, 0, _) | Ty::Matrix(_, _, 0) => {
                return refused(site, refusals::EMPTY_ARRAY);
            }
            Ty::Array(element, len) => match self.value_type(element, site)? {
                Type::Unit => return refused(site, refusals::ARRAY_OF_NOTHING),
                element if !self.slices_in(&element).is_empty() => {
                    return refused(site, refusals::MANY_SLICES);
                }
                element => Type::Array { element: Box::new(element), len: *len },
            },
            Ty::Matrix(element, rows, cols) => {
                Type::Matrix { element: *element, rows: *rows, cols: *cols }
            }
            Ty::Named(path) => match self.types.by_path.get(path) {
                Some(ty) => ty.clone(),
                None if self.types.undefined.contains(path.as_str()) => {
                    return problem(site, "", "");
                }
                None => {
                    return problem(site, format!("`{path}` was not built"), "mark it `#[data]`");
                }
            },
            Ty::Ref(inner, mutable) if let Ty::Slice(element) = &**inner => {
                self.borrowed(element, *mutable, site)?
            }
            Ty::Known(name, _) if name == Ty::NAME => self.name_type(),
            Ty::Ref(inner, _) | Ty::Known(_, inner) => self.pointee(inner, site)?,
            Ty::Slice(element) => self.borrowed(element, false, site)?,
            Ty::Tuple(_) | Ty::List(..) | Ty::Option(_) | Ty::Result(..) => {
                self.generic(ty, site)?
            }
        })
    }

    /// Returns the struct that represents a standard type.
    pub(super) fn generic(&mut self, ty: &Ty, site: Site) -> Result<Type> {
        let ty = &bare(ty, true);
        if let Some(known) = self.types.generics.get(ty) {
            return Ok(known.clone());
        }
        let id = match ty {
            Ty::Tuple(parts) => {
                let parts = parts.iter().map(|ty| self.content_type(ty, site));
                let parts = parts.collect::<Result<_>>()?;
                self.tuple(parts, site)?
            }
            Ty::List(element, n) => {
                let element = self.value_type(element, site)?;
                self.list(element, *n, site)?
            }
            Ty::Option(of) => {
                let value = self.content_type(of, site)?;
                self.outcome((of, value), None, site)?
            }
            Ty::Result(of, or) => {
                let value = self.content_type(of, site)?;
                let error = self.value_type(or, site)?;
                self.outcome((of, value), Some((or, error)), site)?
            }
            _ => return problem(site, "this type has no struct", OUR_FAULT),
        };
        self.types.generics.insert(ty.clone(), Type::Struct(id));
        Ok(Type::Struct(id))
    }

    /// Returns the struct that represents `&[T]` or `&mut [T]` in a value.
    pub(super) fn borrowed(&mut self, element: &Ty, mutable: bool, site: Site) -> Result<Type> {
        let ty = Ty::Ref(Box::new(Ty::Slice(Box::new(element.clone()))), mutable);
        self.borrowed_type(ty, element, (mutable, false), site)
    }

    /// Returns the IR type of a value inside a tuple, an `Option` or a `Result`.
    pub(super) fn content_type(&mut self, ty: &Ty, site: Site) -> Result<Type> {
        match ty {
            Ty::Ref(element, true) if is_element(ty) => {
                self.borrowed_type(ty.clone(), element, (true, true), site)
            }
            ty => self.value_type(ty, site),
        }
    }

    fn borrowed_type(
        &mut self,
        ty: Ty,
        element: &Ty,
        (mutable, one): (bool, bool),
        site: Site,
    ) -> Result<Type> {
        if let Some(known) = self.types.generics.get(&ty) {
            return Ok(known.clone());
        }
        let element = self.element_type(element, site)?;
        let id = self.borrowed_struct(&element, (mutable, one), site)?;
        self.types.borrowed.insert(id, Borrowed { element, mutable, one });
        self.note(&Type::Struct(id)).unequal = true;
        self.types.generics.insert(ty, Type::Struct(id));
        Ok(Type::Struct(id))
    }

    /// Returns the IR type of a slice's elements.
    pub(super) fn element_type(&mut self, element: &Ty, site: Site) -> Result<Type> {
        match self.value_type(element, site)? {
            Type::Unit => refused(site, refusals::EMPTY_ELEMENTS),
            element => Ok(element),
        }
    }

    /// Returns the fields of a struct or a variant that are not zero-sized, and a flag for each original field.
    pub(super) fn kept_fields(
        &mut self,
        module: &str,
        fields: &[tree::Field],
        site: Site,
    ) -> Result<(Vec<Field>, Vec<bool>)> {
        let types = fields.iter().map(|field| self.held_type(&field.ty, site));
        let types = types.collect::<Result<Vec<_>>>()?;
        let kept: Vec<bool> = types.iter().map(|ty| *ty != Type::Unit).collect();
        let count = kept.iter().filter(|kept| **kept).count();
        let all = fields.iter().zip(types).filter(|(_, ty)| *ty != Type::Unit).enumerate();
        let typed = all.map(|(index, (field, ty))| {
            let name = match field.name.parse::<usize>() {
                Ok(_) => part(index, count),
                Err(_) => field.name.clone(),
            };
            let sizes = self.sizes(module, &ty, &field.given.sizes);
            let given = Given { sizes, ..field.given.clone() };
            Field { name, docs: field.docs.clone(), ty, given }
        });
        Ok((typed.collect(), kept))
    }

    /// Returns the payload of each variant of an enum.
    fn payloads(
        &mut self,
        variants: &[tree::Variant],
        named: &Enum,
        site: Site,
    ) -> Result<Vec<Option<Payload>>> {
        let payload = |variant: &tree::Variant| {
            let fields = self.kept_fields(&named.module, &variant.fields, site)?;
            self.payload(named, variant, fields, site)
        };
        variants.iter().map(payload).collect()
    }

    /// Returns the constant of this name and value in `module`; each is defined once.
    pub(super) fn constant(
        &mut self,
        module: &str,
        name: &str,
        ty: &Type,
        words: &[u64],
    ) -> ConstId {
        let said = self.table(module, name, ty, words);
        let module = said.map_or(module, |table| &table.module);
        let consts = &mut self.module.consts;
        let same = |constant: &Const| {
            constant.module == module
                && constant.name == name
                && constant.ty == *ty
                && constant.words == words
        };
        let index = consts.iter().position(same).unwrap_or_else(|| {
            let given = |table: &Table| Given { public: table.public, ..table.given.clone() };
            consts.push(Const {
                name: name.to_owned(),
                module: module.to_owned(),
                ty: ty.clone(),
                words: words.to_vec(),
                docs: said.map(|table| table.docs.clone()).unwrap_or_default(),
                given: said.map(given).unwrap_or_default(),
                span: Span::default(),
            });
            consts.len() - 1
        });
        if let Some(table) = said {
            self.module.consts[index].span = self.span(&table.file, table.site);
        }
        ConstId(index as u32)
    }

    /// Adds the constants of the package that the C has although no function reads them.
    pub(super) fn constants_for_firmware(&mut self) {
        let own = self.package.name.replace('-', "_");
        for table in self.package.tables.iter().filter(|it| it.always) {
            let named =
                table.owner.as_ref().is_some_and(|it| self.aliases.contains_key(it.as_str()));
            if named || table.module.split("::").next() == Some(own.as_str()) {
                let (module, name) = self.named_table(table);
                self.constant(&module, &name, &Type::USIZE, &table.value.words);
            }
        }
    }

    /// Returns module and name of a constant with attributes.
    fn named_table(&self, table: &Table) -> (String, String) {
        let owner = table.owner.as_deref().map(|path| self.item_name(path));
        names::constant(&table.module, owner, &table.name)
    }

    /// Returns the author's attributes of the constant with this name and value; one in this module has priority.
    pub(super) fn table(
        &mut self,
        module: &str,
        name: &str,
        ty: &Type,
        words: &[u64],
    ) -> Option<&'a Table> {
        let same = |it: &&Table| it.value.words == words && self.named_table(it).1 == name;
        let mut tables: Vec<&'a Table> = self.package.tables.iter().filter(same).collect();
        tables.sort_by_key(|it| it.module != module);
        tables
            .into_iter()
            .find(|it| self.value_type(&it.value.ty, it.site).is_ok_and(|its| its == *ty))
    }

    /// Returns the constants, with their modules, that name the lengths in a type; empty if there are none.
    pub(super) fn sizes(&mut self, module: &str, ty: &Type, names: &[String]) -> Vec<String> {
        let mut numbers = Vec::new();
        dimensions(ty, &mut numbers);
        let both = names.iter().zip(numbers);
        let all: Vec<String> = both.map(|(name, number)| self.size(module, name, number)).collect();
        if all.iter().all(String::is_empty) { Vec::new() } else { all }
    }

    fn size(&mut self, module: &str, name: &str, number: u32) -> String {
        let words = [u64::from(number)];
        let said = self.table(module, name, &Type::USIZE, &words);
        if !said.is_some_and(|table| table.public) {
            return String::new();
        }
        let id = self.constant(module, name, &Type::USIZE, &words);
        self.module.consts[id.index()].path()
    }

    /// Returns the length constants of a function's parameters and result; generic parameters are no constants. What
    /// its own parameters are called is no constant.
    pub(super) fn sizes_of(
        &mut self,
        source: &tree::Function,
        parameters: &[Local],
        result: &Type,
    ) -> Attributes {
        let mut attributes = source.tree.attributes.clone();
        let own = |name: &String| source.generics.iter().any(|(own, _)| own == name);
        let mut sizes = |ty: &Type, names: &[String]| {
            let names =
                names.iter().map(|name| if own(name) { String::new() } else { name.clone() });
            self.sizes(&source.module, ty, &names.collect::<Vec<_>>())
        };
        for (name, given) in &mut attributes.parameters {
            let local = parameters.iter().find(|local| local.name == *name);
            given.sizes = local.map_or(Vec::new(), |local| sizes(&local.ty, &given.sizes));
        }
        attributes.result.sizes = sizes(result, &attributes.result.sizes);
        attributes
    }
}

/// Returns a type with nalgebra's types replaced by what represents them in the C. Inside tuples, `Option` and
/// `Result` (`copied`), `&T` becomes `T`: nothing can write the referent during a shared borrow.
fn bare(ty: &Ty, copied: bool) -> Ty {
    let part = |ty: &Ty| Box::new(bare(ty, copied));
    let element = |ty: &Ty| Box::new(bare(ty, false));
    match ty {
        Ty::Unit | Ty::Scalar(_) | Ty::Matrix(..) | Ty::Named(_) => ty.clone(),
        Ty::Ref(inner, false) if copied && !matches!(**inner, Ty::Slice(_)) => *part(inner),
        Ty::Tuple(parts) => Ty::Tuple(parts.iter().map(|ty| *part(ty)).collect()),
        Ty::Option(value) => Ty::Option(part(value)),
        Ty::Result(value, error) => Ty::Result(part(value), part(error)),
        Ty::Array(of, len) => Ty::Array(element(of), *len),
        Ty::List(of, n) => Ty::List(element(of), *n),
        Ty::Slice(of) => Ty::Slice(element(of)),
        Ty::Ref(inner, mutable) => Ty::Ref(element(inner), *mutable),
        Ty::Known(name, _) if name == Ty::NAME => ty.clone(),
        Ty::Known(_, inner) => *element(inner),
    }
}

/// Returns true if the type at a path represents a unit quaternion, false for any quaternion, none for another type.
fn quaternion(path: &str) -> Option<bool> {
    let path = path.strip_prefix("bessemer::linear::spatial::")?;
    match path.split('<').next()? {
        "quaternion::Quaternion" => Some(false),
        "unit_quaternion::UnitQuaternion" => Some(true),
        _ => None,
    }
}

/// Collects the lengths in a type, from the outside in, rows before columns.
fn dimensions(ty: &Type, numbers: &mut Vec<u32>) {
    match ty {
        Type::Array { element, len } => {
            numbers.push(*len);
            dimensions(element, numbers);
        }
        Type::Matrix { rows, cols, .. } => numbers.extend([*rows, *cols]),
        _ => {}
    }
}
