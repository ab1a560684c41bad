#pragma once

#include <limits>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace fairlight {

/// The options of the commands. Every command adds its options by these functions, so that all
/// check values alike. For a bad value they throw CLI::ValidationError, which names the option.

/// The finite numbers that an option accepts: above `low` and below `high`.
struct NumberRange {
  double low;
  double high = std::numeric_limits<double>::infinity();
  bool from_low = false;  ///< whether `low` itself is accepted
};

/// Accepts only a finite number in the range. Rejects "nan", "inf" and "1e999" as well as "one".
CLI::Validator number_in(const NumberRange& range);

/// Adds an option with a floating-point value. Add such options only by this function: a value that
/// is not finite would look like one that was not given.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, const NumberRange& range,
                        const std::string& help);

/// Adds an option with an integer value from `least` to `most`.
template <class Integer>
CLI::Option* add_count(CLI::App& app, const std::string& name, Integer& value, Integer least, Integer most,
                       const std::string& help) {
  return app.add_option(name, value, help)->check(CLI::Range(least, most).description(""))->type_name("N");
}

/// Adds an option with text that is not empty: empty text is often an unset shell variable. Help
/// shows the value as `shown`.
CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& value, const std::string& shown,
                      const std::string& help);

/// Accepts only one of these words. Names the nearest where another is given, or else all.
CLI::Validator one_of(const std::vector<std::string>& choices);

/// Adds an option whose value is one of `choices`. Help lists them.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& choices, const std::string& help);

/// Adds --threads, in the group "Running".
void add_threads(CLI::App& app, int& threads, const std::string& help = "Use this many threads.");

/// Puts the options that are added after this call under this heading of the help.
void begin_group(CLI::App& app, const std::string& heading);

/// Lists these example commands at the end of the help.
void add_examples(CLI::App& app, const std::vector<std::string>& commands);

/// The full name of a command, for example "fairlight audit faults".
std::string full_name(const CLI::App& app);

/// Sets up the help of a program and of all its commands: groups of options, in lines of at most
/// 100 columns, with the default of each. Lines after the first of an option's help are indented:
/// they describe its values. Call it after all commands are added.
void format_help(CLI::App& program);

}  // namespace fairlight
