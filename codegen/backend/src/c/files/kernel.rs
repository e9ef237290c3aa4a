//! Places kernels in files: in a source, or in the header if they are small.

use bessemer_ir::visit::Walk;
use bessemer_ir::{ExprKind, FunctionId, Kernel, Span};

use super::{Callable, Includes, Writer, origin, rust_path};
use crate::c::context::Uses;
use crate::c::helpers::Helper;
use crate::c::shell::NO_CONTRACTION;
use crate::c::tree::Storage;
use crate::c::tree::{Item, StmtKind, plain};
use crate::kernels;
use crate::kernels::replace::Replacement;

impl Writer<'_> {
    /// Returns the kernel of a function, if it is defined in its header.
    pub(super) fn in_header(&self, callable: &Callable) -> Option<&Kernel> {
        let Callable::Function(id) = callable else { return None };
        let kernel = self.context.module.functions[id.index()].kernel.as_ref()?;
        let own = Replacement::of(&self.options.replacements, kernel).is_none();
        (own && kernels::is_in_header(kernel)).then_some(kernel)
    }

    /// Returns a kernel as an inline function of its header.
    pub(super) fn inline_kernel(
        &self,
        kernel: &Kernel,
        id: FunctionId,
        includes: &mut Includes,
    ) -> Vec<Item> {
        let mut uses = Uses::default();
        let mut items = self.kernel(kernel, id, &mut uses);
        for item in &mut items {
            if let Item::Function { docs, head, body, .. } = item {
                head.storage = Storage::Inline;
                if self.options.pragmas {
                    body.insert(0, plain(StmtKind::Verbatim(NO_CONTRACTION.to_owned())));
                }
                docs.clone_from(&self.context.module.functions[id.index()].docs);
            }
        }
        includes.system.extend(["float.h", "stdint.h"]);
        includes.system.append(&mut uses.system);
        items
    }

    /// Returns a kernel as an item of a source, with the declarations that it needs.
    pub(super) fn kernel(&self, kernel: &Kernel, id: FunctionId, uses: &mut Uses) -> Vec<Item> {
        let tuning = &self.options.kernels;
        let own = kernels::source(kernel, tuning);
        let lends = !kernels::lent(kernel, tuning).is_empty();
        let source = match Replacement::of(&self.options.replacements, kernel) {
            Some(replacement) => replacement.replace(kernel, own, lends),
            None => own,
        };
        uses.system.extend(source.math.then_some("math.h"));
        uses.system.extend(source.string.then_some("string.h"));
        uses.helpers.extend(source.dot.then_some(Helper::Dot(kernel.element)));
        let before = (!source.before.is_empty()).then_some(Item::Verbatim(source.before));
        let body = vec![plain(StmtKind::Verbatim(source.body))];
        let function = Item::Function {
            docs: Vec::new(),
            head: self.context.names.head(self.context.names.signature(id)),
            body,
            origin: origin(self.first_call(id)),
            function: rust_path(self.context, &self.context.module.functions[id.index()]),
        };
        before.into_iter().chain([function]).collect()
    }
    /// Returns the first call of a kernel, which stands for its lines of Rust.
    fn first_call(&self, id: FunctionId) -> Span {
        let mut first = Span::default();
        for function in &self.context.module.functions {
            function.body.each_expr(|expr| {
                if matches!(expr.kind, ExprKind::Call(callee, _) if callee == id) && first.line == 0
                {
                    first = expr.span;
                }
            });
        }
        first
    }
}
