// Decides whether a running hard case still holds its rules. The gallery's job and the game call it after
// every step.
#pragma once

#include "engine/core/result.h"
#include "engine/scene/simulation.h"
#include "engine/study/gallery/measures.h"
#include "engine/study/words.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plumbline::study {

enum class Verdict : std::uint8_t { Undecided, Pass, Fail };
template <>
inline constexpr std::array<std::string_view, 3> kWords<Verdict>{"undecided", "pass", "fail"};

/// What a rule allows.
struct Allowed {
    enum class Kind : std::uint8_t { Below, Above, Near };
    Kind kind{Kind::Below};
    double limit{0};   ///< Near: the value to be near to
    double within{0};  ///< Near

    /// How far inside (> 0) or outside (< 0), as a share of the limit, or of `within`. Where that is
    /// 0: in the measure's own unit, and 1 exactly on it. Endlessly far outside where `value` is no
    /// number.
    double margin(double value) const;
};
template <>
inline constexpr std::array<std::string_view, 3> kWords<Allowed::Kind>{"below", "above", "near"};

/// One rule and how it stands.
struct RuleState {
    std::string text;     ///< "drift_m of cube.* at most 0.01, from 5 s"
    std::string measure;  ///< "drift_m"
    Allowed allowed{};
    double from_s{0};
    double to_s{0};
    bool seen{false};  ///< its time has come
    double value{0};   ///< the worst so far
    std::string worst_of;
    double worst_at_s{0};
    Verdict verdict{Verdict::Undecided};

    double margin() const { return allowed.margin(value); }
};

/// "63 % inside", "12 x outside": how a margin is told.
std::string margin_text(double margin);

class HardCaseJudge {
public:
    /// Of a simulation at its start. Refused (exit code 4): a description without [hard_case], an
    /// unknown measure, names that nothing has. The message names file and line.
    static Result<HardCaseJudge> create(const scene::Simulation& simulation);

    /// After each step of the same simulation. Does nothing once decided. `penetration_m`: the deepest, where another engine
    /// made the step; else the contact points say it.
    void after_step(const scene::Simulation& simulation,
                    const std::optional<double>& penetration_m = {});

    /// Fail as soon as one rule fails; pass when the case's time is over.
    Verdict verdict() const { return verdict_; }
    /// The case's own rules, then those that hold for every case.
    std::span<const RuleState> rules() const { return states_; }
    /// With the smallest margin of those whose time has come; null before any has.
    const RuleState* worst() const;
    bool has_ended() const { return has_ended_; }  ///< the case's time has run out
    /// Of all steps so far.
    const physics::Interventions& interventions() const { return interventions_; }

private:
    struct Watched {
        const Measure* measure{nullptr};
        std::vector<std::size_t> bodies{};  ///< into bodies_
        std::vector<std::size_t> joints{};  ///< into the simulation's
        std::size_t relative_to{kNone};
    };
    struct Body {
        ecs::Entity entity{};
        physics::BodyId id{};
        std::string name;
        BodyStart start{};
        double lowest_m{std::numeric_limits<double>::infinity()};
    };
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    explicit HardCaseJudge(const scene::Simulation& simulation);
    Result<Done> add_rule(const scene::Simulation& simulation, const scene::HardCaseRule& rule);
    Result<Done> add_general_rules(const scene::Simulation& simulation);
    Result<std::vector<std::size_t>> bodies_called(const scene::Simulation& simulation,
                                                   const scene::HardCaseRule& rule);
    Result<std::vector<std::size_t>> joints_called(const scene::Simulation& simulation,
                                                   const scene::HardCaseRule& rule) const;
    std::size_t body_index(const scene::Simulation& simulation, const std::string& name);
    BodyObservation look_at(const scene::Simulation& simulation,
                            std::size_t body,
                            std::size_t other) const;
    void look(const scene::Simulation& simulation, const Watched& watched, RuleState& state);

    double seconds_;
    WorldStart start_;
    std::vector<Body> bodies_;
    std::vector<Watched> watched_;
    std::vector<RuleState> states_;
    std::vector<physics::ContactEvent> contacts_;
    physics::Interventions interventions_{};
    scene::Totals totals_{};                 ///< after the latest step
    std::optional<double> penetration_m_{};  ///< of the latest step, where the points do not say it
    bool knows_fields_{false};
    bool needs_contacts_{false};
    bool has_ended_{false};
    Verdict verdict_{Verdict::Undecided};
};

}  // namespace plumbline::study
