// Readers of the JSON that recognisers write: whole values, one after the other.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "continua/core/located_json.h"
#include "continua/replay/recogniser/recogniser_output.h"

namespace continua {

/// Reads each object, or each object of a list.
class JsonReader : public RecogniserReader {
 public:
  using RecogniserReader::RecogniserReader;
  void read(const OutputPart& part, Recognised& gain) final;

 protected:
  /// `line`: on which the object's part begins.
  virtual void read_object(const Json& object, std::size_t line, Recognised& gain) = 0;
};

/// A number of an object, if it is there.
std::optional<double> number_of(const Json& object, const char* member);

/// The member by its name in one notation ("categoryName"), else by that in the other ("category_name").
const Json& either_member(const Json& object, const char* name, const char* other);

/// The words of a recogniser without blanks around them.
std::string trimmed_words(std::string_view text);

/// "file:line: expected WHAT" for a part that lacks something.
Error lacks(const std::string& name, std::size_t line, const std::string& expected);

}  // namespace continua
