//! The crate as its users see it. Figures are compared with closed forms, or with values of other programs.

mod battery;
mod drive;
mod events;
mod integrators;
mod loops;
mod packets;
mod rover;
mod scipy;
mod sensors;
mod stepper;
