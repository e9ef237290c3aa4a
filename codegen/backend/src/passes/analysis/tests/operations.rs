//! Every operation on every pair of intervals of types of a few bits, and on some of all types by chance.

use bessemer_ir::{BinaryOp, CompareOp, Int, Intrinsic};
use proptest::prelude::*;

use crate::passes::analysis::Interval;

/// An integer type of any width.
#[derive(Clone, Copy, Debug)]
struct Width {
    bits: u32,
    signed: bool,
}

impl Width {
    fn all(self) -> Interval {
        let half = 1i128 << (self.bits - 1);
        if self.signed { Interval::new(-half, half - 1) } else { Interval::new(0, 2 * half - 1) }
    }

    fn wrap(self, value: i128) -> i128 {
        let rest = value.rem_euclid(1i128 << self.bits);
        if rest > self.all().high { rest - (1i128 << self.bits) } else { rest }
    }

    fn fits(self, value: i128) -> Option<i128> {
        self.all().contains(value).then_some(value)
    }

    fn unsigned(self) -> Width {
        Width { signed: false, ..self }
    }
}

const BINARY: [BinaryOp; 10] = [
    BinaryOp::Add,
    BinaryOp::Sub,
    BinaryOp::Mul,
    BinaryOp::Div,
    BinaryOp::Rem,
    BinaryOp::And,
    BinaryOp::Or,
    BinaryOp::Xor,
    BinaryOp::Shl,
    BinaryOp::Shr,
];

const COMPARE: [CompareOp; 6] =
    [CompareOp::Eq, CompareOp::Ne, CompareOp::Lt, CompareOp::Le, CompareOp::Gt, CompareOp::Ge];

const PAIRS: [Intrinsic; 12] = [
    Intrinsic::Min,
    Intrinsic::Max,
    Intrinsic::WrappingAdd,
    Intrinsic::WrappingSub,
    Intrinsic::WrappingMul,
    Intrinsic::WrappingDiv,
    Intrinsic::WrappingRem,
    Intrinsic::SaturatingAdd,
    Intrinsic::SaturatingSub,
    Intrinsic::SaturatingMul,
    Intrinsic::DivEuclid,
    Intrinsic::RemEuclid,
];

const SINGLES: [Intrinsic; 6] = [
    Intrinsic::Abs,
    Intrinsic::UnsignedAbs,
    Intrinsic::CountOnes,
    Intrinsic::LeadingZeros,
    Intrinsic::TrailingZeros,
    Intrinsic::SwapBytes,
];

/// Rust's result; nothing where it panics.
fn binary(op: BinaryOp, width: Width, a: i128, b: i128) -> Option<i128> {
    let shift = || u32::try_from(b).ok().filter(|by| *by < width.bits);
    match op {
        BinaryOp::Add => width.fits(a + b),
        BinaryOp::Sub => width.fits(a - b),
        BinaryOp::Mul => width.fits(a.checked_mul(b)?),
        BinaryOp::Div => width.fits(a.checked_div(b)?),
        // It panics where the quotient overflows.
        BinaryOp::Rem => width.fits(a.checked_div(b)?).map(|_| a % b),
        BinaryOp::And => Some(a & b),
        BinaryOp::Or => Some(a | b),
        BinaryOp::Xor => Some(a ^ b),
        BinaryOp::Shl => shift().map(|by| width.wrap(a << by)),
        BinaryOp::Shr => shift().map(|by| a >> by),
    }
}

fn compare(op: CompareOp, a: i128, b: i128) -> bool {
    match op {
        CompareOp::Eq => a == b,
        CompareOp::Ne => a != b,
        CompareOp::Lt => a < b,
        CompareOp::Le => a <= b,
        CompareOp::Gt => a > b,
        CompareOp::Ge => a >= b,
    }
}

fn pair(which: Intrinsic, width: Width, a: i128, b: i128) -> Option<i128> {
    let saturated = |value: i128| value.clamp(width.all().low, width.all().high);
    Some(match which {
        Intrinsic::Min => a.min(b),
        Intrinsic::Max => a.max(b),
        Intrinsic::WrappingAdd => width.wrap(a + b),
        Intrinsic::WrappingSub => width.wrap(a - b),
        Intrinsic::WrappingMul => width.wrap(a.checked_mul(b)?),
        Intrinsic::WrappingDiv => width.wrap(a.checked_div(b)?),
        Intrinsic::WrappingRem => a.checked_rem(b)?,
        Intrinsic::SaturatingAdd => saturated(a + b),
        Intrinsic::SaturatingSub => saturated(a - b),
        Intrinsic::SaturatingMul => saturated(a.checked_mul(b)?),
        Intrinsic::DivEuclid => width.fits(a.checked_div_euclid(b)?)?,
        Intrinsic::RemEuclid => width.fits(a.checked_div(b)?).map(|_| a.rem_euclid(b))?,
        Intrinsic::AbsDiff => (a - b).abs(),
        _ => unreachable!("of two operands"),
    })
}

fn single(which: Intrinsic, width: Width, a: i128) -> Option<i128> {
    let bits = i128::from(width.bits);
    Some(match which {
        Intrinsic::Abs => width.fits(a.abs())?,
        Intrinsic::UnsignedAbs => a.abs(),
        Intrinsic::CountOnes => i128::from(a.count_ones()),
        Intrinsic::LeadingZeros => bits - (128 - i128::from(a.leading_zeros())),
        Intrinsic::TrailingZeros => bits.min(i128::from(a.trailing_zeros())),
        Intrinsic::SwapBytes => a,
        _ => unreachable!("of one operand"),
    })
}

/// Calls `check` with each pair of intervals of the type and the hull of the results on all values in them.
fn each_pair(
    width: Width,
    result: impl Fn(i128, i128) -> Option<i128>,
    mut check: impl FnMut(Interval, Interval, Option<Interval>),
) {
    let all = width.all();
    let join = |a: Option<Interval>, b: Option<Interval>| match (a, b) {
        (Some(a), Some(b)) => Some(a.join(b)),
        (a, b) => a.or(b),
    };
    for low in all.low..=all.high {
        let mut columns = vec![None; (all.high - all.low + 1) as usize];
        for high in low..=all.high {
            for (value, column) in (all.low..).zip(&mut columns) {
                *column = join(*column, result(high, value).map(Interval::one));
            }
            for from in all.low..=all.high {
                let mut hull = None;
                for to in from..=all.high {
                    hull = join(hull, columns[(to - all.low) as usize]);
                    check(Interval::new(low, high), Interval::new(from, to), hull);
                }
            }
        }
    }
}

const NARROW: [Width; 4] = [
    Width { bits: 4, signed: false },
    Width { bits: 4, signed: true },
    Width { bits: 5, signed: false },
    Width { bits: 5, signed: true },
];

#[test]
fn operators_hold_all_their_results() {
    for width in NARROW {
        for op in BINARY {
            each_pair(
                width,
                |a, b| binary(op, width, a, b),
                |a, b, hull| {
                    let found = a.binary(op, b, width.all());
                    assert!(found.within(width.all()), "{width:?} {a} {op:?} {b}: {found}");
                    let holds = hull.is_none_or(|hull| hull.within(found));
                    assert!(holds, "{width:?} {a} {op:?} {b}: {found} of {hull:?}");
                },
            );
        }
    }
}

/// The exact result is what decides that none overflows.
#[test]
fn exact_results_are_exact() {
    for width in NARROW {
        for op in [BinaryOp::Add, BinaryOp::Sub, BinaryOp::Mul] {
            let wide = Width { bits: 64, signed: true };
            each_pair(
                width,
                |a, b| binary(op, wide, a, b),
                |a, b, hull| {
                    assert_eq!(Some(a.exact(op, b)), hull, "{width:?} {a} {op:?} {b}");
                },
            );
        }
    }
}

#[test]
fn comparisons_are_decided_rightly() {
    for width in NARROW {
        for op in COMPARE {
            each_pair(
                width,
                |a, b| Some(compare(op, a, b).into()),
                |a, b, hull| {
                    // It is known exactly where all comparisons agree.
                    assert_eq!(Some(a.compare(op, b)), hull, "{width:?} {a} {op:?} {b}");
                },
            );
        }
    }
}

#[test]
fn intrinsics_hold_all_their_results() {
    for width in NARROW {
        for which in PAIRS {
            each_pair(
                width,
                |a, b| pair(which, width, a, b),
                |a, b, hull| {
                    let found = Interval::intrinsic(which, &[a, b], width.all());
                    let holds = hull.is_none_or(|hull| hull.within(found));
                    assert!(holds, "{width:?} {which:?} {a} {b}: {found} of {hull:?}");
                },
            );
        }
        let all = width.unsigned().all();
        each_pair(
            width,
            |a, b| pair(Intrinsic::AbsDiff, width, a, b),
            |a, b, hull| {
                let found = Interval::intrinsic(Intrinsic::AbsDiff, &[a, b], all);
                assert!(hull.is_none_or(|hull| hull.within(found)), "{width:?} {a} {b}: {found}");
            },
        );
    }
}

#[test]
fn intrinsics_of_one_operand_hold_all_their_results() {
    for width in
        [NARROW[0], NARROW[1], Width { bits: 8, signed: false }, Width { bits: 8, signed: true }]
    {
        for which in SINGLES {
            let unsigned = !matches!(which, Intrinsic::Abs | Intrinsic::UnsignedAbs);
            if unsigned == width.signed {
                continue;
            }
            let all = match which {
                Intrinsic::UnsignedAbs => width.unsigned().all(),
                Intrinsic::Abs | Intrinsic::SwapBytes => width.all(),
                _ => Interval::of(Int::U32),
            };
            for low in width.all().low..=width.all().high {
                for high in low..=width.all().high {
                    let a = Interval::new(low, high);
                    let found = Interval::intrinsic(which, &[a], all);
                    let mut results = (low..=high).filter_map(|a| single(which, width, a));
                    assert!(
                        results.all(|it| found.contains(it)),
                        "{width:?} {which:?} {a}: {found}"
                    );
                }
            }
        }
    }
}

#[test]
fn clamps_complements_and_opposites_hold_all_their_results() {
    let three = [Width { bits: 3, signed: false }, Width { bits: 3, signed: true }];
    for width in three {
        let all = width.all();
        let pairs =
            || (all.low..=all.high).flat_map(|low| (low..=all.high).map(move |high| (low, high)));
        let intervals: Vec<Interval> =
            pairs().map(|(low, high)| Interval::new(low, high)).collect();
        for x in &intervals {
            for value in x.low..=x.high {
                let not = width.wrap(!value);
                assert!(x.not(all).contains(not), "{width:?} !{x}");
                let opposite = width.fits(-value);
                let found = all.meet(Interval::one(0).sub(*x));
                assert!(opposite.is_none_or(|it| found.contains(it)), "{width:?} -{x}: {found}");
            }
            for low in &intervals {
                for high in &intervals {
                    let found = Interval::intrinsic(Intrinsic::Clamp, &[*x, *low, *high], all);
                    for value in x.low..=x.high {
                        for from in low.low..=low.high {
                            let above = high.low.max(from)..=high.high;
                            assert!(
                                above.into_iter().all(|to| found.contains(value.clamp(from, to)))
                            );
                        }
                    }
                }
            }
        }
    }
}

/// The lattice: the join holds both, the meet what both hold, and one value less is no other less.
#[test]
fn joins_and_meets_keep_what_they_must() {
    let width = NARROW[1];
    let some = |a: i128, b: i128| Some(a.max(b)).filter(|_| false);
    each_pair(width, some, |a, b, _| {
        for value in width.all().low..=width.all().high {
            let (in_a, in_b) = (a.contains(value), b.contains(value));
            assert!(a.join(b).contains(value) || !(in_a || in_b));
            assert!(a.meet(b).contains(value) || !(in_a && in_b));
            assert!(a.meet(b).within(a));
            let without = a.without(b.low);
            assert!(without.contains(value) || !in_a || value == b.low);
        }
        assert_eq!(a.within(b), (a.low..=a.high).all(|value| b.contains(value)));
    });
}

fn widths() -> impl Strategy<Value = Width> {
    let bits = prop_oneof![Just(8u32), Just(16), Just(32), Just(64)];
    (bits, any::<bool>()).prop_map(|(bits, signed)| Width { bits, signed })
}

/// Values of a type, its ends and what is near 0 often.
fn value(all: Interval) -> impl Strategy<Value = i128> {
    prop_oneof![
        all.low..=all.high,
        (-4i128..=70).prop_map(move |value| value.clamp(all.low, all.high)),
        (0i128..=3).prop_map(move |from| all.low + from),
        (0i128..=3).prop_map(move |from| all.high - from),
    ]
}

/// A type, and two intervals of it, each with a value in it.
fn case() -> impl Strategy<Value = (Width, [(Interval, i128); 2])> {
    let of = |all| {
        [value(all), value(all), value(all)].prop_map(|mut bounds: [i128; 3]| {
            bounds.sort_unstable();
            (Interval::new(bounds[0], bounds[2]), bounds[1])
        })
    };
    widths().prop_flat_map(move |width| (Just(width), [of(width.all()), of(width.all())]))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(4000) })]

    #[test]
    fn wide_results_are_held((width, [(a, x), (b, y)]) in case()) {
        let all = width.all();
        for op in BINARY {
            let found = a.binary(op, b, all);
            if let Some(result) = binary(op, width, x, y) {
                prop_assert!(found.contains(result), "{x} {op:?} {y}: {found}");
            }
        }
        for op in COMPARE {
            prop_assert!(a.compare(op, b).contains(compare(op, x, y).into()), "{x} {op:?} {y}");
        }
        for which in PAIRS {
            if let Some(result) = pair(which, width, x, y) {
                let found = Interval::intrinsic(which, &[a, b], all);
                prop_assert!(found.contains(result), "{which:?} {x} {y}: {found}");
            }
        }
        let found = Interval::intrinsic(Intrinsic::AbsDiff, &[a, b], width.unsigned().all());
        prop_assert!(found.contains((x - y).abs()), "{found}");
        for op in [BinaryOp::Add, BinaryOp::Sub, BinaryOp::Mul] {
            if let Some(result) = binary(op, Width { bits: 127, signed: true }, x, y) {
                prop_assert!(a.exact(op, b).contains(result));
            }
        }
    }
}
