//! Items of a `flat_map` taken one by one, whose closure counts.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FlatMapThatWrites {
    pub rows: [[f32; 3]; 4],
    pub count: u32,
}

#[component]
impl FlatMapThatWrites {
    #[entry]
    pub fn step(&mut self, x: f32) -> f32 {
        let mut count = self.count;
        let mut cells = self.rows.iter().flat_map(|row| {
            count = count.wrapping_add(1);
            row.iter()
        });
        let first = cells.next().map_or(x, |cell| *cell);
        let second = cells.next().map_or(x, |cell| *cell);
        self.count = count;
        first + second
    }
}
