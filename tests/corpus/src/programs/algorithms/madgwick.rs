//! Madgwick's attitude filter for gyroscope and accelerometer (Madgwick 2010): a gradient step towards gravity.

use bessemer::prelude::*;

/// Attitude of the sensor relative to the earth as a quaternion: w, x, y, z.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Madgwick {
    attitude: [f32; 4],
}

impl Default for Madgwick {
    fn default() -> Self {
        Madgwick { attitude: [1.0, 0.0, 0.0, 0.0] }
    }
}

#[component]
impl Madgwick {
    /// Takes one sample: rates in rad/s, acceleration in any unit, `time` in s since the last.
    #[entry(infallible)]
    pub fn step(&mut self, rate: &Vector3<f32>, force: &Vector3<f32>, gain: f32, time: f32) -> [f32; 4] {
        let [w, x, y, z] = self.attitude;
        let mut slope = [
            0.5 * (-x * rate.x - y * rate.y - z * rate.z),
            0.5 * (w * rate.x + y * rate.z - z * rate.y),
            0.5 * (w * rate.y - x * rate.z + z * rate.x),
            0.5 * (w * rate.z + x * rate.y - y * rate.x),
        ];
        let size = force.norm();
        if size > 0.0 {
            let down = force / size;
            // How far gravity as the attitude has it is from gravity as it is felt.
            let f = [
                2.0 * (x * z - w * y) - down.x,
                2.0 * (w * x + y * z) - down.y,
                2.0 * (0.5 - x * x - y * y) - down.z,
            ];
            let gradient = [
                -2.0 * y * f[0] + 2.0 * x * f[1],
                2.0 * z * f[0] + 2.0 * w * f[1] - 4.0 * x * f[2],
                -2.0 * w * f[0] + 2.0 * z * f[1] - 4.0 * y * f[2],
                2.0 * x * f[0] + 2.0 * y * f[1],
            ];
            let steep = length(&gradient);
            if steep > 0.0 {
                for (slope, part) in slope.iter_mut().zip(&gradient) {
                    *slope -= gain * part / steep;
                }
            }
        }
        for (part, slope) in self.attitude.iter_mut().zip(&slope) {
            *part += slope * time;
        }
        let size = length(&self.attitude);
        for part in self.attitude.iter_mut() {
            *part /= size;
        }
        self.attitude
    }
}

/// The length of a quaternion.
#[function]
pub fn length(q: &[f32; 4]) -> f32 {
    let mut sum = 0.0;
    for part in q {
        sum += part * part;
    }
    sum.sqrt()
}
