//! Interface of the C as data: entry points, and the types of their parameters and results with offsets, units and
//! ranges.
//!
//! Descriptions for other tools are built from it: `interface.json`, ASAP2, bindings of other languages.
//!
//! Invariants: a type follows the types that it contains; names are those of the C. Must not know: any such tool.

use bessemer_ir::{Form, Given, Range, Role, StructId, Type};

use super::context::Context;
use super::layout::{Enums, offsets, size_of};
use super::names::FAULTS;
use super::signature::{Passing, Returned};

/// Interface of the C of a package.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Interface {
    /// Structs, each after those that it contains.
    pub structs: Vec<Struct>,
    /// Enums, including the status.
    pub enums: Vec<Enum>,
    /// Entry points, in the order of the Rust source.
    pub entries: Vec<Entry>,
}

/// A size or offset in bytes. Layouts of compilers differ only in the size of enums.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bytes {
    /// Layout in which an enum is an `int`, as on Linux.
    pub int_enums: u64,
    /// Layout in which an enum is the smallest integer that holds its values, as on bare ARM.
    pub short_enums: u64,
}

/// A struct.
#[derive(Clone, Debug, PartialEq)]
pub struct Struct {
    /// Name of the struct.
    pub name: String,
    /// Name of the struct in Rust, `motor::Gains`.
    pub rust: String,
    /// Author's comment, by lines.
    pub docs: Vec<String>,
    /// Header that declares it.
    pub header: String,
    /// True if it is the state of a component.
    pub component: bool,
    /// True if all fields are valid at any time: false for an enum with payload, an `Option`, a list.
    pub whole: bool,
    /// True if a call works in it: its contents between two calls have no meaning.
    pub scratch: bool,
    /// Function that sets it to its initial state or its default, if it has one.
    pub set_by: Option<String>,
    /// Words that this function sets, in memory order; the word of an enum is its value.
    pub words: Option<Vec<u64>>,
    /// Size of the struct.
    pub size: Bytes,
    /// Fields of the struct.
    pub fields: Vec<Field>,
}

/// A field of a struct.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Path from the struct to the field, `gain` or `as.speed`.
    pub name: String,
    /// Author's comment, by lines.
    pub docs: Vec<String>,
    /// Offset of its first byte.
    pub offset: Bytes,
    /// Type of the field.
    pub value: Value,
    /// For a table: the paths of the fields with the points of its axes, the outer one first.
    pub axes: Vec<String>,
}

/// Type of a field, a parameter or a result, with the unit and the range.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// Element type: a C scalar, or the name of a struct or an enum.
    pub ty: String,
    /// Lengths from the outside in. A slice's pointer has none, since its length is the next parameter.
    pub dimensions: Vec<Option<u32>>,
    /// Rows and columns of a matrix.
    pub matrix: Option<(u32, u32)>,
    /// The unit.
    pub unit: Option<String>,
    /// The range.
    pub range: Option<Range>,
}

/// An enum.
#[derive(Clone, Debug, PartialEq)]
pub struct Enum {
    /// Name of the enum.
    pub name: String,
    /// Author's comment, by lines.
    pub docs: Vec<String>,
    /// The header that declares it.
    pub header: String,
    /// Size of the enum.
    pub size: Bytes,
    /// Enumerators: name, value, comment.
    pub variants: Vec<(String, i32, Vec<String>)>,
}

/// An entry point.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Name of the entry point.
    pub name: String,
    /// Name of the entry point in Rust, `Motor::step`.
    pub rust: String,
    /// Author's comment, by lines.
    pub docs: Vec<String>,
    /// The header that declares it.
    pub header: String,
    /// Parameters: the state first, a result by pointer last.
    pub parameters: Vec<Parameter>,
    /// Type that it returns by value.
    pub result: Option<Value>,
    /// True if the returned value is the status.
    pub status: bool,
}

/// A parameter of an entry point.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Name of the parameter.
    pub name: String,
    /// Passing mode.
    pub passing: Passing,
    /// Type of the parameter.
    pub value: Value,
}

/// Returns the interface of a module in explicit IR.
pub fn interface(context: Context<'_>) -> Interface {
    let Context { module, names, .. } = context;
    let mut writer = Writer { context, face: Interface::default(), seen: Vec::new() };
    for (function, signature) in module.functions.iter().zip(&names.functions) {
        let (Role::Entry { .. }, Some(bessemer_ir::Owner::Struct(owner))) =
            (function.role, function.owner)
        else {
            continue;
        };
        let none = Given::default();
        let locals = function.parameters().iter().map(Some).chain(std::iter::repeat(None));
        let parameters = signature.params.iter().zip(locals).map(|(param, local)| {
            let given = match local {
                Some(local) => function.attributes.parameter(&local.name).unwrap_or(&none),
                None => &function.attributes.result,
            };
            let value = writer.value(&param.ty, given);
            Parameter { name: param.name.clone(), passing: param.passing, value }
        });
        let parameters = parameters.collect();
        let result = match &signature.returned {
            Returned::Value(ty) => Some(writer.value(ty, &function.attributes.result)),
            Returned::Nothing | Returned::Status => None,
        };
        let status = signature.returned == Returned::Status;
        if status {
            writer.status();
        }
        writer.face.entries.push(Entry {
            name: signature.name.clone(),
            rust: format!("{}::{}", module.structs[owner.index()].name, function.name),
            docs: function.docs.clone(),
            header: signature.header.clone(),
            parameters,
            result,
            status,
        });
    }
    writer.face
}

struct Writer<'a> {
    context: Context<'a>,
    face: Interface,
    /// Types described so far.
    seen: Vec<Type>,
}

impl Writer<'_> {
    /// Returns a value's description, after adding its type to the interface.
    fn value(&mut self, ty: &Type, given: &Given) -> Value {
        let (mut inner, mut dimensions, mut matrix) = (ty.clone(), Vec::new(), None);
        let element = loop {
            inner = match inner {
                Type::Array { element, len } => {
                    dimensions.push(Some(len));
                    *element
                }
                Type::Slice(element) => {
                    dimensions.push(None);
                    *element
                }
                Type::Matrix { element, rows, cols } => {
                    matrix = Some((rows, cols));
                    self.context.names.layout.array(element, (rows, cols))
                }
                element => break element,
            };
        };
        let names = self.context.names;
        let ty = match &element {
            Type::Struct(id) => {
                self.structure(*id);
                names.structs[id.index()].ty.clone()
            }
            Type::Enum(_) => {
                self.enumeration(&element);
                names.word(&element)
            }
            element => names.word(element),
        };
        Value { ty, dimensions, matrix, unit: given.unit.clone(), range: given.range }
    }

    fn structure(&mut self, id: StructId) {
        let ty = Type::Struct(id);
        if self.seen.contains(&ty) {
            return;
        }
        self.seen.push(ty.clone());
        let (item, own) =
            (&self.context.module.structs[id.index()], &self.context.names.structs[id.index()]);
        let int = offsets(self.context, id, Enums::Int);
        let short = offsets(self.context, id, Enums::Short);
        let mut fields = self.fields(id);
        if let (Some(name), [.., int_enums], [.., short_enums]) = (&own.fault, &*int, &*short) {
            self.status();
            fields.push(Field {
                name: name.clone(),
                docs: vec!["The fault that stopped the component.".to_owned()],
                offset: Bytes { int_enums: *int_enums, short_enums: *short_enums },
                value: Value {
                    ty: self.context.names.status.ty.clone(),
                    dimensions: Vec::new(),
                    matrix: None,
                    unit: None,
                    range: None,
                },
                axes: Vec::new(),
            });
        }
        let size = self.size(&ty);
        let words = item.initial.as_deref().or(item.defaults.as_deref());
        let words = words.filter(|_| own.init.is_some());
        self.face.structs.push(Struct {
            name: own.ty.clone(),
            rust: format!("{}::{}", item.module, item.name),
            docs: item.docs.clone(),
            header: own.header.clone(),
            component: item.initial.is_some(),
            whole: item.form == Form::Record,
            scratch: matches!(item.form, Form::Lent | Form::Shared),
            set_by: own.init.clone(),
            words: words.map(|words| self.in_memory(&ty, words)),
            size,
            fields,
        });
    }

    /// Returns the fields of a struct; the fields of a struct declared inside it are included.
    fn fields(&mut self, id: StructId) -> Vec<Field> {
        let (item, own) =
            (&self.context.module.structs[id.index()], &self.context.names.structs[id.index()]);
        let int = offsets(self.context, id, Enums::Int);
        let short = offsets(self.context, id, Enums::Short);
        let mut fields = Vec::new();
        for (at, (field, name)) in item.fields.iter().zip(&own.fields).enumerate() {
            let (int_enums, short_enums) = (int[at], short[at]);
            match field.ty {
                Type::Unit => {}
                Type::Struct(inner) if !self.context.names.structs[inner.index()].named => {
                    fields.extend(self.fields(inner).into_iter().map(|inner| Field {
                        name: format!("{name}.{}", inner.name),
                        offset: Bytes {
                            int_enums: int_enums + inner.offset.int_enums,
                            short_enums: short_enums + inner.offset.short_enums,
                        },
                        axes: inner.axes.iter().map(|axis| format!("{name}.{axis}")).collect(),
                        ..inner
                    }));
                }
                _ => {
                    let attributes = &field.given;
                    fields.push(Field {
                        name: name.clone(),
                        docs: field.docs.clone(),
                        offset: Bytes { int_enums, short_enums },
                        value: self.value(&field.ty, attributes),
                        axes: self.paths(id, &attributes.axes),
                    });
                }
            }
        }
        fields
    }

    /// Returns the paths of the points of axes, by their names in Rust.
    fn paths(&self, id: StructId, axes: &[String]) -> Vec<String> {
        let (module, names) = (self.context.module, self.context.names);
        let (item, own) = (&module.structs[id.index()], &names.structs[id.index()]);
        let path = |axis: &String| {
            let at = item.fields.iter().position(|it| it.name == *axis)?;
            let within = match item.fields[at].ty {
                Type::Struct(inner) => format!(".{}", names.structs[inner.index()].fields[0]),
                _ => String::new(),
            };
            Some(format!("{}{within}", own.fields[at]))
        };
        axes.iter().filter_map(path).collect()
    }

    fn size(&self, ty: &Type) -> Bytes {
        Bytes {
            int_enums: size_of(self.context, ty, Enums::Int),
            short_enums: size_of(self.context, ty, Enums::Short),
        }
    }

    /// Returns the words of a value in memory order.
    fn in_memory(&self, ty: &Type, words: &[u64]) -> Vec<u64> {
        let module = self.context.module;
        let each = |types: &mut dyn Iterator<Item = &Type>| {
            let (mut rest, mut all) = (words, Vec::new());
            for ty in types {
                let (own, later) = rest.split_at(module.width(ty).min(rest.len()));
                rest = later;
                all.extend(self.in_memory(ty, own));
            }
            all
        };
        match ty {
            Type::Struct(id) => {
                each(&mut module.structs[id.index()].fields.iter().map(|field| &field.ty))
            }
            Type::Array { element, len } => {
                each(&mut std::iter::repeat_n(&**element, *len as usize))
            }
            Type::Matrix { rows, cols, .. } => {
                self.context.names.layout.in_memory(words, (*rows, *cols))
            }
            Type::Enum(id) => {
                let variants = &module.enums[id.index()].variants;
                let value = |word: &u64| variants.get(*word as usize).map(|it| it.value);
                words.iter().map(|word| value(word).unwrap_or_default() as i64 as u64).collect()
            }
            Type::Unit | Type::Scalar(_) | Type::Slice(_) => words.to_vec(),
        }
    }

    /// Adds the status enum, once.
    fn status(&mut self) {
        let names = &self.context.names.status;
        if self.face.enumeration(&names.ty).is_some() {
            return;
        }
        let faults = FAULTS.iter().map(|fault| names.fault(*fault));
        let variants = std::iter::once(names.ok.clone()).chain(faults);
        self.face.enums.push(Enum {
            name: names.ty.clone(),
            docs: vec!["What a call came to.".to_owned()],
            header: names.header.clone(),
            // Of few values, none of them negative.
            size: Bytes { int_enums: 4, short_enums: 1 },
            variants: variants.zip(0..).map(|(name, value)| (name, value, Vec::new())).collect(),
        });
    }

    fn enumeration(&mut self, ty: &Type) {
        let Type::Enum(id) = ty else { return };
        if self.seen.contains(ty) {
            return;
        }
        self.seen.push(ty.clone());
        let (item, names) =
            (&self.context.module.enums[id.index()], &self.context.names.enums[id.index()]);
        let variants = item.variants.iter().zip(&names.variants);
        let size = self.size(ty);
        self.face.enums.push(Enum {
            name: names.ty.clone(),
            docs: item.docs.clone(),
            header: names.header.clone(),
            size,
            variants: variants
                .map(|(it, name)| (name.clone(), it.value, it.docs.clone()))
                .collect(),
        });
    }
}

/// A number inside a struct, with its path.
#[derive(Clone, Debug, PartialEq)]
pub struct Leaf<'f> {
    /// Path, such as `height.p` or `axes[2].gain`.
    pub path: String,
    /// Offset from the beginning of the struct.
    pub offset: Bytes,
    /// Type: a C scalar or an enum, with the remaining dimensions.
    pub value: &'f Value,
    /// The author's comment.
    pub docs: &'f [String],
    /// Paths of the points of its axes, for a table.
    pub axes: Vec<String>,
}

impl Interface {
    /// Returns the struct of this name.
    pub fn structure(&self, name: &str) -> Option<&Struct> {
        self.structs.iter().find(|it| it.name == name)
    }

    /// Returns the enum of this name.
    pub fn enumeration(&self, name: &str) -> Option<&Enum> {
        self.enums.iter().find(|it| it.name == name)
    }

    /// Returns the numbers of a struct in order; an array of numbers is one entry.
    pub fn leaves<'f>(&'f self, of: &'f Struct) -> Vec<Leaf<'f>> {
        self.leaves_of(of, &|_| true)
    }

    /// Returns the numbers of a struct, descending only into structs for which `wanted` is true.
    pub fn leaves_of<'f>(
        &'f self,
        of: &'f Struct,
        wanted: &dyn Fn(&Struct) -> bool,
    ) -> Vec<Leaf<'f>> {
        let mut leaves = Vec::new();
        self.within(of, wanted, ("", Bytes::default()), &mut leaves);
        leaves
    }

    fn within<'f>(
        &'f self,
        of: &'f Struct,
        wanted: &dyn Fn(&Struct) -> bool,
        (before, from): (&str, Bytes),
        leaves: &mut Vec<Leaf<'f>>,
    ) {
        for field in of.fields.iter().filter(|_| wanted(of)) {
            let path = format!("{before}{}", field.name);
            let offset = from.plus(field.offset, 1);
            let Some(inner) = self.structure(&field.value.ty) else {
                let axes = field.axes.iter().map(|axis| format!("{before}{axis}")).collect();
                leaves.push(Leaf { path, offset, value: &field.value, docs: &field.docs, axes });
                continue;
            };
            let sizes = field.value.dimensions.iter().map(|it| it.unwrap_or(0));
            let mut places = vec![String::new()];
            for size in sizes {
                let each = |place: &String| {
                    (0..size).map(|at| format!("{place}[{at}]")).collect::<Vec<_>>()
                };
                places = places.iter().flat_map(each).collect();
            }
            for (at, place) in (0..).zip(&places) {
                let offset = offset.plus(inner.size, at);
                self.within(inner, wanted, (&format!("{path}{place}."), offset), leaves);
            }
        }
    }
}

impl Bytes {
    /// Returns the sum of `self` and `times` times `others`.
    fn plus(self, others: Bytes, times: u64) -> Bytes {
        Bytes {
            int_enums: self.int_enums + times * others.int_enums,
            short_enums: self.short_enums + times * others.short_enums,
        }
    }
}
