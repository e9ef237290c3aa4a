//! A serial port of this machine as a line: raw bytes at a given speed, with a timeout for reads.
//!
//! What it must not know: the protocol.

use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{Mode, OFlags};
use rustix::termios::{OptionalActions, SpecialCodeIndex, tcgetattr, tcsetattr};

/// Timeout of a read.
const PATIENCE: Timespec = Timespec { tv_sec: 5, tv_nsec: 0 };

/// A port, or a pseudo-terminal.
#[derive(Debug)]
pub struct Port(File);

impl Port {
    /// Opens a port at `baud` bits a second.
    ///
    /// # Errors
    ///
    /// There is no such port, it is in use or not permitted, or it does not support the speed.
    pub fn open(path: &Path, baud: u32) -> io::Result<Self> {
        let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC;
        let port = rustix::fs::open(path, flags, Mode::empty())?;
        let mut settings = tcgetattr(&port)?;
        settings.make_raw();
        settings.set_speed(baud)?;
        // A read waits before, where silence is distinguished from an end.
        settings.special_codes[SpecialCodeIndex::VMIN] = 0;
        settings.special_codes[SpecialCodeIndex::VTIME] = 0;
        // What came before is nobody's.
        tcsetattr(&port, OptionalActions::Flush, &settings)?;
        Ok(Self(port.into()))
    }
}

impl Read for Port {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        if poll(&mut [PollFd::new(&self.0, PollFlags::IN)], Some(&PATIENCE))? == 0 {
            return Err(io::ErrorKind::TimedOut.into());
        }
        match self.0.read(to) {
            // A pseudo-terminal whose other end is closed says so, or has nothing more.
            Err(error) if error.raw_os_error() == Some(rustix::io::Errno::IO.raw_os_error()) => {
                Ok(0)
            }
            other => other,
        }
    }
}

impl Write for Port {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use std::os::unix::ffi::OsStrExt as _;

    #[test]
    fn bytes_go_through_as_they_are() -> io::Result<()> {
        let board = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
        grantpt(&board)?;
        unlockpt(&board)?;
        let name = ptsname(&board, Vec::new())?;
        let mut port =
            Port::open(Path::new(std::ffi::OsStr::from_bytes(name.to_bytes())), 115_200)?;
        let mut board = File::from(board);
        let all: Vec<u8> = (0..=255).collect();
        let mut came = vec![0; all.len()];
        port.write_all(&all)?;
        board.read_exact(&mut came)?;
        assert_eq!(came, all);
        board.write_all(&all)?;
        port.read_exact(&mut came)?;
        assert_eq!(came, all);
        drop(board);
        assert_eq!(port.read(&mut came)?, 0, "the other end is closed");
        Ok(())
    }

    #[test]
    fn what_is_no_port_is_refused() {
        assert!(Port::open(Path::new("/no/such/port"), 9600).is_err());
        assert!(Port::open(Path::new("/dev/null"), 9600).is_err());
    }
}
