#include "engine/core/assert.h"

#include "engine/core/log.h"

#include <cstdlib>

namespace plumbline {

void assertion_failed(std::string_view condition,
                      std::string_view expected,
                      std::string_view file,
                      int line) {
    log_error("{}:{}: expected {} ({})", file, line, expected, condition);
    std::abort();
}

}  // namespace plumbline
