// A cost report that can be looked through: one scene, two lights, four settings.
#pragma once

#include "experiment/cost/cost_report.h"

namespace tests {

inline experiment::cost::Row
row(const char* method, const char* setting, double ms, std::size_t bytes, double law) {
    experiment::cost::Row row{.method = method,
                              .label = method,
                              .dials = {{"law", "physical"}},
                              .setting = setting,
                              .vertices = 642,
                              .triangles = 1280,
                              .mesh_bytes = 30768,
                              .precompute_seconds = 1.5,
                              .bytes_per_vertex = bytes,
                              .bytes_per_light = 64,
                              .frame_ms = {ms, ms, ms},
                              .resting_ms = {ms, ms, ms},
                              .to_bare = {ms / 5, ms / 5, ms / 5},
                              .clock_ms = 2 * ms,
                              .thickness = law / 2,
                              .lights = {}};
    row.lights = {{.law = law, .decision = {}}, {.law = 2 * law, .decision = {}}};
    return row;
}

/// The last knows no law and no thickness: only the path-traced picture tells its error.
inline experiment::cost::CostReport small_report() {
    experiment::cost::SceneCost scene{
        .id = "ball",
        .label = "Ball",
        .model = "sphere",
        .vertices = 642,
        .triangles = 1280,
        .frame_width = 64,
        .frame_height = 48,
        .lights = {{.id = "back",
                    .label = "from behind",
                    .width = 32,
                    .height = 24,
                    .noise_floor = 0.02,
                    .reference = "32 x 24 pixels",
                    .choice = {}},
                   {.id = "left",
                    .label = "from the left",
                    .width = 32,
                    .height = 24,
                    .noise_floor = {},
                    .reference = "",
                    .choice = {}}},
        .rows = {row("coarse", "", 5, 4, 0.2), row("fine", "", 7, 100, 0.01),
                 row("fine", "bands 2", 6, 16, 0.04), row("other", "", 5.5, 0, 0)},
        .remarks = {"other: said something"}};
    auto& other = scene.rows.back();
    other.thickness.reset();
    other.precompute_seconds.reset();
    other.lights = {
        {.reference = 0.3, .fitted = 0.25, .as_drawn = 0.6, .flip = 0.1, .decision = {}},
        {.decision = {}}};
    scene.rows[1].lights[0].decision = "2 of 5 bands";
    scene.rows[1].lights[0].predicted_change = 0.003;
    scene.rows[1].lights[0].measured_change = 0.0029;
    return {.program = "pairlight 0",
            .renderer = "nothing",
            .written_on = "2026-11-26",
            .subject = "A ball",
            .law = "physical",
            .timed_by = "processor",
            .rounds = 3,
            .held_out_lights = 6,
            .wish = {},
            .scenes = {scene}};
}

} // namespace tests
