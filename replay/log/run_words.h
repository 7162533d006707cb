// The ids, places, gestures and programs of a run in words that people use: "puts the red block on the orange block".
// Every reader of logs that speaks to people takes them from here; words.json has the words.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// The text of words.json.
std::string_view words_table();

class RunWords {
 public:
  /// The words of a run whose objects have the attributes that its scene's XML gives them.
  explicit RunWords(const RunIndex& run);
  explicit RunWords(std::string_view mjcf);
  /// Words that leave all as the log has it.
  static RunWords raw();

  /// "the red block" for an object's name; of several that look the same with the name behind it. A name that the scene
  /// does not have is shown as it is.
  std::string thing(std::string_view name) const;
  /// Each text of a list, a name or a program, in words.
  Json each(const Json& list) const;
  /// A program, a place or an avatar's gesture: "puts the red block on the orange block". A term that it does not know
  /// is shown as it is. Of a list each element.
  std::string term(std::string_view term) const;
  /// The same of what words mean, whose gaps are left open: "takes …" for "\x. grasp(x)".
  std::string meaning(std::string_view term) const;
  /// A logged point on the table: "26 cm left of the table's middle".
  std::string spot(const Json& point) const;
  /// A logged sentence with things by people's names: "the red block is held already".
  std::string named(std::string_view sentence) const;
  /// The human's gesture of this name: "yes"; `direction` as logged, or empty.
  std::string gesture(std::string_view name, std::string_view direction) const;
  /// The name of an expectation's field: "the avatar says"; and its value as people tell it: “Okay.”, the white cup.
  std::string expectation(std::string_view field) const;
  std::string expected(std::string_view field, const Json& value) const;
  /// Why a thing was ruled out: "not white" for "not white(cup)" of the cup. A reason without words is left as it is.
  std::string reason(std::string_view reason, std::string_view thing) const;
  /// Why an act went otherwise, of its record's line, as named() tells it; empty where the record gives no reason.
  std::string reason_of_act(std::string_view line) const;
  /// A gap of this type: "the place" for `loc`; empty for a type that has no words.
  std::string missing(std::string_view type) const;

  /// The things that have words, by their names.
  const std::map<std::string, std::string, std::less<>>& things() const { return things_; }
  /// All words that may stand for something of the log, in one text.
  std::string all() const;

 private:
  RunWords() = default;
  const std::string* word(const char* list, std::string_view name) const;
  std::string place(std::string_view point) const;
  std::string elements(std::string_view list) const;
  std::string told(std::string_view term, std::string_view about) const;
  std::string argument(std::string_view term, std::string_view about) const;
  // "white cup" for `white(x) and cup(x)`, said of the thing x, and for the property "\x. white(x) and cup(x)".
  std::optional<std::string> about(std::string_view term, std::string_view thing) const;
  std::optional<std::string> joined(const std::vector<std::string_view>& parts, std::string_view thing,
                                    std::string_view joint) const;
  std::optional<std::string> property(std::string_view term) const;

  Json table_;
  std::map<std::string, std::string, std::less<>> things_;
};

}  // namespace continua
