//! Types and tables, as the attribute macros emit them.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::{Argument, Constant, Site, Ty};
use crate::attributes::Given;

/// Name of an instance: `pub type PidF32 = Pid<f32>;`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Alias {
    /// Path of the instance.
    pub of: String,
    /// Name.
    pub name: String,
    /// Module of its declaration.
    pub module: String,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Source file, as rustc names it.
    pub file: String,
    /// Site of the name.
    pub site: Site,
    /// Author's attributes for the C.
    #[serde(default)]
    pub given: Given,
}

/// A `const` or `static` with an attribute of the DSL.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// Rust module.
    pub module: String,
    /// Author's name; of an associated constant its path, such as `Motion::VELOCITY`.
    pub name: String,
    /// Instance of a generic type to which an associated constant belongs, as its path; the name then begins with `Self`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub owner: Option<String>,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Source file, as rustc names it.
    pub file: String,
    /// Site of the name.
    pub site: Site,
    /// Type and value.
    pub value: Constant,
    /// True if other modules may read it.
    pub public: bool,
    /// True if the C has it although no function reads it, for the firmware.
    #[serde(default, skip_serializing_if = "core::ops::Not::not")]
    pub always: bool,
    /// Author's attributes for the C.
    pub given: Given,
}

/// A struct or an enum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Definition {
    /// Unique Rust path with arguments, such as `models::attitude::Pid`.
    pub path: String,
    /// Module, such as `models::attitude`.
    pub module: String,
    /// Author's name.
    pub name: String,
    /// Arguments for its generic parameters.
    pub arguments: Vec<Argument>,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Source file, as rustc names it.
    pub file: String,
    /// Site of the name.
    pub site: Site,
    /// True if it derives `PartialEq`, so `==` compares part by part.
    pub equal: bool,
    /// True if it derives `PartialOrd`, so `<` compares the variants of an enum or the fields of a struct.
    #[serde(default)]
    pub ordered: bool,
    /// True if it derives `Copy`.
    #[serde(default)]
    pub copied: bool,
    /// Author's attributes for the C.
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
        /// Words of a component's initial state.
        initial: Option<Vec<u64>>,
        /// Words of the default of plain data with a hand-written `Default`.
        #[serde(default)]
        defaults: Option<Vec<u64>>,
    },
    /// An enum.
    Enum(Vec<Variant>),
}

/// A variant of an enum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Variant {
    /// Author's name.
    pub name: String,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Fields of its payload; the parts of a tuple are named `0`, `1`, ….
    pub fields: Vec<Field>,
    /// Number, if the author numbers the variants: `Armed = 5`.
    #[serde(default)]
    pub value: Option<i64>,
    /// Author's attributes for the C.
    #[serde(default)]
    pub given: Given,
}

/// A field of a struct.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Field {
    /// Author's name; `0`, `1`, … in a tuple struct.
    pub name: String,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Type of the field.
    pub ty: Ty,
    /// Author's attributes for the C.
    #[serde(default)]
    pub given: Given,
}
