//! Waits for a datagram until a deadline, however often the wait is interrupted.
//!
//! A wait with a time limit ends with `EINTR` when its process is stopped and continued, or its machine frozen. That is neither
//! silence nor a failure. Must not know the contents of datagrams.

use std::io::ErrorKind::{Interrupted, TimedOut, WouldBlock};
use std::io::Result;
use std::net::{SocketAddr, UdpSocket};
use std::time::Instant;

/// Receives a datagram: its length and its sender; none, if no datagram comes in time.
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

/// Waits for a datagram, and leaves it in the socket. Returns whether one came in time.
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
