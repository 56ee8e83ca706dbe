//! What the keys do.

use polosa::event::Button;

use crate::session::{Hold, Session, Tap};
use crate::wait::until;

const MODEL: &str = "shape:pyramid";

#[test]
fn figures_look_from_the_sides_5_changes_the_projection_and_enter_goes_back() {
    let Some(mut session) = Session::of(&["shape:teapot:3"]) else { return };
    session.check("at first");
    for sign in ['1', '3', '7', '9', '5', '1'] {
        session.type_sign(sign);
        session.check(&format!("after {sign}"));
    }
    session.drag(Button::Left, &[[160, 120], [180, 130], [200, 150]]);
    session.check("after an orbit in parallel projection");
    session.wheel([200, 100], 3);
    session.check("after the wheel in parallel projection");
    session.tap(Tap::ENTER);
    session.check("after Enter");
}

#[test]
fn letters_change_what_is_shown() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    for sign in ['e', 'e', 'e', 'g', 'x', 'c', 'c', 'c', 's', 's'] {
        session.type_sign(sign);
        session.check(&format!("after {sign}"));
    }
}

#[test]
fn d_shows_depth_f_fills_by_other_methods_h_helps() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    for sign in ['d', 'd', 'f', 'f', 'h', 'h'] {
        session.type_sign(sign);
        session.check(&format!("now after {sign}"));
    }
}

#[test]
fn arrows_turn_the_model_with_shift_the_camera_and_l_keeps_the_light_in_the_world() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    session.tap(Tap::LEFT);
    session.check("after an arrow to the left");
    session.tap(Tap::UP);
    session.check("after an arrow upward");
    session.tap(Tap::PAGE_UP);
    session.check("after page up");
    session.type_sign('l');
    session.check("after L");
    session.holding(Hold::SHIFT, |session| session.tap(Tap::LEFT));
    session.check("after Shift and an arrow");
}

#[test]
fn sliders_turn_the_camera_and_follow_it() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    session.type_sign('v');
    session.check("with sliders");
    session.drag(Button::Left, &[[120, 225], [140, 225], [200, 100]]);
    session.check("after the heading was dragged");
    session.drag(Button::Left, &[[303, 100], [303, 60], [303, 61]]);
    session.check("after the pitch was dragged");
    session.drag(Button::Left, &[[160, 120], [180, 130], [190, 135]]);
    session.check("sliders after an orbit");
    session.type_sign('v');
    session.check("without sliders");
}

#[test]
fn the_turntable_turns_until_it_is_told_not_to() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    let mut last = session.screen.settled();
    session.screen.key(u32::from('t'), true);
    session.screen.key(u32::from('t'), false);
    for turn in 0..5 {
        last = until(&format!("turn {turn} of the turntable"), || {
            session.screen.shot().filter(|shot| *shot != last)
        });
    }
    session.screen.key(u32::from('t'), true);
    session.screen.key(u32::from('t'), false);
    session.screen.settled();
    // Whatever came of it, everything else is as before.
    session.tap(Tap::ENTER);
    session.type_sign('x');
    session.check("after the turntable and Enter");
}

#[test]
fn in_flight_w_goes_forward_letters_are_no_commands_and_escape_leaves() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    let background = session.screen.part([0, 0], [1, 1]).expect("a pixel").pixels[0];
    let seen = |session: &Session| {
        let shot = session.screen.shot().expect("a window that is open");
        // Above what is written below.
        let above = &shot.pixels[..320 * 190];
        above.iter().filter(|pixel| **pixel != background).count()
    };
    let hold = |session: &Session, sign: char, until: &dyn Fn() -> Option<()>| {
        session.screen.key(u32::from(sign), true);
        crate::wait::until(&format!("a flight by {sign}"), until);
        session.screen.key(u32::from(sign), false);
        session.screen.settled();
    };
    session.tap(Tap::TAB);
    session.check("at the start of a flight");
    let first = seen(&session);
    hold(&session, 'w', &|| (seen(&session) > first * 5 / 4).then_some(()));
    let near = seen(&session);
    hold(&session, 's', &|| (seen(&session) < near * 9 / 10).then_some(()));
    session.screen.key(Tap::ESCAPE.0, true);
    session.screen.key(Tap::ESCAPE.0, false);
    session.twin.send(polosa::event::Event::Key {
        key: polosa::event::Key::Escape,
        pressed: true,
        repeat: false,
    });
    // S was no shading there, W no end; that E is a command again tells that the mode was left.
    session.tap(Tap::ENTER);
    session.type_sign('e');
    session.check("edges, after a flight");
}

#[test]
fn with_control_or_shift_letters_mean_something_else_or_nothing() {
    let Some(mut session) = Session::of(&[MODEL]) else { return };
    session.check("at first");
    session.holding(Hold::CONTROL, |session| session.type_sign('e'));
    session.holding(Hold::SHIFT, |session| session.type_sign('g'));
    session.type_sign('x');
    session.check("axes alone, after Ctrl E, Shift G and X");
}
