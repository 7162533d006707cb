// Reads the JSON files of the knowledge folder: walks a document, checks its shape and collects every problem with its
// place, so that one run reports all problems of a file.
//
// An Item is a value and its place. Its accessors return the value if the shape is right. If the shape is wrong, they
// note a problem and return an empty value or a default, and reading goes on. An absent item is not a problem here:
// `required` has noted it, or the value may be missing.
//
//   DocumentReader reader;
//   const Item root = reader.root(document);
//   if (root.expect_object("a shop", {"name", "open", "fruit"})) {
//     shop.name = root.required("name", "the shop's name").name("the shop's name");
//     shop.open = root.member("open").truth(true);
//     for (const auto& fruit : root.member("fruit").elements("kinds of fruit"))
//       shop.fruit.push_back(fruit.text("a kind of fruit"));
//   }
//   if (!reader.sound()) return reader.problems().front();
//
// The file {"nam": "Lee", "fruit": ["apple", 7]} gives these problems:
//
//   shop.json:1:1: there is no "name"; expected the shop's name
//   shop.json:1:2: unknown key 'nam' of a shop (did you mean 'name'?)
//   shop.json:1:35: found 7, expected a kind of fruit, a string
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/named_values.h"
#include "continua/core/result.h"

namespace continua {

class DocumentReader;
struct NamedItem;

/// A value of a document and its place there, or the absence of a value. Refers to its document and its reader; both
/// must outlive the item.
///
/// `what` names the expected thing in sentences: "found 7, expected WHAT".
class Item {
 public:
  /// Absent, without a document.
  Item() = default;

  bool exists() const { return json_ != nullptr; }
  /// REQUIRES exists().
  const Json& json() const;
  bool is_text() const { return exists() && json_->is_string(); }
  bool is_list() const { return exists() && json_->is_array(); }
  bool is_object() const { return exists() && json_->is_object(); }
  /// "file:line:column" of the value; for an absent item, of the value that lacks it.
  std::string where() const;

  /// The member `key`; absent if there is none, or if this is not an object.
  Item member(std::string_view key) const;
  /// The member `key`. An absent member is a problem: "there is no "KEY"; expected WHAT".
  Item required(std::string_view key, std::string_view what) const;
  /// The element number `index`, from 0; absent if there is none, or if this is not a list.
  Item element(std::size_t index) const;

  /// The members of an object with any keys, in the order of the file. Another kind of value is a problem.
  std::vector<NamedItem> members(std::string_view what) const;
  /// The elements of a list. Another kind of value is a problem.
  std::vector<Item> elements(std::string_view what) const;

  /// Whether this is an object. Every key that `keys` lacks is a problem, with the nearest of `keys`; so is an "about"
  /// that is not a string.
  bool expect_object(std::string_view what, const std::vector<std::string>& keys) const;
  /// Notes a problem unless the member `key` exists and equals `version`.
  void expect_version(std::string_view key, int version) const;

  /// A string, perhaps empty; empty if absent.
  std::string text(std::string_view what) const;
  /// A string that must not be empty; empty if absent.
  std::string name(std::string_view what) const;
  /// The elements of a list of strings.
  std::vector<std::string> texts(std::string_view what) const;
  /// A number from `least` to `most`, both included; `otherwise` if absent or wrong.
  double number(std::string_view what, double otherwise, double least, double most) const;
  /// A whole number from `least` to `most`, both included; `otherwise` if absent or wrong.
  int whole_number(std::string_view what, int otherwise, int least, int most) const;
  bool truth(bool otherwise) const;
  /// One of `names`; `what` names them in the sentence about a value that is not a string.
  std::optional<std::string> one_of(const std::vector<std::string>& names, std::string_view what) const;
  std::optional<std::string> one_of(const std::vector<std::string>& names) const;
  /// The value for one of the names of the table (core/named_values.h).
  template <class Enum, std::size_t count>
  std::optional<Enum> one_of(const NamedValue<Enum> (&table)[count], std::string_view what) const {
    const auto name = one_of(names_in(table), what);
    return name ? value_in(table, *name) : std::nullopt;
  }

  /// Notes "found VALUE, expected EXPECTED"; false, for `return item.mismatch(…)`. REQUIRES exists().
  bool mismatch(std::string_view expected) const;
  /// Notes a problem of the value; for an absent item, of the value that lacks it.
  void problem(std::string sentence) const;
  /// Notes a problem of the member's key; for an element, of the element.
  void problem_at_key(std::string sentence) const;
  /// Notes a problem of the text, at its byte number `byte`, counted from 0.
  void problem_in_text(std::size_t byte, std::string sentence) const;
  /// Notes the error of a parser of this text, whose place is "column N".
  void problem_in_text(const Error& error) const;
  /// The sentence for a `name` that `known` lacks: "unknown KIND 'NAME' (did you mean 'OTHER'?)".
  std::string unknown(std::string_view kind, std::string_view name, const std::vector<std::string>& known) const;
  /// Whether further problems are no longer noted, so that costly checks are useless.
  bool reader_is_full() const;
  /// The nearest of `known`, in the form of did_you_mean(). Empty once the reader is full.
  std::string nearest(std::string_view name, const std::vector<std::string>& known) const;

 private:
  friend DocumentReader;
  Item(DocumentReader* reader, std::size_t source, const Json* json, std::string pointer)
      : reader_(reader), source_(source), json_(json), pointer_(std::move(pointer)) {}
  const LocatedJson& document() const;

  DocumentReader* reader_ = nullptr;
  std::size_t source_ = 0;  ///< number of the document in the reader
  const Json* json_ = nullptr;
  std::string pointer_;  ///< JSON pointer (RFC 6901) of the value; for an absent item, of the value that lacks it
};

/// A member of an object.
struct NamedItem {
  std::string key;
  Item item;
};

/// Holds the documents under reading, and their problems.
class DocumentReader {
 public:
  /// The most problems that are noted.
  static constexpr std::size_t most_problems = 1000;

  DocumentReader() = default;
  DocumentReader(const DocumentReader&) = delete;  // items refer to their reader
  DocumentReader& operator=(const DocumentReader&) = delete;

  /// The root of a document, which must outlive the reader. Every key that an object has twice is a problem. `remark`
  /// is appended to each sentence about this document.
  Item root(const LocatedJson& document, std::string remark = "");

  /// Whether there are no problems so far.
  bool sound() const { return problems_.empty(); }
  bool full() const { return problems_.size() >= most_problems; }
  /// All problems: document by document in the order of the calls of `root`, each in the order of its text. A problem
  /// that was noted twice is reported once.
  std::vector<Error> problems() const;

 private:
  friend Item;
  void note(std::size_t source, TextPlace place, std::string sentence);

  struct Source {
    const LocatedJson* document;
    std::string remark;
  };
  struct Problem {
    std::size_t source;
    TextPlace place;
    std::string sentence;
  };
  std::vector<Source> sources_;
  std::vector<Problem> problems_;
};

/// "a", "a or b", "a, b or c": the expected names, for a sentence.
std::string any_of(const std::vector<std::string>& names);

/// The byte number N - 1 for the place "column N" of a parser's error. REQUIRES a place of that form.
std::size_t byte_of_column(const Error& error);

}  // namespace continua
