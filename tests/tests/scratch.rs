use kin_core::prelude::*;
use kin_tests::mechanisms::four_bar_typings::*;
macro_rules! show { ($($t:ident)*) => {$({
    let m = $t::<f64>::from_parameters([90.0,30.0,60.0,45.0]);
    let c = Motion::from((65f64.to_radians(), -10.0, 2.0, -0.5, 0.3));
    let p = m.solve_motion([c], Assembly::Open).unwrap();
    let u = p.unknown_motions();
    let n: usize = $t::<f64>::DESCRIPTION.operations.iter().map(|o| o.arithmetic()).sum();
    println!("{:28} {:?} {n} | {:.4} {:.4} | {:.6} {:.6}", stringify!($t), $t::<f64>::DESCRIPTION.blocks.iter().map(|b| b.closed_form).collect::<Vec<_>>(),
      u[0].value().to_degrees(), u[1].value().to_degrees(), u[0].snap(), u[1].snap());
})*}}
#[test]
fn t() {
    show!(FourBarPlain FourBarSidesSwapped FourBarReordered FourBarMovedAcross FourBarSumToZero FourBarZeroToSum FourBarComponents FourBarComponentsSwapped FourBarNegatedComponent FourBarMixedComponents FourBarDoubled FourBarScaledByGround FourBarScaledApart FourBarDivided FourBarConjugate FourBarTurned FourBarInCrankFrame FourBarPolar FourBarCoordinates FourBarProduct FourBarHalfAngles FourBarLets FourBarRockerFromPin FourBarCouplerFromRocker FourBarRockerFromUpright FourBarQuarterTurn FourBarClockwiseRocker FourBarClockwiseCoupler FourBarRelativeRocker FourBarUnknownsSwapped FourBarRenamed);
}
