#!/usr/bin/env bash
# Makes projects by `continua new`, and does in them what their pages say. The program is the first argument.
set -uo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin"
ln -s "$program" "$folder/bin/continua"
PATH=$folder/bin:$PATH
cd "$folder" || exit
failed=0
complain() {
  echo "$1" >&2
  failed=1
}

for options in '' --own-knowledge; do
  name="my study$options"
  continua new "$name" $options > said 2>&1 || { cat said >&2; complain "new $options: status $?"; continue; }
  cd "$name" || exit
  mapfile -t checks < <(sed -n 's/^continua check/&/p' README.md | grep -v approve)
  [[ ${#checks[@]} -gt 0 ]] || complain "$name: its page has no check"
  for check in "${checks[@]}"; do
    $check --no-physics --strict > ../said 2>&1 || { cat ../said >&2; complain "$name: $check: status $?"; }
    grep -q '0 expectations' ../said && complain "$name: its trace expects nothing"
  done
  [[ -f traces/first.run.jsonl && -f .github/workflows/check.yml && -f scenes/table.xml ]] || complain "$name: files are missing"
  grep -rq '@' README.md .github/workflows && grep -rnE '@[A-Z]+@' . && complain "$name: a mark was left"
  cd .. || exit
  # A project can be anywhere.
  mv "$name" moved
  (cd moved && continua check traces --no-physics > /dev/null) || complain "$name: fails where it was moved"
  rm -rf moved
done

# Words of its own, besides those of English.
continua new own > /dev/null 2>&1
continua check own/lexicon/own > said 2>&1 || { cat said >&2; complain 'own words: the lexicon does not hold'; }
continua validate own/lexicon/own/words.json > said 2>&1 || { cat said >&2; complain 'own words: the file is not right'; }
words=$(sed -n 's/^    "\([a-z]*\)": .*/\1/p' own/lexicon/own/words.json)
for machine in machines/own.json interaction; do
  printf '%s\n' "{\"kind\":\"trace\",\"version\":1,\"scene\":\"scenes/table.xml\",\"machine\":\"$machine\"}" \
    "{\"t\":1,\"kind\":\"speech\",\"text\":\"$words\"}" > own/words.trace.jsonl
  continua replay own/words.trace.jsonl --no-physics -o words.run.jsonl > /dev/null
  unknown=$(grep -c '"unknown":\["' words.run.jsonl)
  [[ $unknown == $([[ $machine == interaction ]] && echo 1 || echo 0) ]] || complain "own word $words with $machine: $unknown unknown"
  named=$(grep -c '"lexicon/own/words.json"' words.run.jsonl)
  [[ $named == $([[ $machine == interaction ]] && echo 0 || echo 1) ]] || complain "$machine: the header's digests of knowledge"
done
sed -i 's/"based_on": "english"/"based_on": "englisch"/' own/lexicon/own/words.json
continua validate own/lexicon/own/words.json > said 2>&1
grep -q "words.json:3:15: there is no folder '.*englisch'; expected the name of a lexicon" said || { cat said >&2; complain 'own words based on nothing'; }

continua new own > said 2>&1
[[ $? == 2 ]] && grep -q 'own: exists already; expected the name of a new folder' said || complain 'a folder that is there was not refused'
continua new other --scene none > said 2>&1
[[ $? == 2 && ! -e other ]] || complain 'a scene that is not there was not refused'
exit "$failed"
