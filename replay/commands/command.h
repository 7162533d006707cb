// A subcommand of the program is a file of this folder and a row in program.cpp. The file has
//   struct XOptions                                       everything that its arguments say, with defaults
//   void describe_x(CLI::App& command, XOptions& options) adds its arguments and the last lines of its help
//   int run_x(const XOptions& options)                    does it, once the arguments are read; an ExitStatus
#pragma once

#include "continua/replay/terminal/terminal.h"

namespace CLI {
class App;
}
