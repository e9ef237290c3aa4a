//! Fields of a register by a macro.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy)]
pub struct Control(pub u16);

macro_rules! bits {
    ($name:ident, $method:ident, $mask:expr) => {
        impl $name {
            pub fn $method(&self) -> u16 {
                self.0 & $mask
            }
        }
    };
}

bits!(Control, low, 0x0F);

#[component]
#[derive(Default)]
pub struct MacroMethods {
    pub last: u16,
}

#[component]
impl MacroMethods {
    #[entry]
    pub fn step(&mut self, x: u16) -> u16 {
        self.last = Control(x).low();
        self.last
    }
}
