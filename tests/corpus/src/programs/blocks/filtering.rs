//! Recursive filters: a current that is smoothed and freed from a disturbance whose frequency follows a speed, and a force in double
//! precision.

use bessemer::prelude::*;
pub use bessemer_blocks::{Cascade, CascadeDirect, FirstOrder, FirstOrderFilter, Section};

/// Filters a current: a low-pass of fourth order, then a notch.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurrentFilter {
    smooth: Cascade<f32, 2>,
    notch: CascadeDirect<f32, 1>,
    lead: FirstOrderFilter<f32>,
}

#[component]
impl CurrentFilter {
    /// Filters one sample at 10 kHz.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        sections: &[Section<f32>; 2],
        #[unit("A")] current: f32,
        #[unit("Hz")] disturbance: f32,
    ) -> f32 {
        let smooth = self.smooth.step(sections, current);
        let notch = [Section::notch(disturbance.max(1.0).min(4000.0), 5.0, 10_000.0)];
        let free = self.notch.step(&notch, smooth);
        self.lead.step(&FirstOrder::lead_lag(2e-3, 5e-4, 1e-4), free)
    }

    /// Filters a block of samples by the low-pass alone.
    #[entry(infallible, single)]
    pub fn block(&mut self, sections: &[Section<f32>; 2], samples: &mut [f32; 8]) {
        self.smooth.block(sections, samples);
    }
}

/// Filters a force.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForceFilter {
    sections: Cascade<f64, 3>,
    slow: FirstOrderFilter<f64>,
    started: bool,
}

#[component]
impl ForceFilter {
    /// Filters one sample at 1 kHz.
    #[entry(infallible)]
    pub fn step(&mut self, #[unit("N")] force: f64, #[unit("Hz")] cutoff: f64) -> f64 {
        let sections = [
            Section::low_pass(cutoff, 0.7, 1000.0),
            Section::high_pass(0.1, 0.7, 1000.0),
            Section::band_pass(cutoff, 0.5, 1000.0),
        ];
        let low_pass = FirstOrder::low_pass(0.2, 1e-3);
        if !self.started {
            self.started = true;
            self.slow.preset(&low_pass, force, force);
        }
        self.sections.step(&sections, force) + self.slow.step(&low_pass, force)
            - FirstOrder::high_pass(0.1, 1e-3).b0
    }
}
