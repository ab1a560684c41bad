#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include <fairlight/validation/app/commands.h>
#include <fairlight/version.h>

namespace {

constexpr int bad_input = 2;

/// Answers the command line, and returns the exit status.
int answer(int argc, char** argv) {
  CLI::App program;
  program.set_version_flag("--version", fairlight::version, "Print the version.")->group("Help");
  fairlight::Command command;
  fairlight::add_commands(program, command);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(fairlight::usage_problem(program, error));
  }
  if (!command) throw std::invalid_argument(fairlight::no_command(program));
  return command();
}

int run(int argc, char** argv) {
  const int status = answer(argc, argv);
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
