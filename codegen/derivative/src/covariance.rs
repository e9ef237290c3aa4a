//! Propagation of a covariance P to F P Fᵀ in place, by the structure of the Jacobian F.
//!
//! A row of F that is the identity's changes nothing. The others are processed in groups, each before the rows that it
//! reads: with P = Pᵀ, a group replaces its rows and columns by F's rows times P, and its own block by that times F's rows
//! again. So each element of F costs one product for each state, no temporary matrix is stored, and nothing is zeroed.
//!
//! Invariant: both triangles of P have equal bits afterwards, because one is copied to the other.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::{
    BinaryOp, Block, CompareOp, Expr, ExprKind, LocalId, LogicOp, Place, Scalar, Span, Step,
    StmtKind, Type,
};

use crate::run::Run;
use crate::value::Word;
use crate::{Result, fold, known};

/// Largest number of rows that are processed together without need.
const TOGETHER: usize = 4;

/// Number of rows from which a group whose block needs every product has one loop over all columns. Written out, the products
/// in its own columns would be long.
const DENSE: usize = 3;

/// Elements of a row of the Jacobian, by column.
type Row = BTreeMap<usize, Expr>;

/// Returns the place of the elements of a covariance of `size` states, and the type of an element. The covariance is a square
/// matrix, or a struct with one as its only field.
pub fn elements(
    module: &bessemer_ir::Module,
    root: LocalId,
    ty: &Type,
    size: u32,
    span: Span,
) -> Option<(Place, Type)> {
    let place = Place::local(root, ty.clone(), span);
    let place = match ty {
        Type::Struct(id) => match module.structs[id.index()].fields.as_slice() {
            [field] => place.inside(Step::Field(0), field.ty.clone()),
            _ => return None,
        },
        _ => place,
    };
    let Type::Matrix { element: Scalar::Float(float), rows, cols } = place.ty else { return None };
    (rows == size && cols == size).then_some((place, Type::Scalar(Scalar::Float(float))))
}

impl Run<'_> {
    /// Writes the propagation of a covariance by the Jacobian of these words, whose derivatives are atoms.
    pub fn propagate(
        &mut self,
        words: &[Word],
        (place, leaf): (Place, Type),
        span: Span,
    ) -> Result<()> {
        let row = |word: &Word| -> Row {
            word.tangents.iter().map(|(variable, it)| (*variable as usize, it.clone())).collect()
        };
        let rows: Vec<Row> = words.iter().map(row).collect();
        let covariance = Covariance { place, leaf, span };
        groups(&rows).iter().try_for_each(|group| self.group(&covariance, &rows, group))
    }

    /// Replaces the rows and columns of a group.
    fn group(&mut self, covariance: &Covariance, rows: &[Row], group: &[usize]) -> Result<()> {
        let index = |at: usize| Expr::usize(at as u64, covariance.span);
        // The products of the group's rows with its own columns that its block needs.
        let mut needed: BTreeSet<(usize, usize)> = BTreeSet::new();
        for (at, &row) in group.iter().enumerate() {
            let columns = group[at..].iter().flat_map(|below| rows[*below].keys());
            needed.extend(columns.filter(|it| group.contains(it)).map(|column| (row, *column)));
        }
        let mut own: BTreeMap<(usize, usize), Expr> = BTreeMap::new();
        // The loop must not read, in the group's own columns, an element that mirrors an earlier column.
        let is_behind = |column: &usize| group.contains(column) || Some(column) > group.last();
        let is_dense = needed.len() == group.len() * group.len()
            && group.windows(2).all(|pair| pair[0] + 1 == pair[1])
            && group.iter().all(|row| rows[*row].keys().all(is_behind));
        if group.len() >= DENSE && is_dense {
            self.columns(covariance, rows, group, (0, rows.len()), group)?;
        } else {
            // Before they change.
            for (row, column) in needed {
                let sum =
                    covariance.sum(&rows[row], row, |k| covariance.at(index(k), index(column)));
                own.insert((row, column), self.bind(&format!("row_{row}_{column}"), sum));
            }
            for range in gaps(group, rows.len()) {
                self.columns(covariance, rows, group, range, &[])?;
            }
        }
        let mut block = Vec::new();
        for (at, &row) in group.iter().enumerate() {
            for &column in &group[..=at] {
                let sum = covariance.sum(&rows[row], row, |k| match own.get(&(column, k)) {
                    Some(before) => Read::Value(before.clone()),
                    None => covariance.at(index(column), index(k)),
                });
                block.push((row, column, self.bind(&format!("block_{row}_{column}"), sum)));
            }
        }
        for (row, column, value) in block {
            self.assign(covariance.at(index(row), index(column)), value.clone());
            if row != column {
                self.assign(covariance.at(index(column), index(row)), value);
            }
        }
        Ok(())
    }

    /// Replaces the elements of a group's rows in a range of columns, and those that mirror them, except in the columns
    /// `alone`, which are neighbours.
    fn columns(
        &mut self,
        covariance: &Covariance,
        rows: &[Row],
        group: &[usize],
        (from, to): (usize, usize),
        alone: &[usize],
    ) -> Result<()> {
        let index = |at: usize| Expr::usize(at as u64, covariance.span);
        if to - from == 1 {
            self.column(covariance, rows, group, index(from), alone);
            return Ok(());
        }
        let variable = self.declare("k", &Type::USIZE, covariance.span);
        let (body, ()) = self.captured(|run| {
            let k = Expr::local(variable, &Type::USIZE, covariance.span);
            run.column(covariance, rows, group, k, alone);
            Ok(())
        })?;
        let (from, to) = (index(from), index(to));
        let (inclusive, reversed, unroll, ended) = (false, false, None, false);
        let kind = StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body };
        self.emit(kind, covariance.span);
        Ok(())
    }

    /// Replaces the elements of a group's rows in a column, and those that mirror them, unless it is one of `alone`.
    fn column(
        &mut self,
        covariance: &Covariance,
        rows: &[Row],
        group: &[usize],
        k: Expr,
        alone: &[usize],
    ) {
        let index = |at: usize| Expr::usize(at as u64, covariance.span);
        let mut products = Vec::new();
        for &row in group {
            let sum = covariance.sum(&rows[row], row, |j| covariance.at(index(j), k.clone()));
            products.push((row, self.bind(&format!("row_{row}"), sum)));
        }
        if alone.is_empty() {
            for (row, product) in products {
                self.assign(covariance.at(index(row), k.clone()), product.clone());
                self.assign(covariance.at(k.clone(), index(row)), product);
            }
            return;
        }
        for (row, product) in &products {
            self.assign(covariance.at(index(*row), k.clone()), product.clone());
        }
        let outer = std::mem::take(&mut self.out);
        for (row, product) in products {
            self.assign(covariance.at(k.clone(), index(row)), product);
        }
        let mirrored = Block(std::mem::replace(&mut self.out, outer));
        let to = Expr::compare(CompareOp::Lt, k.clone(), index(alone[0] + alone.len()));
        let within = match alone[0] {
            0 => to,
            first => {
                let from = Expr::compare(CompareOp::Le, index(first), k);
                let kind = ExprKind::Logic(LogicOp::And, Box::new(from), Box::new(to));
                Expr { kind, ty: Type::BOOL, span: covariance.span }
            }
        };
        let condition = within.negated();
        let kind = StmtKind::If { condition, then: mirrored, otherwise: Block::default() };
        self.emit(kind, covariance.span);
    }

    fn assign(&mut self, read: Read, value: Expr) {
        if let Read::Place(place) = read {
            let span = place.span;
            self.emit(StmtKind::Assign { place, value }, span);
        }
    }
}

/// The covariance of a propagation.
struct Covariance {
    place: Place,
    leaf: Type,
    span: Span,
}

/// An operand of a sum.
enum Read {
    Place(Place),
    Value(Expr),
}

impl Covariance {
    fn at(&self, row: Expr, col: Expr) -> Read {
        Read::Place(self.place.inside(Step::Element(row, col), self.leaf.clone()))
    }

    /// Returns the product of a row of F with numbers. The row's own number is first, as others add to it.
    fn sum(&self, row: &Row, own: usize, read: impl Fn(usize) -> Read) -> Expr {
        let load = |column: usize| match read(column) {
            Read::Place(place) => place.load(),
            Read::Value(value) => value,
        };
        let first = row.get_key_value(&own).into_iter();
        let rest = row.iter().filter(|it| *it.0 != own);
        let mut sum: Option<Expr> = None;
        for (&column, factor) in first.chain(rest) {
            let number = load(column);
            sum = Some(match (sum, known(factor)) {
                (None, Some(1.0)) => number,
                (None, Some(-1.0)) => fold::neg(number),
                (None, _) => Expr::binary(BinaryOp::Mul, factor.clone(), number),
                (Some(sum), Some(1.0)) => Expr::binary(BinaryOp::Add, sum, number),
                (Some(sum), Some(-1.0)) => Expr::binary(BinaryOp::Sub, sum, number),
                (Some(sum), _) => {
                    let term = Expr::binary(BinaryOp::Mul, factor.clone(), number);
                    Expr::binary(BinaryOp::Add, sum, term)
                }
            });
        }
        sum.unwrap_or_else(|| crate::float(0.0, &self.leaf, self.span))
    }
}

/// Returns the ranges of the rows that are in no group.
fn gaps(group: &[usize], size: usize) -> Vec<(usize, usize)> {
    let mut gaps = Vec::new();
    let mut from = 0;
    for &row in group.iter().chain([&size]) {
        if from < row {
            gaps.push((from, row));
        }
        from = row + 1;
    }
    gaps
}

/// Returns the rows that change, in groups: a group is before the rows that it reads, except its own. Rows that read each
/// other are in one group.
fn groups(rows: &[Row]) -> Vec<Vec<usize>> {
    let is_identity = |row: usize| {
        rows[row].len() == 1 && rows[row].get(&row).is_some_and(|it| known(it) == Some(1.0))
    };
    let size = rows.len();
    // reached[i][j]: row i reads row j, itself or by others.
    let mut reached: Vec<Vec<bool>> =
        (0..size).map(|i| (0..size).map(|j| rows[i].contains_key(&j)).collect()).collect();
    for k in 0..size {
        for i in 0..size {
            if reached[i][k] {
                let through = reached[k].clone();
                reached[i].iter_mut().zip(through).for_each(|(it, more)| *it |= more);
            }
        }
    }
    let mut components: Vec<Vec<usize>> = Vec::new();
    for row in (0..size).filter(|row| !is_identity(*row)) {
        let mutual = |other: &usize| reached[row][*other] && reached[*other][row];
        match components.iter_mut().find(|it| it.iter().any(mutual)) {
            Some(component) => component.push(row),
            None => components.push(vec![row]),
        }
    }
    // The number of components on the longest way to one: each component that reads it has a lower one.
    let mut levels = vec![0; components.len()];
    for _ in 0..components.len() {
        for reader in 0..components.len() {
            for read in 0..components.len() {
                if reader != read && reached[components[reader][0]][components[read][0]] {
                    levels[read] = levels[read].max(levels[reader] + 1);
                }
            }
        }
    }
    let mut ordered: Vec<(usize, Vec<usize>)> = levels.into_iter().zip(components).collect();
    ordered.sort();
    let read = |group: &[usize]| -> BTreeSet<usize> {
        group.iter().flat_map(|row| rows[*row].keys().copied()).collect()
    };
    let mut groups: Vec<(usize, Vec<usize>)> = Vec::new();
    for (level, component) in ordered {
        if let Some((last, group)) = groups.last_mut() {
            let (before, more) = (read(group), read(&component));
            let most = before.len().max(more.len());
            let alike = *last == level || before.union(&more).count() <= most + 1;
            if alike && group.len() + component.len() <= TOGETHER {
                group.extend(component);
                *last = level;
                continue;
            }
        }
        groups.push((level, component));
    }
    groups
        .into_iter()
        .map(|(_, mut group)| {
            group.sort_unstable();
            group
        })
        .collect()
}
