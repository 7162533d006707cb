#include "continua/replay/log/run_index_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <type_traits>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/gzip_text.h"
#include "continua/core/replaced_file.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

// Shorter logs are read faster than anybody notices. A packed one is some ten times as long when it is unpacked.
constexpr std::uint64_t shortest_kept = std::uint64_t{8} << 20, shortest_packed = shortest_kept / 16;

// The beginning of an index file. A file of another version, or of a machine that lays numbers out otherwise, begins
// otherwise.
struct Begin {
  std::array<char, 24> name{"continua run index 4"};
  std::uint64_t order = 0x0102030405060708ULL;
  std::uint64_t sizes = (sizeof(RecordEntry) << 32) + (sizeof(StackMark) << 24) + (sizeof(SymbolPlace) << 16) +
                        (sizeof(ActMark) << 8) + sizeof(StepMark);
  bool operator==(const Begin&) const = default;
};

struct Symbol {
  std::int64_t id = 0;
  SymbolPlace place;
};

std::string index_path(const std::string& path) { return path + ".index"; }

// Values go to the file and into a digest of all of them, which comes last.
class Writer {
 public:
  explicit Writer(std::ostream& file) : file_(file) {}

  template <class T>
  void put(const T& value) {
    put_bytes(&value, sizeof value);
  }
  template <class T>
  void put_all(const T& values) {
    static_assert(std::is_trivially_copyable_v<typename T::value_type>);
    put(static_cast<std::uint64_t>(values.size()));
    put_bytes(values.data(), values.size() * sizeof(typename T::value_type));
  }
  void put_texts(const std::vector<std::string>& texts) {
    put(static_cast<std::uint64_t>(texts.size()));
    for (const auto& text : texts) put_all(text);
  }
  void finish() { file_ << digest_.text(); }

 private:
  void put_bytes(const void* bytes, std::size_t size) {
    const auto* characters = static_cast<const char*>(bytes);
    digest_.add({characters, size});
    file_.write(characters, static_cast<std::streamsize>(size));
  }

  std::ostream& file_;
  RunningDigest digest_;
};

class Reader {
 public:
  Reader(std::ifstream& file, std::uint64_t size) : file_(file), left_(size) {}

  template <class T>
  bool get(T& value) {
    return get_bytes(&value, sizeof value);
  }
  template <class T>
  bool get_all(T& values) {
    static_assert(std::is_trivially_copyable_v<typename T::value_type>);
    std::uint64_t count = 0;
    if (!get(count) || count > left_ / sizeof(typename T::value_type)) return false;
    values.resize(count);
    return get_bytes(values.data(), count * sizeof(typename T::value_type));
  }
  bool get_texts(std::vector<std::string>& texts) {
    std::uint64_t count = 0;
    if (!get(count)) return false;
    for (std::string text; texts.size() < count; texts.push_back(text))
      if (!get_all(text)) return false;
    return true;
  }
  /// Whether nothing is left but the digest of all that was read.
  bool finished() {
    const auto expected = digest_.text();
    std::string text(expected.size(), '\0');
    return get_bytes(text.data(), text.size()) && left_ == 0 && text == expected;
  }

 private:
  bool get_bytes(void* bytes, std::size_t size) {
    if (size > left_ || !file_.read(static_cast<char*>(bytes), static_cast<std::streamsize>(size))) return false;
    left_ -= size;
    digest_.add({static_cast<const char*>(bytes), size});
    return true;
  }

  std::ifstream& file_;
  std::uint64_t left_;
  RunningDigest digest_;
};

// A record lies behind the one before, and so does what brought it about.
bool is_in_order(const std::vector<RecordEntry>& entries) {
  std::uint64_t end = 0;
  for (std::size_t n = 0; n < entries.size(); ++n) {
    const auto& entry = entries[n];
    if (entry.offset < end || entry.cause < -1 || entry.cause >= static_cast<std::int64_t>(n)) return false;
    end = entry.offset + entry.length + 1;
  }
  return true;
}

// Readers go where an index sends them: none may be sent out of the log, or in a circle.
bool is_consistent(const ScannedLog& log) {
  const auto known = [&](std::uint64_t n) { return n < log.entries.size(); };
  return !log.entries.empty() && is_in_order(log.entries) &&
         std::all_of(log.entries.begin(), log.entries.end(),
                     [&](const RecordEntry& entry) {
                       return entry.kind < log.kinds.size() && entry.offset <= log.bytes &&
                              entry.length <= log.bytes - entry.offset;
                     }) &&
         std::all_of(log.marks.begin(), log.marks.end(), [&](const StackMark& mark) { return known(mark.n); }) &&
         std::all_of(log.acts.begin(), log.acts.end(), [&](const ActMark& mark) { return known(mark.n); }) &&
         std::all_of(log.steps.begin(), log.steps.end(),
                     [&](const StepMark& step) {
                       return known(step.n) && std::max({step.id, step.from, step.to}) < log.names.size();
                     }) &&
         std::all_of(log.symbols.begin(), log.symbols.end(), [&](const auto& symbol) {
           const auto below = log.symbols.find(symbol.second.below);
           return known(symbol.second.n) && (below == log.symbols.end() || below->second.n < symbol.second.n);
         });
}

}  // namespace

std::optional<LogPrint> print_of(const std::string& path) {
  std::error_code problem;
  LogPrint print;
  print.bytes = fs::file_size(path, problem);
  if (problem || print.bytes < (is_gzip_file(path) ? shortest_packed : shortest_kept)) return std::nullopt;
  print.written_ns = fs::last_write_time(path, problem).time_since_epoch().count();
  std::ifstream file(path, std::ios::binary);
  std::array<char, 8192> ends{};
  file.read(ends.data(), ends.size() / 2);
  file.seekg(-static_cast<std::streamoff>(ends.size() / 2), std::ios::end);
  file.read(ends.data() + ends.size() / 2, ends.size() / 2);
  if (problem || !file) return std::nullopt;
  print.ends = hash_of({ends.data(), ends.size()});
  return print;
}

std::optional<ScannedLog> kept_scan(const std::string& path, const LogPrint& print) {
  std::error_code problem;
  const auto size = fs::file_size(index_path(path), problem);
  if (problem) return std::nullopt;
  std::ifstream file(index_path(path), std::ios::binary);
  Reader reader(file, size);
  ScannedLog log;
  Begin begin;
  LogPrint of_log;
  std::vector<Symbol> symbols;
  if (!reader.get(begin) || begin != Begin() || !reader.get(of_log) || of_log != print || !reader.get(log.bytes) ||
      !reader.get_texts(log.kinds) || !reader.get_texts(log.names) || !reader.get_all(log.entries) ||
      !reader.get_all(log.marks) || !reader.get_all(symbols) || !reader.get_all(log.acts) ||
      !reader.get_all(log.steps) || !reader.get_all(log.trouble) || !reader.get(log.last_line) || !reader.finished())
    return std::nullopt;
  log.symbols.reserve(symbols.size());
  for (const auto& [id, place] : symbols) log.symbols.emplace(id, place);
  log.path = path;
  if (!is_consistent(log)) return std::nullopt;
  return log;
}

// A file that cannot be written is no trouble.
void keep_scan(const ScannedLog& log, const LogPrint& print) {
  std::vector<Symbol> symbols;
  for (const auto& [id, place] : log.symbols) symbols.push_back({id, place});
  std::sort(symbols.begin(), symbols.end(), [](const Symbol& a, const Symbol& b) { return a.id < b.id; });
  ReplacedFile file(index_path(log.path), ReplacedFile::Links::replace);
  Writer writer(file.stream());
  writer.put(Begin());
  writer.put(print);
  writer.put(log.bytes);
  writer.put_texts(log.kinds);
  writer.put_texts(log.names);
  writer.put_all(log.entries);
  writer.put_all(log.marks);
  writer.put_all(symbols);
  writer.put_all(log.acts);
  writer.put_all(log.steps);
  writer.put_all(log.trouble);
  writer.put(log.last_line);
  writer.finish();
  (void)file.commit();
}

}  // namespace continua
