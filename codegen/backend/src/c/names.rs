//! C names of all items, and C signatures of all functions.
//!
//! Callers of emitted C (a test harness, a header for another language) use this module.
//!
//! * A type is its Rust name in snake case with `_t`; the enumerators of an enum have its name in capitals as a
//!   prefix. A method has its type as a prefix, a free function the last segment of its module.
//! * A name that is reserved, or a helper's, or that two items want, is qualified by the module: `Mode` in
//!   `models::flight` becomes `flight_mode_t`, since `mode_t` is POSIX's. All items with this name are qualified, so
//!   their order has no influence.
//! * A field, parameter or variable with a reserved name gets a trailing `_`.
//! * An item's name depends only on the items that want the same name.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::{
    ConstId, EnumId, Function, FunctionId, Given, Module, Owner, Role, StructId, Type,
};

use super::analysis::{Faults, unnamed};
use super::const_names::ConstNames;
use super::helpers::is_helper_name;
use super::internal;
use super::library::{self, Math};
use super::matrices::{Layout, Size};
use super::near::Near;
use super::options::Options;
use super::placing::Placing;
use super::reserved::{is_keyword, is_reserved_for_locals, is_reserved_globally};
pub use super::signature::{Param, Passing, Returned, Signature};
use super::spelling::{self, identifier, scalar_type, screaming, snake};
pub use super::status::{FAULTS, StatusNames};
pub use super::tree::Storage;
use super::tree::{Declarator, Head};

/// C names of a struct.
#[derive(Clone, Debug)]
pub struct StructNames {
    /// Prefix of its functions, such as `pid`.
    pub base: String,
    /// Type name, such as `pid_t`.
    pub ty: String,
    /// True if the struct has a name in C; false if it is declared inside the struct that contains it.
    pub named: bool,
    /// Field names, in order.
    pub fields: Vec<String>,
    /// Name of the last field, which holds the fault that stopped the component; none if it cannot fault.
    pub fault: Option<String>,
    /// Name of the function that sets a component to its initial state, or an entry point's argument to its default.
    pub init: Option<String>,
    /// Header that declares it, such as `altitude.h`.
    pub header: String,
}

/// C names of an enum.
#[derive(Clone, Debug)]
pub struct EnumNames {
    /// Prefix of its functions, such as `mode`.
    pub base: String,
    /// Type name.
    pub ty: String,
    /// Enumerator names, in order.
    pub variants: Vec<String>,
    /// Header that declares it.
    pub header: String,
}

/// C names of a whole module.
#[derive(Clone, Debug)]
pub struct Names {
    /// Names by [`StructId`].
    pub structs: Vec<StructNames>,
    /// Names by [`EnumId`].
    pub enums: Vec<EnumNames>,
    consts: ConstNames,
    /// All names with a global meaning in some file, except those of helpers and constants.
    globals: BTreeSet<String>,
    /// Signatures by [`FunctionId`].
    pub functions: Vec<Signature>,
    near: Near,
    /// Names of the status type.
    pub status: StatusNames,
    /// Layout of matrices in memory.
    pub layout: Layout,
    /// Placement of items in files.
    pub placing: Placing,
}

impl Names {
    /// Names all items of a module.
    pub fn new(module: &Module, options: &Options) -> Names {
        Names::with_faults(module, options, &Faults::new(module, options.hook.is_some()))
    }

    pub(crate) fn with_faults(module: &Module, options: &Options, faults: &Faults) -> Names {
        let mut names = Names {
            structs: Vec::new(),
            enums: Vec::new(),
            consts: ConstNames::default(),
            globals: BTreeSet::new(),
            functions: Vec::new(),
            near: Near::default(),
            status: StatusNames::new(options),
            layout: options.layout,
            placing: Placing::new(module, options),
        };
        names.name_types(module, options, faults);
        names.name_functions(module, options);
        names.consts = ConstNames::new(module, &names.functions, &names.globals, &options.prefix);
        names.name_parameters(module, faults);
        let is_taken = |name: &str| names.is_global(name);
        names.near = Near::new(module, &names.functions, &names.placing, faults, is_taken);
        names
    }

    /// Returns the C type of a word.
    pub fn word(&self, ty: &Type) -> String {
        match ty {
            Type::Scalar(scalar) => scalar_type(*scalar).to_owned(),
            Type::Enum(id) => self.enums[id.index()].ty.clone(),
            other => unreachable!("no word: {other:?}"),
        }
    }

    /// Returns `type name[dimensions]` for a variable.
    pub fn declarator(&self, ty: &Type, name: &str) -> Declarator {
        self.sized(ty, name, &[])
    }

    /// Returns the declarator of a public item: a field, a parameter.
    pub fn sized(&self, ty: &Type, name: &str, sizes: &[Option<ConstId>]) -> Declarator {
        let (ty, dimensions) = self.sized_parts(ty, sizes);
        Declarator { ty, name: name.to_owned(), dimensions }
    }

    /// Returns a constant pointer to a value; for an array, to its first element.
    pub fn pointer(&self, ty: &Type, name: &str) -> Declarator {
        let (ty, dimensions) = self.type_parts(ty);
        let inner = dimensions.find(']').map(|end| dimensions[end + 1..].to_owned());
        match inner.unwrap_or_default() {
            none if none.is_empty() => {
                Declarator { ty: format!("{ty} *const"), name: name.to_owned(), dimensions: none }
            }
            inner => Declarator { ty, name: format!("(*const {name})"), dimensions: inner },
        }
    }

    /// Returns the innermost element type and the dimensions.
    pub fn type_parts(&self, ty: &Type) -> (String, String) {
        self.sized_parts(ty, &[])
    }

    /// Returns the parts of a declarator, with the lengths that have names.
    fn sized_parts(&self, ty: &Type, sizes: &[Option<ConstId>]) -> (String, String) {
        let name = |at: usize| self.shared_constant((*sizes.get(at)?)?);
        match ty {
            Type::Unit => ("void".to_owned(), String::new()),
            Type::Scalar(_) | Type::Enum(_) => (self.word(ty), String::new()),
            Type::Struct(id) => (self.structs[id.index()].ty.clone(), String::new()),
            Type::Matrix { element, rows, cols } => {
                let shape =
                    (Size { number: *rows, name: name(0) }, Size { number: *cols, name: name(1) });
                (scalar_type(*element).to_owned(), self.layout.dimensions(shape))
            }
            Type::Slice(element) => {
                let (ty, inner) = self.type_parts(element);
                (ty, format!("[]{inner}"))
            }
            Type::Array { element, len } => {
                let (ty, inner) = self.sized_parts(element, sizes.get(1..).unwrap_or_default());
                (ty, format!("[{}]{inner}", Size { number: *len, name: name(0) }))
            }
        }
    }

    /// Returns a parameter's declaration in C.
    pub fn param(&self, param: &Param) -> Declarator {
        let mut declarator = self.sized(&param.ty, &param.name, &param.sizes);
        let pointer = declarator.dimensions.is_empty();
        match param.passing {
            Passing::Value => return declarator,
            Passing::Input => declarator.ty.insert_str(0, "const "),
            Passing::InOut | Passing::Output => {}
        }
        if pointer {
            declarator.ty.push_str(" *");
        }
        declarator
    }

    /// Returns the head of a function.
    pub fn head(&self, signature: &Signature) -> Head {
        Head {
            contract: Vec::new(),
            asked: Vec::new(),
            storage: signature.storage,
            result: match &signature.returned {
                Returned::Nothing => "void".to_owned(),
                Returned::Value(ty) => self.word(ty),
                Returned::Status => self.status.ty.clone(),
            },
            name: signature.name.clone(),
            params: signature.params.iter().map(|param| self.param(param)).collect(),
        }
    }

    fn name_types(&mut self, module: &Module, options: &Options, faults: &Faults) {
        let structs = module.structs.iter().map(|item| (&*item.name, &*item.module, &item.given));
        let enums = module.enums.iter().map(|item| (&*item.name, &*item.module, &item.given));
        let wanted: Vec<(&str, &str, &Given)> = structs.chain(enums).collect();
        let own = wanted.iter().filter(|(_, _, given)| given.name.is_none());
        let rivals = spelling::wanted(own.map(|(name, _, _)| snake(name)));
        let base = |(name, rust_module, given): &(&str, &str, &Given)| {
            if let Some(name) = &given.name {
                return name.strip_suffix("_t").unwrap_or(name).to_owned();
            }
            let own = snake(name);
            let taken = is_reserved_globally(&format!("{}{own}_t", options.prefix));
            let base = if taken || rivals[&own] > 1 {
                format!("{}_{own}", self.placing.module(rust_module))
            } else {
                own
            };
            format!("{}{base}", options.prefix)
        };
        let bases: Vec<String> = wanted.iter().map(base).collect();
        let unnamed = unnamed(module);
        for (index, item) in module.structs.iter().enumerate() {
            let id = StructId(index as u32);
            let mut fields: Vec<String> = item
                .fields
                .iter()
                .map(|field| given_or(&field.given, field_name(&field.name)))
                .collect();
            if item.overlaid() {
                fields[1..].iter_mut().for_each(|name| name.insert_str(0, OVERLAY));
            }
            let hidden = ["fault", "latched_fault"]
                .into_iter()
                .find(|name| fields.iter().all(|f| f != name));
            let fault = hidden.filter(|_| faults.latched(id)).map(str::to_owned);
            let base = bases[index].clone();
            self.structs.push(StructNames {
                ty: given_or(&item.given, format!("{base}_t")),
                named: !unnamed.contains(&id),
                init: set_by(module, id).map(|word| format!("{base}_{word}")),
                header: options.header(self.placing.struct_file(id)),
                base,
                fields,
                fault,
            });
        }
        for (index, item) in module.enums.iter().enumerate() {
            let base = &bases[module.structs.len() + index];
            let prefix = match item.given.name {
                Some(_) => screaming(base),
                None => base.to_uppercase(),
            };
            self.enums.push(EnumNames {
                base: base.clone(),
                ty: given_or(&item.given, format!("{base}_t")),
                variants: (item.variants.iter())
                    .map(|variant| (variant, format!("{prefix}_{}", screaming(&variant.name))))
                    .map(|(variant, name)| given_or(&variant.given, name))
                    .collect(),
                header: options.header(self.placing.enum_file(EnumId(index as u32))),
            });
        }
    }

    fn name_functions(&mut self, module: &Module, options: &Options) {
        let short: Vec<String> =
            module.functions.iter().map(|function| self.short_name(function, options)).collect();
        let inits = self.structs.iter().filter_map(|names| names.init.as_ref());
        let wanted = spelling::wanted(short.iter().chain(inits).cloned());
        let mut chosen: Vec<String> = (module.functions.iter().zip(&short))
            .map(|(function, name)| {
                if let Some(name) = &function.attributes.name {
                    name.clone()
                } else if wanted[name.as_str()] > 1
                    || is_reserved_globally(name)
                    || is_helper_name(name)
                {
                    long_name(self, module, function, options)
                } else {
                    name.clone()
                }
            })
            .collect();
        // `fn reading_value` beside `Reading::value`: the method keeps the name.
        let methods: BTreeSet<String> = (module.functions.iter().zip(&chosen))
            .filter(|(function, _)| function.owner.is_some())
            .map(|(_, name)| name.clone())
            .collect();
        for (function, name) in module.functions.iter().zip(&mut chosen) {
            let own = function.attributes.name.is_some();
            if function.owner.is_none() && !own && methods.contains(name) {
                name.push_str("_fn");
            }
        }
        let library = |function: &Function| match options.math {
            Math::Portable => None,
            Math::Target => library::name(function),
        };
        for (function, name) in module.functions.iter().zip(&mut chosen) {
            if let Some(theirs) = library(function) {
                *name = theirs;
            }
        }
        let (private, moved) = (self.placing.private(module), self.placing.moved(module));
        self.gather_globals(&chosen);
        for (index, function) in module.functions.iter().enumerate() {
            let id = FunctionId(index as u32);
            self.functions.push(Signature {
                name: chosen[index].clone(),
                storage: match function.role {
                    _ if function.attributes.external.is_some() => Storage::Foreign,
                    _ if library(function).is_some() => Storage::Library,
                    _ if private[index] => Storage::Static,
                    Role::Inline { .. } if moved[index] => Storage::Inline,
                    Role::Inline { .. } => Storage::OwnInline,
                    _ => Storage::Extern,
                },
                params: Vec::new(),
                parts: match options.math {
                    Math::Portable => &[],
                    Math::Target => library::parts(function),
                },
                returned: Returned::Nothing,
                header: match &function.attributes.external {
                    Some(header) => header.clone(),
                    None if moved[index] => internal::inline(options),
                    None => options.header(self.placing.function_file(id)),
                },
            });
        }
    }

    fn short_name(&self, function: &Function, options: &Options) -> String {
        if let Some(name) = &function.attributes.name {
            return name.clone();
        }
        let name = identifier(&function.name);
        if function.kernel.is_some() {
            return format!("{}{name}", options.prefix);
        }
        match function.owner {
            Some(Owner::Struct(id)) => format!("{}_{name}", self.structs[id.index()].base),
            Some(Owner::Enum(id)) => format!("{}_{name}", self.enums[id.index()].base),
            None => format!("{}{}_{name}", options.prefix, self.placing.module(&function.module)),
        }
    }
}

/// Prefix of a field that shares its memory with others: `state.as.running`.
pub const OVERLAY: &str = "as.";

/// Returns the author's name, or else this one.
fn given_or(given: &Given, name: String) -> String {
    given.name.clone().unwrap_or(name)
}

/// Returns the C name of a field.
pub fn field_name(name: &str) -> String {
    let name = identifier(name);
    if is_keyword(&name) { format!("{name}_") } else { name }
}

/// Returns the preferred C name of a local.
pub fn local_name(name: &str) -> String {
    let name = identifier(name);
    if is_reserved_for_locals(&name) { format!("{name}_") } else { name }
}

/// Returns the long name of a function: `attitude_pid_torque`, with the module path and the owner.
fn long_name(names: &Names, module: &Module, function: &Function, options: &Options) -> String {
    let owner = match function.owner {
        Some(Owner::Struct(id)) => format!("{}_", snake(&module.structs[id.index()].name)),
        Some(Owner::Enum(id)) => format!("{}_", snake(&module.enums[id.index()].name)),
        None => String::new(),
    };
    let path = identifier(&function.module.replace("::", "_"));
    let name = format!("{}{path}_{owner}{}", options.prefix, identifier(&function.name));
    let taken = |name: &str| names.structs.iter().any(|item| item.init.as_deref() == Some(name));
    if taken(&name) { format!("{name}_fn") } else { name }
}

impl Names {
    /// Returns true if a name has a global meaning in some file, which a local would hide.
    pub(super) fn is_global(&self, name: &str) -> bool {
        is_helper_name(name)
            || self.globals.contains(name)
            || self.consts.contains(name)
            || self.near.contains(name)
    }

    fn gather_globals(&mut self, functions: &[String]) {
        let status = &self.status;
        let faults = FAULTS.iter().map(|fault| status.fault(*fault));
        let structs = self.structs.iter().flat_map(|item| item.init.iter().chain([&item.ty]));
        let enums = self.enums.iter().flat_map(|item| item.variants.iter().chain([&item.ty]));
        let status = [&status.ty, &status.ok];
        self.globals = (functions.iter().chain(structs).chain(enums).chain(status))
            .cloned()
            .chain(faults)
            .collect();
    }

    /// Returns the name of a constant in the file of this header.
    pub fn constant(&self, header: &str, id: ConstId) -> &str {
        self.consts.get(header, id)
    }

    /// Returns the name of a constant that several files share.
    pub fn shared_constant(&self, id: ConstId) -> Option<&str> {
        self.consts.shared(id)
    }

    /// Returns true if a constant has a different name in some file that uses it.
    pub(super) fn renamed(&self, id: ConstId, name: &str) -> bool {
        self.consts.renamed(id, name)
    }

    /// Returns the name of an enum's variant.
    pub fn variant(&self, id: EnumId, index: u64) -> &str {
        &self.enums[id.index()].variants[index as usize]
    }

    /// Returns the signature of a function.
    pub fn signature(&self, id: FunctionId) -> &Signature {
        &self.functions[id.index()]
    }

    /// Returns the name by which a function calls another.
    pub fn called(&self, caller: FunctionId, callee: FunctionId) -> &str {
        self.near.name(caller, callee).unwrap_or(&self.functions[callee.index()].name)
    }

    /// Returns the functions of which these functions call copies, each with the copy's name.
    pub fn copied(
        &self,
        callers: impl Iterator<Item = FunctionId>,
    ) -> BTreeMap<FunctionId, String> {
        self.near.copied(callers)
    }

    /// Returns true if functions of a C library replace some of the module's.
    pub fn has_library(&self) -> bool {
        let is_theirs = |it: &Signature| it.storage == Storage::Library || !it.parts.is_empty();
        self.functions.iter().any(is_theirs)
    }
}

/// Returns the name of the function that sets a struct to its initial value, if any. It is `init` of a component, or
/// `defaults` of an entry point's argument.
fn set_by(module: &Module, id: StructId) -> Option<&'static str> {
    let item = &module.structs[id.index()];
    if item.initial.is_some() {
        return Some("init");
    }
    item.defaults.as_ref()?;
    let entries = module.functions.iter().filter(|it| matches!(it.role, Role::Entry { .. }));
    let mut taken = entries.flat_map(Function::parameters);
    taken.any(|parameter| parameter.ty == Type::Struct(id)).then_some("defaults")
}
