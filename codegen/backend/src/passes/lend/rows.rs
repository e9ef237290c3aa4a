//! Layout of temporaries in rows: elements of one type form a row, and each temporary has a part of one.
//!
//! Invariant: two temporaries that are alive together share no element.

use super::lives::Life;
use super::row::Row;

/// Location of a temporary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Laid {
    /// Index of the row.
    pub row: usize,
    /// Number of elements before it.
    pub offset: u32,
}

/// Returns rows with few elements, found by a greedy rule, and the location of each temporary.
pub(super) fn lay(lives: &[Life]) -> (Vec<Row>, Vec<Laid>) {
    let mut rows: Vec<Row> = Vec::new();
    let mut laid = vec![Laid { row: 0, offset: 0 }; lives.len()];
    for life in lives {
        if rows.iter().all(|row| row.element != life.row.element) {
            rows.push(Row { element: life.row.element.clone(), len: 0 });
        }
    }
    for (index, row) in rows.iter_mut().enumerate() {
        let own: Vec<usize> =
            (0..lives.len()).filter(|at| lives[*at].row.element == row.element).collect();
        let mut by_length = own.clone();
        by_length.sort_by_key(|at| std::cmp::Reverse(lives[*at].row.len));
        // In the order in which they stand, unless it takes less to begin with the largest.
        let (standing, largest) = (first_fit(lives, &own), first_fit(lives, &by_length));
        let (order, (offsets, len)) =
            if largest.1 < standing.1 { (by_length, largest) } else { (own, standing) };
        row.len = len;
        for (at, offset) in order.into_iter().zip(offsets) {
            laid[at] = Laid { row: index, offset };
        }
    }
    (rows, laid)
}

/// Places each temporary as near to the beginning as the placed ones allow; returns the offsets and the total length.
fn first_fit(lives: &[Life], order: &[usize]) -> (Vec<u32>, u32) {
    let mut offsets: Vec<u32> = Vec::new();
    let mut all = 0;
    for (done, at) in order.iter().enumerate() {
        let life = &lives[*at];
        let mut taken: Vec<(u32, u32)> = (order[..done].iter().zip(&offsets))
            .filter(|(other, _)| lives[**other].meets(life))
            .map(|(other, offset)| (*offset, offset + lives[*other].row.len))
            .collect();
        taken.sort_unstable();
        let offset = taken.iter().fold(0, |offset, (from, to)| {
            if offset + life.row.len <= *from { offset } else { offset.max(*to) }
        });
        all = all.max(offset + life.row.len);
        offsets.push(offset);
    }
    (offsets, all)
}
