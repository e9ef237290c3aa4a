//! Labelled blocks inside each other, in loops, around loops, and as operands.

use bessemer::prelude::*;

/// A reading and the number of its sensor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// Number of the sensor.
    pub sensor: u8,
    /// The value.
    pub value: f64,
}

/// A block whose two branches may both reach the code after it.
#[function]
pub fn both(a: bool, b: bool, x: i32) -> i32 {
    let mut y = x;
    let z = 'out: {
        if a {
            if b {
                break 'out y - 1;
            }
            y += 1;
        } else {
            if b && y > 3 {
                break 'out y * 2;
            }
            y -= 1;
        }
        y += 10;
        if y > 20 {
            break 'out 20;
        }
        y
    };
    z + y
}

/// Nested blocks: the inner one ends the outer one, or only itself.
#[function]
pub fn nested(x: i32, y: i32) -> i32 {
    let mut sum = 0;
    'outer: {
        let part = 'inner: {
            if x < 0 {
                break 'outer;
            }
            if y < 0 {
                break 'inner 1;
            }
            if x == y {
                sum = 100;
                break 'outer;
            }
            x - y
        };
        sum += part;
        if sum > 5 {
            break 'outer;
        }
        sum += 7;
    }
    sum
}

/// A block in a loop: it continues the loop, leaves it, or leaves only itself.
#[function]
pub fn in_loop(values: &[i32; 6]) -> i32 {
    let mut sum = 0;
    'all: for value in values {
        let weight = 'weight: {
            if *value < 0 {
                continue 'all;
            }
            if *value == 7 {
                break 'all;
            }
            for i in 1..4 {
                if value % (i + 1) == 0 {
                    break 'weight i;
                }
                if *value == 100 + i {
                    continue 'all;
                }
                if *value == 200 {
                    break 'all;
                }
            }
            1
        };
        sum += value * weight;
    }
    sum
}

/// A block whose value is a struct, left from within two loops.
#[function]
pub fn found(grid: &[[f64; 3]; 2], limit: f64) -> Reading {
    let reading = 'found: {
        for (row, values) in grid.iter().enumerate() {
            for value in values {
                if *value > limit {
                    break 'found Reading { sensor: row as u8, value: *value };
                }
                if value.is_nan() {
                    break 'found Reading::default();
                }
            }
        }
        Reading { sensor: 255, value: limit }
    };
    Reading { value: reading.value + 1.0, ..reading }
}

/// A block as an operand: operands before it are evaluated before it.
#[function]
pub fn operand(x: u8, y: u8) -> u8 {
    let mut count = x;
    let sum = count + 'part: {
        count = 1;
        if y > 4 {
            break 'part y - 4;
        }
        y + 1
    };
    sum + count
}

/// A block in a `match`, with `return`, `?` and a possible fault.
#[function]
pub fn matched(x: Option<u8>, y: Option<u8>, table: &[u8; 4]) -> Option<u8> {
    let value = 'value: {
        match x {
            Some(0) => return Some(77),
            Some(n @ 1..=3) => break 'value table[usize::from(n)],
            Some(n) if n > 100 => {}
            Some(n) => break 'value table[usize::from(n)],
            None => {
                let y = y?;
                if y == 9 {
                    break 'value 90;
                }
            }
        }
        if let Some(y) = y
            && y > 4
        {
            break 'value y - 4;
        }
        y.unwrap_or(5)
    };
    Some(value + 1)
}

/// A loop without a derivable end in a block, and a block in such a loop.
#[function]
pub fn looped(start: u32) -> u32 {
    let mut n = start % 64;
    let mut steps = 0;
    while steps < 5 {
        steps += 1;
        n = 'next: {
            if n % 2 == 0 {
                break 'next n / 2;
            }
            let mut k = 0;
            while k < 3 {
                k += 1;
                if n % (k + 2) == 0 {
                    break 'next k;
                }
            }
            n + 3
        };
    }
    n
}

/// A generic function with a block that no `break` leaves, and a label used twice.
#[function]
pub fn generic<T: Real, const N: usize>(values: &[T; N], limit: T) -> T {
    let first = 'value: {
        if N == 2 {
            break 'value limit;
        }
        for value in values {
            if *value > limit {
                break 'value *value;
            }
        }
        T::ZERO
    };
    let second = 'value: {
        if first > limit {
            break 'value first;
        }
        first + limit
    };
    second
}

/// Calls the generic function with two types.
#[function]
pub fn generics(three: &[f64; 3], two: &[f32; 2], limit: f64) -> f64 {
    generic(three, limit) + f64::from(generic(two, 2.0))
}

/// A closure of an `Option` method leaves a block, and so does one of a chain.
#[function]
pub fn closures(x: Option<i32>, values: &[i32; 5]) -> i32 {
    'out: {
        let n = x.map_or(1, |x| 'in_closure: {
            if x > 3 {
                break 'in_closure 3;
            }
            x
        });
        let sum: i32 = values
            .iter()
            .map(|value| 'part: {
                if *value > n {
                    break 'part n;
                }
                *value
            })
            .sum();
        if sum > 4 {
            break 'out sum;
        }
        for value in values.iter().filter(|value| **value > n) {
            if *value == 9 {
                break 'out 9;
            }
        }
        0
    }
}
