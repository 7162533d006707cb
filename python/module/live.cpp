// Sessions that are driven live.
#include <optional>

#include "continua/replay/live/live_sessions.h"
#include "module.h"

namespace py = pybind11;

namespace continua {
namespace {

// A session whose time goes by its events. It listens to itself, so it does not end for lack of company.
class Live {
 public:
  Live(const std::string& asked, const std::string& folder, bool physics, const std::string& knowledge) {
    LiveDefaults defaults;
    defaults.folder = folder;
    defaults.timing = LiveTiming::events;
    defaults.replay.physics = physics;
    defaults.replay.knowledge = knowledge;
    sessions_ = value_of(LiveSessions::create(std::move(defaults)));
    auto started = sessions_->start(value_of(parse_json_line(asked, "session", 1)), true);
    if (const auto* refusal = std::get_if<LiveRefusal>(&started)) raise({"session", refusal->sentence});
    session_ = std::get<ListedSession>(started).session;
    session_->audience().attend(true, 1);
  }

  std::vector<std::string> hear(const std::string& events) {
    return value_of(session_->receive(value_of(events_in(events)))).moves;
  }
  void end() { session_->end(); }
  double t() const { return session_->audience().state().t.seconds(); }
  std::string state() const { return session_->audience().state().machine_state; }
  std::string warning() const { return session_->setting().warning ? session_->setting().warning->text() : ""; }
  const std::string& trace_path() const { return session_->setting().options.trace_path; }
  const std::string& log_path() const { return session_->setting().options.log_path; }

 private:
  std::shared_ptr<LiveSessions> sessions_;
  std::shared_ptr<LiveSession> session_;
};

}  // namespace

void define_live(py::module_& module) {
  using namespace py::literals;
  py::class_<Live>(module, "Live", "A session whose time goes by its events.")
      .def(py::init<const std::string&, const std::string&, bool, const std::string&>(), "asked"_a, "folder"_a,
           "physics"_a, "knowledge"_a, Released())
      .def("hear", &Live::hear, "events"_a, "Takes events, as JSON, and gives the avatar's moves since, each as JSON.",
           Released())
      .def("end", &Live::end, "Nothing more happens.", Released())
      .def_property_readonly("t", &Live::t, "Seconds.")
      .def_property_readonly("state", &Live::state, "The name of the machine's state.")
      .def_property_readonly("warning", &Live::warning, "The unknown things of the scene; else empty.")
      .def_property_readonly("trace_path", &Live::trace_path)
      .def_property_readonly("log_path", &Live::log_path);
}

}  // namespace continua
