//! MAVLink 2's signature: with a key, sent messages are signed, and unsigned, forged or repeated ones are rejected.
//!
//! The key is never shown.

use crate::key::{self, secret};
use ::mavlink::dialects::common::MavMessage;
use ::mavlink::{MAVLinkV2MessageRaw, MavHeader, SigningConfig, SigningData};
use std::fmt;
use std::path::Path;

/// Number of the link on which messages are signed; there is only one.
const LINK: u8 = 0;

/// Signs and checks the messages of one link.
#[derive(Default)]
pub struct Signature {
    signing: Option<SigningData>,
    /// Number of rejected messages.
    pub refused: u64,
}

impl fmt::Debug for Signature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Signature({}, {} refused)", self.signing.is_some(), self.refused)
    }
}

impl Signature {
    /// Creates a signature from a secret of 32 bytes that both ends have.
    pub fn new(secret: [u8; 32]) -> Self {
        let signing = SigningData::from_config(SigningConfig::new(secret, LINK, true, false));
        Self { signing: Some(signing), refused: 0 }
    }

    /// Reads a file of 64 hexadecimal digits.
    ///
    /// # Errors
    /// The file cannot be read, or holds something else.
    pub fn read(path: &Path) -> Result<Self, key::Error> {
        secret(path).map(Self::new)
    }

    /// Returns a message in its wire format, signed if there is a key.
    pub fn sealed(&self, header: MavHeader, message: &MavMessage) -> MAVLinkV2MessageRaw {
        let mut raw = MAVLinkV2MessageRaw::new();
        match &self.signing {
            Some(signing) => {
                raw.serialize_message_for_signing(header, message);
                signing.sign_message(&mut raw);
            }
            None => raw.serialize_message(header, message),
        }
        raw
    }

    /// Returns true if a received message is accepted.
    pub fn admits(&mut self, raw: &MAVLinkV2MessageRaw) -> bool {
        let good = self.signing.as_ref().is_none_or(|signing| signing.verify_signature(raw));
        self.refused += u64::from(!good);
        good
    }
}
