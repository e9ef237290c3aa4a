//! The command lines of the ground station: commands, arguments and help texts.
//!
//! A separate crate, so that xtask can print help and report mistakes without building the testbed.
//!
//! Invariant: only data and help texts; nothing is executed here.

use clap::{Args, Subcommand, ValueEnum};
use std::net::{IpAddr, Ipv4Addr, SocketAddr, SocketAddrV4};
use std::path::PathBuf;

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Task {
    /// Fly live: aircraft, emitted C, link and ground station, with a page in the browser
    Fly(Box<Fly>),
    /// Run the onboard C again from a recording of `fly`, and compare every output by its bits; or show it
    Replay(Replay),
}

const FLY: &str = "\
Examples:
  cargo xtask fly                    Open the page in the browser
  cargo xtask fly --headless         Only print its address
  cargo xtask fly --loss 20%         Over a bad link
  cargo xtask fly --target zynq      The C as firmware of an emulated Zynq, over its serial line
  cargo xtask fly --airframe f550    The hexacopter in place of the Mambo
  cargo xtask fly --key FILE         Commands are sealed; FILE holds 32 hexadecimal digits
  cargo xtask fly --record FILE      Record from the beginning; `cargo xtask replay FILE` runs the C again
  cargo xtask fly --foxglove         Foxglove sees the flight at ws://127.0.0.1:8765
  cargo xtask fly --mavlink          QGroundControl or pymavlink at 127.0.0.1:14550 flies it: commands, missions, sticks
  cargo xtask fly --mocap 10.0.0.5   The pose comes from OptiTrack's Motive at this address
  cargo xtask fly --natnet           The simulated aircraft is what Motive would stream
  cargo xtask fly --seconds 600      End after that, and say how well the periods were kept";

/// Arguments of `fly`.
#[derive(Debug, Args)]
#[command(after_help = FLY)]
pub struct Fly {
    /// Open no browser
    #[arg(long)]
    pub headless: bool,
    /// Port of the page; 0 for any that is free
    #[arg(long, default_value_t = 8080)]
    pub port: u16,
    /// Address that the page is served at: others than loopback can be reached from outside
    #[arg(long, default_value_t = IpAddr::V4(Ipv4Addr::LOCALHOST))]
    pub bind: IpAddr,
    /// Machine that runs the onboard software
    #[arg(long, value_enum, default_value_t = Machine::Native)]
    pub target: Machine,
    /// Aircraft to fly
    #[arg(long, value_enum, default_value_t = Airframe::Mambo)]
    pub airframe: Airframe,
    /// Address of this machine at which the onboard software receives commands, with or without a port
    #[arg(long, value_name = "ADDRESS", value_parser = place, default_value = "127.0.0.1")]
    pub link: SocketAddrV4,
    /// Share of the datagrams that is lost, such as 5%
    #[arg(long, value_parser = share, default_value = "0")]
    pub loss: f64,
    /// Share that comes twice
    #[arg(long, value_parser = share, default_value = "0")]
    pub duplicate: f64,
    /// Share that others overtake
    #[arg(long, value_parser = share, default_value = "0")]
    pub reorder: f64,
    /// Delay of the link, ms
    #[arg(long, default_value_t = 0)]
    pub delay: u32,
    /// File with the key that seals commands
    #[arg(long, value_name = "FILE")]
    pub key: Option<PathBuf>,
    /// Record from the beginning
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Show the flight to Foxglove: it connects to this address
    #[arg(long, value_name = "ADDRESS", num_args = 0..=1, default_missing_value = "127.0.0.1:8765")]
    pub foxglove: Option<SocketAddr>,
    /// Speak MAVLink 2 with the ground station that listens at this address, which may command while no page does
    #[arg(long, value_name = "ADDRESS", num_args = 0..=1, default_missing_value = "127.0.0.1:14550")]
    pub mavlink: Option<SocketAddr>,
    /// File with the key that signs MAVLink: 64 hexadecimal digits; messages not signed with it are rejected
    #[arg(long, value_name = "FILE", requires = "mavlink")]
    pub mavlink_key: Option<PathBuf>,
    /// Take the aircraft's pose from the NatNet server at this address (OptiTrack's Motive), not from the simulation
    #[arg(long, value_name = "ADDRESS", value_parser = natnet, num_args = 0..=1, default_missing_value = "127.0.0.1:1510")]
    pub mocap: Option<SocketAddrV4>,
    /// Rigid body that is the aircraft: its name or its number
    #[arg(long, value_name = "BODY", requires = "mocap", default_value = "aircraft")]
    pub body: String,
    /// Axis of motion capture that points upwards
    #[arg(long, value_enum, requires = "mocap", default_value_t = Axis::Y)]
    pub up: Axis,
    /// Stream the simulated aircraft from a NatNet server at this address, as a motion-capture system would
    #[arg(long, value_name = "ADDRESS", value_parser = natnet, num_args = 0..=1, default_missing_value = "127.0.0.1:1510")]
    pub natnet: Option<SocketAddrV4>,
    /// Seed of all randomness
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// End after this many seconds
    #[arg(long)]
    pub seconds: Option<f64>,
}

const REPLAY: &str = "\
Examples:
  cargo xtask replay FILE                                     Run the C again, and compare every bit
  cargo xtask replay FILE --page                              Show the flight
  cargo xtask replay --page --campaign failures --seed 7      Fly a seed of a campaign, record it in target/campaign/, and show it";

/// Arguments of `replay`.
#[derive(Debug, Args)]
#[command(after_help = REPLAY)]
pub struct Replay {
    /// The recording
    #[arg(required_unless_present = "seed")]
    pub file: Option<PathBuf>,
    /// Fly this seed of a campaign, record it in target/campaign/, and show it
    #[arg(long, conflicts_with = "file", requires = "page")]
    pub seed: Option<u64>,
    /// Campaign of the seed
    #[arg(long, value_enum, requires = "seed", default_value_t = Campaign::Spread)]
    pub campaign: Campaign,
    /// Show it in the browser instead
    #[arg(long)]
    pub page: bool,
    /// Open no browser: only print the address of the page
    #[arg(long, requires = "page")]
    pub headless: bool,
    /// Port of the page; 0 for any that is free
    #[arg(long, default_value_t = 8080, requires = "page")]
    pub port: u16,
    /// Machine that runs the onboard software
    #[arg(long, value_enum, default_value_t = Machine::Native)]
    pub target: Machine,
}

impl Task {
    /// The cargo features of the ground station that these arguments need.
    pub fn features(&self) -> Vec<&'static str> {
        match self {
            Self::Fly(wanted) => [("foxglove", wanted.foxglove), ("mavlink", wanted.mavlink)]
                .into_iter()
                .filter_map(|(feature, asked)| asked.map(|_| feature))
                .collect(),
            Self::Replay(_) => Vec::new(),
        }
    }
}

/// Aircraft to fly.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Airframe {
    /// The Parrot Mambo, a quadcopter of 70 g
    Mambo,
    /// A hexacopter of the size of the DJI F550
    F550,
}

/// Campaign whose flights can be shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Campaign {
    /// Flights without failures
    Spread,
    /// Flights with a failure
    Failures,
}

/// Axis that points upwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Axis {
    /// The y axis, as Motive has it unless it is changed there
    Y,
    /// The z axis
    Z,
}

/// Machine that runs the onboard software.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Machine {
    /// This machine
    Native,
    /// An emulated Cortex-A9, under Linux (qemu-arm)
    A9,
    /// An emulated Zynq without an operating system (qemu-system-arm, examples/zynq)
    Zynq,
}

/// Port of NatNet's commands.
const NATNET_PORT: u16 = 1510;

/// Parses an address of a NatNet server.
fn natnet(text: &str) -> Result<SocketAddrV4, String> {
    address(text, NATNET_PORT)
}

/// Parses an address at which any free port will do.
fn place(text: &str) -> Result<SocketAddrV4, String> {
    address(text, 0)
}

/// Parses an address of IPv4, with this port unless it has one.
fn address(text: &str, port: u16) -> Result<SocketAddrV4, String> {
    let alone = text.parse::<Ipv4Addr>().map(|address| SocketAddrV4::new(address, port));
    alone
        .or_else(|_| text.parse())
        .map_err(|_| format!("`{text}` is no address of IPv4: write 127.0.0.1 or 127.0.0.1:5000"))
}

/// Parses a share such as `5%` or `0.05`.
fn share(text: &str) -> Result<f64, String> {
    let (number, unit) = text.strip_suffix('%').map_or((text, 1.0), |number| (number, 0.01));
    let value: f64 = number.trim().parse().map_err(|_| format!("`{text}` is no share: try 5%"))?;
    let share = value * unit;
    if (0.0..=1.0).contains(&share) { Ok(share) } else { Err("a share is 0% to 100%".into()) }
}
