#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include <fairlight/render/render_command.h>
#include <fairlight/validation/commands.h>
#include <fairlight/version.h>

namespace {

constexpr int bad_input = 2;

// The command that was being read when reading stopped.
const CLI::App& innermost(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : innermost(*parsed.front());
}

// "(COMMAND has: sub --this --that)", for a sentence about a word that is none of them.
std::string choices(const CLI::App& app) {
  std::string names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names += " " + sub->get_name();
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_lnames().empty()) names += " --" + option->get_lnames().front();
  }
  return "(" + app.get_name() + " has:" + names + ")";
}

int run(int argc, char** argv) {
  CLI::App program("Monte Carlo light transport, statistically verified");
  program.name("fairlight");
  program.set_version_flag("--version", fairlight::version);
  fairlight::Command command;
  fairlight::add_verify_command(program, command);
  fairlight::add_ledger_command(program, command);
  fairlight::add_audit_command(program, command);
  fairlight::add_render_commands(program, command);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "fairlight: %s %s\n", error.what(), choices(innermost(program)).c_str());
    return bad_input;
  }
  if (!command) throw std::invalid_argument("no command was given " + choices(innermost(program)));
  const int status = command();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw std::runtime_error("standard output cannot be written");
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("fairlight: there is not enough memory (ask for a smaller image)\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fairlight: %s\n", error.what());
  }
  return bad_input;
}
