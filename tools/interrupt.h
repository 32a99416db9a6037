// Ctrl-C as a question a loop can ask.
#pragma once

namespace nephrite::tools {

/// From now on the first Ctrl-C only makes interrupted() true; a second one ends the program at once.
void catchInterrupts();
bool interrupted();

}  // namespace nephrite::tools
