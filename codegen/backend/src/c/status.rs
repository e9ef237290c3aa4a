//! Names of the status type and its values, and of the hook that a fault calls, if there is one.

use bessemer_ir::Fault;

use super::options::Options;
use super::spelling::identifier;

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
            header: options.header(&format!("{stem}_status")),
            hook: options.hook.clone(),
            prefix,
        }
    }

    /// The macro that asks the compiler to unroll a loop.
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
