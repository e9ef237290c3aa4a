//! Random functions that are generic over the floats, called with either.

use super::types::Ty;
use super::writer::{Callee, Kind, Writer};

impl Writer<'_> {
    /// A function of two of any float.
    pub fn generic(&mut self, name: &str) -> String {
        let body = self.real(3);
        for float in ["f32", "f64"] {
            let ty = Ty::Float(float);
            let params = vec![(ty.clone(), Kind::Owned), (ty.clone(), Kind::Owned)];
            self.callees.push(Callee { name: name.to_owned(), params, result: ty, method: false });
        }
        format!("#[function]\nfn {name}<T: Real>(x: T, y: T) -> T {{ {body} }}\n")
    }

    fn real(&mut self, fuel: usize) -> String {
        if fuel == 0 {
            return self.random.of(&["x", "y", "x", "y", "T::ONE", "T::PI", "T::MAX"]).to_owned();
        }
        let one = self.real(fuel - 1);
        match self.below(8) {
            0..=2 => {
                let operator = self.random.of(&["+", "-", "*", "/"]);
                format!("({one} {operator} {})", self.real(fuel - 1))
            }
            3 => {
                let (operator, number) =
                    (self.random.of(&["+", "*"]), self.random.of(&["0.5", "0.1", "-3.25"]));
                format!("({one} {operator} real({number}))")
            }
            4 => format!("{one}.{}({})", self.random.of(&["min", "max"]), self.real(fuel - 1)),
            5 => format!("{one}.{}()", self.random.of(&["abs", "sqrt", "floor"])),
            6 => format!("(-{one})"),
            _ => {
                let (then, otherwise) = (self.real(fuel - 1), self.real(fuel - 1));
                format!("(if {one} < {} {{ {then} }} else {{ {otherwise} }})", self.real(0))
            }
        }
    }
}
