//! Random programs for `cargo xtask fuzz`, most of which aim at the proofs, and some at the order of evaluation. Each
//! difference becomes a file.
//!
//! `BESSEMER_FUZZ` says how many, `BESSEMER_RANDOM_FROM` from which seed.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard};
use std::thread;
use std::time::Instant;

use bessemer_ir::used;
use bessemer_tests::root;
use bessemer_tests::workspace::Workspace;

use super::reference::Reference;
use super::{Batch, PROGRAMS, Reached, attack, found, shrink, wrong};

/// Texts of a batch that aims at the proofs, and instances of each: as many as pay for a build and leave it short.
const AIMED: usize = 16;
const INSTANCES: usize = 40;

/// Number of batches of which one has programs of every kind, one has bodies whose operands write, and one has bodies
/// with explicit `next` calls.
const OF: u64 = 12;
const BESIDE: usize = 200;
/// In one batch of so many rustc gets the instances of each text, and in the others one function of each.
const INSTANTIATED: u64 = 8;

/// Many builds of other programs each: macros that read all of them are worth optimising, and notes for the next build are not
/// worth taking.
const PROFILES: &str = "\
[profile.dev.package.models]
incremental = false
[profile.dev.package.bessemer-macros]
opt-level = 2
[profile.dev.package.quote]
opt-level = 2
[profile.dev.package.proc-macro2]
opt-level = 2
";

/// A run: its workers take seeds, and add what they reached.
struct Run {
    wanted: usize,
    seed: AtomicU64,
    start: Instant,
    reached: Mutex<(Reached, Reference)>,
}

impl Run {
    /// Runs batches until there are as many programs as requested. Each worker has a workspace and a target folder of its own:
    /// cargo runs one build at a time in a folder.
    fn work(&self, worker: usize) {
        let target = root().join(format!("target/fuzz/{worker}"));
        let workspace = Workspace::with_source("").and_then(|it| it.with_target(target));
        let workspace = workspace.expect("a workspace");
        workspace.set_profiles(PROFILES).expect("its manifest");
        while self.reached().0.programs < self.wanted {
            let seed = self.seed.fetch_add(1, Ordering::Relaxed);
            let mut batch = batch(seed);
            let reached = attack(&workspace, seed, &mut batch);
            let wrong = wrong(&batch, &reached.differences);
            for program in shrink::shrunk(&workspace, &wrong) {
                let file = found::keep(&program, seed);
                println!("different: {}", file.display());
            }
            self.add(&batch, reached);
        }
    }

    fn reached(&self) -> MutexGuard<'_, (Reached, Reference)> {
        self.reached.lock().expect("no worker failed")
    }

    fn add(&self, batch: &Batch, reached: Reached) {
        let mut guard = self.reached();
        let (all, reference) = &mut *guard;
        let left: BTreeSet<_> = batch.left().into_iter().map(|it| &it.name).collect();
        for program in &batch.programs {
            reference.count(&program.text, left.contains(&program.name));
        }
        all.add(reached);
        let seconds = self.start.elapsed().as_secs_f64();
        println!(
            "{} of {} programs, {} calls ({} faults), {:.1} programs/s, {:.0} calls/s, {} refused, {} different",
            all.programs,
            self.wanted,
            all.calls,
            all.faults,
            all.programs as f64 / seconds,
            all.calls as f64 / seconds,
            all.refused,
            all.differences.len()
        );
    }
}

fn batch(seed: u64) -> Batch {
    let mut batch = match seed % OF {
        0 => Batch::new(seed, PROGRAMS),
        1 => Batch::beside(seed, BESIDE),
        2 => Batch::iterating(seed, BESIDE),
        _ => Batch::aimed(seed, AIMED, INSTANCES),
    };
    batch.is_of_many = true;
    batch.of_one = !seed.is_multiple_of(INSTANTIATED);
    batch
}

#[test]
#[ignore = "it takes as long as it is told: cargo xtask fuzz"]
fn as_many_as_asked() {
    let number = |name: &str| std::env::var(name).ok().and_then(|it| it.parse::<u64>().ok());
    let run = Run {
        wanted: number("BESSEMER_FUZZ").unwrap_or(1) as usize,
        seed: AtomicU64::new(number("BESSEMER_RANDOM_FROM").unwrap_or_default()),
        start: Instant::now(),
        reached: Mutex::new((Reached::default(), Reference::new())),
    };
    let (workers, run_by) = (thread::available_parallelism().map_or(1, usize::from), &run);
    thread::scope(|scope| {
        (0..workers).for_each(|worker| _ = scope.spawn(move || run_by.work(worker)));
    });
    let (all, reference) = run.reached.into_inner().expect("no worker failed");
    println!("\nhow often each rule decided something");
    for (rule, count) in used::counts() {
        println!("{count:>12}  {rule}");
    }
    println!(
        "\nhow many programs have each method, statement and attribute of the reference, and how many of these ran"
    );
    print!("{}", reference.report());
    let texts: Vec<_> = all.differences.iter().map(|it| it.text.as_str()).collect();
    assert!(texts.is_empty(), "{}", texts.join("\n\n"));
}
