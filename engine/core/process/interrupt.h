// Ctrl-C and its kin, as a flag that loops look at: what was done so far is kept.
#pragma once

namespace plumbline {

/// From now on the first SIGINT, SIGTERM or SIGHUP sets the flag of interrupted(); a second one ends the
/// program at once. A program that is still there a second after the first signal is ended too, with exit
/// code 130 and a line on the standard error output, unless a PollsInterrupts lives. Files are written
/// whole or not at all, so none is left half written. SIGINT and SIGHUP stay ignored where they were
/// ignored at the start: a script's background job and a program under nohup are ended by SIGTERM.
void catch_interrupts();
bool interrupted();
/// The program has done all it wanted and ends: from now on only a second signal hurries it.
void cancel_cut_off();

/// From now on a write into a closed pipe (SIGPIPE) or beyond the limit of a file's size (SIGXFSZ) fails
/// and does not end the program.
void ignore_write_signals();

/// While one lives the program looks at interrupted() and ends by itself, however long that takes.
class PollsInterrupts {
public:
    PollsInterrupts();
    PollsInterrupts(const PollsInterrupts&) = delete;
    PollsInterrupts& operator=(const PollsInterrupts&) = delete;
    ~PollsInterrupts();
};

/// Work within the life of a PollsInterrupts in which nobody looks at the flag, as a step of physics is: the
/// program is ended a second after the signal, as without a PollsInterrupts.
class IgnoresInterrupts {
public:
    IgnoresInterrupts();
    IgnoresInterrupts(const IgnoresInterrupts&) = delete;
    IgnoresInterrupts& operator=(const IgnoresInterrupts&) = delete;
    ~IgnoresInterrupts();
};

}  // namespace plumbline
