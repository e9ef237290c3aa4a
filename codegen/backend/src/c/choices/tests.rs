//! Random chains of comparisons do the same before and after their cases are formed, for each variant and each flag. In
//! half of them an invalid value counts as the last variant.

use super::*;
use crate::c::tree::{Declarator, plain};

const VARIANTS: [&str; 4] = ["A", "B", "C", "D"];
const FLAGS: [&str; 3] = ["p", "q", "r"];

/// State of a run: the variant, the flags, the other writes, and a flag for its end.
#[derive(Clone, Debug, PartialEq)]
struct World {
    state: String,
    flags: [bool; 3],
    writes: Vec<(String, String)>,
    returned: bool,
}

fn place() -> Expr {
    Expr::Arrow(Box::new(Expr::name("self")), "state".to_owned())
}

fn holds(condition: &Expr, world: &World) -> bool {
    match condition {
        Expr::Name(flag) => {
            FLAGS.iter().position(|it| it == flag).is_some_and(|at| world.flags[at])
        }
        Expr::Unary("!", operand) => !holds(operand, world),
        Expr::Binary("==", of, label) => match &**of {
            Expr::Conditional(.., last) if !VARIANTS.contains(&world.state.as_str()) => {
                last == label
            }
            _ => **label == Expr::name(&world.state),
        },
        Expr::Binary("!=", of, label) => {
            !holds(&Expr::Binary("==", of.clone(), label.clone()), world)
        }
        Expr::Binary("&&", a, b) => holds(a, world) && holds(b, world),
        Expr::Binary("||", a, b) => holds(a, world) || holds(b, world),
        other => panic!("no condition: {other:?}"),
    }
}

fn run(body: &[Stmt], world: &mut World) {
    for stmt in body {
        if world.returned {
            return;
        }
        match &stmt.kind {
            StmtKind::If { condition, then, otherwise } => {
                run(if holds(condition, world) { then } else { otherwise }, world);
            }
            StmtKind::Switch { arms, .. } => {
                let met = |arm: &&SwitchArm| arm.labels.contains(&Expr::name(&world.state));
                let default = arms.iter().find(|arm| arm.default);
                let arm = arms.iter().find(met).or(default).expect("one is the default");
                run(&arm.body.clone(), world);
            }
            StmtKind::Assign(to, _, Expr::Name(value)) if *to == place() => {
                world.state = value.clone();
            }
            StmtKind::Assign(to, _, value) => {
                world.writes.push((format!("{to:?}"), format!("{value:?}")));
            }
            StmtKind::Return(_) => world.returned = true,
            other => panic!("no statement: {other:?}"),
        }
    }
}

/// A generator of numbers below a bound; with `true`, an invalid value counts as the last variant.
struct Dice(u64, bool);

impl Dice {
    fn below(&mut self, bound: u64) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % bound) as usize
    }

    fn label(&mut self) -> Expr {
        Expr::name(VARIANTS[self.below(4)])
    }

    fn condition(&mut self) -> Expr {
        let equal = |dice: &mut Dice| match dice.label() {
            last if dice.1 && last == Expr::name(VARIANTS[3]) => {
                let number = Expr::cast("uint32_t", place());
                let is_other = Box::new(Expr::binary("<", number, Expr::name("3U")));
                let value = Expr::Conditional(is_other, Box::new(place()), Box::new(last.clone()));
                Expr::binary("==", value, last)
            }
            label => Expr::binary("==", place(), label),
        };
        let flag = |dice: &mut Dice| match (Expr::name(FLAGS[dice.below(3)]), dice.below(2)) {
            (flag, 0) => flag,
            (flag, _) => Expr::unary("!", flag),
        };
        match self.below(7) {
            0 | 1 => equal(self),
            2 => Expr::binary("||", equal(self), equal(self)),
            3 | 4 => Expr::binary("&&", equal(self), flag(self)),
            5 => Expr::binary("&&", Expr::binary("||", equal(self), equal(self)), flag(self)),
            _ => flag(self),
        }
    }

    fn body(&mut self, depth: usize) -> Vec<Stmt> {
        let count = self.below(3);
        let mut list: Vec<Stmt> = (0..count).map(|_| plain(self.plain())).collect();
        if depth > 0 && self.below(4) == 0 {
            list.push(self.chain(depth - 1));
        }
        list
    }

    fn plain(&mut self) -> StmtKind {
        match self.below(5) {
            0 | 1 => StmtKind::Assign(place(), "=", self.label()),
            2 => StmtKind::Return(None),
            _ => {
                let to = Expr::Arrow(Box::new(Expr::name("self")), "count".to_owned());
                StmtKind::Assign(to, "+=", Expr::name(format!("{}", self.below(9))))
            }
        }
    }

    fn chain(&mut self, depth: usize) -> Stmt {
        let mut rest = self.body(depth);
        for _ in 0..=self.below(5) {
            let kind = StmtKind::If {
                condition: self.condition(),
                then: self.body(depth),
                otherwise: rest,
            };
            rest = vec![plain(kind)];
        }
        rest.remove(0)
    }
}

fn enumerators(names: &[String]) -> Enumerators<'_> {
    Enumerators::new(std::iter::once(names))
}

fn names_of_variants() -> Vec<String> {
    VARIANTS.map(str::to_owned).into()
}

#[test]
fn each_variant_and_flag_meets_the_same_branch() {
    let names = names_of_variants();
    let (mut switches, mut left_out) = (0, 0);
    for seed in 0..4_000 {
        let mut dice = Dice(seed, seed % 2 == 1);
        let before: Vec<Stmt> = vec![dice.chain(2), dice.chain(1)];
        let mut after = before.clone();
        enumerators(&names).rewrite(&mut after);
        switches += usize::from(format!("{after:?}").contains("Switch"));
        left_out += usize::from(format!("{after:?}").len() < format!("{before:?}").len());
        let invalid = (seed % 2 == 1).then_some("E");
        for variant in VARIANTS.into_iter().chain(invalid) {
            for bits in 0..8_u8 {
                let flags = [0, 1, 2].map(|at| bits >> at & 1 == 1);
                let state = variant.to_owned();
                let start = World { state, flags, writes: Vec::new(), returned: false };
                let (mut one, mut other) = (start.clone(), start);
                run(&before, &mut one);
                run(&after, &mut other);
                // A place that is still invalid counts as the last variant, so both states do.
                for world in [&mut one, &mut other] {
                    if world.state == "E" {
                        world.state = VARIANTS[3].to_owned();
                    }
                }
                assert_eq!(one, other, "seed {seed}: {before:?}\nbecame {after:?}");
            }
        }
    }
    assert!(switches > 1_000, "{switches} of 4000 have a switch");
    assert!(left_out > 1_000, "{left_out} of 4000 are shorter");
}

#[test]
fn no_branch_is_empty_before_another() {
    let names = names_of_variants();
    for seed in 0..1_000 {
        let mut body = vec![Dice(seed, false).chain(2)];
        enumerators(&names).rewrite(&mut body);
        no_empty_branch(&body);
    }
}

fn no_empty_branch(body: &[Stmt]) {
    for stmt in body {
        if let StmtKind::If { then, otherwise, .. } = &stmt.kind {
            assert!(!then.is_empty() || otherwise.is_empty(), "{stmt:?}");
        }
        stmt.kind.blocks().into_iter().for_each(|block| no_empty_branch(block));
    }
}

#[test]
fn a_loop_is_left_by_no_switch() {
    let names = names_of_variants();
    let when = |label: &str, then: StmtKind, otherwise| StmtKind::If {
        condition: Expr::binary("==", place(), Expr::name(label)),
        then: vec![plain(then)],
        otherwise: vec![plain(otherwise)],
    };
    let chain = when("A", StmtKind::Break, when("B", StmtKind::Continue, StmtKind::Break));
    let mut body = vec![plain(chain)];
    let before = body.clone();
    enumerators(&names).rewrite(&mut body);
    assert_eq!(body, before);
}

#[test]
fn a_value_that_is_put_back_has_no_name() {
    let names = names_of_variants();
    let count = Expr::Arrow(Box::new(Expr::name("self")), "count".to_owned());
    let ty = "const uint16_t".to_owned();
    let left = Declarator { ty, name: "left".to_owned(), dimensions: String::new() };
    let less = Expr::call("less", vec![Expr::name("left")]);
    let arm = vec![
        plain(StmtKind::Declare(left, Some(Init::Value(count.clone())))),
        plain(StmtKind::Assign(place(), "=", Expr::name("A"))),
        plain(StmtKind::Assign(count.clone(), "=", less)),
    ];
    let mut body = vec![plain(StmtKind::Switch {
        scrutinee: place(),
        arms: vec![SwitchArm { labels: vec![Expr::name("A")], default: true, body: arm }],
    })];
    enumerators(&names).rewrite(&mut body);
    let StmtKind::Switch { arms, .. } = &body[0].kind else { panic!("{body:?}") };
    let less = Expr::call("less", vec![count.clone()]);
    assert_eq!(arms[0].body, [plain(StmtKind::Assign(count, "=", less))]);
}

#[test]
fn a_value_behind_another_write_is_assigned_again() {
    let names = names_of_variants();
    // Two variants of an outer enum in one union: the write to the first changes the bytes of the second.
    let part = |name: &str| Expr::Member(Box::new(Expr::name("as")), name.to_owned());
    let arm = vec![
        plain(StmtKind::Assign(part("other"), "=", Expr::name("5U"))),
        plain(StmtKind::Assign(part("inner"), "=", Expr::name("A"))),
    ];
    let labels = vec![Expr::name("A")];
    let mut body = vec![plain(StmtKind::Switch {
        scrutinee: part("inner"),
        arms: vec![SwitchArm { labels, default: true, body: arm.clone() }],
    })];
    enumerators(&names).rewrite(&mut body);
    let StmtKind::Switch { arms, .. } = &body[0].kind else { panic!("{body:?}") };
    assert_eq!(arms[0].body, arm);
}
