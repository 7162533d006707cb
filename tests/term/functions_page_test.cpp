#include <set>

#include "continua/core/located_json.h"
#include "read_terms.h"
#include "support/folders.h"
#include "support/markdown_table.h"

namespace continua {

TEST_CASE("every example of FUNCTIONS.md is true, and every function has one") {
  const auto page = read_file(source_dir() + "/engine/term/FUNCTIONS.md").value();
  std::set<std::string> documented;
  for (const auto& row : table_rows(page, 5)) {
    const auto &name = row[0], &type = row[1], &example = row[3], &value = row[4];
    INFO(name << ": " << example);
    CHECK(documented.insert(name).second);
    REQUIRE(term_signature().contains(name));
    CHECK(term_signature().at(name).text() == type);
    CHECK(value_of(example) == value);
    CHECK(example.find(name == "xyz" ? "<" : name) != std::string::npos);
  }
  std::set<std::string> names;
  for (const auto& [name, type] : term_signature()) names.insert(name);
  CHECK(documented == names);
}

}  // namespace continua
