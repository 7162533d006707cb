// A guard around MuJoCo's contacts between boxes.
#pragma once

namespace continua {

/// Makes MuJoCo drop contacts between two boxes that are deeper than the boxes overlap. MuJoCo's box–box routine gives
/// such contacts now and then for boxes with flush faces (2.2.2: 0.7 m deep for a block at rest on a table, which shot
/// off at 20 m/s). And makes boxes whose faces are flush touch by these, not by two edges: 3.12 takes the edges where
/// they are a twentieth less deep, so a block that stands a few micrometres deep over the table's edge would lose three
/// of its four contacts for a step, again and again. Applies to the whole program; a second call does nothing.
void guard_box_contacts();

}  // namespace continua
