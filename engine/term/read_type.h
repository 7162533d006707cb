// Types in JSON documents.
#pragma once

#include "continua/core/document_reader.h"
#include "continua/term/type.h"

namespace continua {

/// The type that a text of a document describes, such as "e -> loc". Anything else is a problem of the item, and gives
/// the type of terms; so does an absent item, without a problem.
Type read_type(const Item& item);

}  // namespace continua
