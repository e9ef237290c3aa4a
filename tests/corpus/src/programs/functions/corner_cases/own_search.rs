//! An author's methods with the names of those of slices and lists.

use bessemer::prelude::*;

/// A table of steps that remembers where the last search ended.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Steps {
    pub at: [i32; 5],
    pub hint: u32,
}

#[data]
impl Steps {
    /// The index of a step, counted from the end.
    pub fn binary_search(&self, wanted: i32) -> Option<u32> {
        let mut found = None;
        for i in 0..5 {
            if self.at[i] == wanted {
                found = Some(i as u32);
            }
        }
        found
    }

    /// Number of steps above a limit.
    pub fn partition_point(&self, above: i32) -> u32 {
        let mut count = 0;
        for step in self.at {
            if step > above {
                count += 1;
            }
        }
        count
    }

    /// Raises all steps to at least a limit.
    pub fn retain(&mut self, least: i32) {
        for step in &mut self.at {
            *step = (*step).max(least);
        }
    }

    /// Applies a closure to each step.
    pub fn apply(&mut self, f: impl Fn(i32) -> i32) {
        for step in &mut self.at {
            *step = f(*step);
        }
    }
}

/// Calls the author's methods.
#[function]
pub fn search_steps(steps: &mut Steps, wanted: i32) -> u32 {
    steps.retain(wanted.max(-100));
    let above = steps.partition_point(wanted);
    match steps.binary_search(wanted) {
        Some(at) => at,
        None => above + 10,
    }
}

/// Searches in slices and lists with closures that read other slices.
#[function]
pub fn search_elements(values: &[i32; 6], marks: &[i32], list: &mut List<i32, 6>) -> usize {
    let marked = &marks[..marks.len().min(3)];
    list.retain(|x| !marked.contains(x));
    values.partition_point(|x| *x < 7) + list.len()
}
