#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fairlight/validation/run/subprocess.h>

namespace fairlight {
namespace {

std::string read_all(int file) {
  std::string bytes;
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t n = read(file, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

// Starts the program with these files as its output and its standard error. Returns 0 or an errno.
int start(const std::vector<std::string>& arguments, int output, int errors, pid_t& process) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  const int error = posix_spawnp(&process, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  const auto fail = [&](int error) {
    throw std::runtime_error("cannot run \"" + arguments[0] + "\" (" + std::strerror(error) + ")");
  };
  const int errors = memfd_create("errors", MFD_CLOEXEC);  // a file, so that it cannot fill up as a pipe does
  if (errors < 0) fail(errno);
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno);
  pid_t process = 0;
  const int error = start(arguments, ends[1], errors, process);
  close(ends[1]);
  const std::string out = error == 0 ? read_all(ends[0]) : "";
  close(ends[0]);
  int status = 0;
  while (error == 0 && waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) fail(errno);
  }
  lseek(errors, 0, SEEK_SET);
  const std::string said = read_all(errors);
  close(errors);
  if (error != 0) fail(error);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), out, said};
}

}  // namespace fairlight
