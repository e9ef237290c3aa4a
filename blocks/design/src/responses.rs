//! Responses of discrete systems, and their plots.

use std::error::Error;
use std::f64::consts::TAU;

use bessemer_blocks::Section;
use nalgebra::Complex;
use plotters::prelude::*;

use crate::models::StateSpace;

/// A discrete system with one input and one output.
pub trait Discrete {
    /// Returns the outputs for a unit step from rest.
    fn step_response(&self, count: usize) -> Vec<f64>;

    /// Returns the complex gain at a frequency, in cycles per sample: frequency divided by the sample rate.
    fn gain(&self, cycles: f64) -> Complex<f64>;
}

impl<const N: usize> Discrete for StateSpace<N> {
    fn step_response(&self, count: usize) -> Vec<f64> {
        let mut state = nalgebra::SVector::<f64, N>::zeros();
        let mut outputs = Vec::with_capacity(count);
        for _ in 0..count {
            outputs.push((self.c * state)[(0, 0)] + self.d);
            state = self.a * state + self.b;
        }
        outputs
    }

    fn gain(&self, cycles: f64) -> Complex<f64> {
        let z = turned(cycles);
        let one = nalgebra::SMatrix::<Complex<f64>, N, N>::identity();
        let matrix = one * z - self.a.map(|it| Complex::new(it, 0.0));
        let b = self.b.map(|it| Complex::new(it, 0.0));
        let c = self.c.map(|it| Complex::new(it, 0.0));
        let inside = matrix.try_inverse().map(|inverse| (c * inverse * b)[(0, 0)]);
        inside.map_or(Complex::new(f64::INFINITY, 0.0), |it| it + self.d)
    }
}

impl Discrete for [Section<f64>] {
    fn step_response(&self, count: usize) -> Vec<f64> {
        let mut states = vec![[0.0; 2]; self.len()];
        let step = |_| {
            let mut value = 1.0;
            for (state, section) in states.iter_mut().zip(self) {
                let output = section.b0 * value + state[0];
                state[0] = section.b1 * value - section.a1 * output + state[1];
                state[1] = section.b2 * value - section.a2 * output;
                value = output;
            }
            value
        };
        (0..count).map(step).collect()
    }

    fn gain(&self, cycles: f64) -> Complex<f64> {
        let back = turned(-cycles);
        let of = |it: &Section<f64>| {
            let above = back * (back * it.b2 + it.b1) + it.b0;
            above / (back * (back * it.a2 + it.a1) + 1.0)
        };
        self.iter().map(of).product()
    }
}

/// Returns the point of the unit circle after some cycles.
fn turned(cycles: f64) -> Complex<f64> {
    let (sine, cosine) = (TAU * cycles).sin_cos();
    Complex::new(cosine, sine)
}

/// Plots the step response over `duration` s, and the gain in dB up to half of the sample rate, as one SVG.
///
/// # Errors
/// An error of the plotter if a response of the system is not finite.
pub fn plot(
    system: &(impl Discrete + ?Sized),
    period: f64,
    duration: f64,
) -> Result<String, Box<dyn Error>> {
    let count = (duration / period).ceil().max(2.0) as usize;
    let steps = system.step_response(count).into_iter().enumerate();
    let steps: Vec<(f64, f64)> = steps.map(|(k, value)| (k as f64 * period, value)).collect();
    let gains: Vec<(f64, f64)> = (1..=400)
        .map(|k| {
            let cycles = 0.5 * f64::from(k) / 400.0;
            (cycles / period, 20.0 * system.gain(cycles).norm_sqr().sqrt().max(1e-10).log10())
        })
        .collect();
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, (640, 480)).into_drawing_area();
        area.fill(&WHITE)?;
        let parts = area.split_evenly((2, 1));
        for (part, curve) in parts.iter().zip([steps, gains]) {
            let (low, high) =
                curve.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (_, y)| {
                    (low.min(*y), high.max(*y))
                });
            let margin = 0.05 * (high - low).max(1e-9);
            let last = curve.last().map_or(1.0, |(x, _)| *x);
            let mut chart = ChartBuilder::on(part)
                .margin(10)
                .build_cartesian_2d(0.0..last, low - margin..high + margin)?;
            chart.draw_series(LineSeries::new(curve, &BLUE))?;
        }
        area.present()?;
    }
    Ok(text)
}
