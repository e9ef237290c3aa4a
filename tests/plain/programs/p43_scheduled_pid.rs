//! A PID controller whose gains depend on the operating point.

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gains {
    pub kp: f64,
    pub ki: f64,
    pub kd: f64,
}

impl Gains {
    fn lerp(self, other: Gains, t: f64) -> Gains {
        let mix = |a: f64, b: f64| a + (b - a) * t;
        Gains { kp: mix(self.kp, other.kp), ki: mix(self.ki, other.ki), kd: mix(self.kd, other.kd) }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    pub at: f64,
    pub gains: Gains,
}

/// Points in ascending order of `at`.
#[derive(Debug, Clone, PartialEq)]
pub struct Schedule<const N: usize> {
    points: [Point; N],
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ScheduleError {
    Empty,
    NotAscending { index: usize },
    NotFinite,
}

impl<const N: usize> Schedule<N> {
    pub fn new(points: [Point; N]) -> Result<Self, ScheduleError> {
        if points.is_empty() {
            return Err(ScheduleError::Empty);
        }
        if !points.iter().all(|p| p.at.is_finite()) {
            return Err(ScheduleError::NotFinite);
        }
        if let Some(index) = points.windows(2).position(|w| w[0].at >= w[1].at) {
            return Err(ScheduleError::NotAscending { index });
        }
        Ok(Self { points })
    }

    pub fn lookup(&self, at: f64) -> Gains {
        let first = &self.points[0];
        if at <= first.at {
            return first.gains;
        }
        for pair in self.points.windows(2) {
            let [low, high] = pair else { continue };
            if at <= high.at {
                let t = (at - low.at) / (high.at - low.at);
                return low.gains.lerp(high.gains, t);
            }
        }
        self.points[N - 1].gains
    }

    pub fn nearest(&self, at: f64) -> Option<&Point> {
        self.points.iter().min_by(|a, b| {
            let (da, db) = ((a.at - at).abs(), (b.at - at).abs());
            da.total_cmp(&db)
        })
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    pub min: f64,
    pub max: f64,
    pub slew: f64,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Pid<const N: usize> {
    schedule: Schedule<N>,
    limits: Limits,
    dt: f64,
    integral: f64,
    previous: Option<f64>,
    derivative: f64,
    output: f64,
}

impl<const N: usize> Pid<N> {
    pub fn new(schedule: Schedule<N>, limits: Limits, dt: f64) -> Self {
        Self { schedule, limits, dt, integral: 0.0, previous: None, derivative: 0.0, output: 0.0 }
    }

    pub fn reset(&mut self) {
        self.integral = 0.0;
        self.previous.take();
        self.derivative = 0.0;
    }

    pub fn update(&mut self, setpoint: f64, measured: f64, operating: f64) -> f64 {
        let Gains { kp, ki, kd } = self.schedule.lookup(operating);
        let error = setpoint - measured;

        let raw = match self.previous.replace(measured) {
            Some(before) => (before - measured) / self.dt,
            None => 0.0,
        };
        self.derivative += 0.2 * (raw - self.derivative);

        let unclamped = kp * error + self.integral + kd * self.derivative;
        let Limits { min, max, slew } = self.limits;
        let clamped = unclamped.max(min).min(max);
        let step = slew * self.dt;
        self.output = clamped.clamp(self.output - step, self.output + step);

        let saturated_same_way = (clamped - unclamped) * error < 0.0;
        if !saturated_same_way {
            self.integral += ki * error * self.dt;
        }
        self.output
    }
}

pub fn run(setpoint: f64, operating: f64, load: f64) -> Result<f64, ScheduleError> {
    let gains = |kp, ki, kd| Gains { kp, ki, kd };
    let schedule = Schedule::new([
        Point { at: 0.0, gains: gains(1.0, 0.5, 0.01) },
        Point { at: 50.0, gains: gains(0.8, 0.3, 0.02) },
        Point { at: 100.0, gains: gains(0.5, 0.1, 0.05) },
    ])?;
    let mut pid = Pid::new(schedule, Limits { min: -10.0, max: 10.0, slew: 100.0 }, 0.01);
    let mut plant = 0.0;
    for _ in 0..40 {
        let u = pid.update(setpoint, plant, operating);
        plant += 0.01 * (u - load * plant);
    }
    Ok(plant)
}

pub fn nearest_gain(at: f64) -> f64 {
    const TABLE: Schedule<2> = Schedule {
        points: [
            Point { at: -1.0, gains: Gains { kp: 2.0, ki: 0.0, kd: 0.0 } },
            Point { at: 1.0, gains: Gains { kp: 3.0, ki: 0.0, kd: 0.0 } },
        ],
    };
    TABLE.nearest(at).map_or(0.0, |p| p.gains.kp)
}
