//! The prelude that was forgotten.

#[component]
#[derive(Default)]
pub struct ForgottenImport {
    pub last: f64,
}

#[component]
impl ForgottenImport {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = x;
        self.last
    }
}
