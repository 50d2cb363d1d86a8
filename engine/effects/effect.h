// One optional behaviour of a scene. It exists only while something calls for it, and owns all that
// it needs: dropping the object gives everything back.
#pragma once

#include "engine/audio/sound_cue.h"
#include "engine/render/render_frame.h"
#include "engine/scene/game.h"
#include "engine/scene/simulation.h"

#include <cstdint>
#include <vector>

namespace plumbline::effects {

/// Sounds of one frame.
struct SoundFrame {
    std::vector<audio::SoundCue> cues;
    std::vector<audio::LoopCue> loops;
    audio::Room room{};
};

/// What an effect did so far, for the ledger.
struct EffectWork {
    std::uint64_t calls{0};  ///< times it did anything: bodies swept, sounds made, frames filled
    double cpu_ms{0};        ///< spent elsewhere on its behalf, e.g. in the physics
};

/// Asks for contact events while it lives.
class ContactListener {
public:
    ContactListener(scene::Simulation& simulation, const char* who)
        : simulation_(simulation), who_(who) {
        simulation_.contact_listeners.add(who_);
    }
    ~ContactListener() { simulation_.contact_listeners.remove(who_); }
    ContactListener(const ContactListener&) = delete;
    ContactListener& operator=(const ContactListener&) = delete;

private:
    scene::Simulation& simulation_;
    const char* who_;
};

class Effect {
public:
    virtual ~Effect() = default;
    virtual void before_step(scene::Simulation&) {}  ///< may add forces; must not move bodies
    virtual void after_step(scene::Simulation&, const scene::Game&) {
    }  ///< may read contacts, spawn, mark for destruction
    virtual void extract(const scene::Simulation&, const scene::ViewPoint&, render::RenderFrame&) {
    }  ///< may add to the image
    virtual void sound(const scene::Simulation&, const scene::ViewPoint&, SoundFrame&) {
    }                                                       ///< may add to the sound
    virtual void serialize(Archive&) {}                     ///< what a saved game must keep of it
    virtual std::uint64_t bytes_held() const { return 0; }  ///< beside itself

    const EffectWork& work() const { return work_; }

protected:
    EffectWork work_{};
};

}  // namespace plumbline::effects
