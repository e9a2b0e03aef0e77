// Phong's model without any transmitted light: what the other methods stand on.
#pragma once

#include "renderer/methods/description.h"

namespace renderer::methods {

Description describe_phong();

Expected<std::unique_ptr<Method>> prepare_phong(std::shared_ptr<const shading::Surface> surface);

} // namespace renderer::methods
