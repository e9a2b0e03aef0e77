// On which side of a surface a ray starts, for those who know it.
#pragma once

namespace renderer::geometry {

enum class Side { Unknown, Inside, Outside };

} // namespace renderer::geometry
