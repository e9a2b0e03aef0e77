// The subcommands of `pairlight reference` that compute numbers of books and tables.
#pragma once

namespace experiment::commands {

class Command;

/// slab, half-space, sphere, furnace.
void add_reference_energy(Command& reference);

} // namespace experiment::commands
