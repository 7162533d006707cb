// The examples of a machine file: inputs with the state they lead to, words that are accepted or not.
#include <algorithm>

#include <fmt/format.h>

#include "machine_file/machine_reader.h"

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

}  // namespace

void MachineReader::read_examples(const Item& examples) {
  if (!examples.json || !expect_array(examples, "the examples")) return;
  for (std::size_t i = 0; i < examples.json->size(); ++i) read_example(element(examples, i));
}

void MachineReader::read_example(const Item& example) {
  if (member(example, "word").json) {
    if (!expect_object(example, "an example with a word")) return;
    const auto word = text_of(member(example, "word"), "a word");
    WordExample read;
    read.word = word.find(' ') == std::string::npos ? characters(word) : split(word, " ");
    read.accepted = truth_of(required(example, "accepted", "whether it is, true or false"), true);
    read.by_empty_stack = one_of(example, "by", {"final_state", "empty_stack"}) == "empty_stack";
    known_symbols_.insert(read.word.begin(), read.word.end());
    const auto strange = std::find_if(read.word.begin(), read.word.end(),
                                      [&](const auto& symbol) { return !machine_.knows_input(symbol); });
    if (read.accepted && strange != read.word.end())
      problem(member(example, "word"),
              fmt::format("an accepted word, but no transition takes its symbol {}", in_quotes(*strange)));
    machine_.examples.push_back(std::move(read));
  } else {
    if (!expect_object(example, "an example")) return;
    RunExample read;
    read.inputs = split(text_of(required(example, "input", "symbols separated by \", \""), "symbols"), ", ");
    if (const auto ends = required(example, "ends", "a state"); ends.json) read.ends = state_named(ends);
    known_symbols_.insert(read.inputs.begin(), read.inputs.end());
    machine_.examples.push_back(std::move(read));
  }
}

}  // namespace continua
