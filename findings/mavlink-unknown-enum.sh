#!/usr/bin/env bash
# mavlink 0.21.0 (the crate): a message with a number that an enum of the dialect lacks is an error; pymavlink reads it.
#
# Guessed: MAVLink's enums grow, so a reader keeps a number that it does not know, as its byte on the wire.
# Seen:    a HEARTBEAT whose type is 200 does not parse: `InvalidEnum`, and its autopilot, mode and state are lost with it. The message
#          behind it in the same stream is read. pymavlink 2.4.50 has the number 200 and all other fields.
# So:      do not take a parse error for silence: a station or vehicle of a newer dialect is heard, but not understood.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv python
python/bin/pip --quiet --disable-pip-version-check install pymavlink==2.4.50
mkdir src
cat > Cargo.toml <<'TOML'
[package]
name = "heard"
version = "0.0.0"
edition = "2024"

[dependencies]
mavlink = { version = "=0.21.0", default-features = false, features = ["dialect-minimal", "std"] }
TOML
cat > src/main.rs <<'RUST'
use mavlink::dialects::minimal::MavMessage;
use mavlink::{MavlinkReader, error::MessageReadError};

fn main() {
    let stream = std::fs::read("stream").expect("the stream");
    let mut reader = MavlinkReader::new(&stream[..]);
    loop {
        match reader.read_any_message::<MavMessage>() {
            Ok((_, MavMessage::HEARTBEAT(it))) => println!("crate: {:?}", it.mavtype),
            Err(MessageReadError::Parse(error)) => println!("crate: {error}"),
            Err(MessageReadError::Io(_)) => break,
        }
    }
}
RUST
{
    grep 'mavlink =' Cargo.toml
    python/bin/python - <<'PYTHON'
from importlib.metadata import version
from pymavlink.dialects.v20 import minimal

print(f"pymavlink {version('pymavlink')}")
encoder = minimal.MAVLink(None, 1, 1)
kinds = [200, minimal.MAV_TYPE_QUADROTOR]
sent = [minimal.MAVLink_heartbeat_message(kind, minimal.MAV_AUTOPILOT_GENERIC, 0, 0, minimal.MAV_STATE_ACTIVE, 3) for kind in kinds]
stream = b"".join(message.pack(encoder) for message in sent)
with open("stream", "wb") as file:
    file.write(stream)
for message in minimal.MAVLink(None).parse_buffer(stream):
    print(f"pymavlink: type {message.type}, state {message.system_status}")
PYTHON
    cargo run --quiet
} | tee printed
grep -qx 'pymavlink: type 200, state 4' printed
grep -qx 'pymavlink: type 2, state 4' printed
grep -q '^crate: Invalid enum value for enum type "MavType", got 200' printed
grep -qx 'crate: MAV_TYPE_QUADROTOR' printed
