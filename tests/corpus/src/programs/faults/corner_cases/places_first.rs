//! A place that an earlier operand names is there, or is not, before a later operand faults, returns or writes.
//!
//! Each function has a way to pass a place on, and a row for each kind of place; what comes behind it faults in each way.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cell {
    pub b: u8,
    pub c: [u8; 3],
    pub o: Option<u8>,
}

#[data]
impl Cell {
    fn add(&mut self, n: u8) -> u8 {
        self.b = self.b.wrapping_add(n);
        self.b
    }

    fn sum(&self, n: u8) -> u8 {
        self.b.wrapping_mul(3).wrapping_add(n)
    }
}

#[data]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Places {
    pub a: [u8; 4],
    pub rows: [[u8; 3]; 2],
    pub cells: [Cell; 2],
    pub list: List<u8, 3>,
    pub options: [Option<u8>; 2],
    pub m: SMatrix<f64, 2, 3>,
}

#[function]
fn taken(x: &u8, y: u8) -> u8 {
    x.wrapping_mul(5).wrapping_add(y)
}

#[function]
fn changed(x: &mut u8, y: u8) -> u8 {
    *x = x.wrapping_add(y);
    *x
}

#[function]
fn both(x: u8, y: u8) -> u8 {
    x.wrapping_mul(7).wrapping_add(y)
}

#[function]
fn weighed(x: &f64, y: u8) -> f64 {
    x * 2.0 + f64::from(y)
}

#[function]
fn counted(n: &mut u8, d: u8) -> u8 {
    *n = n.wrapping_add(1);
    *n / d
}

#[function]
fn known(n: u8) -> Option<u8> {
    if n > 200 {
        return None;
    }
    Some(n)
}

/// Behind a place, an assertion.
#[function]
pub fn asserted(places: &mut Places, which: u8, i: usize, j: usize, n: u8, d: u8) -> u8 {
    let r = match which % 16 {
        0 => taken(&places.a[i], { assert!(n < 100); n }),
        1 => taken(&places.rows[i][j], { assert!(n < 100); n }),
        2 => taken(&places.cells[i].c[j], { assert!(n < 100); n }),
        3 => taken(&places.list[i], { assert!(n < 100); n }),
        4 => changed(&mut places.a[i], { assert!(n < 100); n }),
        5 => changed(&mut places.rows[i][j], { assert!(n < 100); n }),
        6 => changed(&mut places.cells[i].b, { assert!(n < 100); n }),
        7 => changed(&mut places.list[i], { assert!(n < 100); n }),
        8 => places.cells[i].add({ assert!(n < 100); n }),
        9 => places.cells[i].sum({ assert!(n < 100); n }),
        10 => weighed(&places.m[(i, j)], { assert!(n < 100); n }) as u8,
        11 => both(places.a[i], { assert!(n < 100); n }),
        12 => places.rows[i][usize::from({ assert!(n < 100); n })],
        13 => core::mem::replace(&mut places.a[i], { assert!(n < 100); n }),
        14 => places.options[i].replace({ assert!(n < 100); n }).unwrap_or(3),
        _ => { places.rows[i][usize::from({ assert!(n < 100); n })] += 1; places.a[0] }
    };
    r.wrapping_add(n)
}

/// Behind a place, a statement that may fault.
#[function]
pub fn divided(places: &mut Places, which: u8, i: usize, j: usize, mut n: u8, d: u8) -> u8 {
    let r = match which % 16 {
        0 => taken(&places.a[i], { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        1 => taken(&places.rows[i][j], { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        2 => taken(&places.cells[i].c[j], { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        3 => taken(&places.list[i], { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        4 => changed(&mut places.a[i], { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        5 => changed(&mut places.rows[i][j], { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        6 => changed(&mut places.cells[i].b, { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        7 => changed(&mut places.list[i], { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        8 => places.cells[i].add({ let quotient = n / d; n = n.wrapping_add(1); quotient }),
        9 => places.cells[i].sum({ let quotient = n / d; n = n.wrapping_add(1); quotient }),
        10 => weighed(&places.m[(i, j)], { let quotient = n / d; n = n.wrapping_add(1); quotient }) as u8,
        11 => both(places.a[i], { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        12 => places.rows[i][usize::from({ let quotient = n / d; n = n.wrapping_add(1); quotient })],
        13 => core::mem::replace(&mut places.a[i], { let quotient = n / d; n = n.wrapping_add(1); quotient }),
        14 => places.options[i].replace({ let quotient = n / d; n = n.wrapping_add(1); quotient }).unwrap_or(3),
        _ => { places.rows[i][usize::from({ let quotient = n / d; n = n.wrapping_add(1); quotient })] += 1; places.a[0] }
    };
    r.wrapping_add(n)
}

/// Behind a place, a call that may fault.
#[function]
pub fn called(places: &mut Places, which: u8, i: usize, j: usize, mut n: u8, d: u8) -> u8 {
    let r = match which % 16 {
        0 => taken(&places.a[i], counted(&mut n, d)),
        1 => taken(&places.rows[i][j], counted(&mut n, d)),
        2 => taken(&places.cells[i].c[j], counted(&mut n, d)),
        3 => taken(&places.list[i], counted(&mut n, d)),
        4 => changed(&mut places.a[i], counted(&mut n, d)),
        5 => changed(&mut places.rows[i][j], counted(&mut n, d)),
        6 => changed(&mut places.cells[i].b, counted(&mut n, d)),
        7 => changed(&mut places.list[i], counted(&mut n, d)),
        8 => places.cells[i].add(counted(&mut n, d)),
        9 => places.cells[i].sum(counted(&mut n, d)),
        10 => weighed(&places.m[(i, j)], counted(&mut n, d)) as u8,
        11 => both(places.a[i], counted(&mut n, d)),
        12 => places.rows[i][usize::from(counted(&mut n, d))],
        13 => core::mem::replace(&mut places.a[i], counted(&mut n, d)),
        14 => places.options[i].replace(counted(&mut n, d)).unwrap_or(3),
        _ => { places.rows[i][usize::from(counted(&mut n, d))] += 1; places.a[0] }
    };
    r.wrapping_add(n)
}

/// Behind a place, what may not be there.
#[function]
pub fn unwrapped(places: &mut Places, which: u8, i: usize, j: usize, n: u8, d: u8) -> u8 {
    let r = match which % 16 {
        0 => taken(&places.a[i], known(n).unwrap()),
        1 => taken(&places.rows[i][j], known(n).unwrap()),
        2 => taken(&places.cells[i].c[j], known(n).unwrap()),
        3 => taken(&places.list[i], known(n).unwrap()),
        4 => changed(&mut places.a[i], known(n).unwrap()),
        5 => changed(&mut places.rows[i][j], known(n).unwrap()),
        6 => changed(&mut places.cells[i].b, known(n).unwrap()),
        7 => changed(&mut places.list[i], known(n).unwrap()),
        8 => places.cells[i].add(known(n).unwrap()),
        9 => places.cells[i].sum(known(n).unwrap()),
        10 => weighed(&places.m[(i, j)], known(n).unwrap()) as u8,
        11 => both(places.a[i], known(n).unwrap()),
        12 => places.rows[i][usize::from(known(n).unwrap())],
        13 => core::mem::replace(&mut places.a[i], known(n).unwrap()),
        14 => places.options[i].replace(known(n).unwrap()).unwrap_or(3),
        _ => { places.rows[i][usize::from(known(n).unwrap())] += 1; places.a[0] }
    };
    r.wrapping_add(n)
}

/// Behind a place, a way out.
#[function]
pub fn left(places: &mut Places, which: u8, i: usize, j: usize, n: u8, d: u8) -> u8 {
    let r = match which % 16 {
        0 => taken(&places.a[i], { if n > d { return 7; } n }),
        1 => taken(&places.rows[i][j], { if n > d { return 7; } n }),
        2 => taken(&places.cells[i].c[j], { if n > d { return 7; } n }),
        3 => taken(&places.list[i], { if n > d { return 7; } n }),
        4 => changed(&mut places.a[i], { if n > d { return 7; } n }),
        5 => changed(&mut places.rows[i][j], { if n > d { return 7; } n }),
        6 => changed(&mut places.cells[i].b, { if n > d { return 7; } n }),
        7 => changed(&mut places.list[i], { if n > d { return 7; } n }),
        8 => places.cells[i].add({ if n > d { return 7; } n }),
        9 => places.cells[i].sum({ if n > d { return 7; } n }),
        10 => weighed(&places.m[(i, j)], { if n > d { return 7; } n }) as u8,
        11 => both(places.a[i], { if n > d { return 7; } n }),
        12 => places.rows[i][usize::from({ if n > d { return 7; } n })],
        13 => core::mem::replace(&mut places.a[i], { if n > d { return 7; } n }),
        14 => places.options[i].replace({ if n > d { return 7; } n }).unwrap_or(3),
        _ => { places.rows[i][usize::from({ if n > d { return 7; } n })] += 1; places.a[0] }
    };
    r.wrapping_add(n)
}

/// Behind a place, a sum that may overflow.
#[function]
pub fn gathered(places: &mut Places, which: u8, i: usize, j: usize, n: u8, d: u8) -> u8 {
    let r = match which % 16 {
        0 => taken(&places.a[i], [n, d].iter().map(|x| x + 3).sum::<u8>()),
        1 => taken(&places.rows[i][j], [n, d].iter().map(|x| x + 3).sum::<u8>()),
        2 => taken(&places.cells[i].c[j], [n, d].iter().map(|x| x + 3).sum::<u8>()),
        3 => taken(&places.list[i], [n, d].iter().map(|x| x + 3).sum::<u8>()),
        4 => changed(&mut places.a[i], [n, d].iter().map(|x| x + 3).sum::<u8>()),
        5 => changed(&mut places.rows[i][j], [n, d].iter().map(|x| x + 3).sum::<u8>()),
        6 => changed(&mut places.cells[i].b, [n, d].iter().map(|x| x + 3).sum::<u8>()),
        7 => changed(&mut places.list[i], [n, d].iter().map(|x| x + 3).sum::<u8>()),
        8 => places.cells[i].add([n, d].iter().map(|x| x + 3).sum::<u8>()),
        9 => places.cells[i].sum([n, d].iter().map(|x| x + 3).sum::<u8>()),
        10 => weighed(&places.m[(i, j)], [n, d].iter().map(|x| x + 3).sum::<u8>()) as u8,
        11 => both(places.a[i], [n, d].iter().map(|x| x + 3).sum::<u8>()),
        12 => places.rows[i][usize::from([n, d].iter().map(|x| x + 3).sum::<u8>())],
        13 => core::mem::replace(&mut places.a[i], [n, d].iter().map(|x| x + 3).sum::<u8>()),
        14 => places.options[i].replace([n, d].iter().map(|x| x + 3).sum::<u8>()).unwrap_or(3),
        _ => { places.rows[i][usize::from([n, d].iter().map(|x| x + 3).sum::<u8>())] += 1; places.a[0] }
    };
    r.wrapping_add(n)
}

/// Values beside a place, in a tuple, an array, a struct, a comparison and an operation.
#[function]
pub fn values(places: &Places, which: u8, i: usize, n: u8, d: u8) -> u8 {
    match which % 8 {
        0 => {
            let (x, y) = (places.a[i], {
                assert!(n < 100);
                n
            });
            x ^ y
        }
        1 => {
            let [x, y] = [places.a[i], known(n).unwrap()];
            x ^ y
        }
        2 => {
            let cell = Cell { c: [places.a[i], 1, 2], b: known(n).unwrap(), o: None };
            cell.sum(d)
        }
        3 => u8::from(places.a[i] < known(n).unwrap()),
        4 => places.a[i].wrapping_add(known(n).unwrap()),
        5 => places.a[i].max(known(n).unwrap()),
        6 => match (places.cells[i], known(n).unwrap()) {
            (Cell { b: 3, .. }, _) => 1,
            (_, 4) => 2,
            _ => 3,
        },
        _ => places.options[i].unwrap_or(n / d),
    }
}

/// References to a place: named, matched, and in a closure's arguments.
#[function]
pub fn references(places: &mut Places, which: u8, i: usize, j: usize, n: u8, d: u8) -> u8 {
    let sum = |x: &u8, y: u8| x.wrapping_add(y);
    match which % 6 {
        0 => {
            let x = &mut places.cells[i].c[j];
            *x = n / d;
            *x
        }
        1 => sum(&places.a[i], known(n).unwrap()),
        2 => {
            let (x, y) = (&mut places.rows[i][j], known(n).unwrap());
            *x = y;
            y
        }
        3 => {
            let cell = &places.cells[i];
            cell.sum(known(n).unwrap())
        }
        4 => match (&places.cells[i].c[j], known(n).unwrap()) {
            (0, y) => y,
            (x, y) => x ^ y,
        },
        _ => {
            let row = &places.rows[i];
            taken(&row[j], known(n).unwrap())
        }
    }
}
