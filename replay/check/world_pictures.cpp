#include "continua/replay/check/world_pictures.h"

#include <fmt/format.h>

#include "continua/replay/inspector/page_parts.h"
#include "continua/replay/log/time_text.h"

namespace continua {
namespace {

constexpr const char* picture_size_px = "640x360";

class Pictures {
 public:
  explicit Pictures(std::shared_ptr<RunFrames> frames) : frames_(std::move(frames)), trouble_(frames_->unavailable()) {}

  WorldPictures::Side side(const char* name, const std::shared_ptr<const RunIndex>& run, SimTime t) {
    WorldPictures::Side side{fmt::format("{}, at {}", name, time_text(t.seconds())), ""};
    const auto png = trouble_ ? Result<std::string>(*trouble_) : frames_->png(run, t, picture_size_px);
    if (png)
      side.png = base64(*png);
    else
      side.trouble = png.error().sentence;
    return side;
  }

 private:
  std::shared_ptr<RunFrames> frames_;
  Outcome trouble_;
};

// The instant of the first record of a difference; of a run that lacks it, that of the other.
SimTime instant_of(const RunIndex& run, const std::vector<std::size_t>& own, const RunIndex& other,
                   const std::vector<std::size_t>& others) {
  if (!own.empty()) return run.entry(own.front()).t;
  const auto end = run.entry(run.size() - 1).t;
  return others.empty() ? end : std::min(end, other.entry(others.front()).t);
}

}  // namespace

std::vector<WorldPictures> pictures_of(const ComparedRuns& runs, const std::shared_ptr<RunFrames>& frames) {
  // Both outlive the pictures; the owner lets the drawer know until when.
  const auto owner = std::make_shared<int>();
  const std::shared_ptr<const RunIndex> a(owner, &runs.approved), b(owner, &runs.run);
  Pictures pictures(frames);
  std::vector<WorldPictures> all;
  constexpr const char *approved = "A: approved", *now = "B: now";
  if (const auto& diff = runs.diff; diff.first < diff.differences.size()) {
    const auto& first = diff.differences[diff.first];
    all.push_back({"Where they part",
                   {pictures.side(approved, a, instant_of(*a, first.a, *b, first.b)),
                    pictures.side(now, b, instant_of(*b, first.b, *a, first.a))}});
  }
  all.push_back(
      {"At the end",
       {pictures.side(approved, a, a->entry(a->size() - 1).t), pictures.side(now, b, b->entry(b->size() - 1).t)}});
  return all;
}

}  // namespace continua
