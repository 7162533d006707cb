#include "continua/machine_file/machine_examples.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/machine_file/machine_keys.h"

namespace continua {
namespace {

std::vector<std::string> split(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const auto end = std::min(text.find(separator, at), text.size());
    if (end > at) parts.emplace_back(text.substr(at, end - at));
    at = end + separator.size();
  }
  return parts;
}

std::vector<std::string> characters(std::string_view text) {
  std::vector<std::string> parts;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (!continues || parts.empty()) parts.emplace_back();
    parts.back() += c;
  }
  return parts;
}

std::optional<WordExample> read_word(const Item& item, const Machine& machine, SymbolReader& symbols) {
  if (!expect_kind(item, "an example with a word")) return std::nullopt;
  const auto word = item.member("word").text("a word");
  WordExample example;
  example.word = word.find(' ') == std::string::npos ? characters(word) : split(word, " ");
  example.accepted = item.required("accepted", "whether it is, true or false").truth(true);
  example.by_empty_stack = item.member("by").one_of({"final_state", "empty_stack"}) == "empty_stack";
  symbols.add_known(example.word);
  const auto strange = std::find_if(example.word.begin(), example.word.end(),
                                    [&](const auto& symbol) { return !machine.knows_input(symbol); });
  if (example.accepted && strange != example.word.end())
    item.member("word").problem(
        fmt::format("an accepted word, but no transition takes its symbol {}", in_quotes(*strange)));
  return example;
}

std::optional<RunExample> read_run(const Item& item, SymbolReader& symbols, StateNames& states) {
  if (!expect_kind(item, "an example")) return std::nullopt;
  RunExample example;
  example.inputs = split(item.required("input", "symbols separated by \", \"").text("symbols"), ", ");
  example.ends = states.named(item.required("ends", "a state")).value_or(0);
  symbols.add_known(example.inputs);
  return example;
}

}  // namespace

std::vector<Example> read_examples(const Item& item, const Machine& machine, SymbolReader& symbols,
                                   StateNames& states) {
  std::vector<Example> examples;
  for (const auto& each : item.elements("the examples")) {
    if (each.member("word").exists()) {
      if (auto example = read_word(each, machine, symbols)) examples.emplace_back(std::move(*example));
    } else if (auto example = read_run(each, symbols, states)) {
      examples.emplace_back(std::move(*example));
    }
  }
  return examples;
}

}  // namespace continua
