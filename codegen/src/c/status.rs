//! The status type: what a call can come to, its names and its header; and the hook that a fault calls if
//! there is one.

use bessemer_ir::Fault;

use super::files::assemble;
use super::lower::Context;
use super::shell::Shell;
use super::spelling::identifier;
use super::tree::{Declarator, Head, Item, Origin, Storage};
use super::{CFile, Options};

/// The names of the status type and its values.
#[derive(Clone, Debug)]
pub struct StatusNames {
    /// The type, `bessemer_status_t`.
    pub ty: String,
    /// No fault.
    pub ok: String,
    /// The header.
    pub header: String,
    /// The function of the firmware's that a fault calls.
    pub hook: Option<String>,
    prefix: String,
}

/// Every fault, in the order of its number in C (from 1).
pub const FAULTS: [Fault; 10] = [
    Fault::Overflow,
    Fault::DivisionByZero,
    Fault::Shift,
    Fault::Index,
    Fault::Clamp,
    Fault::Variant,
    Fault::Assertion,
    Fault::Bound,
    Fault::Absent,
    Fault::Capacity,
];

impl StatusNames {
    /// Those that the user decided for.
    pub fn new(options: &Options) -> StatusNames {
        let stem = identifier(&options.status);
        let prefix = format!("{}_STATUS", stem.to_uppercase());
        StatusNames {
            ty: format!("{stem}_status_t"),
            ok: format!("{prefix}_OK"),
            header: format!("{stem}_status.h"),
            hook: options.hook.clone(),
            prefix,
        }
    }

    /// The macro that asks for a loop to be written out.
    pub fn unroll(&self) -> String {
        format!("{}_UNROLL", self.prefix.trim_end_matches("_STATUS"))
    }

    /// The enumerator of a fault.
    pub fn fault(&self, fault: Fault) -> String {
        let word = match fault {
            Fault::Overflow => "OVERFLOW",
            Fault::DivisionByZero => "DIVISION_BY_ZERO",
            Fault::Shift => "SHIFT",
            Fault::Index => "INDEX",
            Fault::Clamp => "CLAMP",
            Fault::Variant => "VARIANT",
            Fault::Assertion => "ASSERTION",
            Fault::Bound => "BOUND",
            Fault::Absent => "ABSENT",
            Fault::Capacity => "CAPACITY",
            Fault::LeftOut => unreachable!("it ends the program, and no status tells of it"),
        };
        format!("{}_{word}", self.prefix)
    }
}

/// The header of the status type: what a call can come to.
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
        file: &status.header,
        header: &status.header,
        summary: "what a call came to.",
        source: &context.module.name,
        license: &options.license,
        system_includes: Vec::new(),
        own_includes: Vec::new(),
        refuses: true,
    };
    assemble(context, &status.header, &shell, true, &items)
}
