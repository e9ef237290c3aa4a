//! A package of models, as the compiler gets it.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::{Alias, Definition, Function, Site, Table, Ty};

/// A package of models, as the compiler gets it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Package {
    /// The Rust package.
    pub name: String,
    /// Its licence, as its manifest has it.
    pub license: String,
    /// Types, each after those it is made of.
    pub types: Vec<Definition>,
    /// Functions, callees before callers.
    pub functions: Vec<Function>,
    /// The names that their author gave to instances of generic types.
    #[serde(default)]
    pub aliases: Vec<Alias>,
    /// The constants and tables of which their author says more than their value.
    #[serde(default)]
    pub tables: Vec<Table>,
    /// Functions that no call names: the types that they take say where they are called.
    #[serde(default)]
    pub implied: Vec<Implied>,
    /// The generic components of its author's: each has C by its instances alone.
    #[serde(default)]
    pub templates: Vec<Template>,
    /// The refusals of the builder itself.
    pub errors: Vec<Refusal>,
}

/// A generic component.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Template {
    /// The module that it is in.
    pub module: String,
    /// The author's name.
    pub name: String,
    /// The source file, as rustc names it.
    pub file: String,
    /// Site of the name.
    pub site: Site,
}

/// Implementation of a trait that is called other than by name: `PartialEq` by `==`, also on types that contain it;
/// `From` by `?`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Implied {
    /// The name of the trait.
    pub of: String,
    /// The type that it is implemented for.
    pub owner: Ty,
    /// The type that it is compared with, or made from.
    pub other: Ty,
    /// The path of the function.
    pub function: String,
}

/// Something that cannot be compiled, found while building.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Refusal {
    /// The source file, as rustc names it.
    pub file: String,
    /// Site of the implementation.
    pub site: Site,
    /// The mistake.
    pub message: String,
    /// The remedy.
    pub remedy: String,
}
