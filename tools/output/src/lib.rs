//! What the commands write: files and folders that are checked before the work starts and appear
//! whole or not at all, and text that no terminal takes for orders.

mod console;
mod file;
mod folder;

pub use console::{exit_code, plain, say, warn};
pub use file::File;
pub use folder::Folder;
