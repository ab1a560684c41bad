#pragma once

#include <limits>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace fairlight {

/// The options of the program's commands. Every command adds its options by these, so that all of
/// them check their values alike. A value that is refused is a CLI::ValidationError, which names
/// the option.

/// The numbers that an option takes: above `low` and below `high`, and finite.
struct NumberRange {
  double low;
  double high = std::numeric_limits<double>::infinity();
  bool from_low = false;  ///< that `low` is one of them
};

/// Refuses all text but a finite number of the range: "nan", "inf" and "1e999" as well as "one".
CLI::Validator number_in(const NumberRange& range);

/// An option whose value is a floating number. There is no other way to add one: a value that is
/// not finite would be neither given nor not given.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, const NumberRange& range,
                        const std::string& help);

/// A whole number, from `least` to `most`.
template <class Integer>
CLI::Option* add_count(CLI::App& app, const std::string& name, Integer& value, Integer least, Integer most,
                       const std::string& help) {
  return app.add_option(name, value, help)->check(CLI::Range(least, most).description(""))->type_name("N");
}

/// Text that is not empty, as that of a shell variable is which was not set. Help shows it as
/// `shown`.
CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& value, const std::string& shown,
                      const std::string& help);

/// One of a few words. Help lists them.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& choices, const std::string& help);

/// --threads, in the group "Running".
void add_threads(CLI::App& app, int& threads, const std::string& help = "Use this many threads.");

/// Puts the options that are added next under this heading of the command's help.
void begin_group(CLI::App& app, const std::string& heading);

/// Ends the command's help with these commands.
void add_examples(CLI::App& app, const std::vector<std::string>& commands);

/// "fairlight audit faults", of a command within commands.
std::string full_name(const CLI::App& app);

/// Makes the help of a program and of all its commands: groups of options, in lines of at most 100
/// columns, with the default of each. Call it when all commands are added.
void format_help(CLI::App& program);

}  // namespace fairlight
