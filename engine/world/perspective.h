// Whose left, right, front and behind words and place terms mean. The human faces the avatar across the table.
#pragma once

namespace continua {

enum class Perspective { human, avatar };

}  // namespace continua
