// The results of a check as JUnit's XML, which continuous integration reads.
#pragma once

#include <string>
#include <vector>

namespace continua {

struct JunitCase {
  std::string folder, name;
  std::string failure;  ///< one line; empty: it holds
};

std::string junit_xml(const std::string& suite, const std::vector<JunitCase>& cases);

}  // namespace continua
