// ELAN's annotation files (.eaf), version 3.0, checked against ELAN's schema by the tests.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/result.h"
#include "continua/replay/annotation/annotations.h"

namespace continua {

/// The file. An annotation's id is "a16" for record, or line, 16; of several of one record the second is "a16-2". The
/// events of a tier are a tier below it, by Symbolic_Association.
std::string eaf_of(const Annotations& annotations);

/// Reads a file of any program. Annotations that refer to others have these's time, or their share of it; time slots
/// without a time are spread evenly between their neighbours. Errors: it is no annotation file, its times are not in
/// milliseconds, or an annotation refers to nothing.
Result<Annotations> read_eaf(std::string_view text, const std::string& name);

}  // namespace continua
