use kin_core::mechanism;

mechanism! {}

fn main() {}
