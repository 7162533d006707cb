// The inspector's page with one run in it, as a file: opened from a disk, it needs no server and loads nothing.
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/inspector/page_media.h"

namespace continua {

/// Writes the page as HTML: its modules, its style, and the inspector's answers about the run (run_answers.h), all
/// compressed. Its policy lets it load and send nothing, but the recordings that it links. `progress` is called with
/// the part that is done. Errors: the log cannot be read, it or the recordings are too long for one file.
Outcome write_page(const std::string& run_path, std::ostream& out,
                   const std::function<void(double done)>& progress = {}, const PageMedia& media = {});

}  // namespace continua
