#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace fairlight {

/// What the command line asked for; returns the exit status.
using Command = std::function<int()>;

/// Adds `render`, `merge` and `scenes` to the program. The one that was asked for is left in `command`.
void add_render_commands(CLI::App& program, Command& command);

}  // namespace fairlight
