//! Random integers and floats.

use super::types::{INTS, Ty, width};
use super::writer::Writer;

impl Writer<'_> {
    pub fn integer(&mut self, name: &'static str, fuel: usize) -> String {
        let ty = Ty::Int(name);
        let (bits, signed) = width(name);
        let less = fuel - 1;
        match self.below(26) {
            16 | 17 => return self.converted(name, less),
            18 => return self.of_sequence(&ty, less).unwrap_or_else(|| self.simple(&ty)),
            19 => return self.of_text(&ty, less).unwrap_or_else(|| self.simple(&ty)),
            20 => return self.of_bounded(&ty, less).unwrap_or_else(|| self.simple(&ty)),
            21 if matches!(name, "u32" | "u64") => {
                let float = if name == "u32" { "f32" } else { "f64" };
                return format!("{}.to_bits()", self.value(&Ty::Float(float), less));
            }
            22 if name != "usize" && name != "isize" => {
                let bytes = Ty::Array(Box::new(Ty::Int("u8")), bits as usize / 8);
                let end = self.random.of(&["le", "be"]);
                return format!("{name}::from_{end}_bytes({})", self.value(&bytes, less));
            }
            _ => {}
        }
        let one = self.value(&ty, less);
        match self.below(22) {
            0..=2 => {
                let operator = self.random.of(&["add", "sub", "mul"]);
                format!("{one}.wrapping_{operator}({})", self.value(&ty, less))
            }
            3 if self.risky() => {
                let operator = self.random.of(&["div", "rem"]);
                format!("{one}.wrapping_{operator}({})", self.value(&ty, less))
            }
            3 | 4 => {
                let operator = self.random.of(&["add", "sub", "mul"]);
                format!("{one}.saturating_{operator}({})", self.value(&ty, less))
            }
            5 if self.risky() || self.one_in(3) => {
                let operator = self.random.of(&["+", "-", "*", "/", "%"]);
                format!("({one} {operator} {})", self.value(&ty, less))
            }
            6 => {
                let operator = self.random.of(&["/", "%"]);
                format!("({one} {operator} {})", 1 + self.below(9))
            }
            7 => {
                let operator = self.random.of(&["&", "|", "^"]);
                format!("({one} {operator} {})", self.value(&ty, less))
            }
            8 => {
                let operator = self.random.of(&["<<", ">>"]);
                if self.risky() {
                    let by = Ty::Int(self.random.of(&INTS));
                    return format!("({one} {operator} {})", self.value(&by, less));
                }
                format!("({one} {operator} {})", self.below(bits as usize))
            }
            9 => {
                let method = self.random.of(&["min", "max"]);
                format!("{one}.{method}({})", self.value(&ty, less))
            }
            10 if signed => {
                let method = self.random.of(&["wrapping_abs", "signum", "wrapping_neg"]);
                format!("{one}.{method}()")
            }
            10 => format!("{one}.abs_diff({})", self.value(&ty, less)),
            11 => format!("(!{one})"),
            12 => {
                let method = self.random.of(&[
                    "count_ones",
                    "count_zeros",
                    "leading_zeros",
                    "leading_ones",
                    "trailing_zeros",
                    "trailing_ones",
                ]);
                format!("({one}.{method}() as {name})")
            }
            13 => {
                let by = self.value(&Ty::Int("u32"), less);
                let method = self.random.of(&[
                    "rotate_left",
                    "rotate_right",
                    "wrapping_shl",
                    "wrapping_shr",
                ]);
                format!("{one}.{method}({by})")
            }
            14 => format!("{one}.swap_bytes()"),
            15 => {
                let method = self.random.of(&["rem_euclid", "div_euclid"]);
                let by = if self.risky() {
                    self.value(&ty, less)
                } else {
                    (1 + self.below(9)).to_string()
                };
                format!("{one}.{method}({by})")
            }
            16 if self.risky() => format!("{one}.pow({})", self.below(4)),
            16 => format!("{one}.wrapping_pow({})", self.value(&Ty::Int("u32"), less)),
            17 => format!("{one}.clamp({}, {})", self.below(3), 3 + self.below(5)),
            18 if signed && self.risky() => format!("{one}.abs()"),
            19 if signed && self.risky() => format!("(-{one})"),
            20 => format!("({one}.cmp(&{}) as {name})", self.value(&ty, less)),
            _ => {
                let from = self.items.any(self.random, 0, true);
                format!("({} as {name})", self.value(&from, less))
            }
        }
    }

    /// An integer that was another scalar, an enum without payload, or none at all.
    fn converted(&mut self, name: &'static str, fuel: usize) -> String {
        let (bits, signed) = width(name);
        match self.below(5) {
            0 | 1 => {
                let fits = |it: &&str| {
                    let (from, of_signed) = width(it);
                    let sized = it.ends_with("size");
                    !sized && from < bits && (signed || !of_signed) && !name.ends_with("size")
                };
                let from: Vec<_> = INTS.into_iter().filter(fits).collect();
                if from.is_empty() {
                    return format!("{name}::from({})", self.value(&Ty::Bool, fuel));
                }
                let from = self.random.of(&from);
                format!("{name}::from({})", self.value(&Ty::Int(from), fuel))
            }
            2 | 3 => {
                // What always fits is no question.
                let (bits, signed) = width(name);
                let sized = name.ends_with("size");
                let fits = |it: &&str| {
                    let (from, of_signed) = width(it);
                    let always = from < bits && (signed || !of_signed)
                        || from == bits && signed == of_signed;
                    !always || sized != it.ends_with("size") && from >= 32
                };
                let from: Vec<_> = INTS.into_iter().filter(fits).collect();
                let from = self.random.of(&from);
                let value = self.value(&Ty::Int(from), fuel);
                let otherwise = self.value(&Ty::Int(name), fuel);
                format!("{name}::try_from({value}).unwrap_or({otherwise})")
            }
            _ => {
                let plain = self.items.enums.iter().position(|(_, variants)| {
                    variants.iter().all(|(_, parts)| parts.types.is_empty())
                });
                let from = plain.map_or(Ty::Bool, Ty::Enum);
                format!("({} as {name})", self.value(&from, fuel))
            }
        }
    }

    pub fn float(&mut self, name: &'static str, fuel: usize) -> String {
        let ty = Ty::Float(name);
        let less = fuel - 1;
        let one = self.value(&ty, less);
        match self.below(18) {
            9 | 10 => self.of_matrix(&ty, less).unwrap_or(one),
            11 => self.of_bounded(&ty, less).unwrap_or(one),
            0..=4 => {
                let operator = self.random.of(&["+", "-", "*", "/", "%"]);
                format!("({one} {operator} {})", self.value(&ty, less))
            }
            5 => format!("(-{one})"),
            6 => {
                let method = self.random.of(&[
                    "abs", "sqrt", "floor", "ceil", "trunc", "round", "fract", "signum", "recip",
                ]);
                format!("{one}.{method}()")
            }
            7 => {
                let method =
                    self.random.of(&["min", "max", "copysign", "rem_euclid", "div_euclid"]);
                format!("{one}.{method}({})", self.value(&ty, less))
            }
            12 => {
                let method = self.random.of(&["sin", "cos", "exp", "ln", "tanh", "atan"]);
                format!("{one}.{method}()")
            }
            13 => {
                let method = self.random.of(&["atan2", "hypot", "powf"]);
                format!("{one}.{method}({})", self.value(&ty, less))
            }
            14 => format!("{one}.clamp(-1.5, {}.5)", self.below(4)),
            15 => {
                let (factor, more) = (self.value(&ty, less), self.value(&ty, less));
                format!("{one}.mul_add({factor}, {more})")
            }
            16 => {
                let int = if name == "f32" { "u32" } else { "u64" };
                format!("{name}::from_bits({})", self.value(&Ty::Int(int), less))
            }
            17 => {
                let other = if name == "f32" { "f64" } else { "f32" };
                format!("({} as {name})", self.value(&Ty::Float(other), less))
            }
            _ => {
                let from = Ty::Int(self.random.of(&INTS));
                format!("({} as {name})", self.value(&from, less))
            }
        }
    }

    /// Bytes that are an integer or a float, or a text's.
    pub fn bytes(&mut self, len: usize, fuel: usize) -> Option<String> {
        let less = fuel.checked_sub(1)?;
        if self.one_in(3) {
            let text = self.place(false, &|ty| *ty == Ty::Text(len))?;
            return Some(format!("{}.bytes()", text.text));
        }
        let of = match len {
            1 => Ty::Int("i8"),
            2 => Ty::Int("u16"),
            4 => Ty::Float("f32"),
            8 => Ty::Float("f64"),
            _ => return None,
        };
        let end = self.random.of(&["le", "be"]);
        Some(format!("{}.to_{end}_bytes()", self.value(&of, less)))
    }
}
