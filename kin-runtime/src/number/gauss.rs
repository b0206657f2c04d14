//! Gauss's rule for integrals.

/// The nodes and weights of Gauss and Legendre's rule of ten points on -1 ..= 1, for the positive half.
/// (M. Abramowitz and I. A. Stegun, *Handbook of Mathematical Functions*, table 25.4.)
pub(crate) const GAUSS: [(f64, f64); 5] = [
    (0.148_874_338_981_631_22, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];
