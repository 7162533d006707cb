// Reads a file of gestures: notes every problem with its place, and goes on.
#pragma once

#include <string>
#include <vector>

#include "core/located_json.h"
#include "perception/gesture.h"

namespace continua {

class GestureReader {
 public:
  explicit GestureReader(const LocatedJson& document) : document_(document) {}

  GestureCatalogue read();
  /// In the order of the file.
  std::vector<Error> problems();

 private:
  void read_entry(const std::string& names, const std::string& pointer, const Json& json);
  void read_meanings(GestureEntry& entry, const std::string& pointer, const Json& json);
  void read_example(const std::string& pointer, const Json& json);

  // Where a shape is wrong each notes a problem, and gives what is empty.
  bool expect_object(const std::string& pointer, const Json& json, const char* what,
                     const std::vector<std::string>& keys);
  std::string text_of(const std::string& pointer, const Json& json, const std::string& key, const char* what);
  std::vector<std::string> phases_of(const std::string& pointer, const Json& json);
  void expect_one_of(const std::string& pointer, const std::string& found, const std::vector<std::string>& known);
  void mismatch(const std::string& pointer, const Json& json, const std::string& expected);
  void problem(TextPlace place, std::string sentence);

  struct Problem {
    TextPlace place;
    std::string sentence;
  };
  std::vector<Problem> problems_;
  const LocatedJson& document_;
  GestureCatalogue catalogue_;
};

}  // namespace continua
