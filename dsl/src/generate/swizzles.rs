//! The companions of nalgebra's swizzles: `v.xy()`, `v.zyx()`.

#![allow(missing_docs)]

use alloc::borrow::ToOwned;

use bessemer_ir::tree;
use nalgebra::SVector;

use super::builder::{Builder, Callee};
use super::builtin::markers;
use super::slot::Called;
use crate::element::Element;

macro_rules! swizzles {
    ($($count:literal { $($method:ident $marker:ident $name:literal;)* })*) => {
        markers! { $($($marker: $name;)*)* }

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
        __b_xx Xx "swizzle_xx"; __b_xy Xy "swizzle_xy"; __b_xz Xz "swizzle_xz";
        __b_yx Yx "swizzle_yx"; __b_yy Yy "swizzle_yy"; __b_yz Yz "swizzle_yz";
        __b_zx Zx "swizzle_zx"; __b_zy Zy "swizzle_zy"; __b_zz Zz "swizzle_zz";
    }
    3 {
        __b_xxx Xxx "swizzle_xxx"; __b_xxy Xxy "swizzle_xxy"; __b_xxz Xxz "swizzle_xxz";
        __b_xyx Xyx "swizzle_xyx"; __b_xyy Xyy "swizzle_xyy"; __b_xyz Xyz "swizzle_xyz";
        __b_xzx Xzx "swizzle_xzx"; __b_xzy Xzy "swizzle_xzy"; __b_xzz Xzz "swizzle_xzz";
        __b_yxx Yxx "swizzle_yxx"; __b_yxy Yxy "swizzle_yxy"; __b_yxz Yxz "swizzle_yxz";
        __b_yyx Yyx "swizzle_yyx"; __b_yyy Yyy "swizzle_yyy"; __b_yyz Yyz "swizzle_yyz";
        __b_yzx Yzx "swizzle_yzx"; __b_yzy Yzy "swizzle_yzy"; __b_yzz Yzz "swizzle_yzz";
        __b_zxx Zxx "swizzle_zxx"; __b_zxy Zxy "swizzle_zxy"; __b_zxz Zxz "swizzle_zxz";
        __b_zyx Zyx "swizzle_zyx"; __b_zyy Zyy "swizzle_zyy"; __b_zyz Zyz "swizzle_zyz";
        __b_zzx Zzx "swizzle_zzx"; __b_zzy Zzy "swizzle_zzy"; __b_zzz Zzz "swizzle_zzz";
    }
}

impl<T: Element, const N: usize> SwizzleBuiltins<T> for SVector<T, N> {}
