//! Methods of an author's own that have the names of a slice's or a list's.

use bessemer::prelude::*;

/// A table of steps with a hint where the last search ended.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Steps {
    pub at: [i32; 5],
    pub hint: u32,
}

#[data]
impl Steps {
    /// The place of a step, from the back.
    pub fn binary_search(&self, wanted: i32) -> Option<u32> {
        let mut found = None;
        for i in 0..5 {
            if self.at[i] == wanted {
                found = Some(i as u32);
            }
        }
        found
    }

    /// Number of steps above a number.
    pub fn partition_point(&self, above: i32) -> u32 {
        let mut count = 0;
        for step in self.at {
            if step > above {
                count += 1;
            }
        }
        count
    }

    /// Sets what is below a number to it.
    pub fn retain(&mut self, least: i32) {
        for step in &mut self.at {
            *step = (*step).max(least);
        }
    }

    /// Moves every step that a closure names.
    pub fn apply(&mut self, f: impl Fn(i32) -> i32) {
        for step in &mut self.at {
            *step = f(*step);
        }
    }
}

/// Calls each of them.
#[function]
pub fn search_steps(steps: &mut Steps, wanted: i32) -> u32 {
    steps.retain(wanted.max(-100));
    let above = steps.partition_point(wanted);
    match steps.binary_search(wanted) {
        Some(at) => at,
        None => above + 10,
    }
}

/// Searches in slices and lists, whose closures read other slices.
#[function]
pub fn search_elements(values: &[i32; 6], marks: &[i32], list: &mut List<i32, 6>) -> usize {
    let marked = &marks[..marks.len().min(3)];
    list.retain(|x| !marked.contains(x));
    values.partition_point(|x| *x < 7) + list.len()
}
