//! Figures of flights: the thesis' figures, drawn from our flights.
//!
//! A figure is data: a title, panels below one another, and the signals of [`crate::channels`] in each. Curves have a
//! limited number of points; the legend is to their right.

use crate::channels::signal;
use crate::voyage::{Moment, Voyage};
use plotters::coord::Shift;
use plotters::prelude::*;

/// A curve: its name, and the signal `topic.name`, from which another may be subtracted.
#[derive(Clone, Copy)]
pub struct Curve {
    /// Name in the legend.
    pub name: &'static str,
    /// Topic and name of the signal.
    pub of: (&'static str, &'static str),
    /// Signal that is subtracted.
    pub less: Option<(&'static str, &'static str)>,
}

/// A pair of axes with curves.
pub struct Panel {
    /// Label of the vertical axis, with its unit.
    pub label: &'static str,
    /// The curves.
    pub curves: &'static [Curve],
}

/// A figure of several panels.
pub struct Figure {
    /// File name without its ending.
    pub file: &'static str,
    /// Title of the figure.
    pub title: &'static str,
    /// Panels from top to bottom.
    pub panels: &'static [Panel],
}

const fn curve(name: &'static str, topic: &'static str, of: &'static str) -> Curve {
    Curve { name, of: (topic, of), less: None }
}

const fn error(name: &'static str, of: &'static str) -> Curve {
    Curve { name, of: ("reference", of), less: Some(("truth", of)) }
}

const ALTITUDE: Panel = Panel {
    label: "altitude, m",
    curves: &[
        curve("wanted", "reference", "z"),
        curve("estimated", "estimate", "z"),
        curve("true", "truth", "z"),
    ],
};

const MOTORS: Figure = Figure {
    file: "motors",
    title: "motor commands (thesis, figs. 3–20, 3–21)",
    panels: &[
        Panel { label: "motor 3, command", curves: &[curve("motor 3", "motors", "command3")] },
        Panel { label: "motor 4, command", curves: &[curve("motor 4", "motors", "command4")] },
    ],
};

const ALTITUDE_FIGURE: Figure = Figure {
    file: "altitude",
    title: "altitude, its error, vertical velocity (thesis, figs. 3–17 to 3–19)",
    panels: &[
        ALTITUDE,
        Panel { label: "error of altitude, m", curves: &[error("wanted − true", "z")] },
        Panel {
            label: "vertical velocity, m/s",
            curves: &[curve("estimated", "estimate", "vz"), curve("true", "truth", "vz")],
        },
    ],
};

const PLANE_FIGURE: Figure = Figure {
    file: "plane",
    title: "place and yaw",
    panels: &[
        Panel {
            label: "x, m",
            curves: &[
                curve("wanted", "reference", "x"),
                curve("estimated", "estimate", "x"),
                curve("true", "truth", "x"),
            ],
        },
        Panel {
            label: "y, m",
            curves: &[
                curve("wanted", "reference", "y"),
                curve("estimated", "estimate", "y"),
                curve("true", "truth", "y"),
            ],
        },
        Panel {
            label: "yaw, rad",
            curves: &[
                curve("wanted", "reference", "yaw"),
                curve("estimated", "estimate", "yaw"),
                curve("true", "truth", "yaw"),
            ],
        },
    ],
};

const TILT_FIGURE: Figure = Figure {
    file: "tilt",
    title: "attitude and what the crash predictor made of it",
    panels: &[
        Panel {
            label: "angles, rad",
            curves: &[curve("roll", "truth", "roll"), curve("pitch", "truth", "pitch")],
        },
        Panel {
            label: "rates, rad/s",
            curves: &[curve("p", "truth", "p"), curve("q", "truth", "q")],
        },
        Panel {
            label: "speed of the motors, rad/s",
            curves: &[
                curve("motor 1", "motors", "turning1"),
                curve("motor 2", "motors", "turning2"),
                curve("motor 3", "motors", "turning3"),
                curve("motor 4", "motors", "turning4"),
            ],
        },
    ],
};

const GRAVITY_FIGURE: Figure = Figure {
    file: "gravity",
    title: "reduced gravity: who carries the weight (thesis, ch. 7)",
    panels: &[
        ALTITUDE,
        Panel { label: "gain of the feed-forward", curves: &[curve("gain", "reference", "gain")] },
        Panel {
            label: "motor 1, rad/s",
            curves: &[
                curve("closed loop", "motors", "closed_loop1"),
                curve("feed-forward", "motors", "feed_forward1"),
                curve("both", "motors", "speed1"),
            ],
        },
    ],
};

/// Figures of a flight about height.
pub const HEIGHT: &[Figure] = &[ALTITUDE_FIGURE, MOTORS, PLANE_FIGURE];
/// Figures of a flight about yaw.
pub const YAW: &[Figure] = &[PLANE_FIGURE, ALTITUDE_FIGURE, MOTORS];
/// Figures of a flight about position.
pub const PLANE: &[Figure] = &[PLANE_FIGURE, ALTITUDE_FIGURE];
/// Figures of a flight that ends in a crash.
pub const TILT: &[Figure] = &[TILT_FIGURE, ALTITUDE_FIGURE];
/// Figures of a flight under feed-forward.
pub const GRAVITY: &[Figure] = &[GRAVITY_FIGURE, ALTITUDE_FIGURE, PLANE_FIGURE];

/// Time since take-off from which errors determine their scale, s. Earlier ones are as large as the whole movement.
const SETTLED: f64 = 6.0;

/// Width of the legend, to the right of the curves, in pixels.
const LEGEND: u32 = 130;

/// Largest number of points of a curve.
const MAX_POINTS: usize = 900;

/// Blue, orange, green and purple, which colour-blind people can distinguish, too.
const COLOURS: [RGBColor; 4] =
    [RGBColor(31, 119, 180), RGBColor(230, 110, 10), RGBColor(40, 140, 60), RGBColor(130, 80, 170)];

/// Reason why a picture could not be drawn.
#[derive(Debug, thiserror::Error)]
#[error("the picture `{title}` cannot be drawn: {why}")]
pub struct Error {
    title: String,
    why: String,
}

/// Points of a line to draw, and its name.
pub struct Line {
    /// Name in the legend.
    pub name: String,
    /// Points of the line.
    pub points: Vec<(f64, f64)>,
    /// True to draw dots, not a line.
    pub dots: bool,
    /// True for an error signal, whose scale is that of a settled flight.
    pub error: bool,
}

/// A panel with the points to draw.
pub struct Axes {
    /// Label of the vertical axis.
    pub label: String,
    /// Lines of the panel.
    pub lines: Vec<Line>,
}

impl Figure {
    /// Draws the figure of a flight as SVG.
    ///
    /// # Errors
    ///
    /// The message of the drawing library.
    pub fn draw(&self, flight: &str, voyage: &Voyage) -> Result<String, Error> {
        let axes: Vec<Axes> = self.panels.iter().map(|panel| panel.axes(voyage)).collect();
        draw(&format!("{flight}: {}", self.title), "time since take-off, s", &axes)
    }
}

impl Panel {
    fn axes(&self, voyage: &Voyage) -> Axes {
        let line = |curve: &Curve| Line {
            name: curve.name.to_owned(),
            points: thinned(voyage, |moment| curve.at(moment)),
            dots: false,
            error: curve.less.is_some(),
        };
        Axes { label: self.label.to_owned(), lines: self.curves.iter().map(line).collect() }
    }
}

impl Curve {
    fn at(&self, moment: &Moment) -> f64 {
        let value = |(topic, name)| signal(topic, name).map_or(f64::NAN, |it| (it.value)(moment));
        value(self.of) - self.less.map_or(0.0, value)
    }
}

/// Returns a thinned signal: the least and the largest value of each group of moments, so that no peak is lost.
fn thinned(voyage: &Voyage, value: impl Fn(&Moment) -> f64) -> Vec<(f64, f64)> {
    let size = (2 * voyage.moments.len()).div_ceil(MAX_POINTS).max(1);
    let mut points = Vec::new();
    for group in voyage.moments.chunks(size) {
        let all: Vec<(f64, f64)> =
            group.iter().map(|moment| (moment.time, value(moment))).collect();
        let least = all.iter().min_by(|a, b| a.1.total_cmp(&b.1));
        let most = all.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        let mut pair: Vec<_> = least.into_iter().chain(most).copied().collect();
        pair.sort_by(|a, b| a.0.total_cmp(&b.0));
        pair.dedup();
        points.extend(pair.into_iter().filter(|(_, y)| y.is_finite()));
    }
    points
}

/// Draws panels below one another under a title, as SVG.
///
/// # Errors
///
/// The message of the drawing library.
pub fn draw(title: &str, across: &str, panels: &[Axes]) -> Result<String, Error> {
    let mut text = String::new();
    let height = 50 + 230 * panels.len() as u32;
    let result = {
        let root = SVGBackend::with_string(&mut text, (900, height)).into_drawing_area();
        paint(&root, title, across, panels).and_then(|()| root.present().map_err(|e| e.to_string()))
    };
    result.map_err(|why| Error { title: title.to_owned(), why })?;
    Ok(text)
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn paint(root: &Area, title: &str, across: &str, panels: &[Axes]) -> Result<(), String> {
    let text = |error: DrawingAreaErrorKind<_>| error.to_string();
    root.fill(&WHITE).map_err(text)?;
    let root = root.titled(title, ("sans-serif", 20)).map_err(text)?;
    for (index, (area, panel)) in
        root.split_evenly((panels.len(), 1)).iter().zip(panels).enumerate()
    {
        let last = index + 1 == panels.len();
        paint_panel(area, if last { across } else { "" }, panel).map_err(text)?;
    }
    Ok(())
}

type Failure<'a> = DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>;

fn paint_panel<'a>(area: &Area<'a>, across: &str, panel: &Axes) -> Result<(), Failure<'a>> {
    let points = || panel.lines.iter().flat_map(|line| &line.points);
    let (left, right) = span(points().map(|point| point.0), 0.0);
    let settled = |(x, _): &&(f64, f64)| *x > SETTLED;
    let errors = panel.lines.iter().all(|line| line.error) && points().any(|it| settled(&it));
    let scaled = points().filter(|point| !errors || settled(point));
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
        // What is drawn later is thinner, so that what lies under it is seen.
        let width = 1_u32 << (panel.lines.len() - 1 - index).min(2);
        let points = line.points.iter().map(|(x, y)| (*x, y.clamp(low, high)));
        if line.dots {
            chart.draw_series(points.map(|at| Circle::new(at, 2, colour.filled())))?;
        } else {
            chart.draw_series(LineSeries::new(points, colour.stroke_width(width)))?;
        }
        // The chart would cut off what is beside its curves.
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
