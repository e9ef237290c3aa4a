//! Collects the definitions and functions of a package, each after what it is made of.

use alloc::borrow::ToOwned;
use alloc::collections::BTreeSet;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use bessemer_ir::tree::{self, DefinitionKind, Package, Refusal, Site, Ty};

use super::DslType;
use crate::Plain;

/// What a package is made of, so far.
#[derive(Default)]
pub struct Builder {
    package: Package,
    known: BTreeSet<String>,
    /// The functions being built, outermost first.
    stack: Vec<String>,
}

/// What rustc decided about one function.
pub struct Witness {
    /// The types of its slots.
    pub slots: Vec<Ty>,
    /// What its calls call.
    pub callees: Vec<tree::Callee>,
    /// The values of its constants.
    pub constants: Vec<tree::Constant>,
}

/// The marker of a function: builds it, and says how calls name it.
#[diagnostic::on_unimplemented(
    message = "this function is not part of the DSL",
    label = "not part of the DSL"
)]
pub trait Callee {
    /// Builds the function unless that is done, and names it.
    fn callee(cx: &mut Builder) -> tree::Callee;
}

/// A type with a path.
pub trait Named {
    /// The Rust path.
    fn path() -> String;
}

/// An item that announced itself to its package.
pub struct Registered {
    module: &'static str,
    site: (u32, u32),
    build: fn(&mut Builder),
}

inventory::collect!(Registered);

impl Registered {
    /// An item of `module`, at a line and column of its file.
    pub const fn new(
        module: &'static str,
        site: (u32, u32),
        build: fn(&mut Builder),
    ) -> Registered {
        Registered { module, site, build }
    }
}

/// Builds the function of a marker.
pub fn function<C: Callee>(cx: &mut Builder) {
    C::callee(cx);
}

/// Builds a type.
pub fn data<T: DslType>(cx: &mut Builder) {
    T::ty(cx);
}

/// A field of type `T`.
pub fn field<T: DslType>(cx: &mut Builder, name: &str, docs: &[&str]) -> tree::Field {
    tree::Field { name: name.to_owned(), docs: owned(docs), ty: T::ty(cx) }
}

/// A variant of an enum.
pub fn variant(name: &str, docs: &[&str]) -> (String, Vec<String>) {
    (name.to_owned(), owned(docs))
}

/// The words of a value.
pub fn words<T: Plain>(value: &T) -> Vec<u64> {
    let mut words = Vec::new();
    value.store(&mut |word| words.push(word));
    words
}

/// A Rust path.
pub fn path(module: &str, name: &str) -> String {
    format!("{module}::{name}")
}

/// Everything that the items of the package `name` registered, as JSON.
///
/// Items of other crates are part of it as far as they are used.
pub fn package(name: &str, license: &str) -> String {
    let mut builder = Builder::default();
    builder.package.name = name.to_owned();
    builder.package.license = license.to_owned();
    let mut items: Vec<&Registered> = inventory::iter::<Registered>.into_iter().collect();
    // The linker's order differs from build to build; the author's does not.
    items.sort_by_key(|item| (item.module, item.site));
    for item in items {
        let root = item.module.split("::").next().unwrap_or_default();
        if root == name.replace('-', "_") {
            (item.build)(&mut builder);
        }
    }
    serde_json::to_string(&builder.package).unwrap_or_default()
}

impl Builder {
    /// A struct or an enum; `kind` is asked once.
    pub fn definition(
        &mut self,
        path: String,
        docs: &[&str],
        file: &str,
        site: (u32, u32),
        kind: impl FnOnce(&mut Builder) -> DefinitionKind,
    ) -> Ty {
        if self.known.insert(path.clone()) {
            let kind = kind(self);
            self.package.types.push(tree::Definition {
                path: path.clone(),
                docs: owned(docs),
                file: file.to_owned(),
                site: Site(site.0, site.1),
                kind,
            });
        }
        Ty::Named(path)
    }

    /// A function; `witness` is asked once.
    pub fn function(
        &mut self,
        module: &str,
        file: &str,
        name: &str,
        owner: Option<String>,
        text: &str,
        witness: impl FnOnce(&mut Builder) -> Witness,
    ) -> tree::Callee {
        let path = path(owner.as_deref().unwrap_or(module), name);
        if self.stack.contains(&path) {
            self.recursion(&path, file, text);
        } else if self.known.insert(path.clone()) {
            self.stack.push(path.clone());
            let witness = witness(self);
            self.stack.pop();
            if let Ok(tree) = serde_json::from_str(text) {
                self.package.functions.push(tree::Function {
                    path: path.clone(),
                    module: module.to_owned(),
                    file: file.to_owned(),
                    owner,
                    tree,
                    slots: witness.slots,
                    callees: witness.callees,
                    constants: witness.constants,
                });
            }
        }
        tree::Callee::Function(path)
    }

    /// How a function comes back to itself.
    fn round_trip(&self, path: &str) -> String {
        let from = self.stack.iter().position(|known| known == path).unwrap_or_default();
        match &self.stack[from + 1..] {
            [] => format!("`{path}` calls itself"),
            through => format!("`{path}` calls itself, by way of `{}`", through.join("`, `")),
        }
    }

    fn recursion(&mut self, path: &str, file: &str, text: &str) {
        let site = serde_json::from_str::<tree::FunctionTree>(text).map(|tree| tree.site);
        self.package.errors.push(Refusal {
            file: file.to_owned(),
            site: site.unwrap_or_default(),
            message: self.round_trip(path),
            remedy: "write a loop over a range: recursion has no bound that the C could promise"
                .to_owned(),
        });
    }
}

fn owned(lines: &[&str]) -> Vec<String> {
    lines.iter().map(|&line| line.to_owned()).collect()
}
