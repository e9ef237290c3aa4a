//! Space-vector PWM: stator voltage vector in, three timer compare values out,
//! with the sector method and hexagon over-modulation limiting.

/// One of the six 60° sectors, named after its two active vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Sector {
    V1V2 = 1,
    V2V3,
    V3V4,
    V4V5,
    V5V6,
    V6V1,
}

/// Result of one period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modulation {
    pub sector: Sector,
    pub compare: [u16; 3],
    /// True when the wanted vector was outside the hexagon and has been scaled.
    pub limited: bool,
}

#[derive(Clone, Debug)]
pub struct SvPwm {
    period: u16,
    min_pulse: u16,
    limited_count: u32,
}

impl SvPwm {
    const SQRT3: f32 = 1.732_050_8;

    pub const fn new(period: u16, min_pulse: u16) -> Self {
        Self { period, min_pulse, limited_count: 0 }
    }

    /// Finds the sector from the signs of the three projected voltages.
    pub fn sector_of(alpha: f32, beta: f32) -> Sector {
        let slope = Self::SQRT3 * alpha;
        match (beta >= 0.0, beta < slope, beta < -slope) {
            (true, true, _) => Sector::V1V2,
            (true, false, false) => Sector::V2V3,
            (true, false, true) => Sector::V3V4,
            (false, false, _) => Sector::V4V5,
            (false, true, true) => Sector::V5V6,
            (false, true, false) => Sector::V6V1,
        }
    }

    /// Computes compare values for `alpha`/`beta` volts on a bus of `v_bus`.
    pub fn step(&mut self, alpha: f32, beta: f32, v_bus: f32) -> Modulation {
        let half = self.period / 2;
        let idle = Modulation { sector: Sector::V1V2, compare: [half; 3], limited: false };
        if v_bus <= 1.0 || !(alpha.is_finite() && beta.is_finite()) {
            return idle;
        }

        let sector = Self::sector_of(alpha, beta);
        // Times of the two active vectors as shares of the period.
        let x = Self::SQRT3 * beta / v_bus;
        let y = (1.5 * alpha + 0.5 * Self::SQRT3 * beta) / v_bus;
        let z = (-1.5 * alpha + 0.5 * Self::SQRT3 * beta) / v_bus;
        let (t1, t2) = match sector {
            Sector::V1V2 => (-z, x),
            Sector::V2V3 => (y, z),
            Sector::V3V4 => (x, -y),
            Sector::V4V5 => (z, -x),
            Sector::V5V6 => (-y, -z),
            Sector::V6V1 => (-x, y),
        };

        let sum = t1 + t2;
        let limited = sum > 1.0;
        let (t1, t2) = if limited { (t1 / sum, t2 / sum) } else { (t1, t2) };
        if limited {
            self.limited_count = self.limited_count.wrapping_add(1);
        }

        let low = 0.5 * (1.0 - t1 - t2);
        let (mid1, mid2) = (low + t1, low + t2);
        let high = low + t1 + t2;
        let duty = match sector {
            Sector::V1V2 => [high, mid2, low],
            Sector::V2V3 => [mid1, high, low],
            Sector::V3V4 => [low, high, mid2],
            Sector::V4V5 => [low, mid1, high],
            Sector::V5V6 => [mid2, low, high],
            Sector::V6V1 => [high, low, mid1],
        };
        Modulation { sector, compare: duty.map(|d| self.to_compare(d)), limited }
    }

    fn to_compare(&self, duty: f32) -> u16 {
        let ticks = (duty.clamp(0.0, 1.0) * f32::from(self.period) + 0.5) as u16;
        match ticks {
            t if t < self.min_pulse => 0,
            t if t > self.period - self.min_pulse => self.period,
            t => t,
        }
    }

    pub fn limited_count(&self) -> u32 {
        self.limited_count
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f32::consts::TAU;

    #[test]
    fn line_voltages_are_right_all_round() {
        let mut pwm = SvPwm::new(10_000, 0);
        for deg in (0..360).step_by(5) {
            let (s, c) = (deg as f32 / 360.0 * TAU).sin_cos();
            let (alpha, beta) = (10.0 * c, 10.0 * s);
            let m = pwm.step(alpha, beta, 24.0);
            let [a, b, c] = m.compare.map(|t| f32::from(t) * 24.0 / 10_000.0);
            let va = alpha;
            let vb = -0.5 * alpha + 0.866_025_4 * beta;
            let vc = -0.5 * alpha - 0.866_025_4 * beta;
            assert!((a - b - (va - vb)).abs() < 0.02, "{deg}: {m:?}");
            assert!((b - c - (vb - vc)).abs() < 0.02, "{deg}: {m:?}");
        }
        assert_eq!(pwm.limited_count(), 0);
    }

    #[test]
    fn overmodulation_stays_in_range() {
        let mut pwm = SvPwm::new(1000, 20);
        let m = pwm.step(100.0, 30.0, 24.0);
        assert!(m.limited && m.compare.iter().all(|&c| c <= 1000));
        assert_eq!(pwm.step(0.0, 0.0, 0.0).compare, [500; 3]);
    }

    #[test]
    fn sectors_go_round() {
        let names = [30, 90, 150, 210, 270, 330].map(|deg: u16| {
            let (s, c) = (f32::from(deg) / 360.0 * TAU).sin_cos();
            SvPwm::sector_of(c, s) as u8
        });
        assert_eq!(names, [1, 2, 3, 4, 5, 6]);
    }
}
