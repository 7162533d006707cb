// The choices for a live session, and the human's buttons on the page: from data.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/perception/gesture.h"

namespace continua {

/// {"scenes": [names], "machines": [names], "scene", "machine": the ones taken where none is named, "buttons":
/// [{"label", "key", "event"}]}, the last three from knowledge/live.json. Errors: the file cannot be read.
Result<Json> live_setup(const DataPaths& data);

/// All that is wrong with the text of a live.json of this data, in the order of the file: unknown keys, a scene or
/// machine that is not there, buttons without a label, a key of their own (one letter) or an event that can be sent.
std::vector<Error> check_live_setup(std::string_view text, const std::string& path, const DataPaths& data);

/// The gestures that a human may make, [{"label": in words, "about", "event": of a trace, without `t`}]: those of the
/// catalogue, in each direction with a meaning; for a machine without catalogue (null) those that its transitions know
/// by name.
Json gesture_palette(const Machine& machine, const GestureCatalogue* gestures);

}  // namespace continua
