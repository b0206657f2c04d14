-- A straight line at an even speed over half a turn of the crank: four-bar linkages with a tracer on the coupler, against the
-- best of Hoeken's over its two ratios. The crank has the length 1.
--
-- Both are measured in the same way: along and across the chord between the ends of 180° of the crank. The transmission angle
-- is at least 40° on the way, and every link is 0.1 to 10 times as long as the chord. Rows are ordered by value and then id.

-- Hoeken's: 200 000 pairs of ratios
create table hoeken as
select id, ground, coupler, line['length'] as length, line['deviation'] as deviation, line['unevenness'] as unevenness
from (
    select
        id, ground, coupler,
        hoeken_linkage_line(ground, 1, coupler, 'open', 61, 1, pi() / 2, 3 * pi() / 2) as line,
        hoeken_linkage_turn(ground, 1, coupler, 'open', 61, 1, pi() / 2, 3 * pi() / 2) as turn
    from (select value as id, candidate(value, 1, 2, 1.2, 4) as ground, candidate(value, 2, 2, 1, 5) as coupler from range(0, 200000))
    where ground + 1 < 2 * coupler
)
where line['closed'] = 1 and turn['min_transmission'] >= radians(40)
    and least(ground, 1, coupler) >= 0.1 * line['length'] and greatest(ground, 1, coupler) <= 10 * line['length']
order by deviation, id
limit 1;

select * from hoeken;

-- The first round begins at the best of Hoeken's. Each round draws candidates around the 20 best of the one before, in a smaller
-- range, and keeps what is at least as even as Hoeken's.
create table round_0 as
select 0 as id, ground as r1, coupler as r3, coupler as r4, 2 * coupler as x, 0e0 as y, pi() / 2 as start, deviation from hoeken;

create table round_1 as
select id, r1, r3, r4, x, y, start, line['deviation'] as deviation
from (
    select *, traced_four_bar_turn(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi())['min_transmission'] as transmission
    from (
        select *, traced_four_bar_line(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi()) as line
        from (
            select
                ids.value + 1000000 * best.id as id,
                candidate(ids.value, 1, 6, near_r1 - 1.0, near_r1 + 1.0) as r1, candidate(ids.value, 2, 6, near_r3 - 1.0, near_r3 + 1.0) as r3,
                candidate(ids.value, 3, 6, near_r4 - 1.0, near_r4 + 1.0) as r4, candidate(ids.value, 4, 6, near_x - 1.0, near_x + 1.0) as x,
                candidate(ids.value, 5, 6, near_y - 1.0, near_y + 1.0) as y, candidate(ids.value, 6, 6, near_start - 1.0, near_start + 1.0) as start
            from (
                select
                    row_number() over (order by deviation, id) as id,
                    r1 as near_r1, r3 as near_r3, r4 as near_r4, x as near_x, y as near_y, start as near_start
                from round_0
            ) as best
            cross join range(0, 20000) as ids
        )
        where r1 > 1 and r3 > 1 and r4 > 1 and 2 * greatest(r1, r3, r4) <= r1 + r3 + r4 - 1
    )
    where line['closed'] = 1 and line['unevenness'] <= (select unevenness from hoeken)
        and least(r1, 1, r3, r4) >= 0.1 * line['length'] and greatest(r1, r3, r4) <= 10 * line['length']
)
where transmission >= radians(40)
order by deviation, id
limit 20;

create table round_2 as
select id, r1, r3, r4, x, y, start, line['deviation'] as deviation
from (
    select *, traced_four_bar_turn(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi())['min_transmission'] as transmission
    from (
        select *, traced_four_bar_line(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi()) as line
        from (
            select
                ids.value + 1000000 * best.id as id,
                candidate(ids.value, 1, 6, near_r1 - 0.7, near_r1 + 0.7) as r1, candidate(ids.value, 2, 6, near_r3 - 0.7, near_r3 + 0.7) as r3,
                candidate(ids.value, 3, 6, near_r4 - 0.7, near_r4 + 0.7) as r4, candidate(ids.value, 4, 6, near_x - 0.7, near_x + 0.7) as x,
                candidate(ids.value, 5, 6, near_y - 0.7, near_y + 0.7) as y, candidate(ids.value, 6, 6, near_start - 0.7, near_start + 0.7) as start
            from (
                select
                    row_number() over (order by deviation, id) as id,
                    r1 as near_r1, r3 as near_r3, r4 as near_r4, x as near_x, y as near_y, start as near_start
                from round_1
            ) as best
            cross join range(0, 20000) as ids
        )
        where r1 > 1 and r3 > 1 and r4 > 1 and 2 * greatest(r1, r3, r4) <= r1 + r3 + r4 - 1
    )
    where line['closed'] = 1 and line['unevenness'] <= (select unevenness from hoeken)
        and least(r1, 1, r3, r4) >= 0.1 * line['length'] and greatest(r1, r3, r4) <= 10 * line['length']
)
where transmission >= radians(40)
order by deviation, id
limit 20;

create table round_3 as
select id, r1, r3, r4, x, y, start, line['deviation'] as deviation
from (
    select *, traced_four_bar_turn(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi())['min_transmission'] as transmission
    from (
        select *, traced_four_bar_line(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi()) as line
        from (
            select
                ids.value + 1000000 * best.id as id,
                candidate(ids.value, 1, 6, near_r1 - 0.5, near_r1 + 0.5) as r1, candidate(ids.value, 2, 6, near_r3 - 0.5, near_r3 + 0.5) as r3,
                candidate(ids.value, 3, 6, near_r4 - 0.5, near_r4 + 0.5) as r4, candidate(ids.value, 4, 6, near_x - 0.5, near_x + 0.5) as x,
                candidate(ids.value, 5, 6, near_y - 0.5, near_y + 0.5) as y, candidate(ids.value, 6, 6, near_start - 0.5, near_start + 0.5) as start
            from (
                select
                    row_number() over (order by deviation, id) as id,
                    r1 as near_r1, r3 as near_r3, r4 as near_r4, x as near_x, y as near_y, start as near_start
                from round_2
            ) as best
            cross join range(0, 20000) as ids
        )
        where r1 > 1 and r3 > 1 and r4 > 1 and 2 * greatest(r1, r3, r4) <= r1 + r3 + r4 - 1
    )
    where line['closed'] = 1 and line['unevenness'] <= (select unevenness from hoeken)
        and least(r1, 1, r3, r4) >= 0.1 * line['length'] and greatest(r1, r3, r4) <= 10 * line['length']
)
where transmission >= radians(40)
order by deviation, id
limit 20;

create table round_4 as
select id, r1, r3, r4, x, y, start, line['deviation'] as deviation
from (
    select *, traced_four_bar_turn(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi())['min_transmission'] as transmission
    from (
        select *, traced_four_bar_line(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi()) as line
        from (
            select
                ids.value + 1000000 * best.id as id,
                candidate(ids.value, 1, 6, near_r1 - 0.3, near_r1 + 0.3) as r1, candidate(ids.value, 2, 6, near_r3 - 0.3, near_r3 + 0.3) as r3,
                candidate(ids.value, 3, 6, near_r4 - 0.3, near_r4 + 0.3) as r4, candidate(ids.value, 4, 6, near_x - 0.3, near_x + 0.3) as x,
                candidate(ids.value, 5, 6, near_y - 0.3, near_y + 0.3) as y, candidate(ids.value, 6, 6, near_start - 0.3, near_start + 0.3) as start
            from (
                select
                    row_number() over (order by deviation, id) as id,
                    r1 as near_r1, r3 as near_r3, r4 as near_r4, x as near_x, y as near_y, start as near_start
                from round_3
            ) as best
            cross join range(0, 20000) as ids
        )
        where r1 > 1 and r3 > 1 and r4 > 1 and 2 * greatest(r1, r3, r4) <= r1 + r3 + r4 - 1
    )
    where line['closed'] = 1 and line['unevenness'] <= (select unevenness from hoeken)
        and least(r1, 1, r3, r4) >= 0.1 * line['length'] and greatest(r1, r3, r4) <= 10 * line['length']
)
where transmission >= radians(40)
order by deviation, id
limit 20;

create table round_5 as
select id, r1, r3, r4, x, y, start, line['deviation'] as deviation
from (
    select *, traced_four_bar_turn(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi())['min_transmission'] as transmission
    from (
        select *, traced_four_bar_line(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi()) as line
        from (
            select
                ids.value + 1000000 * best.id as id,
                candidate(ids.value, 1, 6, near_r1 - 0.15, near_r1 + 0.15) as r1, candidate(ids.value, 2, 6, near_r3 - 0.15, near_r3 + 0.15) as r3,
                candidate(ids.value, 3, 6, near_r4 - 0.15, near_r4 + 0.15) as r4, candidate(ids.value, 4, 6, near_x - 0.15, near_x + 0.15) as x,
                candidate(ids.value, 5, 6, near_y - 0.15, near_y + 0.15) as y, candidate(ids.value, 6, 6, near_start - 0.15, near_start + 0.15) as start
            from (
                select
                    row_number() over (order by deviation, id) as id,
                    r1 as near_r1, r3 as near_r3, r4 as near_r4, x as near_x, y as near_y, start as near_start
                from round_4
            ) as best
            cross join range(0, 20000) as ids
        )
        where r1 > 1 and r3 > 1 and r4 > 1 and 2 * greatest(r1, r3, r4) <= r1 + r3 + r4 - 1
    )
    where line['closed'] = 1 and line['unevenness'] <= (select unevenness from hoeken)
        and least(r1, 1, r3, r4) >= 0.1 * line['length'] and greatest(r1, r3, r4) <= 10 * line['length']
)
where transmission >= radians(40)
order by deviation, id
limit 20;

create table round_6 as
select id, r1, r3, r4, x, y, start, line['deviation'] as deviation
from (
    select *, traced_four_bar_turn(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi())['min_transmission'] as transmission
    from (
        select *, traced_four_bar_line(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi()) as line
        from (
            select
                ids.value + 1000000 * best.id as id,
                candidate(ids.value, 1, 6, near_r1 - 0.07, near_r1 + 0.07) as r1, candidate(ids.value, 2, 6, near_r3 - 0.07, near_r3 + 0.07) as r3,
                candidate(ids.value, 3, 6, near_r4 - 0.07, near_r4 + 0.07) as r4, candidate(ids.value, 4, 6, near_x - 0.07, near_x + 0.07) as x,
                candidate(ids.value, 5, 6, near_y - 0.07, near_y + 0.07) as y, candidate(ids.value, 6, 6, near_start - 0.07, near_start + 0.07) as start
            from (
                select
                    row_number() over (order by deviation, id) as id,
                    r1 as near_r1, r3 as near_r3, r4 as near_r4, x as near_x, y as near_y, start as near_start
                from round_5
            ) as best
            cross join range(0, 20000) as ids
        )
        where r1 > 1 and r3 > 1 and r4 > 1 and 2 * greatest(r1, r3, r4) <= r1 + r3 + r4 - 1
    )
    where line['closed'] = 1 and line['unevenness'] <= (select unevenness from hoeken)
        and least(r1, 1, r3, r4) >= 0.1 * line['length'] and greatest(r1, r3, r4) <= 10 * line['length']
)
where transmission >= radians(40)
order by deviation, id
limit 20;

create table round_7 as
select id, r1, r3, r4, x, y, start, line['deviation'] as deviation
from (
    select *, traced_four_bar_turn(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi())['min_transmission'] as transmission
    from (
        select *, traced_four_bar_line(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi()) as line
        from (
            select
                ids.value + 1000000 * best.id as id,
                candidate(ids.value, 1, 6, near_r1 - 0.03, near_r1 + 0.03) as r1, candidate(ids.value, 2, 6, near_r3 - 0.03, near_r3 + 0.03) as r3,
                candidate(ids.value, 3, 6, near_r4 - 0.03, near_r4 + 0.03) as r4, candidate(ids.value, 4, 6, near_x - 0.03, near_x + 0.03) as x,
                candidate(ids.value, 5, 6, near_y - 0.03, near_y + 0.03) as y, candidate(ids.value, 6, 6, near_start - 0.03, near_start + 0.03) as start
            from (
                select
                    row_number() over (order by deviation, id) as id,
                    r1 as near_r1, r3 as near_r3, r4 as near_r4, x as near_x, y as near_y, start as near_start
                from round_6
            ) as best
            cross join range(0, 20000) as ids
        )
        where r1 > 1 and r3 > 1 and r4 > 1 and 2 * greatest(r1, r3, r4) <= r1 + r3 + r4 - 1
    )
    where line['closed'] = 1 and line['unevenness'] <= (select unevenness from hoeken)
        and least(r1, 1, r3, r4) >= 0.1 * line['length'] and greatest(r1, r3, r4) <= 10 * line['length']
)
where transmission >= radians(40)
order by deviation, id
limit 20;

create table round_8 as
select id, r1, r3, r4, x, y, start, line['deviation'] as deviation
from (
    select *, traced_four_bar_turn(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi())['min_transmission'] as transmission
    from (
        select *, traced_four_bar_line(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 61, 1, start, start + pi()) as line
        from (
            select
                ids.value + 1000000 * best.id as id,
                candidate(ids.value, 1, 6, near_r1 - 0.01, near_r1 + 0.01) as r1, candidate(ids.value, 2, 6, near_r3 - 0.01, near_r3 + 0.01) as r3,
                candidate(ids.value, 3, 6, near_r4 - 0.01, near_r4 + 0.01) as r4, candidate(ids.value, 4, 6, near_x - 0.01, near_x + 0.01) as x,
                candidate(ids.value, 5, 6, near_y - 0.01, near_y + 0.01) as y, candidate(ids.value, 6, 6, near_start - 0.01, near_start + 0.01) as start
            from (
                select
                    row_number() over (order by deviation, id) as id,
                    r1 as near_r1, r3 as near_r3, r4 as near_r4, x as near_x, y as near_y, start as near_start
                from round_7
            ) as best
            cross join range(0, 20000) as ids
        )
        where r1 > 1 and r3 > 1 and r4 > 1 and 2 * greatest(r1, r3, r4) <= r1 + r3 + r4 - 1
    )
    where line['closed'] = 1 and line['unevenness'] <= (select unevenness from hoeken)
        and least(r1, 1, r3, r4) >= 0.1 * line['length'] and greatest(r1, r3, r4) <= 10 * line['length']
)
where transmission >= radians(40)
order by deviation, id
limit 20;

-- the best of all, beside Hoeken's, which is such a linkage too: measured again, at 3601 poses instead of 61
create table linkages as
select 'searched' as found, * from round_8
union all
select 'Hoeken' as found, * from round_0;

select
    'traced_four_bar' as mechanism, id, found, r1, 1e0 as r2, r3, r4, x as point_x, y as point_y, 0e0 as turn, 0e0 as pivot_x, 0e0 as pivot_y,
    'open' as assembly, start, line['length'] as length, line['deviation'] as deviation, line['unevenness'] as unevenness,
    degrees(half['min_transmission']) as transmission
from (
    select
        *,
        traced_four_bar_line(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 3601, 1, start, start + pi()) as line,
        traced_four_bar_turn(r1, 1, r3, r4, x, y, 0, 0, 0, 'open', 3601, 1, start, start + pi()) as half
    from linkages
)
where found = 'Hoeken' or id in (select id from round_8 order by deviation, id limit 5)
order by deviation, id;
