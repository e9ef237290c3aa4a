//! Random chains of iterators that end in a value, and closures that fill arrays.

use super::links::{Item, Links};
use super::types::Ty;
use super::writer::{Kind, Var, Writer};

impl Writer<'_> {
    /// A chain that ends in a value of the type.
    pub fn chain(&mut self, ty: &Ty, fuel: usize) -> Option<String> {
        if !ty.is_scalar() && !matches!(ty, Ty::Option(_)) && !self.one_in(3) {
            return None;
        }
        let mut links = self.links(fuel - 1)?;
        // Two closures could change the same; only one of them may, the last.
        let computed = self.below(3);
        let kept = self.freeze_all(computed > 0);
        for _ in 0..computed {
            self.computed(&mut links, fuel - 1);
        }
        let text = self.ended(ty, &mut links, fuel - 1);
        self.thaw(kept);
        self.unlinked(&links);
        Some(text)
    }

    fn ended(&mut self, ty: &Ty, links: &mut Links, fuel: usize) -> String {
        let text = links.text.clone();
        let item = links.item.clone();
        match (ty, self.below(6)) {
            (Ty::Bool, 0..=3) => {
                let test = self.of_item(&item, false, |it| it.logical(fuel));
                format!("{text}.{}({test})", self.random.of(&["any", "all"]))
            }
            (Ty::Int("usize"), 0 | 1) => format!("{text}.count()"),
            (Ty::Option(inner), 0..=4) => self.optional_end(inner, links, fuel),
            (Ty::Int(_) | Ty::Float(_), 0 | 1) => {
                let kept = self.freeze_all(true);
                let small = matches!(ty, Ty::Float(_)) || self.risky();
                if !small {
                    self.mapped_to(links, &Ty::Int("u8"), fuel);
                    links.text += &format!(".map(|x| (x % 3) as {})", self.items.name(ty));
                } else if !matches!(&item, Item::Lent(of) | Item::Value(of) if of == ty) {
                    self.mapped_to(links, ty, fuel);
                }
                self.thaw(kept);
                let end = self.random.of(&["sum", "product"]);
                format!("{}.{end}::<{}>()", links.text, self.items.name(ty))
            }
            _ => self.folded(ty, links, fuel),
        }
    }

    fn folded(&mut self, ty: &Ty, links: &Links, fuel: usize) -> String {
        let start = self.value(ty, fuel);
        let before = self.env.len();
        let sum = self.random.of(&["sum", "state"]);
        let step = self.unreturned(|it| {
            it.env.push(Var::new(sum, ty, Kind::Owned, false));
            let pattern = it.item(&links.item, false, before);
            let step = it.inner_block(ty, fuel);
            format!("|{sum}, {pattern}| {{ {step} }}")
        });
        self.env.truncate(before);
        format!("{}.fold({start}, {step})", links.text)
    }

    /// An end that may come to nothing.
    fn optional_end(&mut self, inner: &Ty, links: &mut Links, fuel: usize) -> String {
        if *inner == Ty::Int("usize") && self.one_in(3) {
            let test = self.of_item(&links.item, false, |it| it.logical(fuel));
            return format!("{}.position({test})", links.text);
        }
        if self.one_in(6) {
            return self.tried(inner, links, fuel);
        }
        let kept = self.freeze_all(true);
        match &links.item {
            Item::Lent(of) if of == inner => {
                links.text += ".copied()";
                links.item = Item::Value(inner.clone());
            }
            Item::Value(of) if of == inner => {}
            _ => self.mapped_to(links, inner, fuel),
        }
        let text = &links.text;
        let end = match self.below(7) {
            0 => "next()".to_owned(),
            1 => format!("nth({})", self.below(4)),
            2 => "last()".to_owned(),
            3 if matches!(inner, Ty::Int(_)) => self.random.of(&["min()", "max()"]).to_owned(),
            3 | 4 => {
                let key = Ty::Int(self.random.of(&["u8", "i16", "u64"]));
                let key = self.of_item(&links.item, true, |it| it.value(&key, fuel));
                format!("{}({key})", self.random.of(&["min_by_key", "max_by_key"]))
            }
            5 if matches!(inner, Ty::Float(_)) => {
                let end = self.random.of(&["min_by", "max_by"]);
                format!("{end}(|one, other| one.total_cmp(other))")
            }
            _ => {
                let test = self.of_item(&links.item, true, |it| it.logical(fuel));
                format!("find({test})")
            }
        };
        let text = format!("{text}.{end}");
        self.thaw(kept);
        text
    }

    fn tried(&mut self, inner: &Ty, links: &Links, fuel: usize) -> String {
        let start = self.value(inner, fuel);
        let before = self.env.len();
        let option = Ty::Option(Box::new(inner.clone()));
        let step = self.unreturned(|it| {
            it.env.push(Var::new("state", inner, Kind::Owned, false));
            let pattern = it.item(&links.item, false, before);
            let step = it.inner_block(&option, fuel);
            format!("|state, {pattern}| {{ {step} }}")
        });
        self.env.truncate(before);
        format!("{}.try_fold({start}, {step})", links.text)
    }

    /// Nothing in scope may be changed, until it thaws.
    pub fn freeze_all(&mut self, really: bool) -> Vec<usize> {
        let all: Vec<usize> = if really { (0..self.env.len()).collect() } else { Vec::new() };
        all.iter().for_each(|var| self.lend(*var, false));
        all
    }

    pub fn thaw(&mut self, frozen: Vec<usize>) {
        frozen.into_iter().for_each(|var| self.end(var, false));
    }

    /// `[…].map(|x| …)`.
    pub fn mapped(&mut self, element: &Ty, len: usize, fuel: usize) -> String {
        let from = self.items.any(self.random, 1, true);
        let source = self.value(&Ty::Array(Box::new(from.clone()), len), fuel);
        let (closure, _) = self.lambda(&from, element, fuel);
        format!("{source}.map({closure})")
    }

    /// `core::array::from_fn(|i| …)`.
    pub fn filled_by_index(&mut self, element: &Ty, len: usize, fuel: usize) -> String {
        let before = self.env.len();
        let name = self.new_name();
        self.env.push(Var::new(name, &Ty::Int("usize"), Kind::Owned, false));
        let value = self.unreturned(|it| it.inner_block(element, fuel));
        self.env.truncate(before);
        let of = self.items.name(element);
        format!("core::array::from_fn::<{of}, {len}, _>(|{name}| {{ {value} }})")
    }
}
