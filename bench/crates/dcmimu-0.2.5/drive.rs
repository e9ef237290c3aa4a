//! Calls of `dcmimu` over plain numbers.

use crate::*;

pub fn updated(gyro: [f32; 3], acceleration: [f32; 3], dt: f32, times: u8) -> ([f32; 3], [f32; 3]) {
    let mut imu = DCMIMU::new();
    for _ in 0..times % 4 {
        imu.update((gyro[0], gyro[1], gyro[2]), (acceleration[0], acceleration[1], acceleration[2]), dt);
    }
    let all = imu.all();
    let biases = imu.gyro_biases();
    ([all.yaw, all.pitch, all.roll], [biases.x, biases.y, biases.z])
}

pub fn once(gyro: [f32; 3], acceleration: [f32; 3], dt: f32) -> [f32; 6] {
    let mut imu = DCMIMU::new();
    let (all, biases) = imu.update((gyro[0], gyro[1], gyro[2]), (acceleration[0], acceleration[1], acceleration[2]), dt);
    [all.yaw, imu.pitch(), imu.roll(), biases.x, biases.y, biases.z]
}
