//! The author's wishes for the C of an item.
//!
//! Invariant: none of it changes what is computed.

use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::ir::Const;
use crate::tree::Site;

/// The author's attributes of a type, a variant, a field, a parameter or a table: `#[c(…)]`, `#[unit("…")]`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Given {
    /// Its name in the C, in place of the one that the tool would choose.
    pub name: Option<String>,
    /// The unit of its numbers.
    pub unit: Option<String>,
    /// The section of the object file in which it stands.
    pub section: Option<String>,
    /// Of a constant: whether other modules may read it.
    pub public: bool,
    /// Of a constant: whether its author writes it in base sixteen.
    pub hexadecimal: bool,
    /// Of a field, a parameter or a result: the constants by which the author says how many elements it has, from the
    /// outside in, rows before columns; empty where there is a number. In the tree their names, in the IR with their modules
    /// before them.
    pub sizes: Vec<String>,
    /// Where the name stands, in the file of the item.
    pub site: Site,
}

impl Const {
    /// Its name with its module before it, as [`Given::sizes`] has it.
    pub fn path(&self) -> String {
        alloc::format!("{}::{}", self.module, self.name)
    }
}

/// The author's wishes for the C of a function.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Attributes {
    /// Its name in the C, in place of the one that the tool would choose.
    pub name: Option<String>,
    /// The section of the object file in which it stands.
    pub section: Option<String>,
    /// Whether compilers may put it where it is called.
    pub inlining: Inlining,
    /// An entry point that leaves everything as it was if it faults.
    pub atomic: bool,
    /// The header of a function that the firmware brings; what stands in the Rust stands in for it.
    pub external: Option<String>,
    /// The attributes of its parameters, each by its name in the Rust.
    #[serde(default)]
    pub parameters: Vec<(String, Given)>,
    /// The attributes of its result.
    #[serde(default)]
    pub result: Given,
}

impl Attributes {
    /// The attributes of a parameter, if it has any.
    pub fn parameter(&self, name: &str) -> Option<&Given> {
        self.parameters.iter().find(|(known, _)| known == name).map(|(_, given)| given)
    }
}

/// Whether compilers may put a function where it is called.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Inlining {
    /// As they like.
    #[default]
    Free,
    /// Never: `#[inline(never)]`.
    Never,
    /// Always: `#[inline(always)]`.
    Always,
}
