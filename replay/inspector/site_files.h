// The inspector's pages of many runs as a folder of files: opened from a disk or put on any web server, it needs no
// other program.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "continua/core/result.h"

namespace continua {

struct SiteRequest {
  std::vector<std::string> paths;  ///< run logs, or folders of them, as of RunLibrary
  /// Runs to be compared, each by its path, its name or its id. None: each run with the next of the same trace, in
  /// order of names.
  std::vector<std::array<std::string, 2>> pairs = {};
};

struct SiteCounts {
  std::size_t runs = 0, comparisons = 0;
};

/// Writes the site into `folder`, over the files of an earlier one:
///   index.html, assets/   the page, once
///   runs.js, words.js     lines of the start page; what was said, shown and done in each run, for its search
///   schema.js             the kinds of records
///   runs/ID.js            the inspector's answers about a run (run_answers.h)
///   diffs/ID/ID.js        the comparison of two
///   documents/N.js        what several runs may share: machines, lexicons, scenes, each once
/// A browser lets a page from a disk load scripts alone, so each file is a script that hands over its compressed text.
/// The same runs give the same bytes. `progress` is called with the part that is done. Errors: a log cannot be read or
/// is too long for a file, two ids differ only in case, a run of a pair is not among the runs, a file cannot be
/// written.
Result<SiteCounts> write_site(const SiteRequest& request, const std::string& folder,
                              const std::function<void(double done)>& progress = {});

}  // namespace continua
