//! Calls of `ahrs` over plain numbers.

use crate::*;
use nalgebra::Vector3;

pub fn madgwick(gyro: [f64; 3], acceleration: [f64; 3], field: [f64; 3]) -> [f64; 4] {
    let mut filter = Madgwick::<f64>::default();
    let (g, a) = (Vector3::new(gyro[0], gyro[1], gyro[2]), Vector3::new(acceleration[0], acceleration[1], acceleration[2]));
    let m = Vector3::new(field[0], field[1], field[2]);
    let _ = filter.update(&g, &a, &m);
    let _ = filter.update_imu(&g, &a);
    filter.update_gyro(&g);
    let q = filter.quat;
    [q.w, q.i, q.j, q.k]
}

pub fn mahony(gyro: [f64; 3], acceleration: [f64; 3], field: [f64; 3], gains: [f64; 2]) -> [f64; 4] {
    let mut filter = Mahony::<f64>::new(0.01, gains[0], gains[1]);
    let (g, a) = (Vector3::new(gyro[0], gyro[1], gyro[2]), Vector3::new(acceleration[0], acceleration[1], acceleration[2]));
    let m = Vector3::new(field[0], field[1], field[2]);
    let _ = filter.update(&g, &a, &m);
    let _ = filter.update_imu(&g, &a);
    filter.update_gyro(&g);
    let q = filter.quat;
    [q.w, q.i, q.j, q.k]
}
