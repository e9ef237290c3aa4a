//! Calls of `lora-modulation` over plain numbers.

use crate::*;

fn factor(n: u8) -> SpreadingFactor {
    match n % 8 {
        0 => SpreadingFactor::_5,
        1 => SpreadingFactor::_6,
        2 => SpreadingFactor::_7,
        3 => SpreadingFactor::_8,
        4 => SpreadingFactor::_9,
        5 => SpreadingFactor::_10,
        6 => SpreadingFactor::_11,
        _ => SpreadingFactor::_12,
    }
}

fn bandwidth(n: u8) -> Bandwidth {
    match n % 4 {
        0 => Bandwidth::_7KHz,
        1 => Bandwidth::_125KHz,
        2 => Bandwidth::_250KHz,
        _ => Bandwidth::_500KHz,
    }
}

pub fn on_air(sf: u8, bw: u8, preamble: Option<u8>, explicit: bool, len: u8) -> u32 {
    let params = BaseBandModulationParams::new(factor(sf), bandwidth(bw), CodingRate::_4_5);
    params.time_on_air_us(preamble, explicit, len)
}

pub fn slow(sf: u8, bw: u8, preamble: Option<u8>, explicit: bool, len: u8) -> u32 {
    let params = BaseBandModulationParams::new(factor(sf), bandwidth(bw), CodingRate::_4_8);
    params.time_on_air_us(preamble, explicit, len)
}

pub fn symbols(sf: u8, bw: u8, delay: u32, count: u32) -> (u16, u32, bool, u32) {
    let params = BaseBandModulationParams::new(factor(sf), bandwidth(bw), CodingRate::_4_6);
    (params.delay_in_symbols(delay), params.symbols_to_ms(count), params.ldro, params.bw.into())
}
