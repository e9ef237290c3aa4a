//! Cycles of an instruction, by a simple model of two processors that execute in order.
//!
//! All data are in the first cache, or in memory without wait states.
//!
//! The figures follow Arm's Technical Reference Manuals of the Cortex-M4 (DDI 0439) and of the Cortex-A9's
//! floating-point unit (DDI 0408), by class of instruction. No processor has confirmed them. A branch counts as taken, on the Cortex-A9 as mispredicted. On the
//! Cortex-A9 each operation waits for the one before it.

use super::Processor;

/// Returns the cycles of an instruction.
pub fn of(processor: Processor, text: &str) -> u64 {
    let (word, operands) = text.split_once(' ').unwrap_or((text, ""));
    let stem = word.split('.').next().unwrap_or_default();
    let is_double = word.contains(".f64");
    let begins = |list: &[&str]| list.iter().any(|it| stem.starts_with(it));
    let (branch, division) = match processor {
        Processor::A9 => (8, 0),
        Processor::M4f => (3, 12),
    };
    if begins(&["vdiv"]) {
        return match (processor, is_double) {
            (Processor::A9, true) => 25,
            (Processor::A9, false) => 15,
            (Processor::M4f, _) => 14,
        };
    }
    if begins(&["vsqrt"]) {
        return match (processor, is_double) {
            (Processor::A9, true) => 32,
            (Processor::A9, false) => 17,
            (Processor::M4f, _) => 14,
        };
    }
    let registers = registers(operands);
    if begins(&["push", "pop", "ldm", "stm", "vpush", "vpop", "vldm", "vstm"]) {
        let leaves = if operands.contains("pc") { branch } else { 0 };
        return 1 + registers * if begins(&["v"]) { 2 } else { 1 } + leaves;
    }
    if begins(&["vldr", "vstr", "ldrd", "strd"]) {
        return 3;
    }
    if begins(&["ldr", "str"]) {
        return if operands.starts_with("pc") { 2 + branch } else { 2 };
    }
    if begins(&["cb", "tb", "b"]) && !begins(&["bic", "bfi", "bfc"]) {
        return branch + u64::from(begins(&["tb"])) * 2;
    }
    if begins(&["sdiv", "udiv"]) {
        return division;
    }
    match processor {
        Processor::A9 if begins(&["vmla", "vmls", "vnml"]) => {
            if is_double {
                10
            } else {
                9
            }
        }
        Processor::A9 if begins(&["vmul", "vnmul"]) => {
            if is_double {
                6
            } else {
                5
            }
        }
        Processor::A9 if begins(&["vadd", "vsub", "vcvt", "vcmp"]) => 4,
        Processor::A9 if begins(&["vm"]) => 3,
        Processor::A9 if begins(&["mul", "mla", "mls", "umull", "smull", "umlal", "smlal"]) => 5,
        Processor::M4f if begins(&["vmla", "vmls", "vfma", "vfms", "vnml"]) => 3,
        _ => 1,
    }
}

/// Returns the number of registers in a list, with ranges.
fn registers(operands: &str) -> u64 {
    let list = operands.split(['{', '}']).nth(1).unwrap_or_default();
    let number =
        |it: &str| it.trim_start_matches(|it: char| it.is_alphabetic()).parse::<u64>().ok();
    let each = list.split(',').map(str::trim).filter(|it| !it.is_empty()).map(|it| {
        let ends = it.split_once('-').and_then(|(from, to)| Some((number(from)?, number(to)?)));
        ends.map_or(1, |(from, to)| to.saturating_sub(from) + 1)
    });
    each.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_have_the_cycles_of_their_class() {
        let a9 = |text: &str| of(Processor::A9, text);
        let m4 = |text: &str| of(Processor::M4f, text);
        assert_eq!([a9("add r0, r1, r2"), a9("vdiv.f64 d0, d1, d2"), a9("bne .L3")], [1, 25, 8]);
        assert_eq!(
            [m4("vsqrt.f32 s0, s1"), m4("push {r4, r5, lr}"), m4("sdiv r0, r1, r2")],
            [14, 4, 12]
        );
        assert_eq!(
            [m4("pop {r4-r7, pc}"), m4("bic r0, r0, #1"), m4("vldm r0!, {s0-s3}")],
            [9, 1, 9]
        );
    }
}
