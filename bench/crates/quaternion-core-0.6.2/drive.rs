//! Calls of `quaternion-core` over plain numbers.

use crate::*;

pub fn of_axis(axis: [f64; 3], angle: f64) -> ((f64, [f64; 3]), ([f64; 3], f64)) {
    let q = from_axis_angle(axis, angle);
    (q, to_axis_angle(q))
}

pub fn of_matrix(q: (f64, [f64; 3])) -> ([[f64; 3]; 3], (f64, [f64; 3])) {
    let m = to_dcm(q);
    (m, from_dcm(m))
}

pub fn of_euler(angles: [f64; 3]) -> ((f64, [f64; 3]), [f64; 3]) {
    let q = from_euler_angles(RotationType::Intrinsic, RotationSequence::ZYX, angles);
    (q, to_euler_angles(RotationType::Extrinsic, RotationSequence::XYZ, q))
}

pub fn of_vector(r: [f64; 3]) -> ((f64, [f64; 3]), [f64; 3]) {
    let q = from_rotation_vector(r);
    (q, to_rotation_vector(q))
}

pub fn algebra(a: (f64, [f64; 3]), b: (f64, [f64; 3]), s: f64) -> [(f64, [f64; 3]); 8] {
    [add(a, b), sub(a, b), scale(s, a), scale_add(s, a, b), mul(a, b), conj(a), inv(a), normalize(b)]
}

pub fn powers(q: (f64, [f64; 3]), t: f64) -> [(f64, [f64; 3]); 5] {
    [exp(q), ln(q), pow(q, t), pow_versor(q, t), sqrt(q)]
}

pub fn rotations(q: (f64, [f64; 3]), v: [f64; 3], w: [f64; 3]) -> ([[f64; 3]; 2], Option<(f64, [f64; 3])>, Option<(f64, [f64; 3])>) {
    ([point_rotation(q, v), frame_rotation(q, v)], rotate_a_to_b(v, w), rotate_a_to_b_shortest(v, w))
}

pub fn between(a: (f32, [f32; 3]), b: (f32, [f32; 3]), t: f32) -> [(f32, [f32; 3]); 2] {
    [lerp(a, b, t), slerp(a, b, t)]
}

pub fn products(a: [f64; 3], b: [f64; 3]) -> ([f64; 4], [f64; 3], [f64; 3]) {
    ([sum(a), dot(a, b), norm(a), norm(b)], cross(a, b), hadamard(a, b))
}
