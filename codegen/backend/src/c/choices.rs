//! Choices by an enum: a chain of `if` that compares one place becomes a `switch`.
//!
//! From C tree to C tree, where the branches stand in their final form. A case is a state; the tests that the chain makes
//! besides become `if` inside. What a case knows is not assigned again, and no `if` begins with an empty branch.
//!
//! Invariants:
//! - conditions have no effect (the lowering puts calls that write into statements), so between two of a chain the place
//!   keeps its value, and those that compare a different variant can be left out;
//! - a branch is written down once, unless it is a single plain statement;
//! - a link between two that compare the place, and does not compare it, is a test in each case that reaches it;
//! - the case of the last variant carries `default:`, as in every other `switch`;
//! - the result for each variant stays, and of an invalid value in a chain that takes it for a variant: its case assigns
//!   that variant again.
//!
//! It must not know the IR, or any type other than an enum's names. So it takes every write for one that may change the
//! compared place: two fields of a union share their memory.

use std::collections::BTreeMap;

use super::mentions::names;
use super::tree::{Expr, Init, Origin, Stmt, StmtKind, SwitchArm, compound};

/// Variants from which an enum's chain of comparisons reads better as a `switch`.
const SEVERAL: usize = 3;

/// Nodes of a test that may be written down in several cases.
const SHORT: usize = 9;

/// Cases in which a branch may be written down.
const COPIES: usize = 3;

/// Enumerators of a module: the enum and the position of each.
pub struct Enumerators<'n> {
    enums: Vec<&'n [String]>,
    positions: BTreeMap<&'n str, (usize, usize)>,
}

impl<'n> Enumerators<'n> {
    /// Collects the enumerators of these enums.
    pub fn new(enums: impl Iterator<Item = &'n [String]>) -> Enumerators<'n> {
        let enums: Vec<&[String]> = enums.collect();
        let mut positions = BTreeMap::new();
        for (id, names) in enums.iter().enumerate() {
            positions.extend(names.iter().enumerate().map(|(at, name)| (name.as_str(), (id, at))));
        }
        Enumerators { enums, positions }
    }

    /// Simplifies the `if` chains and `switch` statements of a function's body.
    pub fn rewrite(&self, body: &mut Vec<Stmt>) {
        for mut stmt in std::mem::take(body) {
            if matches!(stmt.kind, StmtKind::If { .. }) {
                let (mut links, mut rest) = chain(stmt);
                links.iter_mut().for_each(|link| self.rewrite(&mut link.body));
                self.rewrite(&mut rest);
                body.extend(self.chosen(links.into_iter(), rest, &mut Excluded::new()));
                continue;
            }
            stmt.kind.blocks_mut().into_iter().for_each(|block| self.rewrite(block));
            if let StmtKind::Switch { scrutinee, arms } = &mut stmt.kind {
                arms.iter_mut().for_each(|arm| self.drop_known(scrutinee, arm));
            }
            body.push(stmt);
        }
        while let Some(at) = (1..body.len()).find(|at| self.names_scrutinee(body, *at)) {
            self.inline_scrutinee(body, at);
        }
    }

    /// Returns true if the statement before a `switch` only names what it selects by, for nothing else.
    fn names_scrutinee(&self, body: &[Stmt], at: usize) -> bool {
        let (
            StmtKind::Declare(declarator, Some(Init::Value(value))),
            StmtKind::Switch { scrutinee, arms },
        ) = (&body[at - 1].kind, &body[at].kind)
        else {
            return false;
        };
        let name = &declarator.name;
        let elsewhere =
            names(&body[at + 1..], name) || arms.iter().any(|arm| names(&arm.body, name));
        is_place(value) && *scrutinee == Expr::name(name) && !elsewhere
    }

    fn inline_scrutinee(&self, body: &mut Vec<Stmt>, at: usize) {
        let name = body.remove(at - 1);
        if let (
            StmtKind::Declare(_, Some(Init::Value(value))),
            StmtKind::Switch { scrutinee, arms },
        ) = (name.kind, &mut body[at - 1].kind)
        {
            arms.iter_mut().for_each(|arm| self.drop_known(&value, arm));
            *scrutinee = value;
        }
    }

    /// Returns the statements of a chain; `excluded` are the variants that a place cannot have any more.
    fn chosen(
        &self,
        mut links: std::vec::IntoIter<Link>,
        rest: Vec<Stmt>,
        excluded: &mut Excluded,
    ) -> Vec<Stmt> {
        let tests = self.tests(links.as_slice());
        let mut length = tests.len();
        while length > 1 {
            if !tests[length - 1].compares {
                length -= 1;
                continue;
            }
            let chain = links.as_slice();
            let behind = Behind { links: &chain[length..], rest: &rest };
            match self.cases(&chain[..length], &tests[..length], &behind, excluded) {
                Ok((groups, others)) => {
                    let closed = tests[..length].iter().filter(|test| test.guard.is_none());
                    closed.for_each(|test| test.exclude(excluded));
                    let origin = chain[0].origin;
                    let tested = links.by_ref().take(length).zip(&tests).collect();
                    let cases = Cases { cases: Case::of(groups, tested), others };
                    let rest = self.chosen(links, rest, excluded);
                    return vec![self.written(cases, &tests[0], rest, origin)];
                }
                Err(fewer) => length = fewer,
            }
        }
        if let Some(test) = tests.first().filter(|test| test.guard.is_none()) {
            test.exclude(excluded);
        }
        let Some(first) = links.next() else { return rest };
        vec![first.followed_by(self.chosen(links, rest, excluded))]
    }

    /// Returns the tests of the first links: of those that compare one place, and of those between them.
    fn tests(&self, links: &[Link]) -> Vec<Test> {
        let mut tests: Vec<Test> = Vec::new();
        for link in links {
            match (self.test(&link.condition), tests.first()) {
                (Some(test), None) => tests.push(test),
                (Some(test), Some(first)) if test.compares_like(first) => tests.push(test),
                (None, Some(first)) if !calls(&link.condition) => {
                    let every = (0..self.enums[first.id].len()).collect();
                    tests.push(Test {
                        of: first.of.clone(),
                        id: first.id,
                        variants: every,
                        guard: Some(link.condition.clone()),
                        compares: false,
                        brought: None,
                    });
                }
                _ => break,
            }
        }
        let brought = tests.iter().find_map(|test| test.brought.clone());
        if let Some(first) = tests.first_mut() {
            first.brought = brought;
        }
        tests
    }

    /// Sorts links that compare one place into groups, and returns the variants of none; an error is the number of links
    /// to try next.
    fn cases(
        &self,
        links: &[Link],
        tests: &[Test],
        behind: &Behind,
        excluded: &Excluded,
    ) -> Result<(Vec<Group>, Vec<usize>), usize> {
        let fewer = links.len() - 1;
        let (mut groups, mut others): (Vec<Group>, Vec<usize>) = Default::default();
        for at in 0..self.enums[tests[0].id].len() {
            if excluded.iter().any(|(place, known)| *place == tests[0].of && *known == at) {
                continue;
            }
            let matching = (0..links.len()).filter(|link| tests[*link].variants.contains(&at));
            let (mut taken, mut falls) = (Vec::new(), true);
            for link in matching {
                taken.push(link);
                falls = tests[link].guard.is_some();
                if !falls {
                    break;
                }
            }
            match groups.iter_mut().find(|group| group.links == taken) {
                _ if taken.is_empty() => others.push(at),
                Some(group) => group.variants.push(at),
                None => groups.push(Group { variants: vec![at], links: taken, falls }),
            }
        }
        let reads_better = match &groups[..] {
            [] => false,
            // One state alone: its comparison stands before what else is tested.
            [group] => group.links.len() > 1,
            _ => self.enums[tests[0].id].len() >= SEVERAL,
        };
        let switch = groups.len() > 1;
        if !reads_better || switch && links.iter().any(|it| it.body.iter().any(leaves_loop)) {
            return Err(fewer);
        }
        for (index, link) in links.iter().enumerate() {
            let uses = groups.iter().filter(|group| group.links.contains(&index)).count();
            let guard = tests[index].guard.as_ref().map_or(0, size);
            let copied = guard > SHORT || uses > COPIES || !is_short(&link.body);
            if uses == 0 || uses > 1 && copied {
                return Err(index.min(fewer));
            }
        }
        let falling = groups.iter().filter(|group| group.falls).count();
        let otherwise = usize::from(!switch || !others.is_empty());
        let moves = switch && falling + otherwise > 0;
        if falling + otherwise > 1 && !behind.is_short() || moves && behind.leaves_loop() {
            return Err(fewer);
        }
        Ok((groups, others))
    }

    /// Writes cases down; `rest` is what happens where none of them is met.
    fn written(
        &self,
        Cases { mut cases, others }: Cases,
        test: &Test,
        rest: Vec<Stmt>,
        origin: Option<Origin>,
    ) -> Stmt {
        let label = |at: &usize| Expr::name(&self.enums[test.id][*at]);
        if cases.len() == 1 {
            let case = cases.remove(0);
            let equal = |at: &usize| match &test.brought {
                Some((variant, value)) if variant == at => {
                    Expr::binary("==", value.clone(), label(at))
                }
                _ => Expr::binary("==", test.of.clone(), label(at)),
            };
            let condition = case.variants.iter().map(equal).reduce(|a, b| Expr::binary("||", a, b));
            let only = matches!(case.variants[..], [_]).then(|| label(&case.variants[0]));
            let mut then = case.body(&rest);
            if let Some(label) = only {
                drop_known(&mut then, &test.of, &label);
            }
            let condition = condition.unwrap_or_else(|| Expr::name("true"));
            return Stmt { kind: choice(condition, then, rest), origin };
        }
        let mut arms: Vec<(Vec<usize>, Vec<Stmt>)> = Vec::new();
        for mut case in cases {
            let variants = std::mem::take(&mut case.variants);
            arms.push((variants, case.body(&rest)));
        }
        if !others.is_empty() {
            arms.push((others, rest));
        }
        // The last variant is in the last case, which represents what is none of them.
        arms.sort_by_key(|(variants, _)| variants.last().copied());
        let count = arms.len();
        let brought = test.brought.as_ref().map(|(variant, _)| *variant);
        let arm = |(index, (variants, body)): (usize, (Vec<usize>, Vec<Stmt>))| {
            let labels = variants.iter().map(label).collect();
            let invalid = brought.is_some_and(|brought| variants.contains(&brought));
            let mut arm = SwitchArm { labels, default: index + 1 == count, body };
            if !invalid {
                self.drop_known(&test.of, &mut arm);
            }
            arm
        };
        let arms = arms.into_iter().enumerate().map(arm).collect();
        Stmt { kind: StmtKind::Switch { scrutinee: test.of.clone(), arms }, origin }
    }

    /// Removes assignments of what the label of a case says.
    fn drop_known(&self, place: &Expr, arm: &mut SwitchArm) {
        if let [label @ Expr::Name(name)] = &arm.labels[..]
            && self.positions.contains_key(name.as_str())
            && is_place(place)
        {
            drop_known(&mut arm.body, place, &label.clone());
        }
    }

    /// Returns the place of a value that is a variant in any case, and the variant as which an invalid one counts.
    fn brought<'e>(&self, value: &'e Expr) -> Option<(&'e Expr, usize)> {
        let Expr::Conditional(condition, place, variant) = value else { return None };
        let Expr::Name(variant) = &**variant else { return None };
        let (_, at) = *self.positions.get(variant.as_str())?;
        is_about(condition, place).then_some((&**place, at))
    }

    /// Returns the comparison with which a condition begins.
    fn test(&self, condition: &Expr) -> Option<Test> {
        match condition {
            Expr::Binary("==", of, label) => {
                let Expr::Name(label) = &**label else { return None };
                let (id, at) = *self.positions.get(label.as_str())?;
                let (place, brought) = match self.brought(of) {
                    Some((place, variant)) => (place, Some((variant, (**of).clone()))),
                    None => (&**of, None),
                };
                let of = Some(place).filter(|place| is_place(place))?.clone();
                Some(Test { of, id, variants: vec![at], guard: None, compares: true, brought })
            }
            Expr::Binary("&&", first, second) => {
                let mut test = self.test(first)?;
                test.guard = Some(match test.guard {
                    None => (**second).clone(),
                    Some(guard) => Expr::binary("&&", guard, (**second).clone()),
                });
                Some(test)
            }
            Expr::Binary("||", first, second) => {
                let (mut test, other) = (self.test(first)?, self.test(second)?);
                let plain = test.guard.is_none() && other.guard.is_none();
                test.variants.extend(&other.variants);
                test.brought = test.brought.or_else(|| other.brought.clone());
                (plain && other.compares_like(&test)).then_some(test)
            }
            _ => None,
        }
    }
}

/// Returns true if a condition compares nothing but a value.
fn is_about(condition: &Expr, value: &Expr) -> bool {
    match condition {
        Expr::Binary("||", a, b) => is_about(a, value) && is_about(b, value),
        Expr::Binary("==" | "<", of, _) => match &**of {
            Expr::Cast(_, inner) => **inner == *value,
            of => of == value,
        },
        _ => false,
    }
}

/// Variants that places cannot have, by the comparisons before.
type Excluded = Vec<(Expr, usize)>;

/// A comparison of a place with variants, and what a condition tests besides.
struct Test {
    of: Expr,
    id: usize,
    variants: Vec<usize>,
    guard: Option<Expr>,
    /// True if the condition compares the place.
    compares: bool,
    /// The variant as which an invalid value counts, and the value with that variant in its place.
    brought: Option<(usize, Expr)>,
}

impl Test {
    fn compares_like(&self, other: &Test) -> bool {
        self.of == other.of && self.id == other.id
    }

    fn exclude(&self, excluded: &mut Excluded) {
        excluded.extend(self.variants.iter().map(|at| (self.of.clone(), *at)));
    }
}

/// An `if` of a chain. Its body may be the rest of the function, so it is copied only where several cases share it.
#[derive(Clone)]
struct Link {
    condition: Expr,
    body: Vec<Stmt>,
    origin: Option<Origin>,
}

impl Link {
    fn followed_by(self, otherwise: Vec<Stmt>) -> Stmt {
        Stmt { kind: choice(self.condition, self.body, otherwise), origin: self.origin }
    }
}

/// The part of a chain behind the links that become cases.
struct Behind<'c> {
    links: &'c [Link],
    rest: &'c [Stmt],
}

impl Behind<'_> {
    fn is_short(&self) -> bool {
        self.links.is_empty() && is_short(self.rest)
    }

    fn leaves_loop(&self) -> bool {
        let bodies = self.links.iter().flat_map(|link| &link.body);
        bodies.chain(self.rest).any(leaves_loop)
    }
}

/// Variants that meet the same links, by their positions.
struct Group {
    variants: Vec<usize>,
    links: Vec<usize>,
    /// True if no link may hold, so that what is behind them follows.
    falls: bool,
}

/// A case: its variants and branches, each with the test that is left of its condition.
struct Case {
    variants: Vec<usize>,
    branches: Vec<(Option<Expr>, Link)>,
    falls: bool,
}

impl Case {
    /// Returns the case of each group.
    fn of(groups: Vec<Group>, tested: Vec<(Link, &Test)>) -> Vec<Case> {
        let mut uses = vec![0; tested.len()];
        groups.iter().flat_map(|group| &group.links).for_each(|link| uses[*link] += 1);
        let mut tested: Vec<_> = tested.into_iter().map(Some).collect();
        let mut branch = |at: usize| {
            uses[at] -= 1;
            let (link, test) = match uses[at] {
                0 => tested[at].take(),
                _ => tested[at].clone(),
            }?;
            Some((test.guard.clone(), link))
        };
        let case = |group: Group| Case {
            branches: group.links.into_iter().filter_map(&mut branch).collect(),
            variants: group.variants,
            falls: group.falls,
        };
        groups.into_iter().map(case).collect()
    }

    fn body(self, rest: &[Stmt]) -> Vec<Stmt> {
        let rest = if self.falls { rest.to_vec() } else { Vec::new() };
        self.branches.into_iter().rev().fold(rest, |otherwise, (guard, link)| match guard {
            None => link.body,
            Some(guard) => {
                vec![Stmt { kind: choice(guard, link.body, otherwise), origin: link.origin }]
            }
        })
    }
}

/// All cases, and the variants that meet none of them.
struct Cases {
    cases: Vec<Case>,
    others: Vec<usize>,
}

/// Takes an `if` apart into the links of its chain and its last branch.
fn chain(stmt: Stmt) -> (Vec<Link>, Vec<Stmt>) {
    let (mut links, mut rest) = (Vec::new(), vec![stmt]);
    while let [Stmt { kind: StmtKind::If { .. }, .. }] = &rest[..]
        && let Some(Stmt { kind: StmtKind::If { condition, then, otherwise }, origin }) = rest.pop()
    {
        links.push(Link { condition, body: then, origin });
        rest = otherwise;
    }
    (links, rest)
}

/// Returns an `if` that does not begin with an empty branch.
fn choice(condition: Expr, then: Vec<Stmt>, otherwise: Vec<Stmt>) -> StmtKind {
    match then.is_empty() && !otherwise.is_empty() {
        true => StmtKind::If { condition: not(condition), then: otherwise, otherwise: then },
        false => StmtKind::If { condition, then, otherwise },
    }
}

/// Returns the opposite of a condition.
fn not(condition: Expr) -> Expr {
    match condition {
        Expr::Unary("!", operand) => *operand,
        Expr::Binary("==", a, b) => Expr::Binary("!=", a, b),
        Expr::Binary("!=", a, b) => Expr::Binary("==", a, b),
        Expr::Binary("||", a, b) if turns(&a) && turns(&b) => Expr::binary("&&", not(*a), not(*b)),
        Expr::Binary("&&", a, b) if turns(&a) && turns(&b) => Expr::binary("||", not(*a), not(*b)),
        other => Expr::unary("!", other),
    }
}

/// Returns true if the opposite of a condition is no longer than it.
fn turns(condition: &Expr) -> bool {
    match condition {
        Expr::Unary("!", _) | Expr::Binary("==" | "!=", ..) => true,
        Expr::Binary("||" | "&&", a, b) => turns(a) && turns(b),
        _ => false,
    }
}

/// Returns true if an expression is a variable or a field, which reading does not change.
fn is_place(expr: &Expr) -> bool {
    match expr {
        Expr::Name(_) => true,
        Expr::Member(of, _) | Expr::Arrow(of, _) | Expr::Unary("*", of) => is_place(of),
        _ => false,
    }
}

/// Returns true if a branch is one plain statement at most.
fn is_short(body: &[Stmt]) -> bool {
    let plain = |stmt: &Stmt| {
        matches!(stmt.kind, StmtKind::Assign(..) | StmtKind::Expr(_) | StmtKind::Return(_))
    };
    body.len() < 2 && body.iter().all(plain)
}

/// Returns the number of nodes of an expression.
fn size(expr: &Expr) -> usize {
    1 + expr.operands().into_iter().map(size).sum::<usize>()
}

/// Returns true if a statement ends a loop around it, which it could not from within a `switch`.
fn leaves_loop(stmt: &Stmt) -> bool {
    match &stmt.kind {
        StmtKind::Break => true,
        StmtKind::If { then, otherwise, .. } => then.iter().chain(otherwise).any(leaves_loop),
        StmtKind::Block(body) => body.iter().any(leaves_loop),
        _ => false,
    }
}

/// Removes assignments of `label` to `place`, which holds it where the statements begin, up to the first other write.
/// Returns true if there is no such write.
fn drop_known(body: &mut Vec<Stmt>, place: &Expr, label: &Expr) -> bool {
    let mut at = 0;
    while at < body.len() {
        let keeps = match &mut body[at].kind {
            StmtKind::Comment(_) => true,
            StmtKind::Declare(_, None) => true,
            StmtKind::Declare(_, Some(init)) => !init_calls(init),
            StmtKind::Assign(to, "=", value) if to == place && value == label => {
                body.remove(at);
                put_back(body, at);
                continue;
            }
            StmtKind::If { condition, then, otherwise } if !calls(condition) => {
                let kept = drop_known(then, place, label);
                drop_known(otherwise, place, label) && kept
            }
            _ => false,
        };
        if let StmtKind::If { condition, then, otherwise } = &mut body[at].kind
            && then.is_empty()
        {
            let taken = std::mem::take(otherwise);
            let condition = std::mem::replace(condition, Expr::name("false"));
            body[at].kind = choice(condition, Vec::new(), taken);
        }
        if !keeps {
            return false;
        }
        at += 1;
    }
    true
}

/// Joins `const t = x;`, the statement before `at`, with `x = f(t);` if nothing else reads it.
fn put_back(body: &mut Vec<Stmt>, at: usize) {
    let Some(before) = at.checked_sub(1) else { return };
    let (StmtKind::Declare(declarator, Some(Init::Value(value))), Some(next)) =
        (&body[before].kind, body.get(at))
    else {
        return;
    };
    let StmtKind::Assign(to, "=", computed) = &next.kind else { return };
    let name = declarator.name.as_str();
    let alone = computed.mentions(name) == 1 && !names(&body[at + 1..], name);
    if to != value || !is_place(to) || !alone {
        return;
    }
    let (to, mut computed) = (to.clone(), computed.clone());
    computed.replace(name, value);
    let joined = match computed {
        Expr::Binary(op, left, right) if *left == to && compound(op).is_some() => {
            StmtKind::Assign(to, compound(op).unwrap_or("="), *right)
        }
        other => StmtKind::Assign(to, "=", other),
    };
    body[at].kind = joined;
    body.remove(before);
}

fn calls(expr: &Expr) -> bool {
    matches!(expr, Expr::Call(..) | Expr::Postfix(..)) || expr.operands().into_iter().any(calls)
}

fn init_calls(init: &Init) -> bool {
    match init {
        Init::Value(value) => calls(value),
        Init::List { items, .. } => items.iter().any(|(_, item)| init_calls(item)),
    }
}

#[cfg(test)]
mod tests;
