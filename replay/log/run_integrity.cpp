#include "continua/replay/log/run_integrity.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_log.h"

namespace continua {
namespace {

std::string_view unquoted(std::string_view value) {
  return value.size() >= 2 && value.front() == '"' ? value.substr(1, value.size() - 2) : std::string_view();
}

// The parts of a line that the chain needs.
struct Line {
  std::string_view text, kind, digest;
  explicit Line(std::string_view line) : text(line) {
    scan_members(line, [this](std::string_view key, std::string_view value) {
      if (key == "kind") kind = unquoted(value);
      if (key == "digest") digest = unquoted(value);
    });
  }
};

class Integrity {
 public:
  explicit Integrity(const std::string& path) : path_(path) {}

  void take(std::string_view text) {
    ++lines_;
    const Line line(text);
    if (ended_) return problem(lines_, "a line after the log's end; expected none");
    if (log::is<log::Block>(line.kind)) {
      close_block(line.digest);
      block_ = RunningDigest();
      block_.add(line.digest);
    } else if (log::is<log::End>(line.kind)) {
      ended_ = true;
      return close(line);
    }
    all_.add(text);
    all_.add("\n");
    block_.add(text);
    block_.add("\n");
    const bool pose = log::is<log::Pose>(line.kind);
    if (pose) {
      poses_.add(text);
      poses_.add("\n");
    }
    if (pose || !is_decision(line.kind)) {
      ++counts_[std::string(line.kind)];
      return;
    }
    const auto record = parse_json_line(text, path_, lines_);
    if (!record) return problem(lines_, "the line is damaged: " + record.error().sentence);
    ++counts_[std::string(line.kind)];
    if (const auto decision = order_.next(*record)) decisions_.add(compact(*decision));
  }

  std::vector<Error> problems() {
    if (damaged_blocks_ > 1) problems_.front().sentence += fmt::format("; {} more after it", damaged_blocks_ - 1);
    return std::move(problems_);
  }

 private:
  void problem(std::size_t line, std::string sentence) {
    problems_.push_back({fmt::format("{}:{}", path_, line), std::move(sentence)});
  }

  void close_block(std::string_view stated) {
    has_blocks_ = true;
    if (block_.text() != stated && ++damaged_blocks_ == 1)
      problems_.insert(problems_.begin(),
                       {fmt::format("{}:{}", path_, block_begin_),
                        fmt::format("the block of records {} to {} is damaged: its digest is {}, {} was written",
                                    block_begin_ - 1, lines_ - 2, block_.text(), stated)});
    block_begin_ = lines_ + 1;
  }

  void close(const Line& line) {
    const auto end = parse_json_line(line.text, path_, lines_);
    if (!end) return problem(lines_, "the last line is damaged: " + end.error().sentence);
    const auto stated = [&](const char* key) {
      const auto found = end->find(key);
      return found == end->end() || !found->is_string() ? std::string() : found->get<std::string>();
    };
    if (all_.text() != stated("digest")) {
      if (damaged_blocks_ > 0) return;
      return problem(block_begin_,
                     has_blocks_
                         ? fmt::format("records {} to {}, after the last whole block, are damaged, or the last line is",
                                       block_begin_ - 1, lines_ - 2)
                         : fmt::format("the log is damaged: the digest of its lines is {}, {} was written", all_.text(),
                                       stated("digest")));
    }
    for (const auto& outcome : order_.outcomes()) decisions_.add(compact(outcome));
    for (const auto& [key, digest] : {std::pair("decisions", decisions_.text()), std::pair("physics", poses_.text())})
      if (digest != stated(key))
        problem(lines_, fmt::format("\"{}\" states {}; that of the records is {}", key, stated(key), digest));
    if (const auto counts = end->find("counts"); counts != end->end() && *counts != Json(counts_))
      problem(lines_, fmt::format("\"counts\" states {}; expected {}", compact(*counts), compact(Json(counts_))));
  }

  const std::string& path_;
  std::size_t lines_ = 0, block_begin_ = 1;
  std::size_t damaged_blocks_ = 0;
  bool has_blocks_ = false, ended_ = false;
  RunningDigest all_, block_, decisions_, poses_;
  DecisionOrder order_;
  std::map<std::string, int> counts_;
  std::vector<Error> problems_;
};

}  // namespace

std::vector<Error> integrity_problems(std::string_view text, const std::string& path) {
  Integrity integrity(path);
  while (!text.empty()) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos && !Json::accept(text)) break;  // cut in the middle of a line
    const auto length = std::min(end, text.size());
    integrity.take(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return integrity.problems();
}

}  // namespace continua
