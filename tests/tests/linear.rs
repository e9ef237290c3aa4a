//! The table of linear algebra: every routine, type and size has the bits of nalgebra in the interpreter and in C. The
//! C is compiled by gcc and clang at -O0 and -O3, under sanitizers, and for the Cortex-A9 with NEON and without; sizes
//! between those at which kernels change in one of these, optimised. Matrices are random, graded, singular and tied,
//! and have NaN, infinities and zeros.

use std::sync::OnceLock;
use std::thread;

use bessemer_codegen::compile::Compiled;
use bessemer_interpret::Interpreter;
use bessemer_ir::{Float, Function, FunctionId, Mode, Module, Scalar, Type};
use bessemer_tests::process::{Process, at_once, lay_out};
use bessemer_tests::random::Random;
use bessemer_tests::store::once;
use bessemer_tests::toolchain::{self, Toolchain, run};
use bessemer_tests::{compiled, harness, texts, turn};
use linear::{CASES, OTHER_SIZES};

/// Calls of each routine.
const CALLS: usize = 24;

/// Number of consecutive sizes of which a leg takes one, unless the run is full.
const SHARED: usize = 40;

/// Calls of each routine of the other sizes: one of each kind.
const FEWER_CALLS: usize = 6;

/// Class of the elements of a call's matrices.
#[derive(Clone, Copy, Debug, Hash)]
enum Kind {
    /// Between −1 and 1.
    Uniform,
    /// Symmetric and positive definite.
    Definite,
    /// Elements of very different sizes.
    Graded,
    /// The last column is the first.
    Singular,
    /// Small whole numbers: ties between pivots, exact zeros of either sign.
    Whole,
    /// A few elements are zero, NaN, infinite or tiny.
    Special,
}

const KINDS: [Kind; 6] =
    [Kind::Uniform, Kind::Definite, Kind::Graded, Kind::Singular, Kind::Whole, Kind::Special];

const SPECIALS: [f64; 8] =
    [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 5e-324, 1e-40, f64::MAX];

fn elements(kind: Kind, rows: usize, cols: usize, random: &mut Random) -> Vec<f64> {
    let mut list: Vec<f64> = (0..rows * cols)
        .map(|index| match kind {
            Kind::Graded => random.unit() * 10f64.powi((index % rows) as i32 % 16 - 8),
            Kind::Whole => [0.0, -0.0, 1.0, -1.0, 2.0][random.below(5)],
            _ => random.unit(),
        })
        .collect();
    match kind {
        Kind::Definite if rows == cols => {
            for row in 0..rows {
                for col in 0..row {
                    list[col + rows * row] = list[row + rows * col];
                }
                list[row + rows * row] += rows as f64;
            }
        }
        Kind::Singular => {
            let first = list[..rows].to_vec();
            list[rows * (cols - 1)..].copy_from_slice(&first);
        }
        Kind::Special => {
            for _ in 0..1 + random.below(3) {
                let at = random.below(list.len());
                list[at] = SPECIALS[random.below(SPECIALS.len())];
            }
        }
        _ => {}
    }
    list
}

/// The words of an argument.
fn argument(module: &Module, ty: &Type, kind: Kind, random: &mut Random) -> Vec<u64> {
    let word = |ty: &Type, value: f64| match ty.as_float() {
        Some(Float::F32) => u64::from((value as f32).to_bits()),
        _ => value.to_bits(),
    };
    match *ty {
        Type::Matrix { element: Scalar::Float(float), rows, cols } => {
            let element = Type::Scalar(Scalar::Float(float));
            let list = elements(kind, rows as usize, cols as usize, random);
            list.into_iter().map(|value| word(&element, value)).collect()
        }
        _ => module
            .leaves(ty)
            .iter()
            .map(|leaf| match leaf.as_float() {
                Some(_) => word(leaf, random.unit()),
                None => random.below(2) as u64,
            })
            .collect(),
    }
}

/// A routine, its calls, and what Rust makes of them.
#[derive(Hash)]
struct Case {
    name: String,
    id: FunctionId,
    /// True if every compiler compiles it.
    everywhere: bool,
    calls: Vec<(Kind, Vec<Vec<u64>>)>,
    native: Vec<Vec<u64>>,
    /// The types of the words that come out.
    leaves: Vec<Type>,
}

impl Case {
    /// The module: its routines have one size, and their C is in one file, which needs all of their kernels.
    fn size(&self) -> &str {
        self.name.rsplit_once("::").map_or("", |(module, _)| module)
    }
}

/// The package, compiled once.
fn linear_routines() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(|| compiled("linear"))
}

fn cases(compiled: &Compiled) -> Vec<Case> {
    let module = &compiled.module;
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let is = |native: &linear::Case, function: &Function| {
        function.name == native.name && function.module == native.module
    };
    let mut cases = Vec::new();
    let everywhere = CASES.into_iter().flatten().copied().flatten().map(|native| (native, true));
    let once = OTHER_SIZES.iter().copied().flatten().map(|native| (native, false));
    for (native, everywhere) in everywhere.chain(once) {
        let name = format!("{}::{}", native.module, native.name);
        let index = module.functions.iter().position(|function| is(native, function));
        let id = FunctionId(index.unwrap_or_else(|| panic!("`{name}` was not compiled")) as u32);
        let function = &module.functions[id.index()];
        let mut leaves = module.leaves(&function.result);
        for local in function.parameters().iter().filter(|local| local.mode == Mode::RefMut) {
            leaves.extend(module.leaves(&local.ty));
        }
        let calls: Vec<_> = (0..if everywhere { CALLS } else { FEWER_CALLS })
            .map(|index| {
                let kind = KINDS[index % KINDS.len()];
                let words = function.parameters().iter();
                (kind, words.map(|it| argument(module, &it.ty, kind, &mut random)).collect())
            })
            .collect();
        let run = |(_, call): &(Kind, Vec<Vec<u64>>)| {
            let (mut words, mut out) = (call.iter().flatten().copied(), Vec::new());
            (native.run)(&mut || words.next().expect("a word"), &mut |word| out.push(word));
            out
        };
        let native = calls.iter().map(run).collect();
        cases.push(Case { name, id, everywhere, calls, native, leaves });
    }
    cases
}

fn agree(leg: &str, case: &Case, index: usize, found: &[u64]) {
    let native = &case.native[index];
    let same = native.iter().zip(found).zip(&case.leaves).all(|((a, b), ty)| {
        a == b
            || match ty.as_float() {
                Some(Float::F64) => f64::from_bits(*a).is_nan() && f64::from_bits(*b).is_nan(),
                Some(Float::F32) => {
                    f32::from_bits(*a as u32).is_nan() && f32::from_bits(*b as u32).is_nan()
                }
                None => false,
            }
    });
    let (kind, call) = &case.calls[index];
    assert!(
        same && native.len() == found.len(),
        "{} in {leg}, {kind:?}\nof    {call:x?}\nRust  {native:x?}\nfound {found:x?}",
        case.name
    );
}

#[test]
fn the_interpreter_agrees() {
    let compiled = linear_routines();
    let cases = cases(compiled);
    let calls: usize = cases.iter().map(|case| case.calls.len()).sum();
    println!("{} routines, {calls} calls", cases.len());
    let mut interpreter = Interpreter::new(&compiled.module);
    for case in &cases {
        let parameters = compiled.module.functions[case.id.index()].parameters();
        for (index, (_, call)) in case.calls.iter().enumerate() {
            let mut arguments = call.clone();
            let mut found =
                interpreter.call(case.id, &mut arguments).unwrap_or_else(|stop| panic!("{stop}"));
            for (local, words) in parameters.iter().zip(&arguments) {
                if local.mode == Mode::RefMut {
                    found.extend(words);
                }
            }
            agree("interpreter", case, index, &found);
        }
    }
}

fn run_c(compiled: &Compiled, cases: &[&Case], toolchain: &Toolchain, flags: &[&str]) {
    let leg = format!("{} {}", toolchain.name(), flags.join(" "));
    let params = |id: FunctionId| compiled.module.functions[id.index()].params;
    let ids: Vec<_> = cases.iter().map(|case| (case.id, params(case.id))).collect();
    let main = harness::programs(&compiled.explicit, &ids);
    let content = (texts(&compiled.files), &main, cases, toolchain);
    once(&leg, &content, || ask_c(compiled, cases, toolchain, flags, &main, &leg));
}

/// The calls of the cases, of their C with `main` around it.
fn ask_c(
    compiled: &Compiled,
    cases: &[&Case],
    toolchain: &Toolchain,
    flags: &[&str],
    main: &str,
    leg: &str,
) {
    let mut process = Process::run(compiled, main, toolchain, flags)
        .unwrap_or_else(|error| panic!("{leg}: {error}"));
    for (at, case) in cases.iter().enumerate() {
        let calls: Vec<_> = case.calls.iter().map(|(_, call)| call).collect();
        let taken = calls.iter().map(|call| 1 + call.iter().flatten().count());
        let together = at_once(taken.max().unwrap_or_default().max(1 + case.leaves.len()));
        for (batch, calls) in calls.chunks(together).enumerate() {
            let died = |error| -> ! { panic!("{leg}, {}: {error}", case.name) };
            process.ask(at, calls).unwrap_or_else(|error| died(error));
            for index in (batch * together..).take(calls.len()) {
                let found = process.receive(1 + case.leaves.len());
                let found = found.unwrap_or_else(|error| died(error));
                assert_eq!(found[0], 0, "{leg}, {}", case.name);
                agree(leg, case, index, &found[1..]);
            }
        }
    }
}

#[test]
fn the_c_agrees() {
    let compiled = linear_routines();
    let cases = cases(compiled);
    let chosen = |wanted: &dyn Fn(&Case) -> bool| -> Vec<&Case> {
        cases.iter().filter(|case| wanted(case)).collect()
    };
    let (all, most) = (chosen(&|_| true), chosen(&|case| case.everywhere));
    let inverses = chosen(&|case| case.name.ends_with("::inverse"));
    let with = |compiler: &str, level: u32| -> Vec<Toolchain> {
        let is = |it: &Toolchain| it.compiler == compiler && it.level == level;
        toolchain::all().into_iter().filter(is).collect()
    };
    let (gcc, clang, target) = ("gcc", "clang", "arm-linux-gnueabihf-gcc");
    let sanitized = &["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-w"][..];
    let avx2 = |flags: &'static [&'static str]| if toolchain::has_avx2() { flags } else { &[] };
    // Kernels have forms for each width of vectors. gcc's are those that any machine has, and the widest for
    // inverses, which shuffle them; on the target plain C99, and loads of NEON, which tiles have forms of their own for.
    let mut legs = vec![
        // The other sizes where it costs least: one optimised build, without the sanitizers.
        (with(gcc, 3), &[][..], &all),
        (with(clang, 3), avx2(&["-mavx2"]), &most),
        // gcc's least optimised code is the sanitized one.
        (with(gcc, 0), sanitized, &most),
    ];
    for flags in turn::one_of(vec![&[][..], &["-mfpu=neon-vfpv3"]]) {
        legs.push((with(target, 2), flags, &most));
    }
    if toolchain::has_avx2() {
        legs.push((with(gcc, 2), &["-march=native"], &inverses));
    }
    if turn::is_full() {
        legs.push((with(clang, 0), &[], &most));
    }
    thread::scope(|scope| {
        for (number, (toolchains, flags, cases)) in legs.into_iter().enumerate() {
            // Legs that follow one another take other sizes, so that none of these is left out by all.
            let sizes: Vec<&[&Case]> =
                cases.chunk_by(|one, next| one.size() == next.size()).collect();
            let own: Vec<&Case> = sizes
                .chunks(SHARED)
                .flat_map(|some| turn::some_of_shifted(some.to_vec(), 1, number))
                .flatten()
                .copied()
                .collect();
            for toolchain in toolchains {
                let cases = own.clone();
                scope.spawn(move || run_c(compiled, &cases, &toolchain, flags));
            }
        }
    });
}

/// Declarations that a compiler for i386 needs, for which Debian has no headers beside those of ARM.
const LIBRARY: [(&str, &str); 2] = [
    (
        "math.h",
        "#define NAN __builtin_nanf(\"\")\n#define isfinite(x) __builtin_isfinite(x)\n\
         #define isinf(x) __builtin_isinf_sign(x)\n#define isnan(x) __builtin_isnan(x)\n\
         double sqrt(double);\ndouble fabs(double);\nfloat sqrtf(float);\nfloat fabsf(float);\n\
         double copysign(double, double);\nfloat copysignf(float, float);\n\
         #define INFINITY __builtin_inff()\ndouble floor(double);\ndouble trunc(double);\n\
         float floorf(float);\nfloat truncf(float);\n",
    ),
    ("string.h", "#include <stddef.h>\nvoid *memcpy(void *, const void *, size_t);\n"),
];

/// The files of the linear algebra, which differ by size, are looked at in so many turns.
const TURNS: usize = 4;

/// A `double` in a struct or an array is at a multiple of 4 there: vectors must not claim more.
#[test]
fn vectors_ask_for_no_more_than_numbers_have() {
    let host = toolchain::host();
    let Some(gcc) = host.iter().find(|it| it.compiler == "gcc") else { return };
    once("claims of vectors", &texts(&linear_routines().files), || vectors_claim_little(gcc));
}

fn vectors_claim_little(gcc: &Toolchain) {
    let folder = lay_out(linear_routines()).expect("the C");
    for (name, text) in LIBRARY {
        std::fs::write(folder.path().join(name), text).expect("a header");
    }
    // The widest of these is of every run: whatever is wrong with narrower vectors is wrong with those, too.
    let narrow = turn::one_of(vec!["-msse2", "-mavx2"]);
    for (number, vectors) in narrow.into_iter().chain(["-mavx512f"]).enumerate() {
        let part = folder.sources().len().div_ceil(TURNS);
        let parts: Vec<_> = folder.sources().chunks(part).collect();
        let sources = turn::some_of_shifted(parts, 1, number);
        let mut command = gcc.command();
        command.args(["-m32", vectors, "-mfpmath=sse", "-ffreestanding", "-fsyntax-only"]);
        command.args(["-Wcast-align=strict", "-I"]).arg(folder.path()).args(sources.concat());
        run(&mut command).unwrap_or_else(|said| panic!("{said}"));
    }
}
