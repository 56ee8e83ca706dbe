//! The sliders of the viewer, which show where the camera looks and have it look there.

use super::Viewer;
use crate::application::Application;
use crate::controls::slider::{Slider, SliderSide};
use crate::event::{Event, Handled};

impl Viewer {
    /// Puts the sliders where the camera is.
    pub(super) fn follow_camera(&mut self, app: &mut Application) {
        if self.sliders.as_ref().is_some_and(|sliders| !sliders.iter().any(Slider::is_held)) {
            let [heading, pitch] = app.heading_pitch();
            if let Some([below, right]) = &mut self.sliders {
                below.set_value(heading.to_degrees().rem_euclid(360.0));
                right.set_value(pitch.to_degrees());
            }
        }
    }

    pub(super) fn new_sliders() -> [Slider; 2] {
        [
            Slider::new(SliderSide::Below, [0.0, 360.0], 0.0),
            Slider::new(SliderSide::Right, [-90.0, 90.0], 0.0),
        ]
    }

    /// Hands an event to the sliders, and the camera their values.
    pub(super) fn slide(&mut self, app: &mut Application, event: &Event) -> Handled {
        let Some(sliders) = &mut self.sliders else { return Handled::No };
        let (size, scale) = (app.size(), app.scale());
        if sliders.iter_mut().all(|slider| slider.event(event, size, scale) == Handled::No) {
            return Handled::No;
        }
        let [heading, pitch] = [&sliders[0], &sliders[1]].map(|slider| slider.value().to_radians());
        app.turn_to(heading, pitch);
        app.redraw();
        Handled::Yes
    }
}
