//! The companions of nalgebra's swizzles: `v.xy()`, `v.zyx()`.

#![allow(missing_docs)]

use bessemer_ir::tree::{self, MatrixMethod};
use nalgebra::SVector;

use super::builder::{Builder, Callee};
use super::builtin::markers;
use super::slot::Called;
use crate::element::Element;

macro_rules! swizzles {
    ($($count:literal { $($method:ident $marker:ident $axes:expr;)* })*) => {
        markers! { $($($marker: Matrix(MatrixMethod::Swizzle($axes, $count));)*)* }

        /// Vectors of a vector's components.
        pub trait SwizzleBuiltins<T: Element>: Sized {$($(
            fn $method(&self) -> Called<$marker, SVector<T, $count>> {
                unreachable!()
            }
        )*)*}
    };
}

swizzles! {
    2 {
        __b_xx Xx [0, 0, 0]; __b_xy Xy [0, 1, 0]; __b_xz Xz [0, 2, 0];
        __b_yx Yx [1, 0, 0]; __b_yy Yy [1, 1, 0]; __b_yz Yz [1, 2, 0];
        __b_zx Zx [2, 0, 0]; __b_zy Zy [2, 1, 0]; __b_zz Zz [2, 2, 0];
    }
    3 {
        __b_xxx Xxx [0, 0, 0]; __b_xxy Xxy [0, 0, 1]; __b_xxz Xxz [0, 0, 2];
        __b_xyx Xyx [0, 1, 0]; __b_xyy Xyy [0, 1, 1]; __b_xyz Xyz [0, 1, 2];
        __b_xzx Xzx [0, 2, 0]; __b_xzy Xzy [0, 2, 1]; __b_xzz Xzz [0, 2, 2];
        __b_yxx Yxx [1, 0, 0]; __b_yxy Yxy [1, 0, 1]; __b_yxz Yxz [1, 0, 2];
        __b_yyx Yyx [1, 1, 0]; __b_yyy Yyy [1, 1, 1]; __b_yyz Yyz [1, 1, 2];
        __b_yzx Yzx [1, 2, 0]; __b_yzy Yzy [1, 2, 1]; __b_yzz Yzz [1, 2, 2];
        __b_zxx Zxx [2, 0, 0]; __b_zxy Zxy [2, 0, 1]; __b_zxz Zxz [2, 0, 2];
        __b_zyx Zyx [2, 1, 0]; __b_zyy Zyy [2, 1, 1]; __b_zyz Zyz [2, 1, 2];
        __b_zzx Zzx [2, 2, 0]; __b_zzy Zzy [2, 2, 1]; __b_zzz Zzz [2, 2, 2];
    }
}

impl<T: Element, const N: usize> SwizzleBuiltins<T> for SVector<T, N> {}
