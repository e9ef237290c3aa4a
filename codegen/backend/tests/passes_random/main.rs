//! Random modules: the passes keep every result, every fault and every write, and leave nothing that
//! faults by itself.

mod generate;
mod tiled;
mod vectors;

use bessemer_backend::passes::{Choices, Report, check, explicit, explicit_with};
use bessemer_backend::validate::validate;
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::visit::{VisitMut, walk_stmt_mut};
use bessemer_ir::{Function, FunctionId, Local, Module, Stmt, StmtKind, Type};
use generate::Random;

/// Marks checks, to tell their faults from an operation's.
struct Mark;

impl VisitMut for Mark {
    fn stmt(&mut self, stmt: &mut Stmt) {
        if matches!(stmt.kind, StmtKind::Check { .. }) {
            stmt.span.file = 1;
        }
        walk_stmt_mut(self, stmt);
    }
}

fn arguments(module: &Module, function: usize, random: &mut Random) -> Vec<Vec<u64>> {
    let parameters = module.functions[function].parameters().to_vec();
    let words = |ty: &Type, random: &mut Random| {
        module.leaves(ty).iter().map(|leaf| random.word(leaf)).collect()
    };
    parameters.iter().map(|parameter| words(&parameter.ty, random)).collect()
}

/// NaNs are all the same.
fn canonical(words: &[u64]) -> Vec<u64> {
    let nan = |word: u64| f64::from_bits(word).is_nan() && word >> 52 & 0x7FF == 0x7FF;
    words.iter().map(|word| if nan(*word) { f64::NAN.to_bits() } else { *word }).collect()
}

#[derive(Default)]
struct Count {
    modules: usize,
    runs: usize,
    faults: usize,
    checks: usize,
    tiled: usize,
    gathered: usize,
}

/// For a look at what fails: the modules go to files.
fn show(module: &Module, name: &str) {
    if std::env::var("PASSES_SHOW").is_ok() {
        let path = std::env::temp_dir().join(name);
        std::fs::write(path, bessemer_ir::text::print(module)).expect("a file");
    }
}

/// The module after the passes: valid, explicit, and no further from it after the passes again.
fn passed(before: &Module, seed: u64, count: &mut Count) -> Module {
    show(before, "before.ir");
    let (after, report) = explicit(before.clone()).unwrap_or_else(|errors| {
        panic!("seed {seed}: {errors:#?}");
    });
    show(&after, "after.ir");
    assert_eq!(check(&after), [], "seed {seed}");
    assert_eq!(validate(&after), Ok(()), "seed {seed}");
    let (again, _) = explicit(after.clone()).expect("explicit again");
    let checks = |report: &Report| report.functions.iter().map(Vec::len).sum::<usize>();
    show(&again, "again.ir");
    assert!(again == after, "seed {seed}: not idempotent");
    count.checks += checks(&report);
    after
}

/// Compares a module before and after the passes, with these arguments of each function.
fn compare(
    seed: u64,
    before: Module,
    arguments: impl Fn(&Module, usize, &mut Random) -> Vec<Vec<u64>>,
    count: &mut Count,
) {
    if validate(&before).is_err() {
        return;
    }
    count.modules += 1;
    let mut after = passed(&before, seed, count);
    let is_tile = |local: &Local| ["tile", "part"].contains(&&*local.name);
    let has_tiles = |function: &&Function| function.locals.iter().any(is_tile);
    count.tiled += after.functions.iter().filter(has_tiles).count();
    let has_magnitude =
        |function: &&Function| function.locals.iter().any(|it| it.name == "largest");
    count.gathered += after.functions.iter().filter(has_magnitude).count();
    after.functions.iter_mut().for_each(|function| Mark.block(&mut function.body));
    // This module keeps the proved checks.
    let (kept, _) = explicit_with(before.clone(), Choices::KEPT).expect("explicit before");
    show(&kept, "kept.ir");
    assert_eq!(validate(&kept), Ok(()), "seed {seed}");
    let (mut first, mut second) = (Interpreter::new(&before), Interpreter::new(&after));
    let mut third = Interpreter::new(&kept);
    let mut random = Random::new(seed ^ 0xABCD);
    for function in 0..before.functions.len() {
        for _ in 0..12 {
            let mut given = arguments(&before, function, &mut random);
            let mut same = given.clone();
            let mut again = given.clone();
            let id = FunctionId(function as u32);
            let expected = first.call(id, &mut given);
            let found = second.call(id, &mut same);
            let proved = third.call(id, &mut again);
            count.runs += 1;
            count.faults += usize::from(expected.is_err());
            let at = format!("seed {seed} f{function}");
            agree(&at, &expected, &found);
            told_alike(&at, &expected, &proved);
            let words =
                |all: &[Vec<u64>]| all.iter().flat_map(|w| canonical(w)).collect::<Vec<_>>();
            assert_eq!(words(&given), words(&same), "{at}: what was lent");
        }
    }
}

fn agree(at: &str, expected: &Result<Vec<u64>, Stop>, found: &Result<Vec<u64>, Stop>) {
    match (expected, found) {
        (Ok(a), Ok(b)) => assert_eq!(canonical(a), canonical(b), "{at}"),
        (
            Err(Stop::Fault { fault: a, function: x, span: s }),
            Err(Stop::Fault { fault: b, function: y, span: t }),
        ) => {
            assert_eq!((a, x, s.line), (b, y, t.line), "{at}");
            assert_eq!(t.file, 1, "{at}: an operation faulted");
        }
        _ => panic!("{at}: {expected:?} became {found:?}"),
    }
}

/// Checks that both outcomes are equal, and that no removed check fails.
fn told_alike(at: &str, expected: &Result<Vec<u64>, Stop>, found: &Result<Vec<u64>, Stop>) {
    match (expected, found) {
        (Ok(a), Ok(b)) => assert_eq!(canonical(a), canonical(b), "{at}"),
        (Err(Stop::Fault { fault: a, .. }), Err(Stop::Fault { fault: b, .. })) => {
            assert_eq!(a, b, "{at}: with the checks that were left out");
        }
        _ => panic!("{at}: {expected:?} became {found:?} with the checks that were left out"),
    }
}

#[test]
fn meaning_is_kept() {
    let mut count = Count::default();
    let seeds =
        std::env::var("PASSES_SEEDS").ok().and_then(|text| text.parse().ok()).unwrap_or(400);
    let first = std::env::var("PASSES_FIRST").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
    for seed in first..first + seeds {
        compare(seed, generate::module(seed), arguments, &mut count);
    }
    let Count { modules, runs, faults, checks, .. } = count;
    println!(
        "{modules} of {seeds} modules valid, {runs} runs, {faults} faults, {checks} checks left"
    );
    assert!(modules > seeds as usize * 9 / 10, "{modules} valid modules of {seeds}");
    assert!(faults > runs / 10 && faults < runs * 9 / 10, "{faults} faults in {runs} runs");
}

#[test]
fn tiled_loops_keep_the_order_of_each_sum() {
    let mut count = Count::default();
    let seeds = std::env::var("PASSES_SEEDS").map_or(200, |text| text.parse().expect("a number"));
    for seed in 0..seeds {
        compare(seed, tiled::module(seed), |_, _, random| tiled::arguments(random), &mut count);
    }
    let Count { modules, runs, faults, tiled, .. } = count;
    println!("{modules} of {seeds} modules valid, {runs} runs, {faults} faults, {tiled} tiled");
    assert_eq!(modules, seeds as usize);
    assert!(
        tiled > modules / 2 && tiled < modules * 5 / 2,
        "{tiled} functions tiled of {modules} × 3"
    );
}

#[test]
fn gathered_statements_keep_their_values() {
    let mut count = Count::default();
    let seeds = std::env::var("PASSES_SEEDS").map_or(150, |text| text.parse().expect("a number"));
    for seed in 0..seeds {
        compare(seed, vectors::module(seed, 3), arguments, &mut count);
    }
    let Count { modules, runs, faults, gathered, .. } = count;
    println!(
        "{modules} of {seeds} modules valid, {runs} runs, {faults} faults, {gathered} gathered"
    );
    assert!(modules > seeds as usize / 2, "{modules} valid modules");
    assert!(gathered > modules / 4, "{gathered} functions gathered of {modules} × 3");
}
