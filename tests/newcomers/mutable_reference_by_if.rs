//! A mutable reference to one of two fields, chosen by an `if`.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct MutableReferenceByIf {
    pub left: u32,
    pub right: u32,
}

#[component]
impl MutableReferenceByIf {
    #[entry]
    pub fn step(&mut self, is_left: bool) {
        let count = if is_left { &mut self.left } else { &mut self.right };
        *count = count.wrapping_add(1);
    }
}
