// A guard around MuJoCo's contacts between boxes.
#pragma once

namespace continua {

/// Makes MuJoCo drop contacts between two boxes that are deeper than the boxes overlap. MuJoCo's box–box routine gives
/// such contacts now and then for boxes with flush faces (2.2.2: 0.7 m deep for a block at rest on a table, which shot
/// off at 20 m/s). Applies to the whole program; a second call does nothing.
void guard_box_contacts();

}  // namespace continua
