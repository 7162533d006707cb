// The program at a terminal: exit statuses, messages, files that are written whole.
#pragma once

#include <cstdio>
#include <string>

#include "continua/core/counted.h"
#include "continua/core/result.h"

namespace continua {

/// The status that a command ends the program with.
enum ExitStatus : int {
  exit_done = 0,        ///< it is done; the answer is yes
  exit_no = 1,          ///< it is done; the answer is no
  exit_impossible = 2,  ///< it could not be done
};

/// Writes the text, as far as the stream takes it. The program's end looks whether standard output took all; nobody can
/// be told that standard error did not.
void put(std::FILE* stream, const std::string& text);

/// The text with its control characters in visible form ("\u001b"), but for ends of lines, tabs, and colours: a
/// terminal would obey them.
std::string printable(const std::string& text);

/// The same as one line: a line of its own that a text began may be a command to GitHub.
std::string printable_line(std::string text);

/// "continua: where: sentence" on standard error, on one line.
void report(const Error& error);

/// "continua: warning: where: sentence" likewise; work goes on.
void report_warning(const Error& warning);

/// The word of a verdict in green or, a bad one, in red, where standard output is a terminal and NO_COLOR is not set
/// (no-color.org); otherwise the word.
std::string verdict_word(const std::string& word, bool good);

/// The number of traces replayed at a time: with a file of lessons (`learned`, or empty) one, since each begins with
/// the lessons of the ones before it; a request for another number is told.
int jobs_at_a_time(int jobs, const std::string& learned);

/// Puts a whole file in the place of another. "-" is standard output.
Outcome write_file(const std::string& path, const std::string& content);

}  // namespace continua
