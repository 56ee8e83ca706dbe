//! A program that files are dragged from: the source's side of the protocol XDND, version 5.
//!
//! ```text
//!   source                          target
//!     ── XdndEnter: text/uri-list ──▶
//!     ── XdndPosition ──────────────▶
//!     ◀─ ConvertSelection ───────────  (the server tells the source: SelectionRequest)
//!     ── the list, SelectionNotify ─▶
//!     ◀─ XdndStatus: accepted ───────
//!     ── XdndDrop ──────────────────▶
//!     ◀─ XdndFinished ───────────────
//! ```

use std::path::Path;

use x11rb::connection::Connection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    ConnectionExt as _, CreateWindowAux, EventMask, PropMode, SELECTION_NOTIFY_EVENT, SelectionNotifyEvent,
    SelectionRequestEvent, Window, WindowClass,
};
use x11rb::wrapper::ConnectionExt as _;

use crate::screen::Screen;
use crate::wait::until;

const VERSION: u32 = 5;

/// Drops a file in the middle of the screen's window.
pub(crate) fn drop_file(screen: &Screen, file: &Path) {
    let connection = screen.connection();
    let list = format!("file://{}\r\n", file.to_str().expect("a name in ASCII"));
    assert!(
        list.bytes().all(|byte| byte.is_ascii() && byte != b'%' && byte != b' '),
        "{list:?} needs escapes"
    );
    let source = connection.generate_id().expect("a number for a window");
    let root = connection.setup().roots[0].root;
    let events = CreateWindowAux::new();
    let made = connection
        .create_window(0, source, root, 0, 0, 1, 1, 0, WindowClass::INPUT_ONLY, 0, &events)
        .map(|made| made.check());
    made.expect("the server answers").expect("a window that is not shown");
    let selection = screen.atom("XdndSelection");
    let owns = connection.set_selection_owner(source, selection, x11rb::CURRENT_TIME);
    owns.expect("the server answers").check().expect("a selection that nobody else has");

    let [enter, position, drop, status, finished, uris, copy] = [
        "XdndEnter",
        "XdndPosition",
        "XdndDrop",
        "XdndStatus",
        "XdndFinished",
        "text/uri-list",
        "XdndActionCopy",
    ]
    .map(|name| screen.atom(name));
    let [width, height] = screen.size();
    let target = screen.window();
    screen.message(target, enter, [source, VERSION << 24, uris, 0, 0]);
    let middle = (width / 2) << 16 | (height / 2);
    screen.message(target, position, [source, 0, middle, x11rb::CURRENT_TIME, copy]);

    let (mut accepted, mut asked) = (false, false);
    until("the window to take what is dragged over it", || {
        while let Some(event) = connection.poll_for_event().expect("the server answers") {
            match event {
                Event::SelectionRequest(request) => {
                    answer(screen, &request, uris, list.as_bytes());
                    asked = true;
                }
                Event::ClientMessage(message) if message.type_ == status => {
                    accepted = message.data.as_data32()[1] & 1 == 1;
                }
                _ => {}
            }
        }
        (accepted && asked).then_some(())
    });
    screen.message(target, drop, [source, 0, x11rb::CURRENT_TIME, 0, 0]);
    until("the window to say that the drop is done", || {
        let events = std::iter::from_fn(|| connection.poll_for_event().expect("the server answers"));
        let mut told = events
            .filter(|event| matches!(event, Event::ClientMessage(message) if message.type_ == finished));
        told.next().map(|_| ())
    });
}

/// Hands over the list of files.
fn answer(screen: &Screen, request: &SelectionRequestEvent, kind: u32, list: &[u8]) {
    let connection = screen.connection();
    let SelectionRequestEvent { requestor, selection, target, property, time, .. } = *request;
    let put = connection.change_property8(PropMode::REPLACE, requestor, property, kind, list);
    put.expect("the server answers").check().expect("the window's property can be set");
    let told = SelectionNotifyEvent {
        response_type: SELECTION_NOTIFY_EVENT,
        sequence: 0,
        time,
        requestor,
        selection,
        target,
        property,
    };
    let sent = connection.send_event(false, requestor as Window, EventMask::NO_EVENT, told);
    sent.expect("the server answers").check().expect("the window is there");
}
