//! Timing of the machine alone: in each period a datagram goes to another thread and back, and nothing is computed.
//!
//! Both threads have the priority of what keeps the period of a flight, so that what an echo misses no program keeps.

use ground::priority;
use ground::testbed::period;
use ground::wait;
use std::io;
use std::net::UdpSocket;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Periods that were kept, or not.
#[derive(Clone, Copy, Default)]
pub struct Echoed {
    pub periods: u64,
    pub missed: u64,
}

/// An echo that goes on.
pub struct Echo {
    goes_on: Arc<AtomicBool>,
    count: JoinHandle<io::Result<Echoed>>,
}

impl Echo {
    pub fn begin() -> Echo {
        let goes_on = Arc::new(AtomicBool::new(true));
        let seen = goes_on.clone();
        let count = std::thread::spawn(move || counted(&seen));
        Echo { goes_on, count }
    }

    pub fn end(self) -> Echoed {
        self.goes_on.store(false, Ordering::Relaxed);
        self.count.join().expect("it counts").expect("loopback is there")
    }
}

fn counted(goes_on: &AtomicBool) -> io::Result<Echoed> {
    let (here, there) = (UdpSocket::bind("127.0.0.1:0")?, UdpSocket::bind("127.0.0.1:0")?);
    here.connect(there.local_addr()?)?;
    there.connect(here.local_addr()?)?;
    std::thread::spawn(move || {
        priority::raise();
        let mut number = [0; 8];
        // The other end is gone when nobody asks any more.
        while there.recv(&mut number).is_ok() && there.send(&number).is_ok() {}
    });
    priority::raise();
    let (begun, length) = (Instant::now(), Duration::from_secs_f64(period()));
    let mut echoed = Echoed::default();
    while goes_on.load(Ordering::Relaxed) {
        let due = begun + length * u32::try_from(echoed.periods).unwrap_or(u32::MAX);
        std::thread::sleep(due.saturating_duration_since(Instant::now()));
        echoed.periods += 1;
        here.send(&echoed.periods.to_le_bytes())?;
        if !answered(&here, echoed.periods, due + length)? {
            echoed.missed += 1;
        }
    }
    Ok(echoed)
}

/// Returns true if this number comes back in time; older ones are late.
fn answered(here: &UdpSocket, number: u64, until: Instant) -> io::Result<bool> {
    let mut heard = [0; 8];
    while wait::receive(here, &mut heard, until)?.is_some() {
        if u64::from_le_bytes(heard) == number {
            return Ok(true);
        }
    }
    Ok(false)
}
