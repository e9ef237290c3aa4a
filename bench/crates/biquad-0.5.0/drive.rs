//! Calls of `biquad` over plain numbers.

use crate::*;

fn kind(n: u8, gain: f32) -> Type<f32> {
    match n % 10 {
        0 => Type::SinglePoleLowPassApprox,
        1 => Type::SinglePoleLowPass,
        2 => Type::LowPass,
        3 => Type::HighPass,
        4 => Type::BandPass,
        5 => Type::Notch,
        6 => Type::AllPass,
        7 => Type::LowShelf(gain),
        8 => Type::HighShelf(gain),
        _ => Type::PeakingEQ(gain),
    }
}

pub fn direct(coefficients: [f32; 5], input: [f32; 9]) -> [f32; 9] {
    let mut filter = DirectForm1::<f32>::new(Coefficients {
        a1: coefficients[0],
        a2: coefficients[1],
        b0: coefficients[2],
        b1: coefficients[3],
        b2: coefficients[4],
    });
    let mut out = [0.0; 9];
    for k in 0..9 {
        out[k] = filter.run(input[k]);
    }
    out
}

pub fn transposed(coefficients: [f64; 5], other: [f64; 5], input: [f64; 9]) -> [f64; 9] {
    let [a1, a2, b0, b1, b2] = coefficients;
    let mut filter = DirectForm2Transposed::<f64>::new(Coefficients { a1, a2, b0, b1, b2 });
    let mut out = [0.0; 9];
    for k in 0..4 {
        out[k] = filter.run(input[k]);
    }
    let [a1, a2, b0, b1, b2] = other;
    let old = filter.replace_coefficients(Coefficients { a1, a2, b0, b1, b2 });
    filter.reset_state();
    for k in 4..8 {
        out[k] = filter.run(input[k]);
    }
    filter.update_coefficients(old);
    out[8] = filter.run(input[8]);
    out
}

pub fn designed(n: u8, gain: f32, f0: f32, q: f32) -> ([f32; 5], u8) {
    match Coefficients::<f32>::from_normalized_params(kind(n, gain), f0, q) {
        Ok(it) => ([it.a1, it.a2, it.b0, it.b1, it.b2], 0),
        Err(Errors::OutsideNyquist) => ([0.0; 5], 1),
        Err(Errors::NegativeQ) => ([0.0; 5], 2),
        Err(Errors::NegativeFrequency) => ([0.0; 5], 3),
    }
}

pub fn filtered(rate: f64, f0: f64, q: f64, input: [f64; 9]) -> Option<[f64; 9]> {
    let (Ok(rate), Ok(f0)) = (Hertz::<f64>::from_hz(rate), Hertz::<f64>::from_hz(f0)) else { return None };
    let Ok(coefficients) = Coefficients::<f64>::from_params(Type::LowPass, rate, f0, q) else { return None };
    let mut filter = DirectForm1::<f64>::new(coefficients);
    let mut out = [0.0; 9];
    for k in 0..9 {
        out[k] = filter.run(input[k]);
    }
    Some(out)
}
