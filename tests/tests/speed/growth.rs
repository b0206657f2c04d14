//! Growth: operations with the square of the order, and with the number of loops; and that high orders are right.
//!
//! The counts are printed: `cargo test -p kin-tests --test speed growth -- --nocapture`.
#![allow(missing_docs, unreachable_pub, reason = "declarations as a person writes them")]

use kin_core::prelude::*;
use kin_core::series::Series;
use kin_tests::growth;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::mechanisms::chains;
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;

/// The highest order that is looked at here.
const ORDER: usize = 10;
const LENGTH: usize = ORDER + 1;

/// A mechanism through the tenth derivative.
trait ThroughTen: Mechanism<Scalar = f64, Motion<f64> = Motion<f64, LENGTH>> {}

impl<M: Mechanism<Scalar = f64, Motion<f64> = Motion<f64, LENGTH>>> ThroughTen for M {}

/// The same declaration through snap and through the tenth derivative.
macro_rules! twice {
    ($($module:ident: $name:ident { $($declaration:tt)* })+) => {
        $(mod $module {
            pub mod snap {
                kin_core::mechanism! { $($declaration)* }
            }
            pub mod ten {
                kin_core::mechanism! { $($declaration)* order = 10; }
            }
        })+
    };
}

twice! {
    four_bar: FourBar {
        pub struct FourBar { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
        input theta2: Angle;
        unknown theta3: Angle, theta4: Angle;
        r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    }
    slider_crank: SliderCrank {
        pub struct SliderCrank { pub crank: Length, pub rod: Length, pub offset: Length }
        input theta: Angle;
        unknown s: Length, phi: Angle;
        crank * cis(theta) + rod * cis(phi) == vec2(s, offset);
    }
    inverted_slider_crank: InvertedSliderCrank {
        pub struct InvertedSliderCrank { pub ground: Length, pub crank: Length }
        input theta: Angle;
        unknown s: Length where s > 0, phi: Angle;
        crank * cis(theta) + ground == s * cis(phi);
    }
    drag: Drag {
        pub struct Drag { pub height: Length, pub decay: Scalar }
        input x: Scalar;
        unknown y: Length;
        y * sqrt(1 + x.powi(2)) == height * exp(decay * sin(x));
    }
}

/// The operations of each order, from the velocity on.
fn counts<M: Mechanism>() -> Vec<i64> {
    M::DESCRIPTION.operations[1..]
        .iter()
        .map(|operations| i64::try_from(operations.arithmetic()).expect("counts are small"))
        .collect()
}

/// All orders to the n-th together take a number of operations that is quadratic in n if the n-th alone takes a number
/// that is linear: no order adds to the one below twice what orders add on average. Nested differentiation multiplies
/// instead: were the n-th order half as dear again as the one below, the last would add three times the average, and
/// more if it were dearer.
fn assert_quadratic<M: Mechanism>() {
    let counts = counts::<M>();
    let growth: Vec<i64> = counts.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let total: Vec<i64> = (1..=counts.len()).map(|order| counts[..order].iter().sum()).collect();
    let name = M::DESCRIPTION.name;
    println!("{name:20} each order alone {counts:4?}");
    println!("{:20} all through it   {total:4?}", "");
    assert_eq!(counts.len(), ORDER);
    let largest = growth.iter().max().expect("there are ten orders");
    let orders = i64::try_from(growth.len()).expect("there are ten orders");
    assert!(
        largest * orders < 2 * growth.iter().sum::<i64>(),
        "{name}: the orders add {growth:?}"
    );
}

#[test]
fn operations_grow_with_the_square_of_the_order() {
    assert_quadratic::<four_bar::ten::FourBar>();
    assert_quadratic::<slider_crank::ten::SliderCrank>();
    assert_quadratic::<inverted_slider_crank::ten::InvertedSliderCrank>();
    assert_quadratic::<drag::ten::Drag>();
}

type S = Series<LENGTH>;

/// The units of error of all orders: those of the twin through snap, with the frequency of the higher orders.
struct Units {
    gauge: Gauge,
}

impl Units {
    fn new<Short: ThroughSnap>(
        short: &Short,
        inputs: &[Motion<f64, LENGTH>],
        unknowns: &[Motion<f64, LENGTH>],
    ) -> Self {
        let mut gauge = Gauge::new(
            short,
            &Short::Inputs::from_fn(|index| inputs[index].truncate()),
            &Short::Unknowns::from_fn(|index| unknowns[index].truncate()),
        );
        let frequency = |motion: &Motion<f64, LENGTH>, size: f64| {
            (1..)
                .zip(&motion.as_slice()[1..])
                .map(|(order, rate)| (rate.abs() / size).powf(1.0 / f64::from(order)))
                .fold(0.0_f64, f64::max)
        };
        for motion in inputs {
            gauge.driving = gauge.driving.max(frequency(motion, motion.value().abs().max(1.0)));
        }
        gauge.frequency = gauge.frequency.max(gauge.driving);
        for (motion, &size) in unknowns.iter().zip(&gauge.sizes) {
            gauge.frequency = gauge.frequency.max(frequency(motion, size));
        }
        Self { gauge }
    }

    /// An error as a part of what is allowed. What is allowed of the snap does for the orders after it, as w to the
    /// n-th power outgrows the sums.
    fn part(error: f64, unit: f64, order: usize) -> f64 {
        error / (unit * ALLOWED[order.min(ALLOWED.len() - 1)])
    }
}

/// Both oracles, with series of eleven terms: the generated derivatives against those of the position solution run on
/// series, and put back into the closure, of which nothing must be left.
fn verify<M: ThroughTen, Short: ThroughSnap>(parameters: &[f64], seed: u64) {
    let mechanism = M::from_parameters(M::Parameters::from_fn(|index| parameters[index]));
    let short = Short::from_parameters(Short::Parameters::from_fn(|index| parameters[index]));
    let lifted = mechanism.convert(S::constant);
    let mut random = Random::new(seed);
    let mut worst = [[0.0_f64; LENGTH]; 2];
    let mut poses = 0;
    for _ in 0..200 {
        let inputs = M::Inputs::from_fn(|_| {
            let mut size = 1.0;
            let mut motion = Motion::from_fn(|_| {
                size *= 2.0;
                size * random.between(-1.0, 1.0)
            });
            motion[0] = random.between(-3.0, 3.0);
            motion
        });
        for assembly in M::assemblies() {
            let Ok(pose) = mechanism.solve(inputs, assembly) else {
                continue;
            };
            poses += 1;
            let unknowns = pose.unknown_motions();
            let units = Units::new(&short, inputs.as_ref(), unknowns.as_ref());
            let series = |motion: &Motion<f64, LENGTH>| S::from_derivatives(motion.derivatives());
            let inputs = <<M::With<S> as Mechanism>::Inputs<S> as Row<S>>::from_fn(|index| series(&inputs[index]));
            let expected = lifted.position(inputs, assembly).expect("it closes on series, too");
            for (index, (own, expected)) in unknowns.as_ref().iter().zip(expected.as_ref()).enumerate() {
                let expected = expected.derivatives();
                for (order, own) in own.derivatives().into_iter().enumerate() {
                    let part = Units::part((own - expected[order]).abs(), units.gauge.unknown(index, order), order);
                    worst[0][order] = worst[0][order].max(part);
                    assert!(
                        part <= 1.0,
                        "{} order {order}: {part} of what is allowed",
                        M::DESCRIPTION.name
                    );
                }
            }
            let own = <<M::With<S> as Mechanism>::Unknowns<S> as Row<S>>::from_fn(|index| series(&unknowns[index]));
            for (index, left) in lifted.closure(inputs, own).as_ref().iter().enumerate() {
                for (order, left) in left.derivatives().into_iter().enumerate() {
                    let part = Units::part(left.abs(), units.gauge.equation(index, order), order);
                    worst[1][order] = worst[1][order].max(part);
                    assert!(part <= 1.0, "{} order {order}: {part} left", M::DESCRIPTION.name);
                }
            }
        }
    }
    println!(
        "{:20} {poses} poses, parts of what is allowed, order by order:",
        M::DESCRIPTION.name
    );
    for (name, parts) in ["differentiation", "closure"].into_iter().zip(worst) {
        println!("{name:>20} {}", parts.map(|part| format!("{part:8.1e}")).join(" "));
    }
    assert!(poses > 100, "only {poses} poses");
}

#[test]
fn high_orders_agree_with_series() {
    verify::<four_bar::ten::FourBar, four_bar::snap::FourBar>(&[4.0, 1.0, 3.0, 2.5], 1);
    verify::<slider_crank::ten::SliderCrank, slider_crank::snap::SliderCrank>(&[1.0, 3.0, 0.4], 2);
    verify::<inverted_slider_crank::ten::InvertedSliderCrank, inverted_slider_crank::snap::InvertedSliderCrank>(
        &[2.0, 0.8],
        3,
    );
    verify::<drag::ten::Drag, drag::snap::Drag>(&[1.5, 0.4], 4);
}

/// The counts of a chain, which is solved all around and compared, loop by loop, with the linkages that it is made of.
fn run<M: ThroughSnap, const LOOPS: usize>() -> Vec<usize> {
    let chain: M = chains::chain();
    let mut random = Random::new(LOOPS as u64);
    let mut poses = 0;
    for step in 0..36 {
        let input = Motion::new(random.motion((f64::from(10 * step) + 0.3).to_radians()));
        let assembly = M::assembly(0).expect("all loops are open in the first assembly");
        let Ok(pose) = chain.solve(M::Inputs::from_fn(|_| input), assembly) else {
            continue;
        };
        poses += 1;
        let unknowns = pose.unknown_motions();
        let (mut crank, mut angle) = (chains::CRANK, input);
        for (index, own) in unknowns.as_ref().chunks(2).enumerate() {
            let [r1, r3, r4] = chains::dimensions(index);
            let linkage = kin_core::library::FourBar { r1, r2: crank, r3, r4 };
            let alone = linkage
                .solve(angle, Assembly::Open)
                .expect("the chain closes, and so does its part");
            let gauge = Gauge::new(&linkage, &[angle], &alone.unknown_motions());
            for (place, (own, alone)) in own.iter().zip(alone.unknown_motions()).enumerate() {
                for (order, (own, alone)) in own.derivatives().into_iter().zip(alone.derivatives()).enumerate() {
                    let error = (own - alone).abs() / gauge.unknown(place, order);
                    assert!(error <= ALLOWED[order], "loop {index}, order {order}: {error} units");
                }
            }
            (crank, angle) = (r4, own[1]);
        }
    }
    assert!(poses >= 30, "{poses} poses of a chain of {LOOPS}");
    M::DESCRIPTION
        .operations
        .iter()
        .map(kin_core::Operations::arithmetic)
        .collect()
}

#[test]
fn chains_cost_what_their_loops_cost() {
    let counts = [
        run::<chains::Chain1, 1>(),
        run::<chains::Chain2, 2>(),
        run::<chains::Chain4, 4>(),
        run::<chains::Chain8, 8>(),
        run::<chains::Chain16, 16>(),
    ];
    for (loops, counts) in [1, 2, 4, 8, 16].into_iter().zip(&counts) {
        println!("{loops:2} loops: {counts:4?} = {}", counts.iter().sum::<usize>());
    }
    // each loop after the second adds what the third and fourth have added
    let added = |order: usize, from: usize, to: usize| counts[to][order] - counts[from][order];
    for order in 0..=4 {
        let two_loops = added(order, 1, 2);
        assert_eq!(added(order, 2, 3), 2 * two_loops, "order {order}");
        assert_eq!(added(order, 3, 4), 4 * two_loops, "order {order}");
    }
}

/// The README and the book show the counts.
#[test]
fn the_book_has_the_counts() {
    let chain: Vec<String> = growth::by_loops()
        .iter()
        .map(|counts| counts.generated.to_string())
        .collect();
    let (last, others) = chain.split_last().expect("chains are counted");
    let chain = format!("take {} and {last} operations through snap", others.join(", "));
    let door = include_str!("../../../README.md");
    assert!(door.contains(&chain), "README.md should say \"{chain}\"");

    let book = include_str!("../../../docs/performance.md");
    for counts in [growth::by_order(), growth::by_loops()] {
        let generated: Vec<usize> = counts.iter().map(|counts| counts.generated).collect();
        let nested: Vec<usize> = counts.iter().map(|counts| counts.nested).collect();
        for (name, counts) in [("operations", generated), ("operations of nested dual numbers", nested)] {
            let cells: Vec<String> = counts.iter().map(ToString::to_string).collect();
            let row = format!("| {name} | {} |", cells.join(" | "));
            assert!(
                book.lines().any(|line| line == row),
                "docs/performance.md should say\n{row}"
            );
        }
    }
}
