//! Writes into the heads of functions what their callers promise: memory that no other argument shares, and a look at
//! the status.
//!
//! A pointer to what a function writes is `restrict` if the function has another pointer, so compilers report a call
//! that breaks the promise. Kernels do without: there it costs registers. So do pointers for which a call within the
//! C is not proved to keep it ([`disjoint`]). If such a function reads a parameter only before it writes its result
//! ([`late`](crate::late)), its comment says that they may share memory. Must not know: how functions are lowered.

use std::collections::{BTreeMap, BTreeSet};

use super::contracts;
use super::draft::Draft;
use crate::c::assemble::assemble;
use crate::c::context::Context;
use crate::c::disjoint::{self, Pair};
use crate::c::file::CFile;
use crate::c::options::Options;
use crate::c::shell::Shell;
use crate::c::spelling::identifier;
use crate::c::tree::{Head, Item, Storage};
use crate::late::early;
use bessemer_ir::{Form, FunctionId};

/// Writes the promises into the files, and returns the header of their macros if one is used.
pub(super) fn write(
    context: Context<'_>,
    options: &Options,
    drafts: &mut [Draft],
) -> Option<CFile> {
    let functions = drafts.iter().flat_map(|draft| &draft.items);
    let unproved = disjoint::unproved(functions, &in_unions(context));
    if options.contracts {
        contracts::write(context, drafts, &unproved);
    }
    let functions = context.module.functions.iter().zip(&context.names.functions);
    let kernels: BTreeSet<&str> =
        functions.filter(|(it, _)| it.kernel.is_some()).map(|(_, it)| it.name.as_str()).collect();
    let in_place = in_place(context, &unproved);
    let macros = Macros::new(options);
    let header = options.header(&format!("{}_calls", identifier(&options.status)));
    let mut used = false;
    for draft in drafts {
        let mut own = false;
        for item in &mut draft.items {
            let (head, docs, declared) = match item {
                Item::Prototype { head, docs, .. } => (head, docs, true),
                Item::Function { head, docs, .. } => (head, docs, false),
                _ => continue,
            };
            // The comment is at the declaration of what other files call, and at the definition of the rest.
            if declared == (head.storage == Storage::Extern) {
                docs.extend(in_place.get(&head.name).cloned());
            }
            if matches!(head.storage, Storage::Extern | Storage::Static) {
                own |= !kernels.contains(head.name.as_str())
                    && restrict(head, &macros.restrict, &unproved);
                if declared
                    && head.storage == Storage::Extern
                    && head.result == context.names.status.ty
                {
                    head.result = format!("{} {}", macros.must_use, head.result);
                    own = true;
                }
            }
        }
        if own {
            draft.includes.own.insert(header.clone());
        }
        used |= own;
    }
    used.then(|| macros.header(context, options, &header))
}

/// Returns sentences about results that may share memory with a parameter, by the function's name: those for which the
/// C itself has such a call.
fn in_place(context: Context<'_>, unproved: &BTreeSet<Pair>) -> BTreeMap<String, String> {
    let mut said = BTreeMap::new();
    for (index, function) in context.module.functions.iter().enumerate() {
        let id = FunctionId(index as u32);
        let signature = context.names.signature(id);
        let params = &context.names.head(signature).params;
        let Some(result) = params.get(function.params as usize) else { continue };
        let early = early(function, context.faults.fallible(id));
        let called = |at: &usize| {
            let pair = |one, other| (signature.name.clone(), one, other);
            let last = function.params as usize;
            unproved.contains(&pair(last, *at)) || unproved.contains(&pair(*at, last))
        };
        let one = (0..function.params as usize).filter(|at| early.has(*at) && called(at));
        // A place of the same type is the whole one: at another address, an element would be read too late.
        let may = |at: usize| match function.locals[at].ty == function.result {
            true => format!("be `{}`", params[at].name),
            false => format!("lie in `{}`", params[at].name),
        };
        let places: Vec<String> = one.map(may).collect();
        if !places.is_empty() {
            let (name, or) = (&result.name, places.join(" or "));
            said.insert(
                signature.name.clone(),
                format!("`{name}` may {or}: nothing is read after it is written."),
            );
        }
    }
    said
}

/// Returns the fields that share memory with other fields.
fn in_unions(context: Context<'_>) -> BTreeSet<String> {
    let structs = context.module.structs.iter().zip(&context.names.structs);
    let shared = structs.flat_map(|(item, names)| match item.form {
        Form::Shared => &names.fields[..],
        _ if item.overlaid() => &names.fields[1..],
        _ => &[],
    });
    shared.cloned().collect()
}

/// Marks the pointers to what a function writes, and returns true if there is one.
fn restrict(head: &mut Head, word: &str, unproved: &BTreeSet<Pair>) -> bool {
    let shares = |index: usize| {
        unproved
            .iter()
            .any(|(name, one, other)| *name == head.name && (*one == index || *other == index))
    };
    let written: Vec<usize> =
        disjoint::written(head).into_iter().filter(|index| !shares(*index)).collect();
    for index in &written {
        let param = &mut head.params[*index];
        match param.dimensions.strip_prefix('[') {
            Some(rest) if rest.starts_with(']') => param.dimensions = format!("[{word}{rest}"),
            Some(rest) => param.dimensions = format!("[{word} {rest}"),
            None => param.ty.push_str(word),
        }
    }
    !written.is_empty()
}

struct Macros {
    restrict: String,
    must_use: String,
}

impl Macros {
    fn new(options: &Options) -> Macros {
        let stem = identifier(&options.status).to_uppercase();
        Macros { restrict: format!("{stem}_RESTRICT"), must_use: format!("{stem}_MUST_USE") }
    }

    fn header(&self, context: Context<'_>, options: &Options, name: &str) -> CFile {
        let Macros { restrict, must_use } = self;
        let restrict = format!(
            "/*\n * Marks a pointer to what a function writes: no other argument leads to memory that it writes there.\n \
             * A call that breaks this is undefined; gcc reports the plain cases (-Wrestrict, which is in -Wall).\n \
             * Defined as nothing, the C makes no use of the promise. C++ has no such word.\n */\n\
             #ifndef {restrict}\n#if defined(__cplusplus)\n#define {restrict}\n#else\n#define {restrict} restrict\n\
             #endif\n#endif"
        );
        let must_use = format!(
            "/* Has compilers report a call whose status nobody looks at. Nothing where the compiler is not known. */\n\
             #ifndef {must_use}\n#if defined(__GNUC__)\n\
             #define {must_use} __attribute__((warn_unused_result))\n#else\n#define {must_use}\n#endif\n#endif"
        );
        let shell = Shell {
            about: &[],
            file: name,
            header: name,
            summary: "what callers of the functions promise.",
            source: &context.module.name,
            license: &options.license,
            pragmas: options.pragmas,
            system_includes: Vec::new(),
            own_includes: Vec::new(),
            calls: false,
            refuses: true,
            computes: false,
        };
        assemble(context, name, &shell, true, &[Item::Verbatim(restrict), Item::Verbatim(must_use)])
    }
}
