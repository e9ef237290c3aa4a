//! The figures of each entry point: sizes, checks, stack, operations that are too wide for a small processor.

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

/// Stack use of a call beside the variables: return address, saved registers, alignment.
const FRAME: u64 = 64;

/// One entry point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EntryReport {
    /// The function.
    pub function: FunctionId,
    /// The author's name of the component.
    pub component: String,
    /// The C type of its state.
    pub state: String,
    /// The C name of the entry point.
    pub entry: String,
    /// The header that declares it.
    pub header: String,
    /// Lines of the component's header and source.
    pub lines: usize,
    /// `sizeof` its state.
    pub state_bytes: u64,
    /// An estimate for the whole call tree: variables and frames along the deepest chain.
    pub stack_bytes: u64,
    /// Checks that are left, callees' included.
    pub checks: u32,
    /// Bytes of the largest set of variables of one function in the call tree.
    pub largest_frame: u64,
    /// Operations in double in the text of all that it reaches.
    pub doubles: usize,
    /// Operations of 64 bits there.
    pub longs: usize,
    /// The author's lines that lead to them.
    pub wide: Vec<Site>,
    /// Items with a unit from their author.
    pub units: Vec<Measured>,
}

/// A place at which the author requests an operation that is too wide for a small processor.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Site {
    /// Span of the operation.
    pub span: Span,
    /// Width that it exceeds.
    pub width: Width,
    /// The function of another package that is called there, and carries it out.
    pub through: Option<FunctionId>,
}

/// Reports on every entry point, in the order of the module.
pub fn report(context: Context<'_>, options: &Options, files: &[CFile]) -> Vec<EntryReport> {
    let Context { module, names, faults } = context;
    let mut deepest: Vec<(u64, u64)> = Vec::new();
    let mut list = Vec::new();
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
    list
}

/// The operations of functions that are too wide, callees before callers.
struct Widths<'m> {
    module: &'m Module,
    /// Each function's own.
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

    /// Returns true if a function is of the package that is compiled, and its lines are the author's.
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
