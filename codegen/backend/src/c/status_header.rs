//! Header of the status type.

use bessemer_ir::Fault;

use super::assemble::assemble;
use super::context::Context;
use super::file::CFile;
use super::options::Options;
use super::shell::Shell;
use super::status::FAULTS;
use super::tree::{Declarator, Head, Item, Origin, Storage};

/// Returns the header of the status type.
pub fn header(context: Context<'_>, options: &Options) -> CFile {
    let status = &context.names.status;
    let mut variants = vec![(vec!["All is well.".to_owned()], status.ok.clone(), 0)];
    for (value, fault) in (1..).zip(FAULTS) {
        let docs = match fault {
            Fault::Overflow => "Integer arithmetic left its type.",
            Fault::DivisionByZero => "An integer was divided by zero.",
            Fault::Shift => "A shift by the width of the type or more.",
            Fault::Index => "An index beyond the end.",
            Fault::Clamp => "Bounds that are not low <= high.",
            Fault::Variant => "An enum that holds none of its values.",
            Fault::Assertion => "An assertion does not hold.",
            Fault::Bound => "A loop did not end within its bound.",
            Fault::Absent => "A value that is not there was taken.",
            Fault::Capacity => "A bounded container is full.",
            Fault::LeftOut => continue,
        };
        variants.push((vec![docs.to_owned()], status.fault(fault), value));
    }
    let meaning = match status.hook {
        None => "What a call came to. After a fault its outputs are as they were.",
        Some(_) => "Why a call could not go on.",
    };
    let item = Item::Enum {
        docs: vec![meaning.to_owned()],
        name: status.ty.clone(),
        variants,
        origin: Origin { file: 0, line: 0 },
    };
    let hook = status.hook.as_ref().map(|name| Item::Prototype {
        docs: vec!["The firmware brings it: a fault calls it, and it does not return.".to_owned()],
        head: Head {
            contract: Vec::new(),
            asked: Vec::new(),
            storage: Storage::Foreign,
            result: "void".to_owned(),
            name: name.clone(),
            params: vec![Declarator {
                ty: status.ty.clone(),
                name: "fault".to_owned(),
                dimensions: String::new(),
            }],
        },
        origin: Origin { file: 0, line: 0 },
        function: String::new(),
    });
    let items: Vec<Item> = std::iter::once(item).chain(hook).collect();
    let shell = Shell {
        about: &[],
        file: &status.header,
        header: &status.header,
        summary: "what a call came to.",
        source: &context.module.name,
        license: &options.license,
        pragmas: options.pragmas,
        system_includes: Vec::new(),
        own_includes: Vec::new(),
        calls: false,
        refuses: true,
        computes: false,
    };
    assemble(context, &status.header, &shell, true, &items)
}
