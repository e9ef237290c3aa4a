//! What keeps the period comes before all other work of the machine, where the system allows it.
//!
//! Pages, recordings and whatever else runs must not make a period late. Without the right to it (on Linux `CAP_SYS_NICE` or a limit
//! of real-time priorities) everything runs as it did: the period is then kept as far as the machine is free.

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

/// Elsewhere nothing is asked for.
#[cfg(not(unix))]
pub fn raise() -> bool {
    false
}

/// Nothing was raised.
#[cfg(not(unix))]
pub fn lower() {}

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
