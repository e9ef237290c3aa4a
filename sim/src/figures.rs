//! Figures of flights: the thesis' figures, drawn from our flights.
//!
//! A figure is data: a title, panels below one another, and the signals of [`crate::channels`] in each. `bessemer_sim` draws it.

use crate::channels::signal;
use crate::voyage::{Moment, Voyage};
use bessemer_sim::Error;
use bessemer_sim::plot::{Axes, Line, draw, thinned};

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
        let line = |curve: &Curve| {
            let all = voyage.moments.iter().map(|moment| (moment.time, curve.at(moment)));
            let points = thinned(&all.collect::<Vec<_>>());
            Line { name: curve.name.to_owned(), points, dots: false }
        };
        let errors = self.curves.iter().all(|curve| curve.less.is_some());
        Axes {
            label: self.label.to_owned(),
            lines: self.curves.iter().map(line).collect(),
            scale_from: errors.then_some(SETTLED),
        }
    }
}

impl Curve {
    fn at(&self, moment: &Moment) -> f64 {
        let value = |(topic, name)| signal(topic, name).map_or(f64::NAN, |it| (it.value)(moment));
        value(self.of) - self.less.map_or(0.0, value)
    }
}
