//! The growth of expansions, with the number of loops and with the order.

use std::time::Instant;

use proc_macro2::{TokenStream, TokenTree};
use quote::{format_ident, quote};

use crate::derive::TooLarge;
use crate::expand::expand;
use crate::passes::Passes;
use crate::plan::plan;
use crate::testing::families::{self, Member};
use crate::testing::sound;
use crate::work::{self, Work};

/// Four-bar linkages in series: the rocker of each is the crank of the next.
fn chain(loops: usize) -> TokenStream {
    let name = format_ident!("Chain{loops}");
    let (mut fields, mut unknowns, mut equations) = (TokenStream::new(), TokenStream::new(), TokenStream::new());
    let (mut crank, mut angle) = (format_ident!("crank"), format_ident!("theta"));
    for index in 1..=loops {
        let [ground, coupler, rocker, phi, psi] =
            ["ground", "coupler", "rocker", "phi", "psi"].map(|name| format_ident!("{name}_{index}"));
        fields.extend(quote!(#ground: Length, #coupler: Length, #rocker: Length,));
        unknowns.extend(quote!(unknown #phi: Angle, #psi: Angle;));
        equations.extend(quote!(
            #crank * cis(#angle) + #coupler * cis(#phi) == #ground + #rocker * cis(#psi);
        ));
        (crank, angle) = (rocker, psi);
    }
    quote! {
        struct #name { crank: Length, #fields }
        input theta: Angle;
        #unknowns
        #equations
    }
}

/// A four-bar linkage to a given order.
fn four_bar(order: usize) -> TokenStream {
    let order = proc_macro2::Literal::usize_unsuffixed(order);
    quote! {
        struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
        input theta2: Angle;
        unknown theta3: Angle, theta4: Angle;
        r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
        order = #order;
    }
}

/// Six unknown angles in one block.
fn coupled() -> TokenStream {
    quote! {
        struct SixCoupled { side: Length, leg: Length, tie: Length, radius: Length }
        input theta: Angle;
        unknown a: Angle, b: Angle, c: Angle, d: Angle, e: Angle, f: Angle;
        let first = polar(radius, 0) + leg * cis(a);
        let second = polar(radius, 2 * PI / 3) + leg * cis(b);
        let third = polar(radius, 4 * PI / 3) + leg * cis(c);
        first + side * cis(d) + tie * cis(e) == second;
        second + side * cis(e) + tie * cis(f) == third;
        third + side * cis(f) + tie * cis(d + theta) == first;
    }
}

/// The length of the longest chain.
const LOOPS: usize = 11;

/// The number of expressions looked up and the number of tokens written grow linearly with the length of a chain.
#[test]
fn a_chain_takes_work_in_proportion_to_its_loops() {
    let work: Vec<[usize; 2]> = (1..=LOOPS)
        .map(|loops| {
            let (tokens, work) = work::of(|| count_tokens(expand(chain(loops))));
            [work.look_ups, tokens]
        })
        .collect();
    for (loops, [lookups, tokens]) in (1..).zip(&work) {
        println!("{loops:2} loops: {lookups:7} expressions looked up, {tokens:6} tokens");
    }
    // an input drives the first loop, unknowns drive the others; with up to six choices all assemblies are listed
    for (kind, first) in [(0, 2), (1, 7)] {
        let each = work[first][kind] - work[first - 1][kind];
        for loops in first..LOOPS {
            let more = work[loops][kind] - work[loops - 1][kind];
            assert!(
                more.abs_diff(each) * 20 <= each,
                "loop {} takes {more}, one before it {each}",
                loops + 1
            );
        }
    }
}

/// One member of each family, of a realistic size, or of a part of it.
fn members(part: usize) -> Vec<Member> {
    let mut members = vec![
        families::arm(7 / part, "with sensitivities;"),
        families::arm(15 / part, ""),
        families::rotations(10 / part),
        families::squares(14 / part),
        families::cross_products(10 / part),
        families::factors(100 / part),
        families::linear_factors(10 / part),
        families::terms(100 / part),
        families::directions(20 / part),
        families::ring(12 / part),
        families::outputs(50 / part),
        families::four_bars(1),
    ];
    members.extend(families::powers());
    let steps = [
        "sin({})",
        "sqrt({} + 2)",
        "exp(-{})",
        "ln({} + 3)",
        "atan({})",
        "acos({} / 4)",
        "tan({} / 2)",
    ];
    members.extend(steps.map(|step| families::nested(50 / part, step)));
    members.push(families::nested(10 / part, "a / (t + 1 / {})"));
    members
}

/// Members whose expansion takes seconds without optimisation.
fn long_members() -> Vec<Member> {
    vec![
        families::arm(30, ""),
        families::terms(500),
        families::ring(30),
        families::outputs(300),
        families::four_bars(5),
    ]
}

/// Members whose expansion takes long without optimisation.
fn large_members() -> Vec<Member> {
    vec![
        families::nested(200, "sin({})"),
        families::linear_factors(30),
        families::cross_products(30),
        families::terms(2000),
        families::ring(60),
        families::four_bars(20),
    ]
}

/// The work and the size of an expansion.
struct Expanded {
    work: Work,
    seconds: f64,
    /// The tokens of the declaration.
    read: usize,
    /// The operations from the position through the highest order, and those of all other requested programs.
    operations: usize,
}

impl Expanded {
    fn new(member: &Member) -> Self {
        let start = processor_seconds();
        let (_, work) = work::of(|| expand(member.tokens()));
        let seconds = processor_seconds() - start;
        let solvers = sound(member.tokens()).solvers(Passes::ALL);
        let further = [Some(&solvers.orientations), solvers.every.as_ref()];
        let further: usize = further.iter().flatten().map(|program| program.cost().total()).sum();
        Self {
            work,
            seconds,
            read: count_tokens(member.tokens()),
            operations: solvers.motion.cost().total() + further,
        }
    }

    /// The look-ups and the iterations of other loops for each token read and each operation written.
    fn rates(&self) -> [usize; 2] {
        [self.work.look_ups, self.work.iterations].map(|work| work / (self.read + self.operations))
    }

    fn line(&self, name: &str) -> String {
        let [look_ups, iterations] = self.rates();
        let Self { read, operations, .. } = self;
        format!(
            "{name:44} {read:6} tokens, {operations:6} operations, for each {look_ups:3} look-ups and {iterations:3} \
             iterations"
        )
    }
}

/// Expands the members of a family on a thread with the stack of a compiler's thread, which is larger than that of a
/// test.
fn expanded(members: Vec<Member>) -> Vec<(String, Expanded)> {
    let expand_all = move || {
        let members = members.into_iter();
        members
            .map(|member| {
                let expanded = Expanded::new(&member);
                (member.name, expanded)
            })
            .collect()
    };
    let thread = std::thread::Builder::new()
        .stack_size(COMPILERS_STACK)
        .spawn(expand_all);
    thread
        .expect("a thread can be started")
        .join()
        .expect("a family is expanded")
}

/// The size of the stack on which rustc runs macros.
const COMPILERS_STACK: usize = 8 << 20;

/// The number of steps is bounded by a multiple of the tokens read and operations written.
#[test]
fn work_follows_what_is_read_and_written() {
    check_work(members(3));
}

/// `.ci/run samples` runs it.
#[test]
#[ignore = "takes half a minute"]
fn work_of_long_declarations_follows_too() {
    check_work(members(1));
    check_work(long_members());
}

fn check_work(members: Vec<Member>) {
    for (name, expanded) in expanded(members) {
        println!("{}", expanded.line(&name));
        let [look_ups, iterations] = expanded.rates();
        assert!(
            look_ups < 100,
            "{name}: {look_ups} look-ups for each token and operation"
        );
        assert!(
            iterations < 200,
            "{name}: {iterations} iterations for each token and operation"
        );
    }
}

/// A declaration that takes too many expressions is reported at the order at which it does.
#[test]
fn a_declaration_that_is_too_large_is_reported() {
    let solvable = sound(families::arm(7, "with sensitivities;").tokens());
    let mut task = solvable.task(Passes::ALL);
    let orders: Vec<Option<usize>> = [1_000, 3_000, 1_000_000]
        .into_iter()
        .map(|most| {
            task.most_expressions = most;
            plan(&task).err().map(|TooLarge { order }| order)
        })
        .collect();
    assert_eq!(orders, [Some(2), Some(3), None]);
}

/// The processor time of this process, including its other threads, if the system reports it.
fn processor_seconds() -> f64 {
    let statistics = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let behind_the_name = statistics.rsplit(')').next().unwrap_or_default();
    // the share of the user and that of the system, in hundredths of a second
    let shares = behind_the_name.split_whitespace().skip(11).take(2);
    let hundredths: Option<f64> = shares.map(|share| share.parse::<f64>().ok()).sum();
    hundredths.map_or(f64::NAN, |hundredths| hundredths / 100.0)
}

/// The number of all tokens, including those within groups.
fn count_tokens(tokens: TokenStream) -> usize {
    tokens
        .into_iter()
        .map(|token| match token {
            TokenTree::Group(group) => 1 + count_tokens(group.stream()),
            _ => 1,
        })
        .sum()
}

/// Prints the times of expansions: `cargo test -p kin-compiler times -- --ignored --nocapture`. It asserts nothing.
#[test]
#[ignore = "prints times"]
fn times() {
    let mut cases = vec![("six coupled unknowns".to_owned(), coupled())];
    cases.extend([4, 6, 8, 10].map(|order| (format!("four-bar to order {order}"), four_bar(order))));
    cases.extend([1, 2, 4, 8, 16].map(|loops| (format!("chain of {loops}"), chain(loops))));
    for (name, declaration) in cases {
        let start = Instant::now();
        let length = expand(declaration).to_string().len();
        let time = start.elapsed().as_secs_f64() * 1e3;
        println!("{name:22} {time:9.1} ms, {length:7} characters");
    }
    let wanted = std::env::var("FAMILY").unwrap_or_default();
    let members = members(1).into_iter().chain(long_members()).chain(large_members());
    for (name, expanded) in expanded(members.filter(|member| member.name.contains(&wanted)).collect()) {
        println!("{}, {:6.2} s", expanded.line(&name), expanded.seconds);
    }
}
