// Reading [[material]]: a medium by its coefficients, or by a colour.
#pragma once

#include "protocols/section.h"
#include "protocols/study.h"

namespace protocols {

/// A material of the study's own.  Notes what is wrong with it, as `Section` does.
OwnMaterial read_material(Section section, const KnownNames& known);

} // namespace protocols
