#!/usr/bin/env bash
# Prints docs/commands.md: the commands as `--help` describes them. The argument is the program; otherwise build/continua.
#   ci/commands_page.sh > docs/commands.md
# A test compares the page with the program.
set -euo pipefail
program=${1:-$(dirname "$0")/../build/continua}

overview=$("$program" --help)
commands=$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z_-]*\) .*/\1/p' <<< "$overview")

# shellcheck disable=SC2016  # the backquotes are Markdown's
{
  printf '# Commands\n\nThe words of `--help`. `ci/commands_page.sh > docs/commands.md` prints this page anew.\n\n'
  for command in $commands; do
    printf -- '- [`%s`](#%s): %s\n' "$command" "$command" "$(sed -n "s/^  $command  *//p" <<< "$overview" | head -1)"
  done
  sed '1,/^Subcommands:/d' <<< "$overview" | sed -n '/^$/,$p'
  for command in $commands; do
    help=$("$program" "$command" --help)
    printf '\n## %s\n\n```text\n%s\n```\n' "$command" "$help"
    for part in $(sed -n '/^Subcommands:/,/^$/s/^  \([a-z_-]*\) .*/\1/p' <<< "$help"); do
      printf '\n### %s %s\n\n```text\n%s\n```\n' "$command" "$part" "$("$program" "$command" "$part" --help)"
    done
  done
} | sed 's/ *$//'
