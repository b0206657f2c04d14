-- The wipers that sweep 90 to 110 degrees with the least angular acceleration: run with --mechanism examples/wiper.kin.
select id, crank, rod, lever, degrees(turn['psi_swing']) as sweep, turn['psi_peak_acceleration'] as acceleration,
       degrees(turn['min_transmission']) as transmission
from (select *, wiper_turn(crank, rod, lever, 100, 500) as turn
      from (select value as id, candidate(value, 1, 3, 15, 60) as crank, candidate(value, 2, 3, 50, 150) as rod,
                   candidate(value, 3, 3, 20, 90) as lever
            from range(0, 200000)))
where turn['rotates'] and degrees(turn['psi_swing']) between 90 and 110 and degrees(turn['min_transmission']) > 35
order by acceleration, id
limit 5;
