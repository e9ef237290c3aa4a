//! Assigns definitions to files, such that the includes of headers have no cycle.
//!
//! * A component has its own files. An item that contains components belongs to the last of them, since that
//!   component's header may include the module's header, which must then not include the component's.
//! * All other items of a Rust module share a pair of files.
//! * The project's prefix precedes each file name, so that two packages can share a folder of headers.
//! * Rust modules may use each other, C headers may not: files that would are merged under the first one's name.
//!
//! Must not know: the C text of a definition.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    EnumId, ExprKind, Function, FunctionId, Module, Owner, Role, Struct, StructId, Type,
};

use super::library::{self, Math};
use super::options::Options;
use super::reserved::is_reserved_file;
use super::spelling::{identifier, last_segment, relative, snake, wanted};

/// File of each definition, without extension.
#[derive(Clone, Debug, Default)]
pub struct Placing {
    /// Prefix of the C names of each Rust module, before files are merged.
    modules: BTreeMap<String, String>,
    structs: Vec<String>,
    enums: Vec<String>,
    functions: Vec<String>,
}

impl Placing {
    /// Assigns all definitions to files.
    pub fn new(module: &Module, options: &Options) -> Placing {
        let mut placing = Placing { modules: module_files(module), ..Placing::default() };
        let enums = module.enums.iter().map(|item| placing.module(&item.module)).collect();
        placing.enums = enums;
        let components = module.structs.iter().filter(|item| item.initial.is_some());
        let components = wanted(components.map(|item| snake(&item.name)));
        // The types of a struct's fields precede it.
        for id in (0..module.structs.len() as u32).map(StructId) {
            let file = placing.of_struct(module, &components, id);
            placing.structs.push(file);
        }
        let functions = module.functions.iter();
        placing.functions = functions.map(|item| placing.of_function(module, item)).collect();
        placing.join(&placing.needs(module, options));
        placing.all().for_each(|file| file.insert_str(0, &options.prefix));
        placing
    }

    /// Returns the file of each definition.
    fn all(&mut self) -> impl Iterator<Item = &mut String> {
        self.structs.iter_mut().chain(&mut self.enums).chain(&mut self.functions)
    }

    /// Returns the prefix of a Rust module's names: its file, unless that was merged.
    pub fn module(&self, path: &str) -> String {
        self.modules.get(path).cloned().unwrap_or_else(|| last_segment(path))
    }

    /// Returns the file of a struct.
    pub fn struct_file(&self, id: StructId) -> &str {
        &self.structs[id.index()]
    }

    /// Returns the file of an enum.
    pub fn enum_file(&self, id: EnumId) -> &str {
        &self.enums[id.index()]
    }

    /// Returns the file of a function.
    pub fn function_file(&self, id: FunctionId) -> &str {
        &self.functions[id.index()]
    }

    /// Returns true for each function that is `static`: private in Rust, and called only from its own file.
    ///
    /// A private function without callers is not `static`, since C compilers would warn. A method of a component is,
    /// since a remark reports it.
    pub fn private(&self, module: &Module) -> Vec<bool> {
        let (moved, elsewhere) = (self.moved(module), self.elsewhere(module));
        let is_private = |function: &Function| function.role == Role::Private;
        let mut locally: Vec<bool> = module.functions.iter().map(is_private).collect();
        let mut called: Vec<bool> = (module.functions.iter())
            .map(|function| match function.owner {
                Some(Owner::Struct(owner)) => module.structs[owner.index()].initial.is_some(),
                _ => false,
            })
            .collect();
        for (caller, function) in module.functions.iter().enumerate() {
            function.body.each_expr(|expr| {
                if let ExprKind::Call(callee, _) = &expr.kind {
                    let leaves = moved[caller] || elsewhere[caller];
                    let together = self.functions[callee.index()] == self.functions[caller];
                    locally[callee.index()] &= !leaves && together;
                    called[callee.index()] = true;
                }
            });
        }
        locally.into_iter().zip(called).map(|(locally, called)| locally && called).collect()
    }

    /// Returns true for each inline function in the header that the sources share: the `pub` ones, and their inline
    /// callees. The others are in each source that calls them.
    pub fn moved(&self, module: &Module) -> Vec<bool> {
        let is_public = |function: &Function| function.role == Role::Inline { public: true };
        with_callees(module, module.functions.iter().map(is_public).collect(), |_, _| false)
    }

    /// Returns true for each inline function that a source other than its own has.
    fn elsewhere(&self, module: &Module) -> Vec<bool> {
        let nothing = vec![false; module.functions.len()];
        with_callees(module, nothing, |caller, callee| {
            self.functions[caller] != self.functions[callee]
        })
    }

    /// Returns the file of a struct; `components` has the number of components that request a name.
    fn of_struct(
        &self,
        module: &Module,
        components: &BTreeMap<String, usize>,
        id: StructId,
    ) -> String {
        let item = &module.structs[id.index()];
        match component_in(module, &Type::Struct(id)) {
            Some(component) if component == id => self.own_file(item, components),
            Some(component) => self.structs[component.index()].clone(),
            None => self.module(&item.module),
        }
    }

    /// Returns the file of a component: its name, qualified by its module if that is taken.
    fn own_file(&self, item: &Struct, components: &BTreeMap<String, usize>) -> String {
        let (own, own_module) = (snake(&item.name), self.module(&item.module));
        let taken = is_reserved_file(&own)
            || own != own_module && self.modules.values().any(|file| *file == own)
            || components[&own] > 1;
        if taken { format!("{own_module}_{own}") } else { own }
    }

    fn of_function(&self, module: &Module, function: &Function) -> String {
        let owner = match function.owner {
            Some(Owner::Struct(owner)) => component_in(module, &Type::Struct(owner)),
            _ => None,
        };
        let named = signature(function).filter_map(|ty| component_in(module, ty)).max();
        match owner.max(named) {
            Some(component) => self.structs[component.index()].clone(),
            None => self.module(&function.module),
        }
    }

    /// Returns the files whose headers each file's header includes.
    fn needs(&self, module: &Module, options: &Options) -> BTreeMap<String, BTreeSet<String>> {
        let mut needs: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        let mut need = |file: &str, ty: &Type| {
            if let Some(other) = self.of_type(ty)
                && other != file
            {
                needs.entry(file.to_owned()).or_default().insert(other.to_owned());
            }
        };
        for (item, file) in module.structs.iter().zip(&self.structs) {
            item.fields.iter().for_each(|field| need(file, &field.ty));
        }
        let private = self.private(module);
        for (index, function) in module.functions.iter().enumerate() {
            let elsewhere = function.attributes.external.is_some()
                || options.math == Math::Target && library::name(function).is_some();
            let inline = matches!(function.role, Role::Inline { .. });
            if !elsewhere && !private[index] && !inline {
                signature(function).for_each(|ty| need(&self.functions[index], ty));
            }
        }
        needs
    }

    fn of_type(&self, ty: &Type) -> Option<&str> {
        match ty {
            Type::Struct(id) => Some(self.struct_file(*id)),
            Type::Enum(id) => Some(self.enum_file(*id)),
            Type::Array { element, .. } | Type::Slice(element) => self.of_type(element),
            _ => None,
        }
    }

    /// Merges files whose headers include each other.
    fn join(&mut self, needs: &BTreeMap<String, BTreeSet<String>>) {
        let reached: BTreeMap<&str, BTreeSet<&str>> =
            needs.keys().map(|file| (file.as_str(), reached(needs, file))).collect();
        let needed = |from: &str, to: &str| reached.get(from).is_some_and(|all| all.contains(to));
        let first: BTreeMap<String, String> = (reached.keys())
            .filter_map(|file| {
                let mutual = |other: &&&str| needed(file, other) && needed(other, file);
                let first = reached.keys().find(mutual)?;
                Some(((*file).to_owned(), (*first).to_owned()))
            })
            .collect();
        for file in self.all() {
            if let Some(first) = first.get(file) {
                file.clone_from(first);
            }
        }
    }
}

/// Extends a mark of functions to the inline callees of marked ones, and to those that `also` marks by caller and
/// callee.
fn with_callees(
    module: &Module,
    mut marked: Vec<bool>,
    also: impl Fn(usize, usize) -> bool,
) -> Vec<bool> {
    // Callees precede callers.
    for caller in (0..marked.len()).rev() {
        module.functions[caller].body.each_expr(|expr| {
            let ExprKind::Call(callee, _) = &expr.kind else { return };
            let callee = callee.index();
            let is_inline = matches!(module.functions[callee].role, Role::Inline { .. });
            marked[callee] |= is_inline && (marked[caller] || also(caller, callee));
        });
    }
    marked
}

/// Returns the headers that a header includes, directly or not.
fn reached<'n>(needs: &'n BTreeMap<String, BTreeSet<String>>, file: &str) -> BTreeSet<&'n str> {
    let mut all: BTreeSet<&str> = BTreeSet::new();
    let mut open: Vec<&str> = needs.get(file).into_iter().flatten().map(String::as_str).collect();
    while let Some(next) = open.pop() {
        if all.insert(next) {
            open.extend(needs.get(next).into_iter().flatten().map(String::as_str));
        }
    }
    all
}

fn signature(function: &Function) -> impl Iterator<Item = &Type> {
    function.parameters().iter().map(|local| &local.ty).chain([&function.result])
}

/// Returns the last component that a type is or contains.
fn component_in(module: &Module, ty: &Type) -> Option<StructId> {
    match ty {
        Type::Struct(id) => {
            let item = &module.structs[id.index()];
            let own = item.initial.is_some().then_some(*id);
            own.or_else(|| item.fields.iter().filter_map(|it| component_in(module, &it.ty)).max())
        }
        Type::Array { element, .. } | Type::Slice(element) => component_in(module, element),
        _ => None,
    }
}

/// Returns the file of each Rust module: its last segment, or the whole path if another module ends alike.
fn module_files(module: &Module) -> BTreeMap<String, String> {
    let paths: BTreeSet<&str> = (module.structs.iter().map(|item| &*item.module))
        .chain(module.enums.iter().map(|item| &*item.module))
        .chain(module.functions.iter().map(|item| &*item.module))
        .collect();
    let ends = wanted(paths.iter().map(|path| last_segment(path)));
    let file = |path: &str| {
        let own = last_segment(path);
        let rivals = ends[&own];
        let whole = || identifier(&path.replace("::", "_"));
        match relative(path).join("_") {
            _ if rivals == 1 && !is_reserved_file(&own) => own,
            short if rivals > 1 && !is_reserved_file(&short) => short,
            _ => whole(),
        }
    };
    paths.iter().map(|path| ((*path).to_owned(), file(path))).collect()
}
