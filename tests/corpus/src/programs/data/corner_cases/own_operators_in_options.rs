//! Arguments of an option's method are evaluated whether they are needed or not; an author's own operator may fault.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Ratio {
    pub over: i32,
    pub under: i32,
}

#[data]
impl PartialEq for Ratio {
    fn eq(&self, other: &Ratio) -> bool {
        self.over / self.under == other.over / other.under
    }
}

#[function]
pub fn told(flag: bool, one: Ratio, other: Ratio) -> bool {
    let known = if flag { Some(true) } else { None };
    known.map_or(one == other, |known| !known)
}

#[function]
pub fn held(value: Option<i32>, one: i32, other: i32) -> bool {
    value.map_or(one < 3 && !(other == 4), |value| value > 7)
}
