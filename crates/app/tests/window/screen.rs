//! Hands and eyes: keys and the mouse by the server's XTEST, which programs cannot tell from real ones, and what the
//! screen shows.

use std::time::{Duration, Instant};

use x11rb::connection::{Connection as _, RequestConnection as _};
use x11rb::protocol::damage::{self, ConnectionExt as _};
use x11rb::protocol::xproto::{
    self, AtomEnum, ClientMessageEvent, ConfigureWindowAux, ConnectionExt as _, EventMask, ImageFormat,
    InputFocus, MapState, Window,
};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;

use crate::wait::{LIMIT, until};

/// What goes wrong between a test and its own server has no remedy.
const LOST: &str = "the X server answers";

/// X's names of keys.
pub(crate) mod keysym {
    pub(crate) const TAB: u32 = 0xff09;
    pub(crate) const RETURN: u32 = 0xff0d;
    pub(crate) const ESCAPE: u32 = 0xff1b;
    pub(crate) const LEFT: u32 = 0xff51;
    pub(crate) const UP: u32 = 0xff52;
    pub(crate) const PAGE_UP: u32 = 0xff55;
    pub(crate) const F12: u32 = 0xffc9;
    pub(crate) const SHIFT: u32 = 0xffe1;
    pub(crate) const CONTROL: u32 = 0xffe3;
}

/// A display, and one window on it.
pub(crate) struct Screen {
    connection: RustConnection,
    root: Window,
    window: Window,
    /// The first key code, and each key's names.
    keys: (u8, Vec<Vec<u32>>),
}

/// What a window shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shot {
    pub(crate) size: [u32; 2],
    /// `0x00RRGGBB`, row by row.
    pub(crate) pixels: Vec<u32>,
}

impl Screen {
    /// Connects to a display.
    pub(crate) fn connect(display: &str) -> Self {
        let (connection, number) = RustConnection::connect(Some(display)).expect(LOST);
        let setup = connection.setup();
        let (first, last) = (setup.min_keycode, setup.max_keycode);
        let root = setup.roots[number].root;
        let mapping =
            connection.get_keyboard_mapping(first, last - first + 1).expect(LOST).reply().expect(LOST);
        let names = mapping.keysyms.chunks(usize::from(mapping.keysyms_per_keycode)).map(<[u32]>::to_vec);
        let keys = (first, names.collect());
        connection.xtest_get_version(2, 2).expect(LOST).reply().expect(LOST);
        Self { connection, root, window: x11rb::NONE, keys }
    }

    /// Waits for a window that something is drawn into, gives it the keyboard, and has everything else be about it. There
    /// is no window manager that would.
    pub(crate) fn find(&mut self) {
        self.window = until("a window", || {
            let children = self.connection.query_tree(self.root).ok()?.reply().ok()?.children;
            children.into_iter().find(|&child| self.is_shown(child))
        });
        // A window is seen before there is a picture in it. Black is what there is without one.
        until("a picture", || (self.part([0, 0], [1, 1])?.pixels != [0]).then_some(()));
        let focus = self
            .connection
            .set_input_focus(InputFocus::PARENT, self.window, x11rb::CURRENT_TIME)
            .expect(LOST);
        focus.check().expect("a window that is shown takes the keyboard");
        until("the keyboard's focus", || {
            let focus = self.connection.get_input_focus().ok()?.reply().ok()?.focus;
            (focus == self.window).then_some(())
        });
    }

    /// Whether the window is gone.
    pub(crate) fn is_closed(&self) -> bool {
        !self.is_shown(self.window)
    }

    fn is_shown(&self, window: Window) -> bool {
        let attributes = self.connection.get_window_attributes(window).expect(LOST).reply();
        attributes.is_ok_and(|is| {
            is.map_state == MapState::VIEWABLE && is.class == xproto::WindowClass::INPUT_OUTPUT
        }) && self.title_of(window).is_some()
    }

    fn title_of(&self, window: Window) -> Option<String> {
        let name = self.atom("_NET_WM_NAME");
        let property = self.connection.get_property(false, window, name, AtomEnum::ANY, 0, 1024);
        let value = property.expect(LOST).reply().ok()?.value;
        (!value.is_empty()).then(|| String::from_utf8_lossy(&value).into_owned())
    }

    /// The window's title.
    pub(crate) fn title(&self) -> String {
        self.title_of(self.window).unwrap_or_default()
    }

    /// Waits for a title that contains this.
    pub(crate) fn wait_for_title(&self, part: &str) {
        until(&format!("a title with {part:?}"), || self.title().contains(part).then_some(()));
    }

    /// The number of a name.
    pub(crate) fn atom(&self, name: &str) -> u32 {
        self.connection.intern_atom(false, name.as_bytes()).expect(LOST).reply().expect(LOST).atom
    }

    pub(crate) fn connection(&self) -> &RustConnection {
        &self.connection
    }

    pub(crate) const fn window(&self) -> Window {
        self.window
    }
}

/// # Hands
impl Screen {
    fn fake(&self, kind: u8, detail: u8, [x, y]: [i16; 2]) {
        let sent = self.connection.xtest_fake_input(kind, detail, x11rb::CURRENT_TIME, self.root, x, y, 0);
        // Once it is answered, the event has happened.
        sent.expect(LOST).check().expect("a possible event");
    }

    /// A key goes down or comes up.
    pub(crate) fn key(&self, keysym: u32, down: bool) {
        let (first, names) = &self.keys;
        // A key's first name is what it gives without a modifier.
        let place = names.iter().position(|names| names.first() == Some(&keysym));
        let place = place.unwrap_or_else(|| panic!("a key for {keysym:#x} on the server's keyboard"));
        let code = *first + u8::try_from(place).expect("codes of keys are bytes");
        self.fake(if down { xproto::KEY_PRESS_EVENT } else { xproto::KEY_RELEASE_EVENT }, code, [0; 2]);
    }

    /// A button goes down or comes up: 1 left, 2 middle, 3 right, 4 the wheel away from the user, 5 towards him.
    pub(crate) fn button(&self, button: u8, down: bool) {
        self.fake(
            if down { xproto::BUTTON_PRESS_EVENT } else { xproto::BUTTON_RELEASE_EVENT },
            button,
            [0; 2],
        );
    }

    /// The pointer goes to a pixel of the window.
    pub(crate) fn point(&self, at: [i32; 2]) {
        let [x, y] = at.map(|place| i16::try_from(place).expect("a place on the screen"));
        let to = self.connection.translate_coordinates(self.window, self.root, x, y);
        let to = to.expect(LOST).reply().expect(LOST);
        self.fake(xproto::MOTION_NOTIFY_EVENT, 0, [to.dst_x, to.dst_y]);
    }

    /// Gives the window another size, as a window manager does when its edge is dragged.
    pub(crate) fn resize(&self, [width, height]: [u32; 2]) {
        let size = ConfigureWindowAux::new().width(width).height(height);
        self.connection.configure_window(self.window, &size).expect(LOST).check().expect("a possible size");
    }

    /// Asks the window to close, as a window manager does when its button is pressed.
    pub(crate) fn close(&self) {
        let [protocols, delete] = ["WM_PROTOCOLS", "WM_DELETE_WINDOW"].map(|name| self.atom(name));
        self.message(self.window, protocols, [delete, x11rb::CURRENT_TIME, 0, 0, 0]);
    }

    /// Tells a window something.
    pub(crate) fn message(&self, to: Window, kind: u32, data: [u32; 5]) {
        let message = ClientMessageEvent::new(32, to, kind, data);
        self.connection.send_event(false, to, EventMask::NO_EVENT, message).expect(LOST).check().expect(LOST);
    }
}

/// # Eyes
impl Screen {
    /// The window's size.
    pub(crate) fn size(&self) -> [u32; 2] {
        let geometry =
            self.connection.get_geometry(self.window).expect(LOST).reply().expect("an open window");
        [geometry.width, geometry.height].map(u32::from)
    }

    /// What the window shows; `None` while it cannot be seen.
    pub(crate) fn shot(&self) -> Option<Shot> {
        let geometry = self.connection.get_geometry(self.window).expect(LOST).reply().ok()?;
        self.part([0, 0], [geometry.width, geometry.height].map(u32::from))
    }

    /// What a part of it shows.
    pub(crate) fn part(&self, at: [i32; 2], size: [u32; 2]) -> Option<Shot> {
        let [x, y] = at.map(|place| i16::try_from(place).expect("a place in the window"));
        let [width, height] = size.map(|side| u16::try_from(side).expect("a size of windows"));
        let image =
            self.connection.get_image(ImageFormat::Z_PIXMAP, self.window, x, y, width, height, u32::MAX);
        let image = image.expect(LOST).reply().ok()?;
        assert_eq!(image.depth, 24, "the screen is one of 24 bits");
        let pixel = |bytes: &[u8; 4]| u32::from_le_bytes(*bytes) & 0xff_ffff;
        Some(Shot { size, pixels: image.data.as_chunks().0.iter().map(pixel).collect() })
    }

    /// What is shown once it has been the same for a while.
    pub(crate) fn settled(&self) -> Shot {
        const WHILE: Duration = Duration::from_millis(250);
        let begun = Instant::now();
        let mut last = (self.shot(), begun);
        loop {
            let shot = self.shot();
            if shot != last.0 {
                last = (shot, Instant::now());
            } else if let Some(shot) = shot
                && last.1.elapsed() >= WHILE
            {
                return shot;
            }
            assert!(begun.elapsed() < LIMIT, "the window was never the same for {WHILE:?}");
            std::thread::sleep(Duration::from_millis(3));
        }
    }

    /// Counts what is drawn into the window from now on.
    pub(crate) fn watch(&self) -> Redraws<'_> {
        let known = self.connection.extension_information(damage::X11_EXTENSION_NAME).expect(LOST);
        assert!(known.is_some(), "Xvfb tells of drawing");
        self.connection.damage_query_version(1, 1).expect(LOST).reply().expect(LOST);
        let id = self.connection.generate_id().expect(LOST);
        let made = self.connection.damage_create(id, self.window, damage::ReportLevel::RAW_RECTANGLES);
        made.expect(LOST).check().expect("a window can be watched");
        let redraws = Redraws { screen: self, damage: id };
        redraws.count();
        redraws
    }
}

/// Counts what is drawn into a window.
pub(crate) struct Redraws<'a> {
    screen: &'a Screen,
    damage: u32,
}

impl Redraws<'_> {
    /// How often something was drawn since this was asked last.
    pub(crate) fn count(&self) -> usize {
        let connection = &self.screen.connection;
        // An answer comes after all that happened before.
        connection.get_input_focus().expect(LOST).reply().expect(LOST);
        let events = std::iter::from_fn(|| connection.poll_for_event().expect(LOST));
        events.filter(|event| matches!(event, x11rb::protocol::Event::DamageNotify(_))).count()
    }
}

impl Drop for Redraws<'_> {
    fn drop(&mut self) {
        let _ = self.screen.connection.damage_destroy(self.damage);
    }
}
