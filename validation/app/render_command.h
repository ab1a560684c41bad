#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace fairlight {

/// The command that the command line asked for. Returns the exit status.
using Command = std::function<int()>;

/// Adds `render`, `merge` and `scenes` to the program. Parsing stores the chosen one in `command`.
void add_render_commands(CLI::App& program, Command& command);

}  // namespace fairlight
