#include "continua/replay/diff/run_givens.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

// "transitions" → "transition".
std::string one_of(const std::string& section) {
  return section.size() > 1 && section.back() == 's' ? section.substr(0, section.size() - 1) : section;
}

std::string key_of(const Json& element) {
  for (const char* key : {"id", "name"})
    if (const auto text = text_of(element, key); !text.empty()) return text;
  return {};
}

class DocumentComparison {
 public:
  DocumentComparison(const std::string& kind, std::size_t most) : kind_(kind), most_(most) {}

  void compare(const Json& a, const Json& b) { compare(a, b, Path()); }
  std::vector<GivenDifference> take() { return std::move(found_); }

 private:
  // The way to a part, in words, and the name of the nearest part that has one.
  struct Path {
    std::vector<std::string> words;
    std::string name;
    bool section = false;  ///< of a document: its members are named like elements of a list, state 'Ask'

    Path inner(const std::string& part) const {
      auto path = *this;
      path.words.push_back(part);
      path.section = words.empty();
      return path;
    }
    Path named(const std::string& key) const {
      auto path = *this;
      if (path.words.empty()) path.words = {"part"};
      path.words.back() = fmt::format("{} '{}'", one_of(path.words.back()), key);
      path.name = key;
      path.section = false;
      return path;
    }
  };

  void compare(const Json& a, const Json& b, const Path& path) {
    if (a == b || found_.size() >= most_) return;
    if (a.is_object() && b.is_object()) return members(a, b, path);
    if (a.is_array() && b.is_array() && keyed(a) && keyed(b)) return elements(a, b, path);
    if (a.is_array() && b.is_array() && a.size() == b.size() && !a.empty() && a[0].is_structured()) {
      for (std::size_t i = 0; i < a.size(); ++i) compare(a[i], b[i], path.inner(fmt::format("no. {}", i + 1)));
      return;
    }
    note(a, b, path);
  }

  void members(const Json& a, const Json& b, const Path& path) {
    const auto one = [&](const std::string& key) {
      compare(member_of(a, key.c_str()), member_of(b, key.c_str()), path.section ? path.named(key) : path.inner(key));
    };
    for (const auto& [key, value] : a.items()) one(key);
    for (const auto& [key, value] : b.items())
      if (!a.contains(key)) one(key);
  }

  static bool keyed(const Json& array) {
    return !array.empty() &&
           std::all_of(array.begin(), array.end(), [](const Json& one) { return !key_of(one).empty(); });
  }

  void elements(const Json& a, const Json& b, const Path& path) {
    std::map<std::string, const Json*> of_b;
    for (const auto& element : b) of_b.emplace(key_of(element), &element);
    std::vector<std::string> order_a, order_b;
    for (const auto& element : a) {
      const auto key = key_of(element);
      const auto other = of_b.find(key);
      compare(element, other == of_b.end() ? Json() : *other->second, path.named(key));
      if (other != of_b.end()) order_a.push_back(key);
    }
    for (const auto& element : b) {
      const auto key = key_of(element);
      if (std::find(order_a.begin(), order_a.end(), key) != order_a.end())
        order_b.push_back(key);
      else
        compare(Json(), element, path.named(key));
    }
    if (order_a != order_b) note("another order", "another order", path.inner("order"));
  }

  void note(const Json& a, const Json& b, const Path& path) {
    if (found_.size() >= most_) return;
    std::string what;
    for (const auto& part : path.words) what += (what.empty() ? "" : ": ") + part;
    found_.push_back({kind_, what.empty() ? "document" : what, a, b, path.name});
  }

  const std::string& kind_;
  std::size_t most_;
  std::vector<GivenDifference> found_;
};

// The values that counted in the end: after a change in mid-run, the new ones.
Json as_it_went_on(const Json& header) {
  Json all = header;
  if (const auto& changed = member_of(header, "what_if"); changed.is_object())
    for (const auto& [key, value] : changed.items()) all[key] = value;
  return all;
}

void add(std::vector<GivenDifference>& all, std::vector<GivenDifference> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

// Of a part that has a name, a digest and a document.
void add_document(std::vector<GivenDifference>& all, const char* part, const Json& a, const Json& b) {
  const auto &one = member_of(a, part), &other = member_of(b, part);
  if (text_of(one, "digest") == text_of(other, "digest") && one.is_null() == other.is_null()) return;
  auto differences = document_differences(part, member_of(one, "document"), member_of(other, "document"));
  // Texts about the parts, and their examples, are for people.
  std::erase_if(differences, [](const GivenDifference& part_of) {
    return part_of.what.ends_with("about") || part_of.what.starts_with("example") || part_of.what == "name";
  });
  if (differences.empty() && text_of(one, "name") != text_of(other, "name"))
    differences.push_back({part, "name", member_of(one, "name"), member_of(other, "name"), ""});
  add(all, std::move(differences));
}

// Rules of the machine that the traces set.
void add_parameters(std::vector<GivenDifference>& all, const Json& a, const Json& b) {
  for (auto& difference : document_differences("machine", member_of(a, "parameters"), member_of(b, "parameters"))) {
    difference.name = difference.what;
    difference.what = fmt::format("parameter '{}'", difference.name);
    all.push_back(std::move(difference));
  }
}

// "lexicon/english/words.json" is of the lexicon.
void add_knowledge(std::vector<GivenDifference>& all, const Json& a, const Json& b) {
  const auto &one = member_of(a, "knowledge"), &other = member_of(b, "knowledge");
  if (!one.is_object() || !other.is_object()) {
    for (const char* part : {"lexicon", "voxemes"})
      if (text_of(member_of(a, part), "digest") != text_of(member_of(b, part), "digest"))
        all.push_back(
            {part, part, member_of(member_of(a, part), "digest"), member_of(member_of(b, part), "digest"), ""});
    return;
  }
  for (auto& difference : document_differences("", one, other)) {
    const auto file = difference.what;
    difference.kind = file.substr(0, file.find_first_of("/."));
    difference.name = file;
    all.push_back(std::move(difference));
  }
}

// The starting poses of the scene's free bodies; then any other difference of the scenes.
void add_scene(std::vector<GivenDifference>& all, const Json& a, const Json& b) {
  const auto &one = member_of(a, "scene"), &other = member_of(b, "scene");
  const auto before = all.size();
  if (text_of(one, "name") != text_of(other, "name"))
    all.push_back({"scene", "name", member_of(one, "name"), member_of(other, "name"), ""});
  auto bodies = document_differences("scene", member_of(one, "bodies"), member_of(other, "bodies"));
  for (auto& body : bodies) body.name = body.what;
  add(all, std::move(bodies));
  if (all.size() == before && member_of(one, "geoms") != member_of(other, "geoms"))
    all.push_back({"scene", "shapes", Json(), Json(), ""});
  if (all.size() == before && text_of(one, "digest") != text_of(other, "digest"))
    all.push_back({"scene", "MJCF", member_of(one, "digest"), member_of(other, "digest"), ""});
}

std::string short_text(const Json& value) {
  constexpr std::size_t longest = 160;
  if (value.is_null()) return "nothing";
  auto text = value.is_string() ? value.get<std::string>() : compact(value);
  if (text.size() <= longest) return text;
  text.resize(longest);
  while (!text.empty() && (text.back() & 0xC0) == 0x80) text.pop_back();
  if (!text.empty() && (text.back() & 0x80)) text.pop_back();
  return text + "…";
}

// [x, y, z] of a pose.
std::string place_text(const Json& pose) {
  if (!pose.is_array() || pose.size() < 3) return short_text(pose);
  return fmt::format("[{}, {}, {}]", compact(pose[0]), compact(pose[1]), compact(pose[2]));
}

// "N[one], \\x. plate(x)" of an entry of a lexicon.
std::string sense_text(const Json& entry) {
  if (entry.is_null()) return "not in this sense";
  const auto category = text_of(entry, "category"), term = text_of(entry, "term"), cost = text_of(entry, "cost");
  if (category.empty()) return fmt::format("passed over, cost {}", cost);
  return fmt::format("{}, {}, cost {}", category, term, cost);
}

}  // namespace

std::vector<GivenDifference> document_differences(const std::string& kind, const Json& a, const Json& b,
                                                  std::size_t most) {
  DocumentComparison comparison(kind, most);
  comparison.compare(a, b);
  return comparison.take();
}

std::vector<GivenDifference> given_differences(const Json& header_a, const Json& header_b) {
  const auto a = as_it_went_on(header_a), b = as_it_went_on(header_b);
  std::vector<GivenDifference> all;
  add_document(all, "machine", a, b);
  add_parameters(all, a, b);
  add_document(all, "phrases", a, b);
  add_knowledge(all, a, b);
  add_scene(all, a, b);
  const auto simple = [&](const char* kind, const char* key) {
    if (member_of(a, key) != member_of(b, key)) all.push_back({kind, key, member_of(a, key), member_of(b, key), ""});
  };
  simple("learned", "learned");
  simple("choice", "choice");
  simple("choice", "forced");
  simple("choice", "most_branches");
  simple("choice", "seed");
  simple("world", "world");
  simple("perspective", "perspective");
  simple("program", "continua");
  for (auto& difference : document_differences("program", member_of(a, "fingerprint"), member_of(b, "fingerprint")))
    all.push_back(std::move(difference));
  return all;
}

std::string told(const GivenDifference& difference) {
  const auto& [kind, what, a, b, name] = difference;
  if (kind == "scene" && !name.empty()) {
    if (a.is_null() || b.is_null()) return fmt::format("{} is only in {}'s scene", name, a.is_null() ? "B" : "A");
    return fmt::format("{} starts at {} in A, at {} in B", name, place_text(a), place_text(b));
  }
  if (kind == "lexicon" && what.find('/') == std::string::npos)
    return fmt::format("the word “{}”: {} in A, {} in B", what, sense_text(a), sense_text(b));
  if (kind == "lexicon" || kind == "gestures" || kind == "voxemes" || kind == "raising") {
    if (a.is_null() || b.is_null()) return fmt::format("{} is only in {}'s knowledge", what, a.is_null() ? "B" : "A");
    return fmt::format("{} is not the same file in both", what);
  }
  if (a.is_null() && b.is_null()) return fmt::format("{} differ", what);
  if (a == b) return fmt::format("{}: {}", what, short_text(a));
  return fmt::format("{}: {} in A, {} in B", what, short_text(a), short_text(b));
}

}  // namespace continua
