//! Names of the status type and its values, and of the hook that a fault calls.

use bessemer_ir::Fault;

use super::options::Options;
use super::spelling::identifier;

/// Names of the status type and its values.
#[derive(Clone, Debug)]
pub struct StatusNames {
    /// Type name, `bessemer_status_t`.
    pub ty: String,
    /// Enumerator for no fault.
    pub ok: String,
    /// Header that declares the type.
    pub header: String,
    /// Function of the firmware that a fault calls.
    pub hook: Option<String>,
    prefix: String,
    /// Macro in front of a loop of few passes, if it is written.
    pub few: Option<String>,
}

/// All faults, in the order of their numbers in C (from 1).
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

/// Largest number of passes that gcc writes out. On the Cortex-A9 a pass over an element has 5 instructions beside 5 of
/// the loop's own.
pub const FEW: u32 = 12;
/// Largest number of operations in the passes that gcc writes out. Beside more, the loop's own instructions are few.
pub const FEW_OPERATIONS: u32 = 40;

/// Returns the macro in front of a loop of few passes; none in C without pragmas, and where loops stay as they are.
pub fn few(options: &Options) -> Option<String> {
    let is_written = options.pragmas && options.kernels.tiles();
    is_written.then(|| format!("{}_FEW_PASSES", identifier(&options.status).to_uppercase()))
}

impl StatusNames {
    /// Returns the names for the user's options.
    pub fn new(options: &Options) -> StatusNames {
        let stem = identifier(&options.status);
        let prefix = format!("{}_STATUS", stem.to_uppercase());
        StatusNames {
            few: few(options),
            ty: format!("{stem}_status_t"),
            ok: format!("{prefix}_OK"),
            header: options.header(&format!("{stem}_status")),
            hook: options.hook.clone(),
            prefix,
        }
    }

    /// Returns the macro that requests unrolling of a loop.
    pub fn unroll(&self) -> String {
        format!("{}_UNROLL", self.prefix.trim_end_matches("_STATUS"))
    }

    /// Returns the enumerator of a fault.
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
