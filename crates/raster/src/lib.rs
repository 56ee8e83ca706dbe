//! polosa.
