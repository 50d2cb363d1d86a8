// What is wrong with a text that somebody wrote, place by place.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace plumbline {

enum class Severity { Warning, Error };

/// One fault in one file.
struct Diagnostic {
    Severity severity{Severity::Error};
    std::string file;     ///< as the person named it
    int line{0};          ///< from 1; 0 when the whole file is meant
    int column{0};        ///< from 1; 0 when unknown
    std::string key;      ///< dotted path, e.g. entity[3].body.mass_kg; may be empty
    std::string message;  ///< what was found, what was expected, what is used instead
};

/// "garden.toml:14:9: error: entity[3].body.mass_kg: …", as compilers print.
std::string to_string(const Diagnostic& diagnostic);

/// Faults in the order they were found.
class Diagnostics {
public:
    void add(Diagnostic diagnostic) { list_.push_back(std::move(diagnostic)); }
    /// What is wrong with a file as a whole.
    void add_error(std::string file, std::string message) {
        add({.file = std::move(file), .key = {}, .message = std::move(message)});
    }
    bool has_errors() const;
    const std::vector<Diagnostic>& list() const { return list_; }

private:
    std::vector<Diagnostic> list_;
};

/// Each on a line of the log, as an error or a warning.
void log_faults(const Diagnostics& faults);

}  // namespace plumbline
