//! Draws all figures of the book.
//!
//! ```sh
//! cargo run -p kin-studio --features gallery --example figures
//! ```

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/figures");
    for figure in kin_studio::figures::all()? {
        std::fs::write(folder.join(figure.file), figure.svg)?;
    }
    Ok(())
}
