//! NMEA 0183 parser fed with bytes: collects a sentence, verifies its checksum
//! and decodes the position sentences GGA and RMC.

/// Why a sentence was thrown away.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NmeaError {
    Checksum { expected: u8, computed: u8 },
    TooLong,
    Malformed,
}

/// Degrees, north and east positive.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Position {
    pub lat: f64,
    pub lon: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sentence {
    Gga { position: Option<Position>, satellites: u8, altitude: Option<f32> },
    Rmc { position: Option<Position>, speed_knots: f32, course: Option<f32> },
    /// Valid, but of a kind nobody here asked for.
    Other([u8; 3]),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Idle,
    Body,
    Trailer { first: Option<u8> },
}

/// Receiver for one serial line.
#[derive(Clone, Debug)]
pub struct NmeaParser {
    state: State,
    buf: [u8; Self::MAX_LEN],
    len: usize,
    checksum: u8,
}

impl NmeaParser {
    pub const MAX_LEN: usize = 82;

    pub const fn new() -> Self {
        Self { state: State::Idle, buf: [0; Self::MAX_LEN], len: 0, checksum: 0 }
    }

    pub fn push(&mut self, byte: u8) -> Option<Result<Sentence, NmeaError>> {
        match (self.state, byte) {
            (_, b'$') => {
                self.state = State::Body;
                (self.len, self.checksum) = (0, 0);
                None
            }
            (State::Idle, _) => None,
            (State::Body, b'*') => {
                self.state = State::Trailer { first: None };
                None
            }
            (State::Body, b' '..=b'~') if self.len < Self::MAX_LEN => {
                self.buf[self.len] = byte;
                self.len += 1;
                self.checksum ^= byte;
                None
            }
            (State::Body, b' '..=b'~') => self.fail(NmeaError::TooLong),
            (State::Body, _) => self.fail(NmeaError::Malformed),
            (State::Trailer { first }, digit) => match (first, hex(digit)) {
                (None, Some(high)) => {
                    self.state = State::Trailer { first: Some(high) };
                    None
                }
                (Some(high), Some(low)) => {
                    self.state = State::Idle;
                    Some(self.complete(high << 4 | low))
                }
                (_, None) => self.fail(NmeaError::Malformed),
            },
        }
    }

    fn fail(&mut self, e: NmeaError) -> Option<Result<Sentence, NmeaError>> {
        self.state = State::Idle;
        Some(Err(e))
    }

    fn complete(&self, expected: u8) -> Result<Sentence, NmeaError> {
        let computed = self.checksum;
        if expected != computed {
            return Err(NmeaError::Checksum { expected, computed });
        }
        decode(&self.buf[..self.len]).ok_or(NmeaError::Malformed)
    }
}

impl Default for NmeaParser {
    fn default() -> Self {
        Self::new()
    }
}

fn hex(b: u8) -> Option<u8> {
    (b as char).to_digit(16).map(|d| d as u8)
}

fn decode(body: &[u8]) -> Option<Sentence> {
    let mut fields = body.split(|&b| b == b',');
    let &[_, _, ref kind @ ..] = fields.next()?.first_chunk::<5>()?;
    match kind {
        b"GGA" => {
            let _time = fields.next()?;
            let position = position(&mut fields)?;
            let quality = number::<u8>(fields.next()?).unwrap_or(0);
            let satellites = number(fields.next()?).unwrap_or(0);
            let altitude = number(fields.nth(1)?);
            Some(Sentence::Gga {
                position: position.filter(|_| quality > 0),
                satellites,
                altitude,
            })
        }
        b"RMC" => {
            let valid = fields.nth(1)? == b"A";
            let position = position(&mut fields)?;
            let speed_knots = number(fields.next()?).unwrap_or(0.0);
            let course = number(fields.next()?);
            Some(Sentence::Rmc { position: position.filter(|_| valid), speed_knots, course })
        }
        other => Some(Sentence::Other(*other)),
    }
}

fn number<T: core::str::FromStr>(field: &[u8]) -> Option<T> {
    core::str::from_utf8(field).ok()?.parse().ok()
}

/// Takes the four fields of a position; the inner option is `None` when empty.
fn position<'a>(fields: &mut impl Iterator<Item = &'a [u8]>) -> Option<Option<Position>> {
    let [lat, ns, lon, ew] = [fields.next()?, fields.next()?, fields.next()?, fields.next()?];
    let parsed = angle(lat, ns).zip(angle(lon, ew));
    Some(parsed.map(|(lat, lon)| Position { lat, lon }))
}

/// `dddmm.mmmm` and a hemisphere letter.
fn angle(field: &[u8], hemisphere: &[u8]) -> Option<f64> {
    let raw: f64 = number(field)?;
    let degrees = (raw / 100.0).trunc();
    let value = degrees + (raw - 100.0 * degrees) / 60.0;
    match hemisphere {
        b"N" | b"E" => Some(value),
        b"S" | b"W" => Some(-value),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GGA: &[u8] =
        b"$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n";
    const RMC: &[u8] =
        b"$GPRMC,123519,A,4807.038,N,01131.000,W,022.4,084.4,230394,003.1,W*78\r\n";

    fn feed(parser: &mut NmeaParser, bytes: &[u8]) -> Option<Result<Sentence, NmeaError>> {
        bytes.iter().filter_map(|&b| parser.push(b)).last()
    }

    #[test]
    fn gga_in_full() {
        let mut p = NmeaParser::new();
        let Some(Ok(Sentence::Gga { position: Some(pos), satellites, altitude })) =
            feed(&mut p, GGA)
        else {
            panic!("no position");
        };
        assert!((pos.lat - 48.1173).abs() < 1e-4 && (pos.lon - 11.516_67).abs() < 1e-4);
        assert_eq!((satellites, altitude), (8, Some(545.4)));
    }

    #[test]
    fn rmc_west_is_negative() {
        let s = feed(&mut NmeaParser::default(), RMC);
        assert!(matches!(
            s,
            Some(Ok(Sentence::Rmc { position: Some(Position { lon, .. }), speed_knots, .. }))
                if lon < -11.5 && speed_knots == 22.4
        ), "{s:?}");
    }

    #[test]
    fn errors_and_resynchronisation() {
        let mut p = NmeaParser::new();
        assert!(matches!(
            feed(&mut p, b"$GPGGA,1*00"),
            Some(Err(NmeaError::Checksum { expected: 0, .. }))
        ));
        assert_eq!(feed(&mut p, &[b'$'; 3]), None);
        assert_eq!(feed(&mut p, &[b'x'; 100]), Some(Err(NmeaError::TooLong)));
        assert_eq!(feed(&mut p, b"$GPGSV*55"), Some(Ok(Sentence::Other(*b"GSV"))));
        assert!(feed(&mut p, GGA).is_some_and(|r| r.is_ok()));
    }
}
