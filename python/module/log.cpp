// Run logs: the stack, reasons, the page, pictures and differences.
#include <optional>
#include <sstream>
#include <tuple>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/replay/diff/run_diff_text.h"
#include "continua/replay/explain/explain.h"
#include "continua/replay/explain/explain_text.h"
#include "continua/replay/inspector/page_file.h"
#include "continua/replay/log/run_log_file.h"
#include "continua/replay/log/run_views.h"
#include "continua/replay/pictures/picture_size.h"
#include "continua/replay/pictures/run_pictures.h"
#include "continua/replay/terminal/terminal.h"
#include "module.h"

namespace py = pybind11;

namespace continua {
namespace {

// As JSON, as text and as a tree.
std::tuple<std::string, std::string, std::string> explained(const RunIndex& run, const ExplainQuestion& question) {
  const auto answer = value_of(explain(run, value_of(asked_record(run, question))));
  return {line_of(answer), printable(explain_text(answer, {})), printable(explain_tree(answer, {}))};
}

// As JSON, as text and as Markdown.
std::tuple<std::string, std::string, std::string> compared(const RunIndex& a, const RunIndex& b, double tolerance_m,
                                                           std::size_t most) {
  const auto diff = value_of(diff_runs(a, b, {tolerance_m}));
  return {line_of(diff_json(a, b, diff)), printable(diff_text(a, b, diff, {false, most})), diff_markdown(a, b, diff)};
}

std::string page_of(const RunIndex& run) {
  std::ostringstream page;
  done(write_page(run.path(), page));
  return std::move(page).str();
}

std::string picture_of(const RunIndex& run, double at_s, const std::string& size, const std::string& camera) {
  const auto end = run.entry(run.size() - 1).t;
  if (!(at_s >= 0 && at_s <= end.seconds()))
    raise({run.path(), fmt::format("found the instant {} s; expected one from 0 to {}", at_s, end.seconds())});
  auto pictures = value_of(RunPictures::open(run, {.size = value_of(picture_size(size)), .camera = camera}));
  return pictures.at(SimTime::from_seconds(at_s)).png();
}

}  // namespace

void define_log(py::module_& module) {
  using namespace py::literals;
  py::class_<RunIndex>(module, "Log", "A run log held open.")
      .def(py::init([](const std::string& path) { return value_of(RunIndex::open(path)); }), "path"_a, Released())
      .def(
          "stack", [](const RunIndex& run, std::size_t n) { return line_of(value_of(run_stack(run, n))); }, "n"_a,
          "The stack as it stood at record n, as JSON. n is below the number of records.", Released())
      .def(
          "explain",
          [](const RunIndex& run, std::optional<std::size_t> record, std::optional<double> at,
             std::optional<std::int64_t> act, std::optional<std::int64_t> step) {
            return explained(run, {.at_s = at, .step = step, .act = act, .record = record});
          },
          "record"_a, "at"_a, "act"_a, "step"_a,
          "Why the record that is asked about: as JSON, as text, and the term behind it as a tree.", Released())
      .def("page", &page_of, "The inspector's page with this run in it, as HTML.", Released())
      .def(
          "picture",
          [](const RunIndex& run, double at_s, const std::string& size, const std::string& camera) {
            std::string png;
            {
              const py::gil_scoped_release released;
              png = picture_of(run, at_s, size, camera);
            }
            return py::bytes(png);
          },
          "at_s"_a, "size"_a, "camera"_a, "The run at an instant, as the bytes of a PNG file.")
      .def(
          "save", [](const RunIndex& run, const std::string& path) { done(rewrite_run_log(run.path(), path)); },
          "path"_a, "Writes the whole log.", Released());
  module.def("diff", &compared, "a"_a, "b"_a, "tolerance_m"_a, "most"_a,
             "Where two runs part, and why: as JSON, as text and as Markdown.", Released());
  module.def(
      "digest", [](const py::bytes& bytes) { return digest(static_cast<std::string_view>(bytes)); }, "bytes"_a,
      "The digest that names documents of logs.");
}

void raise(const Error& error) {
  const py::gil_scoped_acquire lock;
  // Options of the program are arguments here.
  const std::string where = error.where.substr(error.where.starts_with("--") ? 2 : 0);
  PyErr_SetString(py::module_::import("continua.errors").attr("Error").ptr(),
                  Error{where, error.sentence}.text().c_str());
  throw py::error_already_set();
}

}  // namespace continua
