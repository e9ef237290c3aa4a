//! Runs recursive stages on a large stack.
//!
//! A sum of two thousand terms is a tree of two thousand levels, and each stage recurses once per level. Callers of a
//! stage use this module.

use std::cell::Cell;
use std::{panic, thread};

/// Stack size, bytes. Only used pages take memory: some ten kilobytes per level in builds without optimisation.
const STACK: usize = 1 << 30;

thread_local! {
    static IS_DEEP: Cell<bool> = const { Cell::new(false) };
}

/// Runs the work on a large stack of its own, unless it already runs on one. The stack is a thread's, since a crate
/// that grows stacks takes longer to build than most dependencies.
///
/// # Panics
/// If the machine has no room for a thread; where the work does.
pub fn deep<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    if IS_DEEP.get() {
        return work();
    }
    let within = || {
        IS_DEEP.set(true);
        work()
    };
    thread::scope(|scope| {
        let spawned = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, within);
        let done = spawned.expect("a machine has room for a thread").join();
        done.unwrap_or_else(|panic| panic::resume_unwind(panic))
    })
}
