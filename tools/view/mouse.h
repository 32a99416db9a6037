// What the mouse and the keys do over the picture.
#pragma once

namespace nephrite::view {

class Viewer;

/// While UserInterface::draw() runs: turns what the mouse did over the picture into movements of the
/// camera or of the magnified picture.
void followMouse(Viewer& viewer);
/// Runs the commands whose keys were pressed, unless somebody types text.
void followKeys(Viewer& viewer);

}  // namespace nephrite::view
