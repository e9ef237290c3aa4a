//! Components whose calls are recorded for the coverage of a dossier.

use std::ops::{Deref, DerefMut};

use bessemer_words::record::Recorder;
use models::calibration::Measured;
use models::crash_predictor::CrashPredictor;
use models::estimator::{Ages, Estimator, Sensors};
use models::expectation::Push;
use models::gate::Gate;
use models::packet::Packet;
use models::receiver::{Orders, Receiver};
use models::reference_generator::{Course, Reference, ReferenceGenerator};
use models::siphash::Key;
use models::trajectory::Space;
use models::{Alarm, Estimate, Inputs, Limits, Onboard, Orientation, Outputs, Settings};

/// A component in its initial state, and its calls so far.
pub struct Recorded<C> {
    component: C,
    recorder: Recorder,
}

impl<C: Default> Default for Recorded<C> {
    fn default() -> Self {
        Self { component: C::default(), recorder: Recorder::of::<C>("step") }
    }
}

impl<C> Deref for Recorded<C> {
    type Target = C;
    fn deref(&self) -> &C {
        &self.component
    }
}

impl<C> DerefMut for Recorded<C> {
    fn deref_mut(&mut self) -> &mut C {
        &mut self.component
    }
}

impl Recorded<Gate> {
    #[allow(dead_code, reason = "each program has the components that it tests")]
    pub fn step(&mut self, key: &Key, packet: &Packet) -> Packet {
        self.recorder.call(|| (*key, *packet));
        self.component.step(key, packet)
    }
}

impl Recorded<Receiver> {
    #[allow(dead_code, reason = "each program has the components that it tests")]
    pub fn step(&mut self, period: f64, space: &Space, packet: &Packet) {
        self.recorder.call(|| (period, *space, *packet));
        self.component.step(period, space, packet);
    }
}

impl Recorded<ReferenceGenerator> {
    #[allow(dead_code, reason = "each program has the components that it tests")]
    pub fn step(
        &mut self,
        course: &Course,
        orders: &Orders,
        estimate: &Estimate,
        landed: bool,
        degraded: bool,
    ) -> Reference {
        self.recorder.call(|| (*course, *orders, *estimate, landed, degraded));
        self.component.step(course, orders, estimate, landed, degraded)
    }
}

impl Recorded<Estimator> {
    #[allow(dead_code, reason = "each program has the components that it tests")]
    pub fn step(&mut self, sensors: &Sensors, commanded: &Push, measured: &Measured) -> Estimate {
        self.recorder.call(|| (*sensors, *commanded, *measured));
        self.component.step(sensors, commanded, measured)
    }
}

impl Recorded<CrashPredictor> {
    #[allow(dead_code, reason = "each program has the components that it tests")]
    pub fn step(
        &mut self,
        limits: &Limits,
        flying: bool,
        estimate: &Estimate,
        orientation: &Orientation,
        ages: &Ages,
        climb: f64,
    ) -> Alarm {
        self.recorder.call(|| (*limits, flying, *estimate, *orientation, *ages, climb));
        self.component.step(limits, flying, estimate, orientation, ages, climb)
    }
}

impl Recorded<Onboard> {
    #[allow(dead_code, reason = "each program has the components that it tests")]
    pub fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        self.recorder.call(|| (*settings, *inputs));
        self.component.step(settings, inputs)
    }
}
