// The module continua._engine: functions of the program for the package continua, which knows the records. JSON goes
// over as text, in the form of the program's own answers. No call holds Python up while it works.
#include "module.h"

PYBIND11_MODULE(_engine, module) {
  module.doc() = "Functions of the program, for the package around this module.";
  continua::define_log(module);
  continua::define_replay(module);
  continua::define_live(module);
}
