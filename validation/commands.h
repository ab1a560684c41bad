#pragma once

#include <fairlight/render/render_command.h>

namespace fairlight {

/// Adds `verify` to the program.
void add_verify_command(CLI::App& program, Command& command);

/// Adds `ledger` to the program.
void add_ledger_command(CLI::App& program, Command& command);

/// Adds `calibration`, `power` and `ledger` to `audit`.
void add_tester_commands(CLI::App& audit, Command& command);

/// Adds `mutate` to `audit`.
void add_mutate_command(CLI::App& audit, Command& command);

/// Adds `judges` to `audit`.
void add_judges_command(CLI::App& audit, Command& command);

/// Adds `audit` to the program.
void add_audit_command(CLI::App& program, Command& command);

}  // namespace fairlight
