#include "continua/replay/media/media_peaks.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "continua/core/gzip_text.h"
#include "continua/replay/media/ffmpeg.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr int samples_per_second = 8000;  // loudness needs no more
constexpr double peaks_per_second = 50;
constexpr std::size_t most_peaks = 100'000;
constexpr double most_s = 120;
constexpr std::uintmax_t most_file_bytes = 4 << 20;

// Samples come in pieces, which may end within one.
class PeakMaker {
 public:
  void add(std::string_view bytes) {
    rest_.append(bytes);
    std::size_t at = 0;
    for (; at + 2 <= rest_.size(); at += 2) {
      std::int16_t sample = 0;
      std::memcpy(&sample, rest_.data() + at, sizeof sample);
      largest_ = std::max(largest_, std::abs(static_cast<int>(sample)));
      if (++samples_ == samples_a_peak_) close();
    }
    rest_.erase(0, at);
  }

  /// Empty: there was no sound.
  std::string finish() {
    if (samples_ > 0) close();
    if (peaks_.empty()) return "";
    return compact(Json{
        {"peaks", 1}, {"per_second", samples_per_second / static_cast<double>(samples_a_peak_)}, {"values", peaks_}});
  }

 private:
  void close() {
    peaks_.push_back((largest_ * 100 + INT16_MAX / 2) / INT16_MAX);
    largest_ = samples_ = 0;
    if (peaks_.size() < most_peaks) return;
    for (std::size_t i = 0; 2 * i + 1 < peaks_.size(); ++i) peaks_[i] = std::max(peaks_[2 * i], peaks_[2 * i + 1]);
    peaks_.resize(peaks_.size() / 2);
    samples_a_peak_ *= 2;
  }

  std::string rest_;
  int largest_ = 0, samples_ = 0, samples_a_peak_ = static_cast<int>(samples_per_second / peaks_per_second);
  std::vector<int> peaks_;
};

}  // namespace

Result<std::string> work_out_peaks(const std::string& recording) {
  PeakMaker maker;
  const auto failed = run_ffmpeg(
      recording, {"-map", "0:a:0", "-ac", "1", "-ar", std::to_string(samples_per_second), "-f", "s16le", "pipe:1"},
      most_s, [&](std::string_view bytes) { maker.add(bytes); });
  if (failed) return *failed;
  auto peaks = maker.finish();
  if (peaks.empty()) return Error{recording, "has no sound"};
  return peaks;
}

Result<std::string> peaks_of(const std::string& recording) {
  const auto kept = recording + peaks_ending;
  std::error_code missing, problem;
  const auto written = fs::last_write_time(kept, missing), recorded = fs::last_write_time(recording, problem);
  if (!missing && !problem && written >= recorded && !fs::is_symlink(kept, problem) &&
      fs::file_size(kept, problem) <= most_file_bytes)
    if (auto text = read_text(kept); text && peaks_problems(*text, kept).empty()) return *text;
  return work_out_peaks(recording);
}

std::vector<Error> peaks_problems(std::string_view text, const std::string& path) {
  const auto json = LocatedJson::parse(text, path);
  if (!json) return {json.error()};
  const auto& root = json->root();
  const auto wrong = [&](const char* expected) {
    return std::vector<Error>{{path, std::string("expected ") + expected}};
  };
  if (!root.is_object() || !root.contains("peaks") || root["peaks"] != 1)
    return wrong(R"(the peaks of a recording, {"peaks":1,"per_second":50,"values":[…]})");
  const auto rate = root.find("per_second"), values = root.find("values");
  if (rate == root.end() || !rate->is_number() || !(*rate > 0)) return wrong("'per_second', a number above 0");
  const bool good = values != root.end() && values->is_array() &&
                    std::all_of(values->begin(), values->end(),
                                [](const Json& one) { return one.is_number() && one >= 0 && one <= 100; });
  return good ? std::vector<Error>() : wrong("'values', numbers from 0 to 100");
}

}  // namespace continua
