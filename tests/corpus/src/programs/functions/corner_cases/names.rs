//! Names that C, its library or the emitted code has other plans for; comments that C would misread.

use bessemer::prelude::*;

/// A type whose C name is POSIX's. Ends like this: */ and then this /* and ??/
/// a backslash at the end \
/// and one in "quotes".
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Time {
    /// `*/ int x; /*` is no way out.
    pub int: f64,
    pub long: f64,
    pub self_: f64,
    pub r#in: f64,
    pub NAN: f64,
    pub fault: f64,
    pub unix: f64,
    pub Mixed: f64,
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Div {
    pub quot: i32,
    pub rem: i32,
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Names {
    pub register: f64,
    pub fault: u8,
    pub status: u8,
    pub next: Div,
}

#[function]
fn floor(x: f64) -> f64 {
    x.floor() + 1.0
}

#[function]
fn div(a: i32, b: i32) -> Div {
    Div { quot: a / b, rem: a % b }
}

#[function]
fn main(a: i32) -> i32 {
    a ^ 1
}

#[function]
fn init(a: i32) -> i32 {
    a ^ 2
}

#[function]
fn min_f64(a: f64, b: f64) -> f64 {
    a.min(b).max(a.abs().sqrt())
}

#[function]
fn été(naïve: f64) -> f64 {
    let größe = naïve + 1.0;
    größe
}

const I: i32 = 3;
const NULL: f64 = 2.5;
const EOF: u8 = 7;
const π: f64 = 3.0;
/// A comment *\/ that ends early: */
const OVERFLOW: [i32; 2] = [1, 2];

#[component]
impl Names {
    /// A comment that ends early */ or goes on \
    #[entry]
    pub fn step(&mut self, time: Time, double: f64, status: i32, errno: i32, result: u8) -> Time {
        // A line comment with */ and ??/ in it \
        let int = time.int + double;
        let float = int.sin() + floor(int);
        let sin = float.min(NULL).max(double);
        let sqrt = sin.abs().sqrt();
        let bool = sqrt > 1.0;
        let NAN = if bool { sqrt } else { float };
        let signbit = NAN.max(double).copysign(double);
        let memcpy = [signbit, NAN, min_f64(sin, sqrt)];
        let mut memmove = memcpy;
        memmove[1] = memcpy[(errno & 1) as usize];
        let div = div(status, errno);
        self.next = div;
        let uint8_t = result as u32;
        let main = main(errno) + init(status) + I + OVERFLOW[1];
        let mut names_step = main.wrapping_add(uint8_t as i32);
        names_step = names_step.wrapping_mul(2);
        let time_t = Time {
            int,
            long: float,
            self_: sqrt,
            r#in: memmove[1],
            NAN,
            fault: été(π),
            unix: signbit,
            Mixed: names_step as f64,
        };
        let names_t = time_t;
        let linux = names_t;
        self.fault = EOF;
        self.status = self.fault + result;
        self.register += linux.r#in;
        linux
    }

    /// All of C's and C++'s words.
    #[entry]
    pub fn words(&mut self, auto: i32, case: i32, class: i32, template: i32) -> i32 {
        let asm = auto + case;
        let default = class + template;
        let goto = asm ^ default;
        let inline = goto + 1;
        let operator = inline - 1;
        let restrict = operator;
        let sizeof = restrict;
        let stdin = sizeof;
        let switch = stdin;
        let typedef = switch;
        let void = typedef;
        let volatile = void;
        let xor = volatile;
        let DEBUG = xor;
        let ok = DEBUG;
        let UINT8_MAX = ok;
        let INT32_MAX = UINT8_MAX;
        let INT32_C = INT32_MAX;
        let UINT64_C = INT32_C;
        let __LINE__ = UINT64_C;
        let _Bool = __LINE__;
        let _t = _Bool;
        let arm = _t;
        let i386 = arm;
        let CHAR_BIT = i386;
        let M_PI = CHAR_BIT;
        let PRIu32 = M_PI;
        let isless = PRIu32;
        let BESSEMER_STATUS_OK = isless;
        let bessemer_status_t = BESSEMER_STATUS_OK;
        let value = bessemer_status_t / case;
        self.status = (value & 0x7f) as u8;
        value
    }

    /// No result, and one that is named as an argument of the C would be.
    #[entry]
    pub fn set(&mut self, n: u8) {
        self.status = 200 + n;
    }

    #[entry]
    pub fn flag(&self, a: i64) -> bool {
        1000 / a > 7
    }
}
