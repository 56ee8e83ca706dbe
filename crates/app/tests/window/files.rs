//! Files that come to a window and from it.

use std::fs;
use std::path::Path;

use polosa::event::Event;
use polosa::model::Model;
use polosa::viewer::{Options, Viewer};

use crate::models::{BROKEN, LOW_PYRAMID, PYRAMID};
use crate::session::{Hold, Session, Tap, Twin};
use crate::wait::until;
use crate::xdnd;

/// A viewer of a file, and the file's name.
fn viewer_of(content: &str, options: &[&str]) -> Option<(Session, String)> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("model.obj");
    fs::write(&path, content).expect("a file");
    let name = path.to_str().expect("a name in UTF-8").to_owned();
    Some((Session::in_folder(folder, &[&name], options, &[])?, name))
}

/// What the twin shows of another content, from the same camera.
fn reload_twin(session: &mut Session, name: &str) {
    let Twin { app, .. } = &session.twin;
    let (camera, light) = (app.camera, app.light);
    let model = Model::parse(name.into()).expect("a model's name");
    let mut viewer = Viewer::new(vec![model], Options::default());
    viewer.load_now(&mut session.twin.app).expect("a model that can be read");
    (session.twin.app.camera, session.twin.app.light) = (camera, light);
    session.twin.viewer = viewer;
}

#[test]
fn a_dropped_file_is_shown() {
    let Some(mut session) = Session::of(&["shape:cube"]) else { return };
    session.check("before the drop");
    let path = session.path("dropped.obj");
    fs::write(&path, PYRAMID).expect("a file");
    xdnd::drop_file(&session.screen, &path);
    session.screen.wait_for_title("dropped.obj – polosa");
    session.twin = Twin::new(&[path.to_str().expect("a name in UTF-8")]);
    session.check("after the drop");
}

#[test]
fn a_dropped_file_that_cannot_be_read_leaves_what_is_shown_and_a_message() {
    let Some(mut session) = Session::of(&["shape:cube"]) else { return };
    session.check("before the drop");
    let path = session.path("dropped.obj");
    fs::write(&path, BROKEN).expect("a file");
    xdnd::drop_file(&session.screen, &path);
    session.twin.send(Event::Drop(path));
    until("the twin's message", || {
        session.twin.shot();
        session.twin.viewer.message().map(drop)
    });
    session.check("after a drop that cannot be read");
    assert!(session.twin.viewer.message().is_some_and(|message| message.contains("dropped.obj")));
}

#[test]
fn f12_writes_the_picture_without_what_is_over_it() {
    let Some(mut session) = Session::of(&["shape:teapot:3"]) else { return };
    session.check("before the screenshot");
    let plain = session.screen.settled();
    session.type_sign('h');
    session.check("with the help over it");
    for number in [1, 2] {
        session.screen.key(Tap::F12.0, true);
        session.screen.key(Tap::F12.0, false);
        let path = session.path(&format!("polosa-000{number}.png"));
        // It gets its name when it is complete.
        let image = until("the screenshot", || path.exists().then(|| image::open(&path)));
        let image = image.expect("a picture").into_rgb8();
        assert_eq!([image.width(), image.height()], plain.size);
        let pixels: Vec<u32> =
            image.pixels().map(|image::Rgb([r, g, b])| u32::from_be_bytes([0, *r, *g, *b])).collect();
        assert!(pixels == plain.pixels, "screenshot {number} is not what the window shows");
    }
}

#[test]
fn ctrl_r_reads_the_file_again_and_keeps_the_camera() {
    let Some((mut session, name)) = viewer_of(PYRAMID, &[]) else { return };
    session.check("before the reload");
    session.wheel([160, 100], 2);
    session.check("nearer");
    fs::write(&name, LOW_PYRAMID).expect("a file");
    session.holding(Hold::CONTROL, |session| {
        session.screen.key(u32::from('r'), true);
        session.screen.key(u32::from('r'), false);
    });
    reload_twin(&mut session, &name);
    session.check("after the reload");
}

#[test]
fn with_watch_a_written_file_is_read_again_by_itself_and_a_broken_one_is_not_shown() {
    let Some((mut session, name)) = viewer_of(PYRAMID, &["--watch"]) else { return };
    session.check("before it is written");
    fs::write(&name, LOW_PYRAMID).expect("a file");
    reload_twin(&mut session, &name);
    session.check("after it was written");

    // As editors save: another file takes its name.
    let other = Path::new(&name).with_extension("new");
    fs::write(&other, PYRAMID).and_then(|()| fs::rename(&other, &name)).expect("a file");
    reload_twin(&mut session, &name);
    session.check("after another file took its name");

    let good = session.screen.settled();
    fs::write(&name, BROKEN).expect("a file");
    let with_message = until("the message", || session.screen.shot().filter(|shot| *shot != good));
    let (above, all) = (320 * 160, good.pixels.len());
    assert!(with_message.pixels[..above] == good.pixels[..above], "the last good model stays");
    let different = (above..all).filter(|&k| with_message.pixels[k] != good.pixels[k]).count();
    assert!(different > 100, "a message is below: {different} pixels");

    // And when it is whole again it is shown again, without the message.
    fs::write(&name, LOW_PYRAMID).expect("a file");
    reload_twin(&mut session, &name);
    session.check("after it was mended");
}
