-- The inputs that machines refused most often, with the state they were in and the number of runs.
select state, input, count(*) as times, count(distinct run) as runs, any_value(reason) as reason
from refusal
group by state, input
order by times desc, state, input
limit 20;
