// Large members of run logs' first lines, kept once in a folder `documents` for all logs beside it and below
// (RUNLOG.md, Kept documents).
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "continua/core/result.h"

namespace continua {

/// A first line without its large members, and these, by their digests.
struct LeanHeader {
  std::string line;
  std::map<std::string, std::string> documents;
};

/// `header`: the first line of a log, without the line's end. Documents that it refers to stay referred to.
LeanHeader without_documents(std::string_view header);

/// The first line as the whole log has it. `path`: of the log, for documents are looked for in the folders from there
/// up. An error if one of them is missing or is not what its name says.
Result<std::string> with_documents(std::string_view header, const std::string& path);

/// Whether it is the path of such a document: documents/DIGEST.json.
bool is_kept_document(const std::string& path);

/// Nothing if `text` is the content that the document's name stands for.
Outcome kept_document_problem(std::string_view text, const std::string& path);

/// The nearest folder `documents`, from the folder of `path` upwards, with nothing but kept documents in it.
std::optional<std::string> documents_above(const std::string& path);

/// Puts the documents into the folder, which is made if it is not there.
Outcome keep_documents(const LeanHeader& header, const std::string& folder);

/// Removes the documents in `folder` that no log beside the folder or below that place refers to. Gives their number.
Result<std::size_t> remove_unused_documents(const std::string& folder);

}  // namespace continua
