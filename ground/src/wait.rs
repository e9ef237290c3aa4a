//! Waits for a datagram until a time, however often the wait is interrupted.
//!
//! A process that is stopped and goes on, or a machine that is frozen, ends a wait with a time limit early: that is neither
//! silence nor a failure. Knows nothing of what is said.

use std::io::ErrorKind::{Interrupted, TimedOut, WouldBlock};
use std::io::Result;
use std::net::{SocketAddr, UdpSocket};
use std::time::Instant;

/// Takes a datagram: its length, and whom it comes from; none, if none comes in time.
///
/// # Errors
/// An error of the system.
pub fn receive(
    socket: &UdpSocket,
    buffer: &mut [u8],
    until: Instant,
) -> Result<Option<(usize, SocketAddr)>> {
    wait(socket, until, |socket| socket.recv_from(buffer))
}

/// Waits until a datagram is there, and leaves it there; whether one came in time.
///
/// # Errors
/// An error of the system.
pub fn is_there(socket: &UdpSocket, until: Instant) -> Result<bool> {
    Ok(wait(socket, until, |socket| socket.peek_from(&mut [0; 1]))?.is_some())
}

fn wait<T>(
    socket: &UdpSocket,
    until: Instant,
    mut take: impl FnMut(&UdpSocket) -> Result<T>,
) -> Result<Option<T>> {
    loop {
        let left = until.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Ok(None);
        }
        socket.set_read_timeout(Some(left))?;
        match take(socket) {
            Ok(taken) => return Ok(Some(taken)),
            Err(error) if matches!(error.kind(), Interrupted | TimedOut | WouldBlock) => {}
            Err(error) => return Err(error),
        }
    }
}
