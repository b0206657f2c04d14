-- How the smallest transmission angles of four-bar linkages whose crank goes round are distributed, in steps of 5°.
select
    5 * floor(degrees(turn['min_transmission']) / 5) as from_degrees,
    count(*) as linkages,
    round(avg(degrees(turn['theta4_swing'])), 1) as mean_swing
from (
    select four_bar_turn(1, candidate(value, 1, 3, 0.1, 1), candidate(value, 2, 3, 0.3, 2), candidate(value, 3, 3, 0.3, 2)) as turn
    from range(0, 100000)
)
where turn['rotates']
group by from_degrees
order by from_degrees;
