//! Random types and functions that are generic, and their instances.

use super::types::{INTS, Parts, Ty};
use super::writer::{Callee, Kind, Writer};

/// A generic struct: its methods are taken or left.
const LINE: &str = "#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NAME<T, const N: usize> { pub low: T, pub line: [T; N], pub at: usize }
impl<T: Copy + Default, const N: usize> Default for NAME<T, N> {
    fn default() -> Self { NAME { low: T::default(), line: [T::default(); N], at: 0 } }
}
#[data]
impl<T: Copy + PartialOrd, const N: usize> NAME<T, N> {
    pub fn PREFIX_turned(&mut self, x: T) -> T {
        let old = self.line[self.at % N];
        self.line[self.at % N] = x;
        self.at = self.at.wrapping_add(1);
        old
    }
    pub fn PREFIX_largest(&self) -> T {
        self.line.iter().fold(self.low, |most, x| if *x > most { *x } else { most })
    }
    pub fn PREFIX_found(&self, wanted: T) -> Option<usize> {
        self.line.iter().position(|x| *x == wanted)
    }
    pub fn PREFIX_with(self, low: T) -> NAME<T, N> { NAME { low, ..self } }
    pub fn PREFIX_each(&mut self, change: impl Fn(T) -> T) -> usize {
        for x in &mut self.line { *x = change(*x); }
        N
    }
}
";

/// A generic enum.
const MAYBE: &str = "#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum NAME<T> { #[default] Nothing, Just(T), Both { low: T, rate: u8 } }
#[data]
impl<T: Copy> NAME<T> {
    pub fn PREFIX_or(&self, other: T) -> T {
        match self { NAME::Nothing => other, NAME::Just(x) => *x, NAME::Both { low, .. } => *low }
    }
    pub fn PREFIX_as_option(self) -> Option<T> {
        match self { NAME::Both { rate: 0, .. } | NAME::Nothing => None, NAME::Just(x) => Some(x), NAME::Both { low, .. } => Some(low) }
    }
}
";

/// Generic functions.
const FUNCTIONS: &str = "#[function]
fn NAME_larger<T: PartialOrd + Copy>(a: T, b: T) -> T { if b > a { b } else { a } }
#[function]
fn NAME_counted<T: PartialEq + Copy, const N: usize>(values: [T; N], of: T) -> usize {
    values.iter().filter(|x| **x == of).count() + 10 * N
}
#[function]
fn NAME_nearest<T: Copy, const N: usize>(values: [T; N], far: impl Fn(T) -> u32) -> T {
    let mut best = values[0];
    for x in values { if far(x) < far(best) { best = x; } }
    best
}
#[function]
fn NAME_visit<T: Copy, F: FnMut(T) -> bool>(first: T, second: T, mut visit: F) -> u8 {
    if visit(first) && visit(second) { 2 } else { 1 }
}
";

impl Writer<'_> {
    fn callee(&mut self, name: String, params: Vec<(Ty, Kind)>, result: Ty, method: bool) {
        self.callees.push(Callee { name, params, result, method });
    }

    /// Generic types of the program, some instances of each.
    pub fn generic_types(&mut self, prefix: &str) -> String {
        let upper = prefix.to_uppercase();
        let (line, maybe) = (format!("{upper}Line"), format!("{upper}Maybe"));
        for _ in 0..1 + self.below(2) {
            let of = self.items.any(self.random, 0, true);
            let len = 1 + self.below(4);
            let name = format!("{line}<{}, {len}>", self.items.name(&of));
            if self.items.structs.iter().any(|it| it.0 == name) {
                continue;
            }
            let array = Ty::Array(Box::new(of.clone()), len);
            let names = ["low", "line", "at"].map(str::to_owned).into();
            let types = vec![of.clone(), array, Ty::Int("usize")];
            self.items.structs.push((name, Parts { names, types }));
            let this = Ty::Struct(self.items.structs.len() - 1);
            self.methods_of_line(prefix, &this, &of);
        }
        for _ in 0..1 + self.below(2) {
            let of = self.items.any(self.random, 1, true);
            let name = format!("{maybe}<{}>", self.items.name(&of));
            if self.items.enums.iter().any(|it| it.0 == name) {
                continue;
            }
            let parts = |names: &[&str], types: &[Ty]| Parts {
                names: names.iter().map(|it| (*it).to_owned()).collect(),
                types: types.to_vec(),
            };
            let variants = vec![
                ("Nothing".to_owned(), parts(&[], &[])),
                ("Just".to_owned(), parts(&[], std::slice::from_ref(&of))),
                ("Both".to_owned(), parts(&["low", "rate"], &[of.clone(), Ty::Int("u8")])),
            ];
            self.items.enums.push((name, variants));
            let this = Ty::Enum(self.items.enums.len() - 1);
            let (or, option) = (format!("{prefix}_or"), format!("{prefix}_as_option"));
            let lent = (this.clone(), Kind::Shared);
            self.callee(or, vec![lent, (of.clone(), Kind::Owned)], of.clone(), true);
            let own = vec![(this, Kind::Owned)];
            self.callee(option, own, Ty::Option(Box::new(of)), true);
        }
        LINE.replace("NAME", &line).replace("PREFIX", prefix)
            + &MAYBE.replace("NAME", &maybe).replace("PREFIX", prefix)
    }

    fn methods_of_line(&mut self, prefix: &str, this: &Ty, of: &Ty) {
        let method = |name: &str| format!("{prefix}_{name}");
        let with = |kind: Kind, more: Vec<(Ty, Kind)>| [vec![(this.clone(), kind)], more].concat();
        let value = || vec![(of.clone(), Kind::Owned)];
        let closure = vec![(of.clone(), Kind::Closure(of.clone(), false))];
        let usize_ = Ty::Int("usize");
        self.callee(method("turned"), with(Kind::Exclusive, value()), of.clone(), true);
        self.callee(method("largest"), with(Kind::Shared, Vec::new()), of.clone(), true);
        let found = Ty::Option(Box::new(usize_.clone()));
        self.callee(method("found"), with(Kind::Shared, value()), found, true);
        self.callee(method("with"), with(Kind::Owned, value()), this.clone(), true);
        self.callee(method("each"), with(Kind::Exclusive, closure), usize_, true);
    }

    /// Generic functions, with some of the types that they may be called with.
    pub fn generic_functions(&mut self, name: &str) -> String {
        for _ in 0..3 {
            let of = self.items.any(self.random, 0, true);
            let (value, len) = ((of.clone(), Kind::Owned), 1 + self.below(4));
            let array = (Ty::Array(Box::new(of.clone()), len), Kind::Owned);
            let two = vec![value.clone(), value.clone()];
            self.callee(format!("{name}_larger"), two.clone(), of.clone(), false);
            let counted = vec![array.clone(), value];
            self.callee(format!("{name}_counted"), counted, Ty::Int("usize"), false);
            let far = (Ty::Int("u32"), Kind::Closure(of.clone(), false));
            self.callee(format!("{name}_nearest"), vec![array, far], of.clone(), false);
            let visit = vec![(Ty::Bool, Kind::Closure(of, true))];
            self.callee(format!("{name}_visit"), [two, visit].concat(), Ty::Int("u8"), false);
        }
        FUNCTIONS.replace("NAME", name)
    }

    /// A function of two of any float.
    pub fn generic(&mut self, name: &str) -> String {
        let body = self.real(3);
        for float in ["f32", "f64"] {
            let ty = Ty::Float(float);
            let params = vec![(ty.clone(), Kind::Owned), (ty.clone(), Kind::Owned)];
            self.callee(name.to_owned(), params, ty, false);
        }
        format!("#[function]\nfn {name}<T: Real>(x: T, y: T) -> T {{ {body} }}\n")
    }

    fn real(&mut self, fuel: usize) -> String {
        if fuel == 0 {
            return self.random.of(&["x", "y", "x", "y", "T::ONE", "T::PI", "T::MAX"]).to_owned();
        }
        let one = self.real(fuel - 1);
        match self.below(9) {
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
            7 => {
                let int = self.random.of(&INTS);
                format!("real::<T>({one}.as_f64() as {int} as f64)")
            }
            _ => {
                let (then, otherwise) = (self.real(fuel - 1), self.real(fuel - 1));
                format!("(if {one} < {} {{ {then} }} else {{ {otherwise} }})", self.real(0))
            }
        }
    }
}
