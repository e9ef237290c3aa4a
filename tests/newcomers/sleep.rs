//! A pause.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct Sleep {
    pub last: f64,
}

#[component]
impl Sleep {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        std::thread::sleep(std::time::Duration::from_millis(10));
        self.last = x;
        self.last
    }
}
