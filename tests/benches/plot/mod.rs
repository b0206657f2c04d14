//! Pictures of what was measured, for the book.

use std::error::Error;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

pub(crate) const GENERATED: &str = "generated";
pub(crate) const SERIES: &str = "truncated Taylor series";
pub(crate) const NESTED: &str = "nested dual numbers";

/// Colours that people who do not see all of them can tell apart (M. Okabe and K. Ito, *Color Universal Design*, 2002).
const fn colour(name: &str) -> RGBColor {
    match name.as_bytes()[0] {
        b'g' => RGBColor(0, 114, 178),
        b't' => RGBColor(0, 158, 115),
        _ => RGBColor(213, 94, 0),
    }
}

/// How the axis that goes across is divided.
#[derive(Clone, Copy)]
pub(crate) enum Scale {
    Linear,
    PowersOfTwo,
}

/// The growth of one way to the result.
pub(crate) struct Curve {
    pub(crate) name: &'static str,
    pub(crate) points: Vec<(usize, f64)>,
}

/// One half of a figure. The axis that goes up is logarithmic.
pub(crate) struct Panel {
    pub(crate) title: String,
    pub(crate) across: &'static str,
    pub(crate) up: &'static str,
    pub(crate) scale: Scale,
    pub(crate) curves: Vec<Curve>,
}

const SIZE: (u32, u32) = (1000, 430);
const FONT: &str = "sans-serif";

impl Scale {
    #[allow(clippy::cast_precision_loss, reason = "there are tens at most")]
    fn place(self, step: usize) -> f64 {
        match self {
            Self::Linear => step as f64,
            Self::PowersOfTwo => (step as f64).log2(),
        }
    }

    /// About how many labels there are.
    const fn labels(self) -> usize {
        match self {
            Self::Linear => 10,
            Self::PowersOfTwo => 5,
        }
    }

    fn label(self, place: f64) -> String {
        match self {
            Self::Linear => format!("{place:.0}"),
            Self::PowersOfTwo => format!("{:.0}", place.exp2()),
        }
    }
}

/// Draws two panels side by side into the folder of the book's figures.
pub(crate) fn figure(name: &str, panels: &[Panel; 2]) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/figures").join(name);
    let draw = || -> Result<(), Box<dyn Error>> {
        let area = SVGBackend::new(&path, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        for (half, panel) in area.split_evenly((1, 2)).iter().zip(panels) {
            panel.draw(half)?;
        }
        area.present()?;
        Ok(())
    };
    draw().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    println!("figure docs/figures/{name}");
}

impl Panel {
    fn draw(&self, area: &DrawingArea<SVGBackend<'_>, Shift>) -> Result<(), Box<dyn Error>> {
        let points = || self.curves.iter().flat_map(|curve| &curve.points);
        let places: Vec<f64> = points().map(|&(step, _)| self.scale.place(step)).collect();
        let (first, last) = bounds(&places);
        let (low, high) = bounds(&points().map(|&(_, value)| value).collect::<Vec<_>>());
        let margin = 0.03 * (last - first);
        let mut chart = ChartBuilder::on(area)
            .caption(&self.title, (FONT, 17))
            .margin(10)
            .margin_right(18)
            .x_label_area_size(44)
            .y_label_area_size(64)
            .build_cartesian_2d(
                first - margin..last + margin,
                (decade(low, f64::floor)..decade(high, f64::ceil)).log_scale(),
            )?;
        chart
            .configure_mesh()
            .x_labels(self.scale.labels())
            .x_max_light_lines(0)
            .y_max_light_lines(9)
            .x_label_formatter(&|place| self.scale.label(*place))
            .y_label_formatter(&|value| power_of_ten(*value))
            .x_desc(self.across)
            .y_desc(self.up)
            .label_style((FONT, 14))
            .axis_desc_style((FONT, 15))
            .bold_line_style(BLACK.mix(0.2))
            .light_line_style(BLACK.mix(0.06))
            .draw()?;
        for curve in &self.curves {
            let colour = colour(curve.name);
            let line: Vec<(f64, f64)> = curve
                .points
                .iter()
                .map(|&(step, value)| (self.scale.place(step), value))
                .collect();
            chart
                .draw_series(LineSeries::new(line.iter().copied(), colour.stroke_width(2)))?
                .label(curve.name)
                .legend(move |(x, y)| {
                    EmptyElement::at((x, y))
                        + PathElement::new([(0, 0), (22, 0)], colour.stroke_width(2))
                        + Circle::new((11, 0), 3, colour.filled())
                });
            chart.draw_series(PointSeries::of_element(
                line,
                3,
                colour.filled(),
                &|place, size, style| EmptyElement::at(place) + Circle::new((0, 0), size, style),
            ))?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerRight)
            .legend_area_size(28)
            .label_font((FONT, 14))
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .draw()?;
        Ok(())
    }
}

/// The least and the greatest.
fn bounds(values: &[f64]) -> (f64, f64) {
    let limits = (f64::INFINITY, f64::NEG_INFINITY);
    values
        .iter()
        .fold(limits, |(low, high), &value| (low.min(value), high.max(value)))
}

/// The power of ten below or above.
fn decade(value: f64, round: fn(f64) -> f64) -> f64 {
    10.0_f64.powf(round(value.log10()))
}

fn power_of_ten(value: f64) -> String {
    let raised = |digit: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize - '0' as usize);
    let exponent = format!("{:.0}", value.log10());
    format!("10{}", exponent.chars().filter_map(raised).collect::<String>())
}
