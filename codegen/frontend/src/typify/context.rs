//! The state of lowering a package: the module so far, and the meaning of its types, functions and names.
//!
//! Must not know: how anything is lowered.

use std::collections::{BTreeMap, HashMap, HashSet};

use bessemer_ir::tree::{self, Package, Site};
use bessemer_ir::{EnumId, FunctionId, Module, Place, Span, StructId, Type};

use super::problem::{Problem, diagnostic};
use crate::diagnostic::Diagnostic;
use crate::source::Sources;

/// Returns a function's owner, name and suffix, which must be unique.
fn claim(function: &tree::Function) -> (Option<&str>, &str, &[tree::Argument]) {
    (function.owner.as_deref(), &function.tree.name, &function.suffix)
}

/// Counts of expressions whose types were computed and compared with rustc's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Typed {
    /// Number of expressions with a computed type.
    pub expressions: u32,
    /// Number of computed types that agree with rustc's slot.
    pub agreed: u32,
}

/// Fields that lead to a slice in a value. The elements of an array have no step, since they share one lender.
pub(super) type Path = Vec<u32>;

/// Two slices in a struct that have the same lender, since a function makes one a part of the other.
pub(super) type Joined = (StructId, [Path; 2]);

/// A slice in a value.
#[derive(Clone)]
pub(super) struct Borrowed {
    /// Type of one element.
    pub element: Type,
    /// True if its elements may be written through it.
    pub mutable: bool,
    /// True for one element, `&mut T`.
    pub one: bool,
}

/// Location of an author's type: its module, and its position in the order of definitions.
#[derive(Clone)]
pub(super) struct Home {
    /// A type contains only types with a lower number.
    pub order: usize,
    pub module: String,
    pub span: Span,
}

/// A variant of a [`Form::Choice`]. Its word is its index.
#[derive(Clone)]
pub(super) struct Case {
    /// Name in Rust, such as `Some`.
    pub name: String,
    /// Index of the field that holds the payload.
    pub field: Option<u32>,
    /// True if the payload is one value, not a struct of several.
    pub single: bool,
}

/// An author's zero-sized type.
pub(super) struct Nothing {
    pub name: String,
    pub module: String,
    /// True if the type does not derive `PartialEq`, so its values may be unequal.
    pub unequal: bool,
}

/// The names of a package.
pub(super) struct Names<'a> {
    /// Type of names, once there is one.
    pub ty: Option<EnumId>,
    /// Pairs of names with one word, by the word, which are not refused yet.
    pub clashes: BTreeMap<u64, [&'a str; 2]>,
}

impl<'a> Names<'a> {
    pub(super) fn of(package: &'a Package) -> Self {
        let mut texts = BTreeMap::from([(0, "")]);
        let mut clashes = BTreeMap::new();
        for (word, text) in &package.names {
            match texts.insert(*word, text.as_str()) {
                Some(other) if other != text => _ = clashes.insert(*word, [other, text]),
                _ => {}
            }
        }
        Names { ty: None, clashes }
    }

    /// Takes a pair with one of these words. Many values have the word of the empty name, 0, which counts for texts alone.
    pub(super) fn clash(&mut self, words: &[u64], is_text: bool) -> Option<[&'a str; 2]> {
        let mut words = words.iter().filter(|word| is_text || **word != 0);
        words.find_map(|word| self.clashes.remove(word))
    }
}

/// Generated functions that compare two values of a type.
#[derive(Default)]
pub(super) struct Compared {
    /// `==`.
    pub(super) equal: Option<FunctionId>,
    /// `<`.
    pub(super) less: Option<FunctionId>,
    /// `<=`.
    pub(super) less_or_equal: Option<FunctionId>,
}

/// Facts about a type besides its definition.
#[derive(Default)]
pub(super) struct Known<'a> {
    /// Location of an author's type, or of a type that contains one.
    pub(super) home: Option<Home>,
    /// Rust's name of the standard type that a struct represents.
    pub(super) shown: Option<String>,
    /// Variants of a struct that represents an `Option`, a `Result` or an enum with payload.
    pub(super) cases: Vec<Case>,
    /// Error type of a struct that represents a `Result`.
    pub(super) error: Option<tree::Ty>,
    /// Fields with their indices in the C, if some are zero-sized and have none.
    pub(super) fields: Vec<(String, Option<usize>)>,
    /// rustc's types of the fields of a struct, or of an enum with payload.
    pub(super) rustc: Vec<tree::Ty>,
    /// Generated functions that compare two values part by part.
    pub(super) compared: Compared,
    /// Path of the author's function for `==`.
    pub(super) own_equality: Option<&'a str>,
    /// True if the type does not derive `PartialEq`.
    pub(super) unequal: bool,
    /// True if the type derives `PartialOrd`.
    pub(super) ordered: bool,
    /// True for `Reverse`, which orders greater values first.
    pub(super) reversed: bool,
    /// True for a `BoundedMatrix`.
    pub(super) bounded: bool,
    /// For a range: true if it includes its end.
    pub(super) range: Option<bool>,
    /// For a quaternion: true if it is a unit quaternion.
    pub(super) unit: Option<bool>,
}

/// The types so far.
#[derive(Default)]
pub(super) struct Types<'a> {
    pub(super) by_path: HashMap<String, Type>,
    /// Zero-sized types, which the C does not have.
    pub(super) nothings: HashMap<String, Nothing>,
    /// True if the C omits a type or a field.
    pub(super) leaves_out: bool,
    /// Authors' types with an error that was reported.
    pub(super) undefined: HashSet<&'a str>,
    /// Structs that represent standard types.
    pub(super) generics: HashMap<tree::Ty, Type>,
    /// Facts about each type; `unknown` serves all others.
    pub(super) known: HashMap<Type, Known<'a>>,
    pub(super) unknown: Known<'a>,
    /// Structs that represent slices in values.
    pub(super) borrowed: HashMap<StructId, Borrowed>,
    /// Pairs of slices in structs that have one lender.
    pub(super) joined: Vec<Joined>,
}

/// The functions that can be called.
#[derive(Default)]
pub(super) struct Calls<'a> {
    /// Functions of the module, by path.
    pub(super) lowered: HashMap<String, FunctionId>,
    /// All functions, by path.
    pub(super) all: HashMap<&'a str, &'a tree::Function>,
    /// Functions that are lowered at their first use.
    pub(super) waiting: HashMap<&'a str, &'a tree::Function>,
    /// Functions that are being lowered, each required by the one before.
    pub(super) underway: Vec<&'a str>,
    /// For each function, true for the parameters that are zero-sized.
    pub(super) absent: HashMap<FunctionId, Vec<bool>>,
    /// For each function, the lenders of the slices in its result, as places in its parameters.
    pub(super) given_back: HashMap<FunctionId, Vec<(Path, Place)>>,
    /// Paths of functions that return references and are inlined: a reference lowers to a place, never to a pointer.
    pub(super) lending: HashSet<&'a str>,
    /// Callees without a name in the source.
    pub(super) unnamed: Vec<tree::Callee>,
    /// The authors' `iter` methods.
    pub(super) own_iterators: Vec<&'a tree::Function>,
}

/// The authors' implementations of std's traits.
#[derive(Default)]
pub(super) struct Implied<'a> {
    /// Conversions between authors' types, and comparisons of two types.
    pub(super) between: Vec<&'a tree::Implied>,
    /// Implementations of `Index`.
    pub(super) indexing: Vec<(Type, &'a tree::Implied)>,
    /// Author-defined iterators, each with the callee number of its `next`.
    pub(super) iterators: Vec<(Type, u32)>,
}

/// The module so far, and the meaning of its names.
pub(super) struct Context<'a> {
    pub(super) module: Module,
    pub(super) typed: Typed,
    pub(super) by_columns: bool,
    pub(super) package: &'a Package,
    pub(super) sources: &'a Sources,
    pub(super) files: HashMap<String, u32>,
    /// Names that authors gave to generic instances, by path.
    pub(super) aliases: HashMap<&'a str, &'a tree::Alias>,
    /// Names in snake case, below their module or type, that authors chose.
    pub(super) authored: HashSet<String>,
    pub(super) types: Types<'a>,
    /// Names, `&str`: their type, and pairs that the C could not distinguish.
    pub(super) names: Names<'a>,
    pub(super) calls: Calls<'a>,
    pub(super) implied: Implied<'a>,
    /// Errors so far.
    pub(super) told: Vec<Diagnostic>,
    /// True if the builder found an error.
    pub(super) refused: bool,
}

impl<'a> Context<'a> {
    /// Returns the facts about a type.
    pub(super) fn known(&self, ty: &Type) -> &Known<'a> {
        self.types.known.get(ty).unwrap_or(&self.types.unknown)
    }

    /// Returns the facts about a struct.
    pub(super) fn known_of(&self, id: StructId) -> &Known<'a> {
        self.known(&Type::Struct(id))
    }

    /// Returns the facts about a type, to add more.
    pub(super) fn note(&mut self, ty: &Type) -> &mut Known<'a> {
        self.types.known.entry(ty.clone()).or_default()
    }

    /// Returns true if another function of the same owner has the same name.
    pub(super) fn is_claimed_twice(&self, function: &tree::Function) -> bool {
        let all = self.package.functions.iter();
        all.filter(|other| claim(other) == claim(function)).nth(1).is_some()
    }

    pub(super) fn span(&mut self, file: &str, Site(line, column): Site) -> Span {
        if let Some(&file) = self.files.get(file) {
            return Span { file, line, column };
        }
        let index = self.module.files.len() as u32;
        self.files.insert(file.to_owned(), index);
        self.module.files.push(file.to_owned());
        let about = self.sources.about(file);
        if !about.is_empty() {
            self.module.about.insert(file.to_owned(), about);
        }
        Span { file: index, line, column }
    }

    /// Reports a problem. A problem without a message depends on one that was reported already, and is dropped.
    pub(super) fn tell(&mut self, file: &str, problem: Problem) {
        if !problem.message.is_empty() {
            self.told.push(diagnostic(file, problem));
        }
    }
}
