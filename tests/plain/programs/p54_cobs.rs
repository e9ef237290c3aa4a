//! Consistent overhead byte stuffing, zero-delimited, into caller's buffers.

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CobsError {
    /// The destination cannot hold the result.
    BufferFull,
    /// A zero byte or a code that points past the end of the frame.
    Malformed,
}

/// Upper bound for the encoded length, delimiter included.
pub const fn max_encoded_len(payload: usize) -> usize {
    payload + payload / 254 + 2
}

/// Encodes `src` with trailing delimiter and returns the filled part of `dst`.
pub fn encode<'d>(src: &[u8], dst: &'d mut [u8]) -> Result<&'d [u8], CobsError> {
    let mut len = 0;
    let mut put = |bytes: &[u8]| {
        let slot = dst.get_mut(len..len + bytes.len()).ok_or(CobsError::BufferFull)?;
        slot.copy_from_slice(bytes);
        len += bytes.len();
        Ok(())
    };

    for block in src.split(|&b| b == 0) {
        let mut rest = block;
        // Full runs carry no implied zero, so they may simply be chained.
        while let Some((run, tail)) = rest.split_first_chunk::<254>() {
            put(&[0xFF])?;
            put(run)?;
            rest = tail;
        }
        put(&[rest.len() as u8 + 1])?;
        put(rest)?;
    }
    put(&[0])?;
    Ok(&dst[..len])
}

/// Decodes one frame without its delimiter.
pub fn decode<'d>(src: &[u8], dst: &'d mut [u8]) -> Result<&'d [u8], CobsError> {
    let mut decoder = Decoder::new(dst);
    for &byte in src {
        if byte == 0 || decoder.push(byte)?.is_some() {
            return Err(CobsError::Malformed);
        }
    }
    let len = decoder.push(0)?.map(<[u8]>::len).unwrap_or(0);
    Ok(&dst[..len])
}

/// Byte-wise decoder that can be fed from a UART interrupt.
pub struct Decoder<'b> {
    buffer: &'b mut [u8],
    len: usize,
    /// Bytes still to be copied literally before the next code byte.
    remaining: u8,
    zero_pending: bool,
    failed: Option<CobsError>,
}

impl<'b> Decoder<'b> {
    pub fn new(buffer: &'b mut [u8]) -> Self {
        Self { buffer, len: 0, remaining: 0, zero_pending: false, failed: None }
    }

    /// Takes one byte off the wire. Yields a frame on its delimiter, an error
    /// if that frame was damaged; resynchronises on the delimiter either way.
    pub fn push(&mut self, byte: u8) -> Result<Option<&[u8]>, CobsError> {
        if byte == 0 {
            return self.end_of_frame();
        }
        if self.failed.is_none() {
            self.failed = self.accept(byte).err();
        }
        Ok(None)
    }

    fn accept(&mut self, byte: u8) -> Result<(), CobsError> {
        if self.remaining > 0 {
            self.remaining -= 1;
            return self.store(byte);
        }
        if self.zero_pending {
            self.store(0)?;
        }
        self.remaining = byte - 1;
        self.zero_pending = byte != 0xFF;
        Ok(())
    }

    fn store(&mut self, byte: u8) -> Result<(), CobsError> {
        let slot = self.buffer.get_mut(self.len).ok_or(CobsError::BufferFull)?;
        *slot = byte;
        self.len += 1;
        Ok(())
    }

    fn end_of_frame(&mut self) -> Result<Option<&[u8]>, CobsError> {
        let len = core::mem::take(&mut self.len);
        let truncated = core::mem::take(&mut self.remaining) > 0;
        self.zero_pending = false;
        match self.failed.take() {
            Some(error) => Err(error),
            None if truncated => Err(CobsError::Malformed),
            None => Ok(Some(&self.buffer[..len])),
        }
    }
}
