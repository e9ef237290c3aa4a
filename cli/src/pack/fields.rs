//! The fields of a message: the numbers that an entry point takes or returns, with structs flattened.
//!
//! Invariants: the names of a message are unique, in lower case, and without two consecutive `_`; a value that no
//! field can contain is listed. It must not know any system.

use std::collections::BTreeSet;

use bessemer_backend::c::interface::{Interface, Struct, Value};
use serde::Serialize;

/// A field of a message.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Field {
    /// Name of the field in the message.
    pub name: String,
    /// Name of the field in capitalised words.
    pub class: String,
    /// Path of its value from the parameter's name: as the place, under the author's name.
    pub path: String,
    /// Place of its value in the C: `measurement.speed`.
    pub place: String,
    /// Type of an element in C; an `int32_t` for an enum.
    pub ty: String,
    /// Type of an element in messages of uORB and ROS.
    pub message: &'static str,
    /// Type of an element in FPP.
    pub fpp: &'static str,
    /// Number of elements; none for a single number.
    pub count: Option<u32>,
    /// The unit.
    pub unit: Option<String>,
    /// The name of the enum, and the values of its enumerators.
    pub choice: Option<(String, Vec<i32>)>,
}

/// Types of C: in messages of uORB and ROS, and in FPP.
const TYPES: &[(&str, &str, &str)] = &[
    ("bool", "bool", "bool"),
    ("float", "float32", "F32"),
    ("double", "float64", "F64"),
    ("int8_t", "int8", "I8"),
    ("int16_t", "int16", "I16"),
    ("int32_t", "int32", "I32"),
    ("int64_t", "int64", "I64"),
    ("uint8_t", "uint8", "U8"),
    ("uint16_t", "uint16", "U16"),
    ("uint32_t", "uint32", "U32"),
    ("uint64_t", "uint64", "U64"),
];

/// The fields of one message, as they are collected.
pub struct Fields<'f> {
    face: &'f Interface,
    taken: BTreeSet<String>,
    /// The variable of the present value in the C, and its name for the author.
    root: (String, String),
    /// The fields.
    pub all: Vec<Field>,
    /// Places that no field holds.
    pub left_out: Vec<String>,
}

impl<'f> Fields<'f> {
    /// Begins a message. `taken` are the names of the fields that the system adds.
    pub fn new(face: &'f Interface, taken: &[&str]) -> Fields<'f> {
        let taken = taken.iter().map(|it| (*it).to_owned()).collect();
        Fields { face, taken, root: Default::default(), all: Vec::new(), left_out: Vec::new() }
    }

    /// Adds the value of a variable of the C, which the author calls `name`.
    pub fn add(&mut self, variable: &str, name: &str, value: &Value) {
        self.root = (variable.to_owned(), name.to_owned());
        self.place(variable, value);
    }

    fn place(&mut self, place: &str, value: &Value) {
        let Some(of) = self.face.structure(&value.ty) else {
            return self.number(place, value);
        };
        for place in elements(place, value) {
            self.structure(&place, of);
        }
    }

    fn structure(&mut self, place: &str, of: &Struct) {
        if !of.whole {
            return self.left_out.push(place.to_owned());
        }
        for field in &of.fields {
            self.place(&format!("{place}.{}", field.name), &field.value);
        }
    }

    fn number(&mut self, place: &str, value: &Value) {
        if let Some(choice) = self.face.enumeration(&value.ty) {
            let values = choice.variants.iter().map(|(_, value, _)| *value).collect::<Vec<_>>();
            for place in elements(place, value) {
                let choice = Some((value.ty.clone(), values.clone()));
                self.push(&place, "int32_t", value, None, choice);
            }
            return;
        }
        let counts: Vec<u32> = value.dimensions.iter().flatten().copied().collect();
        match counts.len() {
            0 => self.push(place, &value.ty, value, None, None),
            several => {
                let first = match several {
                    1 => place.to_owned(),
                    _ => format!("(&{place}{})", "[0]".repeat(several)),
                };
                self.push_as(place, &first, &value.ty, value, Some(counts.iter().product()));
            }
        }
    }

    fn push_as(&mut self, of: &str, place: &str, ty: &str, value: &Value, count: Option<u32>) {
        self.push(of, ty, value, count, None);
        if let Some(field) = self.all.last_mut() {
            place.clone_into(&mut field.place);
        }
    }

    fn push(
        &mut self,
        place: &str,
        ty: &str,
        value: &Value,
        count: Option<u32>,
        choice: Option<(String, Vec<i32>)>,
    ) {
        let Some((_, message, fpp)) = TYPES.iter().find(|it| it.0 == ty) else {
            return self.left_out.push(place.to_owned());
        };
        let name = unique(&small(place), &mut self.taken);
        let (class, place, ty) = (camel(&name), place.to_owned(), ty.to_owned());
        let unit = value.unit.clone();
        let (variable, author) = &self.root;
        let path = format!("{author}{}", place.strip_prefix(variable.as_str()).unwrap_or(&place));
        self.all.push(Field { name, class, path, place, ty, message, fpp, count, unit, choice });
    }
}

/// The places of the elements of an array; of another value, its own.
fn elements(place: &str, value: &Value) -> Vec<String> {
    let mut places = vec![place.to_owned()];
    for count in value.dimensions.iter().flatten() {
        let each = |place: &String| (0..*count).map(|at| format!("{place}[{at}]")).collect();
        places = places.iter().flat_map::<Vec<_>, _>(each).collect();
    }
    places
}

/// Returns the name, or with a number behind it if it is taken.
pub fn unique(name: &str, taken: &mut BTreeSet<String>) -> String {
    let numbered = (2..).map(|at| format!("{name}_{at}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    let free = names.find(|it| !taken.contains(it)).unwrap_or_default();
    taken.insert(free.clone());
    free
}

/// `axes[2].Gain` as `axes_2_gain`.
pub fn small(place: &str) -> String {
    let words = place.split(|it: char| !it.is_ascii_alphanumeric()).filter(|it| !it.is_empty());
    words.collect::<Vec<_>>().join("_").to_ascii_lowercase()
}

/// `motor_step` as `MotorStep`.
pub fn camel(name: &str) -> String {
    let words = name.split('_').filter(|it| !it.is_empty());
    words.map(|it| it[..1].to_ascii_uppercase() + &it[1..]).collect()
}

/// `MotorStepInput` as `motor_step_input`: the name that PX4 and ROS derive from a message's.
pub fn snake(class: &str) -> String {
    let letters: Vec<char> = class.chars().collect();
    let mut name = String::new();
    for (at, letter) in letters.iter().enumerate() {
        let before = at.checked_sub(1).map(|it| letters[it]);
        let small_after = letters.get(at + 1).is_some_and(char::is_ascii_lowercase);
        let begins = letter.is_ascii_uppercase()
            && before.is_some_and(|it| !it.is_ascii_uppercase() || small_after);
        name += if begins { "_" } else { "" };
        name.push(letter.to_ascii_lowercase());
    }
    name
}
