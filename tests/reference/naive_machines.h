// Small machines to hold the engine against its naive twin: all of a kind where they are few, else drawn by number.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/naive_automaton.h"

namespace naive {

/// In the format of machine files. Its states are P, Q, R, its inputs a and b, its transitions t0, t1 ….
std::string json(const Machine& machine);

/// For every two operations, a machine that does one at `a` and the other at `b`; every fourth also has ε-transitions.
std::vector<Machine> machines_of_two_operations();

/// The features that a sampled machine may have.
struct Limits {
  bool pop_until = true;
  bool after_rewrite = true;
};

/// Up to three states, two inputs, two values of a slot; the same for the same number.
Machine sampled_machine(std::uint64_t number, const Limits& limits = {});

}  // namespace naive
