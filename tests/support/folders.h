// The project's folders, for tests that read its files. They are told by functions of one source, so that a compiler
// cache holds all others for every checkout.
#pragma once
#include <string>

namespace continua {

// The folder that has engine/, traces/ and tests/; absolute, without a slash at its end.
std::string source_dir();

// The folder of this build; absolute, without a slash at its end.
std::string binary_dir();

}  // namespace continua
