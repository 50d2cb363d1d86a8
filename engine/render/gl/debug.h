// Messages from the driver.
#pragma once

namespace plumbline::render::gl {

/// In builds without NDEBUG, and where the context has KHR_debug: driver errors go to the log.
void listen_to_driver();

}  // namespace plumbline::render::gl
