#include "support/folders.h"

namespace continua {

std::string source_dir() { return CONTINUA_SOURCE_DIR; }

std::string binary_dir() { return CONTINUA_BINARY_DIR; }

}  // namespace continua
