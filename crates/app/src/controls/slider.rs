//! A slider along an edge of the picture: a value that is dragged.
//!
//! ```text
//!   ┌───────────────────────────────┬────┐
//!   │                               │ 30°│   Right: values grow upward
//!   │                               │ ┃  │
//!   │                               │ ●  │
//!   │                               │ ┃  │
//!   ├──────┬────────────────────────┼────┤
//!   │ 180° │ ━━━━━━━━━━●━━━━━━━━━━━ │    │   the corner belongs to neither
//!   └──────┴────────────────────────┴────┘
//!            Below: values grow to the right
//! ```
//!
//! A press beside the number moves the knob under the pointer and grabs it; from then on it follows, also when the
//! pointer leaves the picture, until the button is let go.

use embedded_graphics::Drawable as _;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::{
    Circle, Primitive as _, PrimitiveStyle, PrimitiveStyleBuilder, Rectangle,
};
use polosa_scene::Color;

use crate::canvas::{Canvas, rgb};
use crate::event::{Button, Event, Handled};

/// The breadth of the strip along the edge, in units of the desktop: `-180°` fits.
const BREADTH: f64 = 36.0;

/// The part of the strip's length that the number has, where the strip lies; the number's height, where it stands.
const NUMBER: [f64; 2] = [44.0, 24.0];

/// The knob's radius.
const KNOB: f64 = 7.0;

/// The track's breadth.
const TRACK: f64 = 4.0;

/// What is left free at the track's ends, beside half a knob.
const MARGIN: f64 = 5.0;

/// The colours of track and knob, and of the line around it: on a dimmed ground they are seen over any picture.
const TRACK_COLOR: Color = Color::new(0xa0, 0xa0, 0xa0);
const KNOB_COLOR: Color = Color::WHITE;
const LINE_COLOR: Color = Color::new(0x20, 0x20, 0x20);

/// The edge that a [`Slider`] lies along.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SliderSide {
    /// The lower one; values grow to the right.
    Below,
    /// The right one; values grow upward.
    Right,
}

/// A value in degrees that is dragged.
///
/// ```
/// use polosa::controls::slider::{Slider, SliderSide};
/// use polosa::event::{Button, Event, Handled};
///
/// let mut heading = Slider::new(SliderSide::Below, [0.0, 360.0], 180.0);
/// let press = Event::Button { button: Button::Left, pressed: true, at: [1e9, 390.0] };
/// assert_eq!(heading.event(&press, [400, 400], 1.0), Handled::No, "not on the slider");
/// let press = Event::Button { button: Button::Left, pressed: true, at: [60.0, 390.0] };
/// assert_eq!(heading.event(&press, [400, 400], 1.0), Handled::Yes);
/// heading.event(&Event::Motion { at: [1e9, 0.0] }, [400, 400], 1.0);
/// assert_eq!(heading.value(), 360.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    side: SliderSide,
    range: [f64; 2],
    value: f64,
    held: bool,
}

impl Slider {
    /// A slider from `range[0]` to `range[1]` degrees, at `value`, which is brought into the range.
    ///
    /// # Panics
    ///
    /// In debug builds, when the range is not finite or does not grow. In others it then counts as [0, 1].
    #[must_use]
    pub fn new(side: SliderSide, range: [f64; 2], value: f64) -> Self {
        let sound = range[0] < range[1] && (range[1] - range[0]).is_finite();
        debug_assert!(sound, "a slider from {} to {}", range[0], range[1]);
        let range = if sound { range } else { [0.0, 1.0] };
        let mut slider = Self { side, range, value: range[0], held: false };
        slider.set_value(value);
        slider
    }

    /// What it is set to, in degrees, within the range.
    #[must_use]
    pub const fn value(&self) -> f64 {
        self.value
    }

    /// Sets it, as far as the range goes. What is not a number changes nothing.
    pub fn set_value(&mut self, value: f64) {
        if !value.is_nan() {
            self.value = value.clamp(self.range[0], self.range[1]);
        }
    }

    /// Whether it is being dragged.
    #[must_use]
    pub const fn is_held(&self) -> bool {
        self.held
    }

    /// Follows an event. `size` is that of the picture in pixels, `scale` how many pixels a unit of the desktop has.
    ///
    /// [`Handled::Yes`] means that the event was for the slider. The release of another button than the left one, and
    /// the focus going, are everybody's.
    pub fn event(&mut self, event: &Event, size: [u32; 2], scale: f64) -> Handled {
        let strip = Strip::new(self.side, size, scale);
        match *event {
            Event::Button { button: Button::Left, pressed: true, at } => {
                if !strip.is_some_and(|strip| strip.holds(at)) {
                    return Handled::No;
                }
                self.held = true;
                self.drag(strip, at);
                Handled::Yes
            }
            Event::Button { button: Button::Left, pressed: false, at } if self.held => {
                self.drag(strip, at);
                self.held = false;
                Handled::Yes
            }
            Event::Motion { at } if self.held => {
                self.drag(strip, at);
                Handled::Yes
            }
            // What is pressed during the drag must not begin another one behind the slider.
            Event::Button { pressed: true, .. } | Event::DoubleClick { .. } if self.held => Handled::Yes,
            Event::Focus(false) => {
                self.held = false;
                Handled::No
            }
            _ => Handled::No,
        }
    }

    fn drag(&mut self, strip: Option<Strip>, at: [f64; 2]) {
        if let Some(strip) = strip {
            let share = strip.share(at);
            // Exactly the range's ends at both ends; no change for what is not a number.
            self.set_value(self.range[0] * (1.0 - share) + self.range[1] * share);
        }
    }

    /// Draws track, knob and number. Where there is no room for a track, nothing.
    pub fn draw(&self, canvas: &mut Canvas<'_>) {
        let Some(strip) = Strip::new(self.side, canvas.dimensions(), canvas.scale()) else { return };
        let pixel = |[x, y]: [f64; 2]| Point::new(x as i32, y as i32);
        let [low, high] = [strip.low, strip.high].map(pixel);
        canvas.dim([low.x, low.y], [high.x - low.x, high.y - low.y]);

        let half = canvas.pixels_of(TRACK) / 2;
        let [from, to] = strip.track.map(|along| pixel(strip.place(along)));
        let [left, top] = [from.x.min(to.x) - half, from.y.min(to.y) - half];
        let track =
            Size::new(from.x.abs_diff(to.x) + 2 * half as u32, from.y.abs_diff(to.y) + 2 * half as u32);
        let track = Rectangle::new(Point::new(left, top), track);
        let Ok(()) = track.into_styled(PrimitiveStyle::with_fill(rgb(TRACK_COLOR))).draw(canvas);

        let share = (self.value - self.range[0]) / (self.range[1] - self.range[0]);
        let middle = pixel(strip.place(strip.track[0] * (1.0 - share) + strip.track[1] * share));
        let style = PrimitiveStyleBuilder::new()
            .fill_color(rgb(KNOB_COLOR))
            .stroke_color(rgb(LINE_COLOR))
            .stroke_width(canvas.pixels_of(2.0) as u32)
            .build();
        let knob = Circle::with_center(middle, canvas.pixels_of(2.0 * KNOB) as u32);
        let Ok(()) = knob.into_styled(style).draw(canvas);

        // Adding 0 makes −0 a 0.
        let text = format!("{:.0}°", self.value.round() + 0.0);
        let [width, height] = canvas.text_size(&text);
        let [x, y] = match self.side {
            SliderSide::Below => {
                [low.x + (canvas.pixels_of(NUMBER[0]) - width) / 2, (low.y + high.y - height) / 2]
            }
            SliderSide::Right => {
                [(low.x + high.x - width) / 2, low.y + (canvas.pixels_of(NUMBER[1]) - height) / 2]
            }
        };
        canvas.text([x, y], &text, Color::WHITE);
    }
}

/// Where a slider is in a picture; all in pixels.
#[derive(Clone, Copy, Debug)]
struct Strip {
    side: SliderSide,
    low: [f64; 2],
    high: [f64; 2],
    /// Where along the edge the least and the greatest value are.
    track: [f64; 2],
    /// Half a knob.
    knob: f64,
}

impl Strip {
    /// `None` where there is no room for a track.
    fn new(side: SliderSide, size: [u32; 2], scale: f64) -> Option<Self> {
        let [width, height] = size.map(f64::from);
        let (breadth, end) = ((BREADTH * scale).floor(), (KNOB + MARGIN) * scale);
        let (low, high, track) = match side {
            SliderSide::Below => (
                [0.0, height - breadth],
                [width - breadth, height],
                [NUMBER[0] * scale + end, width - breadth - end],
            ),
            SliderSide::Right => (
                [width - breadth, 0.0],
                [width, height - breadth],
                [height - breadth - end, NUMBER[1] * scale + end],
            ),
        };
        let grows = (track[1] - track[0]) * if side == SliderSide::Below { 1.0 } else { -1.0 };
        let room = grows >= 1.0 && low[0] >= 0.0 && low[1] >= 0.0;
        room.then_some(Self { side, low, high, track, knob: KNOB * scale })
    }

    /// Which of a place's coordinates runs along the edge.
    const fn axis(&self) -> usize {
        match self.side {
            SliderSide::Below => 0,
            SliderSide::Right => 1,
        }
    }

    /// The middle of the strip, so far along the edge.
    fn place(&self, along: f64) -> [f64; 2] {
        match self.side {
            SliderSide::Below => [along, (self.low[1] + self.high[1]) / 2.0],
            SliderSide::Right => [(self.low[0] + self.high[0]) / 2.0, along],
        }
    }

    /// Whether a place is on the track, or where a knob can be.
    fn holds(&self, at: [f64; 2]) -> bool {
        let inside = (0..2).all(|k| self.low[k] <= at[k] && at[k] < self.high[k]);
        let [a, b] = self.track;
        let along = at[self.axis()];
        inside && a.min(b) - self.knob <= along && along <= a.max(b) + self.knob
    }

    /// How far along the track a place is, from 0 to 1.
    fn share(&self, at: [f64; 2]) -> f64 {
        let [from, to] = self.track;
        ((at[self.axis()] - from) / (to - from)).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::{Slider, SliderSide, Strip};
    use crate::canvas::Canvas;
    use crate::event::{Button, Event, Handled};

    const SIZE: [u32; 2] = [400, 300];

    fn button(button: Button, pressed: bool, at: [f64; 2]) -> Event {
        Event::Button { button, pressed, at }
    }

    fn press(at: [f64; 2]) -> Event {
        button(Button::Left, true, at)
    }

    fn heading() -> Slider {
        Slider::new(SliderSide::Below, [0.0, 360.0], 180.0)
    }

    fn pitch() -> Slider {
        Slider::new(SliderSide::Right, [-90.0, 90.0], 0.0)
    }

    #[test]
    fn a_press_jumps_and_grabs_and_the_knob_follows_until_it_is_let_go() {
        let mut slider = heading();
        let [from, to] = Strip::new(SliderSide::Below, SIZE, 1.0).unwrap().track;
        let at = |share: f64| [from + (to - from) * share, 290.0];
        assert_eq!(slider.event(&press(at(0.25)), SIZE, 1.0), Handled::Yes);
        assert!(slider.is_held() && (slider.value() - 90.0).abs() < 1e-9);
        for (place, value) in [([from - 1e9, -50.0], 0.0), ([to + 900.0, 900.0], 360.0), (at(0.5), 180.0)] {
            assert_eq!(slider.event(&Event::Motion { at: place }, SIZE, 1.0), Handled::Yes);
            assert!((slider.value() - value).abs() < 1e-9, "{} instead of {value}", slider.value());
        }
        assert_eq!(slider.event(&button(Button::Left, false, at(0.75)), SIZE, 1.0), Handled::Yes);
        assert!(!slider.is_held() && (slider.value() - 270.0).abs() < 1e-9);
        assert_eq!(slider.event(&Event::Motion { at: at(0.1) }, SIZE, 1.0), Handled::No);
        assert!((slider.value() - 270.0).abs() < 1e-9);
    }

    #[test]
    fn values_at_the_side_grow_upward_and_reach_both_ends_exactly() {
        let mut slider = pitch();
        let [low, high] = Strip::new(SliderSide::Right, SIZE, 1.0).unwrap().track;
        assert!(high < low);
        slider.event(&press([390.0, low]), SIZE, 1.0);
        assert_eq!(slider.value(), -90.0);
        slider.event(&Event::Motion { at: [0.0, high] }, SIZE, 1.0);
        assert_eq!(slider.value(), 90.0);
        slider.event(&Event::Motion { at: [0.0, (low + high) / 2.0] }, SIZE, 1.0);
        assert_eq!(slider.value(), 0.0);
    }

    #[test]
    fn no_place_belongs_to_both_and_most_of_the_picture_to_neither() {
        for scale in [1.0, 1.3, 2.0] {
            let [below, right] = [SliderSide::Below, SliderSide::Right]
                .map(|side| Strip::new(side, [800, 600], scale).unwrap());
            for y in 0..600 {
                for x in 0..800 {
                    let at = [f64::from(x) + 0.5, f64::from(y) + 0.5];
                    let (one, other) = (below.holds(at), right.holds(at));
                    assert!(!(one && other), "{at:?}");
                    let edge = 40.0 * scale;
                    assert!(!(one || other) || at[0] > 800.0 - edge || at[1] > 600.0 - edge);
                }
            }
        }
    }

    #[test]
    fn what_is_pressed_during_a_drag_begins_nothing_and_all_releases_are_passed_on() {
        let mut slider = heading();
        let at = [100.0, 290.0];
        assert_eq!(slider.event(&button(Button::Right, true, at), SIZE, 1.0), Handled::No);
        slider.event(&press(at), SIZE, 1.0);
        assert_eq!(slider.event(&button(Button::Right, false, at), SIZE, 1.0), Handled::No);
        assert_eq!(slider.event(&button(Button::Middle, true, at), SIZE, 1.0), Handled::Yes);
        assert_eq!(slider.event(&Event::DoubleClick { at }, SIZE, 1.0), Handled::Yes);
        assert_eq!(slider.event(&Event::Focus(false), SIZE, 1.0), Handled::No);
        assert!(!slider.is_held());
    }

    #[test]
    fn values_are_clamped_and_what_is_no_number_changes_nothing() {
        let mut slider = heading();
        for (given, value) in
            [(-5.0, 0.0), (1e300, 360.0), (f64::NAN, 360.0), (f64::NEG_INFINITY, 0.0), (7.0, 7.0)]
        {
            slider.set_value(given);
            assert_eq!(slider.value(), value);
        }
        slider.event(&press([100.0, 290.0]), SIZE, 1.0);
        let value = slider.value();
        slider.event(&Event::Motion { at: [f64::NAN; 2] }, SIZE, 1.0);
        assert_eq!(slider.value(), value);
    }

    #[test]
    fn a_picture_without_room_has_no_slider_and_a_resize_during_a_drag_only_moves_it() {
        for size in [[0, 0], [1, 1], [400, 20], [60, 40]] {
            let mut slider = heading();
            assert_eq!(slider.event(&press([0.5, 0.5]), size, 1.0), Handled::No);
            let mut pixels = vec![7; (size[0] * size[1]) as usize];
            slider.draw(&mut Canvas::new(&mut pixels, size, 1.0));
            assert!(pixels.iter().all(|pixel| *pixel == 7), "{size:?}");
        }
        let mut slider = heading();
        slider.event(&press([100.0, 290.0]), SIZE, 1.0);
        slider.event(&Event::Motion { at: [9.0, 9.0] }, [1, 1], 1.0);
        assert!(slider.is_held());
        let [from, to] = Strip::new(SliderSide::Below, [800, 600], 2.0).unwrap().track;
        slider.event(&Event::Motion { at: [(from + to) / 2.0, 0.0] }, [800, 600], 2.0);
        assert!((slider.value() - 180.0).abs() < 1e-9);
    }

    #[test]
    fn knob_track_and_number_are_seen_on_black_and_on_white() {
        for ground in [0, 0xff_ffff] {
            for scale in [1.0, 2.0] {
                for slider in [heading(), pitch()] {
                    let size = [800, 600];
                    let mut pixels = vec![ground; 800 * 600];
                    slider.draw(&mut Canvas::new(&mut pixels, size, scale));
                    let strip = Strip::new(slider.side, size, scale).unwrap();
                    let pixel = |[x, y]: [f64; 2]| pixels[y as usize * 800 + x as usize];
                    assert_eq!(
                        pixel(strip.place((strip.track[0] + strip.track[1]) / 2.0)),
                        0xff_ffff,
                        "knob"
                    );
                    let quarter = strip.track[0] * 0.75 + strip.track[1] * 0.25;
                    assert_eq!(pixel(strip.place(quarter)), 0xa0_a0a0, "track");
                    let beside = pixel([strip.low[0] + 1.0, strip.low[1] + 1.0]);
                    assert!(beside <= 0x3f_3f3f, "the ground is dimmed");
                    let number = match slider.side {
                        SliderSide::Below => [strip.low, [strip.track[0] - strip.knob - 2.0, strip.high[1]]],
                        SliderSide::Right => [strip.low, [strip.high[0], strip.track[1] - strip.knob - 2.0]],
                    };
                    let [low, high] = number.map(|place| place.map(|x| x as usize));
                    let white = (low[1]..high[1])
                        .flat_map(|y| (low[0]..high[0]).map(move |x| y * 800 + x))
                        .filter(|k| pixels[*k] == 0xff_ffff)
                        .count();
                    assert!(white > 10, "a number");
                }
            }
        }
    }
}
