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

/// What is asked about: at most one of these; none: the record of most interest (record_of_interest).
struct ExplainQuestion {
  std::optional<double> at_s;         ///< the last that the avatar did or refused until then, in seconds
  std::optional<std::int64_t> step;   ///< the transition of this number
  std::optional<std::int64_t> act;    ///< the act of this number
  std::optional<std::size_t> record;  ///< the record itself
};

/// The record that is asked about; the error says what the log has instead.
Result<std::size_t> asked_record(const RunIndex& run, const ExplainQuestion& question);

/// Why record n, as one object:
/// - "run": path; "n", "t", "kind", "brief": the record
/// - "headline": what happened and what it is due to, a sentence; of an act also how it went
/// - "about": n of the record that the rest is about: n, but of an expectation what it was held against, and of a state
///   of an act the asking for it
/// - "chain": [{"n", "t", "kind", "brief"}] from the record up through its causes
/// - "inputs": what contributed (explained_inputs)
/// - "steps": the transitions that led here (explained_steps); "choice": the policy that chose among candidates
/// - "refused": what a refusal's transitions said (explained_refusals), else null
/// - "stack": what changed (explained_stack)
/// - "cells": what is on the stack at n, since when and where from (explained_cells)
/// - "derivation": the term behind it (derivation_of) or null
/// - "act": how it went (explained_act) or null
/// - "brought_about": what the record led to at once, [{"n", "kind", "brief"}]; "along": what else its cause did
/// - "fragile": [{"n", "margin"}] of the readings and transitions behind it that the log's end lists as such
/// - "trouble": what is wrong with the log's end, or empty
///
/// REQUIRES n < run.size(). An error when the record cannot be read.
Result<Json> explain(const RunIndex& run, std::size_t n);

/// How the value of a cell of the stack ("SYMBOL.SLOT") came about, told from record n, which set it:
/// {"n", "cell", "value", "derivation": derivation_of}. REQUIRES n < run.size(). An error when there is no such cell.
Result<Json> explain_cell(const RunIndex& run, std::size_t n, const std::string& cell);

}  // namespace continua
