//! Definitions and types, from paths to handles; and the constants with which an author writes lengths of fields,
//! parameters and results.
//!
//! A length is written as a constant in the C only if a marked constant has this name and this value, and other
//! modules can see it. Else the C has the number.

use bessemer_ir::tree::{self, Argument, Definition, DefinitionKind, Field, Site, Table, Ty};
use bessemer_ir::{
    Attributes, Const, ConstId, Enum, Given, Local, Scalar, Span, Struct, StructId, Type,
};

use super::generic::Home;
use super::names::{self, snake, split};
use super::{Context, Result, problem, refusals, refused};

impl<'a> Context<'a> {
    /// Returns the fields of a struct.
    pub(super) fn fields(&self, id: StructId) -> &[bessemer_ir::Field] {
        &self.module.structs[id.index()].fields
    }

    /// Returns the type of a field.
    pub(super) fn field_type(&self, id: StructId, at: u32) -> Type {
        self.fields(id)[at as usize].ty.clone()
    }

    /// Returns the name of a struct or an enum.
    pub(super) fn name_of(&self, ty: &Type) -> Option<&str> {
        match ty {
            Type::Struct(id) => Some(&self.module.structs[id.index()].name),
            Type::Enum(id) => Some(&self.module.enums[id.index()].name),
            _ => None,
        }
    }

    /// Adds a struct to the module.
    pub(super) fn add_struct(&mut self, item: Struct) -> StructId {
        self.module.structs.push(item);
        StructId(self.module.structs.len() as u32 - 1)
    }

    /// Returns a type as its author writes it.
    pub(super) fn show(&self, ty: &Type) -> String {
        match ty {
            Type::Unit => "()".into(),
            Type::Scalar(scalar) => scalar.name().into(),
            Type::Array { element, len } => format!("[{}; {len}]", self.show(element)),
            Type::Matrix { element, rows, cols } => {
                format!("SMatrix<{}, {rows}, {cols}>", element.name())
            }
            Type::Struct(_) if let Some(shown) = &self.known(ty).shown => shown.clone(),
            Type::Struct(_) | Type::Enum(_) => self.name_of(ty).unwrap_or_default().to_owned(),
            Type::Slice(element) => format!("[{}]", self.show(element)),
        }
    }

    /// Adds to each field the expression with which `impl Default` computes it, unless that is a plain number.
    fn tell_defaults(&self, definition: &Definition, fields: &mut [bessemer_ir::Field]) {
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
                let named = super::generic::numbered(variants, site)?;
                let named = Enum { name, module, docs, variants: named, given, span };
                self.define_enum(variants, named, site)?
            }
        };
        let differ = |fields: &[Field]| fields.iter().any(|field| self.may_differ(&field.ty));
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
        known.unit = super::spatial::quaternion(path);
        self.types.by_path.insert(definition.path.clone(), ty);
        Ok(())
    }

    /// Returns the name of an instance of the item `name` in the module or type `home`. Another item of the author's
    /// with the resulting name keeps it.
    pub(super) fn instance_name(&self, home: &str, name: &str, suffix: &str) -> String {
        let own = format!("{name}{suffix}");
        let taken =
            !suffix.is_empty() && self.authored.contains(&format!("{home}::{}", snake(&own)));
        if taken { format!("{name}_of{suffix}") } else { own }
    }

    /// Returns a readable suffix for an instance, such as `_f32_4`; empty without arguments.
    pub(super) fn suffix(&self, arguments: &[Argument]) -> String {
        arguments.iter().map(|argument| format!("_{}", self.argument_name(argument))).collect()
    }

    /// Returns a generic argument as part of a name.
    pub(super) fn argument_name(&self, argument: &Argument) -> String {
        match argument {
            Argument::Type(ty) => self.type_name(ty),
            Argument::Number(Scalar::Bool, word) => (*word != 0).to_string(),
            Argument::Number(Scalar::Int(int), word) => {
                let value = int.from_word(*word);
                let sign = if value < 0 { "minus_" } else { "" };
                format!("{sign}{}", value.unsigned_abs())
            }
            Argument::Number(_, word) => word.to_string(),
        }
    }

    fn type_name(&self, ty: &Ty) -> String {
        match ty {
            Ty::Unit => "unit".into(),
            Ty::Scalar(scalar) => scalar.name().into(),
            Ty::Array(element, len) => format!("{}_{len}", self.type_name(element)),
            Ty::Matrix(scalar, rows, cols) => format!("{}_{rows}x{cols}", scalar.name()),
            Ty::Named(path) => snake(self.item_name(path)),
            Ty::Tuple(parts) => {
                let parts: Vec<_> = parts.iter().map(|part| self.type_name(part)).collect();
                format!("{}_{}", super::generic::arity(parts.len()), parts.join("_"))
            }
            Ty::Slice(element) => format!("slice_{}", self.type_name(element)),
            Ty::List(element, n) => format!("list{n}_{}", self.type_name(element)),
            Ty::Option(value) => format!("option_{}", self.type_name(value)),
            Ty::Result(value, error) => {
                format!("result_{}_{}", self.type_name(value), self.type_name(error))
            }
            Ty::Ref(inner, _) => self.type_name(inner),
            Ty::Known(name, inner) => match &**inner {
                Ty::Matrix(scalar, ..) => format!("{}_{}", snake(name), scalar.name()),
                Ty::Scalar(_) => snake(name),
                inner => format!("{}_{}", snake(name), self.type_name(inner)),
            },
        }
    }

    /// Returns the name of the type at a path.
    pub(super) fn item_name<'p>(&'p self, path: &'p str) -> &'p str {
        let named = self.types.by_path.get(path).and_then(|ty| self.name_of(ty));
        let nothing = || self.types.nothings.get(path).map(|it| it.name.as_str());
        named.or_else(nothing).unwrap_or(split(path).1)
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
            if table.module.split("::").next() == Some(own.as_str()) {
                let (module, name) = names::constant(&table.module, None, &table.name);
                self.constant(&module, &name, &Type::USIZE, &table.value.words);
            }
        }
    }

    /// Returns the author's attributes of the constant with this name and value; one in this module has priority.
    pub(super) fn table(
        &mut self,
        module: &str,
        name: &str,
        ty: &Type,
        words: &[u64],
    ) -> Option<&'a Table> {
        let is_named = |it: &Table| names::constant(&it.module, None, &it.name).1 == name;
        let same = |it: &&Table| it.value.words == words && is_named(it);
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
