// "One", which stands for a noun that was used before: the topic.
#pragma once

#include "continua/language/operators.h"

namespace continua {

/// The condition with `topic`, of type e -> t, in place of "one", so that the reasons of ruled-out objects name it.
Term with_topic(const Term& condition, const Term& topic, const Operators& operators);

/// Whether the condition says more than "one" or "the other one".
bool describes_more(const Term& condition, const Operators& operators);

/// Whether the condition, or a part of it, compares things of the topic: "the left one", "the nearest one".
bool compares_topics(const Term& part, const Operators& operators);

}  // namespace continua
