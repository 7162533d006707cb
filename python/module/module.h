// The parts of the module, and how errors of the program reach Python.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

void define_log(pybind11::module_& module);
void define_replay(pybind11::module_& module);
void define_live(pybind11::module_& module);

/// Raises continua.errors.Error. Takes Python's lock for that, if it is not held.
[[noreturn]] void raise(const Error& error);

template <class T>
T value_of(Result<T> result) {
  if (!result) raise(result.error());
  return *std::move(result);
}

inline void done(const Outcome& problem) {
  if (problem) raise(*problem);
}

/// JSON as one line; bytes that are no UTF-8 are replaced.
inline std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Lets other threads of Python go on during a call.
using Released = pybind11::call_guard<pybind11::gil_scoped_release>;

}  // namespace continua
