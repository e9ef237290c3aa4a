//! Random matrices and vectors: values of them, numbers that are taken from them, and what changes them.

use super::types::{Ty, path};
use super::writer::{Kind, Place, Var, Writer};

/// Element type of a matrix, and its numbers of rows and columns.
type Shape = (&'static str, usize, usize);

fn shape(ty: &Ty) -> Option<Shape> {
    match ty {
        Ty::Matrix(element, rows, cols) => Some((element, *rows, *cols)),
        _ => None,
    }
}

fn is_float(element: &str) -> bool {
    element.starts_with('f')
}

impl Writer<'_> {
    /// A matrix, at most `fuel` deep.
    pub fn matrix(&mut self, (element, rows, cols): Shape, fuel: usize) -> String {
        let ty = Ty::Matrix(element, rows, cols);
        if fuel == 0 {
            return self.matrix_of_elements((element, rows, cols), 0);
        }
        let less = fuel - 1;
        // Arithmetic and views of matrices are of floats.
        let float = is_float(element);
        match self.below(22) {
            0..=2 if float => {
                let (one, other) = (self.value(&ty, less), self.value(&ty, less));
                let operator = self.random.of(&["+", "-"]);
                match self.below(3) {
                    0 => format!("(&{one} {operator} &{other})"),
                    _ => format!("({one} {operator} {other})"),
                }
            }
            3 | 4 if float => {
                let (one, by) = (self.value(&ty, less), self.value(&ty.element(), less));
                let operator = if float { self.random.of(&["*", "/"]) } else { "*" };
                format!("({one} {operator} {by})")
            }
            5..=7 if float => {
                let inner = 1 + self.below(4);
                let one = self.value(&Ty::Matrix(element, rows, inner), less);
                let other = self.value(&Ty::Matrix(element, inner, cols), less);
                format!("({one} * {other})")
            }
            8 => {
                let one = self.value(&Ty::Matrix(element, cols, rows), less);
                format!("{one}.transpose()")
            }
            9 if float => {
                let inner = 1 + self.below(3);
                let one = self.value(&Ty::Matrix(element, inner, rows), less);
                let other = self.value(&Ty::Matrix(element, inner, cols), less);
                format!("{one}.tr_mul(&{other})")
            }
            10 if float => {
                let (one, other) = (self.value(&ty, less), self.value(&ty, less));
                format!("{one}.component_mul(&{other})")
            }
            11 if float => {
                let one = self.value(&ty, less);
                let method = self.random.of(&["abs()", "add_scalar(0.5)", "scale(2.5)"]);
                match self.below(3) {
                    0 => format!("(-{one})"),
                    1 => format!("{one}.component_div(&{})", self.value(&ty, less)),
                    _ => format!("{one}.{method}"),
                }
            }
            12 | 13 => {
                let one = self.value(&ty, less);
                let (closure, _) = self.lambda(&ty.element(), &ty.element(), less);
                format!("{one}.map({closure})")
            }
            14 | 15 if float => {
                self.part((element, rows, cols)).unwrap_or_else(|| self.simple(&ty))
            }
            16 if float && (rows, cols) == (3, 1) => {
                let (one, other) = (self.value(&ty, less), self.value(&ty, less));
                format!("{one}.cross(&{other})")
            }
            17 => {
                let before = self.env.len();
                let int = Ty::Int("usize");
                self.env.push(Var::new("r", &int, Kind::Owned, false));
                self.env.push(Var::new("c", &int, Kind::Owned, false));
                let value = self.unreturned(|it| it.inner_block(&ty.element(), less));
                self.close(before);
                format!("{}::from_fn(|r, c| {{ {value} }})", self.path(&ty))
            }
            _ => self.matrix_of_elements((element, rows, cols), less),
        }
    }

    fn path(&self, ty: &Ty) -> String {
        path(&self.items.name(ty))
    }

    fn matrix_of_elements(&mut self, (element, rows, cols): Shape, fuel: usize) -> String {
        let ty = Ty::Matrix(element, rows, cols);
        let path = self.path(&ty);
        match self.below(8) {
            0 => format!("{path}::zeros()"),
            1 => format!("{path}::identity()"),
            2 => format!("{path}::from_element({})", self.value(&ty.element(), fuel)),
            _ => {
                let mut row =
                    || -> Vec<_> { (0..cols).map(|_| self.value(&ty.element(), fuel)).collect() };
                let all: Vec<_> = (0..rows).map(|_| row().join(", ")).collect();
                if rows * cols > 1 && (rows == cols || cols == 1) && self.one_in(2) {
                    return format!("{path}::new({})", all.join(", "));
                }
                format!("matrix![{}]", all.join("; "))
            }
        }
    }

    /// A part of a matrix that is at hand, which may not be there.
    fn part(&mut self, (element, rows, cols): Shape) -> Option<String> {
        let place = self.place(false, &|ty| {
            shape(ty).is_some_and(|it| it.0 == element && it.1 >= rows && it.2 >= cols)
        })?;
        let (_, all_rows, all_cols) = shape(&place.ty)?;
        self.lend(place.root, false);
        let text = &place.text;
        let whole = match self.below(4) {
            0 if cols == 1 && rows == all_rows => {
                format!("{text}.column({}).into_owned()", self.position(all_cols, 1))
            }
            1 if rows == 1 && cols == all_cols => {
                format!("{text}.row({}).into_owned()", self.position(all_rows, 1))
            }
            2 if cols == all_cols => {
                format!(
                    "{text}.fixed_rows::<{rows}>({}).into_owned()",
                    self.position(all_rows, rows)
                )
            }
            _ => {
                let (row, col) = (self.position(all_rows, rows), self.position(all_cols, cols));
                format!("{text}.fixed_view::<{rows}, {cols}>({row}, {col}).into_owned()")
            }
        };
        self.end(place.root, false);
        Some(whole)
    }

    /// Returns the first index of a part of `size` among `all`.
    pub fn position(&mut self, all: usize, size: usize) -> String {
        match self.below(4) {
            0 if self.risky() => self.value(&Ty::Int("usize"), 1),
            1 => format!("({} % {})", self.value(&Ty::Int("usize"), 1), all - size + 1),
            _ => self.below(all - size + 1).to_string(),
        }
    }

    /// A number out of a matrix.
    pub fn of_matrix(&mut self, ty: &Ty, fuel: usize) -> Option<String> {
        let Ty::Float(element) = *ty else { return None };
        let place = self.place(false, &|ty| shape(ty).is_some_and(|it| it.0 == element))?;
        let (_, rows, cols) = shape(&place.ty)?;
        let text = &place.text;
        self.lend(place.root, false);
        let found = match self.below(10) {
            0 | 1 => format!("{text}.dot(&{})", self.value(&place.ty, fuel)),
            2 => format!("{text}.sum()"),
            3 if rows == cols => format!("{text}.trace()"),
            3 => format!("{text}.product()"),
            4 => format!("{text}.norm_squared()"),
            5 => format!("{text}.norm()"),
            6 if rows == cols => format!("{text}.determinant()"),
            6 => format!("{text}.mean()"),
            7 => {
                let (one, other) = (self.position(cols, 1), self.position(cols, 1));
                format!("{text}.column({one}).dot(&{text}.column({other}))")
            }
            8 => {
                let sum = Ty::Float(element);
                let start = self.value(&sum, fuel);
                let kept = self.freeze_all(true);
                let before = self.env.len();
                self.env.push(Var::new("sum", &sum, Kind::Owned, false));
                self.env.push(Var::new("x", &sum, Kind::Shared, false));
                let step = self.unreturned(|it| it.inner_block(&sum, fuel.min(1)));
                self.close(before);
                self.thaw(kept);
                format!("{text}.iter().fold({start}, |sum, x| {{ {step} }})")
            }
            _ => {
                let (row, col) = (self.position(rows, 1), self.position(cols, 1));
                format!("{text}[({row}, {col})]")
            }
        };
        self.end(place.root, false);
        Some(found)
    }

    /// A statement that changes a matrix in its place.
    pub fn matrix_edit(&mut self, fuel: usize) -> Option<String> {
        let place = self.place(true, &|ty| shape(ty).is_some())?;
        self.lend(place.root, true);
        let text = self.edited(&place, fuel);
        self.end(place.root, true);
        text
    }

    fn edited(&mut self, place: &Place, fuel: usize) -> Option<String> {
        let (element, rows, cols) = shape(&place.ty)?;
        let (text, of) = (&place.text, place.ty.element());
        let float = is_float(element);
        let (column, row) = (Ty::Matrix(element, rows, 1), Ty::Matrix(element, 1, cols));
        let at = (self.position(rows, 1), self.position(cols, 1));
        let which = if float { self.below(14) } else { self.random.of(&[0, 13]) };
        Some(match which {
            0 => format!("{text}[({}, {})] = {};", at.0, at.1, self.value(&of, fuel)),
            1 => format!("{text}.set_row({}, &{});", at.0, self.value(&row, fuel)),
            2 => format!("{text}.set_column({}, &{});", at.1, self.value(&column, fuel)),
            3 => format!("{text}.column_mut({}).copy_from(&{});", at.1, self.value(&column, fuel)),
            4 => format!("{text}.swap_rows({}, {});", at.0, self.position(rows, 1)),
            5 => format!("{text}.fill_row({}, {});", at.0, self.value(&of, fuel)),
            6 => format!("{text}.fill({});", self.value(&of, fuel)),
            7 if rows == cols => format!("{text}.transpose_mut();"),
            8 => {
                let operator = self.random.of(&["*=", "/="]);
                format!("{text} {operator} {};", self.value(&of, fuel))
            }
            9 if rows == cols => {
                format!("{text} *= {};", self.value(&place.ty, fuel))
            }
            10 => {
                format!("{text}.component_mul_assign(&{});", self.value(&place.ty, fuel))
            }
            11 => {
                let (part_rows, part_cols) = (1 + self.below(rows), 1 + self.below(cols));
                let at = (self.position(rows, part_rows), self.position(cols, part_cols));
                let part = self.value(&Ty::Matrix(element, part_rows, part_cols), fuel);
                format!(
                    "{text}.fixed_view_mut::<{part_rows}, {part_cols}>({}, {}).copy_from(&{part});",
                    at.0, at.1
                )
            }
            12 => {
                let before = self.env.len();
                self.env.push(Var::new("x", &of, Kind::Exclusive, false));
                let body = self.statement(fuel.min(1));
                self.close(before);
                format!("for x in {text}.iter_mut() {{\n{body}}}")
            }
            _ if float => {
                let operator = self.random.of(&["+=", "-="]);
                format!("{text} {operator} {};", self.value(&place.ty, fuel))
            }
            _ => format!("{text} = {};", self.value(&place.ty, fuel)),
        })
    }
}
