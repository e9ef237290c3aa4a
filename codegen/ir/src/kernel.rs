//! Kernels: routines of linear algebra that are functions of their own, one for each routine, element type and shape.
//!
//! A [`Kernel`] identifies one; [`Kernel::function`] is its function in the module, a signature without a body. Each
//! executor of IR has its own body: the interpreter plain loops, the C back end a file for each kernel. Calls of it
//! are ordinary calls.
//!
//! Invariants: result bits and name follow only from routine, element type and shape, in nalgebra's order of
//! operations. A kernel cannot fault. A new kernel does not change the text of others.
//!
//! Must not know: how it is computed, and its working memory, which belong to the back end.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use crate::ir::{Function, Local, Mode, Role, Type};
use crate::{Float, Scalar};

pub use bessemer_tree::routine::KernelRoutine;

/// A routine of linear algebra with its element type and its shape.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Kernel {
    /// Routine of the kernel.
    pub routine: KernelRoutine,
    /// The type of every element.
    pub element: Float,
    /// Dimensions as [`KernelRoutine`] defines them; each at least 1.
    pub dims: Vec<u32>,
}

/// Largest number of multiplications for which a product is written out in place.
pub const WRITTEN_OUT: u32 = 24;

/// Largest number of multiplications for which a product of a transpose, whose elements are scalar products of
/// columns, is written out in place.
pub const DOTS_WRITTEN_OUT: u32 = 64;

impl Kernel {
    /// Returns a kernel, if the number of dimensions is the routine's and none is 0.
    pub fn new(routine: KernelRoutine, element: Float, dims: &[u32]) -> Option<Kernel> {
        let sound = dims.len() == routine.dims() && !dims.contains(&0);
        sound.then(|| Kernel { routine, element, dims: dims.to_vec() })
    }

    /// Returns the name of its function and its file, such as `lu_solve_f64_6` or `product_f64_6x6_6x3`.
    pub fn name(&self) -> String {
        let shape = match (self.routine, self.dims.as_slice()) {
            (KernelRoutine::Product, [rows, inner, cols]) => {
                format!("{rows}x{inner}_{inner}x{cols}")
            }
            (KernelRoutine::ProductTr, [rows, inner, cols]) => {
                format!("{rows}x{inner}_{cols}x{inner}")
            }
            (KernelRoutine::TrProduct, [rows, inner, cols]) => {
                format!("{inner}x{rows}_{inner}x{cols}")
            }
            (KernelRoutine::TrMul, [rows, left, right]) => format!("{rows}x{left}_{rows}x{right}"),
            (_, [size, 1] | [size]) => format!("{size}"),
            (_, [size, cols]) => format!("{size}x{cols}"),
            _ => String::from("unsound"),
        };
        format!("{}_{}_{shape}", self.routine.name(), Scalar::Float(self.element).name())
    }

    /// Returns true if it is a function of its own. Otherwise it is expanded at its call. The product of a column and
    /// a row always is, since it may be part of a loop over elements.
    pub fn is_function(&self) -> bool {
        let multiplications: u64 = self.dims.iter().map(|dim| u64::from(*dim)).product();
        match (self.routine, self.dims.as_slice()) {
            (
                KernelRoutine::Product | KernelRoutine::ProductTr | KernelRoutine::TrProduct,
                [_, inner, _],
            ) => *inner > 1 && multiplications > WRITTEN_OUT.into(),
            (KernelRoutine::TrMul, _) => multiplications > DOTS_WRITTEN_OUT.into(),
            _ => true,
        }
    }

    /// Returns its function: a signature without a body.
    pub fn function(&self) -> Function {
        let name = self.name();
        let (params, result) = self.face();
        let locals: Vec<Local> = params
            .into_iter()
            .map(|(name, ty, mode)| Local { name: name.into(), ty, mode, span: Default::default() })
            .collect();
        Function {
            module: format!("bessemer::kernels::{name}"),
            name,
            owner: None,
            role: Role::Public,
            attributes: Default::default(),
            docs: self.docs(),
            params: locals.len() as u32,
            locals,
            result,
            result_name: "result".into(),
            body: Default::default(),
            kernel: Some(self.clone()),
            span: Default::default(),
        }
    }

    /// Returns its function for matrices that are not stored by columns: it takes arrays of their elements.
    pub fn flat_function(&self) -> Function {
        let mut function = self.function();
        function.result = flat(&function.result);
        for local in &mut function.locals {
            local.ty = flat(&local.ty);
        }
        function
    }

    fn face(&self) -> (Vec<(&'static str, Type, Mode)>, Type) {
        let element = Scalar::Float(self.element);
        let matrix = |rows, cols| Type::Matrix { element, rows, cols };
        let dim = |index: usize| self.dims.get(index).copied().unwrap_or_default();
        let (n, m, k) = (dim(0), dim(1), dim(2));
        match self.routine {
            KernelRoutine::Product => (
                alloc::vec![("a", matrix(n, m), Mode::Ref), ("b", matrix(m, k), Mode::Ref)],
                matrix(n, k),
            ),
            KernelRoutine::ProductTr => (
                alloc::vec![("a", matrix(n, m), Mode::Ref), ("b", matrix(k, m), Mode::Ref)],
                matrix(n, k),
            ),
            KernelRoutine::TrProduct => (
                alloc::vec![("a", matrix(m, n), Mode::Ref), ("b", matrix(m, k), Mode::Ref)],
                matrix(n, k),
            ),
            KernelRoutine::TrMul => (
                alloc::vec![("a", matrix(n, m), Mode::Ref), ("b", matrix(n, k), Mode::Ref)],
                matrix(m, k),
            ),
            KernelRoutine::LuSolve => (
                alloc::vec![("a", matrix(n, n), Mode::RefMut), ("b", matrix(n, m), Mode::RefMut)],
                Type::BOOL,
            ),
            KernelRoutine::Inverse | KernelRoutine::Cholesky => {
                (alloc::vec![("a", matrix(n, n), Mode::RefMut)], Type::BOOL)
            }
            KernelRoutine::CholeskyLower => {
                (alloc::vec![("a", matrix(n, n), Mode::Ref)], matrix(n, n))
            }
            KernelRoutine::CholeskySolve => (
                alloc::vec![("a", matrix(n, n), Mode::Ref), ("b", matrix(n, m), Mode::RefMut)],
                Type::Unit,
            ),
            KernelRoutine::Solve
            | KernelRoutine::SolveLower
            | KernelRoutine::SolveUpper
            | KernelRoutine::TrSolveLower
            | KernelRoutine::TrSolveUpper => (
                alloc::vec![("a", matrix(n, n), Mode::Ref), ("b", matrix(n, m), Mode::RefMut)],
                Type::BOOL,
            ),
            KernelRoutine::Determinant => {
                (alloc::vec![("a", matrix(n, n), Mode::Ref)], Type::Scalar(element))
            }
        }
    }

    /// Returns its description, for the header of the C.
    fn docs(&self) -> Vec<String> {
        let lines: &[&str] = match (self.routine, self.dims.as_slice()) {
            (KernelRoutine::Product, _) => &[
                "The product of a and b, matrices by columns. Each element of the result starts as its",
                "first product and adds the others in the order of the columns of a.",
            ],
            (KernelRoutine::ProductTr, _) => &[
                "The product of a with the transpose of b, matrices by columns. Each element of the result",
                "starts as its first product and adds the others in the order of the columns of a.",
            ],
            (KernelRoutine::TrProduct, _) => &[
                "The product of the transpose of a with b, matrices by columns. Each element of the result",
                "starts as its first product and adds the others in the order of the rows of a.",
            ],
            (KernelRoutine::TrMul, _) => &[
                "The product of the transpose of a with b, matrices by columns. Each element of the result",
                "is the scalar product of two columns, in nalgebra's order.",
            ],
            (KernelRoutine::LuSolve, _) => &[
                "Solves a x = b by elimination with row pivots, in place; matrices by columns. a becomes its",
                "factors, rows in the order of the pivots: U, and below the diagonal L without its ones. b",
                "becomes x. False, and NaN in both, if a is singular.",
                "",
                "The pivot is the first of the largest magnitudes; a multiplier is an element times the",
                "reciprocal of the pivot; an element takes the steps of the elimination in their order,",
                "each as (-u) * l + element.",
            ],
            (KernelRoutine::Solve, _) => &[
                "Solves a x = b by elimination with row pivots, in place of b; matrices by columns. a stays as",
                "it is. False, and NaN in b, if a is singular.",
                "",
                "The pivot is the first of the largest magnitudes; a multiplier is an element times the",
                "reciprocal of the pivot; an element takes the steps of the elimination in their order,",
                "each as (-u) * l + element.",
            ],
            (KernelRoutine::Inverse, [0..=4]) => &[
                "Inverts a in place, by cofactors; matrices by columns. False, and a as it was, if the",
                "determinant is zero.",
            ],
            (KernelRoutine::Inverse, _) => &[
                "Inverts a in place, by elimination with row pivots; matrices by columns. False, and a as it",
                "was, if it is singular.",
                "",
                "The pivot is the first of the largest magnitudes; a multiplier is an element times the",
                "reciprocal of the pivot; an element takes the steps of the elimination in their order,",
                "each as (-u) * l + element.",
            ],
            (KernelRoutine::Cholesky, _) => &[
                "Factors a, symmetric, into L times its transpose, in place; matrices by columns. L takes the",
                "lower triangle, which alone is read; what is above stays. False, and NaN in the lower",
                "triangle, unless a is positive definite.",
                "",
                "Column by column: an element takes the columns before in their order, each as",
                "(-l) * l + element; then the root of the diagonal divides.",
            ],
            (KernelRoutine::CholeskyLower, _) => &[
                "The factor L of a, symmetric, which is L times its transpose; matrices by columns. The lower",
                "triangle of a alone is read; what is above is above L, too. NaN in the lower triangle, unless",
                "a is positive definite.",
                "",
                "Column by column: an element takes the columns before in their order, each as",
                "(-l) * l + element; then the root of the diagonal divides.",
            ],
            (KernelRoutine::CholeskySolve, _) => &[
                "Solves L times its transpose times x = b, in place of b, where a holds L in its lower",
                "triangle; matrices by columns.",
                "",
                "Downwards each value is divided, then taken from the rows below; upwards the scalar product",
                "with the values below, in nalgebra's order, is taken away before the division.",
            ],
            (KernelRoutine::SolveLower, _) => &[
                "Solves a x = b in place of b, of a the lower triangle; matrices by columns. False, and NaN in",
                "b, if the diagonal has a zero. Each value is divided, then taken from the rows below.",
            ],
            (KernelRoutine::SolveUpper, _) => &[
                "Solves a x = b in place of b, of a the upper triangle; matrices by columns. False, and NaN in",
                "b, if the diagonal has a zero. Each value is divided, then taken from the rows above.",
            ],
            (KernelRoutine::TrSolveLower, _) => &[
                "Solves transpose(a) x = b in place of b, of a the lower triangle; matrices by columns. False,",
                "and NaN in b, if the diagonal has a zero. From the last row upwards: the scalar product with",
                "the values below, in nalgebra's order, is taken away, then divided.",
            ],
            (KernelRoutine::TrSolveUpper, _) => &[
                "Solves transpose(a) x = b in place of b, of a the upper triangle; matrices by columns. False,",
                "and NaN in b, if the diagonal has a zero. From the first row downwards: the scalar product",
                "with the values above, in nalgebra's order, is taken away, then divided.",
            ],
            (KernelRoutine::Determinant, [0..=3]) => &["The determinant of a, by minors."],
            (KernelRoutine::Determinant, _) => &[
                "The determinant of a: the product of the pivots of an elimination by rows, from the first,",
                "times -1 for an odd number of exchanges.",
            ],
        };
        lines.iter().map(|&line| String::from(line)).collect()
    }
}

/// Six products of three elements, each with its sign.
pub type Products = [(i8, [usize; 3]); 6];

/// The sixteen cofactors of a 4×4 matrix by columns, transposed. Each has its element of the inverse and its six
/// products with signs, in the order in which nalgebra sums them.
///
/// The determinant is the sum of the elements 0 to 3 of the matrix times the first four of these.
pub const COFACTORS: [(usize, Products); 16] = {
    const fn six(signs: i8, products: [[usize; 3]; 6]) -> Products {
        let [a, b, c, d, e, f] = products;
        let (plus, minus) = (signs, -signs);
        [(plus, a), (minus, b), (minus, c), (plus, d), (plus, e), (minus, f)]
    }
    #[rustfmt::skip]
    let table = [
        (0, six(1, [[5, 10, 15], [5, 11, 14], [9, 6, 15], [9, 7, 14], [13, 6, 11], [13, 7, 10]])),
        (4, six(-1, [[4, 10, 15], [4, 11, 14], [8, 6, 15], [8, 7, 14], [12, 6, 11], [12, 7, 10]])),
        (8, six(1, [[4, 9, 15], [4, 11, 13], [8, 5, 15], [8, 7, 13], [12, 5, 11], [12, 7, 9]])),
        (12, six(-1, [[4, 9, 14], [4, 10, 13], [8, 5, 14], [8, 6, 13], [12, 5, 10], [12, 6, 9]])),
        (1, six(-1, [[1, 10, 15], [1, 11, 14], [9, 2, 15], [9, 3, 14], [13, 2, 11], [13, 3, 10]])),
        (2, six(1, [[1, 6, 15], [1, 7, 14], [5, 2, 15], [5, 3, 14], [13, 2, 7], [13, 3, 6]])),
        (3, six(-1, [[1, 6, 11], [1, 7, 10], [5, 2, 11], [5, 3, 10], [9, 2, 7], [9, 3, 6]])),
        (5, six(1, [[0, 10, 15], [0, 11, 14], [8, 2, 15], [8, 3, 14], [12, 2, 11], [12, 3, 10]])),
        (6, six(-1, [[0, 6, 15], [0, 7, 14], [4, 2, 15], [4, 3, 14], [12, 2, 7], [12, 3, 6]])),
        (7, six(1, [[0, 6, 11], [0, 7, 10], [4, 2, 11], [4, 3, 10], [8, 2, 7], [8, 3, 6]])),
        (9, six(-1, [[0, 9, 15], [0, 11, 13], [8, 1, 15], [8, 3, 13], [12, 1, 11], [12, 3, 9]])),
        (10, six(1, [[0, 5, 15], [0, 7, 13], [4, 1, 15], [4, 3, 13], [12, 1, 7], [12, 3, 5]])),
        (11, six(-1, [[0, 5, 11], [0, 7, 9], [4, 1, 11], [4, 3, 9], [8, 1, 7], [8, 3, 5]])),
        (13, six(1, [[0, 9, 14], [0, 10, 13], [8, 1, 14], [8, 2, 13], [12, 1, 10], [12, 2, 9]])),
        (14, six(-1, [[0, 5, 14], [0, 6, 13], [4, 1, 14], [4, 2, 13], [12, 1, 6], [12, 2, 5]])),
        (15, six(1, [[0, 5, 10], [0, 6, 9], [4, 1, 10], [4, 2, 9], [8, 1, 6], [8, 2, 5]])),
    ];
    table
};

/// Returns the array type of a matrix's elements by columns, if it has several rows and columns; any other type
/// unchanged.
pub fn flat(ty: &Type) -> Type {
    match ty {
        Type::Matrix { element, rows, cols } if *rows > 1 && *cols > 1 => Type::Array {
            element: alloc::boxed::Box::new(Type::Scalar(*element)),
            len: rows * cols,
        },
        other => other.clone(),
    }
}
