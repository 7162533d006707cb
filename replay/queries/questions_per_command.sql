-- Questions that the avatar asked for each act that it was then asked to do, run by run.
with asked as (select run, count(*) as questions from utterance where text like '%?' group by run),
     done as (select run, count(*) as acts from act where status = 'asked' and step is null group by run)
select run.run, coalesce(questions, 0) as questions, coalesce(acts, 0) as acts,
       round(coalesce(questions, 0) / nullif(acts, 0), 2) as questions_per_act
from run left join asked using (run) left join done using (run)
order by questions_per_act desc nulls last, run.run;
