// What `+=` of an own operator writes: the place is computed once, before the operand.
use core::ops::{Add, AddAssign, MulAssign};
#[data]
#[derive(Clone, Copy)]
pub struct FoundPlacesComputedOnceV { pub x: i32, pub y: i32 }
#[data]
impl Add for FoundPlacesComputedOnceV { type Output = FoundPlacesComputedOnceV; fn add(self, o: FoundPlacesComputedOnceV) -> FoundPlacesComputedOnceV { FoundPlacesComputedOnceV { x: self.x.wrapping_add(o.x), y: self.y.wrapping_sub(o.y) } } }
#[data]
impl AddAssign for FoundPlacesComputedOnceV { fn add_assign(&mut self, o: FoundPlacesComputedOnceV) { self.x = self.x.wrapping_mul(2).wrapping_add(o.y); self.y = self.y.wrapping_add(o.x); } }
#[data]
impl MulAssign<i32> for FoundPlacesComputedOnceV { fn mul_assign(&mut self, o: i32) { self.x = self.x.wrapping_mul(2).wrapping_add(o); } }
#[data]
#[derive(Clone, Copy)]
pub struct FoundPlacesComputedOnceB { pub v: [FoundPlacesComputedOnceV; 3], pub n: usize }
#[data]
impl FoundPlacesComputedOnceB { fn next(&mut self) -> usize { self.n = self.n.wrapping_add(1) % 3; self.n } }
#[function]
fn next(i: &mut usize) -> usize { *i = i.wrapping_add(1); *i % 3 }
#[function]
pub fn found_places_computed_once(x: i32, i: usize) -> (i32, i32, i32) {
    let mut v = [FoundPlacesComputedOnceV { x, y: 1 }, FoundPlacesComputedOnceV { x: 1, y: x }, FoundPlacesComputedOnceV { x: 2, y: 3 }];
    let mut i = i;
    v[next(&mut i)] *= 5;
    v[next(&mut i)] *= v[i % 3].x;
    v[(i.wrapping_add(1)) % 3] += v[i % 3] + v[0];
    v[next(&mut i)] += { let k = next(&mut i); i = k; FoundPlacesComputedOnceV { x: k as i32, y: i as i32 } };
    (v[0].x ^ v[0].y, v[1].x ^ v[1].y, v[2].x ^ v[2].y)
}
#[function]
pub fn found_places_computed_once_2(x: i32, i: usize) -> (i32, i32, usize) {
    let mut b = FoundPlacesComputedOnceB { v: [FoundPlacesComputedOnceV { x, y: 2 }; 3], n: i % 3 };
    let mut k = i;
    let k2 = b.next();
    b.v[{ k = k.wrapping_add(k2); k % 3 }] *= { k = k.wrapping_add(1); (k % 7) as i32 };
    let mut grid = [[FoundPlacesComputedOnceV { x, y: 1 }; 2]; 2];
    grid[next(&mut k) % 2][next(&mut k) % 2] *= next(&mut k) as i32 % 5;
    grid[k % 2][(k / 2) % 2] += grid[1][0];
    (grid[0][0].x ^ grid[0][1].x, grid[1][0].x.wrapping_sub(grid[1][1].x) ^ b.v[1].x, k)
}
#[function]
pub fn found_places_computed_once_3(x: [i32; 4], i: usize, j: usize) -> ([i32; 4], i32) {
    let mut v = [FoundPlacesComputedOnceV { x: x[0], y: 1 }; 4];
    let mut n = 0;
    v[i.wrapping_mul(2)] *= { n += 1; x[j] };
    ([v[0].x, v[1].x, v[2].x, v[3].x], n)
}
#[function]
pub fn found_places_computed_once_4(m: [[f64; 2]; 3], i: usize, k: f64) -> ([f64; 2], f64) {
    let mut v = [Vector2::new(m[0][0], m[0][1]), Vector2::new(m[1][0], m[1][1]), Vector2::new(m[2][0], m[2][1])];
    let mut i = i;
    v[next(&mut i)] += Vector2::new(k, i as f64 % 3.0);
    v[next(&mut i)] *= k + v[i % 3].x;
    v[(i.wrapping_add(1)) % 3] -= v[i % 3];
    let mut q = [UnitQuaternion::identity(), UnitQuaternion::identity()];
    q[next(&mut i) % 2] *= UnitQuaternion::from_quaternion(Quaternion::new(1.0, 2.0, 0.5, 0.25));
    q[next(&mut i) % 2] *= q[i % 2];
    q[next(&mut i) % 2] *= q[(i + 1) % 2];
    ([v[0].x + v[1].y, v[2].x], q[0].w * 3.0 + q[1].i)
}

