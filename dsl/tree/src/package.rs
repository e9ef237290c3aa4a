//! A package of models: the input of the compiler.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::{Alias, Definition, Function, Site, Table, Ty};

/// A package of models: the input of the compiler.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Package {
    /// Name of the Rust package.
    pub name: String,
    /// Licence in its manifest.
    pub license: String,
    /// Types, each after those that it contains.
    pub types: Vec<Definition>,
    /// Functions, callees before callers.
    pub functions: Vec<Function>,
    /// Author's names of instances of generic types.
    #[serde(default)]
    pub aliases: Vec<Alias>,
    /// Constants and tables with C attributes.
    #[serde(default)]
    pub tables: Vec<Table>,
    /// Functions without a call in the source; the types of operands select them.
    #[serde(default)]
    pub implied: Vec<Implied>,
    /// Generic components; only their instances have C.
    #[serde(default)]
    pub templates: Vec<Template>,
    /// Names of types that implement `Deref`, which no expression may use.
    #[serde(default)]
    pub derefs: Vec<String>,
    /// Words and texts of the names in its constants, sorted.
    #[serde(default)]
    pub names: Vec<(u64, String)>,
    /// Refusals of the builder.
    pub errors: Vec<Refusal>,
}

/// Kind of a generic item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum TemplateKind {
    /// A component.
    Component,
    /// A type that is no component.
    Data,
    /// A free function.
    Function,
    /// Method with parameters of its own, or of a generic type.
    Method,
}

/// A generic item.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Template {
    /// Kind.
    pub kind: TemplateKind,
    /// Module.
    pub module: String,
    /// Author's name.
    pub name: String,
    /// Source file, as rustc names it.
    pub file: String,
    /// Site of the name.
    pub site: Site,
    /// Name of the generic type of which it is a method.
    #[serde(default)]
    pub owner: Option<String>,
}

/// Implementation of a trait whose function is called without its name: `PartialEq` by `==`, also on types that
/// contain it; `From` by `?`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Implied {
    /// Name of the trait.
    pub of: String,
    /// Type that implements it.
    pub owner: Ty,
    /// Type with which it is compared, or from which it is converted.
    pub other: Ty,
    /// Path of the function.
    pub function: String,
}

/// A refusal that was found while the tree was built.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Refusal {
    /// Source file, as rustc names it.
    pub file: String,
    /// Site of the implementation.
    pub site: Site,
    /// The mistake.
    pub message: String,
    /// The remedy.
    pub remedy: String,
}
