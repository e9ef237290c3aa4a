//! Raises the priority of the thread that runs the control periods, if the system allows it.
//!
//! Pages, recordings and other programs must not delay a period. Without the permission (on Linux `CAP_SYS_NICE` or a
//! limit of real-time priorities) the program runs with ordinary priority, and periods may be late on a busy machine.

use std::fs::File;
use std::io::Write;

#[cfg(unix)]
use thread_priority::{
    NormalThreadSchedulePolicy, RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy,
    set_thread_priority_and_policy, thread_native_id,
};

/// Raises the priority of this thread, and of processes and threads that it starts, above ordinary ones. Returns
/// false if the system does not allow that.
#[cfg(unix)]
pub fn raise() -> bool {
    let first = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    let low = ThreadPriority::Min;
    set_thread_priority_and_policy(thread_native_id(), low, first).is_ok()
}

/// Gives this thread ordinary priority, for work that a raised thread starts and does not wait for.
#[cfg(unix)]
pub fn lower() {
    let ordinary = ThreadSchedulePolicy::Normal(NormalThreadSchedulePolicy::Other);
    // Who may raise may lower.
    let _ = set_thread_priority_and_policy(thread_native_id(), ThreadPriority::Min, ordinary);
}

/// Does nothing on other systems.
#[cfg(not(unix))]
pub fn raise() -> bool {
    false
}

/// Does nothing, since no priority was raised.
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
    /// Requests it; if the system does not allow that, nothing happens.
    pub fn keep() -> Awake {
        // Only no wait at all, µs, also rules out the sleep in which a virtual machine gives its processor away.
        let wait = 0_i32.to_ne_bytes();
        let asked = File::options().write(true).open("/dev/cpu_dma_latency");
        Awake { _asked: asked.and_then(|mut file| file.write_all(&wait).map(|()| file)).ok() }
    }
}

/// Runs a task, such as starting a process, with the raised priority of a separate thread.
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
