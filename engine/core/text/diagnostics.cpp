#include "engine/core/text/diagnostics.h"

#include "engine/core/log.h"
#include "engine/core/text/printable.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {

std::string to_string(const Diagnostic& diagnostic) {
    std::string place = diagnostic.file;
    if (diagnostic.line > 0) place += fmt::format(":{}", diagnostic.line);
    if (diagnostic.line > 0 && diagnostic.column > 0)
        place += fmt::format(":{}", diagnostic.column);
    const char* severity = diagnostic.severity == Severity::Error ? "error" : "warning";
    const std::string key = diagnostic.key.empty() ? "" : diagnostic.key + ": ";
    return printable_lines(fmt::format("{}: {}: {}{}", place, severity, key, diagnostic.message));
}

bool Diagnostics::has_errors() const {
    return std::ranges::any_of(list_,
                               [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

void log_faults(const Diagnostics& faults) {
    for (const Diagnostic& fault : faults.list())
        log_line(fault.severity == Severity::Error ? LogLevel::Error : LogLevel::Warning,
                 to_string(fault));
}

}  // namespace plumbline
