// The program at a terminal: exit statuses, messages, files that are written whole.
#pragma once

#include <string>

#include "continua/core/result.h"

namespace continua {

/// The status that a command ends the program with.
enum ExitStatus : int {
  exit_done = 0,        ///< it is done; the answer is yes
  exit_no = 1,          ///< it is done; the answer is no
  exit_impossible = 2,  ///< it could not be done
};

/// "continua: where: sentence" on standard error, on one line.
void report(const Error& error);

/// "continua: warning: where: sentence" likewise: what was found is used all the same.
void report_warning(const Error& warning);

/// "1 event", "2 events".
std::string counted(std::size_t count, const std::string& noun);

/// How many traces are replayed at a time: with a file of what was taught (`learned`, or empty) one, since each begins
/// with what the ones before it taught; that another number was asked for is told.
int jobs_at_a_time(int jobs, const std::string& learned);

/// Writes a whole file. "-" is standard output.
Outcome write_file(const std::string& path, const std::string& content);

}  // namespace continua
