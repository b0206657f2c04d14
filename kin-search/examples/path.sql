-- Hoeken's linkages whose tracer comes nearest to four wanted points. The table of points goes with the query.
create table wanted as select * from (values (0, 4), (1, 4), (2, 4), (4, 4)) as points(x, y);

select id, ground, coupler, error['rms'] as rms, error['largest'] as largest
from (
    select *, hoeken_linkage_path_error('wanted', ground, 1, coupler) as error
    from (select value as id, candidate(value, 1, 2, 1.5, 3) as ground, candidate(value, 2, 2, 2, 3.5) as coupler from range(0, 100000))
)
where error['closed'] = 1
order by rms, id
limit 5;
