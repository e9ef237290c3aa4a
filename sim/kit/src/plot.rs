//! Pictures as SVG: panels of curves below one another, of a recording or of any points.
//!
//! Curves have a limited number of points; the legend is to their right. Nothing here knows a simulation.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::error::Error;
use crate::recording::{Recorded, Recording};

/// Width of a picture, pixels.
const WIDTH: u32 = 900;

/// Height of a panel, pixels.
const HEIGHT: u32 = 230;

/// Height of the title, pixels.
const TITLE: u32 = 50;

/// Width of the legend, to the right of the curves, pixels.
const LEGEND: u32 = 130;

/// Largest number of points of a recorded curve, about one a pixel.
const MOST_POINTS: usize = 900;

/// Blue, orange, green and purple, which colour-blind people can distinguish, too.
const COLOURS: [RGBColor; 4] =
    [RGBColor(31, 119, 180), RGBColor(230, 110, 10), RGBColor(40, 140, 60), RGBColor(130, 80, 170)];

/// Points of a curve, and its name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Line {
    /// Name in the legend.
    pub name: String,
    /// Points of the curve, from left to right.
    pub points: Vec<(f64, f64)>,
    /// True to draw dots, not a line.
    pub dots: bool,
}

/// A panel: a pair of axes with curves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axes {
    /// Label of the vertical axis, with its unit.
    pub label: String,
    /// Curves of the panel.
    pub lines: Vec<Line>,
    /// Place on the horizontal axis right of which the values determine the vertical scale, if there are some. Earlier values that
    /// are beyond it are drawn at its end.
    pub scale_from: Option<f64>,
}

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
        let axes = |names: &&[&str]| {
            let curves = names.iter().map(|name| self.channel(name));
            let curves: Vec<&Recorded> = curves.collect::<Result<_, Error>>()?;
            let label = curves.first().map_or("", |curve| curve.unit()).to_owned();
            let line = |curve: &&Recorded| Line {
                name: curve.name().to_owned(),
                points: points(curve),
                dots: false,
            };
            Ok(Axes { label, lines: curves.iter().map(line).collect(), scale_from: None })
        };
        let panels: Vec<Axes> = panels.iter().map(axes).collect::<Result<_, Error>>()?;
        draw("", "time, s", &panels)
    }
}

/// Draws panels below one another under a title, as SVG. The horizontal axis of the last one has the label `across`.
///
/// # Errors
///
/// The message of the drawing library.
pub fn draw(title: &str, across: &str, panels: &[Axes]) -> Result<String, Error> {
    let mut text = String::new();
    let head = if title.is_empty() { 0 } else { TITLE };
    let height = head + HEIGHT * panels.len().max(1) as u32;
    let area = SVGBackend::with_string(&mut text, (WIDTH, height)).into_drawing_area();
    let drawn = paint(&area, title, across, panels).and_then(|()| area.present());
    let drawn = drawn.map_err(|error| Error::Write(format!("picture `{title}`: {error}")));
    drop(area);
    drawn.map(|()| text)
}

/// Returns the finite points of a curve: of many, the least and the largest value of each group, so that no peak is lost.
pub fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let size = (2 * points.len()).div_ceil(MOST_POINTS).max(1);
    let mut thinned = Vec::new();
    for group in points.chunks(size) {
        let least = group.iter().min_by(|a, b| a.1.total_cmp(&b.1));
        let most = group.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        let mut pair: Vec<_> = least.into_iter().chain(most).copied().collect();
        pair.sort_by(|a, b| a.0.total_cmp(&b.0));
        pair.dedup();
        thinned.extend(pair.into_iter().filter(|(_, y)| y.is_finite()));
    }
    thinned
}

fn points(curve: &Recorded) -> Vec<(f64, f64)> {
    let all = curve.times().iter().zip(curve.values());
    thinned(&all.map(|(time, value)| (curve.seconds(*time), *value)).collect::<Vec<_>>())
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Failure<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

fn paint<'a>(
    root: &Area<'a>,
    title: &str,
    across: &str,
    panels: &[Axes],
) -> Result<(), Failure<'a>> {
    root.fill(&WHITE)?;
    let root = match title {
        "" => root.clone(),
        title => root.titled(title, ("sans-serif", 20))?,
    };
    for (index, (area, panel)) in
        root.split_evenly((panels.len().max(1), 1)).iter().zip(panels).enumerate()
    {
        let last = index + 1 == panels.len();
        paint_panel(area, if last { across } else { "" }, panel)?;
    }
    Ok(())
}

fn paint_panel<'a>(area: &Area<'a>, across: &str, panel: &Axes) -> Result<(), Failure<'a>> {
    let points = || panel.lines.iter().flat_map(|line| &line.points);
    let (left, right) = span(points().map(|point| point.0), 0.0);
    let counts = |(x, _): &&(f64, f64)| panel.scale_from.is_none_or(|from| *x > from);
    let any = points().any(|it| counts(&it));
    let scaled = points().filter(|point| !any || counts(point));
    let (low, high) = span(scaled.map(|point| point.1), 0.06);
    let mut chart = ChartBuilder::on(area)
        .margin_left(12)
        .margin_right(LEGEND)
        .margin_top(8)
        .x_label_area_size(36)
        .y_label_area_size(74)
        .build_cartesian_2d(left..right, low..high)?;
    chart
        .configure_mesh()
        .x_desc(across)
        .y_desc(panel.label.as_str())
        .light_line_style(WHITE)
        .bold_line_style(RGBColor(225, 225, 225))
        .label_style(("sans-serif", 13))
        .axis_desc_style(("sans-serif", 14))
        .x_label_formatter(&|x| number(*x, right - left))
        .y_label_formatter(&|y| number(*y, high - low))
        .y_labels(6)
        .draw()?;
    let right_of_curves = area.dim_in_pixel().0 as i32 - LEGEND as i32;
    for (index, line) in panel.lines.iter().enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        // A later line is thinner, so that those under it are seen.
        let width = 1_u32 << (panel.lines.len() - 1 - index).min(2);
        let points = line.points.iter().map(|(x, y)| (*x, y.clamp(low, high)));
        if line.dots {
            chart.draw_series(points.map(|at| Circle::new(at, 2, colour.filled())))?;
        } else {
            chart.draw_series(LineSeries::new(points, colour.stroke_width(width)))?;
        }
        // The chart would cut off its legend.
        let (x, y) = (right_of_curves + 10, 16 + 18 * index as i32);
        let swatch = vec![(x, y), (x + 18, y)];
        area.draw(&PathElement::new(swatch, colour.stroke_width(width.max(2))))?;
        area.draw(&Text::new(line.name.clone(), (x + 25, y - 6), ("sans-serif", 13)))?;
    }
    Ok(())
}

/// Formats a number on an axis of a given range: with enough digits to distinguish the marks, and without a minus for
/// 0.
fn number(value: f64, width: f64) -> String {
    let digits = (1.3 - width.log10()).ceil().clamp(0.0, 9.0) as usize;
    let text = format!("{value:.digits$}");
    let zero = text.trim_start_matches('-').chars().all(|it| it == '0' || it == '.');
    if zero { text.trim_start_matches('-').to_owned() } else { text }
}

/// Returns the range of some values, extended by a fraction `margin` on both sides; it is never empty.
fn span(values: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let (low, high) = values
        .filter(|value| value.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if low > high {
        return (0.0, 1.0);
    }
    let room = (high - low).max(1e-3 * high.abs()).max(1e-6) * margin.max(1e-3);
    (low - room, high + room)
}
