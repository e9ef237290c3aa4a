//! Flight mode state machine of a small multicopter.

use nalgebra::Vector3;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    Disarmed,
    Armed { since_ms: u32 },
    Stabilize,
    ReturnHome(ReturnPhase),
    Landing(LandReason),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReturnPhase {
    Climb,
    Cruise,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LandReason {
    Commanded,
    LowBattery,
    LinkLost,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Event {
    ArmSwitch(bool),
    SelectStabilize,
    SelectReturnHome,
    SelectLand,
    LinkLost,
    Tick,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refusal {
    ThrottleNotLow,
    NoPositionFix,
    NotPossibleNow,
}

/// What the guards look at.
#[derive(Debug, Clone, Copy)]
pub struct Vehicle {
    pub now_ms: u32,
    pub throttle: f32,
    /// Position relative to home, z up; `None` without a fix.
    pub position: Option<Vector3<f32>>,
    pub battery: f32,
    pub on_ground: bool,
}

impl Mode {
    pub fn is_flying(&self) -> bool {
        !matches!(self, Mode::Disarmed | Mode::Armed { .. })
    }

    /// The transition function; the same mode again means "stay".
    fn next(self, event: Event, vehicle: &Vehicle) -> Result<Mode, Refusal> {
        match (self, event) {
            (mode, Event::Tick) => Ok(mode.tick(vehicle)),
            (Mode::Disarmed, Event::ArmSwitch(true)) if vehicle.throttle > 0.05 => {
                Err(Refusal::ThrottleNotLow)
            }
            (Mode::Disarmed, Event::ArmSwitch(true)) => {
                Ok(Mode::Armed { since_ms: vehicle.now_ms })
            }
            (mode, Event::ArmSwitch(true)) => Ok(mode),
            (_, Event::ArmSwitch(false)) if vehicle.on_ground => Ok(Mode::Disarmed),

            // On the ground losing the link is no reason to go anywhere.
            (mode, Event::LinkLost) if !mode.is_flying() => Ok(Mode::Disarmed),
            // An ongoing landing is never turned into something longer.
            (mode @ Mode::Landing(_), Event::LinkLost) => Ok(mode),
            (mode, Event::LinkLost) => Ok(mode
                .next(Event::SelectReturnHome, vehicle)
                .unwrap_or(Mode::Landing(LandReason::LinkLost))),

            (mode, Event::SelectStabilize) if mode.is_flying() => Ok(Mode::Stabilize),
            (mode, Event::SelectLand) if mode.is_flying() => {
                Ok(Mode::Landing(LandReason::Commanded))
            }
            (mode, Event::SelectReturnHome) if mode.is_flying() => vehicle
                .position
                .map(|_| Mode::ReturnHome(ReturnPhase::Climb))
                .ok_or(Refusal::NoPositionFix),
            _ => Err(Refusal::NotPossibleNow),
        }
    }

    fn tick(self, vehicle: &Vehicle) -> Mode {
        const ARMED_TIMEOUT_MS: u32 = 10_000;
        const RETURN_ALTITUDE: f32 = 30.0;
        const HOME_RADIUS: f32 = 2.0;
        const CRITICAL_BATTERY: f32 = 0.12;

        match self {
            Mode::Armed { .. } if vehicle.throttle > 0.1 => Mode::Stabilize,
            Mode::Armed { since_ms } => {
                let expired = vehicle.now_ms.wrapping_sub(since_ms) > ARMED_TIMEOUT_MS;
                if expired { Mode::Disarmed } else { self }
            }
            Mode::Landing(_) if vehicle.on_ground => Mode::Disarmed,
            Mode::Disarmed | Mode::Landing(_) => self,
            _ if vehicle.battery < CRITICAL_BATTERY => Mode::Landing(LandReason::LowBattery),
            Mode::Stabilize => self,
            Mode::ReturnHome(phase) => match (phase, vehicle.position) {
                (_, None) => Mode::Stabilize,
                (ReturnPhase::Climb, Some(p)) if p.z > RETURN_ALTITUDE => {
                    Mode::ReturnHome(ReturnPhase::Cruise)
                }
                (ReturnPhase::Cruise, Some(p)) if p.xy().norm() < HOME_RADIUS => {
                    Mode::Landing(LandReason::Commanded)
                }
                _ => self,
            },
        }
    }
}

/// Holds the current mode and reports changes to an observer.
pub struct ModeMachine<F> {
    mode: Mode,
    on_change: F,
}

impl<F: FnMut(Mode, Mode)> ModeMachine<F> {
    pub fn new(on_change: F) -> Self {
        Self { mode: Mode::Disarmed, on_change }
    }

    pub fn handle(&mut self, event: Event, vehicle: &Vehicle) -> Result<Mode, Refusal> {
        let next = self.mode.next(event, vehicle)?;
        if next != self.mode {
            let previous = core::mem::replace(&mut self.mode, next);
            (self.on_change)(previous, next);
        }
        Ok(next)
    }
}
