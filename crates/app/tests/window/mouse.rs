//! What the mouse does, and the window's size.

use polosa::event::Button;

use crate::session::{Hold, SIZE, Session};

/// A model with an outline that tells where it is turned.
const MODEL: &str = "shape:teapot:4";

#[test]
fn a_window_shows_a_model_as_it_is_drawn_without_one() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("a teapot");
    assert_eq!(session.screen.title(), "shape:teapot:4 – polosa");
    assert_eq!(session.screen.size(), SIZE);
}

#[test]
fn a_left_drag_goes_round_the_model() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    session.drag(Button::Left, &[[160, 120], [170, 118], [200, 100], [230, 90]]);
    session.check("after an orbit");
    session.drag(Button::Left, &[[100, 60], [100, 200], [100, 900], [101, 900]]);
    session.check("after an orbit to the pole, out of the window");
}

#[test]
fn a_middle_drag_and_shift_with_the_left_button_move_the_model_along() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    session.drag(Button::Middle, &[[160, 120], [140, 125], [100, 150]]);
    session.check("after a pan");
    session.holding(Hold::SHIFT, |session| session.drag(Button::Left, &[[90, 150], [120, 120], [180, 90]]));
    session.check("after a pan with Shift");
    // And without Shift the same button orbits again.
    session.drag(Button::Left, &[[160, 100], [170, 100], [190, 100]]);
    session.check("after a pan and an orbit");
}

#[test]
fn the_wheel_goes_towards_what_is_under_the_pointer() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    session.wheel([130, 120], 4);
    session.check("after four notches nearer");
    session.wheel([5, 5], -7);
    session.check("after seven notches farther");
}

#[test]
fn a_right_drag_moves_the_light() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    session.drag(Button::Right, &[[160, 120], [200, 110], [260, 60]]);
    session.check("after the light was moved");
}

#[test]
fn after_a_double_click_the_camera_turns_about_the_point_that_was_clicked() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    // The spout.
    let at = [262, 118];
    session.point(at);
    for pressed in [true, false, true, false] {
        session.press(Button::Left, pressed, at);
    }
    let pivot = session.twin.app.pivot();
    session.twin.shot();
    assert_ne!(session.twin.app.pivot(), pivot, "the click was on the model");
    session.drag(Button::Left, &[[160, 200], [120, 200], [80, 180]]);
    session.check("after an orbit about the spout");
}

#[test]
fn a_window_of_another_size_shows_a_picture_of_that_size() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    for size in [[500, 200], [201, 333], [1, 1], [640, 480]] {
        session.resize(size);
        session.check(&format!("at {} x {}", size[0], size[1]));
    }
    session.drag(Button::Left, &[[160, 120], [170, 118], [200, 100]]);
    session.check("after an orbit in a window of another size");
}

#[test]
fn a_screen_of_twice_the_density_gets_twice_the_pixels() {
    let scale = [("WINIT_X11_SCALE_FACTOR", "2")];
    let Some(mut session) = Session::with(&[MODEL], &[], &scale) else { return };
    let size = SIZE.map(|side| 2 * side);
    assert_eq!(session.screen.size(), size);
    session.twin.send(polosa::event::Event::Resize { size, scale: 2.0 });
    session.check("at twice the density");
    session.type_sign('h');
    session.check("the help at twice the density");
    session.drag(Button::Left, &[[320, 240], [340, 236], [400, 200]]);
    session.check("after an orbit at twice the density");
}
