#pragma once

#include <fairlight/validation/app/render_command.h>

namespace fairlight {

/// Adds `verify` to the program.
void add_verify_command(CLI::App& program, Command& command);

/// Adds `compare` to the program.
void add_compare_command(CLI::App& program, Command& command);
/// Adds `judge`, which tests numbers on standard input, to the program.
void add_judge_command(CLI::App& program, Command& command);

/// Adds `plan`, the number of draws of a test of a mean, to the program.
void add_plan_command(CLI::App& program, Command& command);

/// Adds `ledger` to the program.
void add_ledger_command(CLI::App& program, Command& command);

/// Adds `calibration`, `power` and `ledger` to `audit`.
void add_tester_commands(CLI::App& audit, Command& command);

/// Adds `mutate` to `audit`.
void add_mutate_command(CLI::App& audit, Command& command);

/// Adds `domains` to `audit`.
void add_domains_command(CLI::App& audit, Command& command);

/// Adds `audit` to the program.
void add_audit_command(CLI::App& program, Command& command);

/// Adds `study` to the program.
void add_study_command(CLI::App& program, Command& command);

/// Sets the name of the program, and adds all its commands with their help.
void add_commands(CLI::App& program, Command& command);

/// Says in one sentence what is wrong with a command line that could not be parsed. For an unknown
/// option or command it suggests the nearest ones.
std::string usage_problem(const CLI::App& program, const CLI::ParseError& error);

/// The sentence for a command line that names no command, or only the first of several words.
std::string no_command(const CLI::App& program);

}  // namespace fairlight
