//! Laws of roofs.
