-- The runs of each version of each machine: how much was refused, asked back and done.
select machine_name, left(machine_digest, 8) as version, count(*) as runs,
       sum((select count(*) from input where input.run = run.run and line is not null)) as inputs,
       sum((select count(*) from refusal where refusal.run = run.run)) as refused,
       sum((select count(*) from utterance where utterance.run = run.run and text like '%?')) as questions,
       sum((select count(*) from act where act.run = run.run and step is null and status = 'asked')) as acts,
       sum((select count(*) from act where act.run = run.run and step is null and status = 'done')) as done
from run
group by all
order by machine_name, version;
