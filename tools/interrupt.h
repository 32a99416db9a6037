// Ctrl-C, and the signal by which batch systems end a job, as a question a loop can ask.
#pragma once

namespace nephrite::tools {

/// From now on the first Ctrl-C or SIGTERM only makes interrupted() true; a second one ends the program at
/// once.
void catchInterrupts();
bool interrupted();

}  // namespace nephrite::tools
