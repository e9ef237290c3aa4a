// Locals and parameters that are called as functions of C's library, beside calls of these.
#[function]
pub fn found_names_of_functions_0(x: f64, y: f32, z: i32) -> f64 {
    let ceil = x + 1.0;
    let round = x.round();
    let trunc = ceil.trunc();
    let floor = (ceil + round).floor();
    let ceilf = y.ceil();
    let truncf = y.trunc() + ceilf.trunc();
    let roundf = y.round();
    let fabs = x.abs();
    let memset = z;
    let abort = z ^ 1;
    let memmove = 3;
    let isnan = x.is_nan();
    let sqrt = x.sqrt();
    let mut cells = [0_i32; 64];
    cells[(z & 63) as usize] = abort;
    let sum = floor + trunc + fabs + (truncf + ceilf.ceil() + roundf.round()) as f64;
    sum + (memset as f64) + (memmove as f64) + (cells[7] as f64) + if isnan { 1.0 } else { sqrt.sqrt() } + trunc.trunc()
}
#[function]
pub fn found_names_of_functions_1(ceil: f64, round: f64, trunc: f32, memset: &mut [f64; 40], roundf: f32) -> f64 {
    *memset = [0.0; 40];
    memset[0] = ceil.ceil() + round.round();
    memset[3] = trunc.trunc() as f64 + roundf.round() as f64;
    memset[0] - memset[3]
}
