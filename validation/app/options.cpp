#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <sstream>

#include <fairlight/render/nearest_names.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/options.h>

namespace fairlight {
namespace {

constexpr std::size_t columns = 100;
constexpr std::size_t help_column = 28;

std::string in_words(const NumberRange& range) {
  std::string words = range.from_low ? formatted("of %g or more", range.low) : formatted("above %g", range.low);
  if (std::isfinite(range.high)) words += formatted(" and below %g", range.high);
  return words;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

// Wraps words into lines that end before the last column. All lines but the first are indented.
std::string wrapped(const std::vector<std::string>& words, std::size_t indent) {
  std::string lines;
  std::size_t column = indent;
  for (const std::string& word : words) {
    const bool first = column == indent;
    if (!first && column + 1 + word.size() > columns) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!first) {
      lines += " ";
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines;
}

// A line of the help: the name on the left, its description on the right.
std::string entry(const std::string& name, const std::vector<std::string>& what) {
  std::string line = "  " + name;
  const bool fits = line.size() + 2 <= help_column;
  line += fits ? std::string(help_column - line.size(), ' ') : "\n" + std::string(help_column, ' ');
  return line + wrapped(what, help_column) + "\n";
}

// A line on a value of an option, below the description of the option.
std::string value_entry(const std::string& text) {
  constexpr std::size_t indent = help_column + 2;
  return std::string(indent, ' ') + wrapped(words_of(text), indent) + "\n";
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override {
    std::string help = wrapped(words_of(app->get_description()), 0) + "\n\n" + make_usage(app, std::move(name));
    help += make_positionals(app);
    for (const std::string& group : app->get_groups()) {
      if (group != help_group) help += options_of(app, group);
    }
    help += options_of(app, help_group);
    help += make_subcommands(app, CLI::AppFormatMode::Normal);
    return app->get_footer().empty() ? help : help + "\n" + app->get_footer() + "\n";
  }

  std::string make_subcommand(const CLI::App* sub) const override {
    return entry(sub->get_name(), words_of(sub->get_description()));
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const bool has_value = option->get_type_size() != 0;
    const bool many = option->get_expected_max() > 1;
    std::string name = is_positional ? "" : option->get_name(false, true);
    if (has_value) name += (is_positional ? "" : " ") + option->get_type_name() + (many ? "..." : "");
    std::istringstream lines(option->get_description());
    std::string line;
    std::getline(lines, line);
    std::vector<std::string> what = words_of(line);
    if (option->get_required()) what.emplace_back("[required]");
    if (!option->get_default_str().empty()) what.push_back("[default: " + option->get_default_str() + "]");
    std::string text = entry(name, what);
    while (std::getline(lines, line)) text += value_entry(line);
    return text;
  }

  std::string make_option_usage(const CLI::Option* option) const override {
    const std::string name = option->get_type_name() + (option->get_expected_max() > 1 ? "..." : "");
    return option->get_required() ? name : "[" + name + "]";
  }

  static constexpr const char* help_group = "Help";

 private:
  std::string options_of(const CLI::App* app, const std::string& group) const {
    const auto in_group = [&](const CLI::Option* o) { return o->get_group() == group && o->nonpositional(); };
    const std::vector<const CLI::Option*> options = app->get_options(in_group);
    return options.empty() ? "" : make_group(group, false, options);
  }
};

void format(CLI::App& app, const std::shared_ptr<HelpFormatter>& formatter) {
  app.formatter(formatter);
  app.group("Commands");
  if (app.get_help_ptr() != nullptr) {
    app.set_help_flag("-h,--help", "Print this help.")->group(HelpFormatter::help_group);
  }
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) format(*sub, formatter);
}

}  // namespace

CLI::Validator number_in(const NumberRange& range) {
  return CLI::Validator(
      [range](const std::string& text) {
        double value = 0;
        const bool is_number = CLI::detail::lexical_cast(text, value);
        const bool above = value > range.low || (range.from_low && value == range.low);
        if (is_number && above && value < range.high) return std::string();  // a NaN fails
        return "\"" + text + "\" is not a finite number " + in_words(range);
      },
      "");
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& value, const NumberRange& range,
                        const std::string& help) {
  return app.add_option(name, value, help)->check(number_in(range))->type_name("X");
}

CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& value, const std::string& shown,
                      const std::string& help) {
  const auto not_empty = [](const std::string& text) { return text.empty() ? "the value is empty" : ""; };
  return app.add_option(name, value, help)->check(CLI::Validator(not_empty, ""))->type_name(shown);
}

CLI::Validator one_of(const std::vector<std::string>& choices) {
  return CLI::Validator(
      [choices](const std::string& word) -> std::string {
        if (std::ranges::find(choices, word) != choices.end()) return "";
        const std::vector<std::string> nearest = nearest_names(word, choices);
        return nearest.empty()
                   ? formatted("there is no \"%s\"; choose %s", word.c_str(), alternatives(choices).c_str())
                   : formatted("there is no \"%s\"; did you mean %s?", word.c_str(), alternatives(nearest).c_str());
      },
      "");
}

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& choices, const std::string& help) {
  const std::string list = CLI::detail::join(choices, ", ");
  return app.add_option(name, value, help + " One of: " + list + ".")->check(one_of(choices))->type_name("WORD");
}

void add_threads(CLI::App& app, int& threads, const std::string& help) {
  add_count(app, "--threads", threads, 1, 1024, help)->capture_default_str()->group("Running");
}

void begin_group(CLI::App& app, const std::string& heading) { app.option_defaults()->group(heading); }

void add_examples(CLI::App& app, const std::vector<std::string>& commands) {
  std::string footer = commands.size() > 1 ? "Examples:" : "Example:";
  for (const std::string& command : commands) footer += "\n  " + command;
  app.footer(footer);
}

std::string full_name(const CLI::App& app) {
  return (app.get_parent() == nullptr ? "" : full_name(*app.get_parent()) + " ") + app.get_name();
}

void format_help(CLI::App& program) {
  const auto formatter = std::make_shared<HelpFormatter>();
  formatter->label("Positionals", "Arguments");
  formatter->label("SUBCOMMAND", "COMMAND");
  format(program, formatter);
}

}  // namespace fairlight
