// Checks that always fail: nothing follows them in the C, where compilers warned of the operation. `2 ^ 6` of two
// literals has its base in hexadecimal: compilers took it for a power.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FoundChecksThatAlwaysFailTurn {
    #[default]
    Idle,
    Turn { low: i64 },
}
#[function]
pub fn found_checks_that_always_fail_0(code: i16) -> FoundChecksThatAlwaysFailTurn {
    FoundChecksThatAlwaysFailTurn::Turn { low: 3_i64 * i64::MIN }
}
#[function]
pub fn found_checks_that_always_fail_1(code: i64, t: &mut i64) -> i64 {
    *t = code;
    let a = code.wrapping_add(1);
    let b = 3_i64 * i64::MIN;
    *t += a;
    b + a
}
#[function]
pub fn found_checks_that_always_fail_2(code: i64, t: &mut i64) -> i64 {
    if code > 3 {
        *t += 3_i64 * i64::MIN;
    } else {
        *t = 7;
    }
    t.wrapping_add(1)
}
#[function]
pub fn found_checks_that_always_fail_3(code: u8, t: &mut u8) {
    if code > 3 {
        *t = 200_u8 + 100;
    } else {
        *t = code;
        *t = 200_u8 * 2;
    }
}
#[function]
pub fn found_checks_that_always_fail_4(code: u16) -> [u32; 4] {
    [u32::from((2_u16 ^ 6).min(code)), 10_u32 ^ 3, (10_i32 ^ 3) as u32, (2_i64 ^ 5) as u32]
}
