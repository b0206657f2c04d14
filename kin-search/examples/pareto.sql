-- The Pareto front of crank-rockers, swing against the peak of the rocker's acceleration: no other candidate has more swing and a
-- lower peak. In the order of falling swing, a row is on the front if its peak is lower than that of all rows before it.
select id, swing, peak
from (
    select *, min(peak) over (order by swing desc, id rows between unbounded preceding and 1 preceding) as lowest_before
    from (
        select id, turn['theta4_swing'] as swing, turn['theta4_peak_acceleration'] as peak
        from (
            select value as id, four_bar_turn(1, candidate(value, 1, 3, 0.1, 1), candidate(value, 2, 3, 0.3, 2), candidate(value, 3, 3, 0.3, 2)) as turn
            from range(0, 200000)
        )
        where turn['rotates'] and turn['min_transmission'] >= radians(40)
    )
)
where lowest_before is null or peak < lowest_before
order by swing desc, id;
