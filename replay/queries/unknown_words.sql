-- Words that the lexicon does not have, most frequent first, with an utterance that has them.
select word, count(*) as times, count(distinct run) as runs, any_value(words) as example
from (select run, words, unnest(from_json(unknown, '["VARCHAR"]')) as word from reading where unknown is not null)
group by word
order by times desc, word;
