# Prints a file that compiles several as one, so that what all of them include and instantiate is compiled once.
# Headers come first; what follows them is in a namespace of each file's own, since files name their helpers as they like.
FNR == 1 { files[++count] = FILENAME }
/^#include/ && !included[$0]++ { print }
END {
  print "namespace continua {}"
  for (i = 1; i <= count; ++i) {
    printf "namespace file_%d {\nnamespace continua {\nusing namespace ::continua;\n}\n", i
    printf "#include \"%s\"\n}\n", files[i]
  }
}
