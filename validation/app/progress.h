#pragma once

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include <unistd.h>

#include <fairlight/render/render_image.h>

namespace fairlight {

/// The text of a progress bar for the fraction done and the seconds so far: "verify
/// [#####...............]  25 %, 35 s left".
inline std::string progress_line(const std::string& what, double done, double seconds) {
  constexpr int width = 30;
  const int full = static_cast<int>(width * done);
  const double left = seconds * (1 - done) / done;
  std::string text = what + " [" + std::string(static_cast<std::size_t>(full), '#') +
                     std::string(static_cast<std::size_t>(width - full), '.') + "] ";
  text += std::to_string(static_cast<int>(100 * done)) + " %, ";
  const bool minutes = left >= 120;
  return text + std::to_string(std::llround(std::ceil(minutes ? left / 60 : left))) +
         (minutes ? " min left" : " s left");
}

/// A progress bar on the terminal, with the fraction done and the time left. Prints nothing if
/// standard error is not a terminal.
inline Progress progress_bar(const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return {};
  using Clock = std::chrono::steady_clock;
  return [what, start = Clock::now(), shown = Clock::time_point()](double done) mutable {
    const auto now = Clock::now();
    if (done < 1 && now - shown < std::chrono::milliseconds(100)) return;
    shown = now;
    const double seconds = std::chrono::duration<double>(now - start).count();
    std::fprintf(stderr, "\r%s\033[K", done < 1 ? progress_line(what, done, seconds).c_str() : "");
  };
}

}  // namespace fairlight
