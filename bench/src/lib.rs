//! Measurements: ratios within one run, medians with spread, results in `bench/results/`.
//!
//! | module | what it measures |
//! |---|---|
//! | [`check_cost`] | what the attributes add to `cargo check` of a model |
//! | [`dsp`] | blocks, filters and predictive control beside CMSIS-DSP, Eigen and TinyMPC |
//! | [`ekf`] | a Kalman filter beside the code of SymForce and CasADi |
//! | [`gradient`] | the gradient of a rollout beside CasADi's code |
//! | [`peers`] | emitted C beside other generators' code |
//! | [`generation`] | how long a generation takes, by the number of functions |
//! | [`kernels`] | generated kernels against handwritten C and the libraries |
//! | [`qp`] | quadratic programs beside the code of OSQP and CVXPYgen, and TinyMPC |
//! | [`rebuild`] | what the attributes add to a rebuild of the corpus |
//! | [`shapes`] | growth of the tool's own time with the size of a function |
//! | [`elementary`] | the elementary functions against glibc and newlib |
//! | [`moved`] | the bytes that a control period copies or clears |
//! | [`onboard`] | what a control period of the onboard software takes on the Cortex-A9 |
//! | [`accuracy_points`] | the elementary functions on the points of their accuracy, on every leg |
//! | [`threads`] | what a second thread brings to large kernels |
//! | [`crates`] | which crates of the field become C with attributes and imports alone |
//! | [`equality`] | the elementary functions on millions of points, on every leg |
//! | [`wasm`] | the emitted C beside C that is made of WebAssembly |
//!
//! [`count`] counts instructions on the emulated Cortex-A9.
//!

pub mod accuracy_points;
pub mod check_cost;
pub mod count;
pub mod crates;
pub mod dsp;
pub mod ekf;
pub mod elementary;
pub mod equality;
pub mod generation;
pub mod gradient;
pub mod kernels;
pub mod long;
pub mod moved;
pub mod onboard;
pub mod peers;
pub mod qp;
pub mod rebuild;
pub mod shapes;
pub mod threads;
pub mod wasm;
