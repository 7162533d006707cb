// The program `continua` as a process: its memory, its standard streams, and the status that it ends with.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>

#include "continua/replay/commands/command.h"
#include "continua/replay/commands/program.h"

namespace {

// A file that is opened while one of the three is closed would take its place, and get what is meant for a terminal.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", stream == STDIN_FILENO ? O_RDONLY : O_WRONLY) < 0) return;
}

// Much of what commands print is still in memory when they are done.
int with_all_printed(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  continua::report({"standard output", "could not be written to its end"});
  return continua::exit_impossible;
}

}  // namespace

// jemalloc reads this: large pages. The knowledge takes some 70 MB, for which the system else hands out 18,000 small
// ones.
extern "C" {
__attribute__((visibility("default"))) const char* malloc_conf = "thp:always";
}

int main(int argc, char** argv) {
  open_standard_streams();
  try {
    return with_all_printed(continua::run_program(argc, argv));
  } catch (const std::bad_alloc&) {
    continua::report({"", "it takes more memory than there is"});
    return continua::exit_impossible;
  } catch (const std::exception& problem) {  // a file system that fails in mid-walk
    continua::report({"", problem.what()});
    return continua::exit_impossible;
  }
}
