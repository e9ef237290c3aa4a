//! The right to command the aircraft: one client has it at a time, a page or an external tool.
//!
//! Does not know who may request the right: callers check that first.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// The right to command, shared by all clients.
#[derive(Debug, Default)]
pub struct Command {
    /// Client that has the right; 0 for nobody.
    holder: AtomicU64,
    seats: AtomicU64,
}

impl Command {
    /// Creates a seat for one more client.
    pub fn seat(self: &Arc<Self>) -> Seat {
        Seat { number: 1 + self.seats.fetch_add(1, Ordering::Relaxed), command: self.clone() }
    }

    /// Returns true if any client has the right.
    pub fn is_held(&self) -> bool {
        self.holder.load(Ordering::Relaxed) != 0
    }
}

/// A client that may request the right to command. Dropping it gives the right back.
#[derive(Debug)]
pub struct Seat {
    command: Arc<Command>,
    number: u64,
}

impl Seat {
    /// Takes the right if no other client has it, or if `force` is set. Returns true if this client has it now.
    pub fn claim(&self, force: bool) -> bool {
        if force {
            self.command.holder.store(self.number, Ordering::Relaxed);
            return true;
        }
        self.holds() || self.change(0, self.number)
    }

    /// Gives the right back, if this client has it.
    pub fn release(&self) {
        self.change(self.number, 0);
    }

    /// Returns true if this client has the right.
    pub fn holds(&self) -> bool {
        self.command.holder.load(Ordering::Relaxed) == self.number
    }

    /// Returns true if another client has the right.
    pub fn is_taken(&self) -> bool {
        self.command.is_held() && !self.holds()
    }

    fn change(&self, from: u64, to: u64) -> bool {
        let holder = &self.command.holder;
        holder.compare_exchange(from, to, Ordering::Relaxed, Ordering::Relaxed).is_ok()
    }
}

impl Drop for Seat {
    fn drop(&mut self) {
        self.release();
    }
}
