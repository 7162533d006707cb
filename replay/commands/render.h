// continua render: pictures and films of a run.
#pragma once

#include <optional>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/commands/command.h"

namespace continua {

struct RenderOptions {
  std::string run, output;
  std::optional<double> at_s;
  std::string size;    ///< "WxH"; empty: what suits the output
  std::string camera;  ///< RenderView::camera
  int frames_per_second = 24;
  bool text = true;
  bool real_time = false;  ///< a film does not shorten waits
};

int run_render(const RenderOptions& options);

void describe_render(CLI::App& command, RenderOptions& options);

}  // namespace continua
