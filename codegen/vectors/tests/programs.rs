//! Programs of the IR in vectors, with different arguments in each lane: each lane has the words of the interpreter.
//!
//! `programs.in` is the text that is emitted for `programs.ir`. `UPDATE_DOCS=1 cargo test -p bessemer-vectors` writes it, and the next
//! build compiles it.

use std::collections::BTreeMap;

use bessemer_interpret::call;
use bessemer_ir::{Function, FunctionId, Mode, Module, Scalar, Type};
use bessemer_lanes::{LANES, Lanes, Mask};
use bessemer_vectors::emit;

#[rustfmt::skip]
#[allow(unused, missing_docs, non_snake_case, clippy::all)]
mod programs {
    include!("programs.in");
}

fn module() -> Module {
    bessemer_ir::text::parse(include_str!("programs.ir")).expect("IR")
}

fn find(module: &Module, name: &str) -> FunctionId {
    let place = module.functions.iter().position(|it| it.name == name);
    FunctionId(place.expect("a function of the name") as u32)
}

#[test]
fn the_emitted_text_is_the_committed_one() {
    let module = module();
    let all: Vec<FunctionId> = (0..module.functions.len() as u32).map(FunctionId).collect();
    let text = emit(&module, &all).unwrap_or_else(|error| panic!("{error}"));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/programs.in");
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(path, &text).expect("it is written");
    }
    assert!(text == include_str!("programs.in"), "{path} is stale: UPDATE_DOCS=1, twice");
}

/// Random words, by a generator of 64 bits (Vigna, `splitmix64`).
struct Random(u64);

impl Random {
    fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut word = self.0;
        word = (word ^ (word >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        word ^ (word >> 31)
    }

    /// Returns a word of a type: small whole numbers, numbers around 0, and some of the edges.
    fn of(&mut self, ty: &Type) -> u64 {
        let word = self.word();
        match ty {
            Type::Enum(_) => word % 3,
            Type::Scalar(Scalar::Bool) => word % 2,
            Type::Scalar(Scalar::Int(int)) => {
                let number = match word % 4 {
                    0 => bessemer_ir::Int::max(*int) - i128::from(word >> 60),
                    1 if int.signed() => -i128::from(word >> 59),
                    _ => i128::from((word >> 8) % 21),
                };
                number as u64
            }
            _ => {
                let edges = [0.0, -0.0, f64::NAN, f64::INFINITY, 1e300, -1.0];
                let near = (word >> 11) as f64 / (1_u64 << 50) as f64 - 4.0;
                let edge = edges.get(word as usize % 24).copied();
                edge.unwrap_or(near).to_bits()
            }
        }
    }
}

/// Returns the words of the arguments and of the result after a call by the interpreter.
fn interpreted(module: &Module, id: FunctionId, arguments: &[Vec<u64>]) -> Vec<u64> {
    let mut arguments = arguments.to_vec();
    let result = call(module, id, &mut arguments).unwrap_or_else(|stop| panic!("{stop}"));
    written(&module.functions[id.index()], &arguments).chain(result).map(plain).collect()
}

fn written(function: &Function, arguments: &[Vec<u64>]) -> impl Iterator<Item = u64> {
    let passed = function.parameters().iter().zip(arguments);
    passed.filter(|it| it.0.mode == Mode::RefMut).flat_map(|it| it.1.clone())
}

/// Any NaN is any NaN.
fn plain(word: u64) -> u64 {
    if f64::from_bits(word).is_nan() { u64::MAX } else { word }
}

/// Returns the values of the lanes of an argument.
fn lanes<T: Lanes>(arguments: &[Vec<Vec<u64>>], index: usize) -> T {
    let mut value = T::zero();
    for (lane, arguments) in arguments.iter().enumerate() {
        value.put(lane, &mut arguments[index].iter().copied());
    }
    value
}

/// Appends the words of a lane.
type Words<'w> = &'w dyn Fn(usize, &mut Vec<u64>);

fn words(values: &[Words<'_>], lane: usize) -> Vec<u64> {
    let mut all = Vec::new();
    values.iter().for_each(|words| words(lane, &mut all));
    all.into_iter().map(plain).collect()
}

/// A function in vectors: the words of each lane after a call with a mask.
type Called = fn(Mask, &[Vec<Vec<u64>>], usize) -> Vec<u64>;

macro_rules! called {
    ($name:ident($($index:literal),*)) => {
        (stringify!($name), (|mask, all, lane| {
            let result = programs::$name(mask, $(lanes(all, $index)),*);
            words(&[&|lane, words| result.words(lane, words)], lane)
        }) as Called)
    };
    ($name:ident(mut 0 $(, $index:literal)*)) => {
        (stringify!($name), (|mask, all, lane| {
            let mut state = lanes(all, 0);
            let result = programs::$name(mask, &mut state $(, lanes(all, $index))*);
            words(&[&|lane, words| state.words(lane, words), &|lane, words| result.words(lane, words)], lane)
        }) as Called)
    };
    ($name:ident(ref 0 $(, $index:literal)*)) => {
        (stringify!($name), (|mask, all, lane| {
            let state = lanes(all, 0);
            let result = programs::$name(mask, &state $(, lanes(all, $index))*);
            words(&[&|lane, words| result.words(lane, words)], lane)
        }) as Called)
    };
}

#[test]
fn each_lane_has_the_words_of_the_interpreter() {
    let module = module();
    let called: BTreeMap<&str, Called> = [
        called!(early(0, 1)),
        called!(loops(0, 1)),
        called!(ends(0, 1)),
        called!(named(0, 1)),
        called!(numbered(0, 1)),
        called!(elements(mut 0, 1, 2)),
        called!(raised(mut 0, 1, 2)),
        called!(part(ref 0, 1)),
        called!(integers(0, 1, 2)),
        called!(reals(0, 1)),
    ]
    .into();
    let mut random = Random(7);
    for (name, called) in called {
        let id = find(&module, name);
        let parameters = module.functions[id.index()].parameters();
        for round in 0..200 {
            let mut argument = |ty: &Type| -> Vec<u64> {
                module.leaves(ty).iter().map(|leaf| random.of(leaf)).collect()
            };
            let all: Vec<Vec<Vec<u64>>> = (0..LANES)
                .map(|_| parameters.iter().map(|it| argument(&it.ty)).collect())
                .collect();
            let active: [bool; LANES] = std::array::from_fn(|lane| round % (lane + 2) != 1);
            for lane in (0..LANES).filter(|lane| active[*lane]) {
                let found = called(Mask::new(active), &all, lane);
                let wanted = interpreted(&module, id, &all[lane]);
                assert_eq!(found, wanted, "{name}, lane {lane} of {all:?}");
            }
        }
    }
}

#[test]
fn what_lanes_do_not_have_is_reported_at_its_line() {
    let error = |body: &str| {
        let text = format!(
            "module m\nfile \"a.rs\"\n\n@0:4:8 fn f in m(x: &mut [u8; 4], k: usize) -> u8 as result {{\n{body}\n}}\n"
        );
        let module = bessemer_ir::text::parse(&text).expect("IR");
        emit(&module, &[FunctionId(0)]).expect_err("it is refused").to_string()
    };
    assert_eq!(
        error("  @5:3 check k < 4 else index;\n  @6:3 return x[k];"),
        "a.rs:5:3: `f` has a check that may fail: lanes need an entry point that is `infallible`"
    );
    assert_eq!(
        error("  @6:3 return x[k].saturating_mul(2u8).swap_bytes();"),
        "a.rs:6:3: `f` uses `SwapBytes`, which lanes do not have for this type"
    );
}
