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
    /// Matrix of scalars: rows and columns.
    Matrix(&'static str, usize, usize),
    /// A text of at most so many bytes.
    Text(usize),
    /// Matrix of scalars: largest numbers of rows and columns.
    Bounded(&'static str, usize, usize),
    /// Behind a reference only.
    Slice(Box<Ty>),
    /// A component: a place to call, never a value.
    Unit(usize),
}

pub const INTS: [&str; 10] =
    ["u8", "i8", "u16", "i16", "u32", "i32", "u64", "i64", "usize", "isize"];

impl Ty {
    pub fn is_scalar(&self) -> bool {
        matches!(self, Ty::Int(_) | Ty::Float(_) | Ty::Bool)
    }

    /// Returns true if values of it may be copied.
    pub fn is_data(&self) -> bool {
        match self {
            Ty::Unit(_) | Ty::Slice(_) => false,
            Ty::Array(element, _) => element.is_data(),
            _ => true,
        }
    }

    /// Returns the element type of a matrix.
    pub fn element(&self) -> Ty {
        match self {
            Ty::Matrix(name, ..) | Ty::Bounded(name, ..) if name.starts_with('f') => {
                Ty::Float(name)
            }
            Ty::Matrix(name, ..) | Ty::Bounded(name, ..) => Ty::Int(name),
            other => other.clone(),
        }
    }

    /// Returns the element type of an array, a list or a slice, and its largest length.
    pub fn sequence(&self) -> Option<(&Ty, usize)> {
        match self {
            Ty::Array(element, len) | Ty::List(element, len) => Some((element, *len)),
            Ty::Slice(element) => Some((element, 3)),
            _ => None,
        }
    }

    pub fn is_number(&self) -> bool {
        matches!(self, Ty::Int(_) | Ty::Float(_))
    }
}

/// Returns the number of bits of an integer, and true if it is signed.
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

/// A type's name as it is in expressions and patterns.
pub fn path(name: &str) -> String {
    name.replacen('<', "::<", 1)
}

/// Returns true if the name is that of an instance of what is generic, whose declaration stands elsewhere.
pub fn is_instance(name: &str) -> bool {
    name.contains('<')
}

/// Declarations of a program.
#[derive(Default)]
pub struct Items {
    /// Each with its fields.
    pub structs: Vec<(String, Parts)>,
    /// Each with its variants, of which the first has no payload.
    pub enums: Vec<(String, Vec<(String, Parts)>)>,
    /// Enums and the integers from which they are made.
    pub from: Vec<(usize, &'static str)>,
    /// Components, each with its fields.
    pub units: Vec<(String, Parts)>,
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

    /// Returns a result type: often a `Result` with an error of its own.
    pub fn returned(&self, random: &mut Random) -> Ty {
        let any = self.any(random, 2, false);
        if self.enums.is_empty() || !random.one_in(4) {
            return any;
        }
        Ty::Result(Box::new(any), Box::new(Ty::Enum(random.below(self.enums.len()))))
    }

    /// An error that `?` makes this error of.
    pub fn error_for(&self, random: &mut Random, error: &Ty) -> Ty {
        let from = self.from.iter().find(|it| *error == Ty::Enum(it.0));
        match from {
            Some((_, int)) if random.one_in(2) => Ty::Int(int),
            _ => error.clone(),
        }
    }

    fn parts(&self, random: &mut Random, count: usize, plain: bool) -> Parts {
        let types = (0..count).map(|_| self.any(random, 2, plain)).collect();
        let names = if random.one_in(3) {
            Vec::new()
        } else {
            FIELDS[..count].iter().map(|it| (*it).to_owned()).collect()
        };
        Parts { names, types }
    }

    /// Any type, in fields (`plain`) one that has a default.
    pub fn any(&self, random: &mut Random, depth: usize, plain: bool) -> Ty {
        let inner = |random: &mut Random| Box::new(self.any(random, depth - 1, plain));
        match random.below(if depth == 0 { 12 } else { 30 }) {
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
            24 | 25 => {
                let element = random.of(&["f64", "f64", "f64", "f32", "i32", "u8"]);
                let cols = if random.one_in(2) { 1 } else { 1 + random.below(4) };
                Ty::Matrix(element, 1 + random.below(4), cols)
            }
            26 => Ty::Text(2 + random.below(4)),
            27 => {
                let element = random.of(&["f64", "f32", "i32", "u8"]);
                Ty::Bounded(element, 1 + random.below(3), 1 + random.below(3))
            }
            28 => Ty::Option(Box::new(Ty::Option(inner(random)))),
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
            Ty::Matrix(element, rows, cols) => format!("SMatrix<{element}, {rows}, {cols}>"),
            Ty::Text(len) => format!("Text<{len}>"),
            Ty::Bounded(element, rows, cols) => format!("BoundedMatrix<{element}, {rows}, {cols}>"),
            Ty::Slice(element) => format!("[{}]", self.name(element)),
            Ty::Unit(index) => self.units[*index].0.clone(),
        }
    }

    /// One more component, which may hold those before it.
    pub fn unit(&mut self, random: &mut Random, name: String) -> usize {
        let count = 1 + random.below(3);
        let mut parts = self.parts(random, count, true);
        parts.names = FIELDS[..count].iter().map(|it| (*it).to_owned()).collect();
        if let Some(inner) = self.units.len().checked_sub(1) {
            parts.names.push("inner".to_owned());
            let inner = Ty::Unit(inner);
            let pair = random.one_in(3);
            parts.types.push(if pair { Ty::Array(Box::new(inner), 2) } else { inner });
        }
        self.units.push((name, parts));
        self.units.len() - 1
    }

    /// The fields of a struct or a component.
    pub fn fields_of(&self, ty: &Ty) -> Option<&Parts> {
        match ty {
            Ty::Struct(index) => Some(&self.structs[*index].1),
            Ty::Unit(index) => Some(&self.units[*index].1),
            _ => None,
        }
    }

    /// The declaration of a component.
    pub fn unit_text(&self, index: usize) -> String {
        let (name, parts) = &self.units[index];
        format!(
            "#[component]\n#[derive(Clone, Debug, Default, PartialEq)]\npub struct {name}{}\n",
            self.fields(parts)
        )
    }

    /// The fields of a struct as they are declared.
    fn fields(&self, parts: &Parts) -> String {
        if parts.names.is_empty() {
            let types = parts.types.iter().map(|ty| format!("pub {}", self.name(ty)));
            return format!("({});", types.collect::<Vec<_>>().join(", "));
        }
        let fields = parts.names.iter().zip(&parts.types);
        let fields: Vec<_> =
            fields.map(|(name, ty)| format!("pub {name}: {}", self.name(ty))).collect();
        format!(" {{ {} }}", fields.join(", "))
    }

    /// The declarations.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for (name, parts) in self.structs.iter().filter(|it| !is_instance(&it.0)) {
            let fields = self.fields(parts);
            let _ = writeln!(text, "#[data]\n{DERIVES}\npub struct {name}{fields}");
        }
        for (name, variants) in self.enums.iter().filter(|it| !is_instance(&it.0)) {
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

const FIELDS: [&str; 4] = ["low", "rate", "mode", "index"];

const DERIVES: &str = "#[derive(Clone, Copy, Debug, Default, PartialEq)]";
