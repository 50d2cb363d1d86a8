// Another material while a body touches something: a contact begins, a contact ends.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

#include <set>

namespace plumbline::effects {
namespace {

class ContactLookEffect final : public Effect {
public:
    explicit ContactLookEffect(scene::Simulation& simulation)
        : listener_(simulation, "effect contact_look") {}

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        std::set<std::uint64_t> touching;
        for (const physics::ContactEvent& contact : simulation.physics.report().contacts) {
            touching.insert(contact.user_a);
            touching.insert(contact.user_b);
        }
        for (auto [entity, look, visual] :
             simulation.registry.view<scene::ContactAppearance, scene::Visual>()) {
            const bool touches = touching.contains(scene::mark_of(entity));
            if (touches != look.touches) change(look, visual);
        }
    }

private:
    void change(scene::ContactAppearance& look, scene::Visual& visual) {
        look.touches = !look.touches;
        if (look.touches) {
            look.own = visual.materials;
            visual.materials.assign(look.own.size(), look.material);
        } else {
            visual.materials = look.own;
        }
        ++work_.calls;
    }

    ContactListener listener_;
};

}  // namespace

EffectRow contact_look() {
    return with_effect<ContactLookEffect>(
        {.called_for_by = &entities_with<scene::ContactAppearance>});
}

}  // namespace plumbline::effects
