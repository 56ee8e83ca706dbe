//! Flat drawings: convex polygons, thick lines, dots; sixteen samples a pixel, averaged in linear light.

use std::error::Error;

use polosa_examples::picture;
use polosa_raster::{Clip, Depth, DepthTest, Flat, Space, State, Target};
use polosa_scene::{Color, Picture, srgb};

pub(crate) const PAPER: u32 = 0xfa_f8f4;
pub(crate) const INK: u32 = 0x2b_3038;
pub(crate) const FAINT: u32 = 0xd5_d0c6;
pub(crate) const GREY: u32 = 0x9a_968e;
pub(crate) const BLUE: u32 = 0x2f_6fb0;
pub(crate) const ORANGE: u32 = 0xf0_b46a;
pub(crate) const RED: u32 = 0xc4_4a3c;
pub(crate) const GREEN: u32 = 0x3f_8f5c;

/// Samples along a pixel's side.
const SAMPLES: u32 = 4;

/// A point in pixels, y down.
pub(crate) type Point = [f32; 2];

/// A sheet to draw on.
pub(crate) struct Canvas {
    width: u32,
    height: u32,
    samples: Vec<u32>,
}

impl Canvas {
    pub(crate) fn new(width: u32, height: u32) -> Self {
        let samples = vec![PAPER; (width * height * SAMPLES * SAMPLES) as usize];
        Self { width, height, samples }
    }

    /// A convex polygon.
    pub(crate) fn polygon(&mut self, points: &[Point], color: u32) -> Result<(), Box<dyn Error>> {
        let vertices: Vec<Clip> =
            points.iter().map(|[x, y]| [x * SAMPLES as f32, y * SAMPLES as f32, 0.0, 1.0]).collect();
        let fan: Vec<[u32; 3]> = (2..points.len() as u32).map(|k| [0, k - 1, k]).collect();
        let (width, height) = (self.width * SAMPLES, self.height * SAMPLES);
        let mut target = Target::new(&mut self.samples, Depth::None, width, height, width as usize)?;
        let state = State { space: Space::Screen, test: DepthTest::Off, ..State::default() };
        target.triangles(&state, &vertices, &fan, &Flat(color));
        Ok(())
    }

    /// A rectangle from its upper left to its lower right corner.
    pub(crate) fn rectangle(&mut self, a: Point, b: Point, color: u32) -> Result<(), Box<dyn Error>> {
        self.polygon(&[a, [b[0], a[1]], b, [a[0], b[1]]], color)
    }

    /// A straight line, its ends cut off square.
    pub(crate) fn line(&mut self, a: Point, b: Point, width: f32, color: u32) -> Result<(), Box<dyn Error>> {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let half = width / 2.0 / (dx * dx + dy * dy).sqrt();
        let (x, y) = (-dy * half, dx * half);
        let corners =
            [[a[0] + x, a[1] + y], [b[0] + x, b[1] + y], [b[0] - x, b[1] - y], [a[0] - x, a[1] - y]];
        self.polygon(&corners, color)
    }

    /// A broken line.
    pub(crate) fn dashes(
        &mut self,
        a: Point,
        b: Point,
        width: f32,
        color: u32,
    ) -> Result<(), Box<dyn Error>> {
        let length = ((b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)).sqrt();
        let count = (length / 12.0).max(1.0) as u32;
        let at = |t: f32| between(a, b, t / count as f32);
        (0..count).try_for_each(|k| self.line(at(k as f32), at(k as f32 + 0.55), width, color))
    }

    /// The sides of a polygon.
    pub(crate) fn outline(&mut self, points: &[Point], width: f32, color: u32) -> Result<(), Box<dyn Error>> {
        for (k, &to) in points.iter().enumerate() {
            let from = points[(k + points.len() - 1) % points.len()];
            self.line(from, to, width, color)?;
            self.dot(to, width / 2.0, color)?;
        }
        Ok(())
    }

    /// A line with a head at `b`.
    pub(crate) fn arrow(&mut self, a: Point, b: Point, width: f32, color: u32) -> Result<(), Box<dyn Error>> {
        let length = ((b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)).sqrt();
        let (x, y) = ((b[0] - a[0]) / length, (b[1] - a[1]) / length);
        let (long, wide) = (width * 4.5, width * 2.2);
        let neck = [b[0] - x * long, b[1] - y * long];
        self.line(a, neck, width, color)?;
        self.polygon(
            &[b, [neck[0] - y * wide, neck[1] + x * wide], [neck[0] + y * wide, neck[1] - x * wide]],
            color,
        )
    }

    /// A disc.
    pub(crate) fn dot(&mut self, [x, y]: Point, radius: f32, color: u32) -> Result<(), Box<dyn Error>> {
        const SIDES: u32 = 24;
        let turn = std::f64::consts::TAU / f64::from(SIDES);
        let rim: Vec<Point> = (0..SIDES)
            .map(|k| polosa_math::glam::DVec2::from_angle(f64::from(k) * turn).as_vec2())
            .map(|way| [x + radius * way.x, y + radius * way.y])
            .collect();
        self.polygon(&rim, color)
    }

    /// A disc with a rim.
    pub(crate) fn ring(
        &mut self,
        at: Point,
        radius: f32,
        rim: u32,
        inside: u32,
    ) -> Result<(), Box<dyn Error>> {
        self.dot(at, radius, rim)?;
        self.dot(at, radius - 2.0, inside)
    }

    /// Another picture, each of its pixels `zoom` pixels wide.
    pub(crate) fn paste(&mut self, at: [u32; 2], other: &Picture, zoom: u32) {
        let zoom = zoom * SAMPLES;
        for y in 0..other.height * zoom {
            for x in 0..other.width * zoom {
                let to = (at[1] * SAMPLES + y) * self.width * SAMPLES + at[0] * SAMPLES + x;
                self.samples[to as usize] = other.pixels[(y / zoom * other.width + x / zoom) as usize];
            }
        }
    }

    /// The finished picture.
    pub(crate) fn finish(self) -> Picture {
        let stride = self.width * SAMPLES;
        let mean = |x: u32, y: u32, of: fn(Color) -> u8| {
            let row = |sy: u32| (y * SAMPLES + sy) * stride + x * SAMPLES;
            let samples = (0..SAMPLES).flat_map(|sy| (0..SAMPLES).map(move |sx| (row(sy) + sx) as usize));
            let sum: f32 = samples.map(|at| srgb::decode(of(Color::from_u32(self.samples[at])))).sum();
            srgb::encode(sum / (SAMPLES * SAMPLES) as f32)
        };
        let places = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        let color = |(x, y)| Color::new(mean(x, y, |c| c.r), mean(x, y, |c| c.g), mean(x, y, |c| c.b));
        picture(self.width, self.height, places.map(|place| color(place).to_u32()).collect())
    }
}

/// The point at a share `t` of the way from `a` to `b`.
pub(crate) fn between(a: Point, b: Point, t: f32) -> Point {
    [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]
}
