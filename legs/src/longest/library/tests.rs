//! Counts of the library's functions against their figures.

use super::*;
use crate::harness::MARKS;
use crate::longest::{callers, processor};
use crate::toolchain::{ARM, BARE_A9, CORTEX_M4F, Toolchain};
use crate::watch;

/// Dividends and divisors whose quotients have many binary places, of all kinds: nearly all ones, zeros, or mixed.
fn remainders() -> Vec<(f64, f64)> {
    let ones = (1_u64 << 52) - 1;
    let largest = |mantissa: u64| f64::from_bits(2046 << 52 | mantissa);
    let mut pairs = Vec::new();
    for divisor in [1.0, 3.0, std::f64::consts::TAU, f64::from_bits(1), f64::from_bits(ones)] {
        let mixed = [0, 1, ones, 0x5_5555_5555_5555, 0x9_2492_4924_9249];
        pairs.extend(mixed.map(|mantissa| (largest(mantissa), divisor)));
    }
    // The places of (m - 1) / m and of 1 / m have a period of nearly all ones, and of nearly all zeros.
    for exponent in [1, 53, 1023] {
        let divisor = f64::from_bits(exponent << 52 | ones);
        pairs.extend([ones - 1, 0, 1].map(|mantissa| (largest(mantissa), divisor)));
    }
    pairs
}

fn remainders_of_floats() -> Vec<(f32, f32)> {
    let ones = (1_u32 << 23) - 1;
    let largest = |mantissa: u32| f32::from_bits(254 << 23 | mantissa);
    let mut pairs = Vec::new();
    for divisor in
        [1.0, 3.0, f32::from_bits(1), f32::from_bits(ones), f32::from_bits(1 << 23 | ones)]
    {
        let mixed = [0, 1, ones - 1, ones, 0x25_5555];
        pairs.extend(mixed.map(|mantissa| (largest(mantissa), divisor)));
    }
    pairs
}

/// Counts the calls of a program whose functions are `call_0` and so on. Returns the counts, and the instructions of each
/// function around its call.
fn counted(toolchain: &Toolchain, text: &str, functions: usize) -> (Vec<u64>, Vec<u64>) {
    let folder = tempfile::tempdir().expect("a folder");
    let main = folder.path().join("counted.c");
    std::fs::write(&main, text).expect("a file");
    let program = watch::built(toolchain, folder.path(), &main, &[], &[]).expect("it compiles");
    let own = folder.path().join(watch::FOLDER);
    // The program writes no words.
    std::fs::write(own.join("words.out"), "").expect("a file");
    let counts = watch::counted(toolchain, &own, &program, &[]).expect("it runs").counts;
    (counts, callers(toolchain, &main, functions).expect("the callers"))
}

/// Counts the calls on an emulated processor, with the instructions of their caller.
fn counts(toolchain: &Toolchain, pairs: &[(String, String)], function: &str, ty: &str) -> Vec<u64> {
    let mut text = format!(
        "#include <math.h>\n#include <stdint.h>\n#include <stdlib.h>\n{MARKS}int main(void)\n{{\n    \
         static volatile {ty} x;\n    static volatile {ty} y;\n    static volatile {ty} z;\n"
    );
    for (x, y) in pairs {
        text += &format!(
            "    x = {x}; y = {y};\n    bench_begin(); z = {function}(x, y); bench_end(); (void)z;\n"
        );
    }
    text += "    exit(0);\n}\n";
    counted(toolchain, &text, 0).0
}

/// No call takes more than its figure, and the figure is near the largest count.
#[test]
fn remainders_take_no_more_than_their_figures() {
    // Instructions of `main` between the marks.
    const CALLER: u64 = 16;
    let doubles = remainders();
    let floats = remainders_of_floats();
    let texts = |it: &(f64, f64)| (format!("{:e}", it.0), format!("{:e}", it.1));
    let of_doubles: Vec<_> = doubles.iter().map(texts).collect();
    let texts = |it: &(f32, f32)| (format!("{:e}F", it.0), format!("{:e}F", it.1));
    let of_floats: Vec<_> = floats.iter().map(texts).collect();
    for toolchain in [ARM, BARE_A9, CORTEX_M4F].iter().filter(|it| it.is_there()) {
        let processor = processor(toolchain).expect("the model has it");
        let bound = |function, places| {
            cost(processor, function, Known::default(), places, Numbers::Any)
                .expect("a figure")
                .instructions
                + CALLER
        };
        let mut most = 0;
        for (pair, count) in doubles.iter().zip(counts(toolchain, &of_doubles, "fmod", "double")) {
            let bound = bound("fmod", quotient(pair.1));
            assert!(count <= bound, "{processor:?}: fmod of {pair:?} takes {count}, not {bound}");
            most = most.max(100 * count / bound);
        }
        let single =
            counts(toolchain, &of_floats, "fmodf", "float").into_iter().max().expect("a count");
        let bound = bound("fmodf", 0);
        assert!(single <= bound, "{processor:?}: fmodf takes {single}, not {bound}");
        assert!(
            most > 80 && 100 * single > 70 * bound,
            "{processor:?}: {most} percent, {single} of {bound}"
        );
    }
}

/// Types of the result and of the parameters of a function of the table, in C.
fn signature(name: &str) -> (&'static str, &'static [&'static str]) {
    const DOUBLES: &[&str] = &["double", "double"];
    let kind = name.trim_start_matches("__aeabi_");
    match kind {
        "dadd" | "dsub" | "dmul" | "ddiv" => ("double", DOUBLES),
        _ if kind.starts_with("dcmp") => ("int", DOUBLES),
        "sqrt" | "floor" | "ceil" | "trunc" | "round" => ("double", &["double"]),
        "sqrtf" | "floorf" | "ceilf" | "truncf" | "roundf" => ("float", &["float"]),
        "fmodf" => ("float", &["float", "float"]),
        "ui2d" => ("double", &["uint32_t"]),
        "i2d" => ("double", &["int32_t"]),
        "ul2d" => ("double", &["uint64_t"]),
        "l2d" => ("double", &["int64_t"]),
        "ul2f" => ("float", &["uint64_t"]),
        "l2f" => ("float", &["int64_t"]),
        "d2iz" => ("int32_t", &["double"]),
        "d2uiz" => ("uint32_t", &["double"]),
        "d2ulz" => ("uint64_t", &["double"]),
        "d2lz" => ("int64_t", &["double"]),
        "f2ulz" => ("uint64_t", &["float"]),
        "f2lz" => ("int64_t", &["float"]),
        "d2f" => ("float", &["double"]),
        "f2d" => ("double", &["float"]),
        "uidiv" | "uidivmod" => ("uint32_t", &["uint32_t", "uint32_t"]),
        "idiv" | "idivmod" => ("int32_t", &["int32_t", "int32_t"]),
        "uldivmod" => ("uint64_t", &["uint64_t", "uint64_t"]),
        "ldivmod" => ("int64_t", &["int64_t", "int64_t"]),
        _ => panic!("`{name}` has no signature"),
    }
}

/// Returns words of edge values of a type of C.
fn edges(ty: &str) -> Vec<u64> {
    match ty {
        "double" => {
            let small = [0, 1, 2, 0x034, 0x1FF, 0x3CA, 0x3FE, 0x3FF, 0x400, 0x41D];
            let large = [0x41E, 0x434, 0x43D, 0x5F0, 0x634, 0x7FE, 0x7FF];
            let mantissas = [0, 1, 3, 0x5555, 0x8000_0000, 0x5_5555_5555_5555, 0xF_FFFF_FFFF_FFFF];
            let sizes = small.iter().chain(&large);
            let all = sizes.flat_map(|size| mantissas.map(|it| *size << 52 | it));
            // Sums and differences of them have all signs.
            all.enumerate().map(|(at, it)| it | (at as u64 & 1) << 63).collect()
        }
        "float" => {
            let sizes = [0, 1, 2, 0x3F, 0x7E, 0x7F, 0x80, 0x9E, 0x9F, 0xBE, 0xC0, 0xFE, 0xFF];
            let all =
                sizes.iter().flat_map(|it| [0, 1, 0x2A_AAAA, 0x7F_FFFF].map(|m| it << 23 | m));
            all.flat_map(|it| [it, it | 1 << 31]).collect()
        }
        _ => {
            let small = [1, 2, 3, 7, 10, 0x7FFF, 0xFFFF, 0x5555_5555, 0x7FFF_FFFF, 0x8000_0000];
            let large =
                [0xFFFF_FFFF, 1 << 32, 0x5555_5555_5555_5555, i64::MAX as u64, 1 << 63, u64::MAX];
            // No divisor is zero.
            let fits = |it: &u64| !ty.contains("32") || *it as u32 != 0;
            small.iter().chain(&large).copied().filter(fits).collect()
        }
    }
}

/// True if the operands are no subnormal doubles, and the result of arithmetic is none.
fn is_normal(name: &str, words: &[u64]) -> bool {
    let numbers: Vec<f64> = words.iter().map(|it| f64::from_bits(*it)).collect();
    let result = match (name, &numbers[..]) {
        ("__aeabi_dadd", [x, y]) => x + y,
        ("__aeabi_dsub", [x, y]) => x - y,
        ("__aeabi_dmul", [x, y]) => x * y,
        ("__aeabi_ddiv", [x, y]) => x / y,
        _ => 1.0,
    };
    let (_, parameters) = signature(name);
    let are = parameters.iter().zip(&numbers).all(|(ty, it)| *ty != "double" || !it.is_subnormal());
    are && !result.is_subnormal()
}

/// Edge values of all functions, on each library.
#[test]
fn functions_take_no_more_than_their_figures() {
    for toolchain in [ARM, BARE_A9, CORTEX_M4F].iter().filter(|it| it.is_there()) {
        let processor = processor(toolchain).expect("the model has it");
        let of = |name: &str, zero, numbers| {
            cost(processor, name, Known { bytes: None, zero }, 0, numbers).map(|it| it.instructions)
        };
        let figure = |name: &str, numbers| of(name, false, numbers);
        let all: Vec<&str> = FUNCTIONS.iter().map(|it| it.0).collect();
        let all: Vec<&str> = all
            .into_iter()
            .filter(|it| figure(it, Numbers::Any).is_some() && *it != "fmodf")
            .collect();
        let mut text = format!(
            "#include <math.h>\n#include <stdint.h>\n#include <stdlib.h>\n#include <string.h>\n{MARKS}"
        );
        let (mut main, mut calls) = (String::new(), Vec::new());
        for (at, name) in all.iter().enumerate() {
            let (result, parameters) = signature(name);
            if name.starts_with("__") {
                let list = parameters.join(", ");
                text +=
                    &format!("__attribute__((pcs(\"aapcs\"))) extern {result} {name}({list});\n");
            }
            let mut call = format!(
                "static void call_{at}(void)\n{{\n    bench_begin();\n    r_{at} = {name}("
            );
            let mut reads = String::new();
            for (n, ty) in parameters.iter().enumerate() {
                text += &format!("static volatile {ty} p_{at}_{n};\n");
                call += &format!("{}p_{at}_{n}", if n > 0 { ", " } else { "" });
                let word = if *ty == "float" { "uint32_t" } else { "uint64_t" };
                let value = match *ty {
                    "double" | "float" => format!(
                        "{word} w = ({word})words[i_{n}]; {ty} v; (void)memcpy(&v, &w, sizeof(v)); p_{at}_{n} = v;"
                    ),
                    _ => format!("p_{at}_{n} = ({ty})words[i_{n}];"),
                };
                reads += &format!("{{ {value} }} ");
            }
            text += &format!(
                "static volatile {result} r_{at};\n{call});\n    bench_end();\n    (void)r_{at};\n}}\n"
            );
            let words = edges(parameters[0]);
            let list: Vec<String> = words.iter().map(|it| format!("UINT64_C({it})")).collect();
            let count = words.len();
            main += &format!("    {{ static const uint64_t words[] = {{{}}};\n", list.join(", "));
            for n in 0..parameters.len() {
                main += &format!("    for (int i_{n} = 0; i_{n} < {count}; i_{n}++)\n");
            }
            main += &format!("    {{ {reads} call_{at}(); }} }}\n");
            match parameters.len() {
                1 => calls.extend(words.iter().map(|x| (at, vec![*x]))),
                _ => calls.extend(
                    words.iter().flat_map(|x| words.iter().map(move |y| (at, vec![*x, *y]))),
                ),
            }
        }
        text += &format!("int main(void)\n{{\n{main}    exit(0);\n}}\n");
        let (counts, callers) = counted(toolchain, &text, all.len());
        assert_eq!(counts.len(), calls.len());
        let mut most = vec![[0_u64; 2]; all.len()];
        let mut with_zero = vec![0_u64; all.len()];
        for ((at, words), count) in calls.iter().zip(&counts) {
            let count = count.saturating_sub(callers[*at]);
            most[*at][0] = most[*at][0].max(count);
            if is_normal(all[*at], words) {
                most[*at][1] = most[*at][1].max(count);
            }
            if matches!(words[..], [_, 0]) {
                with_zero[*at] = with_zero[*at].max(count);
            }
        }
        for (name, most) in all.iter().zip(with_zero) {
            let figure = of(name, true, Numbers::Any).expect("a figure");
            assert!(most <= figure, "{processor:?}: {name} with a zero takes {most}, not {figure}");
        }
        for (name, most) in all.iter().zip(most) {
            for (numbers, most) in [Numbers::Any, Numbers::Normal].into_iter().zip(most) {
                let figure = figure(name, numbers).expect("a figure");
                assert!(
                    most <= figure,
                    "{processor:?}: {name} of {numbers:?} takes {most}, not {figure}"
                );
            }
        }
    }
}

fn of_bytes(bytes: Option<u64>) -> Known {
    Known { bytes, zero: false }
}

/// All alignments of both memories, and all lengths up to some lines of a cache.
#[test]
fn copies_take_no_more_than_their_figures() {
    const LENGTHS: usize = 300;
    const COPIES: [(&str, &str); 4] = [
        ("memcpy", "to + at % 8, from + at / 8"),
        ("memmove", "to + at % 8, to + 16 + at / 8"),
        ("memmove", "to + 16 + at % 8, to + at / 8"),
        ("memset", "to + at % 8, at / 8"),
    ];
    for toolchain in [ARM, BARE_A9, CORTEX_M4F].iter().filter(|it| it.is_there()) {
        let processor = processor(toolchain).expect("the model has it");
        let mut text = format!(
            "#include <stdint.h>\n#include <stdlib.h>\n#include <string.h>\n{MARKS}\
             static volatile int at;\nstatic volatile size_t length;\n\
             static double to_words[64], from_words[64];\n"
        );
        let mut main = String::new();
        for (index, (name, arguments)) in COPIES.iter().enumerate() {
            text += &format!(
                "static void call_{index}(void)\n{{\n    char *to = (char *)to_words, *from = (char *)from_words;\n    \
                 (void)to;\n    (void)from;\n    bench_begin();\n    (void){name}({arguments}, length);\n    bench_end();\n}}\n"
            );
            main += &format!(
                "    for (at = 0; at < 64; at++) {{\n        for (length = 0; length < {LENGTHS}; length++) {{\n            \
                 call_{index}();\n        }}\n    }}\n"
            );
        }
        text += &format!("int main(void)\n{{\n{main}    exit(0);\n}}\n");
        let (counts, callers) = counted(toolchain, &text, COPIES.len());
        let per = 64 * LENGTHS;
        assert_eq!(counts.len(), COPIES.len() * per);
        for (at, count) in counts.iter().enumerate() {
            let (name, length) = (COPIES[at / per].0, at % LENGTHS);
            let count = count.saturating_sub(callers[at / per]);
            let figure = cost(processor, name, of_bytes(Some(length as u64)), 0, Numbers::Any);
            let figure = figure.expect("a figure").instructions;
            assert!(
                count <= figure,
                "{processor:?}: {name} of {length} bytes takes {count}, not {figure}"
            );
        }
    }
}

#[test]
fn copies_cost_their_bytes_and_unknown_functions_have_no_cost() {
    let of = |name, bytes| {
        cost(Processor::M4f, name, of_bytes(bytes), 0, Numbers::Any).map(|it| it.instructions)
    };
    assert_eq!([of("memcpy", Some(8)), of("memcpy", None)], [Some(68), None]);
    assert_eq!(quotient(std::f64::consts::TAU), 1023);
    assert_eq!([quotient(0.0), quotient(f64::from_bits(1)), quotient(f64::NAN)], [PLACES; 3]);
    assert_eq!(["__aeabi_uidiv", "printf"].map(|it| of(it, Some(1))), [None; 2]);
}
