#include "fuzz/index_target.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_index_file.h"
#include "support/temporary_folder.h"

namespace continua {
namespace {

constexpr std::size_t names_of_format = 40, head_size = names_of_format + sizeof(LogPrint), digest_size = 32;
constexpr std::uint32_t short_record = 1 << 16;

// Few records, and so a short index; the last one is long, for short logs have no index.
std::string log_text() {
  std::string text = R"({"kind":"run","n":0,"t":0,"version":1})"
                     "\n";
  const auto add = [&](const Json& record) { text += compact(record) + "\n"; };
  int n = 1;
  for (; n < 30; n += 3) {
    add({{"kind", "symbol"},
         {"n", n},
         {"t", n},
         {"id", n},
         {"below", n > 3 ? Json(n - 3) : Json()},
         {"slots", {{"word", "cup"}}}});
    add({{"kind", "transition"},
         {"n", n + 1},
         {"t", n},
         {"id", "go"},
         {"from", "A"},
         {"to", "B"},
         {"stack", n},
         {"cause", n}});
    add({{"kind", "act"}, {"n", n + 2}, {"t", n}, {"program", "lift(cup)"}, {"status", "done"}, {"cause", n + 1}});
  }
  add({{"kind", "end"}, {"n", n}, {"t", n}, {"padding", std::string(std::size_t{8} << 20, '.')}});
  return text;
}

struct IndexedLog {
  TemporaryFolder folder;
  std::string path = folder.file("x.run.jsonl", log_text()), index = path + ".index", head, said;
  LogPrint print = print_of(path).value();

  IndexedLog() {
    (void)RunIndex::open(path);
    std::ifstream file(index, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(file), {}};
    head = whole.substr(0, head_size);
    said = whole.substr(head_size, whole.size() - head_size - digest_size);
    if (leads(said)) return;
    std::fprintf(stderr, "fuzz/index_target.cpp: an index begins otherwise than is written here\n");
    std::abort();
  }
  /// Whether the log is read by an index that says so.
  bool leads(std::string_view bytes) const {
    const auto text = head + std::string(bytes);
    std::ofstream(index, std::ios::binary) << text << digest(text);
    return kept_scan(path, print).has_value();
  }
};

const IndexedLog& indexed_log() {
  static const IndexedLog log;
  return log;
}

}  // namespace

void read_whole(const RunIndex& run) {
  for (std::size_t n = 0; n < run.size(); ++n)
    if (run.entry(n).length < short_record) (void)run.record(n);
  for (const auto& mark : run.stack_marks()) (void)run.snapshot(mark.top);
}

void read_index(std::string_view bytes) {
  const auto& log = indexed_log();
  if (!log.leads(bytes)) return;
  if (const auto run = RunIndex::open(log.path)) read_whole(*run);
}

std::vector<std::string> index_seeds() { return {indexed_log().said}; }

}  // namespace continua
