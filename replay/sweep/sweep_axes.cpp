#include "continua/replay/sweep/sweep_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

namespace continua {
namespace {

SweepAxis axis_of(const std::string& name, const std::vector<std::optional<Json>>& values) {
  SweepAxis axis{name, {}, std::vector<std::optional<std::size_t>>(values.size())};
  std::vector<Json> levels;
  for (const auto& value : values)
    if (value && std::find(levels.begin(), levels.end(), *value) == levels.end()) levels.push_back(*value);
  const bool numbers = std::all_of(levels.begin(), levels.end(), [](const Json& one) { return one.is_number(); });
  if (numbers) std::sort(levels.begin(), levels.end());
  const bool parts = numbers && levels.size() > most_levels;
  const auto low = parts ? levels.front().get<double>() : 0, high = parts ? levels.back().get<double>() : 0;
  const auto step = (high - low) / static_cast<double>(most_levels);
  for (std::size_t i = 0; i < (parts ? most_levels : levels.size()); ++i)
    axis.levels.push_back(parts ? fmt::format("{:.4g}", low + step * (static_cast<double>(i) + 0.5))
                                : text_of_value(levels[i]));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    axis.level_of[i] =
        parts ? std::min(most_levels - 1, static_cast<std::size_t>((values[i]->get<double>() - low) / step))
              : static_cast<std::size_t>(std::find(levels.begin(), levels.end(), *values[i]) - levels.begin());
  }
  return axis;
}

// Student's t for 95 % and so many degrees of freedom, from 1 on.
double student_t(std::size_t freedom) {
  constexpr std::array t = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                            2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                            2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
  // Beyond the table, Cornish and Fisher's first term about the normal quantile.
  return freedom <= t.size() ? t[freedom - 1] : 1.960 + 2.372 / static_cast<double>(freedom);
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const auto value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

template <class Has>
SweepMean mean_where(const std::vector<SweptPoint>& points, const std::string& figure, Has has) {
  std::map<std::string, std::vector<double>> of_seed;
  std::vector<double> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto found = points[i].figures.find(figure);
    if (found == points[i].figures.end() || !has(i)) continue;
    all.push_back(found->second);
    of_seed[points[i].seed].push_back(found->second);
  }
  if (all.empty()) return {};
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  SweepMean mean{all.size(), mean_of(all), *low, *high};
  if (of_seed.size() < 2) return mean;
  std::vector<double> means;
  for (const auto& [seed, values] : of_seed) means.push_back(mean_of(values));
  double squares = 0;
  const auto middle = mean_of(means);
  for (const auto one : means) squares += (one - middle) * (one - middle);
  const auto count = static_cast<double>(means.size());
  const auto half = student_t(means.size() - 1) * std::sqrt(squares / (count - 1) / count);
  return {all.size(), middle, middle - half, middle + half};
}

}  // namespace

std::vector<SweepAxis> axes_of(const std::vector<SweptPoint>& points) {
  std::vector<SweepAxis> axes;
  for (const auto& name : names_of_values(points)) {
    std::vector<std::optional<Json>> values;
    for (const auto& point : points) {
      auto all = point.values();
      const auto found = all.find(name);
      values.push_back(found == all.end() ? std::nullopt : std::optional(std::move(found->second)));
    }
    auto axis = axis_of(name, values);
    if (axis.levels.size() > 1) axes.push_back(std::move(axis));
  }
  return axes;
}

SweepMean mean_at(const std::vector<SweptPoint>& points, const std::string& figure, const SweepAxis& axis,
                  std::size_t level) {
  return mean_where(points, figure, [&](std::size_t i) { return axis.level_of[i] == level; });
}

SweepMean mean_at(const std::vector<SweptPoint>& points, const std::string& figure, const SweepAxis& across,
                  std::size_t column, const SweepAxis& down, std::size_t row) {
  return mean_where(points, figure,
                    [&](std::size_t i) { return across.level_of[i] == column && down.level_of[i] == row; });
}

bool has_seeds(const std::vector<SweptPoint>& points) {
  return std::any_of(points.begin(), points.end(),
                     [&](const SweptPoint& point) { return point.seed != points.front().seed; });
}

}  // namespace continua
