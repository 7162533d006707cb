// Types in JSON documents.
#pragma once

#include "continua/core/document_reader.h"
#include "continua/term/type.h"

namespace continua {

/// The type that a text of a document describes, such as "e -> loc". Anything else is a problem of the item and gives
/// Type::term(). An absent item gives Type::term() without a problem.
Type read_type(const Item& item);

}  // namespace continua
