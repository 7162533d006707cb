#include "continua/replay/pictures/frame_cache.h"

#include <algorithm>
#include <list>
#include <mutex>

#include "continua/replay/pictures/picture_size.h"
#include "continua/replay/pictures/run_pictures.h"

namespace continua {
namespace {

constexpr std::size_t most_opened = 4, most_drawn = 64;
constexpr ImageSize usual{640, 360};

/// The one for which `fits`, now the first of `list`; null: none.
template <class Kept, class Fits>
Kept* last_used(std::list<Kept>& list, const std::shared_ptr<const RunIndex>& run, Fits fits) {
  std::erase_if(list, [](const Kept& one) { return one.run.expired(); });
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Kept& one) { return one.run.lock() == run && fits(one); });
  if (found == list.end()) return nullptr;
  list.splice(list.begin(), list, found);
  return &list.front();
}

class FrameCache : public RunFrames {
 public:
  Outcome unavailable() override;
  Outcome wrong_size(const std::string& size) override;
  Result<std::string> png(const std::shared_ptr<const RunIndex>& run, SimTime t, const std::string& size) override;

 private:
  struct Opened {
    std::weak_ptr<const RunIndex> run;
    ImageSize size;
    RunPictures pictures;
  };
  struct Drawn {
    std::weak_ptr<const RunIndex> run;
    ImageSize size;
    SimTime t;
    std::string png;
  };
  std::mutex mutex_;
  std::list<Opened> opened_;  // the last used first, as below
  std::list<Drawn> drawn_;
};

Outcome FrameCache::unavailable() { return cannot_render(); }

Outcome FrameCache::wrong_size(const std::string& size) {
  if (size.empty()) return std::nullopt;
  const auto read = picture_size(size);
  return read ? std::nullopt : Outcome(read.error());
}

Result<std::string> FrameCache::png(const std::shared_ptr<const RunIndex>& run, SimTime t, const std::string& size) {
  const auto pixels = size.empty() ? usual : picture_size(size).value();
  const std::lock_guard lock(mutex_);
  const auto* drawn = last_used(drawn_, run, [&](const Drawn& one) { return one.size == pixels && one.t == t; });
  if (drawn) return drawn->png;
  auto* opened = last_used(opened_, run, [&](const Opened& one) { return one.size == pixels; });
  if (!opened) {
    auto pictures = RunPictures::open(*run, {pixels, "", false});
    if (!pictures) return pictures.error();
    opened_.push_front({run, pixels, std::move(pictures).value()});
    if (opened_.size() > most_opened) opened_.pop_back();
    opened = &opened_.front();
  }
  drawn_.push_front({run, pixels, t, opened->pictures.at(t).png()});
  if (drawn_.size() > most_drawn) drawn_.pop_back();
  return drawn_.front().png;
}

}  // namespace

std::shared_ptr<RunFrames> drawn_frames() { return std::make_shared<FrameCache>(); }

}  // namespace continua
