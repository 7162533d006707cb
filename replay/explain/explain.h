// Why a run went as it did at one of its records: an act, an utterance, a question, a refusal, or any other. Made of
// the log alone (RUNLOG.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// The subject of the question: at most one of these; none: the record of most interest (record_of_interest).
struct ExplainQuestion {
  std::optional<double> at_s;         ///< the last that the avatar did or refused until then, in seconds
  std::optional<std::int64_t> step;   ///< the transition of this number
  std::optional<std::int64_t> act;    ///< the act of this number
  std::optional<std::size_t> record;  ///< the record itself
};

/// The record in question; the error lists the records that the log has instead.
Result<std::size_t> asked_record(const RunIndex& run, const ExplainQuestion& question);

/// Why record n, as one object:
/// - "run": path; "n", "t", "kind", "brief": the record
/// - "headline": the event and its reason, a sentence; of an act also its outcome; "raw": with the log's own names
/// - "about": n of the record that the rest is about: n itself; of an expectation the record it was held against; of a
///   state of an act the record that asked for it
/// - "chain": [{"n", "t", "kind", "brief", "told": the same in words}] from the record up through its causes
/// - "inputs": the inputs that contributed (explained_inputs)
/// - "steps": the transitions that led here (explained_steps); "choice": the policy that chose among candidates
/// - "refused": of a refusal the reasons of its transitions (explained_refusals), else null
/// - "stack": the changes of the stack (explained_stack)
/// - "cells": the cells of the stack at n, since when and where from (explained_cells)
/// - "derivation": the term behind it (derivation_of) or null
/// - "act": the course of the act (explained_act) or null
/// - "brought_about": the immediate consequences, [{"n", "kind", "brief", "told"}]; "along": the other
///   consequences of its cause
/// - "fragile": [{"n", "margin"}] of the readings and transitions behind it that the log's end lists as fragile
/// - "trouble": the fault of the log's end, or empty
///
/// REQUIRES n < run.size(). An error when the record cannot be read.
Result<Json> explain(const RunIndex& run, std::size_t n);

/// How the value of a cell of the stack ("SYMBOL.SLOT") came about, told from record n, which set it:
/// {"n", "cell", "value", "derivation": derivation_of}. REQUIRES n < run.size(). An error when there is no such cell.
Result<Json> explain_cell(const RunIndex& run, std::size_t n, const std::string& cell);

}  // namespace continua
