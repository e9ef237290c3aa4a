//! Random iterators: where they begin, and the links that go through more or fewer elements.

use super::types::{INTS, Ty};
use super::writer::{Kind, Var, Writer};

/// Item type of an iterator.
#[derive(Clone)]
pub enum Item {
    Value(Ty),
    Lent(Ty),
    Pair(Box<Item>, Box<Item>),
}

/// An iterator: its text, what it gives, and whose elements it goes through.
pub struct Links {
    pub text: String,
    pub item: Item,
    pub loans: Vec<usize>,
    stage: Stage,
}

/// State of the chain, which decides the adapters that may follow.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Stage {
    /// Elements as they stand.
    Begun,
    /// So many of them at a time, some passed over, or from the end.
    Taken,
    Chained,
    Zipped,
    Counted,
    Cut,
    Range,
}

impl Writer<'_> {
    /// An iterator whose elements are read; what it goes through is lent until the caller ends it.
    pub fn links(&mut self, fuel: usize) -> Option<Links> {
        let mut links = self.begun(fuel)?;
        for _ in 0..self.below(4) {
            self.linked(&mut links, fuel);
        }
        Some(links)
    }

    pub fn unlinked(&mut self, links: &Links) {
        links.loans.iter().for_each(|root| self.end(*root, false));
    }

    fn begun(&mut self, fuel: usize) -> Option<Links> {
        if self.one_in(5) {
            return Some(self.of_range(fuel));
        }
        let place = self.any_place(false, &|ty| {
            let data = ty.sequence().is_some_and(|(element, _)| element.is_data());
            data || matches!(ty, Ty::Matrix(..))
        })?;
        self.lend(place.root, false);
        let item = match place.ty.sequence() {
            Some((element, _)) => Item::Lent(element.clone()),
            None => Item::Lent(place.ty.element()),
        };
        let parts = matches!(place.ty, Ty::Array(..) | Ty::List(..) | Ty::Slice(_));
        let (text, item) = match (item, self.below(8)) {
            (Item::Lent(element), 0) if parts => {
                let how = self.random.of(&["windows", "chunks", "chunks_exact"]);
                let size = 1 + self.below(2);
                let item = Item::Lent(Ty::Slice(Box::new(element)));
                (format!("{}.{how}({size})", place.text), item)
            }
            (item, _) => (format!("{}.iter()", place.text), item),
        };
        let stage = if text.ends_with(".iter()") { Stage::Begun } else { Stage::Taken };
        Some(Links { text, item, loans: vec![place.root], stage })
    }

    fn of_range(&mut self, fuel: usize) -> Links {
        let int = self.random.of(&["u8", "usize", "i32", "i8", "i16", "u16"]);
        let low = self.below(3);
        let high = if self.one_in(3) {
            let value = self.value(&Ty::Int("u8"), fuel.saturating_sub(1));
            format!("({value} % 5) as {int}")
        } else {
            format!("{}_{int}", low + self.below(5))
        };
        let rev = self.random.of(&["", "", ".rev()"]);
        let text = format!("({low}..{high}){rev}");
        let item = Item::Value(Ty::Int(int));
        Links { text, item, loans: Vec::new(), stage: Stage::Range }
    }

    /// One more link, if it fits.
    fn linked(&mut self, links: &mut Links, fuel: usize) {
        let (text, stage) = (&links.text, links.stage);
        match self.below(8) {
            0 | 1 if stage < Stage::Counted => {
                let index = Item::Value(Ty::Int("usize"));
                links.item = Item::Pair(Box::new(index), Box::new(links.item.clone()));
                links.text = format!("{text}.enumerate()");
                links.stage = Stage::Counted;
            }
            2 if stage < Stage::Range => {
                let cut = self.random.of(&["skip", "take"]);
                links.text = format!("{text}.{cut}({})", self.passed(fuel));
                links.stage = if stage == Stage::Begun { Stage::Taken } else { Stage::Cut };
            }
            3 if stage == Stage::Begun => {
                links.text = format!("{text}.step_by({})", 1 + self.below(3));
                links.stage = Stage::Taken;
            }
            4 | 5 if matches!(stage, Stage::Begun | Stage::Counted | Stage::Cut) => {
                links.text = format!("{text}.rev()");
                links.stage = if stage == Stage::Begun { Stage::Taken } else { Stage::Cut };
            }
            6 if matches!(stage, Stage::Begun | Stage::Taken | Stage::Zipped) => {
                let Some(other) = self.begun(fuel) else { return };
                if other.stage == Stage::Range {
                    return;
                }
                links.text = format!("{text}.zip({})", other.text);
                links.item = Item::Pair(Box::new(links.item.clone()), Box::new(other.item));
                links.loans.extend(other.loans);
                links.stage = Stage::Zipped;
            }
            _ if matches!(stage, Stage::Begun | Stage::Chained) => {
                let Item::Lent(element) = links.item.clone() else { return };
                let same = |it: &Ty| it.sequence().is_some_and(|(of, _)| *of == element);
                let Some(other) = self.any_place(false, &same) else { return };
                self.lend(other.root, false);
                links.text = format!("{text}.chain({}.iter())", other.text);
                links.loans.push(other.root);
                links.stage = Stage::Chained;
            }
            _ => {}
        }
    }

    /// Returns the number of elements to skip or take.
    fn passed(&mut self, fuel: usize) -> String {
        if self.one_in(4) {
            let value = self.value(&Ty::Int("usize"), fuel.saturating_sub(1));
            return if self.risky() { value } else { format!("{value} % 4") };
        }
        self.below(4).to_string()
    }

    /// A pattern for what an iterator gives, or for a reference to it (`lent`): its names are in scope from here on.
    pub fn item(&mut self, item: &Item, lent: bool, from: usize) -> String {
        match item {
            Item::Pair(one, other) => {
                let (one, other) = (self.item(one, false, from), self.item(other, false, from));
                format!("{}({one}, {other})", if lent { "&" } else { "" })
            }
            Item::Lent(ty) => {
                let and = if lent { "&" } else { "" };
                if ty.is_scalar() && self.one_in(2) {
                    return format!("{and}&{}", self.named(ty, from));
                }
                format!("{and}{}", self.part_of_pattern(ty, &Kind::Shared, false, 1, from))
            }
            Item::Value(ty) if !lent => self.part_of_pattern(ty, &Kind::Owned, false, 1, from),
            Item::Value(ty) if self.one_in(2) => {
                format!("&{}", self.named(ty, from))
            }
            Item::Value(ty) => self.bound(ty, &Kind::Shared, from),
        }
    }

    /// A name that is not written, which follows a `&`.
    fn named(&mut self, ty: &Ty, from: usize) -> String {
        let name = self.bound(ty, &Kind::Owned, from).trim_start_matches("mut ").to_owned();
        if let Some(var) = self.env[from..].iter_mut().find(|var| var.name == name) {
            var.mutable = false;
        }
        name
    }

    /// `|pattern| body` of what an iterator gives.
    pub fn of_item(
        &mut self,
        item: &Item,
        lent: bool,
        body: impl FnOnce(&mut Self) -> String,
    ) -> String {
        self.unreturned(|it| {
            let before = it.env.len();
            let pattern = it.item(item, lent, before);
            let body = body(it);
            it.close(before);
            format!("|{pattern}| {body}")
        })
    }

    /// A link that computes: a closure over what is given, which changes nothing.
    pub fn computed(&mut self, links: &mut Links, fuel: usize) {
        let text = links.text.clone();
        let item = links.item.clone();
        match (self.below(9), &item) {
            (0 | 1, _) => {
                let test = self.of_item(&item, true, |it| it.logical(fuel));
                let how = self.random.of(&["filter", "filter", "take_while", "skip_while"]);
                links.text = format!("{text}.{how}({test})");
            }
            (2 | 3, _) => {
                let to = self.items.any(self.random, 1, true);
                self.mapped_to(links, &to, fuel);
            }
            (4, _) => {
                let to = self.items.any(self.random, 1, true);
                let option = Ty::Option(Box::new(to.clone()));
                let how = self.random.of(&["filter_map", "map_while"]);
                let body = self.of_item(&item, false, |it| it.value(&option, fuel));
                links.text = format!("{text}.{how}({body})");
                links.item = Item::Value(to);
            }
            (5, _) => {
                let to = Ty::Int(self.random.of(&INTS));
                let first = self.below(9);
                let body = self.unreturned(|it| {
                    let before = it.env.len();
                    it.env.push(Var::new("kept", &to, Kind::Exclusive, false));
                    let pattern = it.item(&item, false, before);
                    let value = it.value(&to, fuel);
                    it.close(before);
                    format!("|kept, {pattern}| {{ *kept = {value}; Some(*kept) }}")
                });
                links.text = format!("{text}.scan({first}_{}, {body})", self.items.name(&to));
                links.item = Item::Value(to);
            }
            (_, Item::Lent(Ty::Option(inner))) => {
                links.text = format!("{text}.flatten()");
                links.item = Item::Lent((**inner).clone());
            }
            (_, Item::Lent(ty)) if ty.is_data() => {
                links.text = format!("{text}.copied()");
                links.item = Item::Value(ty.clone());
            }
            _ => {}
        }
        links.stage = Stage::Range;
    }

    pub fn mapped_to(&mut self, links: &mut Links, to: &Ty, fuel: usize) {
        let body = self.of_item(&links.item.clone(), false, |it| {
            format!("{{ {} }}", it.inner_block(to, fuel))
        });
        links.text = format!("{}.map({body})", links.text);
        links.item = Item::Value(to.clone());
    }
}
