// The file of a run log, in any of the forms in which logs are written (RUNLOG.md, Files).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "continua/core/result.h"
#include "continua/replay/log/log_source.h"

namespace continua {

/// The log in a file that stays open. Where documents of its first line are kept beside it, its bytes are those of the
/// log with them in it.
Result<std::shared_ptr<const LogSource>> source_of_log(const std::string& path);

/// All bytes of it, piece by piece; false where it cannot be read to its end.
bool read_pieces(const LogSource& source, const std::function<void(std::string_view)>& use);

/// The whole log in a file.
Result<std::string> read_run_log(const std::string& path);

/// The first line of a file as it stands there, without its end; a line that is longer than any header is cut.
Result<std::string> first_line(const std::string& path);

/// Whether a file of this name may be a run log.
bool is_run_log_name(std::string_view path);

}  // namespace continua
