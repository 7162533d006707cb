// The recordings of a run in a page that has no server (trace/FORMAT.md, media).
#pragma once

#include <cstddef>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/inspector/inspector_api.h"

namespace continua {

/// The most bytes of recordings that are put into a file.
inline constexpr std::size_t most_page_media = std::size_t{64} << 20;

/// How a page has the recordings of its run: their bytes, or links to the files, by their way from the folder that the
/// page will lie in.
struct PageMedia {
  bool embed = false;
  std::string folder = ".";
};

struct MediaInPage {
  std::string answers;   ///< lines as run_answers() gives them; empty without recordings
  std::string elements;  ///< HTML that holds the recordings; empty where they are linked
};

/// The recordings of the run of this id. Errors: a recording cannot be read, or they are too long for one file.
Result<MediaInPage> media_in_page(InspectorApi& api, const std::string& id, const PageMedia& how);

}  // namespace continua
