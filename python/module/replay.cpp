// Replays.
#include <map>

#include <fmt/format.h>

#include "continua/replay/log/run_log_file.h"
#include "continua/replay/session/outside_choice.h"
#include "continua/replay/session/session.h"
#include "module.h"

namespace py = pybind11;

namespace continua {
namespace {

template <class T>
void take(const py::dict& given, const char* name, T& option) {
  if (given.contains(name)) option = given[name].cast<T>();
}

ReplayOptions options_of(const py::dict& given) {
  ReplayOptions options;
  take(given, "scene", options.scene);
  take(given, "machine", options.machine);
  take(given, "language", options.language);
  take(given, "knowledge", options.knowledge);
  take(given, "weights", options.weights);
  take(given, "learned", options.learned);
  take(given, "with", options.with);
  take(given, "seed", options.seed);
  take(given, "from", options.from);
  std::string choice;
  take(given, "choice", choice);
  options.choice = parse_choice(choice);
  if (is_outside_choice(choice))
    options.outside = choice;
  else if (!choice.empty() && !options.choice)
    raise({"choice", fmt::format("found {}; expected {}, pipe:COMMAND or run:RUN", in_quotes(choice), choice_names())});
  return options;
}

// Whether the user wants the call to end; Python's exception is set then.
bool is_interrupted() {
  const py::gil_scoped_acquire lock;
  return PyErr_Occurred() || PyErr_CheckSignals() != 0;
}

std::vector<std::string> replayed(const std::string& trace, const std::string& output, ReplayOptions options) {
  auto session = value_of(Session::load(trace, std::move(options)));
  std::vector<std::string> warnings;
  if (session.warning()) warnings.push_back(session.warning()->text());
  done(not_an_input({output}, session.files()));
  RunLogFile file(output);
  const auto summary = session.run(file.stream());
  if (is_interrupted()) {
    const py::gil_scoped_acquire lock;
    throw py::error_already_set();
  }
  if (summary.stopped) raise(*summary.stopped);
  done(file.commit());
  done(session.keep_learned());
  for (const auto& [step, transition] : summary.not_forced)
    warnings.push_back(fmt::format("forced {} at step {}: that transition does not apply there", transition, step));
  if (session.options().from && !summary.changed)
    warnings.push_back(fmt::format("nothing happens from {} s on; nothing was changed", *session.options().from));
  return warnings;
}

}  // namespace

void define_replay(py::module_& module) {
  using namespace py::literals;
  module.def(
      "replay",
      [](const std::string& trace, const std::string& output, bool physics, const py::dict& given,
         const std::map<int, std::string>& forced) {
        auto options = options_of(given);
        options.physics = physics;
        options.forced = forced;
        options.give_up = is_interrupted;
        const py::gil_scoped_release released;
        return replayed(trace, output, std::move(options));
      },
      "trace"_a, "output"_a, "physics"_a, "options"_a, "forced"_a,
      "Replays a trace into a run log. Gives the warnings.");
}

}  // namespace continua
