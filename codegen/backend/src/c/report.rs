//! Figures of each entry point: sizes, checks, stack, and operations that small processors do not have.

use std::collections::BTreeSet;

use bessemer_ir::visit::Walk;
use bessemer_ir::{ExprKind, Float, Function, FunctionId, Module, Owner, Role, Span};

use super::context::{Context, Uses};
use super::file::CFile;
use super::layout::size_of_struct;
use super::lower;
use super::options::Options;
use super::units::{self, Measured};
use super::wide::{Wide, Width};
use crate::{kernels, passes};

/// Stack use of a call in addition to its variables: return address, saved registers, alignment, bytes.
const FRAME: u64 = 64;

/// Figures of one entry point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EntryReport {
    /// The function.
    pub function: FunctionId,
    /// Author's name of the component.
    pub component: String,
    /// The C type of its state.
    pub state: String,
    /// The C name of the entry point.
    pub entry: String,
    /// The header that declares it.
    pub header: String,
    /// Lines of the component's header and source.
    pub lines: usize,
    /// `sizeof` its state, bytes.
    pub state_bytes: u64,
    /// Estimated stack of the whole call tree: variables and frames along the deepest chain, bytes.
    pub stack_bytes: u64,
    /// Number of remaining checks, including callees.
    pub checks: u32,
    /// Bytes of the largest set of variables of one function in the call tree.
    pub largest_frame: u64,
    /// Number of operations in double in the text of all reached functions.
    pub doubles: usize,
    /// Number of 64-bit operations in the text of all reached functions.
    pub longs: usize,
    /// Author's lines with these operations.
    pub wide: Vec<Site>,
    /// Values with units.
    pub units: Vec<Measured>,
}

/// Stack of one function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FunctionReport {
    /// The function.
    pub function: FunctionId,
    /// The C name.
    pub name: String,
    /// Bytes of its own variables.
    pub frame_bytes: u64,
    /// Estimated stack with its callees, bytes.
    pub stack_bytes: u64,
}

/// A line of the author's with a wide operation.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Site {
    /// Span of the operation.
    pub span: Span,
    /// Limit of the target that the operation exceeds.
    pub width: Width,
    /// Function of another package that is called there and performs it; none if the line itself does.
    pub through: Option<FunctionId>,
}

/// Reports on every entry point and on every function, in the order of the module.
pub fn report(
    context: Context<'_>,
    options: &Options,
    files: &[CFile],
) -> (Vec<EntryReport>, Vec<FunctionReport>) {
    let Context { module, names, faults } = context;
    let mut deepest: Vec<(u64, u64)> = Vec::new();
    let (mut list, mut functions) = (Vec::new(), Vec::new());
    let mut widths = Widths { module, direct: Vec::new(), reached: Vec::new() };
    for (index, function) in module.functions.iter().enumerate() {
        let id = FunctionId(index as u32);
        let (own, wide) = match &function.kernel {
            Some(kernel) => {
                let double = kernel.element == Float::F64;
                let wide = double.then_some(Wide { width: Width::Double, span: function.span });
                (kernels::stack_bytes(kernel, &options.kernels), Vec::from_iter(wide))
            }
            None => {
                let lowered = lower::function(context, id, &mut Uses::default());
                (lowered.locals, lowered.wide)
            }
        };
        widths.add(function, wide);
        let (mut below, mut largest) = (0, own);
        function.body.each_expr(|expr| {
            if let ExprKind::Call(callee, _) = &expr.kind {
                let (depth, frame) = deepest[callee.index()];
                below = below.max(depth);
                largest = largest.max(frame);
            }
        });
        deepest.push((own.next_multiple_of(8) + FRAME + below, largest));
        functions.push(FunctionReport {
            function: id,
            name: names.signature(id).name.clone(),
            frame_bytes: own,
            stack_bytes: deepest[index].0,
        });
        let (Role::Entry { .. }, Some(Owner::Struct(owner))) = (function.role, function.owner)
        else {
            continue;
        };
        let file = names.placing.struct_file(owner);
        let own_files = files
            .iter()
            .filter(|other| other.name.rsplit_once('.').is_some_and(|(stem, _)| stem == file));
        list.push(EntryReport {
            function: id,
            component: module.structs[owner.index()].name.clone(),
            state: names.structs[owner.index()].ty.clone(),
            entry: names.signature(id).name.clone(),
            header: names.signature(id).header.clone(),
            lines: own_files.map(|file| file.text.lines().count()).sum(),
            state_bytes: size_of_struct(context, owner),
            stack_bytes: deepest[index].0,
            checks: faults.checks[index],
            largest_frame: largest,
            doubles: widths.count(index, Width::Double),
            longs: widths.count(index, Width::Long),
            wide: widths.sites(index),
            units: units::of_entry(module, names, function, names.signature(id)),
        });
    }
    (list, functions)
}

/// Wide operations of functions, callees before callers.
struct Widths<'m> {
    module: &'m Module,
    /// Wide operations of each function itself.
    direct: Vec<Vec<Wide>>,
    /// Widths that a call of each function reaches.
    reached: Vec<BTreeSet<Width>>,
}

impl Widths<'_> {
    fn add(&mut self, function: &Function, wide: Vec<Wide>) {
        let mut reached: BTreeSet<Width> = wide.iter().map(|it| it.width).collect();
        function.body.each_expr(|expr| {
            if let ExprKind::Call(callee, _) = &expr.kind {
                reached.extend(&self.reached[callee.index()]);
            }
        });
        self.direct.push(wide);
        self.reached.push(reached);
    }

    fn count(&self, entry: usize, width: Width) -> usize {
        let reached = passes::reached(self.module, entry);
        reached.iter().flat_map(|at| &self.direct[*at]).filter(|it| it.width == width).count()
    }

    /// Returns true if a function belongs to the compiled package, so that its lines are the author's.
    fn is_own(&self, function: &Function) -> bool {
        let root = self.module.name.replace('-', "_");
        function.kernel.is_none() && function.module.split("::").next() == Some(&*root)
    }

    fn sites(&self, entry: usize) -> Vec<Site> {
        let mut sites = BTreeSet::new();
        for at in passes::reached(self.module, entry) {
            let function = &self.module.functions[at];
            if !self.is_own(function) {
                continue;
            }
            let own = self.direct[at].iter();
            sites.extend(own.map(|it| Site { span: it.span, width: it.width, through: None }));
            function.body.each_expr(|expr| {
                if let ExprKind::Call(callee, _) = expr.kind
                    && !self.is_own(&self.module.functions[callee.index()])
                {
                    let reached = self.reached[callee.index()].iter();
                    let through = Some(callee);
                    sites.extend(reached.map(|width| Site {
                        span: expr.span,
                        width: *width,
                        through,
                    }));
                }
            });
        }
        sites.into_iter().collect()
    }
}
