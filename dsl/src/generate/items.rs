//! Items of a package: their registration, and their contribution to it.
//!
//! Invariant: callees precede their callers, and each function is built once.

use alloc::borrow::ToOwned;
use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use bessemer_tree as tree;
use bessemer_tree::{Argument, Site, Ty};

use super::builder::{
    Builder, Named, Said, Underway, Witness, owned, path, said, type_text, words,
};
use super::slot::{DslType, Evaluated, ScalarType};
use super::{handed, operators, wide};
use crate::Plain;

/// Place of an item: its module, and the folder of its package.
pub type Place = (&'static str, &'static str);

/// Function that builds an item.
pub enum Build {
    /// A function.
    Function(fn(&mut Builder) -> tree::Callee),
    /// A type.
    Type(fn(&mut Builder) -> Ty),
    /// Another item.
    Other(fn(&mut Builder)),
}

/// A registered item.
pub struct Registered {
    place: Place,
    site: (u32, u32),
    build: Build,
    /// True if every package that uses its crate includes it.
    everywhere: bool,
}

inventory::collect!(Registered);

impl Registered {
    /// Registers an item at a line and column of its file.
    pub const fn new(place: Place, site: (u32, u32), build: Build) -> Registered {
        Registered { place, site, build, everywhere: false }
    }

    /// Registers a table, which is identified by its value wherever it is used.
    pub const fn table(place: Place, site: (u32, u32), build: fn(&mut Builder)) -> Registered {
        Registered { place, site, build: Build::Other(build), everywhere: true }
    }

    fn module(&self) -> &'static str {
        self.place.0
    }

    /// Returns its crate.
    fn root(&self) -> &'static str {
        self.module().split("::").next().unwrap_or_default()
    }
}

/// Returns the crates whose items are registered, each with the folder in which it was compiled, as JSON.
pub fn folders() -> String {
    let items = inventory::iter::<Registered>.into_iter();
    let crates: BTreeMap<&str, &str> = items.map(|item| (item.root(), item.place.1)).collect();
    serde_json::to_string(&crates).unwrap_or_default()
}

/// Returns a field of type `T`.
pub fn field<T: DslType>(
    cx: &mut Builder,
    name: &str,
    docs: &[&str],
    given: Option<Said>,
) -> tree::Field {
    tree::Field { name: name.to_owned(), docs: owned(docs), ty: T::ty(cx), given: said(given) }
}

/// Returns a variant of an enum.
pub fn variant(
    name: &str,
    docs: &[&str],
    fields: Vec<tree::Field>,
    value: Option<i64>,
    given: Option<Said>,
) -> tree::Variant {
    tree::Variant { name: name.to_owned(), docs: owned(docs), fields, value, given: said(given) }
}

/// Arguments for the generic parameters of a function.
pub struct Generics<'a> {
    /// Arguments of all parameters in scope.
    pub scope: &'a [(String, Argument)],
    /// Arguments of its own parameters.
    pub own: &'a [(String, Argument)],
    /// Interface to which it belongs, the arguments for its parameters, and its module.
    pub interface: Option<(&'static str, &'a [(String, Argument)], &'static str)>,
    /// Number of functions around it.
    pub depth: u32,
}

/// Returns the type argument of the parameter `name`.
pub fn argument<T: DslType>(cx: &mut Builder, name: &str) -> (String, Argument) {
    (name.to_owned(), Argument::Type(T::ty(cx)))
}

/// Returns the number argument of the parameter `name`.
pub fn number<T: Plain + ScalarType>(name: &str, value: T) -> (String, Argument) {
    let word = words(&value).first().copied().unwrap_or_default();
    (name.to_owned(), Argument::Number(T::SCALAR, word))
}

/// Returns all registered items of the package `name`, as JSON.
///
/// Items of other crates are included as far as they are used.
pub fn package(name: &str, library: &str, license: &str) -> String {
    let mut builder = Builder::default();
    // The paths of its modules begin with the library's name, which its manifest may choose.
    let is_named_so = name.replace('-', "_") == library;
    builder.package.name = if is_named_so { name } else { library }.to_owned();
    builder.package.license = license.to_owned();
    let mut items: Vec<&Registered> = inventory::iter::<Registered>.into_iter().collect();
    // The linker's order differs from build to build; the author's does not.
    items.sort_by_key(|item| (item.module(), item.site));
    for item in items {
        if item.everywhere || item.root() == library {
            match item.build {
                Build::Function(build) => _ = build(&mut builder),
                Build::Type(build) => _ = build(&mut builder),
                Build::Other(build) => build(&mut builder),
            }
        }
    }
    builder.package.implied = operators::implied(&mut builder);
    builder.package.names = crate::name::registered();
    serde_json::to_string(&builder.package).unwrap_or_default()
}

impl Builder {
    /// Adds the author's name of an instance.
    pub fn alias<T: DslType>(
        &mut self,
        named: Named,
        docs: &[&str],
        site: (u32, u32),
        given: Option<Said>,
    ) {
        let ty = T::ty(self);
        let site = Site(site.0, site.1);
        let known = |it: &&tree::Definition| matches!(&ty, Ty::Named(path) if *path == it.path);
        let generic = self.package.types.iter().find(known).filter(|it| !it.arguments.is_empty());
        let Some(of) = generic.map(|definition| definition.path.clone()) else {
            self.refuse(
                named.file,
                site,
                format!("an alias of `{}` needs no attribute, which names an instance of a generic type", type_text(&ty)),
                "remove the attribute: the type has its own name",
            );
            return;
        };
        if let Some(other) = self.package.aliases.iter().find(|alias| alias.of == of) {
            let message = format!("`{of}` has two names: it is `{}` already", other.name);
            self.refuse(named.file, site, message, "remove the attribute from one of them");
            return;
        }
        self.package.aliases.push(tree::Alias {
            of,
            name: named.name.to_owned(),
            module: named.module.to_owned(),
            docs: owned(docs),
            file: named.file.to_owned(),
            site,
            given: said(given),
        });
    }

    /// Adds a constant or a table with C attributes.
    pub fn table<T: Evaluated>(
        &mut self,
        named: Named,
        docs: &[&str],
        site: (u32, u32),
        value: &T,
        public: bool,
        given: Option<Said>,
    ) {
        let tree::Constant { ty, words } = value.evaluated(self);
        let value = tree::Constant { ty: handed::array(&ty).cloned().unwrap_or(ty), words };
        self.package.tables.push(tree::Table {
            module: named.module.to_owned(),
            name: named.name.to_owned(),
            owner: None,
            docs: owned(docs),
            file: named.file.to_owned(),
            site: Site(site.0, site.1),
            value,
            public,
            always: false,
            given: said(given),
        });
    }

    /// Adds the index of a block of a state, which the C has for the firmware; `arguments` are those of a generic state.
    pub fn state_index(
        &mut self,
        (state, arguments): (Named, &[(String, Argument)]),
        name: &str,
        doc: &str,
        site: (u32, u32),
        value: usize,
    ) {
        let Named { module, file, name: owner } = state;
        let value = value.evaluated(self);
        let instance = (!arguments.is_empty()).then(|| path(module, owner, arguments));
        let owner = if arguments.is_empty() { owner } else { "Self" };
        self.package.tables.push(tree::Table {
            module: module.to_owned(),
            name: format!("{owner}::{name}"),
            owner: instance,
            docs: owned(&[doc]),
            file: file.to_owned(),
            site: Site(site.0, site.1),
            value,
            public: true,
            always: true,
            given: said(None),
        });
    }

    /// Adds a function; `witness` is called once. It is a reference, since rustc would compile this code for each
    /// closure type otherwise.
    pub fn function(
        &mut self,
        named: Named,
        owner: Option<Ty>,
        generics: Generics<'_>,
        text: &str,
        witness: &dyn Fn(&mut Builder, &mut Witness),
    ) -> tree::Callee {
        let underway = self.underway(&named, owner, &generics);
        let path = underway.path.clone();
        if self.stack.iter().any(|it| it.path == path) {
            self.recursion(&path, named.file, text);
        } else if self.known.insert(path.clone()) {
            self.stack.push(underway.clone());
            let mut learned = Witness::default();
            witness(self, &mut learned);
            self.stack.pop();
            let mut tree = match tree::read::<tree::FunctionTree>(text) {
                Ok(tree) => tree,
                Err(error) => {
                    let message = format!("the tree of `{path}` cannot be read: {error}");
                    let remedy = "use one version of `bessemer` in the whole workspace";
                    self.refuse(named.file, Site::default(), message, remedy);
                    return tree::Callee::Function(path);
                }
            };
            handed::as_closures(&mut tree, &mut learned);
            let Underway { depth, owner, interface, name, suffix, .. } = underway;
            tree.name = name;
            let authors = core::mem::take(&mut learned.operators);
            let mut operators = operators::called(self, &tree.operators, authors, &learned.slots);
            wide::of_words(self, &mut tree, &mut learned, &mut operators);
            self.package.functions.push(tree::Function {
                path: path.clone(),
                module: named.module.to_owned(),
                file: named.file.to_owned(),
                owner,
                generics: generics.scope.to_vec(),
                interface,
                suffix,
                inner: depth > 0,
                tree,
                slots: learned.slots,
                callees: learned.callees,
                constants: learned.constants,
                operators,
            });
        }
        tree::Callee::Function(path)
    }

    /// Returns name and place of a function. A function in the body of another has that one's name as a prefix and its
    /// arguments before its own.
    fn underway(&self, named: &Named, owner: Option<Ty>, generics: &Generics<'_>) -> Underway {
        let (name, depth) = (named.name, generics.depth);
        if let Some(outer) = self.stack.iter().rfind(|it| it.depth < depth) {
            let path = path(&outer.path, name, generics.own);
            let mut inner = Underway { path, depth, ..outer.clone() };
            inner.name = format!("{name}_in_{}", outer.name);
            inner.suffix.extend(self.suffix(None, generics));
            return inner;
        }
        let home = owner.as_ref().map(type_text).unwrap_or_else(|| named.module.to_owned());
        let mut name = name.to_owned();
        let operand = generics.interface.and_then(|(of, arguments, _)| {
            arguments.iter().find(|_| operators::has_operand(of)).map(|(_, operand)| operand)
        });
        // Beside `impl Add for Phasor` there may be those for references; a slice is one anyway.
        if let Some(Argument::Type(Ty::Ref(of, _))) = operand
            && !matches!(**of, Ty::Slice(_))
        {
            name.push_str("_ref");
        }
        let owner = owner.map(|owner| match owner {
            Ty::Ref(of, _) => {
                name.insert_str(0, "ref_");
                type_text(&of)
            }
            owner => type_text(&owner),
        });
        let path = match &generics.interface {
            None => path(&home, named.name, generics.own),
            Some((interface, arguments, module)) => {
                let interface = path(&home, &format!("<{module}::{interface}>"), arguments);
                path(&interface, named.name, generics.own)
            }
        };
        let suffix = self.suffix(owner.as_deref(), generics);
        let interface = generics.interface.map(|(name, ..)| name.to_owned());
        Underway { path, depth, owner, interface, name, suffix }
    }

    /// Returns the arguments that distinguish a function from others of its name and owner. They are those of its
    /// parameters and of its interface's, unless the owner determines them.
    fn suffix(&self, owner: Option<&str>, generics: &Generics<'_>) -> Vec<Argument> {
        let known = self.package.types.iter().find(|it| Some(it.path.as_str()) == owner);
        let known = known.map(|owner| owner.arguments.as_slice()).unwrap_or_default();
        // An operator may take what its type is made of, and the type itself besides.
        let told = |name, argument| !operators::is_sign(name) && known.contains(argument);
        let interface = generics.interface.iter().flat_map(|(name, arguments, _)| {
            arguments.iter().filter(|(_, argument)| !told(name, argument))
        });
        interface.chain(generics.own).map(|(_, argument)| argument.clone()).collect()
    }

    /// Refuses a method of an interface whose implementation is not marked.
    pub fn unmarked<T: DslType>(
        &mut self,
        method: &str,
        file: &str,
        site: (u32, u32),
    ) -> tree::Callee {
        let owner = type_text(&T::ty(self));
        self.refuse(
            file,
            Site(site.0, site.1),
            format!("`{method}` of `{owner}` is not part of the DSL"),
            "mark the `impl` block as the type is: `#[data]` or `#[component]`",
        );
        tree::Callee::Function(String::new())
    }
}
