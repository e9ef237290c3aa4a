//! Random programs for `cargo xtask fuzz`, most of which aim at the proofs, and some at the order of evaluation. Each
//! difference becomes a file.
//!
//! `BESSEMER_FUZZ` says how many, `BESSEMER_RANDOM_FROM` from which seed.

use std::time::Instant;

use bessemer_ir::used;
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

#[test]
#[ignore = "it takes as long as it is told: cargo xtask fuzz"]
fn as_many_as_asked() {
    let number = |name: &str| std::env::var(name).ok().and_then(|it| it.parse::<u64>().ok());
    let (asked, from) = (number("BESSEMER_FUZZ").unwrap_or(1), number("BESSEMER_RANDOM_FROM"));
    let workspace = Workspace::with_source("").expect("a workspace");
    workspace.set_profiles(PROFILES).expect("its manifest");
    let mut reference = Reference::new();
    let (mut all, start) = (Reached::default(), Instant::now());
    for seed in from.unwrap_or_default().. {
        if all.programs >= asked as usize {
            break;
        }
        let mut batch = match seed % OF {
            0 => Batch::new(seed, PROGRAMS),
            1 => Batch::beside(seed, BESIDE),
            2 => Batch::iterating(seed, BESIDE),
            _ => Batch::aimed(seed, AIMED, INSTANCES),
        };
        batch.is_of_many = true;
        batch.of_one = !seed.is_multiple_of(INSTANTIATED);
        let reached = attack(&workspace, seed, &mut batch);
        let left: Vec<_> = batch.left().into_iter().map(|it| &it.name).collect();
        for program in &batch.programs {
            reference.count(&program.text, left.contains(&&program.name));
        }
        let wrong = wrong(&batch, &reached.differences);
        for program in shrink::shrunk(&workspace, &wrong) {
            let file = found::keep(&program, seed);
            println!("different: {}", file.display());
        }
        all.add(reached);
        let seconds = start.elapsed().as_secs_f64();
        println!(
            "{} of {asked} programs, {} calls ({} faults), {:.1} programs/s, {:.0} calls/s, {} refused, {} different",
            all.programs,
            all.calls,
            all.faults,
            all.programs as f64 / seconds,
            all.calls as f64 / seconds,
            all.refused,
            all.differences.len()
        );
    }
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
