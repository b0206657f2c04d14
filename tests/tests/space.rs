use kin_core::prelude::*;
use kin_tests::mechanisms::space::*;

fn show<M: Mechanism>() {
    println!("{}", M::DESCRIPTION.name);
    for b in M::DESCRIPTION.blocks {
        println!("   {}: {}", b.unknowns, b.closed_form);
    }
    println!(
        "   {:?}",
        M::DESCRIPTION
            .operations
            .iter()
            .map(|o| (o.arithmetic(), o.square_roots, o.sine_cosines, o.arc_tangents))
            .collect::<Vec<_>>()
    );
}
#[test]
fn forms() {
    show::<Rssr>();
    show::<RssrByLength>();
    show::<RssrWithBall>();
    show::<Rssp>();
    show::<RsspByLength>();
    show::<Cardan>();
    show::<SphericalFourBar>();
    show::<Leg>();
    show::<LegByLength>();
    show::<Bennett>();
    show::<PlaneProducts>();
}
