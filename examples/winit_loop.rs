//! A frame inside a loop of somebody else's: winit's events, softbuffer's pixels, and polosa only draws into them.
//! What to see: a torus that turns. `--headless OUT.png` draws the same into a vector.
#![expect(clippy::print_stdout, reason = "says where the picture is")]

use std::{error::Error, rc::Rc};

use polosa_examples::{picture, save};
use polosa_raster::{Depth, Target};
use polosa_scene::{Camera, Light, Object, Renderer, Style, World, shape};
use softbuffer::{Context, Surface};
use winit::event_loop::{ActiveEventLoop, EventLoop};
use winit::window::{Window, WindowId};
use winit::{application::ApplicationHandler, event::WindowEvent};

#[derive(Default)]
struct Shown {
    surface: Option<Surface<Rc<Window>, Rc<Window>>>,
    world: World,
    camera: Camera,
    renderer: Renderer,
}

impl Shown {
    /// The part that is polosa's: any slice of pixels will do.
    fn draw(&mut self, pixels: &mut [u32], [width, height]: [u32; 2]) -> Result<(), Box<dyn Error>> {
        self.camera.azimuth(0.02, [0.0; 3].into())?;
        self.camera.set_aspect(f64::from(width) / f64::from(height))?;
        let mut target = Target::new(pixels, Depth::None, width, height, width as usize)?;
        let (light, style) = (Light::default(), Style::default());
        self.renderer.frame(&self.world, &self.camera, &light, &style, None, &mut target)?;
        Ok(())
    }

    fn present(&mut self) -> Result<(), Box<dyn Error>> {
        let mut surface = self.surface.take().ok_or("no window")?;
        let size = <[u32; 2]>::from(surface.window().inner_size()).map(|side| side.max(1));
        surface.resize(size[0].try_into()?, size[1].try_into()?)?;
        let mut pixels = surface.buffer_mut()?;
        self.draw(&mut pixels, size)?;
        pixels.present()?;
        surface.window().request_redraw();
        self.surface = Some(surface);
        Ok(())
    }
}

impl ApplicationHandler for Shown {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        let window = event_loop.create_window(Window::default_attributes()).map(Rc::new);
        let surface = |window: Rc<Window>| Surface::new(&Context::new(window.clone()).ok()?, window).ok();
        self.surface = window.ok().and_then(surface);
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::RedrawRequested if self.present().is_ok() => {}
            WindowEvent::RedrawRequested | WindowEvent::CloseRequested => event_loop.exit(),
            _ => {}
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut shown = Shown::default();
    let torus = shown.world.add_mesh(shape::torus(48, 24)?);
    shown.world.add(Object::new(torus))?;
    shown.camera.set_position([0.0, 2.0, 2.0].into())?;
    shown.camera.look_at([0.0; 3].into())?;
    if std::env::args().len() == 1 {
        let event_loop =
            EventLoop::new().map_err(|error| format!("no window ({error}): try --headless OUT.png"));
        return Ok(event_loop?.run_app(&mut shown)?);
    }
    let mut pixels = vec![0; 320 * 240];
    shown.draw(&mut pixels, [320, 240])?;
    println!("{}", save("winit_loop.png", &picture(320, 240, pixels))?.display());
    Ok(())
}
