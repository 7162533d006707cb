// The file of a run log, in any of the forms in which logs are written (RUNLOG.md, Files).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "continua/core/result.h"
#include "continua/replay/log/log_source.h"

namespace continua {

/// The log in a file that stays open. Its bytes are those of the log unpacked, with the documents of its first line in
/// it where these are kept beside it.
Result<std::shared_ptr<const LogSource>> source_of_log(const std::string& path);

/// All bytes of it, piece by piece. Error: it cannot be read to its end, in lines of the log at `path`.
Outcome read_pieces(const LogSource& source, const std::string& path, const std::function<void(std::string_view)>& use);

/// The sentence on a reading that has just given -1, or fewer bytes than were there before.
std::string reading_problem(ssize_t got);

/// The whole log in a file.
Result<std::string> read_run_log(const std::string& path);

/// The first line of a file as it stands there, unpacked, without its end; a line that is longer than any header is
/// cut.
Result<std::string> first_line(const std::string& path);

/// Whether a file of this name may be a run log.
bool is_run_log_name(std::string_view path);

}  // namespace continua
