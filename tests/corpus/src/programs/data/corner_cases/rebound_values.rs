//! A reference keeps referring to its place when the variable through which it was taken is reassigned.

#![allow(missing_docs)]

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table {
    pub x: f64,
    pub y: f64,
    pub row: [f64; 3],
}

#[data]
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    table: &'a Table,
    at: usize,
}

#[data]
impl<'a> View<'a> {
    fn of(table: &'a Table) -> View<'a> {
        View { table, at: 0 }
    }
    fn first(&self) -> &'a f64 {
        &self.table.x
    }
    fn row(&self) -> &'a [f64] {
        &self.table.row
    }
    fn turn(&mut self, to: &'a Table) -> f64 {
        let before = &self.table.y;
        let row = &self.table.row[..2];
        *self = View::of(to);
        *before + row[1]
    }
}

#[function]
pub fn turned(a: Table, b: Table) -> [f64; 6] {
    let mut v = View { table: &a, at: 1 };
    let (first, y, row, given) = (v.first(), &v.table.y, &v.table.row[1..], v.row());
    let own = &v.table.row;
    let last = v.table.row.last();
    v = View { table: &b, at: 2 };
    let sum = *first + 10.0 * *y + 100.0 * row[0] + given[2] + own[0] + last.copied().unwrap_or(1.0);
    let mut w = View::of(&a);
    let before = w.turn(&b);
    [sum, *v.first(), v.table.row[v.at], before, *w.first(), w.table.y]
}

#[function]
pub fn named(a: Table, b: Table) -> f64 {
    let mut v = View::of(&a);
    let first = v.first();
    let y = &v.table.y;
    let row = &v.table.row[1..];
    let given = v.row();
    v = View::of(&b);
    *first + 10.0 * *y + 100.0 * row[0] + given[2] + *v.first()
}

#[function]
pub fn in_loops(a: Table, b: Table) -> f64 {
    let mut sum = 0.0;
    let views = [View::of(&a), View::of(&b)];
    for mut v in views {
        let (x, y) = (v.first(), &v.table.y);
        v = View::of(&b);
        sum += *x + 10.0 * v.first() + 100.0 * *y;
    }
    for mut v in all(&[a, b, a]) {
        let y = &v.table.y;
        let row = v.row();
        v.table = &b;
        sum -= *y - 7.0 * v.table.y + row[0];
    }
    sum
}

#[function]
fn all<'a>(tables: &'a [Table]) -> impl Iterator<Item = View<'a>> {
    tables.iter().map(|table| View { table, at: 1 })
}

#[function(expand)]
fn each(tables: [Table; 2], mut f: impl FnMut(&Table) -> f64) -> f64 {
    let mut sum = 0.0;
    for table in &tables {
        sum += f(table);
    }
    sum
}

#[function]
pub fn in_closures(a: Table, b: Table) -> f64 {
    let mut v = View::of(&a);
    each([a, b], |table| {
        let x = &v.table.x;
        let row = &v.table.row;
        v = View::of(&b);
        *x + table.x + 10.0 * v.first() + row[2]
    })
}
