//! Places, which are read and written, where an index may differ from lane to lane.

use std::fmt::Write as _;

use bessemer_ir::{Expr, ExprKind, LocalId, Mode, Place, Span, Step, Type};

use crate::body::{Cx, Result};
use crate::names::word;
use crate::types::{self, is_byte};

/// A place in the emitted text.
pub(crate) enum Path {
    /// An expression for the place.
    Direct(String),
    /// An element of `array` whose `index` differs from lane to lane, and the steps from the element, `.time`.
    Selected { array: String, index: String, rest: String },
}

impl Cx<'_> {
    /// Returns the name of a local.
    pub(crate) fn local(&self, id: LocalId) -> String {
        crate::names::local(self.function, id)
    }

    pub(crate) fn path(&self, place: &Place) -> Result<Path> {
        let local = self.function.local(place.root);
        let mut text = self.local(place.root);
        if place.steps.is_empty()
            && local.mode != Mode::Value
            && !matches!(local.ty, Type::Slice(_))
        {
            text = format!("(*{text})");
        }
        let mut ty = local.ty.clone();
        let mut selected: Option<(String, String)> = None;
        for step in &place.steps {
            let next = self.module.step_type(&ty, step);
            let next = next.ok_or_else(|| self.error(place.span, "has a place without a type"))?;
            match step {
                Step::Field(field) => {
                    let Type::Struct(id) = &ty else {
                        return Err(self.error(place.span, "has a field of no struct"));
                    };
                    let fields = &self.module.structs[id.index()].fields;
                    _ = write!(text, ".{}", word(&fields[*field as usize].name));
                }
                Step::From(index) => {
                    let Some(index) = self.uniform(index) else {
                        let what =
                            "passes elements from an index on that differs from lane to lane";
                        return Err(self.error(place.span, what));
                    };
                    _ = write!(text, "[{index} as usize..]");
                }
                Step::Index(_) | Step::Element(..) => match self.index(&text, &ty, step)? {
                    Index::Uniform(index) => _ = write!(text, "[{index}]"),
                    Index::Lanes(index) if selected.is_none() => {
                        selected = Some((std::mem::take(&mut text), index));
                    }
                    Index::Lanes(_) => {
                        let what = "has two indices in one place that differ from lane to lane";
                        return Err(self.error(place.span, what));
                    }
                },
            }
            ty = next;
        }
        Ok(match selected {
            Some((array, index)) => Path::Selected { array, index, rest: text },
            None => Path::Direct(text),
        })
    }

    /// Returns the index of a step, of a matrix by columns.
    fn index(&self, array: &str, whole: &Type, step: &Step) -> Result<Index> {
        let len = match whole {
            Type::Array { len, .. } => Some(*len),
            Type::Matrix { rows, cols, .. } => Some(rows * cols),
            _ => None,
        };
        let (uniform, lanes) = match (step, whole) {
            (Step::Element(row, column), Type::Matrix { rows, cols, .. }) => {
                let flat = match (self.uniform(row), self.uniform(column)) {
                    (Some(row), Some(_)) if *cols == 1 => Some(row),
                    (Some(row), Some(column)) => Some(format!("{row} + {column} * {rows}")),
                    _ => None,
                };
                let lanes = || {
                    let (row, column) = (self.value(row)?, self.value(column)?);
                    Ok(format!("{row} + {column} * Whole::of({rows})"))
                };
                (flat, if *cols == 1 { self.value(row) } else { lanes() })
            }
            (Step::Index(index), _) => (self.uniform(index), self.value(index)),
            _ => (None, Err(self.error(Span::default(), "has a step that is no index"))),
        };
        Ok(match (uniform, len) {
            (Some(text), Some(len)) => match text.parse::<u32>() {
                Ok(number) if number < len => Index::Uniform(text),
                _ => Index::Uniform(format!("lanes::index({text}, {len})")),
            },
            (Some(text), None) => Index::Uniform(format!("lanes::index({text}, {array}.len())")),
            _ => Index::Lanes(lanes?),
        })
    }

    /// Returns the value of a place.
    pub(crate) fn load(&self, place: &Place) -> Result<String> {
        if let Some(table) = self.tables.get(&place.root) {
            return self.of_table(*table, place);
        }
        if self.is_byte(place) {
            return Ok(match self.path(place)? {
                Path::Direct(text) => format!("{text}.whole()"),
                Path::Selected { array, index, rest } => picked(&array, &index, &rest) + ".whole()",
            });
        }
        let copied = matches!(place.ty, Type::Scalar(_) | Type::Enum(_));
        Ok(match self.path(place)? {
            Path::Direct(text) if copied => text,
            Path::Direct(text) if place.steps.is_empty() && self.moved.contains(&place.root) => {
                text
            }
            Path::Direct(text) => format!("{text}.clone()"),
            Path::Selected { array, index, rest } => picked(&array, &index, &rest),
        })
    }

    /// Returns true if a place is a byte of an array or a struct.
    pub(crate) fn is_byte(&self, place: &Place) -> bool {
        !place.steps.is_empty() && is_byte(&place.ty)
    }

    /// Returns a reference to a value.
    pub(crate) fn reference(&self, expr: &Expr) -> Result<String> {
        if let ExprKind::Load(place) = &expr.kind
            && !self.tables.contains_key(&place.root)
            && !self.is_byte(place)
            && let Path::Direct(text) = self.path(place)?
        {
            return Ok(match text.strip_prefix("(*").and_then(|it| it.strip_suffix(')')) {
                Some(name) => name.to_owned(),
                None => {
                    let root = self.function.local(place.root);
                    let slice = matches!(root.ty, Type::Slice(_)) && place.steps.is_empty();
                    if slice { text } else { format!("&{text}") }
                }
            });
        }
        Ok(format!("&{}", self.value(expr)?))
    }

    /// Returns a value of a constant that is not written, by its index in the words of the constant.
    fn of_table(&self, constant: bessemer_ir::ConstId, place: &Place) -> Result<String> {
        let name = self.names.of_const(constant);
        let mut ty = self.function.local(place.root).ty.clone();
        let (mut offset, mut lanes) = (vec!["0".to_owned()], Vec::new());
        for step in &place.steps {
            let next = self.module.step_type(&ty, step);
            let next = next.ok_or_else(|| self.error(place.span, "has a place without a type"))?;
            if let (Step::Field(field), Type::Struct(id)) = (step, &ty) {
                let fields = &self.module.structs[id.index()].fields[..*field as usize];
                let before: usize = fields.iter().map(|it| self.module.width(&it.ty)).sum();
                offset.push(before.to_string());
            } else {
                let width = self.module.width(&next);
                match self.index(name, &ty, step)? {
                    Index::Uniform(index) => offset.push(format!("{index} * {width}")),
                    Index::Lanes(index) => lanes.push(format!("({index}) * Whole::of({width})")),
                }
            }
            ty = next;
        }
        let (offset, of) = (offset.join(" + "), types::text(self.names, &ty));
        Ok(match lanes.is_empty() {
            true => format!("lanes::table::<{of}>(&{name}, {offset})"),
            false => format!("lanes::table_at::<{of}>(&{name}, {offset}, {})", lanes.join(" + ")),
        })
    }
}

/// An index of one element.
enum Index {
    /// A `usize` of Rust.
    Uniform(String),
    Lanes(String),
}

/// Returns the part of the element that each lane selects.
pub(crate) fn picked(array: &str, index: &str, rest: &str) -> String {
    let part = if rest.is_empty() { "it".to_owned() } else { format!("&it{rest}") };
    format!("lanes::pick(&{array}[..], {index}, |it| {part})")
}
