//! A message that is put together.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct SliceThatIsAssigned {
    pub bytes: [u8; 8],
}

#[component]
impl SliceThatIsAssigned {
    #[entry]
    pub fn step(&mut self, head: [u8; 2]) -> u8 {
        self.bytes[0..2] = head;
        self.bytes[0]
    }
}
