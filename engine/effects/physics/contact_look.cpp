// Another material while a body touches something: a contact begins, a contact ends.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

#include <set>

namespace plumbline::effects {
namespace {

class ContactLookEffect final : public Effect {
public:
    explicit ContactLookEffect(scene::Simulation& simulation) : simulation_(simulation) {
        simulation_.contact_listeners.add(kWho);
    }
    ~ContactLookEffect() override { simulation_.contact_listeners.remove(kWho); }
    ContactLookEffect(const ContactLookEffect&) = delete;
    ContactLookEffect& operator=(const ContactLookEffect&) = delete;

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        std::set<std::uint64_t> touching;
        for (const physics::ContactEvent& contact : simulation.physics.contacts()) {
            touching.insert(contact.user_a);
            touching.insert(contact.user_b);
        }
        for (auto [entity, look, visual] :
             simulation.registry.view<scene::ContactAppearance, scene::Visual>()) {
            const bool touches = touching.contains(scene::mark_of(entity));
            if (touches != look.touches) change(look, visual);
        }
    }

    std::uint64_t bytes_cpu() const override { return sizeof(*this); }

private:
    static constexpr const char* kWho = "effect contact_look";

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

    scene::Simulation& simulation_;
};

Callers callers_of_contact_look(const scene::Simulation& simulation) {
    EntityCallers callers(simulation);
    for (auto [entity, look] : simulation.registry.view<const scene::ContactAppearance>())
        callers.add(entity);
    return callers.take();
}

std::unique_ptr<Effect> make_contact_look(scene::Simulation& simulation) {
    return std::make_unique<ContactLookEffect>(simulation);
}

}  // namespace

EffectRow contact_look() {
    return {.name = "contact_look",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_contact_look,
            .make = &make_contact_look};
}

}  // namespace plumbline::effects
