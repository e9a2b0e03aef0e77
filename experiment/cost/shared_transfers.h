// Transfer fields of one model, computed once for every setting that asks for as many bands or
// fewer, and what they took.
#pragma once

#include "renderer/geometry/mesh.h"
#include "renderer/scene.h"
#include "renderer/transfer/transfer_field.h"

#include <tl/expected.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace experiment::cost {

class SharedTransfers {
  public:
    using Field = std::shared_ptr<const renderer::transfer::TransferField>;

    /// The mesh outlives it.
    SharedTransfers(const renderer::geometry::Mesh& mesh,
                    const renderer::Medium& medium,
                    double mm_per_unit)
        : mesh_(mesh), medium_(medium), mm_per_unit_(mm_per_unit) {}

    /// Errors: those of `compute_transfer_field`.
    tl::expected<Field, std::string> field(const renderer::transfer::TransferOptions& options);

    /// Seconds that whoever asked since the last call did not spend, because others had before:
    /// what the field took that served them, which is somewhat more than fewer bands alone take.
    double seconds_saved() { return std::exchange(saved_, 0); }

  private:
    struct Computed {
        renderer::transfer::TransferOptions options;
        Field field;
        double seconds = 0;
    };

    const renderer::geometry::Mesh& mesh_;
    renderer::Medium medium_;
    double mm_per_unit_;
    std::vector<Computed> computed_;
    double saved_ = 0;
};

} // namespace experiment::cost
