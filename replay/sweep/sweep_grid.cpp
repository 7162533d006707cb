#include "continua/replay/sweep/sweep_grid.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "continua/core/json_pointer.h"
#include "continua/core/random.h"

namespace continua {
namespace {

using Settings = std::vector<Json>;  // each {name: value}

// Sums of parts are not to end in 0.30000000000000004.
double rounded(double value) { return std::stod(fmt::format("{:.12g}", value)); }

class GridReader {
 public:
  explicit GridReader(const LocatedJson& document) : document_(document) {}

  Result<std::vector<SweepPoint>> points() {
    Settings all = list();
    multiply(all, latin());
    multiply(all, grid());
    const auto policies = texts("policies");
    const auto seeds = numbers("seeds");
    for (const auto& [key, value] : document_.root().items())
      if (!known_.contains(key))
        fail("/" + key,
             fmt::format("there is no part {}; expected list, latin, grid, policies or seeds", in_quotes(key)));
    if (problem_) return *problem_;
    if (all.size() * policies.size() * seeds.size() > most_sweep_points) return too_many();
    std::vector<SweepPoint> points;
    for (const auto& set : all)
      for (const auto& policy : policies)
        for (const auto& seed : seeds) points.push_back({set, policy, seed});
    return points;
  }

 private:
  void fail(const std::string& pointer, const std::string& sentence) {
    if (!problem_) problem_ = document_.error(pointer, sentence);
  }
  Error too_many() const { return document_.error("", fmt::format("names over {} points", most_sweep_points)); }

  // The part of the document; null if there is none.
  const Json* part_of(const std::string& name) {
    known_.insert(name);
    const auto found = document_.root().find(name);
    return found == document_.root().end() ? nullptr : &*found;
  }

  static bool is_setting(const Json& value) { return value.is_boolean() || value.is_number() || value.is_string(); }

  Settings list() {
    const auto* part = part_of("list");
    if (!part) return {Json::object()};
    Settings all;
    if (!part->is_array() || part->empty()) fail("/list", "expected a list of objects {NAME: VALUE}");
    for (std::size_t i = 0; i < part->size() && part->is_array(); ++i) {
      const auto& one = (*part)[i];
      if (!one.is_object() || !std::all_of(one.begin(), one.end(), is_setting))
        fail(fmt::format("/list/{}", i), fmt::format("found {}; expected an object {{NAME: VALUE}}", compact(one)));
      all.push_back(one);
    }
    return all;
  }

  // The middles of as many equal parts of each range, each of them once, in an order of their own for each name.
  Settings latin() {
    const auto* part = part_of("latin");
    if (!part) return {Json::object()};
    const auto count = part->value("count", Json()), seed = part->value("seed", Json(0u)),
               of = part->value("of", Json());
    if (!count.is_number_unsigned() || count < 1 || count > most_sweep_points || !seed.is_number_unsigned() ||
        !of.is_object() || of.empty() || part->size() > 2u + part->contains("seed")) {
      fail("/latin", "expected {\"count\": 1 or more, \"seed\": 0 or more, \"of\": {NAME: [LOW, HIGH]}}");
      return {};
    }
    Settings all(count.get<std::size_t>(), Json::object());
    Random random(seed.get<std::uint64_t>());
    for (const auto& [name, range] : of.items()) {
      if (!range.is_array() || range.size() != 2 || !range[0].is_number() || !range[1].is_number()) {
        fail("/latin/of/" + pointer_part(name), fmt::format("found {}; expected [LOW, HIGH]", compact(range)));
        return {};
      }
      std::vector<std::size_t> order(all.size());
      for (std::size_t i = 0; i < order.size(); ++i) {
        const auto j = static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1));
        order[i] = order[j];
        order[j] = i;
      }
      const auto low = range[0].get<double>(), high = range[1].get<double>();
      for (std::size_t i = 0; i < all.size(); ++i)
        all[i][name] =
            rounded(low + (high - low) * (static_cast<double>(order[i]) + 0.5) / static_cast<double>(all.size()));
    }
    return all;
  }

  Settings grid() {
    const auto* part = part_of("grid");
    Settings all{Json::object()};
    if (!part) return all;
    if (!part->is_object()) fail("/grid", "expected an object {NAME: VALUES}");
    for (const auto& [name, values] : part->items()) {
      Settings axis;
      for (const auto& value : axis_of(values, "/grid/" + pointer_part(name))) axis.push_back({{name, value}});
      multiply(all, axis);
    }
    return all;
  }

  // [VALUE, …], or {"from", "to", "count"}.
  std::vector<Json> axis_of(const Json& values, const std::string& pointer) {
    if (values.is_array() && !values.empty() && std::all_of(values.begin(), values.end(), is_setting))
      return {values.begin(), values.end()};
    const auto from = values.is_object() ? values.value("from", Json()) : Json(),
               to = values.is_object() ? values.value("to", Json()) : Json(),
               count = values.is_object() ? values.value("count", Json()) : Json();
    if (!from.is_number() || !to.is_number() || !count.is_number_unsigned() || count < 2 || count > most_sweep_points) {
      fail(pointer,
           fmt::format("found {}; expected [VALUE, …] or {{\"from\": LOW, \"to\": HIGH, \"count\": 2 or more}}",
                       in_quotes(compact(values))));
      return {};
    }
    std::vector<Json> all;
    const auto steps = count.get<std::size_t>() - 1;
    for (std::size_t i = 0; i <= steps; ++i)
      all.push_back(rounded(from.get<double>() + (to.get<double>() - from.get<double>()) * static_cast<double>(i) /
                                                     static_cast<double>(steps)));
    return all;
  }

  std::vector<std::string> texts(const std::string& name) {
    const auto* part = part_of(name);
    if (!part) return {""};
    const auto is_text = [](const Json& one) { return one.is_string() && one != ""; };
    if (!part->is_array() || part->empty() || !std::all_of(part->begin(), part->end(), is_text)) {
      fail("/" + name, fmt::format("found {}; expected a list of names", in_quotes(compact(*part))));
      return {};
    }
    return part->get<std::vector<std::string>>();
  }

  // [SEED, …], or {"from", "to"}, both included.
  std::vector<std::optional<std::uint64_t>> numbers(const std::string& name) {
    const auto* part = part_of(name);
    if (!part) return {std::nullopt};
    const auto is_number = [](const Json& one) { return one.is_number_unsigned(); };
    std::vector<std::optional<std::uint64_t>> all;
    if (part->is_array() && std::all_of(part->begin(), part->end(), is_number))
      for (const auto& one : *part) all.push_back(one.get<std::uint64_t>());
    if (part->is_object() && part->size() == 2 && is_number(part->value("from", Json())) &&
        is_number(part->value("to", Json())) && (*part)["to"] >= (*part)["from"] && (*part)["to"] <= most_sweep_points)
      for (auto seed = (*part)["from"].get<std::uint64_t>(); seed <= (*part)["to"].get<std::uint64_t>(); ++seed)
        all.push_back(seed);
    if (all.empty())
      fail("/" + name,
           fmt::format("found {}; expected [SEED, …] or {{\"from\": FIRST, \"to\": LAST}}", in_quotes(compact(*part))));
    return all;
  }

  // Each with each.
  void multiply(Settings& all, const Settings& more) {
    if (problem_) return;
    if (all.size() * more.size() > most_sweep_points) {
      problem_ = too_many();
      return;
    }
    Settings product;
    for (const auto& one : all)
      for (const auto& other : more) {
        auto both = one;
        for (const auto& [name, value] : other.items())
          if (both.contains(name))
            fail("", fmt::format("sets {} in two parts", in_quotes(name)));
          else
            both[name] = value;
        product.push_back(std::move(both));
      }
    all = std::move(product);
  }

  const LocatedJson& document_;
  std::set<std::string, std::less<>> known_;
  std::optional<Error> problem_;
};

}  // namespace

Json SweepPoint::json() const {
  Json json{{"set", set}};
  if (!policy.empty()) json["policy"] = policy;
  if (seed) json["seed"] = *seed;
  return json;
}

Result<std::vector<SweepPoint>> read_sweep_grid(std::string_view text, const std::string& name) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  if (!document->root().is_object())
    return document->error("", "expected an object with list, latin, grid, policies or seeds");
  if (!document->duplicates().empty()) {
    const auto& [place, key] = document->duplicates().front();
    return document->error(place, fmt::format("has {} twice", in_quotes(key)));
  }
  return GridReader(*document).points();
}

}  // namespace continua
