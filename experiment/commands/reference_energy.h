// The subcommands of `pairlight reference` that compute numbers of books and tables.
#pragma once

namespace CLI {
class App;
}

namespace experiment::commands {

/// slab, half-space, sphere, furnace.
void add_reference_energy(CLI::App& reference);

} // namespace experiment::commands
