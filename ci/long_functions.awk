# Prints functions over `limit` lines. Relies on the layout that the formatters make: a block ends at the first line that
# is indented no deeper than the line that opens it.
function indent(line) {
  match(line, /^ */)
  return RLENGTH
}
# Whether a function begins: in C++ a "{" after its parameters, in JavaScript also an arrow before what it gives.
function opens(line) {
  if (line ~ /^ *(export )?(default )?(namespace|class|struct|enum|union|extern)[ :]/ || line ~ /^ *template.*(class|struct) /) return 0
  if (line ~ /^ *([}] )?(if|else|for|while|switch|do|try|catch)[ (]/) return 0
  if (FILENAME ~ /\.m?js$/) return line ~ /=>[ ({[]*$/ || line ~ /=> .*[({[]$/ || line ~ /[)] [{]$/
  return line ~ /[])a-z}] [{]$/ && line !~ /[=,] *[{]$/
}
FNR == 1 { depth = 0 }
/^[ \t]*$/ { next }
{
  here = indent($0)
  while (depth && here <= at[depth]) {
    length_of = (/^ *[]})]/ ? FNR : last) - first[depth] + 1
    if (length_of > limit) print FILENAME ":" first[depth] ": a function of " length_of " lines; expected at most " limit
    --depth
    if (/^ *[]})]/) break
  }
  last = FNR
  if (opens($0)) {
    at[++depth] = here
    first[depth] = FNR
  }
}
