// The last lines of the log, for a report of a crash.
#pragma once

namespace plumbline {

/// The last lines that were shown, oldest first, to a file descriptor. May be called in a signal
/// handler; a line that another thread writes just then may be torn.
void write_last_log_lines(int file);

}  // namespace plumbline
