//! A body that is long enough to be copied in parts: what one part names and leaves open, the next uses and decides.

#![allow(dead_code, non_snake_case, clippy::needless_late_init)]

use bessemer::generate::tree::Ty;
use bessemer::prelude::*;

use super::{F32, F64, function, int, lets};
use bessemer_tree::number::Int;

/// Names of every kind, each used far behind.
#[function]
pub fn in_parts(x: f64, list: &[f32; 4]) -> Option<f64> {
    let count = 3;
    let later;
    let first = &list[0];
    let (mut low, high) = (x, 2.0);
    let K = list[1];
    let twice = |y: f64| y + y;
    let a = x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x;
    let b = a * x * x * x * x * x * x * x * x * x * x * x * x * x * x * x * x * x * x * x * x * x;
    let x = *first;
    let c = b - a - a - a - a - a - a - a - a - a - a - a - a - a - a - a - a - a - a - a - a - a;
    if c > high {
        return None;
    }
    let d = c + c + c + c + c + c + c + c + c + c + c + c + c + c + c + c + c + c + c + c + c + c;
    low += list.get(2).map(|it| f64::from(*it))?;
    let e = x + K + K + K + K + K + K + K + K + K + K + K + K + K + K + K + K + K + K + K + K + K;
    let f = e + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x + x;
    later = u8::max(count, 1);
    Some(twice(low) + d + f64::from(later) + f64::from(f))
}

#[test]
fn parts_hand_their_names_on() {
    let function = function("parts::in_parts");
    let types: Vec<_> = lets(&function);
    let of = |name: &str| types.iter().rev().find(|it| it.0 == name).map(|it| it.1.clone());
    let expected = [
        ("count", int(Int::U8)),
        ("later", int(Int::U8)),
        ("K", F32),
        ("x", F32),
        ("d", F64),
        ("f", F32),
    ];
    for (name, ty) in expected {
        assert_eq!(of(name), Some(ty), "{name}");
    }
    assert_eq!(of("first"), Some(Ty::Ref(Box::new(F32), false)));
}
