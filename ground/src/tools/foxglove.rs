//! Shows a flight in Foxglove while it is flown: the channels of the recording, over Foxglove's WebSocket protocol.
//!
//! Foxglove only observes: it is offered nothing with which it could command.

use super::Tool;
use crate::bench::Period;
use crate::recorder::is_shown;
use crate::refusal::Situation;
use crate::testbed::Testbed;
use ::foxglove::{
    Context, FoxgloveError, PartialMetadata, RawChannel, Schema, WebSocketServerHandle,
};
use sim::ground_station::News;
use sim::recording::{channels, log_time, messages};
use std::net::SocketAddr;
use std::sync::Arc;

/// Number of messages that a slow Foxglove may lag behind before the oldest are dropped: two seconds.
const QUEUE_LENGTH: usize = 1024;

/// The server for Foxglove.
pub struct Foxglove {
    /// Context that connects channels and server; neither of them owns it.
    _context: Arc<Context>,
    channels: Vec<Arc<RawChannel>>,
    /// The server ends with it.
    server: Option<WebSocketServerHandle>,
    address: SocketAddr,
}

impl Foxglove {
    /// Binds to an address, and serves from its own threads.
    ///
    /// # Errors
    ///
    /// The address is in use.
    pub fn start(address: SocketAddr) -> Result<Self, FoxgloveError> {
        let context = Context::new();
        let channel = |it: sim::recording::Channel| {
            let schema = Schema::new(it.schema, "jsonschema", it.text.into_bytes());
            context.channel_builder(it.topic).message_encoding("json").schema(schema).build_raw()
        };
        let channels = channels().map(channel).collect::<Result<_, _>>()?;
        let server = context
            .websocket_server()
            .name("bessemer")
            .bind(address.ip().to_string(), address.port())
            .message_backlog_size(QUEUE_LENGTH)
            .start_blocking()?;
        let address = SocketAddr::new(address.ip(), server.port());
        Ok(Self { _context: context, channels, server: Some(server), address })
    }

    /// Returns the address of the server.
    pub fn address(&self) -> SocketAddr {
        self.address
    }
}

impl Tool for Foxglove {
    fn tell(&mut self, _testbed: &Testbed, _before: &Situation, done: &Period, _news: &[News]) {
        if !is_shown(done) || !self.channels.iter().any(|it| it.has_sinks()) {
            return;
        }
        let time = PartialMetadata::with_log_time(log_time(done.moment.time));
        for (channel, message) in self.channels.iter().zip(messages(&done.moment)) {
            channel.log_with_meta(message.as_bytes(), time);
        }
    }
}

impl Drop for Foxglove {
    fn drop(&mut self) {
        if let Some(server) = self.server.take() {
            // It ends by itself; nobody waits for it.
            let _ = server.stop();
        }
    }
}
