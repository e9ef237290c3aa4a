//! Header of inline functions that several sources, and files of the firmware, may call.
//!
//! Invariants: it contains the package's public functions, the called ones of other crates, and their callees, callees
//! first. A function belongs here because of the function and its module alone
//! ([`crate::c::placing::Placing::moved`]), so a source's text does not depend on other callers.

use std::collections::BTreeSet;

use bessemer_ir::{FunctionId, Role};

use super::draft::Draft;
use super::includes::Includes;
use super::{Unit, Writer};
use crate::c::analysis::is_own;
use crate::c::context::{Context, Uses};
use crate::c::options::Options;
use crate::c::tree::{Item, Storage};
use crate::c::{asked, internal};

/// Returns the header of the called inline functions, if there are any, and its requirements.
pub(super) fn shared(
    context: Context<'_>,
    options: &Options,
    called: &BTreeSet<FunctionId>,
) -> (Option<Draft>, Uses) {
    let name = internal::inline(options);
    let mut uses = Uses { file: name.clone(), called: called.clone(), ..Uses::default() };
    let (mut includes, mut asked) = (Includes::default(), BTreeSet::new());
    let writer = Writer { context, options, name: String::new(), unit: Unit::default() };
    let mut definitions = Vec::new();
    // Callees precede callers: what one calls is known when its turn comes.
    for index in (0..context.module.functions.len()).rev() {
        let id = FunctionId(index as u32);
        let is_inline = context.names.signature(id).storage == Storage::Inline;
        if is_inline && uses.called.contains(&id) || is_for_firmware(context, id) {
            definitions.push(writer.definition(id, &mut uses, &mut includes, &mut asked));
        }
    }
    if definitions.is_empty() {
        return (None, uses);
    }
    asked.extend(uses.unroll.then_some(asked::Macro::Unroll));
    let mut items: Vec<Item> =
        asked.iter().map(|asked| Item::Verbatim(asked.text(options))).collect();
    items.extend(definitions.into_iter().rev());
    includes.uses(context, options, &mut uses);
    let draft = Draft {
        header: name.clone(),
        name,
        summary: "small functions, inlined in the files that include it.".to_owned(),
        about: Vec::new(),
        source: context.module.name.clone(),
        public: true,
        computes: false,
        items,
        includes,
    };
    (Some(draft), uses)
}

/// Returns true for an inline function of the package that its author made public, so that firmware may call it.
pub(super) fn is_for_firmware(context: Context<'_>, id: FunctionId) -> bool {
    let function = &context.module.functions[id.index()];
    let is_inline = context.names.signature(id).storage == Storage::Inline;
    is_inline && function.role == Role::Inline { public: true } && is_own(context.module, function)
}
