-- The ten crank-rockers with the least peak of the rocker's snap among a million candidates, for a swing of at least 60° and a
-- transmission angle of at least 40°.
select id, round(r2, 4) as r2, round(r3, 4) as r3, round(r4, 4) as r4, turn['theta4_peak_snap'] as peak_snap, degrees(turn['theta4_swing']) as swing
from (
    select *, four_bar_turn(1, r2, r3, r4) as turn
    from (
        select
            value as id,
            candidate(value, 1, 3, 0.1, 1.0) as r2, candidate_log(value, 2, 3, 0.3, 3.0) as r3, candidate_log(value, 3, 3, 0.3, 3.0) as r4
        from range(0, 1000000)
    )
    -- Grashof: the crank is the shortest link, and with the longest no longer than the other two
    where r2 < least(r3, r4) and r2 + greatest(1, r3, r4) <= 1 + r3 + r4 - greatest(1, r3, r4)
)
where turn['rotates'] and turn['min_transmission'] >= radians(40) and turn['theta4_swing'] >= radians(60)
order by peak_snap, id
limit 10;
