// The methods, in the order people read them.
#include "renderer/methods/catalogue.h"

#include "renderer/contract.h"
#include "renderer/methods/barre_brisebois.h"
#include "renderer/methods/constant.h"
#include "renderer/methods/green.h"
#include "renderer/methods/jensen.h"
#include "renderer/methods/patro.h"
#include "renderer/methods/phong.h"
#include "renderer/methods/prt.h"
#include "renderer/methods/separable.h"
#include "renderer/methods/shss.h"
#include "renderer/methods/traced.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace renderer::methods {

std::span<const Description> catalogue() {
    // A method a line:
    // clang-format off
    static const std::array all{
        describe_shss(),
        describe_green(),
        describe_green_blur(),
        describe_green_peel(),
        describe_patro(),
        describe_prt(),
        describe_jensen(),
        describe_barre_brisebois(),
        describe_separable(),
        describe_traced(),
        describe_constant(),
        describe_phong(),
    };
    // clang-format on
    return all;
}

const Description* find_method(std::string_view name) {
    const auto all = catalogue();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Description& one) { return one.name == name; });
    return found == all.end() ? nullptr : &*found;
}

tl::expected<Dials, DialProblem> complete_for(std::string_view name, const Dials& given) {
    const auto* method = find_method(name);
    EXPECTS(method != nullptr);
    auto dials = complete(method->dials, given);
    if (dials && method->refuse != nullptr)
        if (auto problem = method->refuse(*dials))
            return tl::make_unexpected(std::move(*problem));
    return dials;
}

Expected<std::unique_ptr<Method>>
prepare_method(std::string_view name, const Dials& dials, const Subject& subject) {
    const auto* method = find_method(name);
    if (method == nullptr)
        return tl::make_unexpected(fmt::format("no method is called \"{}\"", name));
    const auto complete_dials = complete_for(name, dials);
    if (!complete_dials)
        return tl::make_unexpected(fmt::format("{}: '{}' {}", name, complete_dials.error().dial,
                                               complete_dials.error().what));
    return method->prepare(*complete_dials, subject);
}

} // namespace renderer::methods
