// In how few seconds small games were won: kept from one time to the next.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace plumbline::app {

class BestResults {
public:
    /// Reads the file, if it is there; empty: nothing is kept. One that is damaged is said and left as it is.
    explicit BestResults(std::filesystem::path file);

    std::optional<double> of(const std::string& scene) const;
    /// Keeps the time, in s, if it is the scene's first or shorter than before.
    void note(const std::string& scene, double time_s);

private:
    void store() const;

    std::filesystem::path file_;
    std::map<std::string, double> best_s_;
};

}  // namespace plumbline::app
