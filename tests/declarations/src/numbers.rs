//! Numbers as they are written.

use crate::random::Random;

/// A number of ordinary size that is not zero.
pub(crate) fn ordinary(random: &mut Random) -> String {
    let numbers = [
        "2", "3", "0.5", "1.5", "1.25", "0.75", "2.0", "3.0f64", "0.1_5", "2f64", "25e-2", "1E0", "0.3", "1.7", "0.7",
    ];
    (*random.pick(&numbers)).to_owned()
}

/// A number at an end of what can be written: zeros, the least, the largest, whole ones beyond all integers, with signs
/// and types.
pub(crate) fn extreme(random: &mut Random) -> String {
    let numbers = [
        "0",
        "0.0",
        "0e0",
        "000",
        "0_0",
        "1",
        "1.0",
        "1e-320",
        "5e-324",
        "4.9e-324",
        "1e-400",
        "2.2250738585072014e-308",
        "1e-308",
        "1e-300",
        "1e-200",
        "1e-160",
        "1e-154",
        "1e-100",
        "1e-16",
        "1e16",
        "1e17",
        "1e100",
        "1e154",
        "1e160",
        "1e200",
        "1e300",
        "1e307",
        "1e308",
        "1.7976931348623157e308",
        "1.7976931348623159e308",
        "1e309",
        "1e400",
        "1e99999999999",
        "9007199254740993",
        "18446744073709551616",
        "170141183460469231731687303715884105728",
        "340282366920938463463374607431768211456",
        "0.1",
        "0.30000000000000004",
        "1.0000000000000002",
        "0.9999999999999999",
        "3.141592653589793",
        "6.283185307179586",
        "1.5707963267948966",
        "180",
    ];
    if random.one_in(20) {
        let digits = random.size(400);
        return (0..digits).map(|_| char::from(b'0' + digit(random))).collect();
    }
    (*random.pick(&numbers)).to_owned()
}

/// A literal that the compiler reads and the macro does not, or a number in a rare spelling.
pub(crate) fn odd(random: &mut Random) -> String {
    let literals = [
        "0xff",
        "0XFF",
        "0b101",
        "0o17",
        "0xffff_ffff_ffff_ffff_ffff",
        "1u8",
        "256u8",
        "1i128",
        "1f32",
        "1.5f32",
        "1f16",
        "1usize",
        "1.",
        "1._0",
        "1e_1",
        "1_",
        "1__2",
        "1.0_",
        "1e5f64",
        "0x1f64",
        "1length",
        "2cm",
        "1.5rad",
        "'a'",
        "'\\u{1F600}'",
        "b'x'",
        "\"a\"",
        "r#\"raw\"#",
        "b\"bytes\"",
        "c\"c\"",
        "true",
        "false",
        "\"\\\\ \\\" {}\"",
        "'static",
    ];
    (*random.pick(&literals)).to_owned()
}

fn digit(random: &mut Random) -> u8 {
    u8::try_from(random.below(10)).expect("a digit is below ten")
}
