#include "continua/replay/check/check_approval.h"

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "continua/replay/diff/run_diff_text.h"
#include "continua/replay/log/kept_documents.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t lines_shown = 14;

bool is_open(const CheckOptions& options, const TraceCheck& check) {
  return can_be_approved(check.verdict) || (options.strict && check.verdict == Verdict::same_decisions);
}

std::string first_lines(std::string_view text) {
  std::string lines;
  for (std::size_t shown = 0; !text.empty(); ++shown) {
    if (shown == lines_shown) return lines + "    …\n";
    const auto length = std::min(text.find('\n'), text.size());
    lines += length == 0 ? "\n" : fmt::format("    {}\n", text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return lines;
}

// The diff begins with its sentence.
void show(const CheckCase& one, const TraceCheck& check) {
  const auto& compared = check.compared;
  fmt::print("\n{}\n", printable_line(one.path + ": " + (compared ? one.verdict : one.sentence)));
  if (compared) fmt::print("{}", printable(first_lines(diff_text(compared->approved, compared->run, compared->diff))));
}

bool answers_yes() {
  std::string answer;
  return std::getline(std::cin, answer) && (answer == "y" || answer == "yes");
}

}  // namespace

Outcome approve(const CheckOptions& options, const std::vector<CheckItem>& items, const Checking& checking,
                std::vector<CheckCase>& cases) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (const auto* check = checking.trace(i); check && is_open(options, *check)) open.push_back(i);
  if (open.empty()) return std::nullopt;
  if (!options.yes) {
    if (!isatty(STDIN_FILENO))
      return Error{"--approve", fmt::format("{} would be approved, and nobody can be asked; expected --yes",
                                            counted(open.size(), "run"))};
    for (const auto i : open) show(cases[i], *checking.trace(i));
    fmt::print("\nApprove {}? [y/N] ", counted(open.size(), "run"));
    std::fflush(stdout);
    if (!answers_yes()) return std::nullopt;
  }
  std::set<std::string> folders;
  for (const auto i : open) {
    const auto& check = *checking.trace(i);
    const auto approval = approval_of(items[i].path.string(), check.run, check.approved);
    if (auto problem = write_approval(approval)) return problem;
    if (auto documents = documents_above(approval.path)) folders.insert(*std::move(documents));
    std::error_code none;
    if (check.approved && takes_place_of(approval, *check.approved)) fs::remove(check.approved->path, none);
    fmt::print("approved {}\n", printable_line(approval.path));
    auto& approved = cases[i];
    approved.verdict = name_of(Verdict::same);
    approved.sentence = "approved; was " + approved.sentence;
    approved.status = exit_done;
  }
  for (const auto& folder : folders)
    if (const auto removed = remove_unused_documents(folder); !removed) return removed.error();
  return std::nullopt;
}

}  // namespace continua
