// Who asks for contact events: they are made while somebody does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::scene {

class ContactListeners {
public:
    /// "effect impact_sounds"
    void add(const std::string& who) {
        names_.push_back(who);
        ++revision_;
    }
    void remove(const std::string& who) {
        std::erase(names_, who);
        ++revision_;
    }
    const std::vector<std::string>& names() const { return names_; }
    /// Changes with each of the above.
    std::uint64_t revision() const { return revision_; }

private:
    std::vector<std::string> names_;
    std::uint64_t revision_{0};
};

}  // namespace plumbline::scene
