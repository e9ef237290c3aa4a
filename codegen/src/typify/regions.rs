//! What is known of the slices in values: which fields they are, and of which array each is in the locals of a function.
//!
//! Must not know: how any of it is found ([`lenders`](super::lenders)).

use bessemer_ir::tree::Site;
use bessemer_ir::{Expr, LocalId, Place, Span, StructId, Type};

use super::Problem;

/// The fields that lead to a slice in a value; an element of an array is as any other.
pub(super) type Path = Vec<u32>;

/// The refusal of an array of slices: each would have a lender of its own.
pub(super) const MANY: &str = "an array or a list of slices is not in the DSL";
pub(super) const ONE: &str = "keep their ends, an array of pairs, or a field for each slice";

/// Two slices in a struct that have one lender, since a function makes one a part of the other.
pub(super) type Joined = (StructId, [Path; 2]);

/// The slices in the locals of a function, and the arrays whose elements they are.
#[derive(Default)]
pub(super) struct Lenders {
    /// The lender of each slice, by the local that it is in and the fields that lead to it.
    pub known: Vec<(LocalId, Path, Place)>,
    /// Those of slices that are in no local yet.
    pub made: Vec<(Expr, Place)>,
    /// Those of the result.
    pub result: Vec<(Path, Place)>,
    /// The locals that say where a slice begins and how many elements it has, which not every use asks.
    pub taken: Vec<LocalId>,
    /// The parameters that lend: of which other one, and of which slices in it.
    pub lending: Vec<(LocalId, LocalId, Path)>,
    /// What stands for those that are not known yet.
    pub awaited: Vec<Awaited>,
    /// Slices that were copied before their lender was known: to which local, or out of the function, and from where.
    pub copied: Vec<Copied>,
    /// How many locals are parameters.
    pub params: usize,
    /// What is wrong with one of them.
    pub problem: Option<Problem>,
}

impl Lenders {
    /// The lender of the slice in a local, at the fields that lead to it.
    pub fn of(&self, root: LocalId, path: &[u32]) -> Option<Place> {
        let mut known = self.known.iter();
        known.find(|it| it.0 == root && it.1 == path).map(|it| it.2.clone())
    }
}

/// A slice that was copied, at the fields that lead to it in what it was copied to; none is the result.
pub(super) struct Copied {
    pub to: (Option<LocalId>, Path),
    pub from: (LocalId, Path),
    pub span: Span,
}

/// A local that stands for an array until something shows which one it is.
pub(super) struct Awaited {
    pub stands: LocalId,
    pub element: Type,
    /// The slice: the local that it is in, and the fields that lead to it.
    pub of: (LocalId, Path),
    pub site: Site,
    /// What to do where nothing shows it.
    pub help: &'static str,
}
