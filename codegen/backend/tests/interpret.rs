//! The interpreter: programs in `tests/ir/*.ir` with what they give, and every scalar operation and
//! routine against Rust and nalgebra themselves. Drop a file into the folder and it is run:
//!
//! ```text
//! // run NAME ARGUMENT… => RESULT [; ARGUMENT AFTERWARDS…]
//! ```
//!
//! A value is a word, or words in brackets: `1.5`, `1.5f32`, `-3`, `0x7ff8000000000000`, `true`, `inf`,
//! `nan` (any NaN; `nanf32`). A result `!overflow` or `!overflow@file:line:column` is a fault.

use std::fmt::Write as _;
use std::path::Path;

use bessemer_backend::validate::validate;
use bessemer_interpret::{Interpreter, Stop, call};
use bessemer_ir::text::{parse, print};
use bessemer_ir::words::word_fits;
use bessemer_ir::{FunctionId, Module, Type};
use nalgebra::SMatrix;

/// A value of an expectation; `None` is any NaN.
type Words = Vec<Option<u64>>;

fn word(text: &str) -> Result<Option<u64>, String> {
    let float = |text: &str| text.parse::<f64>().ok();
    let word = match text {
        "nan" | "nanf32" => return Ok(None),
        "true" => Some(1),
        "false" => Some(0),
        "inf" | "-inf" => float(text).map(f64::to_bits),
        _ if text.starts_with("0x") => u64::from_str_radix(&text[2..], 16).ok(),
        _ if text.ends_with("f32") => {
            text.trim_end_matches("f32").parse::<f32>().ok().map(|value| u64::from(value.to_bits()))
        }
        _ if text.contains(['.', 'e']) => float(text).map(f64::to_bits),
        _ if text.starts_with('-') => text.parse::<i64>().ok().map(|value| value as u64),
        _ => text.parse().ok(),
    };
    word.map(Some).ok_or_else(|| format!("`{text}` is no word"))
}

fn values(text: &str) -> Result<Vec<Words>, String> {
    let spaced = text.replace('[', " [ ").replace(']', " ] ");
    let (mut values, mut open) = (Vec::new(), None::<Words>);
    for token in spaced.split_whitespace() {
        match (token, &mut open) {
            ("[", _) => open = Some(Vec::new()),
            ("]", _) => values.push(open.take().ok_or("unmatched `]`")?),
            (token, Some(list)) => list.push(word(token)?),
            (token, None) => values.push(vec![word(token)?]),
        }
    }
    Ok(values)
}

fn agree(expected: &[Words], found: &[Vec<u64>]) -> bool {
    let is_nan = |word: u64| f64::from_bits(word).is_nan() || f32::from_bits(word as u32).is_nan();
    expected.len() == found.len()
        && expected.iter().zip(found).all(|(expected, found)| {
            expected.len() == found.len()
                && expected.iter().zip(found).all(|(expected, found)| match expected {
                    Some(word) => word == found,
                    None => is_nan(*found),
                })
        })
}

/// `fault@file:line:column`, or without the place.
fn is_fault(expected: &str, stop: &Stop) -> bool {
    let Stop::Fault { fault, span, .. } = stop else { return false };
    let (name, place) =
        expected.split_once('@').map_or((expected, None), |(name, at)| (name, Some(at)));
    format!("{fault:?}").to_lowercase() == name.replace('_', "")
        && place.is_none_or(|at| at == format!("{}:{}:{}", span.file, span.line, span.column))
}

/// Runs one `// run` line.
fn run(module: &Module, line: &str) -> Result<(), String> {
    let (given, wanted) = line.split_once("=>").ok_or("no `=>`")?;
    let (result, after) = wanted.split_once(';').map_or((wanted, None), |(a, b)| (a, Some(b)));
    let (name, arguments) = given.trim().split_once(' ').unwrap_or((given.trim(), ""));
    let index = module.functions.iter().position(|function| function.name == name);
    let id = FunctionId(index.ok_or_else(|| format!("no function `{name}`"))? as u32);
    let nan = |width: u64| if width == 32 { 0x7fc0_0000 } else { 0x7ff8_0000_0000_0000 };
    let width = if arguments.contains("nanf32") { 32 } else { 64 };
    let mut words: Vec<Vec<u64>> = (values(arguments)?.iter())
        .map(|value| value.iter().map(|word| word.unwrap_or(nan(width))).collect())
        .collect();
    let outcome = call(module, id, &mut words);
    match (result.trim().strip_prefix('!'), &outcome) {
        (Some(fault), Err(stop)) if is_fault(fault.trim(), stop) => {}
        (None, Ok(found)) => {
            let expected = values(result)?.into_iter().next().unwrap_or_default();
            if !agree(&[expected], std::slice::from_ref(found)) {
                return Err(format!("gave {found:x?}"));
            }
        }
        _ => return Err(format!("gave {outcome:x?}")),
    }
    match after {
        Some(after) if !agree(&values(after)?, &words) => Err(format!("left {words:x?}")),
        _ => Ok(()),
    }
}

/// Reads, validates and runs a file; what is wrong with it, and how many lines were run.
fn check(text: &str) -> Result<usize, String> {
    let module = parse(text).map_err(|error| error.to_string())?;
    if parse(&print(&module)).as_ref() != Ok(&module) {
        return Err("does not read back".into());
    }
    validate(&module).map_err(|errors| {
        errors.iter().fold(String::new(), |all, error| all + &error.to_string())
    })?;
    let (mut wrong, mut count) = (String::new(), 0);
    for (number, line) in text.lines().enumerate() {
        if let Some(line) = line.trim().strip_prefix("// run ") {
            count += 1;
            if let Err(problem) = run(&module, line) {
                let _ = writeln!(wrong, "{}: {line}\n  {problem}", number + 1);
            }
        }
    }
    if wrong.is_empty() { Ok(count) } else { Err(wrong) }
}

fn files() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ir");
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{folder:?}: {error}"));
    let mut files: Vec<(String, String)> = entries
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "ir"))
        .map(|path| {
            let text =
                std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
            (path.display().to_string(), text)
        })
        .collect();
    files.sort();
    files
}

#[test]
fn programs_give_what_they_say() {
    let (mut wrong, mut count) = (String::new(), 0);
    for (name, text) in files() {
        match check(&text) {
            Ok(0) => wrong += &format!("{name}: nothing to run\n"),
            Ok(lines) => count += lines,
            Err(problem) => wrong += &format!("{name}:{problem}\n"),
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    assert!(count > 120, "only {count} lines were run");
}

#[test]
fn wrong_expectations_are_noticed() {
    let text = "file \"f.rs\"\nfn f(x: &mut f64) -> f64 { x = 2.0; return x + 1.0; }\nfn g(x: u8) -> u8 { @9:9 return x + 1u8; }\n";
    for good in
        ["f 1.0 => 3.0 ; 2.0", "g 255 => !overflow", "g 255 => !overflow@0:9:9", "g 1 => 2 ; 1"]
    {
        assert_eq!(check(&format!("{text}// run {good}")), Ok(1));
    }
    for bad in [
        "f 1.0 => 3.5",
        "f 1.0 => nan",
        "f 1.0 => !overflow",
        "f 1.0 => 3.0 ; 1.0",
        "f 1.0 => [3.0 3.0]",
        "f => 3.0",
        "g 255 => 0",
        "g 255 => !index",
        "g 255 => !overflow@0:9:8",
        "g 256 => 1",
        "h 1 => 1",
    ] {
        assert!(check(&format!("{text}// run {bad}")).is_err(), "{bad}");
    }
}

#[test]
fn arguments_are_checked() {
    let module = parse("fn f(on: bool, x: [f64; 2]) -> bool { return on; }").unwrap_or_default();
    let run = |id, arguments: &[&[u64]]| {
        let mut arguments: Vec<Vec<u64>> = arguments.iter().map(|words| words.to_vec()).collect();
        call(&module, FunctionId(id), &mut arguments)
    };
    assert_eq!(run(0, &[&[1], &[0, 0]]), Ok(vec![1]));
    assert!(matches!(run(1, &[]), Err(Stop::Function(_))));
    assert!(matches!(run(0, &[&[1]]), Err(Stop::Arguments { expected: 2, found: 1 })));
    assert!(matches!(run(0, &[&[2], &[0, 0]]), Err(Stop::Argument { index: 0, .. })));
    assert!(matches!(run(0, &[&[1], &[0]]), Err(Stop::Argument { index: 1, .. })));
}

#[test]
fn a_payload_of_another_variant_is_not_read() {
    let text = "
        struct OptionU8 choice(-, 1) { is_some: bool, value: u8 }
        fn held(x: &OptionU8) -> u8 { return x.value; }
        fn held_or_0(x: &OptionU8) -> bool { return x.is_some && x.value == 7u8; }
        fn set(x: &mut OptionU8) { x.value = 7u8; x.is_some = true; }
    ";
    let module = parse(text).unwrap_or_else(|error| panic!("{error:?}"));
    let run = |id, option: [u64; 2]| call(&module, FunctionId(id), &mut [option.to_vec()]);
    assert_eq!(run(0, [1, 7]), Ok(vec![7]));
    assert!(matches!(run(0, [0, 7]), Err(Stop::Absent { function: FunctionId(0), .. })));
    assert_eq!(run(1, [0, 7]), Ok(vec![0]), "the first operand excludes the read");
    assert_eq!(run(2, [0, 0]), Ok(vec![]), "a write is no read");
}

#[test]
fn endless_counting_stops_at_the_limit() {
    let text = "fn f() { for i: u64 in 0u64..18446744073709551615u64 { } }";
    let module = parse(text).unwrap_or_default();
    let mut interpreter = Interpreter::new(&module);
    interpreter.limit(1000);
    assert_eq!(interpreter.call(FunctionId(0), &mut []), Err(Stop::Limit));
}

/// Values at the edges of an integer type.
macro_rules! edges {
    ($t:ident) => {
        [$t::MIN, $t::MIN + 1, $t::MIN / 2, 0, 1, 2, 3, 7, $t::MAX / 2, $t::MAX - 1, $t::MAX]
    };
}

/// Every operator of an integer type against Rust's checked methods, on all pairs of edges.
macro_rules! integers {
    ($($t:ident)*) => {$(
        #[test]
        fn $t() {
            let t = stringify!($t);
            let ops: [(&str, fn($t, $t) -> Option<$t>); 14] = [
                ("a + b", $t::checked_add),
                ("a - b", $t::checked_sub),
                ("a * b", $t::checked_mul),
                ("a / b", $t::checked_div),
                ("a % b", $t::checked_rem),
                ("a & b", |a, b| Some(a & b)),
                ("a | b", |a, b| Some(a | b)),
                ("a ^ b", |a, b| Some(a ^ b)),
                ("a << b", |a, b| u32::try_from(b).ok().and_then(|b| a.checked_shl(b))),
                ("a >> b", |a, b| u32::try_from(b).ok().and_then(|b| a.checked_shr(b))),
                ("a.wrapping_add(b)", |a, b| Some(a.wrapping_add(b))),
                ("a.wrapping_sub(b)", |a, b| Some(a.wrapping_sub(b))),
                ("a.wrapping_mul(b)", |a, b| Some(a.wrapping_mul(b))),
                ("!a.min(b)", |a, b| Some(!a.min(b))),
            ];
            for (op, native) in ops {
                let module = parse(&format!("fn f(a: {t}, b: {t}) -> {t} {{ return {op}; }}"));
                let module = module.unwrap_or_else(|error| panic!("{op}: {error}"));
                assert_eq!(validate(&module), Ok(()));
                for a in edges!($t) {
                    for b in edges!($t) {
                        // Sign- or zero-extended by `as`, as words are.
                        let found = call(&module, FunctionId(0), &mut [vec![a as u64], vec![b as u64]]);
                        let expected = native(a, b).map(|value| vec![value as u64]);
                        assert_eq!(found.ok(), expected, "{t} {op} a={a} b={b}");
                    }
                }
            }
            for to in ["i8", "i16", "i32", "i64", "isize", "u8", "u16", "u32", "u64", "usize", "f32", "f64"] {
                let module = parse(&format!("fn f(a: {t}) -> {to} {{ return a as {to}; }}")).unwrap_or_default();
                for a in edges!($t) {
                    let expected = match to {
                        "i8" => a as i8 as u64,
                        "i16" => a as i16 as u64,
                        "i32" => a as i32 as u64,
                        "i64" | "isize" => a as i64 as u64,
                        "u8" => a as u8 as u64,
                        "u16" => a as u16 as u64,
                        "u32" => a as u32 as u64,
                        "u64" | "usize" => a as u64,
                        "f32" => (a as f32).to_bits() as u64,
                        _ => (a as f64).to_bits(),
                    };
                    let found = call(&module, FunctionId(0), &mut [vec![a as u64]]);
                    assert_eq!(found, Ok(vec![expected]), "{a} as {to}");
                }
            }
        }
    )*};
}

#[allow(clippy::unnecessary_cast, clippy::manual_div_ceil)]
mod integers {
    use super::*;
    integers! { i8 i16 i32 i64 isize u8 u16 u32 u64 usize }
}

/// Operators and casts of a float type against Rust's, on all pairs of edges.
macro_rules! floats {
    ($($t:ident $bits:ident)*) => {$(
        #[test]
        fn $t() {
            let t = stringify!($t);
            let edges = [
                0.0, -0.0, 1.0, -1.0, 0.1, 1.5, 3.0, -2.5, 254.9, 255.5, 65536.0, -2147483649.0, 1e19, -1e19,
                $t::MAX, $t::MIN, $t::MIN_POSITIVE, $t::EPSILON, $t::from_bits(1), $t::INFINITY,
                $t::NEG_INFINITY, $t::NAN, -$t::NAN,
            ];
            let ops: [(&str, fn($t, $t) -> $t); 8] = [
                ("a + b", |a, b| a + b),
                ("a - b", |a, b| a - b),
                ("a * b", |a, b| a * b),
                ("a / b", |a, b| a / b),
                ("a % b", |a, b| a % b),
                ("-a", |a, _| -a),
                ("a.sqrt()", |a, _| a.sqrt()),
                ("a.floor()", |a, _| a.floor()),
            ];
            let same = |found: &[u64], expected: $t| {
                let found = $t::from_bits(found[0] as $bits);
                found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan())
            };
            for (op, native) in ops {
                let module = parse(&format!("fn f(a: {t}, b: {t}) -> {t} {{ return {op}; }}")).unwrap_or_default();
                assert_eq!(validate(&module), Ok(()));
                for a in edges {
                    for b in edges {
                        let mut words = [vec![u64::from(a.to_bits())], vec![u64::from(b.to_bits())]];
                        let found = call(&module, FunctionId(0), &mut words);
                        assert!(found.is_ok_and(|found| same(&found, native(a, b))), "{t} {op} a={a} b={b}");
                    }
                }
            }
            for to in ["i8", "i64", "u8", "u32", "u64"] {
                let module = parse(&format!("fn f(a: {t}) -> {to} {{ return a as {to}; }}")).unwrap_or_default();
                for a in edges {
                    let expected = match to {
                        "i8" => a as i8 as u64,
                        "i64" => a as i64 as u64,
                        "u8" => a as u8 as u64,
                        "u32" => a as u32 as u64,
                        _ => a as u64,
                    };
                    let found = call(&module, FunctionId(0), &mut [vec![u64::from(a.to_bits())]]);
                    assert_eq!(found, Ok(vec![expected]), "{a} as {to}");
                }
            }
        }
    )*};
}

mod floats {
    use super::*;
    floats! { f32 u32 f64 u64 }
}

/// Numbers that make orders and roundings show.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(2).wrapping_add(1);
    move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let fraction = (state >> 11) as f64 / (1u64 << 53) as f64;
        match state >> 61 {
            0 => -0.0,
            1 => (fraction - 0.5) * 1e18,
            2 => (fraction - 0.5) * 1e-18,
            _ => fraction - 0.5,
        }
    }
}

/// Runs `body` of two matrices, compares with what nalgebra gives.
fn holds(shapes: &str, body: &str, operands: [Vec<u64>; 2], expected: &[u64]) {
    let module = parse(&format!("fn f({shapes} {{ return {body}; }}"));
    let module = module.unwrap_or_else(|error| panic!("{shapes} {body}: {error}"));
    assert_eq!(validate(&module), Ok(()), "{shapes} {body}");
    let found = call(&module, FunctionId(0), &mut operands.clone());
    assert_eq!(found.as_deref(), Ok(expected), "{shapes} {body}");
}

macro_rules! against_nalgebra {
    ($($test:ident: $t:ident)*) => {$(
        mod $test {
            use super::*;

            fn words<const R: usize, const C: usize>(m: &SMatrix<$t, R, C>) -> Vec<u64> {
                m.iter().map(|value| u64::from(value.to_bits())).collect()
            }

            fn shape<const R: usize, const K: usize, const C: usize>() {
                let t = stringify!($t);
                for seed in 0..40 {
                    let mut next = numbers(seed * 31 + (R * 7 + K * 3 + C) as u64);
                    let a = SMatrix::<$t, R, K>::from_fn(|_, _| next() as $t);
                    let b = SMatrix::<$t, K, C>::from_fn(|_, _| next() as $t);
                    let d = SMatrix::<$t, R, K>::from_fn(|_, _| next() as $t);
                    let e = SMatrix::<$t, R, C>::from_fn(|_, _| next() as $t);
                    let (wa, wb, wd, we) = (words(&a), words(&b), words(&d), words(&e));
                    let shapes = |r: usize, c: usize, result: String| {
                        format!("a: &matrix<{t}, {R}, {K}>, b: &matrix<{t}, {r}, {c}>) -> {result}")
                    };
                    let matrix = |r: usize, c: usize| format!("matrix<{t}, {r}, {c}>");
                    let like = shapes(R, K, matrix(R, K));
                    let scalar = shapes(R, K, t.to_string());
                    let one = |value: $t| vec![u64::from(value.to_bits())];
                    holds(&shapes(K, C, matrix(R, C)), "a.product(b)", [wa.clone(), wb.clone()], &words(&(a * b)));
                    holds(&shapes(R, C, matrix(K, C)), "a.tr_mul(b)", [wa.clone(), we], &words(&a.tr_mul(&e)));
                    let two = || [wa.clone(), wd.clone()];
                    holds(&like, "a.add(b)", two(), &words(&(a + d)));
                    holds(&like, "a.sub(b)", two(), &words(&(a - d)));
                    holds(&like, "a.neg()", two(), &words(&-a));
                    holds(&like, "a.component_mul(b)", two(), &words(&a.component_mul(&d)));
                    holds(&like, "a.scale(b[0, 0])", two(), &words(&(a * d[(0, 0)])));
                    holds(&scalar, "a.dot(b)", two(), &one(a.dot(&d)));
                    holds(&scalar, "a.norm()", two(), &one(a.norm()));
                    holds(&scalar, "a.norm_squared()", two(), &one(a.norm_squared()));
                    holds(&shapes(R, K, matrix(K, R)), "a.transpose()", two(), &words(&a.transpose()));
                    // No zeros to divide by: NaN is not compared by bits.
                    let d = d.map(|value| if value == 0.0 { 3.0 } else { value });
                    let two = || [wa.clone(), words(&d)];
                    holds(&like, "a.component_div(b)", two(), &words(&a.component_div(&d)));
                    holds(&like, "a.unscale(b[0, 0])", two(), &words(&(a / d[(0, 0)])));
                }
            }

            #[test]
            fn routines() {
                shape::<1, 1, 1>();
                shape::<2, 1, 3>();
                shape::<1, 3, 2>();
                shape::<2, 2, 2>();
                shape::<3, 3, 1>();
                shape::<4, 3, 4>();
                shape::<5, 4, 5>();
                shape::<6, 6, 6>();
                shape::<7, 1, 2>();
                shape::<8, 8, 3>();
                shape::<9, 2, 9>();
                shape::<1, 9, 1>();
                shape::<16, 1, 1>();
                shape::<19, 5, 1>();
                shape::<33, 2, 1>();
            }

            #[test]
            fn cross() {
                let t = stringify!($t);
                for seed in 0..100 {
                    let mut next = numbers(seed);
                    let a = SMatrix::<$t, 3, 1>::from_fn(|_, _| next() as $t);
                    let b = SMatrix::<$t, 3, 1>::from_fn(|_, _| next() as $t);
                    let shapes = format!("a: matrix<{t}, 3, 1>, b: matrix<{t}, 3, 1>) -> matrix<{t}, 3, 1>");
                    holds(&shapes, "a.cross(b)", [words(&a), words(&b)], &words(&a.cross(&b)));
                }
            }
        }
    )*};
}

against_nalgebra! { nalgebra_f64: f64 nalgebra_f32: f32 }

/// Checks that validated modules run to a value or a fault, never to a panic. The programs are those of the folder with
/// a token or two exchanged.
#[test]
fn what_validates_runs() {
    let texts: Vec<String> = (files().iter())
        .map(|(_, text)| {
            text.lines().filter(|line| !line.starts_with("//")).collect::<Vec<_>>().join("\n")
        })
        .collect();
    let mut next = numbers(7);
    let mut random = move |below: usize| (next().to_bits() >> 3) as usize % below;
    let mut accepted = 0;
    for round in 0..4000 {
        let text = &texts[round % texts.len()];
        let mut tokens: Vec<&str> =
            text.split_inclusive([' ', '(', ')', ',', ';', '.', '[', ']', ':']).collect();
        for _ in 0..1 + round % 3 {
            // Like for like, so that a good part stays valid.
            let at = random(tokens.len());
            let other = (0..500).map(|_| tokens[random(tokens.len())]);
            let mut other = other.filter(|other| *other != tokens[at] && alike(other, tokens[at]));
            if let Some(other) = other.next() {
                tokens[at] = other;
            }
        }
        let changed = tokens.concat();
        let Ok(module) = parse(&changed) else { continue };
        if changed != *text && validate(&module).is_ok() {
            accepted += 1;
            run_all(&module, random(usize::MAX) as u64);
        }
    }
    assert!(accepted > 100, "only {accepted} of 4000 were valid");
}

/// Returns true if two tokens are numbers, names or marks, with the same mark behind.
fn alike(a: &str, b: &str) -> bool {
    let class = |token: &str| {
        let first = token.chars().next().unwrap_or(' ');
        (first.is_ascii_digit(), first.is_ascii_alphabetic(), token.chars().last())
    };
    class(a) == class(b)
}

/// Calls every function, with a few fillings of its arguments.
fn run_all(module: &Module, fill: u64) {
    let mut interpreter = Interpreter::new(module);
    interpreter.limit(10_000);
    for (index, function) in module.functions.iter().enumerate() {
        for fill in [0, 1, fill & 1, fill & 0xff, 0x3ff0_0000_0000_0000 | fill >> 12] {
            let word = |leaf: &Type| if word_fits(module, leaf, fill) { fill } else { 0 };
            let mut arguments: Vec<Vec<u64>> = (function.parameters().iter())
                .map(|local| module.leaves(&local.ty).iter().map(word).collect())
                .collect();
            let _ = interpreter.call(FunctionId(index as u32), &mut arguments);
        }
    }
}
