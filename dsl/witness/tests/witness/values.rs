//! Types: literals, inference, shadowing, references, constants, structs and components.

#![allow(clippy::needless_late_init, clippy::let_and_return, clippy::needless_lifetimes)]
#![allow(clippy::needless_return)]

use bessemer::prelude::*;

use super::{BOOL, F32, F64, function, int, lets, named, shared, signature};
use bessemer::generate::tree::{DefinitionKind, Ty};
use bessemer_tree::number::{Float, Int, Scalar};

/// Inner struct.
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inner {
    /// A level.
    pub level: f32,
    /// A mode.
    pub mode: Mode,
}

impl Default for Inner {
    fn default() -> Inner {
        Inner { level: 1.5, mode: Mode::Fast }
    }
}

/// A mode.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// Slowly.
    Slow,
    /// Quickly.
    Fast,
}

/// Outer struct.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outer {
    /// The component inside.
    pub inner: Inner,
    /// A matrix.
    pub gain: Matrix2<f64>,
    /// With a name that Rust and C both reserve.
    pub r#type: [i16; 3],
}

#[component]
impl Outer {
    /// Half of something.
    pub const HALF: f64 = 0.5;

    /// One period.
    ///
    /// Twice as documented.
    #[entry(infallible)]
    pub fn step(&mut self, r#in: f64, mut scale: f64, pair: &'_ Pair) -> f64 {
        scale *= Self::HALF;
        self.r#type[1] = 7;
        self.reset(r#in * scale);
        pair.sum()
    }

    fn reset(&mut self, level: f64) {
        self.inner.level = level as f32;
        self.inner.mode = Mode::Slow;
    }
}

/// Two values.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    /// The first.
    pub a: f64,
    /// The second.
    pub b: f64,
}

#[data]
impl Pair {
    /// Both, with shorthand fields.
    pub fn of(a: f64, b: f64) -> Self {
        Self { a, b }
    }

    /// The sum.
    pub fn sum(&self) -> f64 {
        self.a + self.b
    }

    /// By value.
    pub fn swapped(self) -> Pair {
        Pair { a: self.b, b: self.a }
    }
}

/// A limit.
pub const LIMIT: u8 = 200;

/// Literals whose type only rustc knows.
#[function]
pub fn literals(n: u16, y: f32, table: &[i8; 2]) -> bool {
    const LOCAL: i64 = 1 << 40;
    let whole = 1;
    let fraction = 2.5;
    let like_n = 4;
    let like_y = 0.25;
    let from_const = LIMIT;
    let local = LOCAL;
    let shifted = n << 2;
    let element = table[whole];
    let later;
    let _ = shifted;
    let _: f32 = like_y;
    if n == like_n {
        later = 1;
    } else {
        later = LIMIT;
    }
    n == like_n && y < like_y && fraction > 1.0 && local > 0 && element > 0 && later == from_const
}

/// Binds one name to four types.
#[function]
pub fn shadowing(x: u32) -> f64 {
    let x = x as f32;
    let x = x > 1.0;
    let x = if x { 1.0 } else { 2.0 };
    x
}

/// References, and what they refer to.
#[function]
pub fn references(pair: &mut Pair, count: &mut u32, v: &Vector3<f64>) -> f64 {
    let twice = v * 2.0;
    let borrowed = &twice;
    let copied = *borrowed;
    let first = &mut pair.a;
    *first = copied.x;
    *count += 1;
    let product = borrowed.transpose() * v;
    product[(0, 0)]
}

/// A lifetime of its own, and attributes.
#[function]
#[must_use]
pub fn lifetimes<'a>(v: &'a Vector3<f64>, #[allow(unused)] spare: f64) -> f64 {
    #[allow(unused_mut)]
    let mut view: &'a Vector3<f64> = v;
    #[rustfmt::skip]
    let result = view.x;
    result
}

/// Nothing to do, and nothing to give.
#[function]
pub fn empty() {}

/// Leaves at the end.
#[function]
pub fn r#return(x: f64) -> f64 {
    {
        let _inner = x;
    }
    return x;
}

#[test]
fn literals_have_the_type_that_rustc_inferred() {
    let expected = [
        ("whole", int(Int::Usize)),
        ("fraction", F64),
        ("like_n", int(Int::U16)),
        ("like_y", F32),
        ("from_const", int(Int::U8)),
        ("local", int(Int::I64)),
        ("shifted", int(Int::U16)),
        ("element", int(Int::I8)),
        ("later", int(Int::U8)),
        ("_unused", int(Int::U16)),
        ("_unused", F32),
    ];
    let expected = expected.map(|(name, ty)| (name.to_owned(), ty));
    assert_eq!(lets(&function("values::literals")), expected);
}

#[test]
fn constants_have_the_value_that_rustc_computed() {
    let words: Vec<_> =
        function("values::literals").constants.into_iter().map(|it| it.words).collect();
    assert_eq!(words, [[200], [1 << 40], [200]]);
    let step = function("values::Outer::step");
    assert_eq!(step.constants[0].words, [0.5_f64.to_bits()]);
    let reset = function("values::Outer::reset");
    assert_eq!((&reset.constants[0].ty, reset.constants[0].words[0]), (&named("values::Mode"), 0));
}

#[test]
fn a_shadowing_name_has_its_own_type() {
    let function = function("values::shadowing");
    let types: Vec<_> = lets(&function).into_iter().map(|(_, ty)| ty).collect();
    assert_eq!(types, [F32, BOOL, F64]);
}

#[test]
fn references_keep_their_kind() {
    let function = function("values::references");
    let vector = Ty::Matrix(Scalar::Float(Float::F64), 3, 1);
    let types: Vec<_> = lets(&function).into_iter().map(|(_, ty)| ty).collect();
    let exclusive = Ty::Ref(Box::new(F64), true);
    let scalar = Ty::Matrix(Scalar::Float(Float::F64), 1, 1);
    assert_eq!(types, [vector.clone(), shared(vector.clone()), vector.clone(), exclusive, scalar]);
    let (params, result) = signature(&function);
    assert_eq!(params[0], ("pair", Ty::Ref(Box::new(named("values::Pair")), true)));
    assert_eq!(params[2], ("v", shared(vector)));
    assert_eq!(result, F64);
}

#[test]
fn raw_names_travel_without_their_prefix() {
    let step = function("values::Outer::step");
    let names: Vec<_> = signature(&step).0.into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["self", "in", "scale", "pair"]);
    assert_eq!(signature(&function("values::return")).1, F64);
}

#[test]
fn lifetimes_and_attributes_stay_behind() {
    let function = function("values::lifetimes");
    let vector = shared(Ty::Matrix(Scalar::Float(Float::F64), 3, 1));
    assert_eq!(lets(&function), [("view".to_owned(), vector), ("result".to_owned(), F64)]);
    assert_eq!(signature(&super::function("values::empty")), (Vec::new(), Ty::Unit));
}

#[test]
fn a_component_starts_as_its_default_does() {
    let types = super::package().types;
    let outer =
        types.iter().find(|it| it.path == "witness::values::Outer").expect("Outer is there");
    let DefinitionKind::Struct { fields, initial, .. } = &outer.kind else { panic!("a struct") };
    let names: Vec<_> = fields.iter().map(|field| field.name.as_str()).collect();
    assert_eq!(names, ["inner", "gain", "type"]);
    assert_eq!(fields[0].docs, ["The component inside."]);
    let mut words = vec![1.5_f32.to_bits() as u64, 1];
    words.extend([0; 4 + 3]);
    assert_eq!(initial.as_deref(), Some(words.as_slice()));
}

#[test]
fn the_rust_runs_as_written() {
    let mut outer = Outer::default();
    let pair = Pair::of(3.0, 4.0).swapped();
    assert_eq!(outer.step(8.0, 2.0, &pair), 7.0);
    assert_eq!(outer.inner, Inner { level: 8.0, mode: Mode::Slow });
    assert!(!literals(5, 0.0, &[1; 2]));
    assert_eq!(shadowing(2), 1.0);
    let (mut pair, mut count) = (pair, 0);
    assert_eq!(references(&mut pair, &mut count, &Vector3::new(1.0, 2.0, 3.0)), 28.0);
    assert_eq!((pair.a, count), (2.0, 1));
    assert_eq!(lifetimes(&Vector3::new(1.0, 2.0, 3.0), 0.0), 1.0);
    empty();
    assert_eq!(r#return(1.0), 1.0);
}
