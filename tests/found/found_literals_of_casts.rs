// Literals that are cast, and what gives no type to a literal.
#[function]
pub fn found_literals_of_casts_0(b: bool, n: i32) -> i64 {
    let x = (if b { 200 } else { 300 }) as u8;
    let y = (match n & 3 { 0 => 70000, 1 => 65536, _ => 32768 }) as i16;
    let z = ({ 200 + 100 }) as u8;
    let w = (200 + 100) as u8;
    (x as i64) * 1000000 + (y as i64) * 100 + z as i64 + w as i64
}
#[function]
pub fn found_literals_of_casts_1(b: bool) -> f64 {
    let x = 1.000000059604644775390625000001 as f32;
    let y = (if b { 1.000000059604644775390625000001 } else { 0.1 }) as f32;
    let z = -1.000000059604644775390625000001 as f32;
    let w = (1.000000059604644775390625000001 * 1.0) as f32;
    let v: f32 = 1.000000059604644775390625000001;
    let u = 1.000000059604644775390625000001_f32;
    x as f64 + 2.0 * y as f64 + 4.0 * z as f64 + 8.0 * w as f64 + 16.0 * v as f64 + 32.0 * u as f64
}
#[function]
pub fn found_literals_of_casts_2(a: u8, b: f32, c: f64) -> f64 {
    let x = 0.1 as f32; let y = -1.000000059604644775390625000001 as f32; let z = (1.000000059604644775390625000001) as f32; let w = { 1.000000059604644775390625000001 } as f32; let v = -0 as f32; let u = -0.0 as f32; let t = 1e40 as f32; let s = 16777217 as f32; let r = 3.7 as i8; let q = -3.7 as u8; let p = (-(0.1)) as f32; let o = 5 as f64; let n = 2.5 as f64 as f32; let m = 7_u8 as f32;
    let l = (1.000000059604644775390625000001 + b as f64) as f32;
    x as f64 + y as f64 * 3.0 + z as f64 * 5.0 + w as f64 * 7.0 + 1.0 / v as f64 + 1.0 / u as f64 + t as f64 + s as f64 + r as f64 + q as f64 + p as f64 * 11.0 + o + n as f64 + m as f64 + l as f64 + a as f64 + c
}
