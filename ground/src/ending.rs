//! Requests to end the program: Ctrl-C, `SIGTERM`, `SIGHUP`.
//!
//! The first one sets a flag, so that the caller finishes its recording and stops its software. The second one exits at once.
//! Must not know recordings or software.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Exit code that shells report for an end by Ctrl-C.
const INTERRUPTED: i32 = 130;

/// Installs the handlers. The flag becomes true at the first request.
///
/// # Errors
/// The system has no signals, or no thread.
pub fn requested() -> io::Result<Arc<AtomicBool>> {
    let requested = Arc::new(AtomicBool::new(false));
    let flag = requested.clone();
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
    let mut signals = {
        let _guard = runtime.enter();
        Signals::listen()?
    };
    std::thread::Builder::new().name("signals".into()).spawn(move || {
        runtime.block_on(async {
            signals.next().await;
            flag.store(true, Ordering::Relaxed);
            signals.next().await;
            std::process::exit(INTERRUPTED);
        });
    })?;
    Ok(requested)
}

#[cfg(unix)]
struct Signals([tokio::signal::unix::Signal; 3]);

#[cfg(unix)]
impl Signals {
    fn listen() -> io::Result<Self> {
        use tokio::signal::unix::{SignalKind, signal};
        let hangup = signal(SignalKind::hangup())?;
        Ok(Self([signal(SignalKind::interrupt())?, signal(SignalKind::terminate())?, hangup]))
    }

    async fn next(&mut self) {
        let [interrupt, terminate, hangup] = &mut self.0;
        tokio::select! {
            _ = interrupt.recv() => {}
            _ = terminate.recv() => {}
            _ = hangup.recv() => {}
        }
    }
}

#[cfg(not(unix))]
struct Signals;

#[cfg(not(unix))]
impl Signals {
    fn listen() -> io::Result<Self> {
        Ok(Self)
    }

    async fn next(&mut self) {
        if tokio::signal::ctrl_c().await.is_err() {
            // This system has no Ctrl-C.
            std::future::pending::<()>().await;
        }
    }
}
