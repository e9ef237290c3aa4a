//! Registers that a macro declares.
use bessemer::prelude::*;

macro_rules! register {
    ($name:ident) => {
        #[derive(Clone, Copy)]
        pub struct $name(pub u16);
    };
}

register!(Status);

#[component]
#[derive(Default)]
pub struct MacroRegister {
    pub last: u16,
}

#[component]
impl MacroRegister {
    #[entry]
    pub fn step(&mut self, x: u16) -> u16 {
        self.last = Status(x).0;
        self.last
    }
}
