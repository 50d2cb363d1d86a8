// The accuracy panel of a small scene, and clicks in it.
#pragma once

#include "engine/app/overlay/overlay_panels_impl.h"
#include "engine/app/ui/canvas_impl.h"
#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

namespace plumbline::app {

class AccuracyPanel : public SessionTest {
protected:
    AccuracyPanel() : session_(open()), control_(*session_) {
        canvas_.resize(1280, 720, 1.0F, 0.0F);
    }

    Requests frame(double x, double y, bool down, const std::vector<int>& keys = {}) {
        InputSnapshot input;
        input.now_s = now_s_ += 0.02;
        input.cursor_px = {x, y};
        input.buttons[0] = down;
        for (const int key : keys) {
            input.events.push_back({DeviceEventKind::Key, key, true});
            input.events.push_back({DeviceEventKind::Key, key, false});
        }
        canvas_.begin(input);
        Requests asked;
        taken_px_ =
            panels::draw_accuracy({.control = control_, .clock = clock_, .replaying = replaying_},
                                  canvas_.font_px(),
                                  asked);
        canvas_.end();
        return asked;
    }
    /// Presses and lets go at every place of a grid over the panel; all that was asked.
    Requests click_everywhere() {
        Requests asked;
        for (double y = 14.0; y < 718.0; y += 9.0) {
            for (const double share : {0.05, 0.25, 0.45}) {
                const double x = 1280.0 - static_cast<double>(taken_px_) * (1.0 - share);
                frame(x, y, false);
                std::ranges::move(frame(x, y, true), std::back_inserter(asked));
                std::ranges::move(frame(x, y, false), std::back_inserter(asked));
            }
        }
        return asked;
    }
    template <class T>
    static std::vector<T> all_of(const Requests& requests) {
        std::vector<T> found;
        for (const Request& each : requests)
            if (const T* one = std::get_if<T>(&each)) found.push_back(*one);
        return found;
    }
    static std::vector<study::Setting> settings_in(const Requests& requests) {
        std::vector<study::Setting> found;
        for (const WorldRequest& each : all_of<WorldRequest>(requests))
            found.push_back(std::get<SetAccuracy>(each).setting);
        return found;
    }

    std::unique_ptr<Session> session_;
    AccuracyControl control_;
    bool replaying_{false};
    ui::Canvas canvas_;
    FrameClock clock_{1.0 / 60.0};
    float taken_px_{0};
    double now_s_{0};
};

}  // namespace plumbline::app
