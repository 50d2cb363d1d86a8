// Ctrl-C and its kin, as a flag that loops look at: what was done so far is kept.
#pragma once

namespace plumbline {

/// From now on SIGINT, SIGTERM and SIGHUP only set the flag; a second one ends the program at once.
/// SIGPIPE is ignored: a closed pipe shows as a failed write.
void catch_interrupts();
bool interrupted();

}  // namespace plumbline
