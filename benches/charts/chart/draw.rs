//! Pixels of a figure, through plotters' elements: it knows SVG, we know where everything stands.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axis::Scale;
use super::front::front;
use super::place::{Area, Taken, extent};
use super::{Guide, Line, Mark, Panel, Point, Series};

pub(crate) const GREY: RGBColor = RGBColor(0x59, 0x59, 0x59);
const FAINT: RGBColor = RGBColor(0xe4, 0xe4, 0xe4);
const GUIDE: RGBColor = RGBColor(0x8a, 0x8a, 0x8a);
const FRONT: RGBColor = RGBColor(0xd9, 0xe8, 0xc9);

/// Heights of text.
const TEXT: i32 = 26;
const NAME: i32 = 27;
/// What a panel leaves free around its plot: left, top, right, bottom.
const MARGIN: [i32; 4] = [130, 60, 30, 110];

/// A place to draw.
pub(crate) struct Canvas<'a>(DrawingArea<SVGBackend<'a>, Shift>);

/// A panel laid out: its plot, its scales, and where each name stands.
struct Laid {
    plot: Area,
    x: Scale,
    y: Scale,
    /// One for each [`named`] thing; `None` if there is no room.
    names: Vec<Option<[i32; 2]>>,
}

/// Something that has a name in a panel: the name, its colour, and the pixels that it may stand beside.
struct Named<'a> {
    name: &'a str,
    color: RGBColor,
    beside: Vec<[i32; 2]>,
    series: Option<&'a Series>,
}

impl Laid {
    fn pixel(&self, [x, y]: [f64; 2]) -> Option<[i32; 2]> {
        Some([self.x.at(x)?, self.y.at(y)?])
    }

    /// The ends of the bars that say how far a point may be elsewhere: across and up.
    fn bars(&self, point: &Point) -> Option<[[[i32; 2]; 2]; 2]> {
        let at = self.pixel(point.at)?;
        Some([0, 1].map(|c| {
            let scale = [&self.x, &self.y][c];
            let end = |sign: f64| {
                let mut end = at;
                let value = point.at[c] + sign * point.spread[c];
                // What reaches beyond the plot ends at its side.
                end[c] = if point.spread[c] > 0.0 { scale.nearest(value) } else { at[c] };
                end
            };
            [end(-1.0), end(1.0)]
        }))
    }

    /// The ends of a guide in the plot.
    fn guide(&self, guide: &Guide) -> Option<[[i32; 2]; 2]> {
        let Area([left, top, right, bottom]) = self.plot;
        match guide {
            Guide::Level(y, _) => self.y.at(*y).map(|y| [[left, y], [right, y]]),
            Guide::Proportional(at, _) => {
                // A decade to the right is a decade up: two points of the line say all.
                let ten = at.map(|v| 10.0 * v);
                let ([x, y], [to_x, to_y]) = (self.pixel(*at)?, self.pixel(ten)?);
                let (across, up) = (f64::from(to_x - x), f64::from(to_y - y));
                let along = |pixel: i32, from: i32, step: f64| f64::from(pixel - from) / step;
                let [mut first, mut last] = [along(left, x, across), along(right, x, across)];
                first = first.max(along(bottom, y, up));
                last = last.min(along(top, y, up));
                let at = |t: f64| [x + (across * t).round() as i32, y + (up * t).round() as i32];
                (first < last).then(|| [at(first), at(last)])
            }
        }
    }

    /// What has a name, the points first.
    fn named<'a>(&self, panel: &'a Panel) -> Vec<Named<'a>> {
        let mut named = Vec::new();
        for series in &panel.series {
            let color = series.color.rgb();
            for point in series.points.iter().filter(|point| !point.name.is_empty()) {
                let beside = self.pixel(point.at).into_iter().collect();
                named.push(Named { name: &point.name, color, beside, series: None });
            }
        }
        for series in panel.series.iter().filter(|series| !series.name.is_empty()) {
            let beside: Vec<_> =
                series.points.iter().rev().filter_map(|point| self.pixel(point.at)).collect();
            let color = series.color.rgb();
            named.push(Named { name: &series.name, color, beside, series: Some(series) });
        }
        for guide in &panel.guides {
            let (Guide::Proportional(_, name) | Guide::Level(_, name)) = guide;
            let Some([a, b]) = self.guide(guide) else { continue };
            let along = |part: i32| [0, 1].map(|c| a[c] + (b[c] - a[c]) * part / 16);
            let beside = (1..16).rev().map(along).collect();
            named.push(Named { name, color: GREY, beside, series: None });
        }
        named
    }
}

/// Lays a panel out whose names need some lines above the plot.
fn lay(panel: &Panel, [left, top]: [i32; 2], [width, height]: [i32; 2], lines: i32) -> Laid {
    let plot = [
        left + MARGIN[0],
        top + MARGIN[1] + lines * NAME * 3 / 2,
        left + width - MARGIN[2],
        top + height - MARGIN[3],
    ];
    let points = || panel.series.iter().flat_map(|series| &series.points);
    let x = Scale::new(&panel.x, points().map(|point| point.at[0]), plot[0], plot[2]);
    let levels = panel.guides.iter().filter_map(|guide| match guide {
        Guide::Level(y, _) => Some(*y),
        Guide::Proportional(..) => None,
    });
    let y = Scale::new(&panel.y, points().map(|point| point.at[1]).chain(levels), plot[3], plot[1]);
    let mut laid = Laid { plot: Area(plot), x, y, names: Vec::new() };

    let mut taken = Taken::new(laid.plot);
    for series in &panel.series {
        let pixels: Vec<_> = series.points.iter().filter_map(|point| laid.pixel(point.at)).collect();
        pixels.iter().for_each(|&at| taken.add(Area::around(at, 11)));
        for point in &series.points {
            if let Some(bars) = laid.bars(point) {
                bars.iter().for_each(|&[low, high]| taken.add_line(low, high));
            }
        }
        if series.line != Line::None {
            pixels.windows(2).for_each(|pair| taken.add_line(pair[0], pair[1]));
        }
    }
    for guide in &panel.guides {
        if let Some([a, b]) = laid.guide(guide) {
            taken.add_line(a, b);
        }
    }
    let named = laid.named(panel);
    laid.names = named.iter().map(|n| taken.beside(&n.beside, extent(n.name, NAME), 14)).collect();
    laid
}

impl<'a> Canvas<'a> {
    pub(crate) fn new(text: &'a mut String, size: [i32; 2]) -> Result<Self, String> {
        let area =
            SVGBackend::with_string(text, size.map(|side| side.unsigned_abs()).into()).into_drawing_area();
        area.fill(&WHITE).map_err(error)?;
        Ok(Self(area))
    }

    pub(crate) fn finish(&self) -> Result<(), String> {
        self.0.present().map_err(error)
    }

    /// A line of text with its top left corner there.
    pub(crate) fn text(
        &self,
        text: &str,
        at: [i32; 2],
        size: i32,
        color: RGBColor,
        bold: bool,
    ) -> Result<(), String> {
        let style = if bold { FontStyle::Bold } else { FontStyle::Normal };
        self.styled(text, at, ("sans-serif", units(size), style).into_font(), color, (HPos::Left, VPos::Top))
    }

    fn styled(
        &self,
        text: &str,
        at: [i32; 2],
        font: FontDesc<'_>,
        color: RGBColor,
        (h, v): (HPos, VPos),
    ) -> Result<(), String> {
        let style = font.color(&color).pos(Pos::new(h, v));
        self.0.draw(&Text::new(text, (at[0], at[1]), style)).map_err(error)
    }

    fn line(&self, points: &[[i32; 2]], color: RGBColor, width: u32) -> Result<(), String> {
        let points: Vec<(i32, i32)> = points.iter().map(|&[x, y]| (x, y)).collect();
        self.0.draw(&PathElement::new(points, color.stroke_width(width))).map_err(error)
    }

    /// Dashes of so many pixels, with gaps of as many.
    fn dashed(&self, points: &[[i32; 2]], color: RGBColor, width: u32, length: f64) -> Result<(), String> {
        // How far along the whole line a piece begins.
        let mut begun = 0.0;
        for pair in points.windows(2) {
            let ([ax, ay], [bx, by]) = (pair[0].map(f64::from), pair[1].map(f64::from));
            let whole = (bx - ax).hypot(by - ay);
            let at = |t: f64| {
                let part = (t / whole).clamp(0.0, 1.0);
                [(ax + (bx - ax) * part).round() as i32, (ay + (by - ay) * part).round() as i32]
            };
            let mut dash = -(begun % (2.0 * length));
            while dash < whole && whole > 0.0 {
                if dash + length > 0.0 {
                    self.line(&[at(dash), at(dash + length)], color, width)?;
                }
                dash += 2.0 * length;
            }
            begun += whole;
        }
        Ok(())
    }

    fn mark(&self, mark: Mark, [x, y]: [i32; 2], color: RGBColor) -> Result<(), String> {
        let square = |reach: i32| [(x - reach, y - reach), (x + reach, y + reach)];
        match mark {
            Mark::Disc => self.0.draw(&Circle::new((x, y), 9, color.filled())).map_err(error),
            Mark::Ring => {
                self.0.draw(&Circle::new((x, y), 9, WHITE.filled())).map_err(error)?;
                self.0.draw(&Circle::new((x, y), 8, color.stroke_width(4))).map_err(error)
            }
            Mark::Square => self.0.draw(&Rectangle::new(square(8), color.filled())).map_err(error),
            Mark::Diamond => {
                let corners = vec![(x - 12, y), (x, y - 12), (x + 12, y), (x, y + 12)];
                self.0.draw(&Polygon::new(corners, color.filled())).map_err(error)
            }
        }
    }

    /// A whole panel in the rectangle at `place`.
    pub(crate) fn panel(&self, panel: &Panel, place: [i32; 2], size: [i32; 2]) -> Result<(), String> {
        // More lines leave less room, so that more names may have to go there.
        let mut lines = 0;
        let laid = loop {
            let laid = lay(panel, place, size, lines);
            let homeless = laid.names.iter().filter(|name| name.is_none()).count() as i32;
            if homeless <= lines {
                break laid;
            }
            lines = homeless;
        };
        self.text(&panel.title, [place[0] + MARGIN[0], place[1] + 14], 28, super::Color::Black.rgb(), true)?;
        self.axes(panel, &laid)?;
        for guide in &panel.guides {
            if let Some(ends) = laid.guide(guide) {
                self.dashed(&ends, GUIDE, 2, 7.0)?;
            }
        }
        if panel.front {
            self.front(panel, &laid)?;
        }
        for series in &panel.series {
            self.series(series, &laid)?;
        }
        let mut line = place[1] + MARGIN[1] - 2;
        for (named, at) in laid.named(panel).iter().zip(&laid.names) {
            if let Some([x, y]) = at {
                self.text(named.name, [x + NAME / 8, y + NAME / 8], NAME, named.color, false)?;
            } else {
                let x = laid.plot.0[0];
                let middle = line + NAME / 2;
                match named.series {
                    Some(series) => self.mark(series.mark, [x + 12, middle], named.color)?,
                    None => self.dashed(&[[x, middle], [x + 28, middle]], GUIDE, 2, 7.0)?,
                }
                self.text(named.name, [x + 36, line], NAME, named.color, false)?;
                line += NAME * 3 / 2;
            }
        }
        Ok(())
    }

    fn axes(&self, panel: &Panel, laid: &Laid) -> Result<(), String> {
        let Area([left, top, right, bottom]) = laid.plot;
        let font = || ("sans-serif", units(TEXT)).into_font();
        for (x, name) in laid.x.ticks() {
            self.line(&[[x, top], [x, bottom]], FAINT, if name.is_some() { 3 } else { 1 })?;
            if let Some(name) = name {
                self.styled(&name, [x, bottom + 14], font(), GREY, (HPos::Center, VPos::Top))?;
            }
        }
        for (y, name) in laid.y.ticks() {
            self.line(&[[left, y], [right, y]], FAINT, if name.is_some() { 3 } else { 1 })?;
            if let Some(name) = name {
                self.styled(&name, [left - 12, y], font(), GREY, (HPos::Right, VPos::Center))?;
            }
        }
        if let Some(x) = laid.x.gap() {
            self.dashed(&[[x, top], [x, bottom]], GREY, 2, 4.0)?;
        }
        if let Some(y) = laid.y.gap() {
            self.dashed(&[[left, y], [right, y]], GREY, 2, 4.0)?;
        }
        let frame = [[left, top], [left, bottom], [right, bottom], [right, top], [left, top]];
        self.line(&frame, GREY, 2)?;
        let middle = [i32::midpoint(left, right), i32::midpoint(top, bottom)];
        let below = [middle[0], bottom + 58];
        self.styled(&panel.x.label, below, font(), super::Color::Black.rgb(), (HPos::Center, VPos::Top))?;
        let turned = font().transform(FontTransform::Rotate270);
        let beside = [left - MARGIN[0] + 14, middle[1]];
        self.styled(&panel.y.label, beside, turned, super::Color::Black.rgb(), (HPos::Center, VPos::Top))
    }

    /// A staircase below which nobody is.
    fn front(&self, panel: &Panel, laid: &Laid) -> Result<(), String> {
        let points: Vec<[f64; 2]> = panel.series.iter().flat_map(|s| &s.points).map(|p| p.at).collect();
        let shown: Vec<_> = points.into_iter().filter(|&at| laid.pixel(at).is_some()).collect();
        let mut stairs: Vec<[i32; 2]> = Vec::new();
        for at in front(&shown).into_iter().filter_map(|k| laid.pixel(shown[k])) {
            let corner = stairs.last().map(|last| [at[0], last[1]]);
            stairs.extend(corner);
            stairs.push(at);
        }
        let Area([_, top, right, _]) = laid.plot;
        if let (Some(&first), Some(&last)) = (stairs.first(), stairs.last()) {
            stairs.insert(0, [first[0], top]);
            stairs.push([right, last[1]]);
        }
        self.line(&stairs, FRONT, 14)
    }

    fn series(&self, series: &Series, laid: &Laid) -> Result<(), String> {
        let color = series.color.rgb();
        let shown: Vec<(&Point, [i32; 2])> =
            series.points.iter().filter_map(|point| Some((point, laid.pixel(point.at)?))).collect();
        let pixels: Vec<[i32; 2]> = shown.iter().map(|&(_, at)| at).collect();
        match series.line {
            Line::None => {}
            Line::Solid => self.line(&pixels, color, 4)?,
            Line::Dashed => self.dashed(&pixels, color, 4, 12.0)?,
        }
        for (point, at) in shown {
            for [low, high] in laid.bars(point).into_iter().flatten() {
                if low != high {
                    self.line(&[low, high], color, 2)?;
                }
            }
            self.mark(series.mark, at, color)?;
        }
        Ok(())
    }
}

/// plotters' measure of a font that is so many pixels high.
fn units(pixels: i32) -> f64 {
    f64::from(pixels) * 1.24
}

fn error(error: impl std::fmt::Display) -> String {
    format!("drawing: {error}")
}
