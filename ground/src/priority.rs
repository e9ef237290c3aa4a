//! Priority of the thread that keeps the period over all other work of the machine, where the system allows it.
//!
//! Pages, recordings and whatever else runs must not make a period late. Without the right to it (on Linux `CAP_SYS_NICE` or a limit
//! of real-time priorities) everything runs as it did: the period is then kept as far as the machine is free.

use std::fs::File;
use std::io::Write;

#[cfg(unix)]
use thread_priority::{
    NormalThreadSchedulePolicy, RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy,
    set_thread_priority_and_policy, thread_native_id,
};

/// Puts this thread, and the processes and threads that it starts, before ordinary ones; whether the system allows that.
#[cfg(unix)]
pub fn raise() -> bool {
    let first = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    let low = ThreadPriority::Min;
    set_thread_priority_and_policy(thread_native_id(), low, first).is_ok()
}

/// Puts this thread among the ordinary ones again: for what a raised one starts and does not wait for.
#[cfg(unix)]
pub fn lower() {
    let ordinary = ThreadSchedulePolicy::Normal(NormalThreadSchedulePolicy::Other);
    // Who may raise may lower.
    let _ = set_thread_priority_and_policy(thread_native_id(), ThreadPriority::Min, ordinary);
}

/// Elsewhere nothing is requested.
#[cfg(not(unix))]
pub fn raise() -> bool {
    false
}

/// Nothing was raised.
#[cfg(not(unix))]
pub fn lower() {}

/// Guard that keeps the processors from sleeping, where the system allows it. Linux' power-management quality of service
/// withdraws the request when its file is closed.
///
/// A processor that sleeps wakes late; that of a virtual machine is given away meanwhile, and comes back after milliseconds.
pub struct Awake {
    _asked: Option<File>,
}

impl Awake {
    /// Asks for it; what the system does not allow is not missed.
    pub fn keep() -> Awake {
        // Only no wait at all, µs, also rules out the sleep in which a virtual machine gives its processor away.
        let wait = 0_i32.to_ne_bytes();
        let asked = File::options().write(true).open("/dev/cpu_dma_latency");
        Awake { _asked: asked.and_then(|mut file| file.write_all(&wait).map(|()| file)).ok() }
    }
}

/// Does something, such as starting a process, with a raised thread's priority.
pub fn raised<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    std::thread::scope(|scope| {
        let thread = scope.spawn(|| {
            raise();
            work()
        });
        thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use thread_priority::thread_schedule_policy;

    #[test]
    fn what_is_raised_comes_first_until_it_is_lowered() {
        let policy = || thread_schedule_policy().expect("the system tells it");
        let ordinary = policy();
        let (allowed, first, lowered) = raised(|| {
            let (allowed, first) = (raise(), policy());
            lower();
            (allowed, first, policy())
        });
        let fifo = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
        assert_eq!(first, if allowed { fifo } else { ordinary });
        let normal = ThreadSchedulePolicy::Normal(NormalThreadSchedulePolicy::Other);
        assert_eq!((lowered, policy()), (normal, ordinary), "only the thread itself is raised");
    }
}
