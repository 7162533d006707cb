# A manual page from what `continua COMMAND --help` prints. Variables: name, version, see.
function literal(text) {
  gsub(/\\/, "\\e", text)
  gsub(/-/, "\\-", text)
  if (text ~ /^[.']/) text = "\\&" text
  return text
}
function section(title) { print ".SH " title }
NR == 1 {
  printf ".TH %s 1 \"\" \"Continua %s\" \"Commands of Continua\"\n", toupper(literal(name)), version
  print ".ad l"
  section("NAME")
  print literal(name) " \\- " literal($0)
  next
}
/^Usage: / { section("SYNOPSIS"); print ".B " literal(substr($0, 8)); next }
/^Positionals:$/ { section("ARGUMENTS"); next }
/^Options:$/ { section("OPTIONS"); next }
/^Subcommands:$/ { section("COMMANDS"); next }
/^\[Option Group: / { section("OPTIONS"); print toupper(substr($0, 16, 1)) literal(substr($0, 17, length($0) - 17)); in_group = 1; next }
in_group && /^  (Options|Positionals):$/ { next }
in_group && /^  \[?[A-Za-z]/ && !/^    / { print ".br\n" literal(substr($0, 3)); next }
!footer && /^$/ { in_group = 0; next }
# The words that describe an option begin in a column of their own, on its line or on the next.
!footer && /^ +[^ ]/ {
  line = substr($0, 3)
  if (line ~ /^                        /) { sub(/^ +/, "", line); print literal(line); next }
  sub(/^ +/, "", line)
  described = match(line, /   +/)
  print ".TP\n.B " literal(described ? substr(line, 1, RSTART - 1) : line)
  if (described) print literal(substr(line, RSTART + RLENGTH))
  next
}
# The rest stays as it is: remarks and examples.
!footer { footer = 1; section("REMARKS"); print ".nf" }
{ print literal($0) }
END {
  if (footer) print ".fi"
  section("SEE ALSO")
  print see
}
