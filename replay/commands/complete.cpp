#include "continua/replay/commands/complete.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

/// The values that an option or a positional takes: names of the data, and files with an ending ("" is any).
struct Kind {
  std::string_view name;
  const char *folder = "", *extension = "";  ///< of the data; a folder's own names without extension
  std::string_view ending = "";
};

constexpr Kind kinds[] = {
    {"MACHINE", "machines", ".json", ".json"},
    {"machine", "machines", ".json", ".json"},
    {"scene", "scenes", ".xml", ".xml"},
    {"language", "lexicon", "", "/"},
    {"TRACE", "", "", trace_ending},
    {"RUN", "", "", ".run.jsonl"},
    {"A", "", "", ".jsonl"},
    {"B", "", "", ".jsonl"},
};

std::vector<std::string> names_of(const Kind& kind) {
  const auto data = find_data_paths();
  const std::string_view folder = kind.folder;
  if (!data || folder.empty()) return {};
  if (folder == "scenes") return names_in(data->mjcf / folder, kind.extension);
  return names_in(data->knowledge / folder, kind.extension);
}

bool hidden(std::string_view name) { return name.starts_with('.'); }

// Files below the folder that `typed` begins with; folders always, since what is wanted may be in them.
void add_files(const std::string& typed, std::string_view ending, std::vector<Completion>& found) {
  const auto cut = typed.rfind('/') + 1;  // 0 without one
  const auto folder = typed.substr(0, cut), begin = typed.substr(cut);
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, problem)) {
    const auto name = entry.path().filename().string();
    if (!name.starts_with(begin) || (hidden(name) && !hidden(begin))) continue;
    const bool is_folder_too = is_folder(entry.path());
    if (is_folder_too || name.ends_with(ending)) found.push_back({folder + name + (is_folder_too ? "/" : ""), ""});
  }
}

// "TEXT:{free,world,teacher}" names all values.
std::vector<std::string> listed_values(const std::string& type) {
  const auto open = type.find('{'), close = type.rfind('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

std::string short_text(const std::string& text) { return text.substr(0, text.find('\n')); }

void add_values(const CLI::Option& option, const std::string& typed, std::vector<Completion>& found) {
  const auto type = option.get_type_name();
  const auto add = [&](const std::vector<std::string>& words) {
    for (const auto& word : words)
      if (word.starts_with(typed)) found.push_back({word, ""});
  };
  if (const auto listed = listed_values(type); !listed.empty()) return add(listed);
  if (!type.starts_with("TEXT") && !option.get_positional()) return;
  const auto name = option.get_positional()       ? option.get_name()
                    : option.get_lnames().empty() ? ""
                                                  : option.get_lnames()[0];
  const auto* kind =
      std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& one) { return one.name == name; });
  if (kind == std::end(kinds)) return add_files(typed, "", found);
  add(names_of(*kind));
  add_files(typed, kind->ending, found);
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

const CLI::Option* option_named(const CLI::App& command, const std::string& word) {
  for (const auto* option : command.get_options())
    if (!option->get_positional() && option->check_name(word)) return option;
  return nullptr;
}

// The positional that argument number `index` belongs to; null if there are fewer.
const CLI::Option* positional_at(const CLI::App& command, std::size_t index) {
  const CLI::Option* last = nullptr;
  for (const auto* option : command.get_options()) {
    if (!option->get_positional()) continue;
    last = option;
    if (index-- == 0) return last;
  }
  return last && last->get_items_expected_max() > 1 ? last : nullptr;
}

void add_options(const CLI::App& command, const std::string& typed, std::vector<Completion>& found) {
  for (const auto* option : command.get_options())
    for (const auto& name : option->get_lnames())
      if (("--" + name).starts_with(typed)) found.push_back({"--" + name, short_text(option->get_description())});
}

void add_of_command(const CLI::App& command, const std::vector<std::string>& before, const std::string& typed,
                    std::vector<Completion>& found) {
  const CLI::Option* waits = nullptr;
  std::size_t arguments = 0;
  for (const auto& word : before) {
    if (waits) {
      waits = nullptr;
    } else if (word.starts_with('-')) {
      const auto* option = option_named(command, word);
      if (option && takes_value(*option)) waits = option;
    } else {
      ++arguments;
    }
  }
  if (waits) return add_values(*waits, typed, found);
  if (const auto equals = typed.find('='); typed.starts_with("--") && equals != std::string::npos) {
    const auto* option = option_named(command, typed.substr(0, equals));
    if (option && takes_value(*option)) add_values(*option, typed.substr(equals + 1), found);
    for (auto& one : found) one.word = typed.substr(0, equals + 1) + one.word;
    return;
  }
  if (typed.starts_with('-')) return add_options(command, typed, found);
  if (const auto* positional = positional_at(command, arguments)) return add_values(*positional, typed, found);
}

}  // namespace

std::vector<Completion> completions(const CLI::App& program, std::vector<std::string> words) {
  // Bash makes three words of --option=value.
  if (!words.empty() && words.back() == "=") words.back().clear();
  words.erase(std::remove(words.begin(), words.end(), "="), words.end());
  const std::string typed = words.empty() ? "" : words.back();
  if (!words.empty()) words.pop_back();

  std::vector<Completion> found;
  if (words.empty() && typed.starts_with('-')) add_options(program, typed, found);
  for (const auto* command : program.get_subcommands({})) {
    const auto& name = command->get_name();
    if (words.empty() && name.starts_with(typed)) found.push_back({name, command->get_description()});
    if (!words.empty() && name == words.front())
      add_of_command(*command, {words.begin() + 1, words.end()}, typed, found);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

int run_complete(const CompleteOptions& options) {
  std::string lines;
  for (const auto& [word, meaning] : completions(*options.program, options.words)) {
    if (word.find('\n') != std::string::npos) continue;
    lines += word + (meaning.empty() ? "" : "\t" + meaning) + "\n";
  }
  put(stdout, lines);
  return exit_done;
}

void describe_complete(CLI::App& command, CompleteOptions& options) {
  options.program = command.get_parent();
  // As in accept: all words stay in order among the remaining arguments.
  command.add_option("WORD", options.words, "of the line after 'continua', the last as far as it is typed")
      ->check([](const std::string&) { return std::string("remains"); });
  command.validate_positionals();
  command.allow_extras();
  command.footer(
      "An installation has the files by which bash, zsh and fish ask. For bash without one:\n"
      "source ci/packaging/completions/continua.bash\n"
      "Example: continua complete -- replay --machine pal");
  command.callback([&command, &options] {
    options.words = command.remaining();
    const auto mark = std::find(options.words.begin(), options.words.end(), "--");
    if (mark != options.words.end()) options.words.erase(options.words.begin(), mark + 1);
  });
}

}  // namespace continua
