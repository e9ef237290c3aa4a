//! A decompressor in the manner of LZ4: literals and matches.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Broken {
    Truncated,
    TooLarge,
    BadOffset,
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
struct Reader {
    at: usize,
}

#[data]
impl Reader {
    fn byte(&mut self, input: &[u8]) -> Result<u8, Broken> {
        let byte = *input.get(self.at).ok_or(Broken::Truncated)?;
        self.at += 1;
        Ok(byte)
    }

    fn length(&mut self, input: &[u8], nibble: u8) -> Result<usize, Broken> {
        let mut length = nibble as usize;
        if nibble == 15 {
            #[bound(16)]
            loop {
                let more = self.byte(input)?;
                length += more as usize;
                if more != 255 {
                    break;
                }
            }
        }
        Ok(length)
    }
}

#[function]
pub fn decompress(input: &List<u8, 32>) -> Result<List<u8, 64>, Broken> {
    let input = input.as_slice();
    let mut reader = Reader { at: 0 };
    let mut output: List<u8, 64> = List::new();
    #[bound(33)]
    while reader.at < input.len() {
        let token = reader.byte(input)?;
        let literals = reader.length(input, token >> 4)?;
        for _ in 0..literals {
            let byte = reader.byte(input)?;
            if output.len() == output.capacity() {
                return Err(Broken::TooLarge);
            }
            output.push(byte);
        }
        if reader.at >= input.len() {
            break;
        }
        let offset = u16::from_le_bytes([reader.byte(input)?, reader.byte(input)?]) as usize;
        if offset == 0 || offset > output.len() {
            return Err(Broken::BadOffset);
        }
        let matched = reader.length(input, token & 0xF)? + 4;
        let start = output.len() - offset;
        for i in start..start + matched {
            if output.len() == output.capacity() {
                return Err(Broken::TooLarge);
            }
            output.push(output[i]);
        }
    }
    Ok(output)
}
