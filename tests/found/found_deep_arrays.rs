// Arrays in arrays, more deeply than counters have letters: each loop that sets the first state has a counter of its own.
/// Cells in eight dimensions.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct FoundDeepArraysUnit {
    /// The cells.
    pub cells: [[[[[[[[u8; 5]; 1]; 2]; 1]; 2]; 1]; 2]; 5],
}

impl Default for FoundDeepArraysUnit {
    fn default() -> FoundDeepArraysUnit {
        FoundDeepArraysUnit { cells: [[[[[[[[7; 5]; 1]; 2]; 1]; 2]; 1]; 2]; 5] }
    }
}

#[component]
impl FoundDeepArraysUnit {
    /// A cell, which becomes another.
    #[entry]
    pub fn found_deep_arrays_exchange(&mut self, at: u8, within: u8, new: u8) -> u8 {
        let (at, within) = (at as usize, within as usize);
        let old = self.cells[at % 5][at % 2][0][within / 2 % 2][0][1][0][within];
        self.cells[at % 5][at % 2][0][within / 2 % 2][0][1][0][within] = new;
        old
    }
}
