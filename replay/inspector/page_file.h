// The inspector's page with one run in it, as a file: opened from a disk, it needs no server and loads nothing.
#pragma once

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>

#include "continua/core/result.h"

namespace continua {

/// The longest log, in bytes, that is put into a file.
inline constexpr std::size_t most_page_log = std::size_t{64} << 20;

/// Writes the page as HTML: its modules, its style, and the inspector's answers (inspector_api.h) about the run, all
/// compressed; why something is so is told of the records worth stopping at (run_stops.h). Its policy lets it load and
/// send nothing. `progress` is called with the part that is done. Errors: the log cannot be read, or is too long for
/// one file.
Outcome write_page(const std::string& run_path, std::ostream& out,
                   const std::function<void(double done)>& progress = {});

}  // namespace continua
