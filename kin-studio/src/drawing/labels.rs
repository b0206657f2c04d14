//! Labels at free positions of a picture.

use kin_core::Plane;

use super::Canvas;

/// The width of a letter, for each pixel of its height.
const LETTER: f64 = 0.62;
/// The angles at which a text may stand beside its point, in the order of preference, in eighths of a revolution.
const SIDES: [f64; 8] = [7.0, 5.0, 1.0, 3.0, 6.0, 2.0, 0.0, 4.0];

/// The space that is taken, as boxes and lines.
#[derive(Default)]
pub(super) struct Labels {
    /// Lines with the room to keep on both sides.
    lines: Vec<([Plane; 2], f64)>,
    boxes: Vec<[Plane; 2]>,
    size: Plane,
}

impl Labels {
    /// Labels within a picture of a size.
    pub(super) fn within(size: Plane) -> Self {
        Self {
            size,
            ..Self::default()
        }
    }

    /// Keeps a line free, with some room on both sides.
    pub(super) fn keep_line(&mut self, from: Plane, to: Plane) {
        self.lines.push(([from, to], 1.5));
    }

    /// Keeps a bar free.
    pub(super) fn keep_bar(&mut self, from: Plane, to: Plane) {
        self.lines.push(([from, to], 5.0));
    }

    /// Keeps a square around a point free.
    pub(super) fn keep(&mut self, centre: Plane, half: f64) {
        let half = Plane::new(half, half);
        self.boxes.push([centre - half, centre + half]);
    }

    /// Writes a text beside the freest of several points. The text is left out if there is no room.
    pub(super) fn write(&mut self, canvas: &mut Canvas, around: &[Plane], text: &str, size: f64, style: &str) {
        let mut best: Option<(f64, [Plane; 2])> = None;
        let half = Plane::new(0.5 * LETTER * size * width(text), 0.5 * size);
        for distance in [5.0, 9.0, 14.0, 20.0, 27.0] {
            for &point in around {
                for side in SIDES {
                    let outward = Plane::cis(side * std::f64::consts::FRAC_PI_4);
                    let across = Plane::new(half.x * outward.x, half.y * outward.y);
                    let centre = point + across + outward.scale(distance);
                    let text_box = [centre - half, centre + half];
                    let cost = self.cost(text_box) + distance * 0.05;
                    if best.is_none_or(|(least, _)| cost < least - 1e-9) {
                        best = Some((cost, text_box));
                    }
                }
            }
        }
        let Some((_, text_box)) = best.filter(|(cost, _)| *cost < 40.0) else {
            return;
        };
        self.boxes.push(text_box);
        let foot = Plane::new(0.5 * (text_box[0].x + text_box[1].x), text_box[1].y - 0.16 * size);
        canvas.text(foot, size, "middle", style, text);
    }

    /// The cost of a box: 100 for each overlap with the page's edge or with another text, less for lines.
    fn cost(&self, text_box: [Plane; 2]) -> f64 {
        let [low, high] = text_box;
        let outside = low.x < 3.0 || low.y < 3.0 || high.x > self.size.x - 3.0 || high.y > self.size.y - 3.0;
        let mut cost = if outside { 100.0 } else { 0.0 };
        for [other_low, other_high] in &self.boxes {
            let overlap = (high.x.min(other_high.x) - low.x.max(other_low.x))
                .min(high.y.min(other_high.y) - low.y.max(other_low.y));
            if overlap > 0.0 {
                cost += 100.0;
            }
        }
        let (middle, half) = ((low + high).scale(0.5), (high - low).scale(0.5));
        for ([from, to], room) in &self.lines {
            let length = (*to - *from).norm();
            let steps = (length / 3.0).ceil().clamp(1.0, 400.0);
            let mut step = 0.0;
            while step <= steps {
                let offset = *from + (*to - *from).scale(step / steps) - middle;
                if offset.x.abs() < half.x + room && offset.y.abs() < half.y + room {
                    cost += 6.0;
                }
                step += 1.0;
            }
        }
        cost
    }
}

/// The width of a text in letters.
fn width(text: &str) -> f64 {
    text.chars().fold(0.0, |sum, _| sum + 1.0)
}
