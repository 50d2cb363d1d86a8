#include "engine/core/assert.h"
#include "engine/input/bindings_layer.h"

namespace plumbline::input {

extern const char
    kShippedBindings[];  // config/bindings.toml: CMakeLists.txt puts it into the program

Bindings built_in_bindings() {
    Bindings bindings;
    Diagnostics faults;
    const std::optional<LayerContent> content =
        read_layer({.name = "built-in", .text = kShippedBindings}, bindings.tuning, faults);
    PL_ASSERT(content && faults.list().empty(), "known words in config/bindings.toml");
    bindings.origin.fill("built-in");
    for (const LayerHold& hold : content->holds)
        bindings.hold_mode[index_of(hold.action)] = hold.mode;
    for (const LayerLine& line : content->lines) {
        std::vector<Input>& inputs = bindings.inputs[index_of(line.action)];
        for (const LocatedInput& entry : line.inputs) {
            inputs.push_back(entry.input);
            inputs.back().origin = "built-in";
        }
    }
    return bindings;
}

}  // namespace plumbline::input
