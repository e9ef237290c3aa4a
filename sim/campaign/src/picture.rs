//! The histogram of a column as SVG.

use plotters::prelude::*;

/// Width and height, in pixels.
const SIZE: (u32, u32) = (620, 260);
/// Number of bars.
const BARS: usize = 40;

/// Draws the histogram of sorted finite numbers; an empty text if there are none, or if they cannot be drawn.
pub fn histogram(sorted: &[f64], title: &str) -> String {
    let (Some(least), Some(most)) = (sorted.first().copied(), sorted.last().copied()) else {
        return String::new();
    };
    let mut svg = String::new();
    draw(&mut svg, sorted, least, most, title).map_or_else(|_| String::new(), |()| svg)
}

fn draw(
    svg: &mut String,
    sorted: &[f64],
    least: f64,
    most: f64,
    title: &str,
) -> Result<(), Box<dyn std::error::Error>> {
    // All numbers may be one.
    let width = ((most - least) / BARS as f64).max(1e-9 * most.abs().max(1e-300));
    let mut counts = [0_u32; BARS];
    for number in sorted {
        let bar = ((number - least) / width) as usize;
        counts[bar.min(BARS - 1)] += 1;
    }
    let highest = f64::from(counts.iter().copied().max().unwrap_or(0)) * 1.05;
    let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    let range = least..least + width * BARS as f64;
    let mut chart = ChartBuilder::on(&root)
        .margin(8)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d(range, 0.0..highest)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc(title)
        .y_desc("runs")
        .x_label_formatter(&|it| crate::summary::short(*it))
        .y_label_formatter(&|it| crate::summary::short(*it))
        .axis_desc_style(("sans-serif", 14))
        .label_style(("sans-serif", 12))
        .draw()?;
    let blue = RGBColor(53, 104, 160);
    chart.draw_series(counts.iter().enumerate().filter(|(_, count)| **count > 0).map(
        |(bar, count)| {
            let from = least + width * bar as f64;
            Rectangle::new([(from, 0.0), (from + 0.92 * width, f64::from(*count))], blue.filled())
        },
    ))?;
    root.present()?;
    drop(chart);
    drop(root);
    Ok(())
}
