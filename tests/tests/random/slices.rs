//! Random sorts, searches and edits of elements in a row.

use super::types::Ty;
use super::writer::{Kind, Var, Writer};

impl Writer<'_> {
    /// A row of elements that are wanted, to read: its text, whose it is and what an element is.
    fn row(&mut self, wanted: &dyn Fn(&Ty) -> bool) -> Option<(String, usize, Ty)> {
        let place = self.any_place(false, &|ty| {
            ty.sequence().is_some_and(|(element, _)| element.is_data() && wanted(element))
        })?;
        let element = place.ty.sequence()?.0.clone();
        if self.one_in(3) {
            let part = self.lent(&Ty::Slice(Box::new(element.clone())), false)?;
            return Some((part.text, part.root, element));
        }
        Some((place.text, place.root, element))
    }

    /// Returns a query on a sequence: a `bool`, an integer or an option.
    pub fn of_sequence(&mut self, ty: &Ty, fuel: usize) -> Option<String> {
        if matches!(ty, Ty::Int("usize")) && self.one_in(2) {
            let searched = self.searched(fuel)?;
            return Some(format!("{searched}.unwrap_or_else(|at| at)"));
        }
        let (text, root, element) = match ty {
            Ty::Int("usize") => self.row(&|_| true)?,
            Ty::Bool => self.row(&|it| it.is_scalar())?,
            Ty::Option(inner) => self.row(&|it| it == &**inner)?,
            _ => return None,
        };
        self.lend(root, false);
        let said = match ty {
            Ty::Bool => match self.below(4) {
                0 => format!("{text}.is_empty()"),
                1 if element.is_number() => {
                    let start = self.value(&Ty::Array(Box::new(element.clone()), 1), fuel);
                    let end = self.random.of(&["starts_with", "ends_with"]);
                    format!("{text}.{end}(&{start})")
                }
                _ => format!("{text}.contains(&{})", self.value(&element, fuel)),
            },
            Ty::Int(_) if self.one_in(2) => format!("{text}.len()"),
            Ty::Int(_) => {
                let kept = self.freeze_all(true);
                let test = self.predicate(&element, fuel);
                self.thaw(kept);
                format!("{text}.partition_point({test})")
            }
            _ if self.one_in(2) => {
                let split = self.random.of(&["split_first", "split_last"]);
                let kept = self.freeze_all(true);
                let value = self.unreturned(|it| {
                    let before = it.env.len();
                    it.env.push(Var::new("first", &element, Kind::Shared, false));
                    let rest = Ty::Slice(Box::new(element.clone()));
                    it.env.push(Var::new("rest", &rest, Kind::Shared, false));
                    let value = it.value(&element, fuel);
                    it.close(before);
                    value
                });
                self.thaw(kept);
                format!(
                    "(if let Some((first, rest)) = {text}.{split}() {{ Some({value}) }} else {{ None }})"
                )
            }
            _ => format!("{text}.{}().copied()", self.random.of(&["first", "last"])),
        };
        self.end(root, false);
        Some(said)
    }

    /// Returns a search in an ordered sequence, a `Result<usize, usize>`.
    pub fn searched(&mut self, fuel: usize) -> Option<String> {
        let (text, root, element) = self.row(&|ty| matches!(ty, Ty::Int(_)) || !ty.is_scalar())?;
        self.lend(root, false);
        let searched = match &element {
            Ty::Int(_) if self.one_in(2) => {
                format!("{text}.binary_search(&{})", self.value(&element, fuel))
            }
            _ => {
                let key = Ty::Int(self.random.of(&["u8", "i32", "u64"]));
                let kept = self.freeze_all(true);
                let wanted = self.value(&key, fuel);
                let of = self.key(&element, &key, fuel);
                self.thaw(kept);
                if self.one_in(2) {
                    format!("{text}.binary_search_by_key(&{wanted}, {of})")
                } else {
                    let (name, key) = of[1..].split_once("| ")?;
                    format!("{text}.binary_search_by(|{name}| ({key}).cmp(&{wanted}))")
                }
            }
        };
        self.end(root, false);
        Some(searched)
    }

    /// `|x| key` of an element.
    fn key(&mut self, element: &Ty, key: &Ty, fuel: usize) -> String {
        self.unreturned(|it| {
            let before = it.env.len();
            let name = it.new_name();
            it.env.push(Var::new(name, element, Kind::Shared, false));
            let key = it.value(key, fuel);
            it.close(before);
            format!("|{name}| {key}")
        })
    }

    /// A statement that orders, moves or writes elements of a row.
    pub fn slice_edit(&mut self, fuel: usize) -> Option<String> {
        let place = self
            .any_place(true, &|ty| ty.sequence().is_some_and(|(element, _)| element.is_data()))?;
        let (element, len) = place.ty.sequence()?;
        let element = element.clone();
        let slice = Ty::Slice(Box::new(element.clone()));
        let place = if self.one_in(3) { self.lent(&slice, true)? } else { place };
        let list = &place.text;
        self.lend(place.root, true);
        let edited = match self.below(14) {
            0 | 1 if matches!(element, Ty::Int(_)) => format!("{list}.sort_unstable();"),
            0..=3 => self.sorted(list, &element, fuel),
            4 => format!("{list}.swap({}, {});", self.position(len, 1), self.position(len, 1)),
            5 => format!("{list}.reverse();"),
            6 => format!("{list}.fill({});", self.value(&element, fuel)),
            7 => {
                let turn = self.random.of(&["rotate_left", "rotate_right"]);
                if self.risky() {
                    format!("{list}.{turn}({});", self.position(len, 1))
                } else {
                    format!("if {list}.len() > 1 {{ {list}.{turn}(1); }}")
                }
            }
            8 if self.risky() => {
                let from = self.below(len);
                let to = from + self.below(len - from + 1);
                format!("{list}.copy_within({from}..{to}, {});", self.position(len, 1))
            }
            8 | 9 => {
                let get = match self.below(3) {
                    0 => "first_mut()".to_owned(),
                    1 => "last_mut()".to_owned(),
                    _ => format!("get_mut({})", self.value(&Ty::Int("usize"), fuel)),
                };
                let body = self.within(&[("part", &element)], fuel);
                format!("if let Some(part) = {list}.{get} {{\n{body}}}")
            }
            10 => {
                let body = self.within(&[("part", &element), ("rest", &slice)], fuel);
                let split = self.random.of(&["split_first_mut", "split_last_mut"]);
                format!("if let Some((part, rest)) = {list}.{split}() {{\n{body}}}")
            }
            11 => {
                let at = self.position(len, 1);
                let body = self.within(&[("rest", &slice), ("last", &slice)], fuel);
                format!("{{\nlet (rest, last) = {list}.split_at_mut({at});\n{body}}}")
            }
            12 => {
                self.end(place.root, true);
                let text = self.copied_row(list, place.root, &element, len);
                self.lend(place.root, true);
                text
            }
            _ => {
                let at = self.below(len);
                format!(
                    "if {list}.len() > {at} {{ {list}[{at}] = {}; }}",
                    self.value(&element, fuel)
                )
            }
        };
        self.end(place.root, true);
        Some(edited)
    }

    /// A statement within which names represent what may be written.
    fn within(&mut self, names: &[(&str, &Ty)], fuel: usize) -> String {
        let before = self.env.len();
        for (name, ty) in names {
            self.env.push(Var::new(name, ty, Kind::Exclusive, false));
        }
        let body = self.statement(fuel.min(1));
        self.close(before);
        body
    }

    fn sorted(&mut self, list: &str, element: &Ty, fuel: usize) -> String {
        let unstable = self.random.of(&["", "unstable_"]);
        let kept = self.freeze_all(true);
        let by = match element {
            Ty::Float(_) => {
                let order = self.random.of(&[
                    "one.total_cmp(other)",
                    "other.total_cmp(one)",
                    "one.partial_cmp(other).unwrap_or(core::cmp::Ordering::Equal)",
                ]);
                format!("by(|one, other| {order})")
            }
            Ty::Int(_) if self.one_in(2) => {
                let order = self.random.of(&[
                    "other.cmp(one)",
                    "one.cmp(other)",
                    "one.cmp(other).reverse()",
                ]);
                format!("by(|one, other| {order})")
            }
            _ => {
                let key = Ty::Int(self.random.of(&["u8", "i16", "u64"]));
                format!("by_key({})", self.key(element, &key, fuel))
            }
        };
        self.thaw(kept);
        format!("{list}.sort_{unstable}{by};")
    }

    /// Elements of another row, or of the same, in the place of some.
    fn copied_row(&mut self, list: &str, root: usize, element: &Ty, len: usize) -> String {
        self.lend(root, true);
        let count = 1 + self.below(len);
        let other = self.value(&Ty::Array(Box::new(element.clone()), count), 1);
        self.end(root, true);
        if self.risky() {
            return format!("{list}.copy_from_slice(&{other});");
        }
        format!("if {list}.len() >= {count} {{ {list}[..{count}].copy_from_slice(&{other}); }}")
    }
}
