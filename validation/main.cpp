#include <cstdio>
#include <exception>
#include <stdexcept>

#include <fairlight/render/render_command.h>
#include <fairlight/validation/commands.h>
#include <fairlight/version.h>

namespace {

constexpr int bad_input = 2;

int run(int argc, char** argv) {
  CLI::App program("Monte Carlo light transport, statistically verified");
  program.name("fairlight");
  program.set_version_flag("--version", fairlight::version);
  fairlight::Command command;
  fairlight::add_verify_command(program, command);
  fairlight::add_audit_command(program, command);
  fairlight::add_render_commands(program, command);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "fairlight: %s (see fairlight --help)\n", error.what());
    return bad_input;
  }
  if (!command) throw std::invalid_argument("no command was given (verify, audit, render, merge or scenes)");
  return command();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fairlight: %s\n", error.what());
    return bad_input;
  }
}
