//! The types of random programs, and those that a program declares.

use std::fmt::Write as _;

use bessemer_tests::random::Random;

/// A type of the DSL's Rust.
#[derive(Clone, Debug, PartialEq)]
pub enum Ty {
    Int(&'static str),
    Float(&'static str),
    Bool,
    Array(Box<Ty>, usize),
    Tuple(Vec<Ty>),
    Struct(usize),
    Enum(usize),
    Option(Box<Ty>),
    Result(Box<Ty>, Box<Ty>),
    List(Box<Ty>, usize),
}

pub const INTS: [&str; 10] =
    ["u8", "i8", "u16", "i16", "u32", "i32", "u64", "i64", "usize", "isize"];

impl Ty {
    pub fn is_scalar(&self) -> bool {
        matches!(self, Ty::Int(_) | Ty::Float(_) | Ty::Bool)
    }

    pub fn is_number(&self) -> bool {
        matches!(self, Ty::Int(_) | Ty::Float(_))
    }
}

/// How many bits an integer has, and whether it is signed.
pub fn width(int: &str) -> (u32, bool) {
    let bits = match int {
        "usize" | "isize" => 64,
        other => other[1..].parse().unwrap_or(64),
    };
    (bits, int.starts_with('i'))
}

/// The fields or the payload of something: their names, none where they have none.
pub struct Parts {
    pub names: Vec<String>,
    pub types: Vec<Ty>,
}

impl Parts {
    /// `{ a: 1, b: 2 }` or `(1, 2)` of the texts of the parts.
    pub fn filled(&self, texts: &[String]) -> String {
        if self.types.is_empty() {
            return String::new();
        }
        if self.names.is_empty() {
            return format!("({})", texts.join(", "));
        }
        let named: Vec<_> =
            self.names.iter().zip(texts).map(|(name, text)| format!("{name}: {text}")).collect();
        format!(" {{ {} }}", named.join(", "))
    }
}

/// What a program declares.
#[derive(Default)]
pub struct Items {
    /// Each with its fields.
    pub structs: Vec<(String, Parts)>,
    /// Each with its variants, of which the first has no payload.
    pub enums: Vec<(String, Vec<(String, Parts)>)>,
}

impl Items {
    /// Some structs and enums for the program of this prefix; each may hold those before it.
    pub fn new(random: &mut Random, prefix: &str) -> Items {
        let mut items = Items::default();
        for index in 0..1 + random.below(3) {
            let name = format!("{prefix}{}", ["Alpha", "Beta", "Gamma"][index]);
            if random.one_in(2) {
                let count = 1 + random.below(4);
                let parts = items.parts(random, count, true);
                items.structs.push((name, parts));
            } else {
                let plain = random.one_in(3);
                let mut variants = Vec::new();
                for variant in ["Idle", "Go", "Turn", "Stop"].iter().take(2 + random.below(3)) {
                    let count = if plain || variants.is_empty() { 0 } else { random.below(3) };
                    let parts = items.parts(random, count, true);
                    variants.push(((*variant).to_owned(), parts));
                }
                items.enums.push((name, variants));
            }
        }
        items
    }

    fn parts(&self, random: &mut Random, count: usize, plain: bool) -> Parts {
        let types = (0..count).map(|_| self.any(random, 2, plain)).collect();
        let names = if random.one_in(3) {
            Vec::new()
        } else {
            ["low", "rate", "mode", "index"][..count].iter().map(|it| (*it).to_owned()).collect()
        };
        Parts { names, types }
    }

    /// Any type, in fields (`plain`) one that has a default.
    pub fn any(&self, random: &mut Random, depth: usize, plain: bool) -> Ty {
        let inner = |random: &mut Random| Box::new(self.any(random, depth - 1, plain));
        match random.below(if depth == 0 { 12 } else { 24 }) {
            0..=7 => Ty::Int(random.of(&INTS)),
            8 | 9 => Ty::Float(random.of(&["f64", "f64", "f32"])),
            10 => Ty::Bool,
            11 => Ty::Int("u8"),
            12..=14 => Ty::Array(inner(random), 1 + random.below(4)),
            15 => Ty::Tuple((0..2 + random.below(2)).map(|_| *inner(random)).collect()),
            16 | 17 if !self.structs.is_empty() => Ty::Struct(random.below(self.structs.len())),
            18 | 19 if !self.enums.is_empty() => Ty::Enum(random.below(self.enums.len())),
            20 | 21 => Ty::Option(inner(random)),
            22 => Ty::List(Box::new(self.any(random, depth - 1, true)), 2 + random.below(3)),
            23 if !plain => Ty::Result(inner(random), inner(random)),
            _ => Ty::Int(random.of(&["u8", "i16", "u32", "i64"])),
        }
    }

    /// As Rust writes it.
    pub fn name(&self, ty: &Ty) -> String {
        match ty {
            Ty::Int(name) | Ty::Float(name) => (*name).to_owned(),
            Ty::Bool => "bool".to_owned(),
            Ty::Array(element, len) => format!("[{}; {len}]", self.name(element)),
            Ty::Tuple(parts) => {
                let parts: Vec<_> = parts.iter().map(|part| self.name(part)).collect();
                format!("({})", parts.join(", "))
            }
            Ty::Struct(index) => self.structs[*index].0.clone(),
            Ty::Enum(index) => self.enums[*index].0.clone(),
            Ty::Option(inner) => format!("Option<{}>", self.name(inner)),
            Ty::Result(ok, err) => format!("Result<{}, {}>", self.name(ok), self.name(err)),
            Ty::List(element, len) => format!("List<{}, {len}>", self.name(element)),
        }
    }

    /// The declarations.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for (name, parts) in &self.structs {
            let types: Vec<_> = parts.types.iter().map(|ty| self.name(ty)).collect();
            let body = if parts.names.is_empty() {
                format!(
                    "({});",
                    types.iter().map(|ty| format!("pub {ty}")).collect::<Vec<_>>().join(", ")
                )
            } else {
                let fields = parts.names.iter().zip(&types);
                let fields: Vec<_> = fields.map(|(name, ty)| format!("pub {name}: {ty}")).collect();
                format!(" {{ {} }}", fields.join(", "))
            };
            let _ = writeln!(text, "#[data]\n{DERIVES}\npub struct {name}{body}");
        }
        for (name, variants) in &self.enums {
            let _ = writeln!(text, "#[data]\n{DERIVES}\npub enum {name} {{\n    #[default]");
            for (variant, parts) in variants {
                let types: Vec<_> = parts.types.iter().map(|ty| self.name(ty)).collect();
                let _ = writeln!(text, "    {variant}{},", parts.filled(&types));
            }
            text.push_str("}\n");
        }
        text
    }
}

const DERIVES: &str = "#[derive(Clone, Copy, Debug, Default, PartialEq)]";
