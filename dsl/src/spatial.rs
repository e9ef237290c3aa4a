//! nalgebra's rotations, points and poses as words: in nalgebra's order of fields, a pose's rotation first.

use nalgebra::{
    Const, Isometry3, OPoint, Quaternion, Rotation, SMatrix, SVector, Scalar, Translation, Unit,
    UnitQuaternion, Vector4,
};

use crate::Plain;
use crate::math::Real;

macro_rules! as_what_it_holds {
    ($([$($bounds:tt)*] $native:ty: $held:ty, |$it:ident| $inner:expr, $wrap:expr;)*) => {$(
        #[diagnostic::do_not_recommend]
        impl<$($bounds)*> Plain for $native {
            const WORDS: usize = <$held>::WORDS;
            fn store(&self, out: &mut dyn FnMut(u64)) {
                let $it = self;
                $inner.store(out);
            }
            fn load(next: &mut dyn FnMut() -> u64) -> Self {
                $wrap(<$held>::load(next))
            }
        }
    )*};
}

as_what_it_holds! {
    [T: Plain + Scalar] Quaternion<T>: Vector4<T>, |q| q.coords, |coords| Quaternion { coords };
    [T: Plain + Scalar] UnitQuaternion<T>: Quaternion<T>, |q| q.as_ref(), Unit::new_unchecked;
    [T: Plain + Scalar, const N: usize] Rotation<T, N>: SMatrix<T, N, N>, |m| m.matrix(), Rotation::from_matrix_unchecked;
    [T: Plain + Scalar, const N: usize] Translation<T, N>: SVector<T, N>, |t| t.vector, |vector| Translation { vector };
    [T: Plain + Scalar, const N: usize] OPoint<T, Const<N>>: SVector<T, N>, |p| p.coords, |coords| OPoint { coords };
    [T: Plain + Scalar, const N: usize] Unit<SVector<T, N>>: SVector<T, N>, |v| v.as_ref(), Unit::new_unchecked;
}

#[diagnostic::do_not_recommend]
impl<T: Real> Plain for Isometry3<T> {
    const WORDS: usize = 7;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        self.rotation.store(out);
        self.translation.store(out);
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        let rotation = UnitQuaternion::load(next);
        Isometry3::from_parts(Translation::load(next), rotation)
    }
}
