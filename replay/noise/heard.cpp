#include "continua/replay/noise/heard.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/words.h"

namespace continua {
namespace {

std::vector<std::string> pieces_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> pieces;
  for (std::string piece; stream >> piece;) pieces.push_back(piece);
  return pieces;
}

// With the mark that follows the word.
std::string misheard(const std::string& piece, const Confusions& confusions, double chance) {
  const auto& heard = confusions.heard(bare_words(piece), chance);
  const auto last = piece.find_last_not_of(".,;:!?");
  return last == std::string::npos ? heard : heard + piece.substr(last + 1);
}

// Carries over how sure a recogniser is, from the measured one, `wrong` of whose words were wrong, to one of whose
// words `share` are.
double moved_to(double confidence, double wrong, double share) {
  const double right = confidence * (1 - share) / (1 - wrong), rest = (1 - confidence) * share / wrong;
  return right + rest > 0 ? right / (right + rest) : 0;
}

double rounded(double confidence) { return std::round(confidence * 1e3) / 1e3; }

}  // namespace

bool hear_words(InputEvent& speech, const Noise& noise, Random& random) {
  const auto& [dropped, swapped, wrong] = noise.words;
  const double all = dropped + swapped + wrong;
  if (all == 0) return true;
  const auto pieces = pieces_of(speech.text);
  const bool timed = speech.words.size() == pieces.size();
  std::vector<std::string> heard;
  std::vector<Word> times;
  double sure = 1;
  bool swaps = false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double chance = random.uniform(), which = random.uniform() * all, choice = random.uniform(),
                 sureness = random.uniform();
    const bool changed = chance < all;
    if (changed && which < dropped) continue;
    const bool is_swapped = changed && which < dropped + swapped, is_wrong = changed && !is_swapped;
    auto text = is_wrong ? misheard(pieces[i], noise.confusions, choice) : pieces[i];
    if (timed) times.push_back({text, speech.words[i].t});
    heard.insert(swaps && !heard.empty() ? heard.end() - 1 : heard.end(), std::move(text));
    swaps = is_swapped;
    const auto& measured = is_wrong ? noise.confusions.sure_wrong : noise.confusions.sure_right;
    sure *= moved_to(quantile(measured, sureness), noise.confusions.share_wrong, std::min(all, 0.99));
  }
  if (heard.empty()) return false;
  for (std::size_t i = 0; i < times.size(); ++i) times[i].text = heard[i];
  if (heard != pieces) speech.text = fmt::to_string(fmt::join(heard, " "));
  if (timed) speech.words = std::move(times);
  speech.confidence = rounded(speech.confidence * sure);
  return true;
}

void hear_as_list(InputEvent& speech, const Noise& noise, Random& random) {
  const auto pieces = pieces_of(speech.text);
  require(!pieces.empty(), "an utterance has a word");
  const auto& lists = noise.n_best;
  std::vector<Alternative> readings;
  double sure =
      quantile(lists.truth == 1 ? noise.confusions.sure_right : noise.confusions.sure_wrong, random.uniform());
  double left = 1;
  for (int place = 1; place <= lists.size; ++place) {
    auto heard = pieces;
    const auto one = static_cast<std::size_t>(random.uniform() * static_cast<double>(pieces.size()));
    const double choice = random.uniform();
    if (place != lists.truth) heard[one] = misheard(heard[one], noise.confusions, choice);
    readings.push_back({fmt::to_string(fmt::join(heard, " ")), rounded(sure)});
    left -= sure;
    sure = std::min(sure, left / 2);
  }
  speech.text = readings.front().text;
  speech.confidence = readings.front().confidence;
  speech.words.clear();
  speech.alternatives.assign(readings.begin() + 1, readings.end());
}

}  // namespace continua
