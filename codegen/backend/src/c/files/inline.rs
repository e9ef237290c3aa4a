//! Header of inline functions that several sources may call.
//!
//! Invariants: it contains the called functions and their callees, callees first. A function belongs here because of
//! the function and its module alone ([`crate::c::placing::Placing::moved`]), so a source's text does not depend on
//! other callers.

use std::collections::BTreeSet;

use bessemer_ir::FunctionId;

use super::draft::Draft;
use super::includes::Includes;
use super::{Unit, Writer};
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
        if is_inline && uses.called.contains(&id) {
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
        summary:
            "small functions that stand where they are called; for the sources beside it alone."
                .to_owned(),
        about: Vec::new(),
        source: context.module.name.clone(),
        public: false,
        computes: false,
        items,
        includes,
    };
    (Some(draft), uses)
}
