//! Names, `&str`: values without an order, each the CRC-32 of its text.
//!
//! While functions are lowered, names have the type of an enum without variants, so that nothing takes one for a
//! number: they have no order, no arithmetic and no conversion.

use bessemer_ir::tree::{Site, Ty};
use bessemer_ir::{Const, ConstId, Enum, EnumId, Given, Span, Type};

use super::context::Context;
use super::problem::{Result, problem};

fn one_word<T>([one, other]: [&str; 2], site: Site) -> Result<T> {
    problem(
        site,
        format!(
            "the names {one:?} and {other:?} have the same CRC-32, which is all that the C has of a name"
        ),
        "change the text of one of them",
    )
}

impl Context<'_> {
    /// Returns the type of names.
    pub(super) fn name_type(&mut self) -> Type {
        if let Some(id) = self.names.ty {
            return Type::Enum(id);
        }
        let enums = &mut self.module.enums;
        let id = EnumId(enums.len() as u32);
        enums.push(Enum {
            name: Ty::NAME.into(),
            module: Const::NAMES.into(),
            docs: Vec::new(),
            variants: Vec::new(),
            given: Given::default(),
            span: Span::default(),
        });
        self.names.ty = Some(id);
        Type::Enum(id)
    }

    /// Returns the constant of a name.
    pub(super) fn text(&mut self, text: &str, word: u64) -> ConstId {
        let ty = self.name_type();
        let consts = &mut self.module.consts;
        let is_known = |at: &usize| consts[*at].is_name() && consts[*at].words == [word];
        let known = (0..consts.len()).find(is_known);
        let index = known.unwrap_or_else(|| {
            consts.push(Const {
                name: of_text(text, word),
                module: Const::NAMES.to_owned(),
                ty,
                words: vec![word],
                docs: vec![shown(text)],
                given: Given { hexadecimal: true, public: true, ..Given::default() },
                span: Span::default(),
            });
            consts.len() - 1
        });
        ConstId(index as u32)
    }

    /// Refuses a value with a name that has the word of another, once for each two names. Without such names, words are
    /// words.
    pub(super) fn no_clash(&mut self, words: &[u64], is_text: bool, site: Site) -> Result<()> {
        match self.names.clash(words, is_text) {
            Some(pair) => one_word(pair, site),
            None => Ok(()),
        }
    }

    /// Refuses two names with one word that are in no value so far.
    pub(super) fn no_clash_left(&mut self, site: Site) -> Result<()> {
        match self.names.clashes.pop_first() {
            Some((_, pair)) => one_word(pair, site),
            None => Ok(()),
        }
    }

    /// Returns true for the type of names.
    pub(super) fn is_name(&self, ty: &Type) -> bool {
        matches!(ty, Type::Enum(id) if self.names.ty == Some(*id))
    }

    /// Adds the constants of names that are only in tables and initial states: callers compare with them, too.
    pub(super) fn all_names(&mut self) {
        if self.names.ty.is_some() {
            self.text("", 0);
            self.package.names.iter().for_each(|(word, text)| _ = self.text(text, *word));
        }
    }

    /// Makes the names of the module numbers.
    pub(super) fn names_to_numbers(&mut self) {
        if let Some(names) = self.names.ty {
            crate::numbered_names::to_numbers(&mut self.module, names);
        }
    }
}

/// Largest number of bytes of a text's part in the name of its constant.
const LONGEST: usize = 40;

/// Returns the name of the constant of a text: `OVER_TEMPERATURE`.
fn of_text(text: &str, word: u64) -> String {
    let words = text.split(|it: char| !it.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let mut name = String::new();
    for word in words {
        if !name.is_empty() && name.len() + word.len() > LONGEST {
            break;
        }
        name.push_str(if name.is_empty() { "" } else { "_" });
        name.push_str(&word.to_ascii_uppercase());
    }
    match (text, name.as_str()) {
        ("", _) => "EMPTY".to_owned(),
        (_, "") => format!("{word:08X}"),
        // POSIX has `NAME_MAX` in `limits.h`.
        (_, "MAX") => format!("MAX_{word:08X}"),
        _ => name,
    }
}

/// Returns a text as a comment shows it: in quotation marks, in ASCII, without an end of the comment.
fn shown(text: &str) -> String {
    let text: String = text.chars().flat_map(char::escape_default).collect();
    format!("The name \"{}\", as its CRC-32.", text.replace("*/", "*\\/").replace("/*", "/\\*"))
}
