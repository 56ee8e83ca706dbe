//! Methods by name: an enumeration, what each member is called, and one line about it.

use alloc::string::String;
use core::fmt;

/// A name that belongs to no method; its message lists those that there are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownName {
    what: &'static str,
    given: String,
    known: &'static [&'static str],
}

impl UnknownName {
    pub(super) const fn new(what: &'static str, given: String, known: &'static [&'static str]) -> Self {
        Self { what, given, known }
    }

    /// The names that would have been understood.
    #[must_use]
    pub const fn known(&self) -> &'static [&'static str] {
        self.known
    }
}

impl fmt::Display for UnknownName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no {} is called '{}'; there are ", self.what, self.given)?;
        for (k, name) in self.known.iter().enumerate() {
            let between = if k == 0 { "" } else { ", " };
            write!(f, "{between}{name}")?;
        }
        Ok(())
    }
}

impl core::error::Error for UnknownName {}

/// Defines an enumeration of methods. The first is the default; the line about a method is its documentation.
macro_rules! methods {
    (
        $(#[$attribute:meta])*
        $kind:ident, $what:literal {
            $first:ident, $first_name:literal, $first_about:literal;
            $($method:ident, $name:literal, $about:literal;)*
        }
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
        #[non_exhaustive]
        pub enum $kind {
            #[doc = $first_about]
            #[default]
            $first,
            $(
                #[doc = $about]
                $method,
            )*
        }

        impl $kind {
            /// Every one of them, the exact one first.
            pub const ALL: &[Self] = &[Self::$first, $(Self::$method),*];
            const NAMES: &[&str] = &[$first_name, $($name),*];

            /// Its name in text: what [`FromStr`](core::str::FromStr) understands.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    Self::$first => $first_name,
                    $(Self::$method => $name,)*
                }
            }

            /// One line: where it comes from, and what it gets wrong.
            #[must_use]
            pub const fn about(self) -> &'static str {
                match self {
                    Self::$first => $first_about,
                    $(Self::$method => $about,)*
                }
            }
        }

        impl core::fmt::Display for $kind {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.pad(self.name())
            }
        }

        impl core::str::FromStr for $kind {
            type Err = $crate::reference::UnknownName;

            fn from_str(name: &str) -> Result<Self, Self::Err> {
                let found = Self::ALL.iter().find(|method| method.name() == name);
                found.copied().ok_or_else(|| Self::Err::new($what, name.into(), Self::NAMES))
            }
        }
    };
}
pub(super) use methods;
