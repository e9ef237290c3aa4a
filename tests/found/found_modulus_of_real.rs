use bessemer::nalgebra::{ComplexField, RealField, Complex};
#[function]
pub fn found_modulus_of_real(x: f64, y: f32) -> f64 {
    x.modulus() + f64::from(y.modulus())
}
// helper
#[function]
fn found_modulus_of_real_size<T: RealField + Copy>(x: T, y: T) -> T {
    x.modulus() + y
}
#[function]
pub fn found_modulus_of_real_generic(x: f64, y: f32) -> f64 { found_modulus_of_real_size(x, x) + f64::from(found_modulus_of_real_size(y, 2.0)) }
#[function]
pub fn found_modulus_of_real_complex(x: f64, y: f64) -> f64 { Complex::new(x, y).modulus() + Complex::new(x, y).argument() }
