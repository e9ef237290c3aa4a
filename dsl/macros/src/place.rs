//! Where an item stands: its module, and the folder of its package, by which generation knows a crate that another
//! workspace has built into the same target folder.
//!
//! The folder is said as the file system knows it: a package that two workspaces reach by links is one package to cargo,
//! built once, and a link may be gone when it is used.

use std::path::PathBuf;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// A `bessemer::generate::Place`.
pub fn place() -> TokenStream {
    let named = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let folder = named.canonicalize().unwrap_or(named);
    let folder = Literal::string(&folder.to_string_lossy());
    quote!((::core::module_path!(), #folder))
}
