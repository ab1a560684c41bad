#pragma once

#include <chrono>
#include <cstdio>

#include <unistd.h>

#include <fairlight/render/render_image.h>

namespace fairlight {

/// A line on the terminal that shows the fraction done and the time left; silent where standard error is no
/// terminal.
inline Progress progress_bar(const char* what) {
  if (isatty(STDERR_FILENO) == 0) return {};
  return [what, start = std::chrono::steady_clock::now()](double done) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::fprintf(stderr, "\r%s %3.0f %%, %.0f s left \033[K", what, 100 * done, seconds * (1 - done) / done);
    if (done >= 1) std::fputs("\r\033[K", stderr);
  };
}

}  // namespace fairlight
