#include "continua/replay/noise/noise.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/core/document_reader.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

double share(const Item& item) { return item.number("a share, 0 to 1", 0, 0, 1); }

Noise::Words read_words(const Item& item) {
  Noise::Words words;
  if (!item.expect_object("noise of words", {"dropped", "swapped", "misheard", "confusions"})) return words;
  words = {share(item.member("dropped")), share(item.member("swapped")), share(item.member("misheard"))};
  if (words.dropped + words.swapped + words.misheard > 1)
    item.problem("'dropped', 'swapped' and 'misheard' are more than 1 together; expected shares of the same words");
  return words;
}

Noise::NBest read_n_best(const Item& item) {
  Noise::NBest lists{1};
  if (!item.expect_object("n-best lists", {"share", "size", "truth"})) return lists;
  lists.share = item.member("share").number("a share, 0 to 1", 1, 0, 1);
  lists.size = item.member("size").whole_number("how many readings a list has, 1 to 100", lists.size, 1, 100);
  lists.truth = item.member("truth").whole_number(
      fmt::format("the place of what was said, 1 to {} (the list's 'size')", lists.size), 1, 1, lists.size);
  return lists;
}

Noise::Gestures read_gestures(const Item& item) {
  Noise::Gestures gestures;
  if (!item.expect_object("noise of gestures", {"missed", "doubled"})) return gestures;
  gestures = {share(item.member("missed")), share(item.member("doubled"))};
  if (gestures.missed + gestures.doubled > 1)
    item.problem("'missed' and 'doubled' are more than 1 together; expected shares of the same gestures");
  return gestures;
}

Noise::Pointing read_pointing(const Item& item) {
  Noise::Pointing pointing;
  if (!item.expect_object("noise of pointing", {"sd", "late", "cut"})) return pointing;
  return {item.member("sd").number("metres, 0 to 10", 0, 0, 10),
          item.member("late").number("seconds, 0 to 60", 0, 0, 60), share(item.member("cut"))};
}

// The file for a name in a folder of the knowledge, or for a path relative to `beside`.
std::string found_file(const std::string& name, const fs::path& folder, const fs::path& beside) {
  if (const auto known = folder / (name + ".json"); fs::exists(known)) return known.string();
  return (beside / name).lexically_normal().string();
}

}  // namespace

const std::vector<std::string>& noise_kinds() {
  static const std::vector<std::string> kinds{"words", "n_best", "times", "gestures", "pointing"};
  return kinds;
}

Noise only(const Noise& noise, std::string_view kind, double strength) {
  Noise one;
  one.confusions = noise.confusions;
  const auto least = [&](double value, double all) { return value * std::min(strength, all > 0 ? 1 / all : strength); };
  if (kind == "words") {
    const auto& from = noise.words;
    const double all = from.dropped + from.swapped + from.misheard;
    one.words = {least(from.dropped, all), least(from.swapped, all), least(from.misheard, all)};
  } else if (kind == "n_best") {
    one.n_best = noise.n_best;
    one.n_best.share = least(noise.n_best.share, noise.n_best.share);
  } else if (kind == "times") {
    one.times.sd_s = noise.times.sd_s * strength;
  } else if (kind == "gestures") {
    const auto& from = noise.gestures;
    one.gestures = {least(from.missed, from.missed + from.doubled), least(from.doubled, from.missed + from.doubled)};
  } else {
    require(kind == "pointing", "a kind of noise");
    const auto& from = noise.pointing;
    one.pointing = {from.sd_m * strength, from.late_s * strength, least(from.cut, from.cut)};
  }
  return one;
}

bool has_kind(const Noise& noise, std::string_view kind) {
  if (kind == "words") return noise.words.dropped + noise.words.swapped + noise.words.misheard > 0;
  if (kind == "n_best") return noise.n_best.share > 0;
  if (kind == "times") return noise.times.sd_s > 0;
  if (kind == "gestures") return noise.gestures.missed + noise.gestures.doubled > 0;
  return noise.pointing.sd_m + noise.pointing.late_s + noise.pointing.cut > 0;
}

Result<Noise> read_noise(const std::string& name, const fs::path& knowledge) {
  const auto document = LocatedJson::read(found_file(name, knowledge / "noise", ""));
  if (!document) return document.error();
  DocumentReader reader;
  const auto root = reader.root(*document);
  Noise noise;
  if (root.expect_object("noise", {"noise", "about", "words", "n_best", "times", "gestures", "pointing"})) {
    root.expect_version("noise", 1);
    if (const auto words = root.member("words"); words.exists()) noise.words = read_words(words);
    if (const auto lists = root.member("n_best"); lists.exists()) noise.n_best = read_n_best(lists);
    if (const auto times = root.member("times"); times.exists() && times.expect_object("noise of times", {"sd"}))
      noise.times.sd_s = times.member("sd").number("seconds, 0 to 60", 0, 0, 60);
    if (const auto gestures = root.member("gestures"); gestures.exists()) noise.gestures = read_gestures(gestures);
    if (const auto pointing = root.member("pointing"); pointing.exists()) noise.pointing = read_pointing(pointing);
  }
  if (!reader.sound()) return reader.problems().front();
  if (!has_kind(noise, "words") && !has_kind(noise, "n_best")) return noise;
  const auto named = root.member("words").member("confusions");
  const auto table = named.exists() ? named.name("a table of confusions, a name or a file") : std::string("english");
  if (!reader.sound()) return reader.problems().front();
  auto confusions =
      read_confusions(found_file(table, knowledge / "confusions", fs::path(document->name()).parent_path()));
  if (!confusions) return confusions.error();
  noise.confusions = std::move(*confusions);
  return noise;
}

}  // namespace continua
