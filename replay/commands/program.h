// The commands of the program, by their names.
#pragma once

namespace continua {

/// Reads the arguments as the system hands them over and runs the command that they name: an ExitStatus. Arguments that
/// are not understood are told on standard error.
int run_program(int argc, char** argv);

}  // namespace continua
