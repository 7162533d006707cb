// Pictures of runs on demand; those asked for last are kept.
#pragma once

#include <list>
#include <mutex>

#include "replay/pictures/run_pictures.h"
#include "replay/run_frames.h"

namespace continua {

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

}  // namespace continua
