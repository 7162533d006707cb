// The readers of everything that comes from outside, each as a function of bytes. Whatever the bytes are, a reader
// returns: with a value or with an error. README.md says how they are attacked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace continua {

struct FuzzTarget {
  std::string name;
  void (*read)(std::string_view bytes);
  std::string folder, ending;                    ///< of its seeds: files of the sources, at any depth
  std::vector<std::string> (*made)() = nullptr;  ///< seeds that are made
  std::string schema = {};                       ///< the file of the sources that has the names in its files
};

const std::vector<FuzzTarget>& fuzz_targets();

/// The target of that name; null if there is none.
const FuzzTarget* fuzz_target(std::string_view name);

/// The seeds of a target in the order of their names, and its rows of tests/corpus. Longer files are left out.
std::vector<std::string> fuzz_seeds(const FuzzTarget& target);

/// The words of a target's schema and seeds, those that come most often first; at most 400.
std::vector<std::string> fuzz_words(const FuzzTarget& target);

}  // namespace continua
