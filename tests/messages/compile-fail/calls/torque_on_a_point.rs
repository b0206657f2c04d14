use kin_core::library::FiveBar;
use kin_core::load::Loads;

fn main() {
    let _ = Loads::<FiveBar>::new().torque(10.0, |pose| pose.hand);
}
