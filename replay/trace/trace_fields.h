// Reads the fields of one JSON object of a trace and collects their faults.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/world/geometry.h"

namespace continua {

/// The accessors return an empty value for a field that is absent or wrong; the latter adds a problem.
class TraceFields {
 public:
  /// `where` is "file:line"; `what` names the object in sentences ("speech", "word 3 of speech"). REQUIRES that
  /// `object` is a JSON object. It and `problems` must outlive this.
  TraceFields(const Json& object, std::string where, std::string what, std::vector<Error>& problems)
      : object_(object), where_(std::move(where)), what_(std::move(what)), problems_(problems) {}

  /// Nothing if the field is absent.
  const Json* find(const char* name) const;
  bool has(const char* name) const { return find(name) != nullptr; }

  /// Adds a problem unless one of the fields is there; `names` are joined with "or" in the sentence.
  void need(std::initializer_list<const char*> names) const;

  std::string text(const char* name) const;
  /// A text that is one of `choices`, or empty.
  std::string choice(const char* name, const std::vector<std::string>& choices) const;
  bool truth(const char* name, bool otherwise) const;
  std::optional<double> number(const char* name, double least, double most) const;
  std::optional<std::uint64_t> whole_number(const char* name, std::uint64_t most) const;
  /// An array of one finite number or more.
  std::vector<double> numbers(const char* name) const;
  /// An array of `size` numbers between `-most` and `most`; of a 2-vector z is 0.
  std::optional<Vec3> vector(const char* name, int size, double most) const;
  /// The objects of an array; `each` is called with fields and JSON of every one.
  template <class Each>
  void for_each(const char* name, Each each) const {
    const Json* array = array_of_objects(name);
    if (!array) return;
    std::size_t index = 0;
    for (const auto& element : *array)
      each(TraceFields(element, where_, std::string(name) + "/" + std::to_string(index++) + " of " + what_, problems_));
  }

  /// Calls `use` with the fields of an object. REQUIRES that the field is there and an object.
  template <class Use>
  void within(const char* name, Use use) const {
    use(TraceFields(*find(name), where_, std::string(name) + " of " + what_, problems_));
  }

  void problem(const std::string& sentence) const;
  /// "'field' of speech is TEXT; expected …".
  void wrong(const char* name, const std::string& expected) const;

 private:
  const Json* array_of_objects(const char* name) const;

  const Json& object_;
  std::string where_, what_;
  std::vector<Error>& problems_;
};

}  // namespace continua
