//! Pictures of recordings: panels of curves over time, as SVG.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::error::Error;
use crate::recording::{Recorded, Recording};

/// Size of a panel, pixels.
const PANEL: (u32, u32) = (900, 230);

/// Width beside a panel for the names of its curves, pixels.
const LEGEND: u32 = 160;

/// Largest number of points of a curve, about two a pixel.
const MOST_POINTS: usize = 1600;

/// Colours of the curves, in their order; after the last one the first.
const COLOURS: [RGBColor; 5] = [BLUE, RED, RGBColor(0, 130, 60), RGBColor(200, 120, 0), BLACK];

impl Recording {
    /// Draws panels below one another, each with the curves of some channels over time in s.
    ///
    /// ```no_run
    /// # fn picture(recording: &bessemer_sim::Recording) -> Result<(), Box<dyn std::error::Error>> {
    /// let picture = recording.svg(&[&["speed", "target"], &["torque"]])?;
    /// std::fs::write("run.svg", picture)?;
    /// # Ok(()) }
    /// ```
    ///
    /// # Errors
    ///
    /// No channel has one of the names, or the drawing fails.
    pub fn svg(&self, panels: &[&[&str]]) -> Result<String, Error> {
        let curves = |names: &&[&str]| names.iter().map(|name| self.channel(name)).collect();
        let panels: Vec<Vec<&Recorded>> = panels.iter().map(curves).collect::<Result<_, _>>()?;
        let mut text = String::new();
        let size = (PANEL.0, PANEL.1 * panels.len().max(1) as u32);
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        let drawn = painted(&area, &panels).map_err(|error| Error::Write(error.to_string()));
        drop(area);
        drawn.map(|()| text)
    }
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Failure<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

fn painted<'a>(area: &Area<'a>, panels: &[Vec<&Recorded>]) -> Result<(), Failure<'a>> {
    area.fill(&WHITE)?;
    for (part, curves) in area.split_evenly((panels.len().max(1), 1)).iter().zip(panels) {
        paint_panel(part, curves)?;
    }
    area.present()
}

fn paint_panel<'a>(area: &Area<'a>, curves: &[&Recorded]) -> Result<(), Failure<'a>> {
    let lines: Vec<Vec<(f64, f64)>> = curves.iter().map(|curve| points(curve)).collect();
    let times = range(lines.iter().flatten().map(|(time, _)| *time), 0.0);
    let values = range(lines.iter().flatten().map(|(_, value)| *value), 0.05);
    let unit = curves.first().map_or("", |curve| curve.unit());
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .margin_right(LEGEND)
        .x_label_area_size(36)
        .y_label_area_size(74)
        .build_cartesian_2d(times.0..times.1, values.0..values.1)?;
    chart.configure_mesh().light_line_style(WHITE).x_desc("time, s").y_desc(unit).draw()?;
    let left = area.dim_in_pixel().0 as i32 - LEGEND as i32 + 10;
    for (index, (line, curve)) in lines.into_iter().zip(curves).enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        chart.draw_series(LineSeries::new(line, &colour))?;
        let top = 16 + 18 * index as i32;
        area.draw(&PathElement::new(vec![(left, top), (left + 18, top)], colour.stroke_width(2)))?;
        area.draw(&Text::new(curve.name(), (left + 25, top - 6), ("sans-serif", 13)))?;
    }
    Ok(())
}

/// Returns the finite points of a curve; of many, the lowest and the highest of each group.
fn points(curve: &Recorded) -> Vec<(f64, f64)> {
    let all = curve.times().iter().zip(curve.values());
    let all = all.map(|(time, value)| (*time as f64 / 1e9, *value));
    let all: Vec<(f64, f64)> = all.filter(|(_, value)| value.is_finite()).collect();
    if all.len() <= MOST_POINTS {
        return all;
    }
    let ends = |group: &[(f64, f64)]| {
        let lowest = group.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1));
        let highest = group.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1));
        let mut pair: Vec<_> = lowest.into_iter().chain(highest).collect();
        pair.sort_by(|a, b| a.0.total_cmp(&b.0));
        pair
    };
    all.chunks(all.len().div_ceil(MOST_POINTS / 2)).flat_map(ends).collect()
}

/// Returns a range around some values that is never empty, extended by a fraction on both sides.
fn range(values: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let widen = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), widen);
    if low > high {
        return (0.0, 1.0);
    }
    let room = margin * (high - low) + if high > low { 0.0 } else { 1e-3 * high.abs().max(1.0) };
    (low - room, high + room)
}
