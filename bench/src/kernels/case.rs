//! The cases of the measurement, and the numbers that they run on.

/// A measured routine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Routine {
    /// Solves `a x = b` for one right-hand side by LU.
    LuSolve,
    /// Computes the inverse.
    Inverse,
    /// Solves `a x = b` for a symmetric, positive definite `a`.
    CholeskySolve,
    /// Multiplies two square matrices.
    Product,
}

impl Routine {
    /// All routines in the order of the tables.
    pub const ALL: [Routine; 4] =
        [Routine::LuSolve, Routine::Inverse, Routine::CholeskySolve, Routine::Product];

    /// Returns the name in results, such as `lu_solve`.
    pub fn name(self) -> &'static str {
        match self {
            Routine::LuSolve => "lu_solve",
            Routine::Inverse => "inverse",
            Routine::CholeskySolve => "cholesky_solve",
            Routine::Product => "product",
        }
    }

    /// Returns the title in tables.
    pub fn title(self) -> &'static str {
        match self {
            Routine::LuSolve => "LU solve",
            Routine::Inverse => "inverse",
            Routine::CholeskySolve => "Cholesky solve",
            Routine::Product => "product",
        }
    }
}

/// A float type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Element {
    /// `double`.
    F64,
    /// `float`.
    F32,
}

impl Element {
    /// Returns the name in results, such as `f64`.
    pub fn name(self) -> &'static str {
        match self {
            Element::F64 => "f64",
            Element::F32 => "f32",
        }
    }
}

/// A case: a routine with a float type and a size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Case {
    /// Routine that is measured.
    pub routine: Routine,
    /// Float type of the elements.
    pub element: Element,
    /// Number of rows and columns.
    pub size: usize,
}

/// The two parts of the computation of Chapter 6.
pub const CHAPTER_6: [Case; 2] = [
    Case { routine: Routine::LuSolve, element: Element::F64, size: 200 },
    Case { routine: Routine::Inverse, element: Element::F64, size: 100 },
];

impl Case {
    /// Returns the name in results, such as `lu_solve_f64_6`.
    pub fn name(&self) -> String {
        format!("{}_{}_{}", self.routine.name(), self.element.name(), self.size)
    }

    /// Returns every small case of these sizes.
    pub fn small(sizes: &[usize]) -> Vec<Case> {
        let mut cases = Vec::new();
        for element in [Element::F64, Element::F32] {
            for routine in Routine::ALL {
                cases.extend(sizes.iter().map(|&size| Case { routine, element, size }));
            }
        }
        cases
    }
}

/// The numbers of a case as doubles, by columns, equal to those of `bench/c/harness.c`; numbers of `f32` are exact.
pub struct Numbers {
    /// The first operand.
    pub matrix: Vec<f64>,
    /// The second operand of a product.
    pub second: Vec<f64>,
    /// The right-hand side.
    pub vector: Vec<f64>,
}

impl Numbers {
    /// Returns the numbers of a case.
    pub fn of(case: &Case) -> Numbers {
        let n = case.size;
        let fill = |count, seed: u64| fill(count, seed.wrapping_add(n as u64), case.element);
        let mut matrix = fill(n * n, 0x9E37_79B9_7F4A_7C15);
        if case.routine == Routine::CholeskySolve {
            make_definite(&mut matrix, n, case.element);
        }
        let second = fill(n * n, 0xD1B5_4A32_D192_ED03);
        Numbers { matrix, second, vector: fill(n, 0x8CB9_2BA7_2F3D_8DD7) }
    }
}

fn make_definite(matrix: &mut [f64], n: usize, element: Element) {
    let round = |number: f64| match element {
        Element::F64 => number,
        Element::F32 => f64::from(number as f32),
    };
    for column in 0..n {
        for row in 0..=column {
            let sum = round(matrix[row + n * column] + matrix[column + n * row]);
            matrix[row + n * column] = sum;
            matrix[column + n * row] = sum;
        }
    }
    for i in 0..n {
        matrix[i + n * i] = round(matrix[i + n * i] + n as f64);
    }
}

fn fill(count: usize, seed: u64, element: Element) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        let number = (state.wrapping_mul(2_685_821_657_736_338_717) >> 11) as f64 * 2f64.powi(-53);
        match element {
            Element::F64 => number,
            Element::F32 => (number * 2f64.powi(24)).floor() * 2f64.powi(-24),
        }
    };
    (0..count).map(|_| next()).collect()
}
