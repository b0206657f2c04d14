use kin_core::library::FourBar;
use kin_core::load::Loads;

fn main() {
    let _ = Loads::<FourBar>::new().gravity(9.81);
}
