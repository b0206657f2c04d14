//! The picture of a house: rooms on floors, and arrows from each room to those that it imports.
//!
//! A room stands one floor above the highest that it imports. An arrow that follows from others is left out. An arrow over several
//! floors has a place of its own on each, so that none runs through a room. (K. Sugiyama, S. Tagawa & M. Toda, Methods for visual
//! understanding of hierarchical system structures, IEEE Transactions on Systems, Man, and Cybernetics 11, 1981, 109-125.)

use std::fmt::Write as _;

use crate::rooms::Room;

const WIDTH: f64 = 158.0;
const HEIGHT: f64 = 46.0;
/// Between two floors.
const STAIRS: f64 = 58.0;
/// Between neighbours.
const GAP: f64 = 22.0;
const MARGIN: f64 = 20.0;
/// How often the floors are sorted by their neighbours.
const SWEEPS: usize = 32;

/// An occupant of a floor: a room, or an arrow that passes.
struct Item {
    room: Option<usize>,
    floor: usize,
    x: f64,
    above: Vec<usize>,
    below: Vec<usize>,
}

impl Item {
    fn width(&self) -> f64 {
        if self.room.is_some() { WIDTH } else { 4.0 }
    }
}

pub(crate) fn draw(rooms: &[Room], arrows: &[(usize, usize)]) -> String {
    let floors = floors(rooms.len(), arrows);
    let arrows = needed(rooms.len(), arrows);
    let mut items: Vec<Item> = (0..rooms.len())
        .map(|room| Item {
            room: Some(room),
            floor: floors[room],
            x: 0.0,
            above: Vec::new(),
            below: Vec::new(),
        })
        .collect();
    for (from, to) in &arrows {
        let mut upper = *from;
        for floor in (floors[*to] + 1..floors[*from]).rev() {
            items.push(Item {
                room: None,
                floor,
                x: 0.0,
                above: Vec::new(),
                below: Vec::new(),
            });
            let lower = items.len() - 1;
            join(&mut items, upper, lower);
            upper = lower;
        }
        join(&mut items, upper, *to);
    }
    let mut order: Vec<Vec<usize>> = vec![Vec::new(); floors.iter().max().map_or(0, |highest| highest + 1)];
    for (place, item) in items.iter().enumerate() {
        order[item.floor].push(place);
    }
    sort(&items, &mut order);
    spread(&mut items, &order);
    print(rooms, &items, order.len())
}

fn join(items: &mut [Item], upper: usize, lower: usize) {
    items[upper].below.push(lower);
    items[lower].above.push(upper);
}

/// The floor of each room. Rooms are imported only by rooms that stand behind them in the list.
fn floors(count: usize, arrows: &[(usize, usize)]) -> Vec<usize> {
    let mut floors = vec![0; count];
    for room in 0..count {
        let below = arrows.iter().filter(|(from, _)| *from == room);
        floors[room] = below.map(|(_, to)| floors[*to] + 1).max().unwrap_or(0);
    }
    floors
}

/// The arrows that do not follow from others.
fn needed(count: usize, arrows: &[(usize, usize)]) -> Vec<(usize, usize)> {
    let mut reaches = vec![vec![false; count]; count];
    for room in 0..count {
        for (_, to) in arrows.iter().filter(|(from, _)| *from == room) {
            let beyond = reaches[*to].clone();
            for (own, further) in reaches[room].iter_mut().zip(beyond) {
                *own |= further;
            }
            reaches[room][*to] = true;
        }
    }
    let follows = |(from, to): &(usize, usize)| {
        arrows
            .iter()
            .any(|(start, middle)| start == from && middle != to && reaches[*middle][*to])
    };
    arrows.iter().copied().filter(|arrow| !follows(arrow)).collect()
}

/// Sorts each floor by the places of the neighbours, up and down, and keeps the order with the fewest crossings.
fn sort(items: &[Item], order: &mut Vec<Vec<usize>>) {
    let mut best = order.clone();
    for sweep in 0..SWEEPS {
        let upwards = sweep % 2 == 0;
        let count = order.len();
        for step in 1..count {
            let floor = if upwards { step } else { count - 1 - step };
            let beside = if upwards { floor - 1 } else { floor + 1 };
            let place = places(items.len(), &order[beside]);
            let mean = |item: usize| {
                let neighbours = if upwards {
                    &items[item].below
                } else {
                    &items[item].above
                };
                let sum: usize = neighbours.iter().map(|neighbour| place[*neighbour]).sum();
                // An item without neighbours stays where it is, between the means of the others.
                if neighbours.is_empty() {
                    None
                } else {
                    Some(number(sum) / number(neighbours.len()))
                }
            };
            let own = places(items.len(), &order[floor]);
            order[floor].sort_by(|one, other| {
                let key = |item: usize| mean(item).unwrap_or(number(own[item]));
                key(*one).total_cmp(&key(*other)).then(own[*one].cmp(&own[*other]))
            });
        }
        if crossings(items, order) < crossings(items, &best) {
            best.clone_from(order);
        }
    }
    *order = best;
}

/// The place of each item on a floor.
fn places(count: usize, floor: &[usize]) -> Vec<usize> {
    let mut places = vec![0; count];
    for (place, item) in floor.iter().enumerate() {
        places[*item] = place;
    }
    places
}

fn crossings(items: &[Item], order: &[Vec<usize>]) -> usize {
    let place = places_of_all(items.len(), order);
    let mut count = 0;
    for floor in order {
        let lines: Vec<(usize, usize)> = floor
            .iter()
            .flat_map(|item| items[*item].below.iter().map(|below| (place[*item], place[*below])))
            .collect();
        for (index, one) in lines.iter().enumerate() {
            count += lines[index + 1..]
                .iter()
                .filter(|other| (one.0 < other.0 && one.1 > other.1) || (one.0 > other.0 && one.1 < other.1))
                .count();
        }
    }
    count
}

fn places_of_all(count: usize, order: &[Vec<usize>]) -> Vec<usize> {
    let mut places = vec![0; count];
    for floor in order {
        for (place, item) in floor.iter().enumerate() {
            places[*item] = place;
        }
    }
    places
}

/// Moves items towards their neighbours, as far as those on the same floor leave room.
fn spread(items: &mut [Item], order: &[Vec<usize>]) {
    for floor in order {
        let mut x = 0.0;
        for item in floor {
            items[*item].x = x + items[*item].width() / 2.0;
            x += items[*item].width() + GAP;
        }
        let middle = (x - GAP) / 2.0;
        for item in floor {
            items[*item].x -= middle;
        }
    }
    for _ in 0..4 * SWEEPS {
        for floor in order {
            // As near to what is wanted as the distances allow, by least squares: what is too near moves as one.
            let mut blocks: Vec<(f64, usize)> = Vec::new();
            let mut offsets = vec![0.0; floor.len()];
            for place in 0..floor.len() {
                if place > 0 {
                    offsets[place] = offsets[place - 1] + distance(items, floor[place - 1], floor[place]);
                }
                let mut block = (wanted(items, floor[place]) - offsets[place], 1);
                while let Some(before) = blocks.pop_if(|before| before.0 > block.0) {
                    let size = before.1 + block.1;
                    block.0 = (before.0 * number(before.1) + block.0 * number(block.1)) / number(size);
                    block.1 = size;
                }
                blocks.push(block);
            }
            let places = blocks.iter().flat_map(|(x, size)| core::iter::repeat_n(*x, *size));
            for ((item, x), offset) in floor.iter().zip(places).zip(&offsets) {
                items[*item].x = x + offset;
            }
        }
    }
    // An item without neighbours at the end of its floor was only pushed away.
    for floor in order {
        let is_alone = |item: usize| items[item].above.is_empty() && items[item].below.is_empty();
        if let [.., before, last] = floor[..]
            && is_alone(last)
        {
            items[last].x = items[before].x + distance(items, before, last);
        }
    }
}

fn wanted(items: &[Item], item: usize) -> f64 {
    let neighbours = items[item].above.iter().chain(&items[item].below);
    let count = items[item].above.len() + items[item].below.len();
    if count == 0 {
        return items[item].x;
    }
    neighbours.map(|neighbour| items[*neighbour].x).sum::<f64>() / number(count)
}

fn distance(items: &[Item], one: usize, other: usize) -> f64 {
    f64::midpoint(items[one].width(), items[other].width()) + GAP
}

fn print(rooms: &[Room], items: &[Item], floors: usize) -> String {
    let edge = |sign: f64| {
        let ends = items.iter().map(|item| sign * item.x + item.width() / 2.0);
        ends.fold(f64::NEG_INFINITY, f64::max)
    };
    let shift = (edge(-1.0) + MARGIN).round();
    let width = (shift + edge(1.0) + MARGIN).round();
    let height = 2.0 * MARGIN + number(floors) * HEIGHT + number(floors - 1) * STAIRS;
    let top = |floor: usize| MARGIN + number(floors - 1 - floor) * (HEIGHT + STAIRS);

    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" text-anchor=\"middle\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n\
         <defs><marker id=\"tip\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">\
         <path d=\"M0 0 10 5 0 10z\" fill=\"#557\"/></marker></defs>\n\
         <g fill=\"none\" stroke=\"#557\" stroke-width=\"1.3\">\n"
    );
    for (place, item) in items.iter().enumerate().filter(|(_, item)| item.room.is_some()) {
        for below in &item.below {
            // From the lower edge of a room, through the places that the arrow has for itself, to the upper edge of another.
            let (mut upper, mut lower) = (place, *below);
            let mut y = top(item.floor) + HEIGHT;
            let x = shift + port(items, &item.below, place, lower);
            let mut path = format!("M{x:.0} {y:.0}");
            let mut before = x;
            loop {
                let end = top(items[lower].floor);
                let is_room = items[lower].room.is_some();
                let x = shift
                    + if is_room {
                        port(items, &items[lower].above, lower, upper)
                    } else {
                        items[lower].x
                    };
                let middle = f64::midpoint(y, end);
                let _ = write!(path, " C{before:.0} {middle:.0} {x:.0} {middle:.0} {x:.0} {end:.0}");
                if is_room {
                    break;
                }
                y = end + HEIGHT;
                let _ = write!(path, " V{y:.0}");
                before = x;
                (upper, lower) = (lower, items[lower].below[0]);
            }
            let _ = writeln!(svg, "<path d=\"{path}\" marker-end=\"url(#tip)\"/>");
        }
    }
    svg.push_str("</g>\n");
    for (item, room) in items.iter().zip(rooms) {
        let (x, y) = (shift + item.x, top(item.floor));
        let _ = writeln!(
            svg,
            "<rect x=\"{:.0}\" y=\"{y:.0}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" rx=\"5\" fill=\"#eef2fa\" stroke=\"#335\"/>\
             <text x=\"{x:.0}\" y=\"{:.0}\" font-size=\"15\" font-weight=\"bold\" fill=\"#112\">{}</text>\
             <text x=\"{x:.0}\" y=\"{:.0}\" font-size=\"12\" fill=\"#445\">{}</text>",
            x - WIDTH / 2.0,
            y + 20.0,
            room.name,
            y + 37.0,
            room.holds
        );
    }
    svg.push_str("</svg>\n");
    svg
}

/// Where an arrow leaves or enters a room: the arrows of one edge stand beside each other, in the order of their other ends.
fn port(items: &[Item], neighbours: &[usize], room: usize, own: usize) -> f64 {
    let x = |item: usize| items[item].x;
    let before = neighbours
        .iter()
        .filter(|other| x(**other) < x(own) || (x(**other) <= x(own) && **other < own))
        .count();
    let step = (WIDTH - 30.0) / number(neighbours.len());
    x(room) + (number(before) + 0.5 - number(neighbours.len()) / 2.0) * step.min(26.0)
}

fn number(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}
