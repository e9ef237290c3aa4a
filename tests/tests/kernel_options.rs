//! Options of kernels in programs. The user's own functions can replace kernels, with equal results, and be removed
//! again. Threads change no bit; a code budget makes objects smaller and changes no bit. The fast mode: `fast_mode.rs`.

use std::process::Command;

use bessemer_backend::c::Options;
use bessemer_backend::kernels::{self, Mode, Processors, Tuning, replace};
use bessemer_ir::{Float, Kernel, KernelRoutine};
use bessemer_tests::kernels::files;
use bessemer_tests::store::once;
use bessemer_tests::{texts, turn};

/// The words that a program of `tests/kernels` prints, with these kernels; none if it does not link.
fn words(kernels: &[Kernel], program: &str, options: &Options, flags: &[&str]) -> Option<Vec<u64>> {
    let folder = tempfile::tempdir().expect("a folder");
    let own = bessemer_tests::root().join("tests/kernels");
    let mut sources = vec![own.join(program), own.join("own_product.c")];
    for file in files(kernels, options) {
        let path = folder.path().join(&file.name);
        std::fs::write(&path, &file.text).expect("a folder of ours");
        if file.name.ends_with(".c") {
            sources.push(path);
        }
    }
    let program = folder.path().join("program");
    let mut command = Command::new("gcc");
    command.args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-I"]);
    command.arg(folder.path()).arg("-I").arg(&own).args(sources);
    let output = command.arg("-o").arg(&program).args(flags).arg("-lm").output().ok()?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        // A library may be missing, and nothing else.
        assert!(flags.iter().any(|flag| flag.starts_with("-l")), "{said}");
        return None;
    }
    let output = Command::new(program).output().expect("a program of ours");
    assert!(output.status.success());
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    Some(text.lines().map(|line| line.parse().expect("a word of ours")).collect())
}

fn kernel(routine: KernelRoutine, element: Float, dims: &[u32]) -> Kernel {
    Kernel::new(routine, element, dims).expect("as many as it has")
}

/// The words of the two products, with these replacements.
fn products(table: &str, flags: &[&str]) -> Option<Vec<u64>> {
    let kernels = [
        kernel(KernelRoutine::Product, Float::F64, &[20; 3]),
        kernel(KernelRoutine::Product, Float::F32, &[9; 3]),
    ];
    let replacements = replace::parse(table).expect("a sound table");
    words(&kernels, "products.c", &Options { replacements, ..Options::default() }, flags)
}

#[test]
fn an_own_function_and_a_library_stand_for_kernels() {
    let table = bessemer_tests::root().join("tests/kernels/replacements.json");
    let table = std::fs::read_to_string(table).expect("in the repository");
    let Some(kernels) = products("[]", &[]) else {
        println!("left out: there is no gcc");
        return;
    };
    let back = products(&table, &["-DBESSEMER_OWN_KERNELS"]);
    assert_eq!(back.as_ref(), Some(&kernels), "the kernels come back");

    // The own function alone: nothing is large enough for the library.
    let own = products(&table.replacen("16", "99", 1), &[]);
    assert_eq!(own.as_ref(), Some(&kernels), "an own function in the kernel's order has its bits");

    let Some(library) = products(&table, &["-lopenblas"]) else {
        println!("left out: there is no CBLAS");
        return;
    };
    assert_eq!(library[400..], kernels[400..]);
    for (word, ours) in library.iter().zip(&kernels).take(400) {
        let (theirs, ours) = (f64::from_bits(*word), f64::from_bits(*ours));
        // Twenty products of numbers below a half, in any order, fused or not.
        assert!((theirs - ours).abs() <= 20.0 * 20.0 * 0.25 * f64::EPSILON, "{theirs} {ours}");
    }
}

#[test]
fn threads_change_no_bit() {
    let kernels = [
        kernel(KernelRoutine::Inverse, Float::F64, &[100]),
        kernel(KernelRoutine::Inverse, Float::F32, &[50]),
        kernel(KernelRoutine::Solve, Float::F64, &[90, 50]),
        kernel(KernelRoutine::Product, Float::F64, &[65, 90, 70]),
    ];
    let threaded = files(&kernels, &Options::default());
    once("threads", &texts(&threaded), || each_number_of_threads_agrees(&kernels));
}

fn each_number_of_threads_agrees(kernels: &[Kernel]) {
    let run = |flags: &[&str]| words(kernels, "threads.c", &Options::default(), flags);
    let Some(alone) = run(&[]) else {
        println!("left out: there is no gcc");
        return;
    };
    let threads = ["-DBESSEMER_THREADS=2U", "-DBESSEMER_THREADS=3U", "-DBESSEMER_THREADS=8U"];
    for (number, threads) in turn::one_of(threads.into_iter().enumerate().collect()) {
        for more in ways(number) {
            let found = run(&[&[threads, "-pthread"], more].concat());
            assert_eq!(found.as_ref(), Some(&alone), "{threads} {more:?}");
        }
    }
}

/// Solve, inverse, factor and products of several ways, as `solves.c` prints them.
fn solves(tuning: Tuning, flags: &[&str]) -> Option<Vec<u64>> {
    let options = Options { kernels: tuning, ..Options::default() };
    words(&of_several_ways(), "solves.c", &options, flags)
}

fn of_several_ways() -> [Kernel; 8] {
    [
        kernel(KernelRoutine::Solve, Float::F64, &[150, 1]),
        kernel(KernelRoutine::Solve, Float::F64, &[17, 1]),
        kernel(KernelRoutine::Inverse, Float::F64, &[12]),
        kernel(KernelRoutine::Cholesky, Float::F64, &[8]),
        kernel(KernelRoutine::CholeskySolve, Float::F64, &[8, 1]),
        kernel(KernelRoutine::Solve, Float::F64, &[6, 1]),
        kernel(KernelRoutine::ProductTr, Float::F64, &[6; 3]),
        kernel(KernelRoutine::TrProduct, Float::F64, &[6; 3]),
    ]
}

/// Returns the flags for the vectors of every machine, for none, and for the widest of this one. They rotate by number,
/// so that a run of a few numbers has each; a full run has all of them.
fn ways(number: usize) -> Vec<&'static [&'static str]> {
    turn::some_of_shifted(vec![&[], &["-DBESSEMER_PLAIN"], &["-march=native"]], 1, number)
}

/// Bytes of code that a kernel may have.
const BUDGETS: [u32; 5] = [4096, 2048, 1024, 512, 0];

#[test]
fn a_budget_changes_size_and_no_bit() {
    let kernels = of_several_ways();
    let of_budget = |code_bytes| {
        let tuning = Tuning { code_bytes, ..Tuning::default() };
        files(&kernels, &Options { kernels: tuning, ..Options::default() })
    };
    let usual = Tuning::default().code_bytes;
    let files: Vec<_> = BUDGETS.into_iter().chain([usual]).flat_map(of_budget).collect();
    once("budgets", &texts(&files), each_budget_agrees);
}

fn each_budget_agrees() {
    let Some(roomy) = solves(Tuning::default(), &[]) else {
        println!("left out: there is no gcc");
        return;
    };
    for (number, code_bytes) in turn::some_of(BUDGETS.into_iter().enumerate().collect(), 2) {
        let tuning = Tuning { code_bytes, ..Tuning::default() };
        for flags in ways(number) {
            assert_eq!(solves(tuning, flags).as_ref(), Some(&roomy), "{code_bytes} {flags:?}");
        }
    }
}

#[test]
fn plain_kernels_are_c99_alone_and_change_no_bit() {
    use KernelRoutine::*;
    let plain = Tuning { mode: Mode::Plain, ..Tuning::default() };
    let usual = solves(Tuning::default(), &[]);
    assert!(usual.is_none() || solves(plain, &["-march=native"]) == usual);
    // The loops that the files open with.
    assert!(usual.is_none() || solves(Tuning::default(), &["-DBESSEMER_LOOPS"]) == usual);
    let of_three = [Product, ProductTr, TrProduct, TrMul].map(|it| (it, 3));
    let of_two =
        [LuSolve, Solve, CholeskySolve, SolveLower, SolveUpper, TrSolveLower, TrSolveUpper];
    let of_two = of_two.map(|it| (it, 2));
    let of_one = [Inverse, Determinant, Cholesky, CholeskyLower].map(|it| (it, 1));
    for (routine, count) in of_three.into_iter().chain(of_two).chain(of_one) {
        for (size, element) in (1..25).flat_map(|it| [(it, Float::F32), (it, Float::F64)]) {
            let kernel = kernel(routine, element, &vec![size; count]);
            let source = kernels::source(&kernel, &plain);
            let text = source.before + &source.body;
            let other = ["#", "__", "vector_size", "_mm"].iter().find(|it| text.contains(**it));
            assert_eq!(other, None, "{}", kernel.name());
        }
    }
}

/// Checks the variants of one family of processors, rotating. They mention no other family, compile everywhere without
/// a warning, and have the same bits.
#[test]
fn the_ways_of_one_family_are_those_of_all() {
    use KernelRoutine::*;
    let families = [
        (Processors::CortexA, &["__x86_64__", "__AVX", "__SSE", "__ARM_ARCH_PROFILE"][..]),
        (Processors::CortexM, &["__x86_64__", "__AVX", "__SSE", "__ARM_NEON"]),
        (Processors::X86, &["__arm__", "__ARM_"]),
    ];
    let of_three = [Product, ProductTr, TrProduct, TrMul].map(|it| (it, 3));
    let of_two =
        [LuSolve, Solve, CholeskySolve, SolveLower, SolveUpper, TrSolveLower, TrSolveUpper];
    let of_two = of_two.map(|it| (it, 2));
    let of_one = [Inverse, Determinant, Cholesky, CholeskyLower].map(|it| (it, 1));
    let routines: Vec<_> = of_three.into_iter().chain(of_two).chain(of_one).collect();
    let families = families.into_iter().enumerate().collect();
    for (number, (processors, others)) in turn::one_of(families) {
        for mode in [Mode::Exact, Mode::Fast] {
            let tuning = Tuning { processors, mode, ..Tuning::default() };
            for (routine, count) in &routines {
                for (size, element) in (1..25).flat_map(|it| [(it, Float::F32), (it, Float::F64)]) {
                    let kernel = kernel(*routine, element, &vec![size; *count]);
                    let source = kernels::source(&kernel, &tuning);
                    assert!(!source.body.trim().is_empty(), "{} does something", kernel.name());
                    let text = source.before + &source.body;
                    let other = others.iter().find(|it| text.contains(**it));
                    assert_eq!(other, None, "{}\n{text}", kernel.name());
                }
            }
        }
        each_is_what_its_compiler_sees_of_all(&routines, processors);
        let tuning = Tuning { processors, ..Tuning::default() };
        let options = Options { kernels: tuning, ..Options::default() };
        once("ways of a family", &texts(&files(&of_several_ways(), &options)), || {
            let Some(all) = solves(Tuning::default(), &[]) else {
                println!("left out: there is no gcc");
                return;
            };
            for flags in ways(number) {
                assert_eq!(solves(tuning, flags).as_ref(), Some(&all), "{processors:?} {flags:?}");
            }
        });
    }
}

/// A kernel for one family is what a compiler for it is left with of the kernel for all, token by token. One size in twelve a run.
fn each_is_what_its_compiler_sees_of_all(
    routines: &[(KernelRoutine, usize)],
    processors: Processors,
) {
    let (compiler, flags): (_, &[&str]) = match processors {
        Processors::CortexA => ("arm-linux-gnueabihf-gcc", &["-mcpu=cortex-a9", "-mfpu=neon"]),
        Processors::CortexM => ("arm-none-eabi-gcc", &["-mcpu=cortex-m7", "-mfloat-abi=hard"]),
        _ => ("gcc", &[]),
    };
    let sizes = turn::some_of((1..25).collect(), 2);
    let each = routines.iter().flat_map(|(routine, count)| {
        sizes.iter().flat_map(|size| {
            [Float::F32, Float::F64].map(|element| kernel(*routine, element, &vec![*size; *count]))
        })
    });
    let kernels: Vec<_> = each.collect();
    for mode in [Mode::Exact, Mode::Fast] {
        let tuning = Tuning { mode, ..Tuning::default() };
        let seen = |tuning| tokens(&kernels, tuning, compiler, flags);
        let (Some(all), Some(own)) = (seen(tuning), seen(Tuning { processors, ..tuning })) else {
            println!("left out: there is no {compiler}");
            return;
        };
        assert!(all.len() > 1000 && all == own, "{processors:?} {mode:?}: {}", apart(&all, &own));
    }
}

/// Returns the preprocessed sources of kernels; none without such a compiler.
fn tokens(
    kernels: &[Kernel],
    tuning: Tuning,
    compiler: &str,
    flags: &[&str],
) -> Option<Vec<String>> {
    let folder = tempfile::tempdir().expect("a folder");
    let options = Options { kernels: tuning, ..Options::default() };
    let mut sources = Vec::new();
    for file in files(kernels, &options) {
        let path = folder.path().join(&file.name);
        std::fs::write(&path, &file.text).expect("a folder of ours");
        sources.extend(file.name.ends_with(".c").then_some(path));
    }
    let mut command = Command::new(compiler);
    command.args(["-std=c99", "-E", "-P", "-I"]).arg(folder.path()).args(flags).args(sources);
    let output = command.output().ok()?;
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8_lossy(&output.stdout);
    Some(text.split_whitespace().map(str::to_owned).collect())
}

/// Returns the first difference of two texts.
fn apart(one: &[String], other: &[String]) -> String {
    let at = one.iter().zip(other).take_while(|(one, other)| one == other).count();
    let around = |text: &[String]| {
        text[at.saturating_sub(20)..].iter().take(40).cloned().collect::<Vec<_>>().join(" ")
    };
    format!("{}\n{}", around(one), around(other))
}

#[test]
fn a_budget_makes_objects_smaller() {
    let kernels = [
        kernel(KernelRoutine::LuSolve, Float::F64, &[8, 1]),
        kernel(KernelRoutine::Solve, Float::F32, &[12, 1]),
        kernel(KernelRoutine::Solve, Float::F64, &[60, 1]),
        kernel(KernelRoutine::Inverse, Float::F64, &[9]),
        kernel(KernelRoutine::Cholesky, Float::F64, &[8]),
        kernel(KernelRoutine::CholeskySolve, Float::F64, &[14, 1]),
        kernel(KernelRoutine::Product, Float::F64, &[12; 3]),
        kernel(KernelRoutine::TrProduct, Float::F64, &[9; 3]),
    ];
    for kernel in kernels {
        let bytes = |code_bytes| object_bytes(&kernel, Tuning { code_bytes, ..Tuning::default() });
        let (Some(roomy), Some(tight)) = (bytes(8192), bytes(1024)) else {
            println!("left out: there is no gcc");
            return;
        };
        assert!(tight < roomy, "{}: {tight} of {roomy} bytes", kernel.name());
        // The estimate is one for ARM; instructions of x86-64 are longer.
        assert!(tight <= 1536 && roomy <= 10 * 1024, "{}: {tight}, {roomy} bytes", kernel.name());
    }
}

/// Bytes of machine code of a kernel in plain C.
fn object_bytes(kernel: &Kernel, tuning: Tuning) -> Option<u64> {
    let folder = tempfile::tempdir().expect("a folder");
    let options = Options { kernels: tuning, ..Options::default() };
    for file in files(std::slice::from_ref(kernel), &options) {
        std::fs::write(folder.path().join(&file.name), &file.text).expect("a folder of ours");
    }
    let mut command = Command::new("gcc");
    command.args(["-std=c99", "-O2", "-ffp-contract=off", "-DBESSEMER_PLAIN", "-c"]);
    command.arg(format!("{}.c", kernel.name())).current_dir(&folder);
    command.status().ok().filter(|status| status.success())?;
    let object = folder.path().join(format!("{}.o", kernel.name()));
    let output = Command::new("size").arg(object).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines().nth(1)?.split_whitespace().next()?.parse().ok()
}
