//! Ends of slices and indices keep the values that they had where they were evaluated. A later end, operand or
//! statement writes the variables that they were read from.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Places {
    pub a: [u8; 4],
    pub rows: [[u8; 3]; 3],
    pub cells: [u8; 2],
    pub options: [Option<u8>; 2],
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

/// The ends of a slice keep their values, though a later end, operand or statement writes what they were read from.
#[function]
pub fn ends(values: &[u8; 6], which: u8, start: usize) -> u8 {
    let mut n = start & 3;
    let part = match which % 6 {
        0 => {
            &values[n..{
                n += 2;
                n
            }]
        }
        1 => {
            &values[n..={
                n += 1;
                n
            }]
        }
        2 => &values[n..],
        3 => &values[..n],
        4 => &values[..=n],
        _ => &values[1..][..n],
    };
    n = n.wrapping_mul(3) & 3;
    let rest = &part[n.min(part.len())..];
    n = 1;
    let sum = rest.iter().fold(part.len() as u8, |sum, x| sum.wrapping_mul(3) ^ x);
    let first = taken(
        &values[n..{
            n = 4;
            n
        }][{
            n = 2;
            n
        } - 1],
        {
            n = 0;
            values[n]
        },
    );
    sum ^ first.wrapping_mul(5) ^ n as u8
}

/// An index leads to the place that it had where it was evaluated, though it is written before the place is used.
#[function]
pub fn indices(places: &mut Places, which: u8, start: usize) -> u8 {
    let mut n = start & 1;
    let r = match which % 8 {
        0 => both(places.a[n], {
            n += 1;
            places.a[n]
        }),
        1 => taken(&places.a[n], {
            n += 1;
            places.a[n]
        }),
        2 => changed(&mut places.a[n], {
            n += 1;
            n as u8
        }),
        3 => {
            let cell = &mut places.cells[n];
            n = 1 - n;
            *cell = n as u8;
            changed(cell, 5)
        }
        4 => {
            let x = &places.rows[n][{
                n += 1;
                n
            }];
            n = 0;
            x.wrapping_add(n as u8)
        }
        5 => {
            places.a[n] = {
                n += 2;
                n as u8
            };
            n as u8
        }
        6 => {
            places.a[n] ^= {
                n = 3 - n;
                n as u8
            };
            places.a[n & 1]
        }
        _ => match &mut places.options[n] {
            Some(x) => {
                n ^= 1;
                *x ^= n as u8;
                *x
            }
            empty => {
                n ^= 1;
                *empty = Some(n as u8);
                3
            }
        },
    };
    r.wrapping_mul(3) ^ n as u8
}

/// A name in a condition is an index of a later place, which the body uses after the variable behind the name is written.
#[function]
pub fn conditions(places: &mut Places, start: usize) -> u8 {
    let mut chosen = Some(start & 1);
    if let Some(i) = chosen
        && places.a[i] > 3
        && let Some(x) = &mut places.options[i]
    {
        chosen = Some(1 - i);
        *x = x.wrapping_add(chosen.unwrap_or(3) as u8);
        return *x;
    }
    let mut left = 3;
    #[bound(4)]
    while let Some(i) = chosen
        && let Some(cell) = places.cells.get_mut(i)
        && *cell > left
    {
        chosen = Some(1 - i);
        *cell = cell.wrapping_mul(3) & 7;
        left += 1;
    }
    chosen.map_or(left, |i| places.cells[i])
}
