//! Two types that C cannot tell apart.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Default)]
#[c(name = "raw_header_t")]
pub struct HTTPHeader {
    pub length: u16,
}

#[data]
#[derive(Clone, Copy, Default)]
pub struct HttpHeader {
    pub length: u16,
}

#[component]
#[derive(Default)]
pub struct Clashing {
    pub one: HTTPHeader,
    pub other: HttpHeader,
}

#[component]
impl Clashing {
    #[entry]
    pub fn step(&mut self) -> u16 {
        self.one.length
    }
}
