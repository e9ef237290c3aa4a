//! Tables that the whole back end reads, and the requirements of one file.

use std::collections::BTreeSet;

use bessemer_ir::{Const, ConstId, FunctionId, Int, Module, Scalar, Type};

use super::analysis::Faults;
use super::helpers::Helper;
use super::names::Names;

/// Requirements of the functions in a file: helpers, constants and headers.
#[derive(Clone, Debug, Default)]
pub struct Uses {
    /// Header name that identifies the file.
    pub file: String,
    /// Helper functions.
    pub helpers: BTreeSet<Helper>,
    /// Called functions.
    pub called: BTreeSet<FunctionId>,
    /// Named constants.
    pub consts: BTreeSet<ConstId>,
    /// Emitted headers.
    pub headers: BTreeSet<String>,
    /// Headers of C's library.
    pub system: BTreeSet<&'static str>,
    /// True if the macro for unrolling is needed.
    pub unroll: bool,
}

/// Data shared by the lowering of all functions.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// The module.
    pub module: &'a Module,
    /// Names of all items.
    pub names: &'a Names,
    /// Set of functions that can fault.
    pub faults: &'a Faults,
}

impl<'a> Context<'a> {
    /// Returns the constant of the name, `&str`, with this word. Other numbers may have its word by chance; zero, the
    /// word of the empty name, often does, and stays a number.
    pub fn text(self, ty: &Type, word: u64) -> Option<(ConstId, &'a str)> {
        let is_text = |item: &Const| item.is_name() && item.words == [word];
        let index = (word != 0 && *ty == Type::Scalar(Scalar::Int(Int::U32)))
            .then(|| self.module.consts.iter().position(is_text))??;
        let id = ConstId(index as u32);
        Some((id, self.names.shared_constant(id)?))
    }
}
