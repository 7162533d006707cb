// Waveforms of recordings, worked out by ffmpeg where it is installed.
#include "continua/replay/media/media_peaks.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

namespace continua {
namespace {

// Sound of one channel, 8000 samples a second: `amplitude(t)` of a tone, 0 to 1.
std::string wav(double seconds, const std::function<double(double)>& amplitude) {
  const auto number = [](std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFF);
    return text;
  };
  std::string samples;
  for (int i = 0; i < seconds * 8000; ++i) {
    const double t = i / 8000.0;
    samples += number(static_cast<std::uint32_t>(std::lround(32767 * amplitude(t) * std::sin(2764 * t))), 2);
  }
  const auto size = static_cast<std::uint32_t>(samples.size());
  return "RIFF" + number(36 + size, 4) + "WAVEfmt " + number(16, 4) + number(1, 2) + number(1, 2) + number(8000, 4) +
         number(16000, 4) + number(2, 2) + number(16, 2) + "data" + number(size, 4) + samples;
}

bool has_ffmpeg() { return std::system("ffmpeg -version > /dev/null 2>&1") == 0; }

}  // namespace

TEST_CASE("Peaks are as loud as the recording, when it is") {
  if (!has_ffmpeg()) return;
  const ScratchFolder folder;
  const auto path = folder.write("half.wav", wav(4, [](double t) { return t < 2 ? 0.5 : 0; }));
  const auto text = work_out_peaks(path);
  REQUIRE(text);
  const auto peaks = Json::parse(*text);
  CHECK(peaks["per_second"] == 50);
  REQUIRE(peaks["values"].size() == 200);
  for (std::size_t i = 0; i < 200; ++i) {
    INFO(i);
    const int value = peaks["values"][i];
    CHECK((i < 99 ? std::abs(value - 50) <= 1 : i > 100 ? value == 0 : true));
  }
  CHECK(peaks_problems(*text, "x").empty());
}

TEST_CASE("Long recordings have fewer peaks a second") {
  if (!has_ffmpeg()) return;
  const ScratchFolder folder;
  const auto path = folder.write("long.wav", wav(2100, [](double t) { return t < 1000 ? 0 : 1; }));
  const auto peaks = Json::parse(work_out_peaks(path).value());
  CHECK(peaks["per_second"] == 25);
  CHECK(peaks["values"].size() == 52500);
  CHECK(peaks["values"][24'990] == 0);
  CHECK(peaks["values"][25'010] == 100);
}

TEST_CASE("A file of peaks that is not older than the recording is taken, if it is one") {
  const ScratchFolder folder;
  const auto path = folder.write("a.wav", "no recording");
  const std::string kept = R"({"peaks":1,"per_second":50,"values":[1,2]})";
  const auto beside = folder.write("a.wav.peaks.json", kept);
  CHECK(peaks_of(path).value() == kept);
  folder.write("a.wav.peaks.json", R"({"peaks":1,"per_second":50,"values":[1,200]})");
  CHECK_FALSE(peaks_of(path).ok());
  folder.write("a.wav.peaks.json", kept);
  std::filesystem::last_write_time(beside, std::filesystem::last_write_time(path) - std::chrono::hours(1));
  CHECK_FALSE(peaks_of(path).ok());
}

TEST_CASE("Something that is no recording has no peaks, and leads ffmpeg nowhere else") {
  if (!has_ffmpeg()) return;
  const ScratchFolder folder;
  folder.write("real.wav", wav(1, [](double) { return 0.5; }));
  const auto list =
      folder.write("list.wav", "#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\nreal.wav\n#EXT-X-ENDLIST\n");
  const auto concat = folder.write("concat.mp4", "ffconcat version 1.0\nfile real.wav\n");
  for (const auto& path : {list, concat}) {
    const auto peaks = work_out_peaks(path);
    REQUIRE_FALSE(peaks.ok());
    CHECK(peaks.error().sentence == "ffmpeg finds no sound or picture of that kind in it");
  }
}

}  // namespace continua
