-- The time from the input to the act that was asked for because of it: how long words waited for a pointing, an answer
-- or a free hand. The input is found by following `cause`.
with recursive way as (
  select run, n as act, program, t as asked, cause from act where status = 'asked' and step is null
  union all
  select way.run, way.act, way.program, way.asked, record.cause
  from way join record on record.run = way.run and record.n = way.cause
  where record.kind <> 'input'
)
select split_part(program, '(', 1) as act, count(*) as times, round(median(asked - input.t), 3) as median_s,
       round(max(asked - input.t), 3) as longest_s
from way join input on input.run = way.run and input.n = way.cause
group by 1
order by times desc, act;
