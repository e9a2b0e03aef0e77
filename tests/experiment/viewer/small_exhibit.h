// A body under two lights, with every method to choose from.
#pragma once

#include "experiment/viewer/exhibit.h"
#include "experiment/viewer/viewer_state.h"

#include <stdexcept>

namespace tests {

inline experiment::viewer::Exhibit exhibit_of_body(const std::string& name) {
    auto exhibit = experiment::viewer::open_exhibit(name, {});
    if (!exhibit)
        throw std::runtime_error(exhibit.error());
    return *exhibit;
}

/// The exhibit's choice of that method, to be chosen.
inline experiment::viewer::Choose choice_of(const experiment::viewer::Exhibit& exhibit,
                                            std::string_view method) {
    for (std::size_t i = 0; i < exhibit.choices.size(); ++i)
        if (exhibit.choices[i].method == method)
            return {i};
    throw std::runtime_error("no such method");
}

} // namespace tests
