//! Writes the solver of a mechanism of the library as C99, with a program that shows it.
//!
//! ```sh
//! cargo run --example c_code --features tape -- jansen_leg out
//! cc -O2 -std=c99 -ffp-contract=off out/main.c out/jansen_leg.c -lm -o out/jansen_leg
//! ```
//!
//! With the word `skeleton` behind the folder, the code finds the joints as well.

use std::error::Error;
use std::fs;
use std::path::Path;

#[allow(clippy::wildcard_imports, reason = "any mechanism of the library may be asked for")]
use kin_core::library::*;
use kin_core::tape::{self, C, Options, RecordError};

/// What prints the code of one mechanism.
type Printer = fn(&Options) -> Result<C, RecordError>;

/// The C code of a mechanism by its name, if the library has it.
fn code(name: &str, options: &Options) -> Option<Result<C, RecordError>> {
    macro_rules! by_name {
        ($($mechanism:ident)+) => {
            [$((stringify!($mechanism), code_of::<$mechanism>)),+]
        };
    }
    let all: [(&str, Printer); 37] = by_name! {
        AndrewsSqueezer Bennett ChebyshevLinkage ClassThreeTriad FiveBar FourBar FreudensteinFourBar GearedFiveBar
        GeometricFourBar HoekenLinkage InvertedSliderCrank JansenLeg KlannLeg OffsetSliderCrank Pantograph
        PeaucellierLinkage RobertsLinkage Rssp Rssr ScotchYoke SliderCrank SliderCrankFirstApproximation
        SliderCrankHigherApproximation SphericalFourBar StephensonI StephensonIByDyad StephensonII StephensonIIByElbow
        StephensonIII StephensonIIIByDyad StewartGoughLeg UniversalJoint WattI WattIByDyad WattII WattIIByCouplers
        WhitworthQuickReturn
    };
    let plain = |name: &str| name.replace('_', "").to_lowercase();
    let (_, code) = all.into_iter().find(|(own, _)| plain(own) == plain(name))?;
    Some(code(options))
}

fn code_of<M: kin_core::Mechanism<Scalar = f64>>(options: &Options) -> Result<C, RecordError> {
    Ok(tape::record::<M>(options)?.c())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let name = words.next().unwrap_or_else(|| "four_bar".to_owned());
    let folder = words.next().unwrap_or_else(|| "out".to_owned());
    let options = match words.next().as_deref() {
        Some("skeleton") => Options::new().with_skeleton(),
        _ => Options::new(),
    };
    let Some(c) = code(&name, &options) else {
        return Err(format!("the library has no mechanism `{name}`; the book lists all of them").into());
    };
    let (c, folder) = (c?, Path::new(&folder));
    fs::create_dir_all(folder)?;
    let (header, source) = (format!("{}.h", c.name), format!("{}.c", c.name));
    for (file, text) in [
        (&header, &c.header),
        (&source, &c.source),
        (&"main.c".to_owned(), &c.example),
    ] {
        fs::write(folder.join(file), text)?;
        println!("{}: {} bytes", folder.join(file).display(), text.len());
    }
    let folder = folder.display();
    println!(
        "build it by: cc -O2 -std=c99 -ffp-contract=off {folder}/main.c {folder}/{source} -lm -o {folder}/{}",
        c.name
    );
    Ok(())
}
