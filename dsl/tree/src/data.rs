//! Types and tables as the attribute macros hand them on.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::{Argument, Constant, Site, Ty};
use crate::attributes::Given;

/// `pub type PidF32 = Pid<f32>;`: the name of an instance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Alias {
    /// The path of the instance.
    pub of: String,
    /// Its name.
    pub name: String,
    /// The module in which it is declared.
    pub module: String,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// The source file, as rustc names it.
    pub file: String,
    /// Site of the name.
    pub site: Site,
    /// The author's wishes for its C.
    #[serde(default)]
    pub given: Given,
}

/// A `const` or `static` with an attribute of the DSL's.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// The Rust module that it is in.
    pub module: String,
    /// The author's name.
    pub name: String,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// The source file, as rustc names it.
    pub file: String,
    /// Site of the name.
    pub site: Site,
    /// Its type and its value.
    pub value: Constant,
    /// True if other modules may read it.
    pub public: bool,
    /// The author's wishes for its C.
    pub given: Given,
}

/// A struct or an enum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Definition {
    /// Its Rust path, `models::attitude::Pid`, with its arguments: unique.
    pub path: String,
    /// The module that it is in, `models::attitude`.
    pub module: String,
    /// The author's name.
    pub name: String,
    /// The arguments for its parameters.
    pub arguments: Vec<Argument>,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// The source file, as rustc names it.
    pub file: String,
    /// Site of the name.
    pub site: Site,
    /// True if it derives `PartialEq`, so that `==` compares part by part.
    pub equal: bool,
    /// True if it derives `PartialOrd`, so that `<` compares the variants of an enum, the parts of a struct.
    #[serde(default)]
    pub ordered: bool,
    /// True if it derives `Copy`.
    #[serde(default)]
    pub copied: bool,
    /// The author's wishes for its C.
    #[serde(default)]
    pub given: Given,
    /// Kind of the definition: struct or enum.
    pub kind: DefinitionKind,
}

/// The two kinds of [`Definition`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum DefinitionKind {
    /// A struct; a component has an initial state.
    Struct {
        /// Fields, in the author's order.
        fields: Vec<Field>,
        /// The initial state of a component, as words.
        initial: Option<Vec<u64>>,
        /// The default of plain data whose author writes it out, as words.
        #[serde(default)]
        defaults: Option<Vec<u64>>,
    },
    /// An enum.
    Enum(Vec<Variant>),
}

/// A variant of an enum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Variant {
    /// The author's name.
    pub name: String,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// Its payload; the names of a tuple's parts are `0`, `1`, ….
    pub fields: Vec<Field>,
    /// Its number, where the author numbers the variants: `Armed = 5`.
    #[serde(default)]
    pub value: Option<i64>,
    /// The author's wishes for its C.
    #[serde(default)]
    pub given: Given,
}

/// A field of a struct.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Field {
    /// The author's name; of a tuple struct `0`, `1`, ….
    pub name: String,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// Its type.
    pub ty: Ty,
    /// The author's wishes for its C.
    #[serde(default)]
    pub given: Given,
}
