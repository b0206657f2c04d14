//! An SVG picture, element by element.

use std::fmt::Write as _;

use kin_core::Plane;

use super::INK;

/// A picture that grows. Its coordinates are pixels, y downwards.
#[derive(Clone, Debug, Default)]
pub struct Canvas {
    elements: String,
}

impl Canvas {
    /// Adds an element or several as they stand.
    pub fn raw(&mut self, element: &str) {
        self.elements.push_str(element);
        self.elements.push('\n');
    }

    /// A line through some points, closed if wanted; `style` holds the attributes of stroke and fill.
    pub fn path(&mut self, points: &[Plane], closed: bool, style: &str) {
        let mut data = String::new();
        for (index, point) in points.iter().enumerate() {
            let command = if index == 0 { 'M' } else { 'L' };
            // a String never refuses what is written to it
            let _ = write!(data, "{command}{} {}", number(point.x), number(point.y));
        }
        if closed {
            data.push('Z');
        }
        self.raw(&format!(r#"<path d="{data}" {style}/>"#));
    }

    /// A thin line.
    pub fn line(&mut self, from: Plane, to: Plane, colour: &str, width: f64) {
        let width = number(width);
        self.path(
            &[from, to],
            false,
            &format!(r#"fill="none" stroke="{colour}" stroke-width="{width}" stroke-linecap="round""#),
        );
    }

    /// A circle.
    pub fn circle(&mut self, centre: Plane, radius: f64, style: &str) {
        let [x, y, radius] = [centre.x, centre.y, radius].map(number);
        self.raw(&format!(r#"<circle cx="{x}" cy="{y}" r="{radius}" {style}/>"#));
    }

    /// A text; `anchor` is `start`, `middle` or `end`.
    pub fn text(&mut self, at: Plane, size: f64, anchor: &str, style: &str, text: &str) {
        let [x, y, size] = [at.x, at.y, size].map(number);
        let text = escaped(text);
        self.raw(&format!(
            r#"<text x="{x}" y="{y}" font-size="{size}" text-anchor="{anchor}" {style}>{text}</text>"#
        ));
    }

    /// An arrow head at the end of a line that comes from somewhere.
    pub fn arrow_head(&mut self, tip: Plane, from: Plane, colour: &str) {
        let back = unit(from - tip);
        let across = Plane::new(-back.y, back.x);
        let corners = [
            tip,
            tip + back.scale(7.0) + across.scale(2.8),
            tip + back.scale(7.0) - across.scale(2.8),
        ];
        self.path(&corners, true, &format!(r#"fill="{colour}" stroke="none""#));
    }

    /// Another picture, its upper left corner at a point.
    pub fn place(&mut self, other: &Self, at: Plane) {
        let [x, y] = [at.x, at.y].map(number);
        self.raw(&format!(r#"<g transform="translate({x} {y})">"#));
        self.elements.push_str(&other.elements);
        self.raw("</g>");
    }

    /// Defines a motion through keyframes at equal times, the last of which is the first again, and which begins at a
    /// part of its period.
    ///
    /// If the reader's system asks for reduced motion, parts stay where [`Canvas::follow`] puts them.
    pub fn motion(&mut self, name: &str, keyframes: &[Keyframe], seconds: f64, start: f64) {
        let mut rules = String::new();
        let steps = keyframes.len().saturating_sub(1).max(1);
        for (index, Keyframe { at, degrees }) in keyframes.iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "some hundred keyframes")]
            let percent = 100.0 * index as f64 / steps as f64;
            let [x, y] = [at.x, at.y].map(number);
            // a String never refuses what is written to it
            let _ = write!(
                rules,
                "{percent:.2}%{{transform:translate({x}px,{y}px) rotate({degrees:.2}deg)}}"
            );
        }
        let delay = -seconds * start;
        self.raw(&format!(
            "<style>@keyframes {name}{{{rules}}}\n@media (prefers-reduced-motion:no-preference)\
             {{.{name}{{animation:{name} {seconds}s linear {delay:.3}s infinite}}}}</style>"
        ));
    }

    /// Another picture, drawn about the origin, that follows a motion.
    pub fn follow(&mut self, name: &str, at_rest: Keyframe, other: &Self) {
        let [x, y] = [at_rest.at.x, at_rest.at.y].map(number);
        let degrees = at_rest.degrees;
        self.raw(&format!(
            r#"<g class="{name}" transform="translate({x} {y}) rotate({degrees:.2})">"#
        ));
        self.elements.push_str(&other.elements);
        self.raw("</g>");
    }

    /// The whole file: a white card, so that it can be read on dark pages too.
    #[must_use]
    pub fn finish(&self, width: f64, height: f64, title: &str) -> String {
        let [width, height] = [width, height].map(number);
        let title = escaped(title);
        format!(
            concat!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
                 viewBox=\"0 0 {width} {height}\" ",
                r#"font-family="DejaVu Sans, Helvetica, Arial, sans-serif" fill="{ink}" role="img">"#,
                "\n<title>{title}</title>\n",
                r##"<rect width="{width}" height="{height}" rx="6" fill="#ffffff"/>"##,
                "\n{elements}</svg>\n"
            ),
            width = width,
            height = height,
            title = title,
            ink = INK,
            elements = self.elements,
        )
    }
}

/// The position of a moving part: its origin, and its angle of rotation, clockwise on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keyframe {
    /// The origin of the part.
    pub at: Plane,
    /// The angle, which counts full revolutions.
    pub degrees: f64,
}

/// The unit vector along another; zero stays zero.
pub(super) fn unit(vector: Plane) -> Plane {
    let length = vector.norm();
    if length > 0.0 {
        vector.scale(1.0 / length)
    } else {
        vector
    }
}

/// A coordinate, to a tenth of a pixel.
fn number(value: f64) -> String {
    let text = format!("{value:.1}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [0.0, -0.04, 1.0, -2.25, 3.33].map(number),
            ["0", "0", "1", "-2.2", "3.3"]
        );
    }

    #[test]
    fn texts_are_escaped() {
        let mut canvas = Canvas::default();
        canvas.text(Plane::new(0.0, 0.0), 10.0, "start", "", "a < b & c");
        assert!(canvas.finish(1.0, 1.0, "t").contains(">a &lt; b &amp; c</text>"));
    }
}
