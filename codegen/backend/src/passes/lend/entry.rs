//! Work struct of an entry point.
//!
//! It has a field for each row. If that needs a tenth more memory than the values that are alive at once, and the
//! temporaries form groups that are never alive together, the groups share memory: the struct is then a union of
//! them.

use bessemer_ir::{
    Field, Form, Function, Given, LocalId, Module, Owner, Place, Span, Step, Struct, StructId, Type,
};

use super::lives::{Life, What};
use super::row::{Row, noun};
use super::rows::{self, Laid};

/// Layout of an entry point's work struct.
pub(super) struct Plan {
    /// Rows by group: one group is a struct, several are a union of structs.
    groups: Vec<Vec<Row>>,
    /// Row and offset of each temporary.
    pub laid: Vec<Laid>,
}

/// Computes the layout of an entry point's temporaries; `size` returns the bytes of a value.
pub(super) fn plan(lives: &[Life], size: &dyn Fn(&Type) -> u64) -> Plan {
    let bytes = |rows: &[Row]| rows.iter().map(|row| size(&row.ty())).sum::<u64>();
    let (rows, laid) = rows::lay(lives);
    let mut groups: Vec<(Vec<Row>, Vec<usize>, Vec<Laid>)> = Vec::new();
    for members in merged(lives, apart(lives)) {
        let own: Vec<Life> = members.iter().map(|at| lives[*at].clone()).collect();
        let (rows, laid) = rows::lay(&own);
        groups.push((rows, members, laid));
    }
    let most = groups.iter().map(|(rows, ..)| bytes(rows)).max().unwrap_or_default();
    if 10 * bytes(&rows) <= 11 * most {
        return Plan { groups: vec![rows], laid };
    }
    let mut all = vec![Laid { row: 0, offset: 0 }; lives.len()];
    let mut before = 0;
    for (rows, members, laid) in &groups {
        for (at, laid) in members.iter().zip(laid) {
            all[*at] = Laid { row: before + laid.row, ..*laid };
        }
        before += rows.len();
    }
    Plan { groups: groups.into_iter().map(|(rows, ..)| rows).collect(), laid: all }
}

/// Partitions temporaries into groups, such that no temporary is alive together with one of another group.
fn apart(lives: &[Life]) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (at, life) in lives.iter().enumerate() {
        let meets = |group: &Vec<usize>| group.iter().any(|other| lives[*other].meets(life));
        let (together, rest): (Vec<_>, Vec<_>) = groups.into_iter().partition(meets);
        groups = rest;
        groups.push(together.into_iter().flatten().chain([at]).collect());
    }
    groups.iter_mut().for_each(|group| group.sort_unstable());
    groups.sort_unstable();
    groups
}

/// Merges groups of equal element types, since they can share rows.
fn merged(lives: &[Life], groups: Vec<Vec<usize>>) -> Vec<Vec<usize>> {
    let elements = |group: &[usize]| {
        let mut all: Vec<&Type> = Vec::new();
        for at in group {
            if !all.contains(&&lives[*at].row.element) {
                all.push(&lives[*at].row.element);
            }
        }
        all
    };
    let mut list: Vec<Vec<usize>> = Vec::new();
    for group in groups {
        let own = elements(&group);
        let alike = list.iter_mut().find(|other| {
            let theirs = elements(other);
            theirs.len() == own.len() && own.iter().all(|it| theirs.contains(it))
        });
        match alike {
            Some(other) => other.extend(group),
            None => list.push(group),
        }
    }
    list
}

/// Comment of a work struct; it names no function, since the name in C is not known yet.
const ENTRY_MEMORY: &str =
    "Working memory of its entry point; the contents are undefined between calls.";

/// Returns the structs, inner ones first; and for each row, the steps to it and its type.
pub(super) fn structs(
    module: &Module,
    function: &Function,
    lives: &[Life],
    plan: &Plan,
) -> (Vec<Struct>, Vec<(Vec<Step>, Type)>) {
    let name = called(module, function);
    let docs = vec![ENTRY_MEMORY.to_owned()];
    let own = |name: String, docs: Vec<String>, fields: Vec<Field>| {
        record((name, function.module.clone(), function.span), docs, fields)
    };
    let mut row = 0;
    let mut fields_of = |rows: &[Row]| -> Vec<Field> {
        let mut taken = Vec::new();
        let mut fields = Vec::new();
        for it in rows {
            let what: Vec<What> = (lives.iter().zip(&plan.laid))
                .filter(|(_, laid)| laid.row == row)
                .map(|(life, _)| life.what)
                .collect();
            let wanted = name_of(module, function, &what, it);
            let name = fresh(&wanted, &mut taken);
            fields.push(Field { name, docs: Vec::new(), ty: it.ty(), given: Given::default() });
            row += 1;
        }
        fields
    };
    let next = module.structs.len() as u32;
    let mut list = Vec::new();
    let mut at = Vec::new();
    if let [rows] = plan.groups.as_slice() {
        let fields = fields_of(rows);
        at.extend(
            fields
                .iter()
                .enumerate()
                .map(|(index, field)| (vec![Step::Field(index as u32)], field.ty.clone())),
        );
        list.push(own(format!("{name}_work"), docs, fields));
        return (list, at);
    }
    let mut members: Vec<Field> = Vec::new();
    let mut taken = Vec::new();
    for (index, rows) in plan.groups.iter().enumerate() {
        let mut fields = fields_of(rows);
        if let [only] = fields.as_mut_slice() {
            at.push((vec![Step::Field(index as u32)], only.ty.clone()));
            only.name = fresh(&only.name, &mut taken);
            members.append(&mut fields);
            continue;
        }
        at.extend(fields.iter().enumerate().map(|(inner, field)| {
            (vec![Step::Field(index as u32), Step::Field(inner as u32)], field.ty.clone())
        }));
        let wanted = fields.first().map_or("rest", |field| &field.name).to_owned();
        let together = fresh(&format!("with_{wanted}"), &mut taken);
        let ty = Type::Struct(StructId(next + list.len() as u32));
        let docs = vec!["Memory in use at one time.".to_owned()];
        list.push(own(format!("{name}_{together}_work"), docs, fields));
        members.push(Field { name: together, docs: Vec::new(), ty, given: Given::default() });
    }
    let mut docs = docs;
    docs.push("No two of its fields are in use at one time.".into());
    list.push(Struct { form: Form::Shared, ..own(format!("{name}_work"), docs, members) });
    (list, at)
}

/// Returns the place of a row in the work struct.
pub(super) fn place(laid: &Laid, at: &[(Vec<Step>, Type)], work: LocalId) -> Place {
    let (steps, ty) = at[laid.row].clone();
    Place { root: work, steps, ty, span: Default::default() }
}

/// Returns the name of a row: the name of its content if this is one value.
fn name_of(module: &Module, function: &Function, what: &[What], row: &Row) -> String {
    match what {
        [What::Local(id)] => function.local(*id).name.clone(),
        _ => match row.element {
            Type::Struct(_) => {
                let noun = noun(module, &row.element);
                noun.strip_suffix("_work").unwrap_or(&noun).to_owned()
            }
            _ => noun(module, &row.element),
        },
    }
}

fn fresh(wanted: &str, taken: &mut Vec<String>) -> String {
    let candidates =
        std::iter::once(wanted.to_owned()).chain((2..).map(|count| format!("{wanted}_{count}")));
    let name = candidates.into_iter().find(|name| !taken.contains(name)).unwrap_or_default();
    taken.push(name.clone());
    name
}

/// Returns a generated struct of working memory.
pub(super) fn record(
    (name, module, span): (String, String, Span),
    docs: Vec<String>,
    fields: Vec<Field>,
) -> Struct {
    Struct {
        name,
        module,
        docs,
        fields,
        form: bessemer_ir::Form::Lent,
        initial: None,
        defaults: None,
        given: Given::default(),
        span,
    }
}

/// Returns the name of a function after its type or its module.
pub(super) fn called(module: &Module, function: &Function) -> String {
    let owner = match function.owner {
        Some(Owner::Struct(id)) => Some(module.structs[id.index()].name.as_str()),
        Some(Owner::Enum(id)) => Some(module.enums[id.index()].name.as_str()),
        None => None,
    };
    let place = owner.or_else(|| function.module.rsplit("::").next()).unwrap_or_default();
    format!("{place}_{}", function.name)
}
