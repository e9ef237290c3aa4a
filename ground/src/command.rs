//! The right to command: one client at a time has it, page or external tool.
//!
//! Knows nobody's rights to it: whoever requests the command has shown them.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// The command.
#[derive(Debug, Default)]
pub struct Command {
    /// Client that has the right; 0 for nobody.
    holder: AtomicU64,
    seats: AtomicU64,
}

impl Command {
    /// A seat beside the others.
    pub fn seat(self: &Arc<Self>) -> Seat {
        Seat { number: 1 + self.seats.fetch_add(1, Ordering::Relaxed), command: self.clone() }
    }

    /// Returns true if any client has the right.
    pub fn is_held(&self) -> bool {
        self.holder.load(Ordering::Relaxed) != 0
    }
}

/// Somebody who may have the command. Whoever leaves, has it no more.
#[derive(Debug)]
pub struct Seat {
    command: Arc<Command>,
    number: u64,
}

impl Seat {
    /// Takes the command if nobody else has it, or by `force`; whether it is held now.
    pub fn claim(&self, force: bool) -> bool {
        if force {
            self.command.holder.store(self.number, Ordering::Relaxed);
            return true;
        }
        self.holds() || self.change(0, self.number)
    }

    /// Gives the command back, if it is held.
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
