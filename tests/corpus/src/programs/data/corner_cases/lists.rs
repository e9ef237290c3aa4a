//! Lists of numbers, structs and lists: pushed, popped, indexed, truncated, iterated over, compared, copied.

use bessemer::prelude::*;

/// A mark on a route.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mark {
    pub at: f32,
    pub notes: List<u8, 3>,
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stacks {
    pub numbers: List<i16, 5>,
    pub marks: List<Mark, 3>,
    pub rows: [List<u8, 2>; 2],
    pub spare: Option<List<u8, 2>>,
}

#[function]
fn doubled(list: &mut List<i16, 5>, by: i16) -> i16 {
    for x in list.iter_mut() {
        *x = x.wrapping_mul(2);
    }
    list.push(by);
    by.wrapping_add(1)
}

#[function]
fn total(list: List<u8, 2>) -> u8 {
    let mut sum = 0u8;
    for (i, x) in list.iter().enumerate() {
        sum = sum.wrapping_add(*x).wrapping_add(i as u8);
    }
    sum
}

#[component]
impl Stacks {
    #[entry]
    pub fn pushed(&mut self, x: i16) -> usize {
        let next = doubled(&mut self.numbers, x);
        if self.numbers.len() < self.numbers.capacity() {
            self.numbers.push(next);
        }
        self.numbers.len()
    }

    #[entry(infallible)]
    pub fn pushed_where_there_is_room(&mut self, x: i16) -> bool {
        if !self.numbers.is_full() {
            self.numbers.push(x);
        }
        self.numbers.is_full() || self.rows.iter().any(|row| row.is_full())
    }

    #[entry]
    pub fn indexed(&mut self, i: usize, j: usize) -> i16 {
        self.numbers[i] += self.numbers[j];
        let row = self.rows[j];
        self.marks[i].notes = List::new();
        self.marks[i].notes.push(total(row));
        self.numbers[j]
    }

    #[entry(infallible)]
    pub fn popped(&mut self) -> (Option<i16>, Option<Mark>, u8) {
        let number = self.numbers.pop();
        let mark = self.marks.pop();
        self.rows[1].pop();
        let taken = if let Some(mut list) = self.spare { list.pop().unwrap_or(9) } else { 0 };
        (number, mark, taken)
    }

    #[entry]
    pub fn sized(&mut self, n: usize, x: u8) -> List<u8, 2> {
        let before = self.rows[0];
        self.rows[0].resize(n, x);
        self.rows[1].truncate(n);
        if x == 0 {
            self.rows[1].clear();
        }
        self.spare = Some(before);
        self.rows[0]
    }

    #[entry(infallible)]
    pub fn same(&self, rows: &[List<u8, 2>; 2], mark: Mark) -> (bool, bool, bool) {
        let mut found = false;
        for own in &self.marks {
            if *own == mark {
                found = true;
            }
        }
        (rows[0] == rows[1], *rows == self.rows, found)
    }

    #[entry]
    pub fn sorted(&mut self) -> i16 {
        for i in 1..self.numbers.len() {
            let mut j = i;
            #[bound(5)]
            while j > 0 && self.numbers[j - 1] > self.numbers[j] {
                let high = self.numbers[j - 1];
                self.numbers[j - 1] = self.numbers[j];
                self.numbers[j] = high;
                j -= 1;
            }
        }
        if self.numbers.is_empty() { 0 } else { self.numbers[self.numbers.len() / 2] }
    }
}
