// A guard around MuJoCo's contacts between boxes.
#pragma once

namespace continua {

/// Makes MuJoCo leave out contacts between two boxes that are deeper than the boxes overlap. Its box–box routine gives
/// such contacts now and then for boxes whose faces lie flush (2.2.2: a block at rest on a table was told to be 0.7 m
/// deep in it, and shot off at 20 m/s). Holds for the whole program; calling it again does nothing.
void guard_box_contacts();

}  // namespace continua
