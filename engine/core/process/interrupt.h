// Ctrl-C and its kin, as a flag that loops look at: what was done so far is kept.
#pragma once

namespace plumbline {

/// From now on SIGINT, SIGTERM and SIGHUP only set the flag; a second one ends the program at once.
/// SIGPIPE is ignored: a closed pipe shows as a failed write.
void catch_interrupts();
bool interrupted();

/// Work in which nobody looks at the flag, as a step of physics is. If it still lasts a second after the
/// signal, the program is ended there, with exit code 130 and a line on the standard error output: files are
/// written whole or not at all, so none is left half written.
class UnheedingWork {
public:
    UnheedingWork();
    UnheedingWork(const UnheedingWork&) = delete;
    UnheedingWork& operator=(const UnheedingWork&) = delete;
    ~UnheedingWork();
};

}  // namespace plumbline
