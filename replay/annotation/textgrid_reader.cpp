#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "continua/replay/annotation/event_tiers.h"
#include "continua/replay/annotation/textgrid.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

void append_utf8(std::string& out, std::uint32_t point) {
  if (point < 0x80) {
    out += static_cast<char>(point);
    return;
  }
  const int more = point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
  constexpr unsigned char first[] = {0, 0xC0, 0xE0, 0xF0};
  out += static_cast<char>(first[more] | point >> (6 * more));
  for (int i = more - 1; i >= 0; --i) out += static_cast<char>(0x80 | (point >> (6 * i) & 0x3F));
}

// Praat writes UTF-16 where the labels are not ASCII, with a byte order mark.
std::string utf8_of(std::string_view text) {
  const bool big = text.starts_with("\xFE\xFF");
  if (!big && !text.starts_with("\xFF\xFE")) return std::string(without_byte_order_mark(text));
  std::string out;
  std::uint32_t high = 0;
  for (std::size_t at = 2; at + 1 < text.size(); at += 2) {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + i]));
    };
    const auto unit = big ? byte(0) << 8 | byte(1) : byte(1) << 8 | byte(0);
    if ((unit & 0xFC00) == 0xD800)
      high = unit;
    else if ((unit & 0xFC00) == 0xDC00)
      append_utf8(out, high ? 0x10000 + ((high & 0x3FF) << 10) + (unit & 0x3FF) : 0xFFFD), high = 0;
    else
      append_utf8(out, unit);
  }
  return out;
}

// The values of a file one after the other: numbers, and texts in quotes. The long form says between them what they
// are: such words, numbers in brackets and comments are passed over, and so is `<exists>`.
class Values {
 public:
  explicit Values(std::string_view text) : text_(text) {}

  struct Value {
    bool is_text = false;
    std::string text;
    double number = 0;
    std::size_t line = 1;
  };

  std::optional<Value> next() {
    while (skip_blanks()) {
      Value value{.is_text = text_[at_] == '"', .text = {}, .line = line_};
      if (value.is_text) return value.text = quoted(), value;
      const auto word = bare_word();
      if (word.starts_with('!')) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value.number);
                 problem == std::errc() && end == word.data() + word.size()) {
        return value;
      }
    }
    return std::nullopt;
  }

  std::size_t line() const { return line_; }

 private:
  bool skip_blanks() {
    for (; at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos; ++at_)
      line_ += text_[at_] == '\n';
    return at_ < text_.size();
  }

  std::string_view bare_word() {
    const auto end = std::min(text_.find_first_of(" \t\r\n\"", at_), text_.size());
    const auto word = text_.substr(at_, end - at_);
    at_ = end;
    return word;
  }

  std::string quoted() {
    std::string text;
    for (++at_; at_ < text_.size(); ++at_) {
      const bool mark = text_[at_] == '"', doubled = mark && text_.substr(at_ + 1).starts_with('"');
      if (mark) ++at_;
      if (mark && !doubled) return text;
      line_ += text_[at_] == '\n';
      text += text_[at_];
    }
    return text;
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
};

class TextGridReader {
 public:
  TextGridReader(std::string text, const std::string& name) : text_(std::move(text)), values_(text_) {
    found_.name = name;
  }

  Result<Annotations> read() {
    if (!is_textgrid(text_)) return error(R"(expected a TextGrid: File type = "ooTextFile")");
    values_.next(), values_.next();
    if (!number() || !end() || !count()) return error(problem_);
    for (std::size_t left = size_; left > 0; --left)
      if (!read_tier()) return error(problem_);
    join_events();
    return std::move(found_);
  }

 private:
  bool number() {
    const auto value = values_.next();
    last_ = value.value_or(Values::Value{});
    if (value && !value->is_text) return true;
    problem_ = fmt::format("found {}; expected a number", value ? in_quotes('"' + value->text + '"') : "the end");
    return false;
  }

  bool text() {
    const auto value = values_.next();
    last_ = value.value_or(Values::Value{});
    if (value && value->is_text) return true;
    problem_ = fmt::format("found {}; expected a text in quotes", value ? compact(value->number) : "the end");
    return false;
  }

  // A time as far as it can be one.
  bool time(std::int64_t& ms) {
    if (!number()) return false;
    if (last_.number >= -1e9 && last_.number <= 1e9) return ms = std::llround(last_.number * 1000), true;
    problem_ = fmt::format("found the time {}; expected seconds", last_.number);
    return false;
  }
  bool end() { return time(found_.end_ms); }

  bool count() {
    if (!number()) return false;
    if (last_.number >= 0 && last_.number <= static_cast<double>(text_.size()) &&
        last_.number == std::floor(last_.number))
      return size_ = static_cast<std::size_t>(last_.number), true;
    problem_ = fmt::format("found the number {}; expected how many follow", last_.number);
    return false;
  }

  bool read_tier() {
    if (!text()) return false;
    const bool points = last_.text == "TextTier";
    if (!points && last_.text != "IntervalTier") {
      problem_ = fmt::format("found the class {}; expected IntervalTier or TextTier", in_quotes(last_.text));
      return false;
    }
    if (!text()) return false;
    Tier tier{last_.text};
    if (!number() || !number() || !count()) return false;
    for (std::size_t left = size_; left > 0; --left) {
      Annotation one;
      if (!time(one.begin_ms) || (one.end_ms = one.begin_ms, !points && !time(one.end_ms)) || !text()) return false;
      one.n = last_.line;
      one.value = label_of(last_.text);
      if (!one.value.empty()) tier.annotations.push_back(std::move(one));
    }
    found_.tiers.push_back(std::move(tier));
    return true;
  }

  // Our own tiers of events go into the annotations that begin with them. Events without a label have no other trace
  // in the file than these.
  void join_events() {
    for (const auto& events : found_.tiers) {
      if (events.name == "continua.trace" && !events.annotations.empty()) found_.header = events.annotations[0].value;
      if (!events.name.ends_with(events_ending)) continue;
      const auto name = events.name.substr(0, events.name.size() - std::string_view(events_ending).size());
      const auto of =
          std::find_if(found_.tiers.begin(), found_.tiers.end(), [&](const auto& t) { return t.name == name; });
      if (of != found_.tiers.end()) join(events, *of);
    }
    std::erase_if(found_.tiers,
                  [](const Tier& tier) { return tier.name.ends_with(events_ending) || tier.name == "continua.trace"; });
  }

  void join(const Tier& events, Tier& tier) {
    auto& annotations = tier.annotations;
    const auto count = annotations.size();
    for (std::size_t i = 0, at = 0; i < events.annotations.size(); ++i) {
      const auto& one = events.annotations[i];
      const auto event = LocatedJson::parse(one.value, found_.name);
      if (!event || !event->root().is_object()) continue;
      while (at < count && annotations[at].begin_ms < one.begin_ms) ++at;
      if (at < count && annotations[at].begin_ms == one.begin_ms)
        annotations[at].event = event->root();
      else if (label_of_event(member_of(event->root(), "event")).empty())
        annotations.push_back({one.n, one.begin_ms, one.end_ms, "", event->root()});
    }
    std::stable_sort(annotations.begin(), annotations.end(),
                     [](const Annotation& a, const Annotation& b) { return a.begin_ms < b.begin_ms; });
  }

  Error error(const std::string& sentence) const {
    return {fmt::format("{}:{}", found_.name, values_.line()), sentence};
  }

  std::string text_;
  Values values_;
  Values::Value last_;
  std::size_t size_ = 0;
  std::string problem_;
  Annotations found_;
};

}  // namespace

bool is_textgrid(std::string_view text) {
  const auto beginning = utf8_of(text.substr(0, 400));
  return beginning.find("ooTextFile") != std::string::npos && beginning.find("\"TextGrid\"") != std::string::npos;
}

Result<Annotations> read_textgrid(std::string_view text, const std::string& name) {
  return TextGridReader(utf8_of(text), name).read();
}

}  // namespace continua
