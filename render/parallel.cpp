#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include <fairlight/render/parallel.h>

namespace fairlight {

void for_each_unit(std::size_t units, int threads, const std::function<void(std::size_t)>& work,
                   const Progress& progress) {
  if (threads < 1) throw std::invalid_argument("the number of threads must be at least 1");
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex mutex;
  std::exception_ptr failure;
  std::size_t failed_unit = units, done = 0;
  const auto serve = [&] {
    while (!failed) {
      const std::size_t unit = next++;
      if (unit >= units) return;
      try {
        work(unit);
        if (!progress) continue;
        const std::lock_guard lock(mutex);
        progress(static_cast<double>(++done) / static_cast<double>(units));
      } catch (...) {
        const std::lock_guard lock(mutex);
        failed = true;
        if (unit < failed_unit) {
          failed_unit = unit;
          failure = std::current_exception();
        }
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(static_cast<std::size_t>(threads), units); ++i) others.emplace_back(serve);
    serve();
  }
  if (failure) std::rethrow_exception(failure);
}

int hardware_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace fairlight
