//! A field of another module's component.
use bessemer::prelude::*;

mod inner {
    use bessemer::prelude::*;

    #[data]
    #[derive(Clone, Copy, Default)]
    pub struct Hidden {
        secret: f64,
    }
}

#[component]
#[derive(Default)]
pub struct PrivateField {
    pub hidden: inner::Hidden,
}

#[component]
impl PrivateField {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.hidden.secret * x
    }
}
