// A machine as the header of a run log has it.
#pragma once

#include "continua/automaton/machine.h"
#include "continua/replay/log/records_of_log.h"

namespace continua {

/// States and transitions in the order of the machine file; a transition from several states gives an edge for each.
log::Graph graph_of(const Machine& machine);

}  // namespace continua
