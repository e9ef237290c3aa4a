//! A text of fixed length is an array of bytes.

use bessemer::prelude::*;

/// A channel of the log.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Channel {
    pub name: [u8; 6],
    pub scale: f32,
}

/// The channel for the height.
#[function]
pub fn height(scale: f32) -> Channel {
    Channel { name: *b"height", scale }
}

/// Returns true if a channel is the one for the height.
#[function]
pub fn is_height(channel: &Channel) -> bool {
    channel.name == *b"height"
}
