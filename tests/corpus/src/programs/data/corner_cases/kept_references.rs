//! A reference obtained from a variable keeps referring to the same place when the variable is reassigned.

use bessemer::prelude::*;

/// A sample and its weight.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Measured value.
    pub value: i32,
    /// Weight.
    pub weight: i32,
}

/// References to the best sample so far and the one before.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Best<'a> {
    now: &'a Sample,
    before: &'a Sample,
}

/// The option is assigned again.
#[function]
pub fn assigned(a: &Sample, b: &Sample) -> i32 {
    let mut best = Some(a);
    let mut sum = 0;
    if let Some(kept) = best {
        best = Some(b);
        sum = kept.value.wrapping_mul(3);
    }
    if let Some(now) = best { sum.wrapping_add(now.value) } else { sum }
}

/// Methods of the option replace its content.
#[function]
pub fn replaced(a: &Sample, b: &Sample) -> i32 {
    let mut best = Some(a);
    let mut sum = 0;
    if let Some(kept) = best {
        let old = best.replace(b);
        sum = kept.value.wrapping_mul(5);
        if let Some(old) = old {
            sum = sum.wrapping_add(old.weight);
        }
    }
    if let Some(kept) = best {
        let taken = best.take();
        sum = sum.wrapping_add(kept.weight.wrapping_mul(7));
        if let Some(taken) = taken {
            sum = sum.wrapping_sub(taken.value);
        }
    }
    if best.is_none() { sum } else { -1 }
}

/// A part of a tuple is assigned again.
#[function]
pub fn in_a_tuple(a: &Sample, b: &Sample) -> i32 {
    let mut pair = (a, 1);
    let (kept, count) = pair;
    pair.0 = b;
    pair.1 += count;
    kept.value.wrapping_mul(11).wrapping_add(pair.0.value).wrapping_add(pair.1)
}

/// A field of a struct is assigned, and then the whole struct.
#[function]
pub fn in_a_struct(a: &Sample, b: &Sample) -> i32 {
    let mut best = Best { now: a, before: a };
    let kept = best.now;
    let Best { before, .. } = best;
    best.now = b;
    let second = best.now;
    best = Best { now: a, before: b };
    let sum = kept.value.wrapping_mul(13).wrapping_add(before.weight);
    sum.wrapping_add(second.value).wrapping_add(best.before.weight.wrapping_mul(17))
}

/// A parameter that the function owns is assigned again.
#[function]
fn of_its_own<'a>(mut best: Option<&'a Sample>, other: &'a Sample) -> i32 {
    if let Some(kept) = best {
        best = Some(other);
        return kept.value.wrapping_mul(19).wrapping_add(best.map_or(0, |it| it.value));
    }
    0
}

/// Calls a function that takes the option.
#[function]
pub fn in_a_parameter(a: &Sample, b: &Sample) -> i32 {
    of_its_own(Some(a), b)
}

/// The largest sample in a loop, and the one before it.
#[function]
pub fn in_a_loop(samples: &[Sample; 4]) -> i32 {
    let mut best: Option<&Sample> = None;
    let mut sum = 0_i32;
    for sample in samples {
        match best {
            Some(kept) if kept.value < sample.value => {
                best = Some(sample);
                sum = sum.wrapping_mul(3).wrapping_add(kept.value);
            }
            None => best = Some(sample),
            _ => {}
        }
    }
    sum.wrapping_add(best.map_or(0, |it| it.weight))
}

/// Two references are swapped.
#[function]
pub fn swapped<'a>(a: &'a Sample, b: &'a Sample) -> i32 {
    let (mut one, mut other) = (Some(a), Some(b));
    if let (Some(first), Some(second)) = (one, other) {
        core::mem::swap(&mut one, &mut other);
        let sum = first.value.wrapping_mul(23).wrapping_add(second.weight);
        return sum.wrapping_add(one.map_or(0, |it| it.value));
    }
    0
}

/// A mutable name in a pattern is assigned again.
#[function]
pub fn in_a_pattern(a: &Sample, b: &Sample) -> i32 {
    let (mut best, other) = (Some(a), b);
    if let Some(kept) = best {
        best = Some(other);
        return kept.value.wrapping_mul(29).wrapping_add(best.map_or(0, |it| it.value));
    }
    0
}

/// The option is changed through a reference.
#[function]
fn lent<'a>(best: &mut Option<&'a Sample>, other: &'a Sample) -> i32 {
    if let Some(kept) = *best {
        *best = Some(other);
        return kept.value.wrapping_mul(31);
    }
    0
}

/// A function changes the option of its caller.
#[function]
pub fn of_its_caller<'a>(a: &'a Sample, b: &'a Sample) -> i32 {
    let mut best = Some(a);
    let sum = lent(&mut best, b);
    sum.wrapping_add(best.map_or(0, |it| it.value))
}

/// A pattern on the first of several structs.
#[function]
fn of_the_first<'a>(pairs: &mut [Best<'a>], b: &'a Sample) -> i32 {
    let [first, ..] = pairs else { return 0 };
    let Best { now, .. } = *first;
    first.now = b;
    now.value.wrapping_mul(19).wrapping_add(first.now.weight)
}

/// Calls a function that takes several structs.
#[function]
pub fn in_a_slice(a: &Sample, b: &Sample) -> i32 {
    let mut pairs = [Best { now: a, before: a }, Best { now: b, before: b }];
    of_the_first(&mut pairs, b).wrapping_add(pairs[0].now.value)
}
