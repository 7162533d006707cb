// A JSON document read by a function of its root, for files that are one value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/core/document_reader.h"
#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// The value of the document; `name` stands for the file in errors. Errors: the first problem of the text.
template <class Value>
Result<Value> parsed_document(std::string_view text, const std::string& name, Value (*read)(const Item&)) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  DocumentReader reader;
  auto value = read(reader.root(*document));
  if (!reader.sound()) return reader.problems().front();
  return value;
}

/// All problems of the text.
template <class Value>
std::vector<Error> problems_of_document(std::string_view text, const std::string& name, Value (*read)(const Item&)) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return {document.error()};
  DocumentReader reader;
  (void)read(reader.root(*document));
  return reader.problems();
}

}  // namespace continua
