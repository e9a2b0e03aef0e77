// pairlight reference slab|half-space|sphere|furnace: shares of light, their errors, and seconds.
#include "experiment/commands/reference_energy.h"

#include "experiment/commands/command.h"
#include "experiment/commands/command_line.h"
#include "experiment/energy_json.h"
#include "experiment/models.h"
#include "renderer/geometry/mesh.h"
#include "renderer/reference/energy.h"
#include "renderer/reference/illumination.h"
#include "renderer/reference/mesh_body.h"
#include "renderer/stopwatch.h"

#include <fmt/core.h>

#include <limits>
#include <memory>
#include <string>

namespace experiment::commands {

namespace reference = renderer::reference;

namespace {

using reference::BoundaryKind;
using reference::Incidence;

struct Options {
    EnergyShape shape = EnergyShape::Slab;
    reference::EnergyProblem problem;
    reference::EnergyRun run;
    std::string boundary;
    std::string model;
    std::string json;
    Inputs read; ///< on the way to the result
    Voice voice;
};

/// A polished surface where the indices differ, unless something else was asked for.
reference::Boundary boundary_of(const Options& options) {
    auto boundary = options.problem.boundary;
    if (options.boundary.empty())
        boundary.kind = options.problem.index == 1 ? BoundaryKind::Matched : BoundaryKind::Smooth;
    else
        boundary.kind = *reference::boundary_kind(options.boundary);
    value_or_stop(reference::check_reachable({}, boundary));
    return boundary;
}

/// What would change nothing, and whoever gave it would not know.
void refuse_what_changes_nothing(const Options& options,
                                 const Command& reference,
                                 const Command& command) {
    const auto boundary = boundary_of(options);
    if (options.boundary == "matched" && options.problem.index != 1)
        command.expect_not_given(
            {"--index"}, "bends no light through a matched boundary; leave one of them out");
    if (boundary.kind != BoundaryKind::Rough)
        command.expect_not_given({"--roughness"}, "is of a rough boundary; add --boundary rough");
    for (const auto& given : reference.given_options())
        throw CommandError(
            fmt::format("{} is for a picture; leave it out beside {}", given, command.name()));
}

/// The optical thickness is that of the bounding sphere's radius, as a sphere's is.
reference::EnergyBalance furnace(Options& options, const reference::EnergyProblem& problem) {
    const auto model = value_or_stop(load_model(options.model, StudyFolder{"."}));
    options.read.push_back(model.file);
    for (const auto& remark : model.remarks)
        options.voice.remark(remark);
    const auto bounds = renderer::geometry::bounding_sphere(model.mesh);
    const auto medium = reference::grey_medium(problem.optical_thickness / bounds.radius,
                                               problem.albedo, problem.anisotropy, problem.index);
    return reference::body_energy(*reference::make_mesh_body(model.mesh), bounds.centre,
                                  bounds.radius, medium, problem.boundary, options.run);
}

reference::EnergyBalance measured(Options& options) {
    auto problem = options.problem;
    problem.boundary = boundary_of(options);
    switch (options.shape) {
    case EnergyShape::HalfSpace:
        problem.optical_thickness = std::numeric_limits<double>::infinity();
        return reference::slab_energy(problem, options.run);
    case EnergyShape::Slab:
        return reference::slab_energy(problem, options.run);
    case EnergyShape::Sphere:
        return reference::sphere_energy(problem, options.run);
    case EnergyShape::Furnace:
        break;
    }
    return furnace(options, problem);
}

void print_row(const char* name, const reference::Estimate& estimate) {
    fmt::print("{:<15} {:.7f} +- {:.1e}\n", name, estimate.value, estimate.standard_error);
}

void print_text(const Options& options, const reference::EnergyBalance& balance, double seconds) {
    const bool is_flat =
        options.shape == EnergyShape::Slab || options.shape == EnergyShape::HalfSpace;
    if (is_flat) {
        print_row("reflectance", balance.back);
        print_row("transmittance", balance.through);
        fmt::print("{:<15} {:.7f}, exact\n", "specular", balance.specular);
    } else {
        print_row("escape", balance.escape);
        if (options.shape == EnergyShape::Sphere && options.problem.incidence == Incidence::Normal)
            print_row("forward", balance.through);
    }
    print_row("absorbed", balance.absorbed);
    print_row("collisions", balance.collisions);
    fmt::print("{} paths, {} leaks, {:.3g} s\n", balance.paths, balance.leaks, seconds);
}

void run(Options& options) {
    if (options.shape == EnergyShape::Furnace && options.problem.albedo == 1)
        options.voice.remark("without absorption every path comes out: expected is exactly 1");
    const renderer::Stopwatch watch;
    const auto balance = measured(options);
    const double seconds = watch.seconds();
    if (!options.json.empty())
        deliver(energy_json(balance, options.shape, options.problem.incidence, seconds),
                options.json, options.read);
    else
        print_text(options, balance, seconds);
}

void add_shape(Command& reference, const char* name, const char* description, EnergyShape shape) {
    const auto options = std::make_shared<Options>();
    options->shape = shape;
    auto command = reference.add_command(name, description);
    auto& problem = options->problem;
    command.add_option("--albedo", problem.albedo, "Scattered share of what collides")
        .within(0.0, 1.0)
        .shows_default();
    command.add_option("--anisotropy", problem.anisotropy, "Henyey-Greenstein's g")
        .within(-0.999, 0.999)
        .shows_default();
    if (shape != EnergyShape::HalfSpace)
        command
            .add_option("--optical-thickness", problem.optical_thickness,
                        shape == EnergyShape::Slab ? "Mean free paths across"
                                                   : "Mean free paths in a radius")
            .within(1e-9, 1e9)
            .shows_default();
    command.add_option("--index", problem.index, "Refractive index, inside over outside")
        .within(0.2, 5.0)
        .shows_default();
    command
        .add_option("--boundary", options->boundary,
                    "matched, smooth or rough; without it, smooth where the index is not 1")
        .one_of({"matched", "smooth", "rough"});
    command.add_option("--roughness", problem.boundary.roughness, "GGX alpha of a rough boundary")
        .shows_default();
    if (shape == EnergyShape::Furnace) {
        options->model = "sphere";
        command.add_option("--model", options->model, "A model file, a model's name, or a body")
            .shows_default();
    } else {
        problem.incidence = shape == EnergyShape::Sphere ? Incidence::Diffuse : Incidence::Normal;
        command.add_choice("--incidence", problem.incidence,
                           shape == EnergyShape::Sphere
                               ? "normal (a parallel beam as wide as the sphere) or diffuse"
                               : "normal or diffuse",
                           {{"normal", Incidence::Normal}, {"diffuse", Incidence::Diffuse}});
    }
    command.add_option("--paths", options->run.paths, "How many paths of light")
        .within(std::uint64_t{128}, std::uint64_t{1} << 40)
        .shows_default();
    command.add_option("--seed", options->run.seed, "Seed of the random numbers").shows_default();
    command.add_option("--json", options->json, "Write JSON to this file; - is standard output");
    add_voice(command, options->voice);
    command.runs([options, reference, command] {
        refuse_what_changes_nothing(*options, reference, command);
        run(*options);
    });
}

} // namespace

void add_reference_energy(Command& reference) {
    add_shape(reference, "slab", "Reflectance and transmittance of a slab", EnergyShape::Slab);
    add_shape(reference, "half-space", "Reflectance of a half-space", EnergyShape::HalfSpace);
    add_shape(reference, "sphere", "What escapes of the light that falls on a sphere",
              EnergyShape::Sphere);
    add_shape(reference, "furnace", "What an even sky of radiance 1 looks like through a model",
              EnergyShape::Furnace);
}

} // namespace experiment::commands
