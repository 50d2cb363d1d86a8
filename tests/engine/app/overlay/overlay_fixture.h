// All that the overlay reads in one frame, of a small scene.
#pragma once

#include "engine/app/overlay/overlay_panels_impl.h"
#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>

namespace plumbline::app {

class OverlayPanels : public SessionTest {
protected:
    OverlayPanels() : session_(open()), accuracy_(*session_) {}

    OverlayInput input() {
        return {.parts = parts_,
                .hud = hud_,
                .simulation = *session_->simulation,
                .report = report_,
                .clock = clock_,
                .bindings = bindings_,
                .device = input::LastDevice::KeyboardMouse,
                .ledger = ledger_,
                .accuracy = accuracy_};
    }
    static std::vector<std::string> words_of(const std::vector<ui::HudLine>& lines) {
        std::vector<std::string> words;
        for (const ui::HudLine& line : lines) words.push_back(line.text);
        return words;
    }

    std::unique_ptr<Session> session_;
    AccuracyControl accuracy_;
    OverlayParts parts_;
    scene::HudContent hud_;
    FrameReport report_;
    FrameClock clock_{1.0 / 60.0};
    input::Bindings bindings_{input::built_in_bindings()};
    std::vector<effects::LedgerLine> ledger_;
};

}  // namespace plumbline::app
