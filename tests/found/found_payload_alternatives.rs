// Alternatives for a payload behind a pattern with a name: a check that is kept read the payload before the variant was known.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FOUND_PAYLOAD_ALTERNATIVESWay { #[default] Off, On(i16), Both { low: i16, high: i16 } }
#[function]
pub fn found_payload_alternatives(k: i16, p: i16, n0: u8) -> i16 {
    let mut w = if n0 & 2 == 0 { FOUND_PAYLOAD_ALTERNATIVESWay::On(k) } else { FOUND_PAYLOAD_ALTERNATIVESWay::Off };
    let z = match (FOUND_PAYLOAD_ALTERNATIVESWay::On(k)) {
        x @ FOUND_PAYLOAD_ALTERNATIVESWay::On(y) if y > p => { w = x; y }
        FOUND_PAYLOAD_ALTERNATIVESWay::Both { low: x @ (..=5 | 9..), .. } => x,
        x => { w = x; 6 }
    };
    z ^ match w { FOUND_PAYLOAD_ALTERNATIVESWay::Off => 1, FOUND_PAYLOAD_ALTERNATIVESWay::On(x) => x, FOUND_PAYLOAD_ALTERNATIVESWay::Both { low, high } => low ^ high }
}
