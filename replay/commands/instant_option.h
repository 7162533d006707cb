// Instants on the command line, in seconds or as the program tells them.
#pragma once

namespace CLI {
class Option;
}

namespace continua {

/// Lets an option of seconds take an instant as it is told, too: "1:04.5" is 64.5.
CLI::Option* takes_instants(CLI::Option* option);

}  // namespace continua
