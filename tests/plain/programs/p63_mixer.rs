//! Quadrotor mixer with prioritised saturation, and DShot frame encoding.

use nalgebra::{Matrix4x3, Vector3, Vector4};

/// Normalised demands; axes in -1..=1, throttle in 0..=1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Demand {
    pub throttle: f32,
    pub roll: f32,
    pub pitch: f32,
    pub yaw: f32,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotorOutputs {
    pub motors: Vector4<f32>,
    /// Share of the yaw demand that could be served.
    pub yaw_share: f32,
    /// The throttle had to be moved to make room for roll and pitch.
    pub throttle_shifted: bool,
}

#[derive(Debug, Clone)]
pub struct Mixer {
    axes: Matrix4x3<f32>,
    /// Slowest turning that keeps the propellers controllable.
    idle: f32,
}

impl Mixer {
    /// X frame, motors: front right, rear right, rear left, front left.
    pub fn quad_x(idle: f32) -> Self {
        #[rustfmt::skip]
        let axes = Matrix4x3::new(
            -0.5,  0.5, -0.5,
            -0.5, -0.5,  0.5,
             0.5, -0.5, -0.5,
             0.5,  0.5,  0.5,
        );
        Self { axes, idle }
    }

    /// Serves roll and pitch first, then throttle, and yaw with what is left.
    pub fn mix(&self, demand: &Demand) -> MotorOutputs {
        let attitude = self.axes * Vector3::new(demand.roll, demand.pitch, 0.0);
        let yaw = self.axes.column(2) * demand.yaw;

        let span = 1.0 - self.idle;
        let attitude = attitude * fit_factor(&attitude, span);

        let wanted = self.idle + demand.throttle.clamp(0.0, 1.0) * span;
        let throttle = wanted.clamp(self.idle - attitude.min(), 1.0 - attitude.max());
        let base = attitude.add_scalar(throttle);

        let yaw_share = base
            .iter()
            .zip(yaw.iter())
            .map(|(&b, &y)| headroom_share(b, y, self.idle))
            .fold(1.0, f32::min);

        MotorOutputs {
            motors: (base + yaw * yaw_share).map(|m| m.clamp(self.idle, 1.0)),
            yaw_share,
            throttle_shifted: throttle != wanted,
        }
    }
}

/// Factor that squeezes the spread of `v` into `span`.
fn fit_factor(v: &Vector4<f32>, span: f32) -> f32 {
    let spread = v.max() - v.min();
    if spread > span { span / spread } else { 1.0 }
}

/// Largest share of `step` that keeps `base` within `floor..=1`.
fn headroom_share(base: f32, step: f32, floor: f32) -> f32 {
    let room = if step > 0.0 { 1.0 - base } else { base - floor };
    if step.abs() > room { (room / step.abs()).max(0.0) } else { 1.0 }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DshotCommand {
    Stop,
    Beep(u8),
    Throttle(u16),
}

impl DshotCommand {
    const FIRST_THROTTLE: u16 = 48;
    const LAST_THROTTLE: u16 = 2047;

    pub fn from_output(output: f32) -> Self {
        let span = f32::from(Self::LAST_THROTTLE - Self::FIRST_THROTTLE);
        let steps = (output.clamp(0.0, 1.0) * span + 0.5) as u16;
        Self::Throttle(Self::FIRST_THROTTLE + steps)
    }

    fn value(self) -> u16 {
        match self {
            Self::Stop => 0,
            Self::Beep(tone) => u16::from(tone.clamp(1, 5)),
            Self::Throttle(t) => t.clamp(Self::FIRST_THROTTLE, Self::LAST_THROTTLE),
        }
    }

    /// Eleven value bits, the telemetry request and four checksum bits.
    pub fn frame(self, telemetry: bool) -> DshotFrame {
        let data = self.value() << 1 | u16::from(telemetry);
        let checksum = (data ^ data >> 4 ^ data >> 8) & 0xF;
        DshotFrame(data << 4 | checksum)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DshotFrame(pub u16);

impl DshotFrame {
    /// Timer compare values for the sixteen bits, first one first.
    pub fn pulses(self, bit_ticks: u16) -> impl Iterator<Item = u16> {
        let (zero, one) = (bit_ticks * 3 / 8, bit_ticks * 3 / 4);
        (0..16).rev().map(move |bit| if self.0 >> bit & 1 == 1 { one } else { zero })
    }
}
