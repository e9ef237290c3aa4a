//! State of charge for a series pack of N cells: coulomb counting, correction
//! from the open-circuit voltage at rest, and passive balancing decisions.

/// Open-circuit voltage over state of charge, both rising.
#[derive(Debug, Clone, Copy)]
pub struct OcvTable<'a>(&'a [(f32, f32)]);

impl<'a> OcvTable<'a> {
    /// `points` holds (state of charge, volts) pairs.
    pub const fn new(points: &'a [(f32, f32)]) -> Self {
        Self(points)
    }

    pub fn soc(&self, volts: f32) -> Option<f32> {
        let (&(soc_min, v_min), &(soc_max, v_max)) = (self.0.first()?, self.0.last()?);
        if volts <= v_min {
            return Some(soc_min);
        }
        if volts >= v_max {
            return Some(soc_max);
        }
        self.segments()
            .find(|(_, (_, v1))| volts <= *v1)
            .map(|((s0, v0), (s1, v1))| s0 + (s1 - s0) * (volts - v0) / (v1 - v0))
    }

    /// Slope dSOC/dV at a voltage; large where the curve is flat.
    pub fn sensitivity(&self, volts: f32) -> Option<f32> {
        self.segments()
            .find(|((_, v0), (_, v1))| (*v0..*v1).contains(&volts))
            .map(|((s0, v0), (s1, v1))| (s1 - s0) / (v1 - v0))
    }

    fn segments(&self) -> impl Iterator<Item = ((f32, f32), (f32, f32))> + 'a {
        self.0.iter().copied().zip(self.0.iter().copied().skip(1))
    }
}

#[derive(Debug, Clone, Copy)]
pub struct Parameters<'a> {
    pub ocv: OcvTable<'a>,
    pub capacity_ah: f32,
    /// Charge acceptance while charging.
    pub coulombic_efficiency: f32,
    /// Current below which the pack counts as resting.
    pub rest_current: f32,
    /// Time at rest before voltages are trusted.
    pub rest_seconds: f32,
    /// Share of the OCV correction applied per second of rest.
    pub correction_rate: f32,
    /// Spread of state of charge at which balancing starts.
    pub balance_spread: f32,
}

/// One set of measurements; discharge current is negative.
#[derive(Debug, Clone, Copy)]
pub struct PackSample<const N: usize> {
    pub cell_volts: [f32; N],
    pub current: f32,
}

#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Cell {
    soc: f32,
}

impl Cell {
    fn count(&mut self, delta: f32) {
        self.soc = (self.soc + delta).clamp(0.0, 1.0);
    }

    fn pull_towards(&mut self, target: f32, share: f32) {
        self.soc += (target - self.soc) * share.clamp(0.0, 1.0);
    }
}

pub struct Estimator<'a, const N: usize> {
    parameters: Parameters<'a>,
    cells: [Cell; N],
    resting_for: f32,
}

impl<'a, const N: usize> Estimator<'a, N> {
    /// Seeds the estimate from the voltages at power-up.
    pub fn new(parameters: Parameters<'a>, cell_volts: &[f32; N]) -> Option<Self> {
        let mut cells = [Cell::default(); N];
        for (cell, &volts) in cells.iter_mut().zip(cell_volts) {
            cell.soc = parameters.ocv.soc(volts)?;
        }
        Some(Self { parameters, cells, resting_for: 0.0 })
    }

    pub fn update(&mut self, sample: &PackSample<N>, dt: f32) {
        let p = &self.parameters;
        let efficiency = if sample.current > 0.0 { p.coulombic_efficiency } else { 1.0 };
        let delta = sample.current * efficiency * dt / (3600.0 * p.capacity_ah);
        self.cells.iter_mut().for_each(|cell| cell.count(delta));

        if sample.current.abs() > p.rest_current {
            self.resting_for = 0.0;
            return;
        }
        self.resting_for += dt;
        if self.resting_for >= p.rest_seconds {
            self.correct(&sample.cell_volts, dt);
        }
    }

    fn correct(&mut self, cell_volts: &[f32; N], dt: f32) {
        /// On plateaus a millivolt may stand for several percent.
        const MAX_SENSITIVITY: f32 = 5.0;
        let Parameters { ocv, correction_rate, .. } = self.parameters;

        for (cell, &volts) in self.cells.iter_mut().zip(cell_volts) {
            let steep = ocv.sensitivity(volts).is_none_or(|s| s < MAX_SENSITIVITY);
            if let Some(target) = ocv.soc(volts).filter(|_| steep) {
                cell.pull_towards(target, correction_rate * dt);
            }
        }
    }

    pub fn cell_socs(&self) -> impl ExactSizeIterator<Item = f32> + '_ {
        self.cells.iter().map(|cell| cell.soc)
    }

    /// The weakest cell decides.
    pub fn pack_soc(&self) -> f32 {
        self.cell_socs().fold(1.0, f32::min)
    }

    /// Which bleed resistors to switch on.
    pub fn balancing(&self) -> [bool; N] {
        let limit = self.pack_soc() + self.parameters.balance_spread;
        self.cells.map(|cell| cell.soc > limit)
    }
}
