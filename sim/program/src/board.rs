//! The onboard software on a board at the other end of a serial line: the emulated Zynq of `examples/zynq`, without an
//! operating system.
//!
//! Of the outputs come back those that aircraft and ground take, the motors' speeds and the packet: a serial line has no
//! more room. All of them are in the digest. A flight cannot be reported what goes wrong here: after an error the outputs are those of a computer that stands
//! still, and [`Board::failure`] says why.

use std::io::{Read, Write};
use std::os::unix::net::UnixStream;
use std::time::Duration;

use bessemer_codegen::compile::Compiled;
use bessemer_legs::firmware::{Firmware, Machine};
use bessemer_legs::harness::{self, Mover, Way};
use bessemer_legs::lockstep::{self, Lockstep, Stack};
use bessemer_legs::process::Error;
use bessemer_legs::toolchain::{Sizes, Toolchain};
use bessemer_legs::{root, value, words};
use models::{Inputs, Outputs, Settings};
use sim::computer::Computer;

/// Timeout of an answer, emulated on a busy machine.
const PATIENCE: Duration = Duration::from_secs(10);

/// Beginning of the C that transfers values over the line.
const WORDS: &str = "\
/* Written from the models: see words.h. */
#include \"words.h\"

#include <stddef.h>
#include <string.h>

#include \"link.h\"

#define get link_get
#define put link_put

";

/// Beginning of the C that hashes the state.
const DIGESTS: &str = "\
/* Written from the models: see words.h. */
#include \"words.h\"

#include <stddef.h>
#include <string.h>

#include \"digest.h\"
#include \"link.h\"

#define get link_get
#define put digest_put

";

/// Firmware with the onboard software.
pub struct Loaded {
    firmware: Firmware,
    identity: u64,
}

impl Loaded {
    /// Builds the firmware of `examples/zynq` with the C of the models.
    ///
    /// # Errors
    ///
    /// The message of the compiler or the system, or that the models have no onboard software.
    pub fn zynq(compiled: &Compiled, toolchain: &Toolchain) -> Result<Self, Error> {
        let module = &compiled.explicit;
        let lacking = || Error::Compile("the models have no onboard software".into());
        let mover = |name, ty, way| Mover { name, ty, way };
        let moved = [
            mover("get_settings", "Settings", Way::In),
            mover("get_inputs", "Inputs", Way::In),
            mover("put_packet", "Packet", Way::Out),
        ];
        let digested = [
            mover("digest_outputs", "Outputs", Way::Out),
            mover("digest_onboard", "Onboard", Way::Out),
        ];
        let all = moved.iter().chain(&digested);
        let identity = harness::identity(module, all.map(|it| it.ty)).ok_or_else(lacking)?;
        let words = harness::movers(module, WORDS, &moved).ok_or_else(lacking)?;
        let own =
            format!("\nuint64_t words_identity(void)\n{{\n    return {identity:#x}ULL;\n}}\n");
        let made = [
            ("words.c", words + &own),
            ("digests.c", harness::movers(module, DIGESTS, &digested).ok_or_else(lacking)?),
        ];
        let board = ["legs/c/link", "examples/zynq/board", "examples/zynq"]
            .map(|folder| root().join(folder));
        let firmware = Firmware::build(&board, &made, &compiled.files, toolchain)?;
        Ok(Self { firmware, identity })
    }

    /// Returns the sizes of the firmware.
    ///
    /// # Errors
    /// What the system said.
    pub fn sizes(&self) -> Result<Sizes, Error> {
        self.firmware.sizes()
    }

    /// Starts the emulated machine; `through` wraps its serial line.
    ///
    /// # Errors
    ///
    /// The message of the system; [`lockstep::Error`] as text, if the software does not answer.
    pub fn start<L: Read + Write>(
        &self,
        through: impl FnOnce(UnixStream) -> L,
    ) -> Result<Board<L>, Error> {
        let (machine, line) = self.firmware.start(PATIENCE)?;
        let lockstep = Lockstep::open(through(line), self.identity);
        let lockstep = lockstep.map_err(|error| Error::Compile(error.to_string()))?;
        Ok(Board { lockstep, settings: None, digest: 0, failure: None, machine })
    }
}

/// A board that runs the onboard software.
pub struct Board<L> {
    lockstep: Lockstep<L>,
    settings: Option<Settings>,
    digest: u64,
    failure: Option<lockstep::Error>,
    /// The emulated machine.
    pub machine: Machine,
}

impl<L: Read + Write> Board<L> {
    /// Returns the error that ended the lockstep, if any.
    pub fn failure(&self) -> Option<&lockstep::Error> {
        self.failure.as_ref()
    }

    /// Returns the serial line.
    pub fn line(&mut self) -> &mut L {
        self.lockstep.line()
    }

    /// Returns the use of the stack.
    ///
    /// # Errors
    ///
    /// The error of the line or the board.
    pub fn stack(&mut self) -> Result<Stack, lockstep::Error> {
        self.lockstep.stack()
    }

    fn stepped(
        &mut self,
        settings: &Settings,
        inputs: &Inputs,
    ) -> Result<Outputs, lockstep::Error> {
        if self.settings.is_none() {
            self.lockstep.begin()?;
        }
        if self.settings.as_ref() != Some(settings) {
            self.lockstep.set(words(settings).into_iter())?;
            self.settings = Some(*settings);
        }
        let answer = self.lockstep.step(words(inputs).into_iter())?;
        let mut outputs = Outputs::default();
        let speeds = answer.len().min(outputs.command.speeds.len());
        let (speeds, rest) = answer.split_at(speeds);
        let (digest, packet) = rest.split_last().unwrap_or((&0, &[]));
        outputs.command.speeds = value(speeds);
        outputs.downlink = value(packet);
        self.digest = *digest;
        Ok(outputs)
    }
}

impl<L: Read + Write> Computer for Board<L> {
    fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        if self.failure.is_none() {
            match self.stepped(settings, inputs) {
                Ok(outputs) => return outputs,
                Err(error) => self.failure = Some(error),
            }
        }
        Outputs::default()
    }

    fn digest(&self) -> u64 {
        self.digest
    }
}
