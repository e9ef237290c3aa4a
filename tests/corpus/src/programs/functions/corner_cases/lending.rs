//! Functions that return references: when their arguments are evaluated and checked, and what is written through
//! them.

use core::ops::{Index, IndexMut};

use bessemer::prelude::*;

/// A pair of numbers.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    x: f64,
    n: u8,
}

#[data]
impl Cell {
    fn n_mut(&mut self) -> &mut u8 {
        &mut self.n
    }
}

/// A large store.
#[data]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Store {
    cells: [Cell; 3],
    rows: [[f64; 2]; 2],
    matrix: Matrix2<f64>,
    list: List<u8, 4>,
    last: Option<f64>,
    at: u8,
}

#[data]
impl Store {
    fn cell(&self, i: usize) -> &Cell {
        &self.cells[i]
    }

    fn cell_mut(&mut self, i: usize) -> &mut Cell {
        &mut self.cells[i]
    }

    /// Counts the call, then returns a reference to the next cell.
    fn next(&mut self) -> &mut Cell {
        self.at += 1;
        let i = usize::from(self.at % 4);
        self.cell_mut(i)
    }

    fn line(&self, i: usize) -> &[f64; 2] {
        &self.rows[i]
    }

    fn line_mut(&mut self, i: usize) -> &mut [f64; 2] {
        &mut self.rows[i]
    }

    fn whole(&self) -> &Matrix2<f64> {
        &self.matrix
    }

    fn whole_mut(&mut self) -> &mut Matrix2<f64> {
        &mut self.matrix
    }

    fn items(&self) -> &List<u8, 4> {
        &self.list
    }

    fn items_mut(&mut self) -> &mut List<u8, 4> {
        &mut self.list
    }

    fn newest(&self) -> &u8 {
        self.list.last().unwrap()
    }

    fn last_mut(&mut self) -> &mut Option<f64> {
        &mut self.last
    }

    fn held_mut(&mut self) -> &mut f64 {
        self.last.as_mut().unwrap()
    }
}

#[data]
impl Index<usize> for Store {
    type Output = u8;

    fn index(&self, i: usize) -> &u8 {
        &self.list[i]
    }
}

#[data]
impl Index<(usize, usize)> for Store {
    type Output = f64;

    fn index(&self, pair: (usize, usize)) -> &f64 {
        let (row, column) = pair;
        assert!(pair.0 < 5);
        &self.rows[row][column]
    }
}

#[data]
impl IndexMut<(usize, usize)> for Store {
    fn index_mut(&mut self, pair: (usize, usize)) -> &mut f64 {
        let (row, column) = pair;
        assert!(pair.0 < 5);
        &mut self.rows[row][column]
    }
}

/// The index is evaluated at the call; later changes of the variable do not matter.
#[function]
pub fn fixed(store: &mut Store, start: usize) -> f64 {
    let mut i = start % 4;
    let cell = store.cell(i);
    i += 1;
    let sum = cell.x + store.cell(i % 4).x;
    let before = store.cell(1).x + store.next().x;
    *store.cell_mut({ i += 1; i % 3 }) = Cell { x: sum, ..*store.cell(i % 3) };
    store.cell_mut(i % 3).x += before * f64::from(store.at);
    *store.next().n_mut() ^= 3;
    sum + f64::from(i as u32)
}

/// The index is checked, even if nothing reads the reference.
#[function]
pub fn unread(store: &mut Store, i: usize) -> u8 {
    let _ = store.cell(i);
    let _kept = store.cell(i % 4);
    store.next();
    store.at
}

/// A reference to a struct whose fields are used.
#[function]
pub fn parts(store: &mut Store, i: usize) -> f64 {
    let mut sum = 0.0;
    for x in store.line(i) {
        sum += x;
    }
    for x in store.line_mut(1) {
        *x += 1.0;
    }
    sum += store.line(i).iter().map(|x| x * 2.0).sum::<f64>() + store.line(0)[1];
    store.line_mut(i)[0] = sum;
    let v = store.whole() * Vector2::new(1.0, 2.0);
    store.whole_mut()[(0, 1)] = v.x;
    *store.whole_mut() *= 2.0;
    sum + store.whole()[(1, 1)] + store.whole().trace()
}

/// References into lists and options.
#[function]
pub fn held(store: &mut Store, n: u8) -> u32 {
    store.items_mut().push(n);
    let sum = store.items().iter().map(|x| u32::from(*x)).sum::<u32>();
    match store.last_mut() {
        Some(x) => *x += 1.0,
        None => *store.last_mut() = Some(f64::from(*store.newest())),
    }
    *store.held_mut() *= 3.0;
    if let Some(x) = store.last_mut() {
        *x -= 1.0;
    }
    sum + u32::from(store[0]) + store.items().len() as u32
}

/// Two implementations of `Index`, selected by the type of the index.
#[function]
pub fn indexed(store: &mut Store, i: usize, j: usize) -> f64 {
    let place = (i % 6, j % 3);
    store[place] += 1.0;
    store[(1, j)] = store[(i, 0)] * 2.0;
    store[(0, 1)] + f64::from(store[j])
}

/// References in conditions, loops and closures.
#[function]
pub fn asked(store: &Store, i: usize) -> f64 {
    if store.cell(0).n > 3 && store.cell(i).x > 0.0 {
        return store.cell(i).x;
    }
    let mut k = 0;
    #[bound(5)]
    while store.cell(k % 3).x > 2.0 {
        k += 1;
    }
    let found = (0..3).map(|k| store.cell(k)).filter(|cell| cell.n > 1).map(|cell| cell.x).fold(0.0, |a, b| a - b);
    match store.cell(k) {
        Cell { n: 0, x } => *x,
        cell => found + cell.x,
    }
}

/// A ring buffer of the last values.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ring {
    values: [f32; 4],
    next: u8,
}

/// A trait with methods for all rings.
#[interface]
pub trait Recent {
    fn back(&self, n: usize) -> &f32;
    fn newest(&self) -> &f32 {
        self.back(0)
    }
    fn put(&mut self) -> &mut f32;
}

#[data]
impl Recent for Ring {
    fn back(&self, n: usize) -> &f32 {
        let at = (usize::from(self.next) + 3 - n) % 4;
        &self.values[at]
    }

    fn put(&mut self) -> &mut f32 {
        let at = usize::from(self.next % 4);
        self.next = self.next.wrapping_add(1);
        &mut self.values[at]
    }
}

#[function]
fn fed<R: Recent>(ring: &mut R, x: f32) -> f32 {
    *ring.put() = x;
    *ring.put() = ring.newest() + ring.back(1);
    *ring.newest()
}

/// References returned through a trait.
#[function]
pub fn recent(ring: &mut Ring, x: f32, n: usize) -> f32 {
    fed(ring, x) - ring.back(n % 5)
}

/// Values with keys.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slots {
    keys: [u8; 4],
    values: [f64; 4],
}

#[data]
impl Slots {
    /// Searches a key, then returns a reference to its value.
    fn of_mut(&mut self, key: u8) -> &mut f64 {
        let mut at = 0;
        for i in 0..4 {
            if self.keys[i] == key {
                at = i;
                break;
            }
        }
        &mut self.values[at]
    }

    /// Changes its own copy of the parameter before it returns a reference.
    fn later(&mut self, mut i: usize) -> &mut f64 {
        i += 1;
        &mut self.values[i]
    }
}

/// References to a whole value, and unused copies.
#[function]
pub fn copied(slots: &mut Slots, key: u8, i: usize) -> f64 {
    *slots.of_mut(key) += 1.0;
    *slots.later(i) = 2.0;
    *slots.clone().of_mut(3) = 5.0;
    let mut other = *slots;
    *other.of_mut(1) = 7.0;
    slots.values[0] + other.values[0] + *slots.clone().later(0) + i as f64
}
