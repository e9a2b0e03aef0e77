// From settings to the method they name.
#include "renderer/methods/method.h"

#include "renderer/methods/green.h"
#include "renderer/methods/phong.h"
#include "renderer/methods/shss.h"

#include <utility>

namespace renderer::methods {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};

} // namespace

Expected<std::unique_ptr<Method>> prepare_method(const MethodSettings& settings,
                                                 std::shared_ptr<const Surface> surface,
                                                 const thickness::ThicknessField* field) {
    return std::visit(
        Overloaded{[&](const PhongSettings&) { return prepare_phong(std::move(surface)); },
                   [&](const GreenSettings& green) {
                       return prepare_green(green, std::move(surface), field);
                   },
                   [&](const ShssSettings& shss) {
                       return prepare_shss(shss, std::move(surface), field);
                   }},
        settings);
}

} // namespace renderer::methods
