//! The figures of each entry point: sizes, checks, stack.

use bessemer_ir::visit::Walk;
use bessemer_ir::{FunctionId, Module, Owner, Role};

use super::analysis::Faults;
use super::context::{Context, Uses};
use super::file::CFile;
use super::layout::size_of_struct;
use super::lower;
use super::names::Names;
use super::options::Options;
use super::units::{self, Measured};
use crate::kernels;

/// What a call costs beside the variables: return address, saved registers, alignment.
const FRAME: u64 = 64;

/// One entry point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EntryReport {
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
    /// What its author gave a unit.
    pub units: Vec<Measured>,
}

/// Reports on every entry point, in the order of the module.
pub fn report(module: &Module, options: &Options, files: &[CFile]) -> Vec<EntryReport> {
    let faults = Faults::new(module, options.hook.is_some());
    let names = Names::with_faults(module, options, &faults);
    let context = Context { module, names: &names, faults: &faults };
    let mut deepest: Vec<(u64, u64)> = Vec::new();
    let mut list = Vec::new();
    for (index, function) in module.functions.iter().enumerate() {
        let id = FunctionId(index as u32);
        let own = match &function.kernel {
            Some(kernel) => kernels::stack_bytes(kernel, &options.kernels),
            None => lower::function(context, id, &mut Uses::default()).locals,
        };
        let (mut below, mut largest) = (0, own);
        function.body.each_expr(|expr| {
            if let bessemer_ir::ExprKind::Call(callee, _) = &expr.kind {
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
            component: module.structs[owner.index()].name.clone(),
            state: names.structs[owner.index()].ty.clone(),
            entry: names.signature(id).name.clone(),
            header: names.signature(id).header.clone(),
            lines: own_files.map(|file| file.text.lines().count()).sum(),
            state_bytes: size_of_struct(context, owner),
            stack_bytes: deepest[index].0,
            checks: faults.checks[index],
            largest_frame: largest,
            units: units::of_entry(module, &names, function, names.signature(id)),
        });
    }
    list
}
