// Estimates with all their digits.
#include "experiment/energy_json.h"

#include <nlohmann/json.hpp>

namespace experiment {

namespace {

using Json = nlohmann::ordered_json;
using renderer::reference::Estimate;

Json as_json(const Estimate& estimate) {
    return {{"estimate", estimate.value}, {"standard_error", estimate.standard_error}};
}

} // namespace

std::string energy_json(const renderer::reference::EnergyBalance& balance,
                        EnergyShape shape,
                        renderer::reference::Incidence incidence,
                        double seconds) {
    using renderer::reference::Incidence;
    Json json;
    if (shape == EnergyShape::Slab || shape == EnergyShape::HalfSpace) {
        json["reflectance"] = as_json(balance.back);
        json["transmittance"] = as_json(balance.through);
        json["specular"] = balance.specular;
    } else {
        json["escape"] = as_json(balance.escape);
        if (shape == EnergyShape::Sphere && incidence == Incidence::Normal)
            json["forward"] = as_json(balance.through);
    }
    json["absorbed"] = as_json(balance.absorbed);
    json["collisions"] = as_json(balance.collisions);
    json["paths"] = balance.paths;
    json["leaks"] = balance.leaks;
    json["seconds"] = seconds;
    return json.dump(2) + "\n";
}

} // namespace experiment
